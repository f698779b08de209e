//! Conclusions from the map of torsional stability, in sentences.

use wholestring::operation::OperationKind;
use wholestring_results::{StabilitySummary, StableFrom, StableWhere};
use wholestring_units::{Dimension, UnitSet, significant};

/// Conclusions from the map, in sentences. `operation` is the analysed operation, which
/// is not that of the map if it does not rotate on bottom.
pub fn stability_sentences(
    operation: OperationKind,
    summary: &StabilitySummary,
    units: UnitSet,
) -> Vec<String> {
    let speed = |si: f64| Dimension::RotarySpeed.format(significant(si / RPM, 3) * RPM, units);
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
