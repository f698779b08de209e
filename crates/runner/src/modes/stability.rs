//! The map of torsional stability of a case that drills.

use std::{borrow::Cow, num::NonZeroUsize, sync::Mutex};

use wholestring::{
    model::Model,
    operation::{Operation, OperationKind},
    torsional_stability::{
        StabilityError, StabilityLine, StabilityRange, StabilitySettings, Threshold,
        TorsionalStability,
    },
    well::{Hole, Well},
};
use wholestring_case::Case;
use wholestring_report::StabilityPicture;
use wholestring_results::{StabilitySummary, StableFrom, StableWhere, Table};
use wholestring_units::{Dimension, UnitSet};

use crate::{
    cancellation::CancellationToken,
    parallel::{in_parallel, jobs, lock},
};

/// Numbers of rotary speeds and weights of the map.
const SPEEDS: usize = 20;
const WEIGHTS: usize = 19;

/// The map of a case, and its result for the case's own speed and weight.
pub(super) struct Stability {
    pub(super) summary: StabilitySummary,
    pub(super) lines: Vec<StabilityLine>,
}

/// Computes the map of an operation that drills, or else of the case's first that does. Returns the
/// reason if there is none: no operation rotates on bottom, the bit is on solid rock, or settings
/// of the dynamics are invalid. After a cancellation the map is invalid.
pub(super) fn find(
    case: &Case,
    operation: &Operation,
    jobs: Option<NonZeroUsize>,
    cancellation: &CancellationToken,
) -> Result<Stability, String> {
    let drills = |operation: &&Operation| operation.kind == OperationKind::Drill;
    let operation = [operation].into_iter().chain(&case.operations).find(drills);
    let found = operation.map(|operation| map(case, operation, jobs, cancellation));
    found.unwrap_or(Err(StabilityError::NotDrilling)).map_err(|error| error.to_string())
}

fn map(
    case: &Case,
    operation: &Operation,
    requested: Option<NonZeroUsize>,
    cancellation: &CancellationToken,
) -> Result<Stability, StabilityError> {
    let settings = settings(case);
    let model = with_static_friction(&case.model, case.modes.static_over_kinetic);
    let string = TorsionalStability::new(&model, operation, &case.dynamics)?;
    let of_case = string.of_case(&settings)?;
    let weights = settings.weights_N.values();
    let lines: Vec<Mutex<Option<Result<StabilityLine, StabilityError>>>> =
        weights.iter().map(|_| Mutex::new(None)).collect();
    let order: Vec<usize> = (0..weights.len()).collect();
    in_parallel(jobs(requested), &order, |index| {
        if !cancellation.is_cancelled() {
            *lock(&lines[index]) = Some(string.line(weights[index], &settings));
        }
    });
    let lines: Result<Vec<StabilityLine>, StabilityError> =
        lines.iter().filter_map(|line| lock(line).take()).collect();
    let lines = lines?;
    // A map that could not have any other result would be misleading.
    let stable = |line: &StabilityLine| line.threshold == Threshold::Everywhere;
    let falls = string.anything_falls()?;
    if lines.iter().all(stable) && of_case.threshold == Threshold::Everywhere && !falls {
        return Err(string.nothing_falls());
    }
    let summary = StabilitySummary::new(&of_case, settings.highest_Hz);
    let summary = StabilitySummary { driven_by_rate: !falls, ..summary };
    Ok(Stability { summary, lines })
}

/// The model with static friction at this ratio to kinetic friction, in sections without higher
/// static friction.
fn with_static_friction(model: &Model, ratio: f64) -> Cow<'_, Model> {
    let hole = &model.well.hole;
    let sections = hole.sections().iter().map(|section| {
        let mut section = *section;
        let friction = &mut section.friction;
        if friction.at_rest <= friction.kinetic {
            friction.at_rest = ratio * friction.kinetic;
        }
        section
    });
    let hole_of = |sections| Hole::new(sections)?.with_roughness(hole.roughness().copied());
    match hole_of(sections.collect()) {
        Ok(hole) if ratio > 1.0 => {
            let path = model.well.path.clone();
            Cow::Owned(Model { well: Well { path, hole }, ..model.clone() })
        }
        _ => Cow::Borrowed(model),
    }
}

/// Ranges of the map.
fn settings(case: &Case) -> StabilitySettings {
    let range = |[from, to]: [f64; 2], values: usize| StabilityRange { from, to, values };
    let [slowest, fastest] = case.modes.rotary_rad_per_s;
    StabilitySettings {
        // A string at zero speed has no steady rotation.
        speeds_rad_per_s: range([slowest.max(fastest / SPEEDS as f64), fastest], SPEEDS),
        weights_N: range(case.modes.weights_N, WEIGHTS),
        highest_Hz: case.modes.highest_frequency_Hz,
    }
}

