//! The assembly in its hole, from the side and from above, drawn with lateral exaggeration.

use wholestring::statics::assembly::Contact;
use wholestring_results::BhaPart;
use wholestring_units::significant;

use super::{
    Bha,
    curves::{self, conditions, shown_to_m, three},
    nodes::Varied,
    views,
};
use crate::{
    Plot,
    figure::{Axis, Figure, Ink, Key, Layout, Mark, Panel, Range, Sample, Shape, Stroke},
    plots::DisplayUnits,
};

/// Size of the figure and of a panel, mm.
const WIDTH_MM: f64 = 180.0;
const PANEL_MM: f64 = 46.0;

/// Width of the frames, mm: that of the figure without margins, label and ticks.
const FRAME_MM: f64 = 160.0;

/// Half the height of a panel over the radius of the hole.
const AROUND: f64 = 1.35;

/// Part of a contact force from which it is marked in a plane.
const SEEN: f64 = 0.1;

/// Largest number of forces written into a view.
const NAMED: usize = 8;

const WALL: Ink = Ink::Rock;
const BODY: Ink = Ink::Line(0);
const BLADES: Ink = Ink::Line(1);
const TOUCH: Ink = Ink::Line(3);

/// Lateral exaggeration of the two views.
fn exaggeration(bha: &Bha) -> f64 {
    let radius_m = largest_radius_m(bha);
    (PANEL_MM / (2.0 * AROUND * radius_m)) / (FRAME_MM / shown_to_m(bha).max(1e-3))
}

fn largest_radius_m(bha: &Bha) -> f64 {
    let to_m = shown_to_m(bha);
    let nodes = bha.nodes.from_bit_m.iter().zip(&bha.nodes.hole_radius_m);
    nodes.filter(|(at, _)| **at <= to_m).map(|(_, radius)| *radius).fold(1e-3, f64::max)
}

pub(super) fn figure(bha: &Bha, display: DisplayUnits<'_>) -> Figure {
    let times = exaggeration(bha);
    let times = significant(times, 2);
    let to_m = shown_to_m(bha);
    let bend = bha.summary.parts.iter().find_map(|part| part.bend_m);
    let marked = |ink| Sample::Point(ink, Shape::Tip);
    let mut keys = vec![
        Key { name: "wall".into(), sample: Sample::Area(WALL) },
        Key { name: "bit and bodies".into(), sample: Sample::Area(BODY) },
    ];
    if bha.summary.parts.iter().any(|part| part.blades_m.is_some()) {
        keys.push(Key { name: "blades".into(), sample: Sample::Area(BLADES) });
    }
    let axis = Key { name: "axis of the string".into(), sample: Sample::Line(BODY, Stroke::Solid) };
    keys.push(axis);
    keys.push(Key { name: "contact force".into(), sample: marked(TOUCH) });
    if bend.is_some_and(|at| at <= to_m) {
        let sample = Sample::Point(Ink::Text, Shape::Diamond);
        keys.push(Key { name: "bend".into(), sample });
    }
    // On a page the key replaces the title.
    let name = format!("drawn {times} times as wide as long");
    keys.push(Key { name, sample: Sample::Words });
    let panels = vec![
        panel(bha, 0, "From the side, high side up", display),
        panel(bha, 1, "From above, right side up", display),
    ];
    let mut shared = Axis::new(
        display.label("Distance from the bit", "length"),
        Range::Fixed(-0.01 * display.value(to_m, "length"), display.value(to_m, "length")),
    );
    shared.min_span = 0.0;
    Figure {
        title: bha.head.title.clone(),
        subtitle: conditions(bha, display),
        keys,
        layout: Layout::across(1, WIDTH_MM, PANEL_MM),
        shared,
        panels,
        hole: Vec::new(),
    }
}

/// A picture in one plane.
struct View<'a> {
    bha: &'a Bha,
    /// 0 towards the high side, 1 to the right.
    side: usize,
    display: DisplayUnits<'a>,
}

fn panel(bha: &Bha, side: usize, title: &str, display: DisplayUnits<'_>) -> Panel {
    let view = View { bha, side, display };
    let half = view.wide(AROUND * largest_radius_m(bha));
    let mut axis = Axis::new(display.label(title, "diameter"), Range::Fixed(-half, half));
    axis.min_span = 2.0 * half;
    let mut marks = view.walls(half);
    marks.extend(view.string());
    marks.extend(view.touches());
    for at_m in bha.sensors_m() {
        let label = if side == 0 { "survey sensor" } else { "" };
        marks.push(Mark::SharedRule { at: view.long(at_m), label: label.into() });
    }
    Panel::new(axis, marks)
}

