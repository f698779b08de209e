//! Pictures of linear vibration.

use std::f64::consts::TAU;

use wholestring_results::{CampbellRow, ModeFound, ModeShapeRow, ResponseRow};

use super::Modes;
use crate::{
    Plot,
    figure::{
        Axis, Direction, Figure, Ink, Key, Layout, Mark, Panel, Range, Sample, Scale, Shape, Stroke,
    },
    plots::{DisplayUnits, named},
    stability::stability_figure,
};

/// Families, in the order of their colours.
const FAMILIES: [&str; 3] = ["lateral", "axial", "torsional"];

/// Lateral shapes that are drawn, and shapes of the other families.
const DRAWN: usize = 6;
const DRAWN_OTHERS: usize = 3;

/// Names of the pictures of linear vibration; the last one is for a string that drills.
pub const MODES_PICTURES: [&str; 5] =
    ["campbell", "mode_shapes", "string_shapes", "response", "stability"];

/// Returns every picture of linear vibration, in a set of units (`si`, `metric` or `field`).
pub fn modes_plots(modes: &Modes, units: &str) -> Vec<Plot> {
    let drawing = Drawing { modes, display: DisplayUnits::new(&modes.head.dimensions, units) };
    let map = modes.stability_map.as_ref();
    let figures = [
        Some(drawing.campbell()),
        Some(drawing.lateral_shapes()),
        Some(drawing.string_shapes()),
        Some(drawing.response()),
        map.map(|map| stability_figure(map, &modes.head, units)),
    ];
    named(MODES_PICTURES, figures)
}

/// Drawing of the pictures of linear vibration.
struct Drawing<'a> {
    modes: &'a Modes,
    display: DisplayUnits<'a>,
}

fn family(name: &str) -> usize {
    FAMILIES.iter().position(|family| *family == name).unwrap_or(0)
}

/// A number of excitations per turn as shown to users: `1x`.
pub(super) fn order_name(order: f64) -> String {
    format!("{}x", (order * 1000.0).round() / 1000.0)
}

