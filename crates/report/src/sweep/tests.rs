//! Pictures and tables of sweeps.

use std::collections::BTreeMap;

use wholestring::outcome::ModelKind;

use super::*;
use crate::{
    DisplayUnit, Severity,
    figure::{Direction, Figure, Mark, Sample, Scale, Stroke},
};

const MODELS: [ModelKind; 2] = [ModelKind::Soft, ModelKind::Dynamic];

/// A sweep of two keys by both models, with a number that shows every case.
fn sweep(keys: [&str; 2], values: [&[&str]; 2]) -> Sweep {
    let unit = |symbol: &str, factor| DisplayUnit { symbol: symbol.into(), factor };
    let mut rows = Vec::new();
    for (i, first) in values[0].iter().enumerate() {
        for (k, second) in values[1].iter().enumerate() {
            for model in MODELS {
                let load = 1e5 * (1.0 + i as f64 + 10.0 * k as f64);
                let mut numbers = BTreeMap::from([
                    ("bit_depth_m".to_owned(), 300.0 * (k + 1) as f64),
                    ("hook_load_N".to_owned(), load),
                ]);
                if model == ModelKind::Dynamic {
                    for (end, value) in [("p05", load - 1e3), ("p95", load + 1e3), ("std", 5e2)] {
                        numbers.insert(format!("hook_load_N_{end}"), value);
                    }
                }
                rows.push(SweepRow {
                    values: vec![(*first).to_owned(), (*second).to_owned()],
                    model: Some(model),
                    operation: Some(OperationKind::Drill),
                    status: "complete".into(),
                    numbers,
                    errors: 0,
                    warnings: 0,
                    check: Default::default(),
                    page: None,
                });
            }
        }
    }
    Sweep {
        head: PageHead {
            program: "wholestring".into(),
            title: "A well".into(),
            units: "si".into(),
            dimensions: BTreeMap::from([
                ("force".into(), [unit("kN", 1e3), unit("t", 9806.65), unit("klbf", 4448.2216)]),
                ("length".into(), [unit("m", 1.0), unit("m", 1.0), unit("ft", 0.3048)]),
            ]),
            facts: Vec::new(),
        },
        keys: keys.map(String::from).to_vec(),
        checked: true,
        rows,
    }
}

fn figure(sweep: &Sweep, units: &str) -> Figure {
    let plots = sweep_plots(sweep, units);
    let names: Vec<&str> = plots.iter().map(|plot| plot.name.as_str()).collect();
    // Quantities without values are not drawn.
    assert_eq!(names, ["sweep", "hook-load"]);
    plots[0].figure.clone()
}

fn curves(figure: &Figure) -> Vec<(Stroke, Vec<(f64, f64)>)> {
    let marks = figure.panels[0].marks.iter();
    marks
        .filter_map(|mark| match mark {
            Mark::Curve { stroke, points, .. } => Some((*stroke, points.clone())),
            _ => None,
        })
        .collect()
}

/// Depth points down, in the reader's units; a curve for each friction, dashed for the soft string,
/// and the band of the dynamics about its mean.
#[test]
fn a_broomstick_has_a_curve_for_each_friction() {
    let sweep = sweep(["friction", "bit_depth"], [&["0.1", "0.2", "0.3"], &["300m", "600m"]]);
    let figure = figure(&sweep, "field");
    assert_eq!(figure.layout.direction, Direction::Down);
    assert!(figure.shared.down);
    assert_eq!(figure.shared.label, "Bit depth, ft");
    assert_eq!(figure.panels[0].axis.label, "Hook load without block, klbf");
    let curves = curves(&figure);
    assert_eq!(curves.len(), 6);
    let dashed = curves.iter().filter(|(stroke, _)| *stroke == Stroke::Dashed);
    assert_eq!(dashed.count(), 3);
    // Friction 0.2 at 600 m: 100 kN (1 + 1 + 10).
    let (depth, load) = curves[2].1[1];
    assert!((depth - 600.0 / 0.3048).abs() < 1e-9, "{depth} ft");
    assert!((load - 1.2e6 / 4448.2216).abs() < 1e-9, "{load} klbf");
    let names: Vec<&str> = figure.keys.iter().map(|key| key.name.as_str()).collect();
    assert_eq!(
        names,
        [
            "friction 0.1",
            "friction 0.2",
            "friction 0.3",
            "dynamics, mean",
            "soft string",
            "5–95 % of the time"
        ]
    );
    let bands = figure.panels[0].marks.iter().filter_map(|mark| match mark {
        Mark::Band { points, .. } => Some(points),
        _ => None,
    });
    let widths: Vec<f64> = bands
        .flatten()
        .filter(|point| point.1.is_finite())
        .map(|(_, low, high)| high - low)
        .collect();
    assert_eq!(widths.len(), 6);
    assert!(widths.iter().all(|width| (width - 2e3 / 4448.2216).abs() < 1e-9));
}

