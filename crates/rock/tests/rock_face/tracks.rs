//! Surfaces and cuts of the cutters.

use std::f64::consts::{PI, TAU};

use nalgebra::Vector3;
use wholestring_rock::bit_face::{BottomHole, PdcBit};

use wholestring_verification::relative_error;

use super::{faces, opposed, pdc};

/// The cutters leave no ring uncut, and the ridges between their tracks stay below the body. Near
/// the gauge the profile is vertical, and a height has no meaning.
#[test]
fn no_ring_is_left_uncut() {
    let mut worst = vec![];
    for (name, face) in faces() {
        let tracks = face.tracks();
        let ridge = |ring: usize| {
            assert!(tracks.engaged(ring, 2e-3) > 0, "{name}: {}", tracks.radius_m(ring));
            let inside = (tracks.radius_m(ring) - face.profile().core_radius_m())
                .min(face.profile().radius_m() - tracks.radius_m(ring));
            let near_gauge =
                inside < 0.1 * face.profile().radius_m() && tracks.radius_m(ring) > 0.04;
            if near_gauge { 0.0 } else { tracks.ridge_m(ring) }
        };
        worst.push((name, (0..tracks.rings()).map(ridge).fold(0.0, f64::max)));
    }
    for (name, ridge) in &worst {
        assert!(*ridge < 7e-3, "{name}: {ridge}");
    }
    // Discs of 16 mm, 5.6 mm apart, leave 8 mm − √(64 − 2.8²) mm = 0.51 mm; on a cone of 15° a
    // little more.
    assert!((0.3e-3..0.7e-3).contains(&worst[0].1), "{worst:?}");
}

/// The cutters together remove the hole: area times depth of cut, to rounding, however deep they
/// cut and whatever their tracks.
#[test]
fn the_cut_is_the_hole() {
    for (name, face) in faces() {
        let [a, b] = [face.profile().radius_m(), face.profile().core_radius_m()];
        for depth_m in [1e-5, 3e-4, 2e-3, 1.5e-2] {
            let cut = face.tracks().cut(depth_m);
            let volume: f64 = cut.volume_m3.iter().sum();
            let area: f64 = cut.area_m2.iter().sum();
            assert!(relative_error(volume, PI * (a * a - b * b) * depth_m) < 1e-10, "{name}");
            assert!(relative_error(area, (a - b) * depth_m) < 1e-10, "{name}");
            assert!(cut.volume_m3.iter().all(|&v| v >= 0.0));
            if depth_m > 1e-3 {
                let idle = cut.volume_m3.iter().filter(|&&v| v == 0.0).count();
                assert!(idle * 10 <= face.cutters().len(), "{name}: {idle} idle");
            }
        }
    }
}

/// Cutting at one specific energy the face is a bit of Detournay and Defourny: the weight and the
/// torque of its cuts are those of the law, whatever the layout.
#[test]
fn the_face_obeys_detournay_and_defourny() {
    let e07 = wholestring_verification::file("E07_bit_rock_detournay.json");
    let input = |key: &str| e07["inputs"][key].as_f64().unwrap();
    let expected = |key: &str| e07["expected"][key].as_f64().unwrap();
    let face = PdcBit::for_diameter(2.0 * input("a_m")).face().unwrap();
    let cut = face.tracks().cut(expected("depth_of_cut_per_rev_m"));
    let (energy, inclination) = (input("eps_Pa"), input("zeta"));
    let weight: f64 = cut.area_m2.iter().map(|area| inclination * energy * area).sum();
    let torque: f64 = cut.volume_m3.iter().map(|volume| energy * volume / TAU).sum();
    assert!(relative_error(weight, expected("W_cut_N")) < 1e-10, "{weight}");
    assert!(relative_error(torque, expected("T_cut_Nm")) < 1e-10, "{torque}");
}

