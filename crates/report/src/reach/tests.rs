//! The page and the picture of a made-up reach.

use std::collections::BTreeMap;

use wholestring::operation::OperationKind;

use super::*;
use crate::figure::{Mark, Shape};

const NASTY: &str = "</script><script>alert(1)</script> & \"";

fn reach() -> Reach {
    let curve = |friction, slope: f64| ReachCurve {
        operation: OperationKind::Drill,
        limit: "top drive".into(),
        friction,
        points: (0..11)
            .map(|step| (1000.0 * f64::from(step), 1.0 - slope * f64::from(step)))
            .collect(),
    };
    let row = |friction, depth_m, first| ReachRow {
        operation: OperationKind::Drill,
        limit: "top drive".into(),
        stops: true,
        friction,
        depth_m,
        already: false,
        margins: [Some(1.0), None],
        md_m: None,
        first,
    };
    Reach {
        head: PageHead {
            program: "wholestring".into(),
            title: NASTY.into(),
            units: "si".into(),
            dimensions: BTreeMap::new(),
            facts: Vec::new(),
        },
        answers: ["si", "metric", "field"].map(|units| vec![format!("{NASTY} {units}")]),
        checks: vec![ReachVerdict {
            severity: Severity::Error,
            friction: "friction 0.4".into(),
            sentences: ["m", "m", "ft"].map(|unit| format!("drill: stopped at 5000 {unit}")),
        }],
        notes: Default::default(),
        frictions: vec!["friction 0.2".into(), "friction 0.4".into()],
        titles: vec!["top drive".into()],
        limits: vec![row(0, None, false), row(1, Some(5000.0), true)],
        curves: vec![curve(0, 0.05), curve(1, 0.2)],
        depths_m: [0.0, 10e3],
        uncertain: None,
    }
}

/// Curves end where they leave the frame; the first stop is named at its depth.
#[test]
fn curves_and_the_first_stop() {
    let plots = reach_plots(&reach(), "si");
    let [plot] = &plots[..] else { panic!("one picture") };
    let [panel] = &plot.figure.panels[..] else { panic!("one operation") };
    let curves: Vec<_> = panel
        .marks
        .iter()
        .filter_map(|mark| match mark {
            Mark::Curve { points, .. } => Some(points),
            _ => None,
        })
        .collect();
    assert_eq!(curves[0].last(), Some(&(10e3, 50.0)));
    let last = curves[1].iter().rev().find(|point| point.1.is_finite()).unwrap();
    assert!((last.0 - 6250.0).abs() < 1e-6 && last.1 == -25.0, "{last:?}");
    let named = panel.marks.iter().any(|mark| {
        matches!(mark, Mark::Name { at, text }
        if *at == (5000.0, 0.0) && text == "top drive")
    });
    let marked = panel.marks.iter().any(|mark| {
        matches!(mark, Mark::Points { shape, points, .. }
        if *shape == Shape::Diamond && points[..] == [(5000.0, 0.0)])
    });
    assert!(named && marked);
}

#[test]
fn the_page_says_it() {
    let page = reach_html(&reach());
    assert!(!page.contains("<script"));
    for part in ["none to 10000", "5000", "locked up", "stops the well first", "friction 0.4"] {
        assert!(page.contains(part), "{part}");
    }
    // The verdict on each operation is before the first figure, with its severity.
    let verdict = page.find("stopped at 5000\u{a0}m").expect("a verdict");
    assert!(verdict < page.find("<figure").expect("a figure"));
    assert!(page.contains("level-error"));
    // The depth of a limit, which is the answer, follows its name.
    assert!(page.contains("<th class=\"words\">limit</th><th>reached with the bit at</th>"));
    assert!(reach_plots(&Reach { curves: Vec::new(), ..reach() }, "si").is_empty());
}
