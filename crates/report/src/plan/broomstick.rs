//! Hook load and surface torque against the depth of the bit.

use wholestring::operation::OperationKind;
use wholestring_results::{PlanPoint, PlanSurfaceLimit};

use super::{
    Plan,
    curves::{Curve, hook_load_N, line, over_depth, surface_torque_N_m},
    measured, overlay, surface_limit_is_near, surface_limit_title,
};
use crate::{
    draw::palette::operation_colour,
    figure::{Axis, Figure, Ink, Key, Mark, Panel, Range, Sample, Shape, Stroke},
    plots::DisplayUnits,
    uncertain::Uncertain,
};

/// Curves that differ by less than this part of the largest are not distinguishable by eye.
const SAME: f64 = 2e-3;

/// A quantity of each point that a picture shows.
struct Quantity<'a> {
    title: &'a str,
    about: &'a str,
    /// Its name in the bands of uncertain numbers.
    name: &'a str,
    dimension: &'a str,
    value: fn(&PlanPoint) -> f64,
}

/// Trip in to the left, rotate off bottom, trip out to the right; operations that drill in a panel
/// of their own.
pub(super) fn hook_load(plan: &Plan, display: DisplayUnits<'_>) -> Option<Figure> {
    let quantity = Quantity {
        title: "Hook load",
        about: "without the weight of the block",
        name: "hook_load",
        dimension: "force",
        value: hook_load_N,
    };
    figure(plan, display, &quantity, |_| true)
}

/// Torque at the top in operations that rotate.
pub(super) fn torque(plan: &Plan, display: DisplayUnits<'_>) -> Option<Figure> {
    let quantity = Quantity {
        title: "Surface torque",
        about: "",
        name: "surface_torque",
        dimension: "torque",
        value: surface_torque_N_m,
    };
    figure(plan, display, &quantity, OperationKind::rotates)
}

fn figure(
    plan: &Plan,
    display: DisplayUnits<'_>,
    quantity: &Quantity<'_>,
    is_shown: fn(OperationKind) -> bool,
) -> Option<Figure> {
    let all = plan.operations().filter(|operation| is_shown(*operation));
    let (drilling, off): (Vec<_>, Vec<_>) = all.partition(|operation| operation.on_bottom());
    let groups = [(off, "off bottom"), (drilling, "on bottom")];
    let groups = groups.into_iter().filter(|(operations, _)| !operations.is_empty());
    let limits: Vec<&PlanSurfaceLimit> = plan.surface(quantity.dimension).collect();
    let mut largest = 0.0_f64;
    let mut panels = Vec::new();
    let mut operations = Vec::new();
    for (group, name) in groups {
        let (panel, most) = panel(plan, display, quantity, &group, name);
        panels.push(panel);
        largest = largest.max(most);
        operations.extend(group);
    }
    let mut keys = keys(plan, &operations);
    keys.extend(measured::keys(plan, &operations, quantity.dimension));
    keys.extend(overlay::keys(plan, &operations, quantity.dimension));
    let outside = limits.iter().filter(|limit| !surface_limit_is_near(limit, largest));
    let outside = outside.map(|limit| {
        let title = surface_limit_title(limit);
        format!("{title} {}", display.quantity(limit.allowed, quantity.dimension))
    });
    let subtitle = subtitle(plan, quantity.about, &outside.collect::<Vec<_>>());
    (!panels.is_empty()).then(|| over_depth(plan, display, &subtitle, keys, panels))
}

