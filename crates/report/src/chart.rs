//! Curves over one pair of axes.

use plotters::style::text_anchor::HPos;

use crate::{
    axis::Axis,
    canvas::{Canvas, Drawn, fitting, sheet},
    colours,
    legend::Legend,
    line::thinned,
    profile::{Curve, Entry, Stroke},
};

/// A picture of curves: one quantity against another.
///
/// Everything is in the reader's units already; labels name them.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    /// Title.
    pub title: String,
    /// What stands under it; may be empty.
    pub subtitle: String,
    /// The axis at the bottom.
    pub x: Scale,
    /// The axis at the left.
    pub y: Scale,
    /// What the colours and strokes of the curves mean.
    pub legend: Vec<Entry>,
    /// The curves; their points are `(x, y)`.
    pub curves: Vec<Curve>,
    /// Values of `y` to hold the curves against.
    pub levels: Vec<Level>,
}

/// An axis.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Scale {
    /// Label, unit included.
    pub label: String,
    /// Whether it is a depth or a time, of which the axis shows exactly what the curves span; any other holds zero.
    /// A depth at the left points down.
    pub exact: bool,
}

/// A line across the picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    /// What it is: `rated torque`.
    pub label: String,
    /// Where it lies.
    pub value: f64,
}

const WIDTH: f64 = 760.0;
const HEIGHT: f64 = 380.0;
const LEFT: f64 = 78.0;
const RIGHT: f64 = 26.0;
const BOTTOM: f64 = 58.0;

/// Curves of more points than this are lines without dots.
const MOST_DOTS: usize = 60;

/// The picture as the text of an SVG file.
pub fn chart_svg(chart: &Chart) -> String {
    let legend = Legend::of(&chart.legend, WIDTH - LEFT - RIGHT);
    let top = if chart.subtitle.is_empty() {
        70.0
    } else {
        90.0
    } + legend.height();
    sheet(WIDTH, top + HEIGHT + BOTTOM, |canvas| {
        draw(canvas, chart, &legend, top)
    })
}

