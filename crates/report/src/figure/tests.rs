//! Figures in their written form.

use super::{ruler::Ruler, *};

fn curve(ink: usize, stroke: Stroke) -> Mark {
    Mark::Curve {
        ink: Ink::Line(ink),
        stroke,
        points: (0..100).map(|i| (f64::from(i) * 40.0, f64::from(i) - 20.0)).collect(),
    }
}

fn figure(direction: Direction, columns: usize) -> Figure {
    let panel = |label: &str| Panel {
        axis: Axis {
            sides: Some(["low side".into(), "high side".into()]),
            ..Axis::new(label, Range::Zero)
        },
        marks: vec![curve(0, Stroke::Dashed), curve(1, Stroke::Solid)],
        keys: Vec::new(),
    };
    let key = |(index, name): (usize, &&str)| Key {
        name: (*name).into(),
        sample: Sample::Line(Ink::Line(index), Stroke::Solid),
    };
    let names = ["trip out", "trip in", "rotate off bottom", "drill", "slide", "back-ream"];
    let labels = [
        "Effective tension, klbf",
        "Torque, ft·lbf",
        "Side force, lbf/ft",
        "Wear work on the hole, ft·lbf/ft",
        "Dogleg severity, °/100 ft",
    ];
    let down = direction == Direction::Down;
    let interval = |from, to, cased, label: &str| Interval {
        from,
        to,
        cased,
        shoe: cased,
        label: label.into(),
    };
    Figure {
        title: "A <well> & its \"string\"".into(),
        subtitle: "friction 0.3 ".repeat(40),
        keys: names.iter().enumerate().map(key).collect(),
        layout: Layout { direction, columns, width_mm: 180.0, panel_mm: 100.0 },
        shared: Axis { down, ..Axis::new("Measured depth, ft", Range::Tight) },
        panels: labels.map(panel).to_vec(),
        hole: if down {
            vec![
                interval(0.0, 3000.0, true, "casing"),
                interval(3000.0, 3900.0, false, "open hole"),
            ]
        } else {
            Vec::new()
        },
    }
}

/// Names of adjacent lines down the page are one below the other, and none leaves the frame.
#[test]
fn names_of_near_lines_do_not_cover_each_other() {
    let names = ["top drive", "make-up", "pipe, torsion", "hoist"];
    let mut figure = figure(Direction::Down, 1);
    figure.panels.truncate(1);
    let rules = names.iter().zip([60.0, 61.0, 62.0, 79.0]);
    figure.panels[0]
        .marks
        .extend(rules.map(|(name, at)| Mark::OwnRule { at, label: (*name).into() }));
    let drawing = figure.drawing();
    let boxes = boxes(&drawing.svg());
    let own: Vec<_> = boxes.iter().filter(|text| names.contains(&text.1.as_str())).collect();
    assert_eq!(own.len(), names.len(), "{boxes:?}");
    for (place, (one, name)) in own.iter().enumerate() {
        assert!(one[2] <= drawing.size().0, "{name}: {one:?}");
        for (other, with) in &own[place + 1..] {
            let beside = one[2] <= other[0] || other[2] <= one[0];
            let apart = beside || one[3] <= other[1] || other[3] <= one[1];
            assert!(apart, "{name} {one:?}, {with} {other:?}");
        }
    }
}