/// Without depth the key with the most values is the axis: as numbers where they are numbers of one
/// unit.
#[test]
fn any_key_can_be_the_axis() {
    let numbers = sweep(["rpm", "wob"], [&["60", "90"], &["2tf", "4tf", "6tf"]]);
    let numbers = figure(&numbers, "si");
    assert_eq!(numbers.layout.direction, Direction::Across);
    assert_eq!(numbers.shared.label, "Weight on bit, tf");
    let at: Vec<f64> = curves(&numbers)[0].1.iter().map(|point| point.0).collect();
    assert_eq!(at, [2.0, 4.0, 6.0]);
    assert!(matches!(numbers.keys[0].sample, Sample::Line(..)));
    assert_eq!(numbers.keys[0].name, "rotary speed 60");
    let words =
        sweep(["dynamics.friction_law", "dynamics.seed"], [&["vector", "independent"], &["1"]]);
    let words = figure(&words, "si");
    assert_eq!(words.shared.label, "Friction law");
    assert_eq!(words.shared.scale, Scale::Words(vec!["vector".into(), "independent".into()]));
}

#[test]
fn values_are_read_with_their_unit() {
    use super::varied::split;
    for (text, expected) in [
        ("0.2", Some((0.2, ""))),
        ("1e-3", Some((1e-3, ""))),
        ("300m", Some((300.0, "m"))),
        ("-2.5 deg/30m", Some((-2.5, "deg/30m"))),
        ("vector", None),
        ("nan", None),
        ("", None),
    ] {
        assert_eq!(split(text), expected, "{text}");
    }
}

/// The table has every case, and marks those that failed.
#[test]
fn the_table_has_every_case() {
    let mut sweep = sweep(["friction", "bit_depth"], [&["0.1", "0.2"], &["300m"]]);
    let page_table = sweep.page_table();
    assert_eq!(
        page_table.heads,
        ["friction", "bit_depth", "Model", "Operation", "Hook load without block"]
    );
    assert_eq!(page_table.rows.len(), 4);
    assert_eq!(
        page_table.rows[1][4],
        Cell::Quantity { value: 1e5, dimension: "force".into(), std: Some(5e2) }
    );
    sweep.rows[0] = SweepRow {
        values: sweep.rows[0].values.clone(),
        model: None,
        operation: None,
        status: "failed".into(),
        numbers: BTreeMap::new(),
        errors: 0,
        warnings: 1,
        check: Default::default(),
        page: Some("a/report.html".into()),
    };
    let page_table = sweep.page_table();
    assert_eq!(page_table.heads[5..], ["Status", "Checks", "Report"]);
    assert_eq!(
        page_table.rows[0][5..],
        [
            Cell::Text("failed".into()),
            Cell::Text("\u{25b2} 1 warning".into()),
            Cell::Link { text: "open".into(), href: "a/report.html".into() },
        ]
    );
    assert_eq!(page_table.rows[1][7], Cell::Nothing);
}

/// A page holds the figure in every set of units, and no name ends its element.
#[test]
fn the_page_of_a_sweep_is_whole() {
    let nasty = "</template><script>alert(1)</script> & \"x\"";
    let mut sweep = sweep(["friction", "bit_depth"], [&["0.1", nasty], &["300m", "600m"]]);
    sweep.head.title = nasty.into();
    let page = crate::sweep_html(&sweep);
    // Each wide and narrow.
    assert_eq!(page.matches("<svg class=\"figure\"").count(), 6);
    assert_eq!(page.matches("</template").count(), 6);
    assert_eq!(page.matches("</script").count(), 2);
    for label in ["Hook load without block", "klbf", "kN"] {
        assert!(page.contains(label), "{label}");
    }
}