/// A track is the lowest point of the turning solid: found there by turning a point on it through
/// all angles.
///
/// Tolerance: lines on a cutter's side are 1 mm apart along it, which leaves `1 mm²/(8 r)` of the
/// surface that bends behind the edge, times the slope of a flank; 5 μm covers it beyond 15 mm from
/// the axis. Rows of inserts are within 1 μm.
#[test]
fn a_track_is_the_lowest_point_swept() {
    for (name, face) in faces() {
        let tracks = face.tracks();
        let mut points = 0;
        for index in (0..face.cutters().len()).step_by(6) {
            let cutter = &face.cutters()[index];
            let tip = cutter.tip_m.xy().norm();
            for ring in (0..tracks.rings()).step_by(5) {
                let radius = tracks.radius_m(ring);
                // The flanks are vertical at their ends: no depth there.
                let (Some(z), true) = (tracks.track_m(index, ring), radius > 0.015) else {
                    continue;
                };
                if (radius - tip).abs() > 5e-3 {
                    continue;
                }
                let distance = |angle: f64| {
                    let (sin, cos) = angle.sin_cos();
                    cutter.distance(Vector3::new(radius * cos, radius * sin, z)).0
                };
                let step = TAU / 600.0;
                let coarse = (0..600).map(|i| i as f64 * step);
                let best = coarse.min_by(|&a, &b| distance(a).total_cmp(&distance(b))).unwrap();
                let [mut low, mut high] = [best - step, best + step];
                for _ in 0..30 {
                    let third = (high - low) / 3.0;
                    if distance(low + third) < distance(high - third) {
                        high -= third;
                    } else {
                        low += third;
                    }
                }
                let least = distance(0.5 * (low + high));
                assert!(least.abs() < 5e-6, "{name} {index} at {radius}: {least}");
                points += 1;
            }
        }
        assert!(points > 20, "{name}: {points}");
    }
}

/// Opposed cutters balance; those of a spiral do not, but by little compared with their load.
#[test]
fn imbalance() {
    let cut = opposed().face().unwrap().tracks().cut(2e-3);
    let balanced = cut.drag_imbalance.iter().chain(&cut.thrust_imbalance);
    // 180° as a floating number turns by 1e-16; tracks by the rounding of their angles.
    assert!(balanced.into_iter().all(|share| share.abs() < 1e-9), "{cut:?}");
    let cut = pdc().face().unwrap().tracks().cut(2e-3);
    let [x, y] = cut.drag_imbalance;
    assert!((1e-3..0.3).contains(&x.hypot(y)), "{x} {y}");
}

/// The pattern of the bottom turns with the bit and goes down with it.
#[test]
fn the_bottom_follows_the_bit() {
    let face = pdc().face().unwrap();
    let (tracks, depth_m, sectors) = (face.tracks(), 3e-3, 90);
    let before = tracks.bottom(depth_m, 0.0, sectors);
    let turned = tracks.bottom(depth_m, TAU / 3.0, sectors);
    let mut swing: f64 = 0.0;
    for ring in (0..before.rings()).step_by(7) {
        for sector in 0..sectors {
            let [was, is] = [
                before.z_m(ring, sector).unwrap(),
                turned.z_m(ring, (sector + sectors / 3) % sectors).unwrap(),
            ];
            assert!((was - is).abs() < 1e-12);
            swing = swing.max(tracks.envelope_m(ring) - was);
            assert!(tracks.envelope_m(ring) - was <= depth_m && was <= tracks.envelope_m(ring));
        }
    }
    assert!(swing > 0.1 * depth_m);
}

/// Heights are the means of the values in a cell, and the volume between two bottoms is that of a
/// cylinder.
#[test]
fn heights_of_a_bottom() {
    let mut bottom = BottomHole::new([0.02, 0.1], 8, 12);
    for (x, z) in [(0.0251, 0.01), (0.0259, 0.03), (0.11, 5.0), (0.01, 5.0)] {
        bottom.add([x, 1e-3, z]);
    }
    assert!((bottom.z_m(0, 0).unwrap() - 0.02).abs() < 1e-15);
    assert_eq!(bottom.z_m(0, 11), None);
    let flat = |z: f64| {
        let mut flat = BottomHole::new([0.02, 0.1], 8, 12);
        for ring in 0..8 {
            (0..12).for_each(|sector| flat.set_m(ring, sector, z));
        }
        flat
    };
    let removed = flat(3e-3).removed_since_m3(&flat(1e-3));
    assert!(relative_error(removed, PI * (0.01 - 0.0004) * 2e-3) < 1e-12);
    assert!(
        relative_error(flat(0.0).removed_since_m3(&bottom), -0.02 * PI * (0.0009 - 0.0004) / 12.0)
            < 1e-12
    );
}