fn draw(canvas: &Canvas, chart: &Chart, legend: &Legend, top: f64) -> Drawn {
    let room = WIDTH - LEFT - RIGHT;
    let (right, bottom) = (WIDTH - RIGHT, top + HEIGHT);
    let title = fitting(&chart.title, 17.0, room);
    canvas.text(&title, LEFT, 30.0, 17.0, colours::TEXT, HPos::Left)?;
    let subtitle = fitting(&chart.subtitle, 12.5, room);
    canvas.text(&subtitle, LEFT, 50.0, 12.5, colours::NOTE, HPos::Left)?;
    legend.draw(canvas, LEFT, top - 16.0 - legend.height())?;

    let points = || chart.curves.iter().flat_map(|curve| &curve.points);
    let sound = |x: f64, y: f64| if (x + y).is_finite() { x } else { f64::NAN };
    let xs = points().map(|(x, y)| sound(*x, *y));
    let levels = chart.levels.iter().map(|level| level.value);
    let ys = points().map(|(x, y)| sound(*y, *x)).chain(levels);
    let axis = |scale: &Scale, values: Vec<f64>, ticks| {
        if scale.exact {
            Axis::depth(values, ticks)
        } else {
            Axis::around(values, false, ticks)
        }
    };
    let x_axis = axis(&chart.x, xs.collect(), 8);
    let y_axis = axis(&chart.y, ys.collect(), 6);
    let x = |value: f64| LEFT + room * x_axis.place(value);
    let y = |value: f64| match chart.y.exact {
        true => top + HEIGHT * y_axis.place(value),
        false => bottom - HEIGHT * y_axis.place(value),
    };
    let grid = |tick: f64| match tick.abs() < 1e-12 {
        true => colours::CASING,
        false => colours::GRID,
    };
    for tick in x_axis.ticks() {
        let (at, label) = (x(tick), x_axis.label(tick));
        canvas.line(&[(at, top), (at, bottom)], grid(tick), 0.8)?;
        canvas.text(&label, at, bottom + 14.0, 11.5, colours::TEXT, HPos::Center)?;
    }
    for tick in y_axis.ticks() {
        let (at, label) = (y(tick), y_axis.label(tick));
        canvas.line(&[(LEFT, at), (right, at)], grid(tick), 0.8)?;
        canvas.text(&label, LEFT - 7.0, at, 11.5, colours::TEXT, HPos::Right)?;
    }
    let middle = LEFT + room / 2.0;
    let under = bottom + 38.0;
    canvas.text(
        &chart.x.label,
        middle,
        under,
        13.0,
        colours::TEXT,
        HPos::Center,
    )?;
    canvas.upright(
        &chart.y.label,
        LEFT - 56.0,
        top + HEIGHT / 2.0,
        13.0,
        colours::TEXT,
    )?;

    for level in &chart.levels {
        let at = y(level.value);
        canvas.dashed(&[(LEFT, at), (right, at)], colours::NOTE, 1.2, 3.0)?;
        let label = fitting(&level.label, 11.5, room);
        canvas.text(
            &label,
            right - 4.0,
            at - 9.0,
            11.5,
            colours::NOTE,
            HPos::Right,
        )?;
    }
    for stroke in [Stroke::Solid, Stroke::Dashed] {
        for curve in chart.curves.iter().filter(|curve| curve.stroke == stroke) {
            let colour = colours::line(curve.colour);
            for piece in curve.points.split(|(x, y)| !(x + y).is_finite()) {
                let piece: Vec<_> = piece.iter().map(|point| (x(point.0), y(point.1))).collect();
                canvas.curve(&thinned(&piece), colour, stroke)?;
                if curve.points.len() <= MOST_DOTS {
                    canvas.dots(&piece, colour, 2.2)?;
                }
            }
        }
    }
    let corners = [
        (LEFT, top),
        (right, top),
        (right, bottom),
        (LEFT, bottom),
        (LEFT, top),
    ];
    canvas.line(&corners, colours::FRAME, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chart() -> Chart {
        let scale = |label: &str, exact| Scale {
            label: label.into(),
            exact,
        };
        Chart {
            title: "Torque <of> \"friction\" & more".into(),
            subtitle: String::new(),
            x: scale("Bit depth, m", true),
            y: scale("Torque, kN·m", false),
            legend: Vec::new(),
            curves: vec![Curve {
                colour: 0,
                stroke: Stroke::Solid,
                points: vec![(300.0, 1.0), (600.0, 2.0), (900.0, 3.0)],
            }],
            levels: vec![Level {
                label: "rated".into(),
                value: 12.0,
            }],
        }
    }

    /// The numbers of an attribute of every element of that name.
    fn values(svg: &str, element: &str, key: &str) -> Vec<f64> {
        let of = |text: &str| {
            let (_, rest) = text.split_once(&format!(" {key}=\""))?;
            rest.split_once('"')?.0.parse().ok()
        };
        svg.split(&format!("<{element}"))
            .skip(1)
            .filter_map(of)
            .collect()
    }

    #[test]
    fn dots_lie_where_their_values_are() {
        let svg = chart_svg(&chart());
        let (x, y) = (values(&svg, "circle", "cx"), values(&svg, "circle", "cy"));
        assert_eq!(x.len(), 3);
        // From edge to edge, evenly, and up.
        assert_eq!((x[0], x[2]), (LEFT * 10.0, (WIDTH - RIGHT) * 10.0));
        assert!((x[0] + x[2] - 2.0 * x[1]).abs() <= 1.0, "{x:?}");
        assert!((y[0] + y[2] - 2.0 * y[1]).abs() <= 1.0, "{y:?}");
        assert!(y[2] < y[0], "{y:?}");
        // There is room for the level: 3 of at least 12.
        assert!(y[2] - 700.0 > 0.7 * HEIGHT * 10.0, "{y:?}");
        assert!(svg.contains("&lt;of&gt;"));
    }

    #[test]
    fn depth_points_down_and_gaps_stay_open() {
        let mut down = chart();
        down.y.exact = true;
        down.levels.clear();
        down.curves[0].points[1].1 = f64::NAN;
        let svg = chart_svg(&down);
        let y = values(&svg, "circle", "cy");
        assert_eq!(y.len(), 2);
        assert!(y[1] > y[0], "{y:?}");
        down.curves.clear();
        assert!(chart_svg(&down).ends_with("</svg>\n"));
    }
}
