//! The page and the picture of a made-up reach.

use serde_json::json;
use wholestring::operation::OperationKind;
use wholestring_judge::{DepthLimit, Judge, LimitSettings, Reached};
use wholestring_results::{REACH_VERSION, ReachCheck, ReachStop};

use super::*;
use crate::figure::{Ink, Mark, Shape};

const NASTY: &str = "</script><script>alert(1)</script> & \"";

/// A well that a drilling string reaches at a friction of 0.2, and to 5000 m at 0.4.
fn summary() -> ReachSummary {
    let friction = |friction: f64, depth_m: Option<f64>| ReachOfFriction {
        friction: Some(friction),
        friction_at_bit: friction,
        critical_inclination_rad: None,
        first: depth_m.map(|depth_m| ReachStop {
            operation: OperationKind::Drill,
            limit: DepthLimit::TopDrive,
            depth_m,
        }),
        limits: vec![ReachLimit {
            operation: OperationKind::Drill,
            limit: DepthLimit::TopDrive,
            title: "top drive".into(),
            stops: true,
            depth_m,
            already: false,
            locked_up_m: None,
            margin_at_from: Some(1.0),
            margin_at_to: None,
            at_md_m: None,
        }],
        missing: Vec::new(),
    };
    let reached = Reached {
        operation: OperationKind::Drill.words(),
        stopped: Some((5000.0, DepthLimit::TopDrive)),
        pushed_from_m: None,
        rig_pushes: false,
        from_m: 0.0,
        planned_m: 8000.0,
        to_m: 10e3,
    };
    let judge = Judge {
        limits: LimitSettings::default(),
        units: UnitSet::Si,
        soft_has_helix_friction: true,
    };
    ReachSummary {
        schema_version: REACH_VERSION,
        case: NASTY.into(),
        settings: json!({"units": "si"}),
        from_m: 0.0,
        to_m: 10e3,
        inclination_rad: 1.5,
        helix_side_force: true,
        stop_at_helix: false,
        left_out: Vec::new(),
        unchecked: Vec::new(),
        frictions: vec![friction(0.2, None), friction(0.4, Some(5000.0))],
        checks: vec![ReachCheck {
            operation: OperationKind::Drill,
            friction: Some(0.4),
            check: judge.reach(&reached),
        }],
        uncertain: None,
    }
}

/// The margins of a limit of drilling, which fall evenly with depth.
fn falling(limit: DepthLimit, friction: f64, slope: f64) -> impl Iterator<Item = ReachMargin> {
    (0..11).map(f64::from).map(move |step| ReachMargin {
        operation: OperationKind::Drill,
        limit,
        friction: Some(friction),
        bit_depth_m: 1000.0 * step,
        margin: 1.0 - slope * step,
        force_N: None,
        force_limit_N: None,
        torque_N_m: None,
        torque_limit_N_m: None,
        md_m: None,
    })
}

/// The margins of the top drive.
fn margins() -> Vec<ReachMargin> {
    let of_friction = |(friction, slope)| falling(DepthLimit::TopDrive, friction, slope);
    [(0.2, 0.05), (0.4, 0.2)].into_iter().flat_map(of_friction).collect()
}

fn page_of(margins: &[ReachMargin]) -> Reach {
    Reach::new(summary(), margins, None)
}

fn reach() -> Reach {
    page_of(&margins())
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

/// A helix that the string survives has a grey point where it begins, and a curve only where it
/// counts as a stop.
#[test]
fn buckling_that_stops_nothing_has_no_curve() {
    let with_helix = |stops: bool| {
        let mut summary = summary();
        let limits = &mut summary.frictions[1].limits;
        let helix = ReachLimit {
            limit: DepthLimit::Helix,
            title: DepthLimit::Helix.title().into(),
            stops,
            depth_m: Some(4000.0),
            ..limits[0].clone()
        };
        limits.push(helix);
        let mut rows = margins();
        rows.extend(falling(DepthLimit::Helix, 0.4, 0.25));
        let plots = reach_plots(&Reach::new(summary, &rows, None), "si");
        let marks = &plots[0].figure.panels[0].marks;
        let curves = marks.iter().filter(|mark| matches!(mark, Mark::Curve { .. })).count();
        let begins = marks.iter().any(|mark| {
            matches!(mark, Mark::Points { ink: Ink::Note, points, .. }
            if points[..] == [(4000.0, 0.0)])
        });
        (curves, begins)
    };
    assert_eq!(with_helix(false), (2, true));
    assert_eq!(with_helix(true), (3, false));
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
    assert!(reach_plots(&page_of(&[]), "si").is_empty());
}
