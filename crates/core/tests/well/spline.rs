//! The shape of the C2 curve: through the survey, straight where it is straight, no overshoot,
//! continuous curvature.

use nalgebra::{Rotation3, Vector3};
use proptest::prelude::*;
use wholestring::well::{Interpolation, Path, Station, TieIn};

use crate::surveys::{
    iscwsa, kick_off_at_300_m, minimum_curvature, smooth_well, spline, station, station_along,
    stations,
};

/// Every shipped survey and some that are hard on a curve.
fn surveys() -> Vec<(String, Vec<Station>)> {
    let mut surveys: Vec<_> =
        iscwsa().into_iter().map(|(name, well)| (name, stations(&well))).collect();
    let mut add = |name: &str, survey: Vec<Station>| surveys.push((name.to_owned(), survey));
    add("kick-off", kick_off_at_300_m());
    add("smooth", smooth_well(40));
    add(
        "one curved interval between straight ones",
        vec![
            station(0.0, 0.0, 0.0),
            station(300.0, 0.0, 0.0),
            station(330.0, 3.0, 0.0),
            station(400.0, 3.0, 0.0),
        ],
    );
    add(
        "a sparse plan",
        vec![
            station(0.0, 0.0, 45.0),
            station(320.0, 0.0, 45.0),
            station(1075.0, 90.0, 45.0),
            station(2000.0, 90.0, 160.0),
            station(2500.0, 90.0, 160.0),
        ],
    );
    add(
        "through the vertical",
        vec![
            station(0.0, 2.0, 30.0),
            station(30.0, 2.0, 30.0),
            station(60.0, 0.0, 0.0),
            station(90.0, 2.0, 210.0),
            station(120.0, 4.0, 210.0),
            station(150.0, 4.0, 30.0),
            station(180.0, 4.0, 30.0),
        ],
    );
    add(
        "zigzag",
        (0..40)
            .map(|index| {
                let index = f64::from(index);
                station(10.0 * index, 45.0 + (index * 1.7).sin(), 100.0 + (index * 2.3).cos())
            })
            .collect(),
    );
    surveys
}

/// Dogleg severity between stations `index` and `index + 1`; zero beyond the survey.
fn interval_severity(survey: &[Station], index: Option<usize>) -> f64 {
    index
        .and_then(|index| survey.get(index).zip(survey.get(index + 1)))
        .map_or(0.0, |(a, b)| a.dogleg_rad(b) / (b.md_m - a.md_m))
}

fn worst_overshoot(survey: &[Station]) -> f64 {
    let path = spline(survey);
    let mut worst: f64 = 0.0;
    for index in 0..survey.len() - 1 {
        let limit = [index.checked_sub(1), Some(index), Some(index + 1)]
            .into_iter()
            .map(|index| interval_severity(survey, index))
            .fold(0.0, f64::max);
        let (from, to) = (survey[index].md_m, survey[index + 1].md_m);
        for part in 0..=120 {
            let md_m = from + (to - from) * f64::from(part) / 120.0;
            let severity = path.dogleg_severity_rad_per_m(md_m);
            // Straight to rounding is straight.
            if severity > 1e-15 {
                worst = worst.max(severity / limit);
            }
        }
    }
    worst
}

#[test]
fn takes_the_surveys_directions() {
    for (name, survey) in surveys() {
        let path = spline(&survey);
        for station in &survey {
            let error = (path.at(station.md_m).tangent - station.tangent()).norm();
            assert!(error < 1e-14, "{name}, MD {}: {error}", station.md_m);
        }
    }
}

/// The bound is a theorem (see `well/curve.rs`): the allowance is rounding only.
#[test]
fn no_dogleg_above_1_2_times_its_neighbours() {
    for (name, survey) in surveys() {
        let worst = worst_overshoot(&survey);
        assert!(worst <= 1.2 + 1e-9, "{name}: {worst}");
    }
}