/// Some operations, and the largest value of their curves, SI: limits near it are drawn.
fn panel(
    plan: &Plan,
    display: DisplayUnits<'_>,
    quantity: &Quantity<'_>,
    operations: &[OperationKind],
    name: &str,
) -> (Panel, f64) {
    let value = |point: &PlanPoint| display.value((quantity.value)(point), quantity.dimension);
    let depth = |point: &PlanPoint| display.value(point.bit_depth_m, "length");
    let points = |curve: &Curve<'_>| -> Vec<(f64, f64)> {
        curve.points.iter().map(|point| (depth(point), value(point))).collect()
    };
    let mut marks = Vec::new();
    let mut largest = 0.0_f64;
    // Below all lines.
    for (uncertain, operation) in plan
        .samples()
        .iter()
        .flat_map(|uncertain| operations.iter().map(move |operation| (uncertain, operation)))
    {
        let band = uncertain.band(quantity.name, *operation).map(|(depth_m, ends)| {
            let [from, to] = ends.map(|end| display.value(end, quantity.dimension));
            largest = largest.max(from.abs()).max(to.abs());
            (display.value(depth_m, "length"), from, to)
        });
        let ink = Ink::Line(operation_colour(*operation));
        marks.push(Mark::Band { ink, points: band.collect() });
    }
    for operation in operations {
        let ink = Ink::Line(operation_colour(*operation));
        for (place, model) in plan.summary.models.iter().enumerate() {
            let mut ends: Vec<((f64, f64), &str)> = Vec::new();
            for curve in plan.curves_of(*model, *operation) {
                let points = points(&curve);
                let mut finite = points.iter().filter(|(_, value)| value.is_finite());
                largest = finite.clone().fold(largest, |most, (_, value)| most.max(value.abs()));
                ends.extend(finite.next_back().map(|end| (*end, curve.level.label.as_str())));
                let shape = Shape::of(curve.level.friction as usize);
                marks.extend(match place {
                    0 => line(ink, curve.level.stroke(), shape, points),
                    _ => vec![Mark::Points { ink, shape, points }],
                });
            }
            if place == 0 {
                marks.extend(names(&ends, largest));
            }
        }
    }
    // Above all curves.
    marks.extend(overlay::marks(plan, display, operations, quantity.dimension));
    marks.extend(measured::marks(plan, display, operations, quantity.dimension));
    let largest = largest / display.value(1.0, quantity.dimension);
    marks.extend(
        plan.surface(quantity.dimension).filter(|limit| surface_limit_is_near(limit, largest)).map(
            |limit| {
                let at = display.value(limit.allowed, quantity.dimension);
                Mark::OwnRule { at, label: surface_limit_title(limit).to_owned() }
            },
        ),
    );
    let title = format!("{}, {name}", quantity.title);
    let axis = Axis::new(display.label(&title, quantity.dimension), Range::Zero);
    (Panel::new(axis, marks), largest)
}

/// The friction at the end of each line; none where the lines of all frictions coincide.
fn names(ends: &[((f64, f64), &str)], largest: f64) -> Vec<Mark> {
    let values = || ends.iter().map(|(end, _)| end.1);
    let spread =
        values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min);
    if spread < SAME * largest {
        return Vec::new();
    }
    let name = |(at, text): &((f64, f64), &str)| Mark::Foot { at: *at, text: (*text).to_owned() };
    ends.iter().map(name).collect()
}

fn keys(plan: &Plan, operations: &[OperationKind]) -> Vec<Key> {
    let key = |name: String, sample| Key { name, sample };
    let mut keys: Vec<Key> = operations
        .iter()
        .map(|operation| {
            let ink = Ink::Line(operation_colour(*operation));
            key(operation.words().to_owned(), Sample::Line(ink, Stroke::Solid))
        })
        .collect();
    for level in &plan.levels {
        let name = format!("{} friction, {}", level.name(), level.label);
        keys.push(key(name, Sample::Line(Ink::Note, level.stroke())));
    }
    if plan.samples().is_some() {
        let name = "5 to 95 % of the samples".to_owned();
        keys.push(key(name, Sample::Band(Ink::Note)));
    }
    if let [_, others @ ..] = &plan.summary.models[..] {
        for model in others {
            for (place, level) in plan.levels.iter().enumerate() {
                let name = format!("{model} string, {} friction", level.name());
                keys.push(key(name, Sample::Point(Ink::Note, Shape::of(place))));
            }
        }
    }
    keys
}

/// The subject of the picture, and limits that are beyond it.
fn subtitle(plan: &Plan, about: &str, outside: &[String]) -> String {
    let first = plan.summary.models.first();
    let lines = first.map(|model| match plan.summary.models.len() {
        1 => format!("{model} string"),
        _ => format!("lines: {model} string"),
    });
    let about = (!about.is_empty()).then(|| about.to_owned());
    let limits = match outside {
        [] => None,
        [one] => Some(format!("limit beyond the picture: {one}")),
        several => Some(format!("limits beyond the picture: {}", several.join(", "))),
    };
    let bands = plan.samples().map(Uncertain::description);
    lines.into_iter().chain(about).chain(limits).chain(bands).collect::<Vec<_>>().join("; ")
}
