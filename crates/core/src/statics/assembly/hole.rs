//! The same assembly in a hole of another inclination.

use std::f64::consts::PI;

use crate::{
    model::Model,
    operation::Operation,
    well::{Hole, HoleSection, Interpolation, Path, PathError, Station, TieIn, Well},
};

/// Part of the hole that may build, and the shortest stretch that does, m.
const MOST: f64 = 0.9;
const LEAST_M: f64 = 1e-3;

/// The same string in a hole that has one inclination at the bit, rad, and builds at a constant
/// rate to there over a length, rad/m and m, or from the vertical; straight above. It is as wide
/// and as slippery as the hole at the bit is, and goes the same way.
///
/// # Errors
/// Numbers that are not finite, or an inclination outside 0 to π.
pub fn in_straight_hole(
    model: &Model,
    operation: &Operation,
    inclination_rad: f64,
    (build_rad_per_m, over_m): (f64, f64),
) -> Result<Model, PathError> {
    let bit_m = operation.bit_depth_m;
    let azimuth_rad = model.well.path.at(bit_m).azimuth_rad();
    // No farther up than where the hole is vertical.
    let vertical_rad = if build_rad_per_m > 0.0 { 0.0 } else { PI };
    let room_m = match build_rad_per_m {
        0.0 => f64::INFINITY,
        rate => (inclination_rad - vertical_rad) / rate,
    };
    let over_m = over_m.min(room_m).min(MOST * bit_m);
    let above_rad = (inclination_rad - build_rad_per_m * over_m).clamp(0.0, PI);
    let station = |md_m: f64, inclination_rad: f64| Station { md_m, inclination_rad, azimuth_rad };
    let mut stations = vec![station(0.0, above_rad)];
    if over_m > LEAST_M {
        stations.push(station(bit_m - over_m, above_rad));
    }
    stations.push(station(bit_m, inclination_rad));
    let path = Path::new(&stations, Interpolation::MinimumCurvature, TieIn::default())?;
    let at_bit = *model.well.hole.at(bit_m);
    let section = HoleSection { from_md_m: 0.0, to_md_m: bit_m, ..at_bit };
    // Already checked with the case.
    let hole = Hole::new(vec![section]).unwrap_or_else(|_| model.well.hole.clone());
    Ok(Model { well: Well { path, hole }, ..model.clone() })
}
