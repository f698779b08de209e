//! The same assembly in a hole of another inclination.

use std::f64::consts::PI;

use crate::{
    model::Model,
    operation::Operation,
    well::{Hole, HoleSection, Interpolation, Path, PathError, Station, TieIn, Well},
};

/// The same string in a hole that has one inclination at the bit, rad, and builds at a constant rate
/// to there over a length, rad/m and m; straight above. It is as wide and as slippery as the hole at the bit is,
/// and goes the same way.
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
    let over_m = over_m.clamp(1.0, 0.9 * bit_m);
    let above_rad = (inclination_rad - build_rad_per_m * over_m).clamp(0.0, PI);
    let station = |md_m: f64, inclination_rad: f64| Station { md_m, inclination_rad, azimuth_rad };
    let stations = [
        station(0.0, above_rad),
        station(bit_m - over_m, above_rad),
        station(bit_m, inclination_rad),
    ];
    let path = Path::new(&stations, Interpolation::MinimumCurvature, TieIn::default())?;
    let at_bit = model.well.hole.at(bit_m).clone();
    let section = HoleSection { from_md_m: 0.0, to_md_m: bit_m, ..at_bit };
    // What the case has checked already.
    let hole = Hole::new(vec![section]).unwrap_or_else(|_| model.well.hole.clone());
    Ok(Model { well: Well { path, hole }, ..model.clone() })
}