/// One curved interval between straight ones needs all of the 1.2: a flat top of 5/6 of its length.
#[test]
fn lone_dogleg_has_a_flat_top() {
    let survey = [
        station(0.0, 10.0, 0.0),
        station(100.0, 10.0, 0.0),
        station(130.0, 13.0, 0.0),
        station(200.0, 13.0, 0.0),
    ];
    let path = spline(&survey);
    let mean = 3.0_f64.to_radians() / 30.0;
    for (md_m, share) in [(100.0, 0.0), (102.5, 0.6), (105.0, 1.2), (115.0, 1.2), (127.5, 0.6)] {
        let severity = path.dogleg_severity_rad_per_m(md_m);
        assert!((severity / mean - share).abs() < 1e-9, "MD {md_m}: {severity}");
    }
}

#[test]
fn straight_stays_straight() {
    let survey = kick_off_at_300_m();
    let path = spline(&survey);
    for tenth in 0..=3000 {
        let point = path.at(f64::from(tenth) / 10.0);
        assert!(point.position_m.xy().norm() < 1e-9);
        assert!(point.tangent.xy().norm() < 1e-9);
        assert!(point.curvature_per_m.norm() < 1e-9);
    }
    // The hole holds 60° from 900 m on.
    let (from, along) = (path.at(900.0).position_m, station(900.0, 60.0, 45.0).tangent());
    for metre in 900..=2500 {
        let point = path.at(f64::from(metre));
        let straight = from + along * (f64::from(metre) - 900.0);
        assert!((point.position_m - straight).norm() < 1e-9);
        assert!((point.tangent - along).norm() < 1e-9);
        assert!(point.curvature_per_m.norm() < 1e-9);
    }
}

/// A single tangent: one interval, one direction, and a projection ten times as long.
#[test]
fn single_tangent() {
    let survey = [station(100.0, 37.0, 250.0), station(200.0, 37.0, 250.0)];
    let path = spline(&survey);
    let along = survey[0].tangent();
    for md_m in [-50.0, 0.0, 100.0, 133.3, 200.0, 1200.0] {
        let point = path.at(md_m);
        assert!((point.position_m - along * (md_m - 100.0)).norm() < 1e-9);
        assert!((point.tangent - along).norm() < 1e-15);
        assert_eq!(point.curvature_per_m.norm(), 0.0);
    }
}

/// Bound on the slope of the curvature around a station, 1/m²: from 1.2 times the largest dogleg
/// severity around to the opposite of it in a sixth of the shortest interval, and the turning of
/// the vector itself.
fn steepest(survey: &[Station], index: usize) -> f64 {
    let around = index.saturating_sub(2)..(index + 2).min(survey.len() - 1);
    let severity =
        around.clone().map(|near| interval_severity(survey, Some(near))).fold(0.0, f64::max);
    let shortest =
        around.map(|near| survey[near + 1].md_m - survey[near].md_m).fold(f64::INFINITY, f64::min);
    2.4 * severity / (shortest / 6.0) + (1.2 * severity).powi(2)
}

/// Across a station the curvature changes by no more than its slope times the distance probed. The
/// minimum-curvature path jumps however near one probes.
#[test]
fn curvature_is_continuous() {
    for (name, survey) in surveys() {
        let path = spline(&survey);
        for index in 0..survey.len() {
            let md_m = survey[index].md_m;
            let slope = steepest(&survey, index);
            for probe in [1e-2, 1e-4, 1e-6, 1e-8] {
                let jump =
                    path.at(md_m + probe).curvature_per_m - path.at(md_m - probe).curvature_per_m;
                assert!(
                    jump.norm() <= 2.0 * slope * probe + 1e-15,
                    "{name}, MD {md_m}, probe {probe}: {}",
                    jump.norm()
                );
            }
        }
    }
    let path = minimum_curvature(&kick_off_at_300_m());
    let jump = path.at(300.0 + 1e-8).curvature_per_m - path.at(300.0 - 1e-8).curvature_per_m;
    assert!((jump.norm() * 30.0 / 3.0_f64.to_radians() - 1.0).abs() < 1e-6);
}

