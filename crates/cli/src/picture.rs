//! The picture of a run: tension, torque and side force against depth, models overlaid.

use wholestring::well::{Hole, HoleKind};
use wholestring_report::{
    Curve, Entry, Interval, IntervalKind, Panel, Profile, Stroke, profile_svg,
};
use wholestring_results::Table;
use wholestring_units::{Dimension, Unit, UnitSet};

use crate::column::{numbers, words};

/// The profiles in a table of nodes as the text of an SVG file.
pub(crate) fn draw(
    title: &str,
    subtitle: &str,
    nodes: &Table,
    hole: &Hole,
    units: UnitSet,
) -> String {
    let length = Dimension::Length.unit_in(units);
    let legend = Legend::of(nodes);
    let panel =
        |name: &str, dimension: Dimension, column: &str, sides: Option<[String; 2]>| Panel {
            label: format!("{name}, {}", dimension.unit_in(units).symbol),
            sides,
            curves: curves(nodes, &legend, column, dimension, units),
        };
    let deepest = numbers(nodes, "md_m")
        .iter()
        .flatten()
        .fold(0.0, |a: f64, b| a.max(*b));
    let intervals = hole
        .sections()
        .iter()
        .filter(|section| section.from_md_m < deepest);
    let diameter = |si| Dimension::Diameter.format(si, units);
    profile_svg(&Profile {
        title: title.into(),
        subtitle: subtitle.into(),
        depth_label: format!("Measured depth, {}", length.symbol),
        legend: legend.entries(),
        panels: vec![
            panel("Effective tension", Dimension::Force, "tension_N", None),
            panel("Torque", Dimension::Torque, "torque_N_m", None),
            panel(
                "Side force",
                Dimension::ForcePerLength,
                "side_force_N_per_m",
                Some(["low side".into(), "high side".into()]),
            ),
        ],
        hole: intervals
            .map(|section| {
                let (kind, name) = match section.kind {
                    HoleKind::Casing => (IntervalKind::Casing, "casing"),
                    HoleKind::Open => (IntervalKind::Open, "open hole"),
                };
                Interval {
                    from: length.from_si(section.from_md_m.max(0.0)),
                    to: length.from_si(section.to_md_m.min(deepest)),
                    kind,
                    label: format!("{name}, {}", diameter(section.diameter_m)),
                }
            })
            .collect(),
    })
}

/// What is drawn: operations in the order of the table, and by which models.
struct Legend<'a> {
    operations: Vec<&'a str>,
    soft: bool,
    dynamic: bool,
}

impl<'a> Legend<'a> {
    fn of(nodes: &'a Table) -> Self {
        let mut operations: Vec<&str> = Vec::new();
        for operation in words(nodes, "operation") {
            if !operations.contains(&operation.as_str()) {
                operations.push(operation);
            }
        }
        let has = |model| words(nodes, "model").iter().any(|name| name == model);
        Self {
            operations,
            soft: has("soft"),
            dynamic: has("dynamic"),
        }
    }

    /// Operations differ by colour and models by stroke; with one operation alone the models differ by
    /// colour too.
    fn look(&self, model: &str, operation: &str) -> (usize, Stroke) {
        let index = self.operations.iter().position(|name| *name == operation);
        let index = index.unwrap_or(0);
        match (self.soft && self.dynamic, model, self.operations.len()) {
            (true, "soft", 1) => (1, Stroke::Dashed),
            (true, "soft", _) => (index, Stroke::Dashed),
            _ => (index, Stroke::Solid),
        }
    }

    fn entries(&self) -> Vec<Entry> {
        let models = [
            ("soft", "soft string", self.soft),
            ("dynamic", "dynamics", self.dynamic),
        ];
        let models = models.iter().filter(|(_, _, drawn)| *drawn);
        let entry = |name: String, colour, stroke| Entry {
            name,
            colour,
            stroke,
        };
        if self.operations.len() == 1 {
            return models
                .map(|(model, name, _)| {
                    let (colour, stroke) = self.look(model, self.operations[0]);
                    entry(name.to_string(), Some(colour), stroke)
                })
                .collect();
        }
        let operations = self.operations.iter().enumerate();
        operations
            .map(|(index, name)| entry(name.replace('_', " "), Some(index), Stroke::Solid))
            .chain(models.map(|(model, name, _)| {
                let (_, stroke) = self.look(model, "");
                entry(name.to_string(), None, stroke)
            }))
            .collect()
    }
}

/// One curve per operation and model, whose rows follow each other.
fn curves(
    nodes: &Table,
    legend: &Legend,
    column: &str,
    dimension: Dimension,
    units: UnitSet,
) -> Vec<Curve> {
    let (models, operations) = (words(nodes, "model"), words(nodes, "operation"));
    let length = Dimension::Length.unit_in(units);
    let unit = dimension.unit_in(units);
    let shown =
        |value: &Option<f64>, unit: &Unit| value.map_or(f64::NAN, |value| unit.from_si(value));
    let mut curves: Vec<Curve> = Vec::new();
    let mut last = None;
    let rows = numbers(nodes, "md_m").iter().zip(numbers(nodes, column));
    for (row, (md, value)) in rows.enumerate() {
        let this = (models[row].as_str(), operations[row].as_str());
        if last != Some(this) {
            last = Some(this);
            let (colour, stroke) = legend.look(this.0, this.1);
            curves.push(Curve {
                colour,
                stroke,
                points: Vec::new(),
            });
        }
        if let Some(curve) = curves.last_mut() {
            curve.points.push((shown(md, length), shown(value, unit)));
        }
    }
    curves
}
