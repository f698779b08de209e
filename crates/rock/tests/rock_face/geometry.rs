//! Profiles, cutters, the grid, and invalid bits.

use std::cell::Cell;

use nalgebra::Vector3;
use proptest::{prelude::*, test_runner::TestRunner};
use wholestring_rock::bit_face::{Cutter, FaceError, InsertBit, PdcBit};

use super::{cones, faces, pdc};

/// Sizes from slim holes to top holes make a bit without further numbers, with cutters from the
/// axis (or the core) to the gauge.
#[test]
fn every_diameter_makes_a_bit() {
    for inches in [3.75, 4.75, 6.0, 6.125, 8.5, 9.875, 12.25, 14.75, 17.5, 26.0] {
        let diameter_m = 0.0254 * inches;
        for face in [
            PdcBit::for_diameter(diameter_m).face(),
            PdcBit::core(diameter_m, 0.45 * diameter_m).face(),
            InsertBit::for_diameter(diameter_m).face(),
        ] {
            let face = face.unwrap_or_else(|error| panic!("{inches} in: {error}"));
            let last = face.cutters().last().unwrap().tip_m;
            assert!((last.xy().norm() - 0.5 * diameter_m).abs() < 1e-12);
        }
    }
    // 6 blades and 16 mm cutters on 8-1/2 in.
    let face = pdc().face().unwrap();
    assert_eq!((face.blades(), face.cutters().len()), (6, 30));
}

/// The profile's points are where its own distance is zero, one after the other without a corner.
#[test]
fn profiles_are_smooth() {
    for (name, face) in faces() {
        let profile = face.profile();
        let (length, steps) = (profile.length_m(), 1000);
        let mut before = profile.at(0.0);
        for step in 1..=steps {
            let point = profile.at(length * step as f64 / steps as f64);
            let (dr, dz) = (point.radius_m - before.radius_m, point.z_m - before.z_m);
            // A chord of an arc of 24 mm is shorter by 5e-9 of 0.14 mm, and leans by half of 0.006
            // rad.
            let chord = dr.hypot(dz) / (length / steps as f64);
            assert!((chord - 1.0).abs() < 1e-5, "{name}: {chord}");
            let across = (dr * point.normal[0] + dz * point.normal[1]) / length * steps as f64;
            assert!(across.abs() < 4e-3, "{name}: {across}");
            if point.radius_m < profile.radius_m() * (1.0 - 1e-9) {
                assert!((profile.z_m(point.radius_m) - point.z_m).abs() < 1e-9, "{name}");
            }
            assert!(point.z_m < 1e-15);
            before = point;
        }
        assert!((before.radius_m - profile.radius_m()).abs() < 1e-12);
        assert!((before.z_m - profile.gauge_z_m()).abs() < 1e-12);
    }
}

/// Middle of a cutter's face, from its tip, its rake and its radius.
fn middle(cutter: &Cutter, radius: f64) -> Vector3<f64> {
    let (sin, cos) = cutter.back_rake_rad.sin_cos();
    cutter.tip_m - (cutter.normal - cutter.axis * sin) / cos * radius
}

