//! The hole between the surface and the first station, and stations above the wellhead.

use wholestring::well::{Path, Station};
use wholestring_units::{Dimension, UnitSet};

use super::{
    doubts::StationDoubt,
    places::{degrees, depth},
};

/// Largest inclination at the first station with which the straight hole above it may replace a
/// build from the vertical, rad: the straight line is then 0.4 % shorter in depth than the vertical.
const NEARLY_VERTICAL_RAD: f64 = 5.0 * std::f64::consts::PI / 180.0;

/// Tolerance of the position of the first station on a straight line from the wellhead: in m, and
/// as a part of its measured depth.
const STRAIGHT_M: f64 = 1.0;
const STRAIGHT: f64 = 0.01;

/// Height above the wellhead from rounding, m.
const ROUNDED_M: f64 = 0.5;

/// Returns the reasons why no hole from the surface goes through a survey, in words: the first
/// station is below the surface and inclined, without a straight line from the wellhead to its
/// position; or a station is above the wellhead.
pub fn surface_doubts(path: &Path, set: UnitSet) -> Vec<StationDoubt> {
    inclined_start(path, set).into_iter().chain(above_wellhead(path, set)).collect()
}

/// The course of the hole above a first station below the surface, as a note: `None` where it is
/// vertical and begins at depth zero.
pub fn straight_start(path: &Path, set: UnitSet) -> Option<String> {
    let first = path.stations().first()?;
    let surface_m = path.at(0.0).position_m.z;
    let is_plain = first.inclination_rad == 0.0 && surface_m.abs() <= ROUNDED_M;
    (first.md_m > 0.0 && !is_plain).then(|| {
        format!(
            "the hole above the first station at {} is straight, inclined by {} deg as there; it \
             begins at a true vertical depth of {}",
            depth(first.md_m, set),
            degrees(first.inclination_rad),
            depth(surface_m, set)
        )
    })
}

fn inclined_start(path: &Path, set: UnitSet) -> Option<StationDoubt> {
    let first = path.stations().first()?;
    if first.md_m <= 0.0 || first.inclination_rad <= NEARLY_VERTICAL_RAD {
        return None;
    }
    let start = path.at(first.md_m);
    let off_m = (start.position_m - start.tangent * first.md_m).norm();
    if off_m <= STRAIGHT_M + STRAIGHT * first.md_m {
        return None;
    }
    let md = depth(first.md_m, set);
    Some(StationDoubt {
        index: 0,
        sentence: format!(
            "the survey begins at {md} with an inclination of {} deg: the hole from the surface to \
             there is not given",
            degrees(first.inclination_rad)
        ),
        label: format!("expected a station at 0 {} above it", symbol(set)),
        help: format!(
            "add the stations from the surface down to {md}; for a hole that is straight from the \
             wellhead, the station [0, {}, {}]",
            degrees(first.inclination_rad),
            degrees(first.azimuth_rad)
        ),
    })
}

fn above_wellhead(path: &Path, set: UnitSet) -> Option<StationDoubt> {
    // Depths of a survey may count from sea level.
    let wellhead_m = path.at(0.0_f64.min(path.first_md_m())).position_m.z;
    let above_m = |station: &Station| wellhead_m - path.at(station.md_m).position_m.z;
    let stations = path.stations();
    let index = stations.iter().position(|station| above_m(station) > ROUNDED_M)?;
    let highest = stations.iter().max_by(|a, b| above_m(a).total_cmp(&above_m(b)))?;
    let station = &stations[index];
    Some(StationDoubt {
        index,
        sentence: format!(
            "the hole comes out of the ground: it is {} above the wellhead at {}",
            depth(above_m(highest), set),
            depth(highest.md_m, set)
        ),
        label: format!(
            "{} above the wellhead, with an inclination of {} deg",
            depth(above_m(station), set),
            degrees(station.inclination_rad)
        ),
        help: "a hole inclined by more than 90 deg goes up: is an inclination, a depth or the \
               tie-in wrong?"
            .to_owned(),
    })
}

fn symbol(set: UnitSet) -> &'static str {
    Dimension::Length.unit_in(set).symbol
}
