//! Weight on bit against its set point.

use wholestring::{
    dynamics::{DynamicsSettings, HoistControl},
    model::Model,
    operation::Operation,
    outcome::{Column, TIME_SERIES, TimeSeries, samples::ends},
};

use crate::{
    Check, CheckKind, Recent, Severity,
    window::{Window, share},
};

/// A mean that is off its target by more than this part of it is reported: the resolution of a
/// weight indicator.
const OFF: f64 = 0.05;

/// A mean that is off by more than this belongs to a different operation than the requested one.
const FAR_OFF: f64 = 0.2;

/// The same of a weight that no control holds, but that follows from a hook load: twice the
/// requested weight.
const FAR_OFF_UNHELD: f64 = 1.0;

/// A standard deviation beyond this part of the mean is reported: the weight then swings by half of
/// it either way.
const UNSTEADY: f64 = 0.25;

/// A bit that is off the rock for more than this share of the time bounces.
const BOUNCES: f64 = 0.01;

/// Time in which an autodriller reaches its set point, s; only then a weight counts as missed.
const REACHED_S: f64 = 5.0;

/// Part of the string's buoyed weight that no indicator shows.
const NONE: f64 = 1e-3;

const WEIGHT: &Column<TimeSeries> = Column::named(TIME_SERIES, "weight_on_bit_N");
const SET_WEIGHT: &Column<TimeSeries> = Column::named(TIME_SERIES, "weight_on_bit_set_N");

/// Returns the checks of an operation with the bit on bottom.
pub fn checks(
    operation: &Operation,
    settings: &DynamicsSettings,
    window: &Window<'_>,
) -> Vec<Check> {
    let mut found = Vec::new();
    let (true, Some(weight)) = (operation.kind.on_bottom(), window.statistic("weight_on_bit_N"))
    else {
        return found;
    };
    if let Some((target_N, held)) = target_N(operation, settings, window) {
        found.extend(off_target(weight.mean, target_N, held));
    }
    if weight.mean > 0.0 && weight.std > UNSTEADY * weight.mean {
        found.push(
            Check::reported(CheckKind::WeightOnBitUnsteady, Severity::Warning)
                .value(weight.std)
                .limit(UNSTEADY * weight.mean),
        );
    }
    let off_rock = share(&window.scalar(WEIGHT), |weight_N| weight_N <= 0.0);
    if weight.mean > 0.0 && off_rock > BOUNCES {
        found.push(
            Check::reported(CheckKind::BitBounce, Severity::Warning).value(off_rock).limit(BOUNCES),
        );
    }
    found
}

/// The requested weight, N, and whether a control holds it; `None` where no weight is requested, or
/// it changes in the window.
fn target_N(
    operation: &Operation,
    settings: &DynamicsSettings,
    window: &Window<'_>,
) -> Option<(f64, bool)> {
    let set_N = window.scalar(SET_WEIGHT);
    if let Some([first_N, _]) = ends(&set_N).filter(|[first_N, _]| !first_N.is_nan()) {
        let changes = share(&set_N, |weight_N| weight_N != first_N) > 0.0;
        return (!changes && first_N > 0.0).then_some((first_N, true));
    }
    let lifted = matches!(settings.hoist_control, Some(HoistControl::HookLoad(_)));
    (lifted && settings.schedule.is_empty() && operation.weight_on_bit_N > 0.0)
        .then_some((operation.weight_on_bit_N, false))
}

/// Mean weight of the last seconds against a set point that has not changed since.
pub(crate) fn recent(recent: &Recent<'_>) -> Option<Check> {
    let (weights_N, set_N) = (recent.weight_on_bit_N, recent.weight_on_bit_set_N);
    let target_N = set_N.first().copied().filter(|target_N| *target_N > 0.0)?;
    let is_steady = set_N.iter().all(|set_N| *set_N == target_N);
    let is_long = weights_N.len() as f64 * recent.sample_s >= REACHED_S;
    let mean_N = weights_N.iter().sum::<f64>() / weights_N.len() as f64;
    (is_steady && is_long).then(|| off_target(mean_N, target_N, true)).flatten()
}

/// A weight on bit that is more than string, block and rig provide without friction, N; `None`
/// where they provide it.
pub(crate) fn weight_not_available(
    model: &Model,
    requested_N: f64,
    available_N: f64,
) -> Option<Check> {
    let is_missing = requested_N - available_N > NONE * model.buoyed_weight_N();
    (requested_N > 0.0 && is_missing).then(|| {
        let check = Check::reported(CheckKind::WeightNotAvailable, Severity::Error);
        check.value(requested_N).limit(available_N.max(0.0))
    })
}

fn off_target(mean_N: f64, target_N: f64, held: bool) -> Option<Check> {
    let off = mean_N / target_N - 1.0;
    let kind = match off < 0.0 {
        true => CheckKind::WeightOnBitNotReached,
        false => CheckKind::WeightOnBitExceeded,
    };
    let far = if held { FAR_OFF } else { FAR_OFF_UNHELD };
    let severity = if off.abs() > far { Severity::Error } else { Severity::Warning };
    (off.abs() > OFF).then(|| Check::reported(kind, severity).value(mean_N).limit(target_N))
}