/// Eight frictions have seven colours: the eighth shares that of the first, and is dashed.
#[test]
fn more_curves_than_colours_differ_by_stroke() {
    let frictions = ["0.1", "0.15", "0.2", "0.25", "0.3", "0.35", "0.4", "0.45"];
    let mut sweep = sweep(["friction", "bit_depth"], [&frictions, &["300m", "600m"]]);
    sweep.rows.retain(|row| row.model == Some(ModelKind::Soft));
    let strokes: Vec<Stroke> =
        curves(&figure(&sweep, "si")).iter().map(|(stroke, _)| *stroke).collect();
    assert_eq!(strokes[..7], [Stroke::Solid; 7]);
    assert_eq!(strokes[7..], [Stroke::Dashed]);
}

/// Operations are distinguished by strokes and named at the ends of their curves; a page can hide
/// the marks of a key, and knows the row of a point.
#[test]
fn operations_differ_by_stroke_and_have_their_names() {
    let mut sweep = sweep(["friction", "bit_depth"], [&["0.1"], &["300m", "600m"]]);
    sweep.rows.retain(|row| row.model == Some(ModelKind::Soft));
    let slides = sweep
        .rows
        .clone()
        .into_iter()
        .map(|row| SweepRow { operation: Some(OperationKind::Slide), ..row });
    sweep.rows = sweep.rows.iter().cloned().chain(slides).collect();
    let figure = figure(&sweep, "si");
    let strokes: Vec<Stroke> = curves(&figure).iter().map(|(stroke, _)| *stroke).collect();
    assert_eq!(strokes, [Stroke::Solid, Stroke::Dashed]);
    let names: Vec<&str> = figure.panels[0]
        .marks
        .iter()
        .filter_map(|mark| match mark {
            Mark::Foot { text, .. } => Some(text.as_str()),
            _ => None,
        })
        .collect();
    assert_eq!(names, ["drill", "slide"]);
    let page = crate::sweep_html(&sweep);
    // A curve and its points for each operation, in each set of units.
    for key in ["0", "1"] {
        let group = format!("<g class=\"series\" data-keys=\"{key}\">");
        assert!(page.matches(&group).count() >= 6, "{group}");
        assert_eq!(
            page.matches(&format!("<g class=\"legend-key\" data-keys=\"{key}\">")).count(),
            // Wide and narrow.
            6
        );
    }
    // Place and row of each point: two of each operation in a panel.
    let spots = page.split("data-spots=\"").skip(1);
    let spots: Vec<&str> = spots.map(|rest| rest.split('"').next().unwrap()).collect();
    let rows = |spots: &&str| -> Vec<String> {
        let numbers: Vec<&str> = spots.split(' ').collect();
        numbers.chunks(3).map(|spot| spot[2].to_owned()).collect()
    };
    for pair in [["0", "1"], ["2", "3"]] {
        assert_eq!(spots.iter().map(rows).filter(|rows| *rows == pair).count(), 6);
    }
    // Files for paper have none of that.
    let file = figure.drawing().svg();
    assert!(!file.contains("data-") && !file.contains("class=\"series\""));
    assert!(file.contains(">slide</text>"));
}

/// A case with errors has a ring in every picture and a name for it in the legend, one with
/// warnings alone a broken one.
#[test]
fn judged_cases_are_ringed() {
    let mut sweep = sweep(["friction", "bit_depth"], [&["0.1"], &["300m", "600m"]]);
    let rings = |figure: &Figure| -> Vec<(Severity, Vec<(f64, f64)>)> {
        let marks = figure.panels[0].marks.iter();
        marks
            .filter_map(|mark| match mark {
                Mark::Rings { level, points } => Some((*level, points.clone())),
                _ => None,
            })
            .collect()
    };
    let named = |figure: &Figure| -> Vec<(String, Sample)> {
        let keys = figure.keys.iter();
        let ringed = keys.filter(|key| matches!(key.sample, Sample::Ring(_)));
        ringed.map(|key| (key.name.clone(), key.sample)).collect()
    };
    let clean = figure(&sweep, "si");
    assert!(rings(&clean).is_empty() && named(&clean).is_empty());
    for row in &mut sweep.rows {
        let deep = row.values[1] == "600m";
        (row.errors, row.warnings) = match (deep, row.model) {
            (true, Some(ModelKind::Soft)) => (1, 2),
            (true, _) => (0, 1),
            _ => (0, 0),
        };
    }
    let judged = figure(&sweep, "si");
    // 100 kN (1 + 10) at 600 m.
    let at = (600.0, 1100.0);
    assert_eq!(rings(&judged), [(Severity::Warning, vec![at]), (Severity::Error, vec![at])]);
    assert_eq!(
        named(&judged),
        [
            ("with errors".to_owned(), Sample::Ring(Severity::Error)),
            ("with warnings".to_owned(), Sample::Ring(Severity::Warning))
        ]
    );
    // A page hides a ring with its curve and with its own key.
    let place = judged.keys.iter().position(|key| key.name == "with errors");
    let marks = &judged.panels[0].marks;
    let of_ring = marks.windows(2).find_map(|pair| match pair {
        [Mark::Of { keys }, Mark::Rings { level: Severity::Error, .. }] => Some(keys),
        _ => None,
    });
    let of_ring = of_ring.unwrap();
    assert_eq!(of_ring.last().copied(), place);
    let also = of_ring.iter().map(|key| judged.keys[*key].name.as_str());
    assert!(also.into_iter().any(|name| name == "soft string"));
    // A full ring and a broken one are drawn.
    let svg = judged.drawing().svg();
    assert!(svg.contains("stroke-over") && svg.contains("stroke-near"), "{svg}");
}

