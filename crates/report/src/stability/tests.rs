//! The map of torsional stability, by its marks.

use std::collections::BTreeMap;

use super::{StabilityPicture, stability_figure};
use crate::{
    PageHead,
    figure::{Mark, Range},
};

/// Unstable at the corner of low speed and high weight; stable everywhere at the smallest weight,
/// nowhere at the largest.
fn picture() -> StabilityPicture {
    StabilityPicture {
        speeds_rad_per_s: vec![5.0, 10.0, 15.0],
        weights_N: vec![20e3, 40e3, 60e3],
        growth_per_s: vec![-0.1, -0.2, -0.3, 0.2, -0.2, -0.3, 0.4, 0.2, 0.1],
        thresholds_rad_per_s: vec![f64::NAN, 7.5, f64::NAN],
        own: [20.0, 40e3],
    }
}

fn marks(picture: &StabilityPicture) -> (Vec<Mark>, Range) {
    let head = PageHead {
        program: "test".into(),
        title: "a well".into(),
        units: "si".into(),
        dimensions: BTreeMap::new(),
        facts: Vec::new(),
    };
    let figure = stability_figure(picture, &head, "si");
    (figure.panels[0].marks.clone(), figure.shared.range)
}

/// Growth is exact on its points and linear between them; stable places have no colour; the
/// threshold has its one point; the frame includes the case, which is beyond the map.
#[test]
fn the_map_shows_growth_threshold_and_case() {
    let (marks, range) = marks(&picture());
    let Mark::Map(map) = &marks[0] else {
        panic!("a map");
    };
    let at = |column: usize, row: usize| map.values[column * map.middles.len() + row];
    assert_eq!(map.ends.len() * map.middles.len(), map.values.len());
    assert_eq!((map.middles.len(), map.largest), (17, 0.4));
    assert!(at(0, 0).is_nan() && at(8, 8).is_nan());
    assert_eq!([at(0, 8), at(0, 16), at(16, 16)], [0.2, 0.4, 0.1]);
    assert!((at(4, 16) - 0.3).abs() < 1e-12 && (at(0, 12) - 0.3).abs() < 1e-12);
    let Mark::Curve { points, .. } = &marks[1] else {
        panic!("a threshold");
    };
    let finite: Vec<_> = points.iter().filter(|(speed, _)| speed.is_finite()).collect();
    assert_eq!(finite, [&(7.5, 40e3)]);
    assert!(matches!(&marks[2], Mark::Points { points, .. } if points[..] == [(20.0, 40e3)]));
    assert_eq!(range, Range::Fixed(5.0, 20.0));
}

/// A string that is stable everywhere has no colours and no threshold.
#[test]
fn a_stable_map_is_blank() {
    let mut stable = picture();
    stable.growth_per_s = vec![-0.1; 9];
    stable.thresholds_rad_per_s = vec![f64::NAN; 3];
    let (marks, _) = marks(&stable);
    assert!(matches!(&marks[..], [Mark::Points { .. }]));
}
