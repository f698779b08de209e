//! Quantities against measured depth, side by side, depth down the page.

use plotters::style::text_anchor::HPos;

use crate::{
    axis::Axis,
    canvas::{Canvas, Drawn, LETTER, fitting, sheet},
    colours,
    legend::Legend,
    line::thinned,
};

/// A picture of profiles: panels side by side over one depth axis that points down.
///
/// Everything is in the reader's units already; labels name them.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    /// Title, such as the case's name.
    pub title: String,
    /// What stands under it, such as friction and mud; may be empty.
    pub subtitle: String,
    /// Label of the depth axis, unit included.
    pub depth_label: String,
    /// What the colours and strokes of the curves mean.
    pub legend: Vec<Entry>,
    /// The panels, from left to right.
    pub panels: Vec<Panel>,
    /// The hole beside them, from the surface down.
    pub hole: Vec<Interval>,
}

/// One quantity against depth.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// Label of the axis, unit included.
    pub label: String,
    /// What lies on either side of zero, left and right, where the sign means a side.
    pub sides: Option<[String; 2]>,
    /// The curves.
    pub curves: Vec<Curve>,
}

/// An entry of the legend.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Entry {
    /// What it says.
    pub name: String,
    /// Colour that it is about; `None` where it is about the stroke alone.
    pub colour: Option<usize>,
    /// Stroke that it is about.
    pub stroke: Stroke,
}

/// One curve of a panel.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Index of its colour; seven can be told apart.
    pub colour: usize,
    /// How it is drawn.
    pub stroke: Stroke,
    /// Depth and value; the curve breaks where one is not finite.
    pub points: Vec<(f64, f64)>,
}

/// How a curve is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stroke {
    /// A full line.
    Solid,
    /// A dashed line, drawn over the full ones.
    Dashed,
}

/// A stretch of hole.
#[derive(Debug, Clone, PartialEq)]
pub struct Interval {
    /// Depth where it begins.
    pub from: f64,
    /// Depth where it ends.
    pub to: f64,
    /// Casing or rock.
    pub kind: IntervalKind,
    /// What it is: `casing 9-5/8 in`.
    pub label: String,
}

/// What the wall of a stretch of hole is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum IntervalKind {
    /// Casing, with a shoe at its lower end.
    Casing,
    /// Rock.
    Open,
}

const WIDTH: f64 = 960.0;
const PANELS: f64 = 760.0;
const LEFT: f64 = 76.0;
const RIGHT: f64 = 62.0;
const GAP: f64 = 22.0;
const BOTTOM: f64 = 28.0;
/// The picture as the text of an SVG file.
pub fn profile_svg(profile: &Profile) -> String {
    let legend = Legend::of(&profile.legend, WIDTH - LEFT);
    let top = 120.0 + legend.height();
    let height = top + PANELS + BOTTOM;
    sheet(WIDTH, height, |canvas| draw(canvas, profile, &legend, top))
}

fn draw(canvas: &Canvas, profile: &Profile, legend: &Legend, top: f64) -> Drawn {
    let room = WIDTH - LEFT - RIGHT;
    let title = fitting(&profile.title, 19.0, room);
    canvas.text(&title, LEFT, 34.0, 19.0, colours::TEXT, HPos::Left)?;
    let subtitle = fitting(&profile.subtitle, 12.5, room);
    canvas.text(&subtitle, LEFT, 56.0, 12.5, colours::NOTE, HPos::Left)?;
    legend.draw(canvas, LEFT, 80.0)?;

    let hole = profile
        .hole
        .iter()
        .flat_map(|interval| [interval.from, interval.to]);
    let curves = profile.panels.iter().flat_map(|panel| &panel.curves);
    let points = curves.flat_map(|curve| curve.points.iter().map(|point| point.0));
    let depth = Axis::depth(hole.chain(points), 10);

    let count = profile.panels.len().max(1) as f64;
    let width = (WIDTH - LEFT - RIGHT - GAP * (count - 1.0)) / count;
    let frame = |index: usize| Frame {
        left: LEFT + index as f64 * (width + GAP),
        top,
        width,
        height: PANELS,
    };
    for (index, panel) in profile.panels.iter().enumerate() {
        draw_panel(canvas, panel, &depth, frame(index), &profile.hole)?;
    }
    draw_depth_axis(canvas, &profile.depth_label, &depth, top)?;
    draw_hole(canvas, &profile.hole, &depth, top)
}