/// Left, top, right, bottom of every text, with its own.
fn boxes(svg: &str) -> Vec<([f64; 4], String)> {
    let mut boxes = Vec::new();
    for element in svg.split("<text ").skip(1) {
        let (tag, rest) = element.split_once('>').unwrap();
        let value = |key: &str| {
            let (_, after) = tag.split_once(&format!("{key}=\""))?;
            Some(after.split_once('"')?.0)
        };
        let text = rest.split_once("</text>").unwrap().0.to_owned();
        if text.is_empty() {
            continue;
        }
        let number = |text: &str| text.parse::<f64>().unwrap();
        let size = number(value("font-size").unwrap());
        let width = crate::draw::text_width(&text, size);
        let rise = 0.72 * size;
        boxes.push(match value("transform") {
            Some(transform) => {
                let (_, place) = transform.split_once("translate(").unwrap();
                let (place, _) = place.split_once(')').unwrap();
                let (x, y) = place.split_once(' ').unwrap();
                let (x, y) = (number(x), number(y));
                ([x - rise, y - width / 2.0, x, y + width / 2.0], text)
            }
            None => {
                let (x, y) = (number(value("x").unwrap()), number(value(" y").unwrap()));
                let left = match value("text-anchor") {
                    Some("middle") => x - width / 2.0,
                    Some("end") => x - width,
                    _ => x,
                };
                ([left, y - rise, left + width, y], text)
            }
        });
    }
    boxes
}

#[test]
fn no_text_overlaps_another_or_leaves_the_page() {
    for (direction, columns) in
        [(Direction::Down, 5), (Direction::Down, 3), (Direction::Across, 1), (Direction::Across, 2)]
    {
        let drawing = figure(direction, columns).drawing();
        let boxes = boxes(&drawing.svg());
        assert!(boxes.len() > 30, "{}", boxes.len());
        let (width, height) = drawing.size();
        for (index, (a, text)) in boxes.iter().enumerate() {
            assert!(
                a[0] >= 0.0 && a[2] <= width && a[1] >= 0.0 && a[3] <= height,
                "{text} leaves the page"
            );
            for (b, other) in &boxes[..index] {
                let apart = a[0] >= b[2] || b[0] >= a[2] || a[1] >= b[3] || b[1] >= a[3];
                assert!(apart, "`{text}` overlaps `{other}`");
            }
        }
    }
}

#[test]
fn names_are_escaped() {
    let svg = figure(Direction::Down, 5).drawing().svg();
    assert!(svg.contains("A &lt;well&gt; &amp; its"), "{svg:.600}");
}

/// The ends of a line across a panel are at its frame, whichever way depth points.
#[test]
fn depth_points_down() {
    let svg = |down: bool| {
        let mut figure = figure(Direction::Across, 1);
        figure.panels.truncate(1);
        figure.panels[0].axis = Axis { down, ..Axis::new("Depth, m", Range::Fixed(0.0, 100.0)) };
        figure.drawing().svg()
    };
    let height_of = |svg: &str, tick: &str| {
        let text = boxes(svg).into_iter().find(|(_, text)| text == tick);
        text.expect("a tick").0[1]
    };
    assert!(height_of(&svg(true), "100") > height_of(&svg(true), "0"));
    assert!(height_of(&svg(false), "100") < height_of(&svg(false), "0"));
}

#[test]
fn empty_and_broken_curves_are_drawn() {
    let mut broken = figure(Direction::Down, 5);
    if let Mark::Curve { points, .. } = &mut broken.panels[0].marks[0] {
        points.clear();
    }
    let pieces = |figure: &Figure| {
        let svg = figure.drawing().svg();
        assert!(svg.ends_with("</svg>\n") && !svg.contains("NaN"));
        svg.matches('M').count()
    };
    let whole = pieces(&broken);
    if let Mark::Curve { points, .. } = &mut broken.panels[0].marks[1] {
        points[50].1 = f64::NAN;
    }
    // The gap makes two pieces of one.
    assert_eq!(pieces(&broken), whole + 1);
    broken.panels.clear();
    broken.hole.clear();
    pieces(&broken);
}

/// A painted picture is as large as its print, and is not blank.
#[test]
fn a_picture_of_pixels_has_the_size_that_was_asked_for() {
    let drawing = figure(Direction::Down, 5).drawing();
    let bytes = drawing.png(300.0);
    let pixels = tiny_skia::Pixmap::decode_png(&bytes).expect("a PNG file");
    // 180 mm at 300 dots per inch.
    assert_eq!(pixels.width(), 2126);
    let inked = pixels.pixels().iter().filter(|pixel| pixel.red() < 250);
    let share = inked.count() as f64 / pixels.pixels().len() as f64;
    assert!((0.01..0.5).contains(&share), "{share} of it is inked");
}