/// Where the curve changes formula, position, direction and curvature do not jump by more than
/// rounding, once the motion over the 2e-10 m between the two probes is taken off.
#[test]
fn smooth_across_knots() {
    let probe = 1e-10;
    for (name, survey) in surveys() {
        let path = spline(&survey);
        for (index, pair) in survey.windows(2).enumerate() {
            let slope = steepest(&survey, index).max(steepest(&survey, index + 1));
            for share in [0.0, 1.0 / 6.0, 5.0 / 6.0, 1.0] {
                let md_m = pair[0].md_m + share * (pair[1].md_m - pair[0].md_m);
                let (above, below) = (path.at(md_m - probe), path.at(md_m + probe));
                let along = below.tangent * (2.0 * probe);
                let position_m = below.position_m - above.position_m - along;
                let turned = below.curvature_per_m * (2.0 * probe);
                let direction = below.tangent - above.tangent - turned;
                let curvature = below.curvature_per_m - above.curvature_per_m;
                // The probes' own MD, up to 3000 m, is rounded to 5e-13 m, a position's three
                // coordinates likewise.
                assert!(position_m.norm() < 4e-12, "{name}, MD {md_m}: {position_m}");
                assert!(direction.norm() < 1e-12, "{name}, MD {md_m}: {direction}");
                assert!(
                    curvature.norm() < 1e-12 + 2.0 * probe * slope,
                    "{name}, MD {md_m}: {curvature}"
                );
            }
        }
    }
}

/// The curve has no favoured direction: turning the whole survey in space turns the curve, also
/// where that brings the hole through the vertical.
#[test]
fn turning_the_survey_turns_the_curve() {
    for (name, survey) in surveys() {
        let path = spline(&survey);
        for rotation in [
            Rotation3::from_axis_angle(&Vector3::z_axis(), 2.0),
            Rotation3::from_euler_angles(0.3, 1.2, -0.8),
            Rotation3::from_axis_angle(&Vector3::y_axis(), 2.9),
        ] {
            let turned: Vec<_> = survey
                .iter()
                .map(|station| station_along(station.md_m, &(rotation * station.tangent())))
                .collect();
            let turned = spline(&turned);
            for part in 0..=400 {
                let md_m = path.last_md_m() * f64::from(part) / 400.0;
                let (point, other) = (path.at(md_m), turned.at(md_m));
                assert!(
                    (rotation * point.position_m - other.position_m).norm() < 1e-9,
                    "{name}, MD {md_m}"
                );
                assert!(
                    (rotation * point.curvature_per_m - other.curvature_per_m).norm() < 1e-12,
                    "{name}, MD {md_m}"
                );
            }
        }
    }
}

/// Surveyed from the bottom up it is the same hole.
#[test]
fn same_curve_from_below() {
    for (name, survey) in surveys() {
        let path = spline(&survey);
        let last = survey[survey.len() - 1].md_m;
        let reversed: Vec<_> = survey
            .iter()
            .rev()
            .map(|station| station_along(last - station.md_m, &-station.tangent()))
            .collect();
        let reversed = spline(&reversed);
        let bottom = path.at(last).position_m;
        for part in 0..=400 {
            let md_m = path.first_md_m() + (last - path.first_md_m()) * f64::from(part) / 400.0;
            let other = reversed.at(last - md_m).position_m + bottom;
            let error = (path.at(md_m).position_m - other).norm();
            assert!(error < 1e-9, "{name}, MD {md_m}: {error}");
        }
    }
}

/// From 2° one way to 2° the other way in one interval: vertical in the middle, in one plane.
#[test]
fn through_the_vertical_in_one_interval() {
    let survey = [station(0.0, 2.0, 60.0), station(30.0, 2.0, 240.0)];
    let path = spline(&survey);
    assert!(path.at(15.0).inclination_rad() < 1e-15);
    let out_of_plane = Vector3::new(-60.0_f64.to_radians().sin(), 60.0_f64.to_radians().cos(), 0.0);
    for metre in 0..=30 {
        let point = path.at(f64::from(metre));
        assert!(point.position_m.dot(&out_of_plane).abs() < 1e-13);
        assert!(point.tangent.dot(&out_of_plane).abs() < 1e-15);
    }
}

