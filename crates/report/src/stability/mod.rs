//! The map of torsional stability on paper.

use wholestring::operation::OperationKind;
use wholestring_results::{StabilitySummary, StableFrom, StableWhere, Table};
use wholestring_units::{Dimension, UnitSet, significant};

use crate::{
    PageHead,
    figure::{Axis, Figure, Hue, Ink, Key, Layout, Map, Mark, Panel, Range, Sample, Shape, Stroke},
    plots::DisplayUnits,
};

/// The map of torsional stability as it is drawn. Numbers are SI; one that is not known is not
/// finite.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct StabilityPicture {
    /// Rotary speeds, rad/s, increasing.
    pub(crate) speeds_rad_per_s: Vec<f64>,
    /// Weights on bit, N, increasing.
    pub(crate) weights_N: Vec<f64>,
    /// Growth rate of the fastest growing motion, 1/s: for the first weight at each speed, then for
    /// the next.
    pub(crate) growth_per_s: Vec<f64>,
    /// Speed from which each weight is stable, rad/s; not a number where all are, or none is.
    pub(crate) thresholds_rad_per_s: Vec<f64>,
    /// The case's own rotary speed, rad/s, and weight on bit, N.
    pub(crate) own: [f64; 2],
}

impl StabilityPicture {
    /// The map of `stability.parquet`, with the case's own place in it.
    pub(crate) fn new(table: &Table, summary: &StabilitySummary) -> Self {
        let column = |name: &str| table.values(name);
        let all_weights_N = column("weight_on_bit_N");
        let mut weights_N = all_weights_N.clone();
        weights_N.dedup();
        let speeds = all_weights_N.len() / weights_N.len().max(1);
        let thresholds = column("threshold_rad_per_s");
        Self {
            speeds_rad_per_s: column("rotary_speed_rad_per_s").into_iter().take(speeds).collect(),
            weights_N,
            growth_per_s: column("growth_per_s"),
            thresholds_rad_per_s: thresholds.into_iter().step_by(speeds.max(1)).collect(),
            own: [summary.rotary_speed_rad_per_s, summary.weight_on_bit_N],
        }
    }
}

// Growth of steady rotation into stick-slip, over rotary speed and weight on bit.

/// Columns and rows with which the map is refined between those that were computed.
const FINE: usize = 8;

/// The map in a set of units (`si`, `metric` or `field`): growth in colours where it is unstable,
/// the threshold, and the case's own speed and weight.
pub(crate) fn stability_figure(picture: &StabilityPicture, head: &PageHead, units: &str) -> Figure {
    let display = DisplayUnits::new(&head.dimensions, units);
    let speed = |si: f64| display.value(si, "rotary speed");
    let weight = |si: f64| display.value(si, "force");
    let speeds = finer(&picture.speeds_rad_per_s);
    let weights = finer(&picture.weights_N);
    let values: Vec<f64> = speeds
        .iter()
        .flat_map(|s| weights.iter().map(move |w| picture.growth_at(*s, *w)))
        .map(|growth| if growth > 0.0 { growth } else { f64::NAN })
        .collect();
    let largest = values.iter().copied().filter(|value| value.is_finite()).fold(0.0, f64::max);
    let ends: Vec<f64> = speeds.windows(2).map(|pair| speed(0.5 * (pair[0] + pair[1]))).collect();
    let [first, last] = ends_of(&picture.speeds_rad_per_s).map(speed);
    let mut marks = Vec::new();
    let mut keys = Vec::new();
    if largest > 0.0 {
        marks.push(Mark::Map(Map {
            from: first,
            ends: ends.into_iter().chain([last]).collect(),
            middles: weights.iter().map(|w| weight(*w)).collect(),
            values,
            hue: Hue::Amount,
            largest,
            label: "Growth rate of the fastest growing motion, 1/s".into(),
            sides: None,
        }));
    }
    let line: Vec<(f64, f64)> = picture
        .thresholds_rad_per_s
        .iter()
        .zip(&picture.weights_N)
        .map(|(s, w)| (speed(*s), weight(*w)))
        .collect();
    if line.iter().any(|(s, _)| s.is_finite()) {
        marks.push(Mark::Curve { ink: Ink::Text, stroke: Stroke::Solid, points: line });
        keys.push(Key {
            name: "threshold: stable at all higher speeds".into(),
            sample: Sample::Line(Ink::Text, Stroke::Solid),
        });
    }
    let own = (speed(picture.own[0]), weight(picture.own[1]));
    marks.push(Mark::Points { ink: Ink::Error, shape: Shape::Diamond, points: vec![own] });
    keys.push(Key { name: "the case".into(), sample: Sample::Point(Ink::Error, Shape::Diamond) });
    let axis = |name: &str, dimension: &str, [from, to]: [f64; 2]| {
        Axis::new(display.label(name, dimension), Range::Fixed(from, to))
    };
    let rows = ends_of(&picture.weights_N).map(weight);
    let including = |[from, to]: [f64; 2], own: f64| [from.min(own), to.max(own)];
    Figure {
        title: head.title.clone(),
        subtitle: if largest > 0.0 {
            "torsional stability: coloured where steady rotation grows into stick-slip".into()
        } else {
            "torsional stability: stable at all these speeds and weights".into()
        },
        keys,
        layout: Layout::across(1, 140.0, 85.0),
        shared: axis("Rotary speed", "rotary speed", including([first, last], own.0)),
        panels: vec![Panel::new(axis("Weight on bit", "force", including(rows, own.1)), marks)],
        hole: Vec::new(),
    }
}

impl StabilityPicture {
    /// Growth between the points of the map.
    fn growth_at(&self, speed: f64, weight: f64) -> f64 {
        let [(i, right), (j, up)] =
            [place(&self.speeds_rad_per_s, speed), place(&self.weights_N, weight)];
        let columns = self.speeds_rad_per_s.len();
        let at = |row: usize, column: usize| {
            let rows = self.weights_N.len();
            let (row, column) =
                (row.min(rows.saturating_sub(1)), column.min(columns.saturating_sub(1)));
            self.growth_per_s.get(row * columns + column).copied().unwrap_or(f64::NAN)
        };
        let row = |j: usize| at(j, i) + right * (at(j, i + 1) - at(j, i));
        row(j) + up * (row(j + 1) - row(j))
    }
}

/// Position of a value among increasing ones: the index before it, and the part of the way to the
/// next.
fn place(values: &[f64], at: f64) -> (usize, f64) {
    let after = values.partition_point(|value| *value <= at).saturating_sub(1);
    let Some(next) = values.get(after + 1) else {
        return (after, 0.0);
    };
    (after, ((at - values[after]) / (next - values[after])).clamp(0.0, 1.0))
}

/// The same values with others between.
fn finer(values: &[f64]) -> Vec<f64> {
    let between = |pair: &[f64]| -> Vec<f64> {
        (0..FINE).map(|i| pair[0] + (pair[1] - pair[0]) * i as f64 / FINE as f64).collect()
    };
    values.windows(2).flat_map(between).chain(values.last().copied()).collect()
}

/// The first and the last.
fn ends_of(values: &[f64]) -> [f64; 2] {
    [values.first(), values.last()].map(|value| value.copied().unwrap_or(f64::NAN))
}

// Conclusions from the map of torsional stability, in sentences.

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

#[cfg(test)]
mod tests;
