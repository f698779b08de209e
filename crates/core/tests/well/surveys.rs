//! Surveys that several tests use.

use std::{fs, path::PathBuf};

use nalgebra::{Rotation3, Vector3};
use wholestring::well::{Interpolation, Path, Station, TieIn};

/// A published station with the position that goes with it.
pub(crate) struct Surveyed {
    pub(crate) station: Station,
    pub(crate) position_m: Vector3<f64>,
}

pub(crate) fn station(md_m: f64, inclination_deg: f64, azimuth_deg: f64) -> Station {
    Station {
        md_m,
        inclination_rad: inclination_deg.to_radians(),
        azimuth_rad: azimuth_deg.to_radians(),
    }
}

/// The station at `md_m` of a hole that points along `tangent`.
pub(crate) fn station_along(md_m: f64, tangent: &Vector3<f64>) -> Station {
    Station {
        md_m,
        inclination_rad: tangent.x.hypot(tangent.y).atan2(tangent.z),
        azimuth_rad: tangent.y.atan2(tangent.x),
    }
}

pub(crate) fn spline(stations: &[Station]) -> Path {
    Path::new(stations, Interpolation::Spline, TieIn::default()).unwrap()
}

pub(crate) fn minimum_curvature(stations: &[Station]) -> Path {
    Path::new(stations, Interpolation::MinimumCurvature, TieIn::default()).unwrap()
}

pub(crate) fn stations(wells: &[Surveyed]) -> Vec<Station> {
    wells.iter().map(|row| row.station).collect()
}

pub(crate) fn tie_in(first: &Surveyed) -> TieIn {
    TieIn { north_m: first.position_m.x, east_m: first.position_m.y, tvd_m: first.position_m.z }
}

/// The twelve ISCWSA standard wellpaths with their published positions, rounded to 0.005 m.
pub(crate) fn iscwsa() -> Vec<(String, Vec<Surveyed>)> {
    let file = PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("../../verification/B01_iscwsa_standard_wellpaths.csv");
    let mut wells: Vec<(String, Vec<Surveyed>)> = Vec::new();
    for line in fs::read_to_string(file).unwrap().lines().skip(1) {
        let (name, numbers) = line.split_once(',').unwrap();
        let [md, inc, azi, north, east, tvd] = numbers_of(numbers)[..] else {
            panic!("not a station: {line}");
        };
        if wells.last().is_none_or(|well| well.0 != name) {
            wells.push((name.to_owned(), Vec::new()));
        }
        wells.last_mut().unwrap().1.push(Surveyed {
            station: station(md, inc, azi),
            position_m: Vector3::new(north, east, tvd),
        });
    }
    assert_eq!(wells.len(), 12);
    wells
}

/// A survey that is shipped with a case: md, inc, azi in m and deg under one header line.
pub(crate) fn shipped(name: &str) -> Vec<Station> {
    let file = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../cases").join(name);
    let text = fs::read_to_string(file).unwrap();
    let rows = text.lines().skip(1).map(numbers_of);
    rows.map(|row| station(row[0], row[1], row[2])).collect()
}

/// Rows of a file that cannot be shipped, from the folder that WHOLESTRING_EXTRA_DATA names.
pub(crate) fn extra_data(name: &str) -> Option<Vec<Vec<f64>>> {
    let Some(folder) = std::env::var_os("WHOLESTRING_EXTRA_DATA") else {
        println!("skipped: WHOLESTRING_EXTRA_DATA names no folder with {name}");
        return None;
    };
    let text = fs::read_to_string(PathBuf::from(folder).join(name)).unwrap();
    Some(text.lines().skip(1).map(numbers_of).collect())
}

fn numbers_of(line: &str) -> Vec<f64> {
    line.split(',').map(|number| number.trim().parse().unwrap()).collect()
}

/// A well that kicks off at 300 m, builds 3 deg/30 m to 60°, and holds; stations every 30 m.
pub(crate) fn kick_off_at_300_m() -> Vec<Station> {
    (0..=60)
        .map(|index| {
            let md_m = 30.0 * f64::from(index);
            station(md_m, ((md_m - 300.0) / 10.0).clamp(0.0, 60.0), 45.0)
        })
        .collect()
}

/// Stations of a circle: `count` of them `spacing_m` apart, turning at `curvature_per_m` in a plane
/// that is neither vertical nor horizontal.
pub(crate) fn circle(count: usize, spacing_m: f64, curvature_per_m: f64) -> Vec<Station> {
    let tilt = Rotation3::from_euler_angles(0.4, -0.7, 1.1);
    (0..count)
        .map(|index| {
            let md_m = spacing_m * index as f64;
            let (sin, cos) = (curvature_per_m * md_m).sin_cos();
            station_along(md_m, &(tilt * Vector3::new(cos, sin, 0.0)))
        })
        .collect()
}

/// A smooth three-dimensional well with known direction at every depth: a build with a turn, over
/// 1200 m. Returns the direction.
pub(crate) fn smooth_direction(md_m: f64) -> Vector3<f64> {
    let along = md_m / 1200.0;
    let (sin_inc, cos_inc) = (0.2 + 1.1 * along - 0.3 * along * along).sin_cos();
    let (sin_azi, cos_azi) = (0.5 + 0.9 * along * along).sin_cos();
    Vector3::new(sin_inc * cos_azi, sin_inc * sin_azi, cos_inc)
}

/// Stations of [`smooth_direction`].
pub(crate) fn smooth_well(intervals: usize) -> Vec<Station> {
    (0..=intervals)
        .map(|index| {
            let md_m = 1200.0 * index as f64 / intervals as f64;
            station_along(md_m, &smooth_direction(md_m))
        })
        .collect()
}

/// Integral of a vector function, Simpson's rule.
pub(crate) fn integral(
    function: impl Fn(f64) -> Vector3<f64>,
    from: f64,
    to: f64,
    intervals: usize,
) -> Vector3<f64> {
    let step = (to - from) / intervals as f64;
    (0..intervals)
        .map(|index| {
            let (left, right) = (from + step * index as f64, from + step * (index + 1) as f64);
            (function(left) + function(0.5 * (left + right)) * 4.0 + function(right)) * (step / 6.0)
        })
        .sum()
}
