//! Standpipe pressure, equivalent density, surge and swab against the depth of the bit.

use super::{
    FAR, Plan, PlanMudRow,
    depth_figure::{line, over_depth},
};
use crate::{
    figure::{Axis, Figure, Ink, Key, Mark, Panel, Range, Sample, Shape, Stroke},
    plots::DisplayUnits,
};

/// Motions of the string, in the order of a row.
pub(super) const STATES: [&str; 5] = [
    "circulating",
    "running in, string closed",
    "running in, string open",
    "pulling out, string closed",
    "pulling out, string open",
];

/// The pressure at the standpipe, and the densities at the bit and at the shoe.
pub(super) fn figure(plan: &Plan, display: DisplayUnits<'_>) -> Option<Figure> {
    let mud = plan.mud.as_ref().filter(|mud| !mud.rows.is_empty())?;
    let curve = |dimension: &str, place: usize, value: &dyn Fn(&PlanMudRow) -> f64| {
        let point = |row: &PlanMudRow| {
            (display.value(row.bit_depth_m, "length"), display.value(value(row), dimension))
        };
        let points = mud.rows.iter().map(point).collect();
        line(Ink::Line(place), Stroke::of(place), Shape::of(place), points)
    };
    let mut pressure = curve("pressure", 0, &|row| row.standpipe_Pa);
    let largest_Pa = mud.rows.iter().map(|row| row.standpipe_Pa).fold(0.0, f64::max);
    let near = mud.pump_limit_Pa.filter(|limit_Pa| *limit_Pa <= FAR * largest_Pa);
    pressure.extend(near.map(|limit_Pa| Mark::OwnRule {
        at: display.value(limit_Pa, "pressure"),
        label: "limit".to_owned(),
    }));
    let title = format!("Standpipe pressure, {}", mud.operation.words());
    let mut panels =
        vec![Panel::new(Axis::new(display.label(&title, "pressure"), Range::Zero), pressure)];
    let has_shoe = mud.rows.iter().any(|row| row.at_shoe_kg_per_m3[0].is_finite());
    type Densities = fn(&PlanMudRow) -> [f64; 5];
    let places: [(&str, Densities, bool); 2] = [
        ("Equivalent density at the bit", |row| row.at_bit_kg_per_m3, true),
        ("Equivalent density at the shoe", |row| row.at_shoe_kg_per_m3, has_shoe),
    ];
    for (title, densities, _) in places.into_iter().filter(|(.., is_there)| *is_there) {
        let mut marks: Vec<Mark> = (0..STATES.len())
            .flat_map(|place| curve("density", place, &|row| densities(row)[place]))
            .collect();
        marks.push(Mark::OwnRule {
            at: display.value(mud.density_kg_per_m3, "density"),
            label: "mud".to_owned(),
        });
        panels.push(Panel::new(Axis::new(display.label(title, "density"), Range::Tight), marks));
    }
    let key = |(place, name): (usize, &&str)| Key {
        name: (*name).to_owned(),
        sample: Sample::Line(Ink::Line(place), Stroke::of(place)),
    };
    let keys = STATES.iter().enumerate().map(key).collect();
    let mut subtitle =
        "steady speeds; closed: all mud displaced by the string flows up the annulus".to_owned();
    if let (Some(limit_Pa), None) = (mud.pump_limit_Pa, near) {
        subtitle += &format!(
            "; limit of the pump {}, beyond the picture",
            display.quantity(limit_Pa, "pressure")
        );
    }
    Some(over_depth(plan, display, &subtitle, keys, panels))
}
