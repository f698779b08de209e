//! High side and right side.

use nalgebra::Vector3;
use wholestring::well::Path;

use crate::surveys::{kick_off_at_300_m, smooth_well, spline, station};

fn bearing_deg(path: &Path, md_m: f64) -> f64 {
    let high = path.high_side_at(md_m);
    high.y.atan2(high.x).to_degrees()
}

/// Largest angle by which the high side turns over `step_m`, deg.
fn largest_step_deg(path: &Path, from: f64, to: f64, step_m: f64) -> f64 {
    let steps = ((to - from) / step_m).ceil();
    (0..steps as usize)
        .map(|step| {
            let md_m = from + step_m * step as f64;
            let (a, b) = (path.high_side_at(md_m), path.high_side_at(md_m + step_m));
            a.dot(&b).clamp(-1.0, 1.0).acos().to_degrees()
        })
        .fold(0.0, f64::max)
}

#[test]
fn horizontal_hole_to_the_north() {
    let path = spline(&[station(0.0, 90.0, 0.0), station(100.0, 90.0, 0.0)]);
    let point = path.at(50.0);
    assert!((point.high_side().unwrap() - Vector3::new(0.0, 0.0, -1.0)).norm() < 1e-15);
    assert!((point.right_side().unwrap() - Vector3::new(0.0, 1.0, 0.0)).norm() < 1e-15);
}

/// In any inclined hole: across the hole, in the vertical plane through it, upwards.
#[test]
fn definition() {
    let path = spline(&smooth_well(40));
    for metre in 0..=1200 {
        let point = path.at(f64::from(metre));
        let (high, right) = (point.high_side().unwrap(), point.right_side().unwrap());
        assert!((high.norm() - 1.0).abs() < 1e-14);
        assert!(high.dot(&point.tangent).abs() < 1e-14);
        assert!(right.z.abs() < 1e-14);
        assert!((-high.z - point.inclination_rad().sin()).abs() < 1e-14);
        assert!((path.high_side_at(f64::from(metre)) - high).norm() < 1e-12);
    }
}

#[test]
fn vertical_hole() {
    let path = spline(&[station(0.0, 0.0, 123.0), station(1500.0, 0.0, 77.0)]);
    assert_eq!(path.at(700.0).high_side(), None);
    assert_eq!(path.at(700.0).azimuth_rad(), 0.0);
    for md_m in [-10.0, 0.0, 700.0, 1500.0, 1600.0] {
        assert!((path.high_side_at(md_m) - Vector3::new(1.0, 0.0, 0.0)).norm() < 1e-15);
    }
}

/// Above the kick-off the high side already faces the way the hole will deviate, and it passes the
/// kick-off without a jump.
#[test]
fn continuous_through_a_kick_off() {
    let path = spline(&kick_off_at_300_m());
    assert!((bearing_deg(&path, 0.0) - 45.0).abs() < 1e-9);
    assert!((bearing_deg(&path, 299.0) - 45.0).abs() < 1e-9);
    assert!((bearing_deg(&path, 320.0) - 45.0).abs() < 1e-9);
    // It turns with the hole: 1.2 times 0.1 deg/m at most.
    assert!(largest_step_deg(&path, 0.0, 600.0, 0.5) < 0.0601);
}

/// A hole that drops to vertical keeps the bearing that it had; between two inclined parts the
/// bearing turns evenly from the one to the other.
#[test]
fn continuous_through_vertical_parts() {
    let path = spline(&[
        station(0.0, 10.0, 20.0),
        station(100.0, 10.0, 20.0),
        station(200.0, 0.0, 0.0),
        station(300.0, 0.0, 0.0),
        station(400.0, 10.0, 110.0),
        station(500.0, 0.0, 0.0),
        station(600.0, 0.0, 0.0),
    ]);
    assert!((bearing_deg(&path, 180.0) - 20.0).abs() < 1e-6);
    assert!((bearing_deg(&path, 250.0) - 65.0).abs() < 0.1);
    assert!((bearing_deg(&path, 320.0) - 110.0).abs() < 1e-6);
    assert!((bearing_deg(&path, 650.0) - 110.0).abs() < 1e-6);
    // 90° over some 105 m of near-vertical hole.
    assert!(largest_step_deg(&path, 0.0, 700.0, 0.1) < 0.1);
}

/// The narrow passage of a hole through the vertical is found even when it has no station near.
#[test]
fn continuous_through_a_passage() {
    let path = spline(&[
        station(0.0, 40.0, 0.0),
        station(400.0, 40.0, 180.0),
        station(500.0, 40.0, 180.0),
    ]);
    // Vertical at 200 m; 0.001 rad either side of it is 0.24 m, and the bearing turns 180° in it.
    assert!((bearing_deg(&path, 199.0)).abs() < 1e-6);
    assert!((bearing_deg(&path, 201.0).abs() - 180.0).abs() < 1e-6);
    assert!(largest_step_deg(&path, 190.0, 210.0, 0.001) < 1.0);
}

/// A hole that goes straight up has its high side opposite to its azimuth.
#[test]
fn continuous_up_to_straight_up() {
    let path = spline(&[
        station(0.0, 90.0, 30.0),
        station(300.0, 180.0, 30.0),
        station(400.0, 180.0, 30.0),
    ]);
    assert!((bearing_deg(&path, 200.0) + 150.0).abs() < 1e-6);
    assert!((bearing_deg(&path, 390.0) + 150.0).abs() < 1e-6);
    assert!(largest_step_deg(&path, 0.0, 400.0, 0.1) < 0.05);
}