/// Both axes have the same unit length; a line that is hardly wide gets a quarter of its length as
/// width.
#[test]
fn a_plan_has_one_scale() {
    let mut figure = figure(Direction::Plan, 1);
    figure.panels.truncate(1);
    figure.panels[0].axis = Axis::new("North, m", Range::Tight);
    for (points, spans) in [
        (vec![(0.0, 0.0), (300.0, 150.0)], (300.0, 150.0)),
        (vec![(0.0, 0.0), (150.0, 300.0)], (150.0, 300.0)),
        (vec![(5.0, 0.0), (15.0, 4000.0)], (1000.0, 4000.0)),
    ] {
        let shared: Vec<f64> = points.iter().map(|point| point.0).collect();
        figure.panels[0].marks =
            vec![Mark::Curve { ink: Ink::Line(0), stroke: Stroke::Solid, points }];
        let scaled = place::to_scale(&figure, &shared);
        let span = |axis: &Axis| match axis.range {
            Range::Fixed(from, to) => to - from,
            _ => panic!("{axis:?}"),
        };
        assert_eq!((span(&scaled.shared), span(&scaled.panels[0].axis)), spans);
        let (wide, high) = place::frame(&scaled, (200.0, 100.0));
        assert!((wide / spans.0 - high / spans.1).abs() < 1e-12);
        assert!(wide <= 200.0 + 1e-9 && high <= 100.0 + 1e-9);
        assert!(wide == 200.0 || (high - 100.0).abs() < 1e-9);
    }
}

/// One node far off does not flatten the others, and is reported with its number.
#[test]
fn an_outlier_is_marked_at_the_edge() {
    for direction in [Direction::Down, Direction::Across] {
        let mut figure = figure(direction, 1);
        figure.panels.truncate(1);
        let mut points: Vec<(f64, f64)> =
            (0..400).map(|i| (10.0 * f64::from(i), (0.1 * f64::from(i)).sin())).collect();
        points[100].1 = 230.0;
        points[300].1 = -120.0;
        figure.panels[0].marks =
            vec![Mark::Curve { ink: Ink::Line(0), stroke: Stroke::Solid, points }];
        let texts = |figure: &Figure| -> Vec<String> {
            let svg = figure.drawing().svg();
            boxes(&svg).into_iter().map(|(_, text)| text).collect()
        };
        assert!(texts(&figure).contains(&"200".to_owned()), "ticks as before");
        figure.panels[0].axis.clips = true;
        let texts = texts(&figure);
        assert!(!texts.contains(&"200".to_owned()), "{texts:?}");
        let is_written = |number: &str| texts.iter().any(|text| text.starts_with(number));
        assert!(is_written("230") && is_written("\u{2212}120"), "{texts:?}");
    }
}

/// A nearly constant load fills a small part of its axis, which has the minimum span of the
/// quantity.
#[test]
fn a_steady_signal_is_not_blown_up() {
    let span = |low: f64, high: f64| {
        let axis = Axis { min_span: 20.0, ..Axis::new("Hook load, kN", Range::Near) };
        let ruler = Ruler::new(&axis, [low, high], 5.0);
        (ruler.value(0.0), ruler.value(1.0))
    };
    // About its middle; from zero where zero is near; unchanged where it varies by more.
    for ((low, high), (from, to)) in [
        ((660.1, 660.3), (650.2, 670.2)),
        ((0.0, 0.2), (0.0, 20.0)),
        ((-0.2, 0.0), (-20.0, 0.0)),
        ((-1e-9, 0.2), (0.0, 20.0)),
        ((600.0, 700.0), (595.0, 705.0)),
    ] {
        let found = span(low, high);
        assert!(
            (found.0 - from).abs() < 1e-9 && (found.1 - to).abs() < 1e-9,
            "{low} to {high}: {found:?}"
        );
    }
}