impl Drawing<'_> {
    fn speed(&self, rad_per_s: f64) -> f64 {
        self.display.value(rad_per_s, "rotary speed")
    }

    fn speed_axis(&self, range: Range) -> Axis {
        Axis::new(self.display.label("Rotary speed", "rotary speed"), range)
    }

    fn figure(&self, shared: Axis, layout: Layout, panels: Vec<Panel>, keys: Vec<Key>) -> Figure {
        let facts = self.modes.head.facts.iter().filter_map(|fact| self.display.fact(fact));
        Figure {
            title: self.modes.head.title.clone(),
            subtitle: facts.collect::<Vec<_>>().join("; "),
            keys,
            layout,
            shared,
            panels,
            hole: Vec::new(),
        }
    }

    fn campbell(&self) -> Figure {
        let modes = self.modes;
        let fastest = modes.branches().next().and_then(<[CampbellRow]>::last);
        let fastest = fastest.map_or(1.0, |row| row.rotary_speed_rad_per_s);
        // The lateral modes fill the picture; torsional and axial ones above them are cut off.
        let highest = |family: &str| {
            let rows = modes.rows.campbell.iter().filter(|row| row.family == family);
            rows.map(|row| row.frequency_Hz).fold(0.0, f64::max)
        };
        let top = 1.15 * highest("lateral").max(fastest / TAU);
        let mut marks = Vec::new();
        let mut orders: Vec<f64> =
            modes.summary.critical_speeds.iter().map(|critical| critical.order).collect();
        orders.sort_by(f64::total_cmp);
        orders.dedup();
        for order in orders {
            // A line from the origin, as far as the frame extends.
            let end = fastest.min(top * TAU / order);
            let points: Vec<(f64, f64)> =
                [0.0, end].map(|speed| (self.speed(speed), order * speed / TAU)).to_vec();
            marks.push(Mark::Name { at: points[1], text: order_name(order) });
            marks.push(Mark::Curve { ink: Ink::Note, stroke: Stroke::Dashed, points });
        }
        for branch in modes.branches() {
            let Some(first) = branch.first() else { continue };
            let is_backward = first.whirl.as_deref() == Some("backward");
            let stroke = if is_backward { Stroke::Dotted } else { Stroke::Solid };
            let points = branch.iter().map(|row| {
                let hz = if row.frequency_Hz <= top { row.frequency_Hz } else { f64::NAN };
                (self.speed(row.rotary_speed_rad_per_s), hz)
            });
            let ink = Ink::Line(family(&first.family));
            marks.push(Mark::Curve { ink, stroke, points: points.collect() });
        }
        for (place, name) in FAMILIES.iter().enumerate() {
            let critical =
                modes.summary.critical_speeds.iter().filter(|critical| critical.family == *name);
            let points = critical.filter(|critical| critical.frequency_Hz <= top).map(|critical| {
                (self.speed(critical.rotary_speed_rad_per_s), critical.frequency_Hz)
            });
            let points: Vec<(f64, f64)> = points.collect();
            marks.push(Mark::Points { ink: Ink::Line(place), shape: Shape::of(0), points });
        }
        marks.push(Mark::SharedRule {
            at: self.speed(modes.summary.rotary_speed_rad_per_s),
            label: modes.summary.operation.words().to_owned(),
        });
        let mut keys: Vec<Key> = FAMILIES
            .iter()
            .enumerate()
            .map(|(place, name)| Key {
                name: (*name).to_owned(),
                sample: Sample::Line(Ink::Line(place), Stroke::Solid),
            })
            .collect();
        keys.push(Key {
            name: "backward whirl".into(),
            sample: Sample::Line(Ink::Line(0), Stroke::Dotted),
        });
        keys.push(Key {
            name: "critical speed".into(),
            sample: Sample::Point(Ink::Line(0), Shape::of(0)),
        });
        let axis = Axis::new("Natural frequency, Hz", Range::Fixed(0.0, top));
        let shared = self.speed_axis(Range::Fixed(0.0, self.speed(fastest)));
        let layout = Layout::across(1, 180.0, 110.0);
        self.figure(shared, layout, vec![Panel::new(axis, marks)], keys)
    }

    /// Displacement of the shape from the hole's middle line in two directions.
    fn lateral_panel(&self, shape: &[ModeShapeRow]) -> Panel {
        let hertz = self.frequency_Hz(shape);
        let curve = |value: fn(&ModeShapeRow) -> f64, place: usize, stroke: Stroke| Mark::Curve {
            ink: Ink::Line(place),
            stroke,
            points: self.along(shape, value),
        };
        let number = shape.first().map_or(0, |row| row.number);
        let title = format!("{number}: {hertz:.3} Hz");
        Panel::new(
            Axis::new(title, Range::Fixed(-1.1, 1.1)),
            vec![
                curve(|row| row.high_later_m, 0, Stroke::Dotted),
                curve(|row| row.right_later_m, 1, Stroke::Dotted),
                curve(|row| row.high_m, 0, Stroke::Solid),
                curve(|row| row.right_m, 1, Stroke::Solid),
            ],
        )
    }

    fn along(&self, shape: &[ModeShapeRow], value: fn(&ModeShapeRow) -> f64) -> Vec<(f64, f64)> {
        shape.iter().map(|row| (self.display.value(row.md_m, "length"), value(row))).collect()
    }

    fn frequency_Hz(&self, shape: &[ModeShapeRow]) -> f64 {
        let same = |row: &&ModeFound| {
            shape.first().is_some_and(|own| row.family == own.family && row.number == own.number)
        };
        self.modes.summary.modes.iter().find(same).map_or(f64::NAN, |row| row.frequency_Hz)
    }

    fn shapes<'b>(&'b self, family: &'b str) -> impl Iterator<Item = &'b [ModeShapeRow]> {
        let is_its =
            move |shape: &&[ModeShapeRow]| shape.first().is_some_and(|row| row.family == family);
        self.modes.shapes().filter(is_its)
    }

    fn depth(&self) -> Axis {
        Axis {
            down: true,
            ..Axis::new(self.display.label("Measured depth", "length"), Range::Tight)
        }
    }

    fn lateral_shapes(&self) -> Figure {
        let lateral = self.shapes("lateral").take(DRAWN);
        let panels: Vec<Panel> = lateral.map(|lateral| self.lateral_panel(lateral)).collect();
        let key = |name: &str, place: usize, stroke: Stroke| Key {
            name: name.to_owned(),
            sample: Sample::Line(Ink::Line(place), stroke),
        };
        let keys = vec![
            key("towards the high side", 0, Stroke::Solid),
            key("to the right of it", 1, Stroke::Solid),
            key("a quarter of a period later", 0, Stroke::Dotted),
        ];
        let layout = Layout {
            direction: Direction::Down,
            columns: panels.len().max(1),
            width_mm: 200.0,
            panel_mm: 150.0,
        };
        self.figure(self.depth(), layout, panels, keys)
    }

    fn string_shapes(&self) -> Figure {
        let mut panels = Vec::new();
        for name in ["axial", "torsional"] {
            let place = family(name);
            let shapes: Vec<&[ModeShapeRow]> = self.shapes(name).take(DRAWN_OTHERS).collect();
            let mut marks = Vec::new();
            for (number, shape) in shapes.iter().enumerate() {
                let value = match place {
                    1 => |row: &ModeShapeRow| row.along_m,
                    _ => |row: &ModeShapeRow| row.turn_rad,
                };
                let (ink, stroke) = (Ink::Line(number), Stroke::of(number));
                marks.push(Mark::Curve { ink, stroke, points: self.along(shape, value) });
            }
            let hertz = shapes.iter().map(|shape| format!("{:.3}", self.frequency_Hz(shape)));
            let title = format!("{name}: {} Hz", hertz.collect::<Vec<_>>().join(" / "));
            panels.push(Panel::new(Axis::new(title, Range::Fixed(-1.1, 1.1)), marks));
        }
        let layout = Layout {
            direction: Direction::Down,
            columns: panels.len(),
            width_mm: 150.0,
            panel_mm: 130.0,
        };
        let key = |number: usize| Key {
            name: format!("mode {}", number + 1),
            sample: Sample::Line(Ink::Line(number), Stroke::of(number)),
        };
        self.figure(self.depth(), layout, panels, (0..DRAWN_OTHERS).map(key).collect())
    }

    fn response(&self) -> Figure {
        let response = &self.modes.rows.response;
        let panel = |name: &str, dimension: &str, value: fn(&ResponseRow) -> f64| {
            let point = |row: &ResponseRow| {
                let speed = self.speed(row.rotary_speed_rad_per_s);
                (speed, self.display.value(value(row), dimension))
            };
            let points = response.iter().map(point).collect();
            let axis = Axis {
                scale: Scale::Logarithmic,
                ..Axis::new(self.display.label(name, dimension), Range::Tight)
            };
            let curve = Mark::Curve { ink: Ink::Line(0), stroke: Stroke::Solid, points };
            let at = Mark::SharedRule {
                at: self.speed(self.modes.summary.rotary_speed_rad_per_s),
                label: self.modes.summary.operation.words().to_owned(),
            };
            Panel::new(axis, vec![curve, at])
        };
        let panels = vec![
            panel("Largest amplitude", "diameter", |row| row.amplitude_m),
            panel("Largest bending stress", "stress", |row| row.bending_stress_Pa),
        ];
        let mut figure = self.figure(
            self.speed_axis(Range::Tight),
            Layout::across(2, 180.0, 70.0),
            panels,
            Vec::new(),
        );
        figure.subtitle = format!("Response to {}", self.modes.forcing(self.display.unit_set()));
        figure
    }
}