/// A tie-in moves the hole and changes nothing else.
#[test]
fn tie_in_moves_the_hole() {
    let survey: Vec<_> = smooth_well(40)
        .into_iter()
        .map(|station| Station { md_m: station.md_m + 912.5, ..station })
        .collect();
    let tie_in = TieIn { north_m: -1200.25, east_m: 340.5, tvd_m: 905.75 };
    let (moved, path) =
        (Path::new(&survey, Interpolation::Spline, tie_in).unwrap(), spline(&survey));
    let offset = Vector3::new(tie_in.north_m, tie_in.east_m, tie_in.tvd_m);
    assert_eq!(moved.at(912.5).position_m, offset);
    for md_m in [0.0, 500.0, 912.5, 1000.0, 1777.7, 2500.0] {
        let (a, b) = (moved.at(md_m), path.at(md_m));
        assert!((a.position_m - b.position_m - offset).norm() < 1e-9);
        assert_eq!(a.tangent, b.tangent);
    }
    // Above the first station: straight up along its direction.
    let above = moved.at(812.5);
    assert!((above.position_m + survey[0].tangent() * 100.0 - offset).norm() < 1e-9);
}

/// In the middle of an interval the dogleg severity is 0.8 to 1.2 times the interval's own: less
/// than 0.8 only by the cosine of the latitude, which stays below a sixth of the dogleg.
fn keeps_to_its_own_interval(survey: &[Station]) -> bool {
    let path = spline(survey);
    survey.windows(2).all(|pair| {
        let dogleg = pair[0].dogleg_rad(&pair[1]);
        let severity = path.dogleg_severity_rad_per_m(0.5 * (pair[0].md_m + pair[1].md_m));
        let share = severity * (pair[1].md_m - pair[0].md_m) / dogleg;
        dogleg < 1e-12 || (0.8 * (dogleg / 6.0).cos() - 1e-9..1.2 + 1e-9).contains(&share)
    })
}

#[test]
fn a_sharp_neighbour_does_not_bend_a_gentle_interval() {
    for (name, survey) in surveys() {
        assert!(keeps_to_its_own_interval(&survey), "{name}");
    }
}

proptest! {
    /// Whatever the survey, the tangent is a unit vector, the numbers are finite and the dogleg
    /// severity stays within its bound.
    #[test]
    fn any_survey(
        legs in prop::collection::vec(
            (1e-3..300.0_f64, 0.0..=180.0_f64, -720.0..720.0_f64), 2..30
        )
    ) {
        let mut md_m = 0.0;
        let survey: Vec<_> = legs.iter().map(|&(length_m, inclination, azimuth)| {
            md_m += length_m + 1e-3;
            station(md_m, inclination, azimuth)
        }).collect();
        let path = Path::new(&survey, Interpolation::Spline, TieIn::default());
        prop_assume!(path.is_ok());
        let path = path.unwrap();
        for part in 0..=500 {
            let probe_m = md_m * f64::from(part) / 500.0;
            let point = path.at(probe_m);
            prop_assert!((point.tangent.norm() - 1.0).abs() < 1e-14);
            prop_assert!(point.position_m.iter().all(|number| number.is_finite()));
            prop_assert!(point.tangent.dot(&point.curvature_per_m).abs()
                <= 1e-14 * point.curvature_per_m.norm());
            let high = path.high_side_at(probe_m);
            prop_assert!((high.norm() - 1.0).abs() < 1e-12);
            prop_assert!(high.dot(&point.tangent).abs() < 1e-12);
        }
        prop_assert!(worst_overshoot(&survey) <= 1.2 + 1e-9);
        prop_assert!(keeps_to_its_own_interval(&survey));
    }
}