/// Conclusions from the map, in sentences. `operation` is the analysed operation, which
/// is not that of the map if it does not rotate on bottom.
pub fn sentences(
    operation: OperationKind,
    summary: &StabilitySummary,
    units: UnitSet,
) -> Vec<String> {
    let speed = |si: f64| Dimension::RotarySpeed.format(three(si / RPM) * RPM, units);
    let weight = Dimension::Force.format(summary.weight_on_bit_N, units);
    let own = speed(summary.rotary_speed_rad_per_s);
    let mut sentences = Vec::new();
    let drill = OperationKind::Drill;
    if operation != drill {
        sentences.push(format!(
            "The map is of the rotating string: `{}` does not rotate on bottom, and the case's \
             `{drill}` at {own} is taken.",
            operation.words(),
        ));
    }
    sentences.push(match summary.from {
        StableFrom { threshold_rad_per_s: Some(threshold), .. } => format!(
            "At {weight} steady rotation is stable from {} on; the case's {own} is {:.0} % {}.",
            speed(threshold),
            100.0 * summary.margin.unwrap_or(0.0).abs(),
            if summary.margin.unwrap_or(0.0) < 0.0 { "below" } else { "above" },
        ),
        StableFrom { stable: StableWhere::Everywhere, .. } => {
            format!("At {weight} steady rotation is stable at all speeds of the map.")
        }
        _ => format!(
            "At {weight} steady rotation is not stable even at the fastest speed of the map."
        ),
    });
    if let (Some(growth), Some(frequency)) = (summary.growth_per_s, summary.frequency_Hz) {
        let how = if growth > 0.0 { "grows" } else { "dies away" };
        sentences.push(format!(
            "At {own} a swing of {frequency:.3} Hz {how} by {:.3} 1/s{}.",
            growth.abs(),
            if growth > 0.0 { ", fastest of all" } else { ", slowest of all" },
        ));
    }
    if summary.driven_by_rate {
        sentences.push(
            "Neither the torque of the bit nor the axial friction falls with speed in this case: \
             the instability on the map is driven by the rate of penetration. A bit that slows \
             down drills less than the string advances, so that its weight increases, and its \
             torque with it."
                .into(),
        );
    }
    if summary.stalls {
        sentences.push(format!(
            "The string requires {} at the top, more than the top drive provides.",
            Dimension::Torque.format(summary.surface_torque_N_m, units)
        ));
    }
    let parts = summary.reflections.iter().map(|[frequency_Hz, part]| {
        format!("{:.0} % of a wave of {frequency_Hz:.2} Hz", 100.0 * part)
    });
    let parts = parts.collect::<Vec<_>>().join(", ");
    sentences.push(match gives_way(summary) {
        true => format!(
            "The top drive reflects {parts}; the first is the string's lowest torsional frequency."
        ),
        false => "The top turns at a constant speed and reflects every wave completely.".into(),
    });
    if let Some(better) = &summary.better_controller {
        let from = match better.from.threshold_rad_per_s {
            Some(threshold) => format!("from {} on", speed(threshold)),
            None => "at all speeds of the map".to_owned(),
        };
        sentences.push(format!(
            "SoftTorque with impedance_ratio = {} would reflect {:.0} % and be stable {from}.",
            better.impedance_ratio,
            100.0 * better.reflection
        ));
    } else if summary.from.stable != StableWhere::Everywhere && gives_way(summary) {
        sentences.push("No SoftTorque that was tried has a lower threshold.".into());
    }
    if summary.lies_by == "soft" {
        sentences.push(
            "The stiff string found no equilibrium: contact forces are the soft string's.".into(),
        );
    }
    sentences
}

/// Whether the drive has inertia; a drive at constant speed reflects every wave completely.
fn gives_way(summary: &StabilitySummary) -> bool {
    summary.reflections.iter().any(|[_, part]| *part < 1.0)
}

/// rad/s in a revolution per minute.
const RPM: f64 = std::f64::consts::PI / 30.0;

/// A number in three digits.
fn three(value: f64) -> f64 {
    format!("{value:.2e}").parse().unwrap_or(value)
}

/// The map as the page shows it, from its table.
pub(super) fn picture(table: &Table, summary: &StabilitySummary) -> StabilityPicture {
    let column = |name: &str| -> Vec<f64> {
        let column = table.numbers(name).unwrap_or_default();
        column.iter().map(|value| value.unwrap_or(f64::NAN)).collect()
    };
    let all_weights_N = column("weight_on_bit_N");
    let mut weights_N = all_weights_N.clone();
    weights_N.dedup();
    let speeds = all_weights_N.len() / weights_N.len().max(1);
    let thresholds = column("threshold_rad_per_s");
    StabilityPicture {
        speeds_rad_per_s: column("rotary_speed_rad_per_s").into_iter().take(speeds).collect(),
        weights_N,
        growth_per_s: column("growth_per_s"),
        thresholds_rad_per_s: thresholds.into_iter().step_by(speeds.max(1)).collect(),
        own: [summary.rotary_speed_rad_per_s, summary.weight_on_bit_N],
    }
}