impl View<'_> {
    fn long(&self, metres: f64) -> f64 {
        self.display.value(metres, "length")
    }

    fn wide(&self, metres: f64) -> f64 {
        self.display.value(metres, "diameter")
    }

    /// A quantity of the nodes at a distance from the bit.
    fn at(&self, values: &[f64], from_bit_m: f64) -> f64 {
        let at = &self.bha.nodes.from_bit_m;
        let above = at.partition_point(|node| *node < from_bit_m).min(at.len().saturating_sub(1));
        let below = above.saturating_sub(1);
        let above = below + 1;
        let (Some(low), Some(high), Some(from), Some(to)) =
            (at.get(below), at.get(above), values.get(below), values.get(above))
        else {
            return values.first().copied().unwrap_or(f64::NAN);
        };
        let part = ((from_bit_m - low) / (high - low)).clamp(0.0, 1.0);
        from + part * (to - from)
    }

    fn offset_m(&self, from_bit_m: f64) -> f64 {
        self.at(&self.bha.nodes.offset_m[self.side], from_bit_m)
    }

    /// Rock on either side of the hole, and the wall as two lines.
    fn walls(&self, half: f64) -> Vec<Mark> {
        let to_m = shown_to_m(self.bha);
        let nodes = self.bha.nodes.from_bit_m.iter().zip(&self.bha.nodes.hole_radius_m);
        let mut nodes: Vec<(f64, f64)> = nodes
            .filter(|(at, _)| **at <= to_m)
            .map(|(at, radius)| (self.long(*at), self.wide(*radius)))
            .collect();
        let last_m = self.at(&self.bha.nodes.hole_radius_m, to_m);
        nodes.push((self.long(to_m), self.wide(last_m)));
        let mut marks = Vec::new();
        for sign in [1.0, -1.0] {
            let points = nodes.iter().map(|(at, radius)| (*at, sign * radius, sign * half));
            // Drawn twice, so that it hides more of the marks below it.
            let rock = Mark::Band { ink: WALL, points: points.collect() };
            marks.extend([rock.clone(), rock]);
        }
        for sign in [1.0, -1.0] {
            let points = nodes.iter().map(|(at, radius)| (*at, sign * radius));
            let points = points.collect();
            marks.push(Mark::Curve { ink: Ink::Text, stroke: Stroke::Solid, points });
        }
        let bottom = nodes.first().map_or(0.0, |first| first.1);
        let points = vec![(0.0, -bottom), (0.0, bottom)];
        marks.push(Mark::Curve { ink: Ink::Text, stroke: Stroke::Solid, points });
        marks
    }

    /// A stretch of the string with a diameter.
    fn body(&self, [from_m, to_m]: [f64; 2], od_m: f64, ink: Ink) -> Vec<Mark> {
        let to_m = to_m.min(shown_to_m(self.bha));
        if to_m <= from_m {
            return Vec::new();
        }
        let inner = self.bha.nodes.from_bit_m.iter().copied();
        let inner = inner.filter(|at| (from_m..to_m).contains(at) && *at > from_m);
        let places = std::iter::once(from_m).chain(inner).chain([to_m]);
        let edges: Vec<(f64, f64, f64)> = places
            .map(|at| {
                let middle = self.offset_m(at);
                let [low, high] = [middle - 0.5 * od_m, middle + 0.5 * od_m];
                (self.long(at), self.wide(low), self.wide(high))
            })
            .collect();
        let mut marks = vec![Mark::Band { ink, points: edges.clone() }];
        for side in [|e: &(f64, f64, f64)| e.1, |e: &(f64, f64, f64)| e.2] {
            let points = edges.iter().map(|edge| (edge.0, side(edge))).collect();
            marks.push(Mark::Curve { ink, stroke: Stroke::Solid, points });
        }
        for edge in edges.first().into_iter().chain(edges.last()) {
            let points = vec![(edge.0, edge.1), (edge.0, edge.2)];
            marks.push(Mark::Curve { ink, stroke: Stroke::Solid, points });
        }
        marks
    }

    fn string(&self) -> Vec<Mark> {
        let mut marks = Vec::new();
        for part in &self.bha.summary.parts {
            marks.extend(self.body([part.from_bit_m, part.to_bit_m], part.od_m, BODY));
        }
        for part in &self.bha.summary.parts {
            marks.extend(self.blades(part));
        }
        let to_m = shown_to_m(self.bha);
        let nodes = self.bha.nodes.from_bit_m.iter().zip(&self.bha.nodes.offset_m[self.side]);
        let mut points: Vec<(f64, f64)> = nodes
            .filter(|(at, _)| **at <= to_m)
            .map(|(at, offset)| (self.long(*at), self.wide(*offset)))
            .collect();
        points.push((self.long(to_m), self.wide(self.offset_m(to_m))));
        marks.push(Mark::Curve { ink: BODY, stroke: Stroke::Solid, points });
        let bends = self.bha.summary.parts.iter().filter_map(|part| part.bend_m);
        let points: Vec<(f64, f64)> = bends
            .filter(|at| *at <= to_m)
            .map(|at| (self.long(at), self.wide(self.offset_m(at))))
            .collect();
        if !points.is_empty() {
            marks.push(Mark::Points { ink: Ink::Text, shape: Shape::Diamond, points });
        }
        marks
    }

    fn blades(&self, part: &BhaPart) -> Vec<Mark> {
        let Some([od_m, length_m]) = part.blades_m else {
            return Vec::new();
        };
        let middle_m = 0.5 * (part.from_bit_m + part.to_bit_m);
        self.body([middle_m - 0.5 * length_m, middle_m + 0.5 * length_m], od_m, BLADES)
    }

    /// Contacts on the side of the wall that they press in this plane, the largest with their
    /// forces.
    fn touches(&self) -> Vec<Mark> {
        let to_m = shown_to_m(self.bha);
        let seen = self.bha.summary.state.contacts.iter().filter(|contact| {
            let size_N = contact.force_N[0].hypot(contact.force_N[1]);
            middle_m(contact) <= to_m
                && size_N > 0.0
                && contact.force_N[self.side].abs() >= SEEN * size_N
        });
        let mut seen: Vec<_> = seen.collect();
        seen.sort_by(|a, b| b.force_N[self.side].abs().total_cmp(&a.force_N[self.side].abs()));
        let place = |contact: &&Contact| {
            let at_m = middle_m(contact);
            let radius_m = self.at(&self.bha.nodes.hole_radius_m, at_m);
            (self.long(at_m), self.wide(radius_m) * contact.force_N[self.side].signum())
        };
        let mut marks = Vec::new();
        for (shape, up) in [(Shape::Triangle, true), (Shape::Tip, false)] {
            let pressing = seen.iter().filter(|contact| (contact.force_N[self.side] > 0.0) == up);
            let points: Vec<(f64, f64)> = pressing.map(place).collect();
            if !points.is_empty() {
                marks.push(Mark::Points { ink: TOUCH, shape, points });
            }
        }
        for contact in seen.iter().take(NAMED) {
            let force_N = contact.force_N[self.side].abs();
            let text = three(self.display, force_N, "force");
            marks.push(Mark::Name { at: place(contact), text });
        }
        marks
    }
}

/// Distance of the middle of a contact from the bit, m.
fn middle_m(contact: &Contact) -> f64 {
    0.5 * (contact.from_bit_m[0] + contact.from_bit_m[1])
}

// All pictures of a static BHA analysis.

/// Returns every picture of an assembly, in a set of units (`si`, `metric` or `field`): `views`
/// (from the side and from above), `bending` (moment and stress), and a picture of each varied
/// quantity (`toolface`, `weight`, `inclination`); none where nothing was solved.
pub fn bha_plots(bha: &Bha, units: &str) -> Vec<Plot> {
    let display = DisplayUnits::new(&bha.head.dimensions, units);
    if bha.nodes.from_bit_m.len() < 2 {
        return Vec::new();
    }
    let plot = |name: &str, figure| Plot { name: name.into(), figure };
    let mut plots = vec![
        plot("views", views::figure(bha, display)),
        plot("bending", curves::bending_figure(bha, display)),
    ];
    let picture =
        |varied: Varied<'_>| plot(varied.name, curves::sweeps_figure(bha, &varied, display));
    plots.extend(bha.varied().map(picture));
    plots
}
