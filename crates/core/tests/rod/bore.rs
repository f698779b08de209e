//! The hole's radius: cones instead of steps.

use wholestring::{prelude::*, wall::Bore};

use crate::common::open_section;

fn bore(diameters_to_md_m: &[(f64, f64)]) -> Bore {
    let mut from_md_m = 0.0;
    let sections = diameters_to_md_m.iter().map(|&(diameter_m, to_md_m)| {
        let section = HoleSection { from_md_m, ..open_section(diameter_m, 0.3, to_md_m) };
        from_md_m = to_md_m;
        section
    });
    Bore::new(&Hole::new(sections.collect()).expect("a sound hole"))
}

/// Within a cone the slope is 1:100, and nowhere more where cones do not meet.
#[test]
fn radius_changes_by_one_in_a_hundred() {
    let bore = bore(&[(0.34, 500.0), (0.31, 1500.0), (0.2159, 2500.0), (0.25, 2600.0)]);
    let at = |md: f64| bore.smooth_radius_m(md);
    let h = 0.01;
    let steepest = (1..300_000)
        .map(|i| (at(i as f64 * h) - at((i - 1) as f64 * h)).abs() / h)
        .fold(0.0, f64::max);
    assert!((steepest - 0.01).abs() < 1e-9, "{steepest}");
    for (md, diameter) in [(0.0, 0.34), (1000.0, 0.31), (2000.0, 0.2159), (2700.0, 0.25)] {
        assert!((at(md) - 0.5 * diameter).abs() < 1e-15);
    }
    // The cone is centred on the step.
    assert!((at(1500.0) - 0.25 * (0.31 + 0.2159)).abs() < 1e-15);
    assert_eq!(bore.smooth_radius_m(-1e-9), 0.17);
}

/// A washout or a liner shorter than its two cones: the cones overlap and the radius has no step.
#[test]
fn a_short_section_makes_no_step() {
    for (middle, longest) in [(0.5, 0.01), (0.1, 0.01), (0.25, 0.02)] {
        let bore = bore(&[(0.3, 100.0), (middle, 101.0), (0.2, 200.0)]);
        let at = |md: f64| bore.smooth_radius_m(md);
        let h = 0.001;
        let steepest = (1..200_000)
            .map(|i| (at(i as f64 * h) - at((i - 1) as f64 * h)).abs() / h)
            .fold(0.0, f64::max);
        assert!(steepest < longest * (1.0 + 1e-6), "{middle}: {steepest}");
        assert!((at(0.0) - 0.15).abs() < 1e-15 && (at(200.0) - 0.1).abs() < 1e-15);
    }
}
