//! Surveys that make no path, and depths that are no depth.

use wholestring::well::{Interpolation, Path, Station, TieIn};

use crate::surveys::{spline, station};

fn message(survey: &[Station]) -> String {
    Path::new(survey, Interpolation::Spline, TieIn::default()).unwrap_err().to_string()
}

#[test]
fn says_which_station_and_why() {
    let good = station(0.0, 0.0, 0.0);
    assert_eq!(message(&[]), "a path needs at least two survey stations, got 0");
    assert_eq!(message(&[good]), "a path needs at least two survey stations, got 1");
    assert_eq!(
        message(&[good, station(30.0, f64::NAN, 0.0)]),
        "the station at 30 m: inclination is not a finite number"
    );
    assert_eq!(
        message(&[good, station(30.0, 0.0, f64::INFINITY)]),
        "the station at 30 m: azimuth is not a finite number"
    );
    assert_eq!(
        message(&[good, station(f64::NAN, 0.0, 0.0)]),
        "the station at NaN m: measured depth is not a finite number"
    );
    assert_eq!(
        message(&[good, station(30.0, 1.0, 0.0), station(30.0, 2.0, 0.0)]),
        "the station at 30 m: measured depth must grow, but the station above is at 30 m"
    );
    assert_eq!(
        message(&[good, station(30.0, -0.5, 0.0)]),
        "the station at 30 m: inclination -0.5000 deg is not between 0 and 180 deg"
    );
    assert_eq!(
        message(&[good, station(30.0, 181.0, 0.0)]),
        "the station at 30 m: inclination 181.0000 deg is not between 0 and 180 deg"
    );
    assert_eq!(
        message(&[station(0.0, 90.0, 10.0), station(30.0, 90.0, 190.0)]),
        "the station at 30 m: the hole turns by 180 deg from the station above at 0 m"
    );
    let tie_in = TieIn { tvd_m: f64::NAN, ..TieIn::default() };
    let error = Path::new(&[good, station(30.0, 0.0, 0.0)], Interpolation::Spline, tie_in);
    assert_eq!(error.unwrap_err().to_string(), "the tie-in position is not finite");
}

/// Questions without an answer get NaN or a far point, never a panic.
#[test]
fn any_depth_may_be_asked_for() {
    let path = spline(&[station(0.0, 0.0, 0.0), station(30.0, 3.0, 0.0)]);
    for md_m in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e308, -1e308] {
        let _ = path.at(md_m);
        let _ = path.high_side_at(md_m);
    }
    assert!(path.at(f64::NAN).position_m.x.is_nan());
}
