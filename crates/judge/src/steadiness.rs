//! Whether the means of a dynamic run are steady, whether its hook load swings although nothing
//! excites the string, and the depth at which the means are taken.

use wholestring::{
    dynamics::DynamicsSettings,
    operation::{Operation, OperationKind},
    outcome::{Column, Samples, TIME_SERIES, TimeSeries, samples::sum},
};

use crate::{Check, CheckKind, Severity, window::Window};

/// Travel of the bit in the window, m, from which a drift depends on depth as much as on the start.
const TRAVELS_M: f64 = 1.0;

/// Largest difference, m, between the requested depth and the mean depth of the bit over the
/// window.
const ELSEWHERE_M: f64 = 1.0;

/// Parts of the window over which swings are compared: long enough for the slowest vibration of a
/// string, short enough that the drift within a part is a straight line.
const PARTS: usize = 4;

/// Standard deviation of a steady hook load, over the mean of hook load and axial friction, that is
/// reported. The cases that come with the program stay below 0.1 % with their own meshes, tripping
/// in and out; friction that feeds a vibration saturates at 3 to 5 %.
const SWINGS: f64 = 0.005;

/// Vibration that is left of the start decays within a window; one that is fed does not. The last
/// part of the window keeps at least this share of the largest standard deviation.
const SUSTAINED: f64 = 0.5;

/// Returns the checks of a run that was computed to its end.
pub fn checks(
    operation: &Operation,
    settings: &DynamicsSettings,
    window: &Window<'_>,
) -> Vec<Check> {
    let run = window.run();
    let numerics = run.numerics;
    let mut found = Vec::new();
    found.extend(hook_load_swings(operation, settings, window));
    if numerics.settled == Some(false) {
        found.push(
            Check::reported(CheckKind::NeverSteady, Severity::Warning).value(numerics.settle_s),
        );
    }
    if run.statistics.iter().any(|(_, statistic)| statistic.drifts) {
        let travels = numerics.bit_travel_m.abs() >= TRAVELS_M;
        let severity = if travels { Severity::Note } else { Severity::Warning };
        found.push(Check::reported(CheckKind::WindowDrifts, severity));
    }
    // A user who gives the time has thereby chosen the depth.
    let off_m = numerics.mean_bit_depth_m - operation.bit_depth_m;
    if numerics.settled.is_some() && off_m.abs() >= ELSEWHERE_M {
        found.push(
            Check::reported(CheckKind::BitElsewhere, Severity::Note)
                .value(numerics.mean_bit_depth_m)
                .limit(operation.bit_depth_m),
        );
    }
    found
}

const HOOK_LOAD: &Column<TimeSeries> = Column::named(TIME_SERIES, "hook_load_N");

/// A hook load that swings, with an amplitude that does not decay, while the string trips without
/// rotation: neither bit, rotation nor a set point that changes excites it.
fn hook_load_swings(
    operation: &Operation,
    settings: &DynamicsSettings,
    window: &Window<'_>,
) -> Option<Check> {
    let trips = matches!(operation.kind, OperationKind::TripIn | OperationKind::TripOut);
    if !trips || !settings.schedule.steps.is_empty() {
        return None;
    }
    let mean_N = |name| window.statistic(name).map_or(0.0, |statistic| statistic.mean.abs());
    let scale_N = mean_N("hook_load_N") + mean_N("axial_friction_N");
    let deviations_N = deviations(&window.scalar(HOOK_LOAD));
    let largest_N = deviations_N.iter().copied().fold(0.0, f64::max);
    let last_N = *deviations_N.last()?;
    let limit_N = SWINGS * scale_N;
    (last_N > limit_N && last_N >= SUSTAINED * largest_N).then(|| {
        Check::reported(CheckKind::HookLoadSwings, Severity::Warning).value(last_N).limit(limit_N)
    })
}

/// Standard deviations about the straight line of each part of the samples; none where there are
/// too few samples for a line.
fn deviations(samples: &impl Samples) -> Vec<f64> {
    let rows = samples.count() / PARTS;
    if rows < 3 {
        return Vec::new();
    }
    let part = |place: usize| (place / rows).min(PARTS - 1);
    let counted = PARTS * rows;
    let mut means = [0.0; PARTS];
    sum(samples, |place, value| {
        if place < counted {
            means[part(place)] += value / rows as f64;
        }
        0.0
    });
    // Sums of x², x y and y² about the means of each part.
    let middle = 0.5 * (rows as f64 - 1.0);
    let (mut along, mut squares) = ([0.0; PARTS], [0.0; PARTS]);
    sum(samples, |place, value| {
        if place < counted {
            let x = (place % rows) as f64 - middle;
            let y = value - means[part(place)];
            along[part(place)] += x * y;
            squares[part(place)] += y * y;
        }
        0.0
    });
    let count = rows as f64;
    let across = count * (count * count - 1.0) / 12.0;
    let deviation =
        |(along, square): (f64, f64)| ((square - along * along / across).max(0.0) / count).sqrt();
    along.into_iter().zip(squares).map(deviation).collect()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{SQRT_2, TAU};

    use super::*;

    /// A swing of amplitude `a` about a line deviates by `a/√2` from it; the line itself by nothing.
    #[test]
    fn deviations_leave_out_a_drift() {
        let line = |row: usize| 400e3 - 35.0 * row as f64;
        let drifting: Vec<f64> = (0..402).map(line).collect();
        assert!(deviations(&drifting).iter().all(|deviation_N| *deviation_N < 1e-6));
        let swing = |row: usize| line(row) + 2e3 * (TAU * 0.06 * row as f64).sin();
        let swinging: Vec<f64> = (0..402).map(swing).collect();
        for deviation_N in deviations(&swinging) {
            assert!((deviation_N * SQRT_2 / 2e3 - 1.0).abs() < 0.01, "{deviation_N}");
        }
        assert!(deviations(&[1.0; 11]).is_empty());
    }
}
