//! The picture of a run: tension, torque and side force against depth, models overlaid.

use wholestring::well::{Hole, HoleKind};
use wholestring_report::{Curve, Interval, IntervalKind, Panel, Profile, Stroke, profile_svg};
use wholestring_results::{Data, Table};
use wholestring_units::{Dimension, UnitSet};

/// The profiles in a table of nodes as the text of an SVG file.
pub(crate) fn draw(
    title: &str,
    subtitle: &str,
    nodes: &Table,
    hole: &Hole,
    units: UnitSet,
) -> String {
    let length = Dimension::Length.unit_in(units);
    let panel =
        |name: &str, dimension: Dimension, column: &str, sides: Option<[String; 2]>| Panel {
            label: format!("{name}, {}", dimension.unit_in(units).symbol),
            sides,
            curves: curves(nodes, column, dimension, units),
        };
    let deepest = number(nodes, "md_m")
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

fn number<'a>(table: &'a Table, name: &str) -> &'a [Option<f64>] {
    match table.column(name).map(|column| &column.data) {
        Some(Data::Number(values)) => values,
        _ => &[],
    }
}

fn text<'a>(table: &'a Table, name: &str) -> &'a [String] {
    match table.column(name).map(|column| &column.data) {
        Some(Data::Text(values)) => values,
        _ => &[],
    }
}

/// One curve per operation and model. Operations differ by colour and models by stroke; with one
/// operation alone the models differ by colour too.
fn curves(nodes: &Table, column: &str, dimension: Dimension, units: UnitSet) -> Vec<Curve> {
    let (models, operations) = (text(nodes, "model"), text(nodes, "operation"));
    let mut names: Vec<&str> = operations.iter().map(String::as_str).collect();
    names.dedup();
    let mut order: Vec<&str> = Vec::new();
    for name in names {
        if !order.contains(&name) {
            order.push(name);
        }
    }
    let both = ["soft", "dynamic"]
        .iter()
        .all(|name| models.iter().any(|model| model == name));
    let length = Dimension::Length.unit_in(units);
    let unit = dimension.unit_in(units);
    let rows = number(nodes, "md_m").iter().zip(number(nodes, column));
    let mut curves: Vec<Curve> = Vec::new();
    let mut last = None;
    for (row, (md, value)) in rows.enumerate() {
        let (model, operation) = (models[row].as_str(), operations[row].as_str());
        if last != Some((model, operation)) {
            last = Some((model, operation));
            let soft = model == "soft";
            let index = order
                .iter()
                .position(|name| *name == operation)
                .unwrap_or(0);
            curves.push(Curve {
                name: format!(
                    "{}, {}",
                    operation.replace('_', " "),
                    if soft { "soft string" } else { "dynamics" }
                ),
                colour: if order.len() == 1 && soft && both {
                    1
                } else {
                    index
                },
                stroke: if soft && both {
                    Stroke::Dashed
                } else {
                    Stroke::Solid
                },
                points: Vec::new(),
            });
        }
        let shown = |value: &Option<f64>, unit: &wholestring_units::Unit| {
            value.map_or(f64::NAN, |si| unit.from_si(si))
        };
        if let Some(curve) = curves.last_mut() {
            curve.points.push((shown(md, length), shown(value, unit)));
        }
    }
    curves
}