/// A sharp cutter's distance is that of the nearest of points 0.1 mm apart on a disc, which is at
/// most 0.07 mm from the true foot; the sign is that of the disc's inequality.
#[test]
fn distance_is_that_of_the_nearest_point() {
    let bit = PdcBit { chamfer_m: 0.0, ..pdc() };
    let face = bit.face().unwrap();
    let cutter = &face.cutters()[17];
    let (a, length, pitch) = (0.5 * bit.cutter_diameter_m, bit.cutter_length_m, 1e-4);
    let middle = middle(cutter, a);
    let u = cutter.axis.cross(&Vector3::x()).normalize();
    let v = cutter.axis.cross(&u);
    let mut surface = Vec::new();
    let mut ring = |rho: f64, zeta: f64| {
        let points = (std::f64::consts::TAU * rho / pitch).ceil().max(1.0) as usize;
        for i in 0..points {
            let (sin, cos) = (std::f64::consts::TAU * i as f64 / points as f64).sin_cos();
            surface.push(middle + cutter.axis * zeta + (u * cos + v * sin) * rho);
        }
    };
    for i in 0..=(a / pitch) as usize {
        ring(i as f64 * pitch, 0.0);
        ring(i as f64 * pitch, -length);
    }
    for i in 0..=(length / pitch) as usize {
        ring(a, -(i as f64) * pitch);
    }
    let mut random = 1u64;
    let mut uniform = || {
        random = random.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (random >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    for _ in 0..60 {
        let from = Vector3::from_fn(|_, _| 0.03 * uniform()) - cutter.axis * 0.5 * length;
        let point = middle + from;
        let (distance, _) = cutter.distance(point);
        let nearest = surface.iter().map(|p| (p - point).norm_squared());
        let nearest = nearest.fold(f64::INFINITY, f64::min).sqrt();
        let zeta = from.dot(&cutter.axis);
        let inside = zeta < 0.0 && zeta > -length && (from - cutter.axis * zeta).norm() < a;
        assert_eq!(distance < 0.0, inside);
        let exact = distance.abs();
        assert!(exact <= nearest + 1e-12 && nearest <= exact.hypot(0.8e-4), "{exact} {nearest}");
    }
}

/// A hemisphere's distance is the ball's below its equator.
#[test]
fn a_hemisphere_is_a_ball() {
    let bit = InsertBit::for_diameter(0.2159);
    let face = bit.face().unwrap();
    for insert in face.cutters().iter().step_by(7) {
        let a = 0.5 * bit.insert_diameter_m;
        let centre = insert.tip_m - insert.axis * a;
        for off in [Vector3::x(), Vector3::y(), Vector3::z(), Vector3::new(0.3, -0.4, 0.2)] {
            let point = centre + off * 2.0 * a + insert.axis * 2.5 * a;
            let (distance, _) = insert.distance(point);
            assert!((distance - ((point - centre).norm() - a)).abs() < 1e-15);
        }
    }
}

/// The way out is the gradient of the distance, of length one: differences over 1 nm against
/// rounding of 1e-8.
#[test]
fn the_way_out_is_the_gradient() {
    for face in [pdc().face().unwrap(), cones().face().unwrap()] {
        let cutters = face.cutters();
        let near = -0.02..0.02f64;
        let point = (near.clone(), near.clone(), near, 0..cutters.len());
        let result = TestRunner::default().run(&point, |(x, y, z, which)| {
            let cutter = &cutters[which];
            let point = cutter.tip_m + Vector3::new(x, y, z);
            let (distance, out) = cutter.distance(point);
            prop_assert!((out.norm() - 1.0).abs() < 1e-12);
            let h = 1e-9;
            let along = (cutter.distance(point + out * h).0 - distance) / h;
            // Where two surfaces are as near, inside, the direction jumps.
            prop_assert!((along - 1.0).abs() < 1e-6 || distance < 0.0, "{along}");
            // A distance changes by no more than one goes.
            let (tip, _) = cutter.distance(cutter.tip_m);
            prop_assert!((tip - distance).abs() <= (point - cutter.tip_m).norm() + 1e-12);
            Ok(())
        });
        result.unwrap();
    }
}

/// The grid gives the result of a search through all cutters, bit for bit, inside the face and
/// around it.
#[test]
fn the_grid_finds_what_a_search_finds() {
    for (name, face) in faces() {
        let radius = face.profile().radius_m();
        let low = face.profile().top_z_m();
        let held = Cell::new(0);
        let result = TestRunner::new(ProptestConfig::with_cases(6000)).run(
            &(-1.1..1.1, -1.1..1.1, 0.0..1.0f64),
            |(x, y, z)| {
                // Most of the points where cutters are.
                let point = Vector3::new(x * radius, y * radius, 0.01 + (low - 0.01) * z.powi(3));
                let found = face.holds(point);
                prop_assert_eq!(found, face.holds_by_search(point));
                held.set(held.get() + usize::from(found.is_some()));
                Ok(())
            },
        );
        result.unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(held.get() > 500, "{name}: {}", held.get());
    }
}

/// Points inside leave the face the short way: a step of the depth along it ends on the surface of
/// the part.
#[test]
fn the_short_way_leads_out() {
    for (name, face) in faces() {
        let cutters = face.cutters();
        for cutter in cutters.iter().step_by(5) {
            let point = cutter.tip_m - cutter.normal * 2e-4 - cutter.axis * 1e-4;
            let touch = face.holds(point).unwrap_or_else(|| panic!("{name}: outside"));
            let end = point + touch.out * (touch.depth_m * (1.0 + 1e-9));
            assert!(face.holds(end).is_none_or(|t| t.part != touch.part), "{name}");
        }
    }
}

/// Invalid numbers are rejected with the reason.
#[test]
fn what_makes_no_bit() {
    let refused = |bit: PdcBit| bit.face().expect_err("no bit");
    let error = refused(PdcBit { back_rake_rad: f64::NAN, ..pdc() });
    assert!(error.to_string().contains("back rake is NaN, expected 0 to 0.75 rad"));
    let error = refused(PdcBit { nose_radius_m: 0.07, shoulder_radius_m: 0.08, ..pdc() });
    assert!(matches!(error, FaceError::Profile { .. }), "{error}");
    let error = refused(PdcBit { cutters_per_track: 4, ..pdc() });
    assert!(matches!(error, FaceError::Unspread { .. }), "{error}");
    let error = refused(PdcBit { cutters_per_blade: 8, ..pdc() });
    assert!(matches!(error, FaceError::Overlap { .. }), "{error}");
    // Blades that are alike leave rings between their cutters, the first next to the axis.
    let error = refused(PdcBit { cutters_per_track: 6, ..pdc() });
    let FaceError::UncutRing { from_m, to_m } = error else { panic!("{error}") };
    assert!(to_m > from_m && to_m < 0.1);
    // Rows wider apart than their inserts.
    let error = InsertBit { rows: 6, ..InsertBit::for_diameter(0.2159) }.face();
    assert!(matches!(error, Err(FaceError::UncutRing { .. })));
}
