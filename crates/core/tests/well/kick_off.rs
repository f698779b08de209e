//! Kick-off and end of build.

use wholestring::well::Station;

use crate::surveys::{
    extra_data, iscwsa, kick_off_at_300_m, minimum_curvature, shipped, spline, station, stations,
};

fn kick_off(survey: &[Station]) -> (Option<f64>, Option<f64>) {
    let path = minimum_curvature(survey);
    (path.kick_off_md_m(), path.build_end_md_m())
}

#[test]
fn constant_build() {
    assert_eq!(kick_off(&kick_off_at_300_m()), (Some(300.0), Some(900.0)));
    assert_eq!(spline(&kick_off_at_300_m()).kick_off_md_m(), Some(300.0));
}

/// The reconstructed well of the article: vertical, an arc of radius R to 65°, a tangent. Its true
/// vertical depth is 322.9 m + R sin 65° + 3230 m cos 65°; the C2 curve's is off by its two
/// transitions, κh²/27 each.
#[test]
fn the_articles_well() {
    let survey = shipped("np13-x1042-survey.csv");
    assert_eq!(kick_off(&survey), (Some(322.9), Some(1075.0)));
    let inclination = 65.0_f64.to_radians();
    let radius_m = 752.1 / inclination;
    let tvd_m = 322.9 + radius_m * inclination.sin() + 3230.0 * inclination.cos();
    let arcs = minimum_curvature(&survey).at(4305.0).position_m;
    assert!((arcs.z - tvd_m).abs() < 1e-8, "{}", arcs.z);
    let departure_m = radius_m * (1.0 - inclination.cos()) + 3230.0 * inclination.sin();
    assert!((arcs.xy().norm() - departure_m).abs() < 1e-8);
    let curve = spline(&survey).at(4305.0).position_m;
    assert!((curve - arcs).norm() < 2.0 * 30.084_f64.powi(2) / radius_m / 27.0);
}

/// The shipped standard wellpath is the published one.
#[test]
fn the_standard_wellpath() {
    let wells = iscwsa();
    let (_, well) = wells.iter().find(|well| well.0 == "04 - well").unwrap();
    assert_eq!(shipped("iscwsa-04-survey.csv"), stations(well));
}

/// Corners less than 25 m below the station above them, as inserted into an even survey, are found
/// exactly too.
#[test]
fn corners_between_even_stations() {
    let mut survey = Vec::new();
    let mut depths: Vec<f64> = (0..60).map(|index| 30.0 * f64::from(index)).collect();
    depths.extend([310.0, 912.0]);
    depths.sort_by(f64::total_cmp);
    for md_m in depths {
        survey.push(station(md_m, (0.1 * (md_m - 310.0)).clamp(0.0, 60.2), 45.0));
    }
    assert_eq!(kick_off(&survey), (Some(310.0), Some(912.0)));
}

/// A plan with its corner points only.
#[test]
fn sparse_plan() {
    let survey = [
        station(0.0, 0.0, 45.0),
        station(322.9, 0.0, 45.0),
        station(1075.0, 65.0, 45.0),
        station(4305.0, 65.0, 45.0),
    ];
    assert_eq!(kick_off(&survey), (Some(322.9), Some(1075.0)));
}

#[test]
fn straight_wells_have_none() {
    assert_eq!(kick_off(&[station(0.0, 0.0, 0.0), station(1500.0, 0.0, 0.0)]), (None, None));
    let slant: Vec<_> = (0..50)
        .map(|index| {
            let wander = f64::from(index).sin();
            station(30.0 * f64::from(index), 45.0 + 0.5 * wander, 90.0 + 0.7 * wander)
        })
        .collect();
    assert_eq!(kick_off(&slant), (None, None));
}

/// A hole that begins inclined and turns without building has a kick-off and no build.
#[test]
fn turn_without_build() {
    let survey = [
        station(0.0, 30.0, 0.0),
        station(300.0, 30.0, 0.0),
        station(600.0, 30.0, 60.0),
        station(900.0, 30.0, 60.0),
    ];
    assert_eq!(kick_off(&survey), (Some(300.0), None));
}

/// The build may last to the end of the survey.
#[test]
fn build_to_the_end() {
    let survey: Vec<_> = (0..=30)
        .map(|index| station(30.0 * f64::from(index), 3.0 * f64::from(index), 0.0))
        .collect();
    assert_eq!(kick_off(&survey), (Some(0.0), Some(900.0)));
}

/// The same well with the scatter of a real survey (0.3° and more, in inclination and azimuth) and
/// a tangent that wanders: within one interval of the smooth one's.
#[test]
fn scatter_does_not_move_them_far() {
    let mut state = 42_u64;
    let mut random = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    for _ in 0..200 {
        let survey: Vec<_> = kick_off_at_300_m()
            .into_iter()
            .map(|smooth| {
                let inclination = smooth.inclination_rad.to_degrees() + 0.3 * random();
                // A nearly vertical hole's azimuth is anything.
                let spread = if smooth.inclination_rad < 0.02 { 180.0 } else { 1.0 };
                station(smooth.md_m, inclination.abs(), 45.0 + spread * random())
            })
            .collect();
        let (kick_off, build_end) = kick_off(&survey);
        assert!((kick_off.unwrap() - 300.0).abs() <= 30.0, "{kick_off:?}");
        assert!((build_end.unwrap() - 900.0).abs() <= 30.0, "{build_end:?}");
    }
}

/// Read off the published surveys' own columns: where the inclination leaves zero, and where it
/// stops growing. Well 10 builds twice, with a turn at nearly constant inclination from 1320 m.
#[test]
fn iscwsa_standard_wellpaths() {
    let build = |from: f64, to: f64| (Some(from), Some(to));
    let expected = [
        ("Reference well", build(990.0, 2280.0)),
        ("01 - well", build(990.0, 2280.0)),
        ("02 - well", build(990.0, 2430.0)),
        ("03 - well", build(990.0, 2310.0)),
        ("04 - well", build(990.0, 2370.0)),
        ("05 - well", build(990.0, 2160.0)),
        ("06 - well", build(990.0, 2280.0)),
        ("07 - well", build(990.0, 2280.0)),
        ("08 - well", build(990.0, 1710.0)),
        ("09 - well", (None, None)),
        ("10 - well", build(900.0, 1320.0)),
        ("11 - well", build(1020.0, 2400.0)),
    ];
    for ((name, well), (expected_name, expected)) in iscwsa().iter().zip(expected) {
        assert_eq!(name, expected_name);
        assert_eq!(kick_off(&stations(well)), expected, "{name}");
    }
}

/// A real survey: 1.2° at 188.6 m, then a steady build to 31.3° at 705.7 m, which then stays.
#[test]
fn real_survey() {
    let Some(rows) = extra_data("B02_wellpathpy_deviation.csv") else {
        return;
    };
    let survey: Vec<_> = rows.iter().map(|row| station(row[0], row[1], row[2])).collect();
    assert_eq!(kick_off(&survey), (Some(188.6), Some(705.7)));
}
