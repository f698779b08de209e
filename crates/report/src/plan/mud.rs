//! Standpipe pressure, equivalent density, surge and swab against the depth of the bit.

use wholestring_results::{PlanDensity, PlanHydraulics};

use super::{
    Plan,
    curves::{line, over_depth},
    limits::FAR,
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

/// Equivalent density at the casing shoe, kg/m³; not a number without casing.
pub(super) fn at_shoe_kg_per_m3(density: PlanDensity) -> f64 {
    density.shoe_kg_per_m3.unwrap_or(f64::NAN)
}

/// Whether there is a casing shoe.
pub(super) fn has_shoe(rows: &[PlanHydraulics]) -> bool {
    rows.iter().any(|row| row.circulating.shoe_kg_per_m3.is_some())
}

/// The pressure at the standpipe, and the densities at the bit and at the shoe.
pub(super) fn figure(plan: &Plan, display: DisplayUnits<'_>) -> Option<Figure> {
    let rows = &plan.summary.hydraulics;
    let operation = rows.first()?.operation;
    let curve = |dimension: &str, place: usize, value: &dyn Fn(&PlanHydraulics) -> f64| {
        let point = |row: &PlanHydraulics| {
            (display.value(row.bit_depth_m, "length"), display.value(value(row), dimension))
        };
        let points = rows.iter().map(point).collect();
        line(Ink::Line(place), Stroke::of(place), Shape::of(place), points)
    };
    let mut pressure = curve("pressure", 0, &|row| row.standpipe_pressure_Pa);
    let largest_Pa = rows.iter().map(|row| row.standpipe_pressure_Pa).fold(0.0, f64::max);
    let pump_limit_Pa = plan.summary.pump_pressure_limit_Pa();
    let near = pump_limit_Pa.filter(|limit_Pa| *limit_Pa <= FAR * largest_Pa);
    pressure.extend(near.map(|limit_Pa| Mark::OwnRule {
        at: display.value(limit_Pa, "pressure"),
        label: "limit".to_owned(),
    }));
    let title = format!("Standpipe pressure, {}", operation.words());
    let mut panels =
        vec![Panel::new(Axis::new(display.label(&title, "pressure"), Range::Zero), pressure)];
    let mud_kg_per_m3 = plan.summary.mud_density_kg_per_m3().unwrap_or(f64::NAN);
    type Density = fn(PlanDensity) -> f64;
    let places: [(&str, Density, bool); 2] = [
        ("Equivalent density at the bit", |density| density.bit_kg_per_m3, true),
        ("Equivalent density at the shoe", at_shoe_kg_per_m3, has_shoe(rows)),
    ];
    for (title, density, _) in places.into_iter().filter(|(.., is_there)| *is_there) {
        let mut marks: Vec<Mark> = (0..STATES.len())
            .flat_map(|place| curve("density", place, &|row| density(row.densities()[place].1)))
            .collect();
        marks.push(Mark::OwnRule {
            at: display.value(mud_kg_per_m3, "density"),
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
    if let (Some(limit_Pa), None) = (pump_limit_Pa, near) {
        subtitle += &format!(
            "; limit of the pump {}, beyond the picture",
            display.quantity(limit_Pa, "pressure")
        );
    }
    Some(over_depth(plan, display, &subtitle, keys, panels))
}
