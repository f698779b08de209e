//! Readings and the curves of another program over the broomsticks.

use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_results::{PlanMeasured, PlanOverlay, PlanOverlayDifference, PlanOverlayRow};

use super::{plan, plan_html, plan_plots, plan_with};
use crate::figure::{Mark, Range, Stroke};

fn measured(operation: OperationKind, bit_depth_m: f64, held_out: bool) -> PlanMeasured {
    PlanMeasured {
        model: ModelKind::Soft,
        place: "line <2>".into(),
        operation,
        reading: "pick_up".into(),
        is_torque: false,
        held_out,
        bit_depth_m,
        measured: 5e5,
        block_N: 2e5,
        predicted: [4.5e5, 4.8e5, 4.9e5].map(Some),
        message: None,
    }
}

/// Points without the block appear with the curves, the table row with it; a point deeper than the
/// plan has room.
#[test]
fn what_was_measured_stands_on_the_broomstick() {
    let rows = [(OperationKind::TripOut, 1000.0, false), (OperationKind::TripOut, 2400.0, true)];
    let rows = rows.map(|(operation, depth_m, out)| measured(operation, depth_m, out));
    let measured_plan = plan_with(|summary| summary.measured = rows.into());
    let plots = plan_plots(&measured_plan, "si");
    let hook_load = &plots[0].figure;
    let points: Vec<_> = hook_load.panels[0]
        .marks
        .iter()
        .filter_map(|mark| match mark {
            Mark::Points { points, .. } => Some(points.as_slice()),
            _ => None,
        })
        .collect();
    assert_eq!(points, [[(2400.0, 300.0)], [(1000.0, 300.0)]]);
    let keys: Vec<&str> = hook_load.keys.iter().map(|key| key.name.as_str()).collect();
    assert!(keys.ends_with(&["measured", "measured, held out"]), "{keys:?}");
    // No torque was read.
    assert!(plots[1].figure.keys.iter().all(|key| !key.name.contains("measured")));
    assert!(matches!(hook_load.shared.range, Range::Fixed(_, to) if to > 2400.0));
    let page = plan_html(&measured_plan);
    for text in ["plan_measured.csv", "weight with block, kN", "500", "line &lt;2&gt;, held out"] {
        assert!(page.contains(text), "{text}");
    }
    assert!(!plan_html(&plan()).contains("plan_measured"));
}

/// A line over the curves, its name in the legend, and the differences of our curve from it in a
/// table.
#[test]
fn another_program_lies_over_the_broomstick() {
    let row = |bit_depth_m: f64, theirs: f64| PlanOverlayRow {
        model: ModelKind::Soft,
        operation: OperationKind::TripOut,
        place: String::new(),
        is_torque: false,
        bit_depth_m,
        theirs,
        ours: None,
    };
    let overlay = PlanOverlay {
        file: "other <program>.csv".into(),
        rows: vec![row(1000.0, 3e5), row(2500.0, 6e5)],
        differences: vec![PlanOverlayDifference {
            model: ModelKind::Soft,
            operation: OperationKind::TripOut,
            is_torque: false,
            count: 2,
            mean: 4e3,
            largest: -1.2e4,
            largest_at_m: 2500.0,
            theirs_there: 6e5,
            largest_part: Some(-0.02),
        }],
    };
    let overlaid = plan_with(|summary| summary.overlay = Some(overlay));
    let plots = plan_plots(&overlaid, "si");
    let hook_load = &plots[0].figure;
    let lines: Vec<_> = hook_load.panels[0]
        .marks
        .iter()
        .filter_map(|mark| match mark {
            Mark::Curve { stroke: Stroke::LongDashed, points, .. } => Some(points.as_slice()),
            _ => None,
        })
        .collect();
    assert_eq!(lines, [[(1000.0, 300.0), (2500.0, 600.0)]]);
    let keys: Vec<&str> = hook_load.keys.iter().map(|key| key.name.as_str()).collect();
    assert!(keys.ends_with(&["another program: other <program>.csv"]), "{keys:?}");
    assert!(plots[1].figure.keys.iter().all(|key| !key.name.contains("another program")));
    assert!(matches!(hook_load.shared.range, Range::Fixed(_, to) if to > 2500.0));
    let page = plan_html(&overlaid);
    for text in
        ["plan_overlay.csv", "hook load, kN", "\u{2212}12.00", "\u{2212}2.0", "Ours less theirs"]
    {
        assert!(page.contains(text), "{text}");
    }
    assert!(!page.contains("<program>"));
    assert!(!plan_html(&plan()).contains("plan_overlay"));
}