/// The place of a panel on the page.
#[derive(Debug, Clone, Copy)]
struct Frame {
    left: f64,
    top: f64,
    width: f64,
    height: f64,
}

fn draw_panel(
    canvas: &Canvas,
    panel: &Panel,
    depth: &Axis,
    frame: Frame,
    hole: &[Interval],
) -> Drawn {
    let Frame {
        left,
        top,
        width,
        height,
    } = frame;
    let (right, bottom) = (left + width, top + height);
    let values = panel
        .curves
        .iter()
        .flat_map(|curve| curve.points.iter().map(|point| point.1));
    let axis = Axis::around(values, panel.sides.is_some(), 5);
    let x = |value: f64| left + width * axis.place(value);
    let y = |value: f64| top + height * depth.place(value);

    for tick in axis.ticks() {
        let at_zero = tick.abs() < 1e-12;
        let colour = if at_zero {
            colours::CASING
        } else {
            colours::GRID
        };
        canvas.line(&[(x(tick), top), (x(tick), bottom)], colour, 0.8)?;
        canvas.text(
            &axis.label(tick),
            x(tick),
            top - 11.0,
            11.5,
            colours::TEXT,
            HPos::Center,
        )?;
    }
    for tick in depth.ticks() {
        canvas.line(&[(left, y(tick)), (right, y(tick))], colours::GRID, 0.8)?;
    }
    for shoe in hole
        .iter()
        .filter(|interval| interval.kind == IntervalKind::Casing)
    {
        let y = y(shoe.to);
        canvas.dashed(&[(left, y), (right, y)], colours::NOTE, 0.9, 2.0)?;
    }
    let middle = left + width / 2.0;
    canvas.text(
        &panel.label,
        middle,
        top - 32.0,
        13.0,
        colours::TEXT,
        HPos::Center,
    )?;
    if let Some([low, high]) = &panel.sides {
        let y = bottom + 12.0;
        canvas.text(low, left, y, 11.0, colours::NOTE, HPos::Left)?;
        canvas.text(high, right, y, 11.0, colours::NOTE, HPos::Right)?;
    }
    for stroke in [Stroke::Solid, Stroke::Dashed] {
        for curve in panel.curves.iter().filter(|curve| curve.stroke == stroke) {
            for piece in curve
                .points
                .split(|(depth, value)| !(depth + value).is_finite())
            {
                let piece: Vec<_> = piece.iter().map(|point| (x(point.1), y(point.0))).collect();
                canvas.curve(&thinned(&piece), colours::line(curve.colour), stroke)?;
            }
        }
    }
    let corners = [
        (left, top),
        (right, top),
        (right, bottom),
        (left, bottom),
        (left, top),
    ];
    canvas.line(&corners, colours::FRAME, 1.0)
}

fn draw_depth_axis(canvas: &Canvas, label: &str, depth: &Axis, top: f64) -> Drawn {
    for tick in depth.ticks() {
        let y = top + PANELS * depth.place(tick);
        canvas.text(
            &depth.label(tick),
            LEFT - 7.0,
            y,
            11.5,
            colours::TEXT,
            HPos::Right,
        )?;
    }
    canvas.upright(label, LEFT - 52.0, top + PANELS / 2.0, 13.0, colours::TEXT)
}