/// The verdict counts cases rather than rows, names the case of the most severe check, and prints
/// its units as on a page.
#[test]
fn the_verdict_counts_cases_and_quotes_the_most_severe_check() {
    let mut sweep = sweep(["friction", "rpm"], [&["0.2", "0.4"], &["60", "120"]]);
    let verdict = |sweep: &Sweep| {
        serde_json::to_value(sweep.verdict().expect("a verdict")).expect("words").to_string()
    };
    assert!(verdict(&sweep).contains("no errors and no warnings in 4 cases"));
    for (row, errors, warnings) in [(0, 0, 1), (6, 1, 0), (7, 2, 0)] {
        sweep.rows[row].errors = errors;
        sweep.rows[row].warnings = warnings;
        sweep.rows[row].check =
            ["kN.m", "kN.m", "ft-lbf"].map(|unit| format!("{errors} errors at 3 {unit}"));
    }
    let text = verdict(&sweep);
    assert!(text.contains(r#""severity":"error""#), "{text}");
    assert!(text.contains("errors in 1 of 4 cases, warnings in 1 more"), "{text}");
    assert!(text.contains("friction 0.4, rpm 120, drill: 2 errors at 3 kN·m"), "{text}");
    assert!(crate::sweep_html(&sweep).contains("errors in 1 of 4 cases"));
    sweep.checked = false;
    assert_eq!(sweep.verdict(), None);
}

/// Curves that end at one point have one name, not a stack of them; names of others are beyond the
/// ends, where no curve runs.
#[test]
fn names_of_curves_that_coincide_are_one() {
    let mut sweep =
        sweep(["friction", "rpm"], [&["0.1", "0.2", "0.3", "0.4"], &["60", "120", "180"]]);
    let names = |sweep: &Sweep| -> Vec<String> {
        let marks = figure(sweep, "si").panels.swap_remove(0).marks;
        let name = |mark: &Mark| match mark {
            Mark::Foot { text, .. } => Some(text.clone()),
            _ => None,
        };
        marks.iter().filter_map(name).collect()
    };
    assert_eq!(names(&sweep).len(), 3);
    let page = figure(&sweep, "si").drawing().element("f");
    let line = |part: &str| page.lines().find(|line| line.contains(part)).expect("a line");
    let after = |line: &str, start: &str| -> f64 {
        let (_, rest) = line.split_once(start).expect("a number");
        let end = rest.find(|letter: char| !letter.is_ascii_digit() && letter != '.');
        rest[..end.unwrap_or(rest.len())].parse().expect("a number")
    };
    // Each spot is x, y and row.
    let (_, spots) = page.split_once("data-spots=\"").expect("spots");
    let spots: Vec<f64> = spots[..spots.find('"').expect("an end")]
        .split(' ')
        .map(|number| number.parse().expect("a number"))
        .collect();
    let end = spots.iter().step_by(3).copied().fold(0.0, f64::max);
    let name = after(line(">180</text>"), "x=\"");
    assert!(name > end, "a name at {name} over curves that end at {end}");
    // On a narrow page, where they would take the room of the curves, the legend has them.
    let mut narrow = figure(&sweep, "si");
    narrow.layout.columns = 1;
    narrow.layout.width_mm = 20.0;
    assert!(!narrow.drawing().element("f").contains(">180</text>"));
    for row in &mut sweep.rows {
        row.numbers.insert("hook_load_N".into(), 1e5);
    }
    assert_eq!(names(&sweep), ["all 3"]);
}
