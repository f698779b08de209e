//! Accuracy of the C2 curve: its integration against independent quadrature, its shape against
//! curves that are known.

use nalgebra::Vector3;
use wholestring::well::Path;

use crate::surveys::{
    circle, integral, iscwsa, kick_off_at_300_m, minimum_curvature, smooth_direction, smooth_well,
    spline, stations,
};

fn paths() -> Vec<(String, Path)> {
    let mut paths: Vec<_> =
        iscwsa().into_iter().map(|(name, well)| (name, spline(&stations(&well)))).collect();
    paths.push(("kick-off".into(), spline(&kick_off_at_300_m())));
    paths.push(("smooth, sparse".into(), spline(&smooth_well(4))));
    paths.push(("circle in one interval".into(), spline(&circle(2, 900.0, 2.0 / 900.0))));
    paths
}

/// Positions are the integral of the unit tangent. Simpson's rule between stations and transitions,
/// where the integrand is smooth; halving its step changes the sum by less than 1e-10 m.
#[test]
fn positions_are_the_integral_of_directions() {
    for (name, path) in paths() {
        let mut sum = Vector3::zeros();
        let start = path.at(path.first_md_m()).position_m;
        for pair in path.stations().windows(2) {
            let length_m = pair[1].md_m - pair[0].md_m;
            for (from, to) in [(0.0, 1.0 / 6.0), (1.0 / 6.0, 5.0 / 6.0), (5.0 / 6.0, 1.0)] {
                let (from, to) = (pair[0].md_m + from * length_m, pair[0].md_m + to * length_m);
                let intervals = ((to - from) / 0.5).ceil() as usize;
                sum += integral(|md_m| path.at(md_m).tangent, from, to, intervals);
                let error = (path.at(to).position_m - start - sum).norm();
                assert!(error < 1e-9, "{name}, MD {to}: {error}");
            }
        }
    }
}

/// Measured depth is the length of the curve: inscribed polygons with steps `d` and `2d`,
/// extrapolated (the deficit of a polygon is of order d²).
#[test]
fn measured_depth_is_the_arc_length() {
    let length = |path: &Path, from: f64, to: f64, steps: usize| -> f64 {
        let at = |step: usize| path.at(from + (to - from) * step as f64 / steps as f64).position_m;
        (0..steps).map(|step| (at(step + 1) - at(step)).norm()).sum()
    };
    for (name, path) in paths() {
        let (mut total, mut last) = (0.0, path.first_md_m());
        for pair in path.stations().windows(2) {
            // Twelve steps put a corner on each end of the transitions.
            let steps = 12 * ((pair[1].md_m - pair[0].md_m) / 12.0).ceil() as usize;
            let coarse = length(&path, pair[0].md_m, pair[1].md_m, steps);
            let fine = length(&path, pair[0].md_m, pair[1].md_m, 2 * steps);
            total += fine + (fine - coarse) / 3.0;
            last = pair[1].md_m;
        }
        let error = total - (last - path.first_md_m());
        assert!(error.abs() < 1e-9, "{name}: {error} m over {last} m");
    }
}

/// The curvature vector is the derivative of the direction: central differences over 0.2 mm, away
/// from the ends of transitions.
#[test]
fn curvature_is_the_derivative_of_direction() {
    for (name, path) in paths() {
        for pair in path.stations().windows(2) {
            for share in [0.03, 0.11, 0.3, 0.5, 0.71, 0.9, 0.97] {
                let md_m = pair[0].md_m + share * (pair[1].md_m - pair[0].md_m);
                let slope = (path.at(md_m + 1e-4).tangent - path.at(md_m - 1e-4).tangent) / 2e-4;
                let error = (slope - path.at(md_m).curvature_per_m).norm();
                // The MD's own rounding at 3000 m moves the difference by 2e-9 of itself.
                assert!(error < 1e-10, "{name}, MD {md_m}: {error}");
            }
        }
    }
}

/// Through stations on a circle the curve is that circle, but for the first and last interval,
/// where the curvature has to rise from that of the straight continuation. With spacing `h` its
/// profile there (from 0 to 1.1 κ in the first sixth, down to κ in the last) turns late:
/// integrated, the curve is κh²/27 off the circle after it, except for terms of order (κh)² of
/// that.
#[test]
fn a_circle_is_a_circle() {
    let curvature = 1e-3;
    for count in [25_usize, 49, 97] {
        let spacing_m = 720.0 / (count - 1) as f64;
        let survey = circle(count, spacing_m, curvature);
        let path = spline(&survey);
        let exact = minimum_curvature(&survey);
        let (from, to) = (survey[1].md_m, survey[count - 2].md_m);
        let offset = path.at(from).position_m - exact.at(from).position_m;
        for part in 0..=1000 {
            let md_m = from + (to - from) * f64::from(part) / 1000.0;
            let (point, circle) = (path.at(md_m), exact.at(md_m));
            assert!((point.position_m - circle.position_m - offset).norm() < 1e-10);
            assert!((point.tangent - circle.tangent).norm() < 1e-13);
            assert!((point.curvature_per_m - circle.curvature_per_m).norm() < 1e-13);
        }
        let predicted = curvature * spacing_m.powi(2) / 27.0;
        let error = offset.norm() / predicted - 1.0;
        assert!(error.abs() < (curvature * spacing_m).powi(2), "{error}");
    }
}

/// Through stations of a smooth well both curves approach it, and each other, with the square of
/// the spacing.
#[test]
fn second_order_on_a_smooth_well() {
    let mut errors = Vec::new();
    for intervals in [20, 40, 80, 160] {
        let survey = smooth_well(intervals);
        let (curve, arcs) = (spline(&survey), minimum_curvature(&survey));
        let mut worst = [0.0_f64; 3];
        for md_m in [300.0, 600.0, 900.0, 1200.0] {
            let exact = integral(smooth_direction, 0.0, md_m, 2000);
            let (curve, arcs) = (curve.at(md_m).position_m, arcs.at(md_m).position_m);
            for (worst, error) in worst.iter_mut().zip([curve - exact, arcs - exact, curve - arcs])
            {
                *worst = worst.max(error.norm());
            }
        }
        errors.push(worst);
    }
    for pair in errors.windows(2) {
        for (coarse, fine) in pair[0].iter().zip(&pair[1]) {
            let order = (coarse / fine).log2();
            assert!((order - 2.0).abs() < 0.1, "order {order} from {errors:?}");
        }
    }
}