/// A strip beside the panels with casing and rock, and a triangle at each casing shoe.
fn draw_hole(canvas: &Canvas, hole: &[Interval], depth: &Axis, top: f64) -> Drawn {
    let left = WIDTH - RIGHT + 12.0;
    let right = left + 9.0;
    for interval in hole {
        let [from, to] = [interval.from, interval.to].map(|md| top + PANELS * depth.place(md));
        let colour = match interval.kind {
            IntervalKind::Casing => colours::CASING,
            IntervalKind::Open => colours::ROCK,
        };
        canvas.fill(
            &[(left, from), (right, from), (right, to), (left, to)],
            colour,
        )?;
        if interval.kind == IntervalKind::Casing {
            canvas.fill(
                &[(left, to - 9.0), (left, to), (left - 7.0, to)],
                colours::FRAME,
            )?;
        }
        if to - from > LETTER * 11.0 * interval.label.chars().count() as f64 {
            let middle = (from + to) / 2.0;
            canvas.upright(&interval.label, right + 12.0, middle, 11.0, colours::NOTE)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::canvas::FINE;

    fn profile() -> Profile {
        let curve = |colour, stroke| Curve {
            colour,
            stroke,
            points: (0..100)
                .map(|i| (f64::from(i) * 40.0, f64::from(i) - 20.0))
                .collect(),
        };
        let panel = |label: &str| Panel {
            label: label.into(),
            sides: Some(["low side".into(), "high side".into()]),
            curves: vec![curve(0, Stroke::Dashed), curve(1, Stroke::Solid)],
        };
        Profile {
            title: "A <well> & its \"string\"".into(),
            subtitle: "friction 0.3 ".repeat(40),
            depth_label: "Measured depth, ft".into(),
            legend: [
                "trip out",
                "trip in",
                "rotate off bottom",
                "drill",
                "slide",
                "back-ream",
            ]
            .iter()
            .enumerate()
            .map(|(index, name)| Entry {
                name: (*name).into(),
                colour: (index > 0).then_some(index),
                stroke: Stroke::Solid,
            })
            .collect(),
            panels: [
                "Effective tension, klbf",
                "Torque, ft-lbf",
                "Side force, lbf/ft",
            ]
            .map(panel)
            .to_vec(),
            hole: vec![
                Interval {
                    from: 0.0,
                    to: 3000.0,
                    kind: IntervalKind::Casing,
                    label: "casing".into(),
                },
                Interval {
                    from: 3000.0,
                    to: 3900.0,
                    kind: IntervalKind::Open,
                    label: "open hole".into(),
                },
            ],
        }
    }

    /// Left, top, right, bottom of every text that is not turned, with its own.
    fn boxes(svg: &str) -> Vec<([f64; 4], String)> {
        let mut boxes = Vec::new();
        for element in svg.split("<text ").skip(1) {
            let (tag, rest) = element.split_once('>').unwrap();
            let value = |key: &str| {
                let (_, after) = tag.split_once(&format!("{key}=\""))?;
                Some(after.split_once('"')?.0)
            };
            if value("transform").is_some() {
                continue;
            }
            let number = |key| value(key).unwrap().parse::<f64>().unwrap();
            let text = rest.split_once("</text>").unwrap().0.trim().to_owned();
            let size = number(" font-size");
            let width = 0.6 * size * text.chars().count() as f64;
            let left = match value("text-anchor") {
                Some("middle") => number("x") - width / 2.0,
                Some("end") => number("x") - width,
                _ => number("x"),
            };
            let y = number(" y");
            boxes.push(([left, y - size / 2.0, left + width, y + size / 2.0], text));
        }
        boxes
    }

    #[test]
    fn no_text_overlaps_another_or_leaves_the_page() {
        let svg = profile_svg(&profile());
        let boxes = boxes(&svg);
        assert!(boxes.len() > 30, "{}", boxes.len());
        for (index, (a, text)) in boxes.iter().enumerate() {
            assert!(
                a[0] >= 0.0 && a[2] <= WIDTH * FINE,
                "{text} leaves the page"
            );
            for (b, other) in &boxes[..index] {
                let apart = a[0] >= b[2] || b[0] >= a[2] || a[1] >= b[3] || b[1] >= a[3];
                assert!(apart, "`{text}` overlaps `{other}`");
            }
        }
    }

    #[test]
    fn names_are_escaped() {
        let svg = profile_svg(&profile());
        assert!(svg.contains("A &lt;well&gt; &amp; its"), "{svg:.600}");
    }

    #[test]
    fn empty_and_broken_curves_are_drawn() {
        let mut broken = profile();
        broken.panels[0].curves[0].points.clear();
        broken.panels[0].curves[1].points[50].1 = f64::NAN;
        let before = profile_svg(&broken).matches("<polyline").count();
        broken.panels[0].curves[1].points[50].1 = 3.0;
        // Without the gap the two pieces are one.
        assert_eq!(
            profile_svg(&broken).matches("<polyline").count() + 1,
            before
        );
        broken.panels.clear();
        broken.hole.clear();
        assert!(profile_svg(&broken).ends_with("</svg>\n"));
    }
}
