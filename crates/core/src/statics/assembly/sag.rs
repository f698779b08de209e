//! Error of a survey sensor because the string's axis is not the hole's.

use std::f64::consts::PI;

use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use super::axis::AssemblyNode;
use crate::model::Model;

/// Below this inclination an azimuth means little, rad.
const LEAST_INCLINATION_RAD: f64 = PI / 180.0;

/// Sag of the string at a survey sensor.
///
/// The corrections are added to the sensor's measurements: measured + correction = hole.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Sag {
    /// Component that holds the sensor, counted from the bit.
    pub component: usize,
    /// Its name.
    pub name: String,
    /// Distance of the sensor from the bit, m.
    pub from_bit_m: f64,
    /// Its measured depth, m.
    pub md_m: f64,
    /// Inclination of the hole there, rad.
    pub hole_inclination_rad: f64,
    /// Correction of the inclination, rad.
    pub inclination_rad: f64,
    /// Correction of the azimuth, rad; none where the hole is within 1° of the vertical.
    pub azimuth_rad: Option<f64>,
}

/// The sag at every sensor in the solved part.
pub(super) fn sag(model: &Model, nodes: &[AssemblyNode]) -> Vec<Sag> {
    let solved_m = nodes.last().map_or(0.0, |top| top.from_bit_m);
    let sensors = model.string.spans().enumerate().filter_map(|(index, span)| {
        let from_bit_m = span.from_bit_m + span.component.survey_sensor_m?;
        (from_bit_m <= solved_m).then(|| (index, from_bit_m, span.component.name.clone()))
    });
    let at = |(component, from_bit_m, name): (usize, f64, String)| {
        let (md_m, tilt_rad) = between(nodes, from_bit_m);
        let path = &model.well.path;
        let hole = path.at(md_m).tangent;
        let high = path.high_side_of(md_m, &hole);
        let right = hole.cross(&high);
        let [up, aside] = tilt_rad;
        let along = (1.0 - up * up - aside * aside).max(0.0).sqrt();
        let string = hole * along + high * up + right * aside;
        let [hole_inclination_rad, measured_rad] =
            [hole, string].map(|axis| inclination_rad(&axis));
        let azimuth_rad = (hole_inclination_rad > LEAST_INCLINATION_RAD).then(|| {
            let turn = libm::atan2(hole.y, hole.x) - libm::atan2(string.y, string.x);
            (turn + PI).rem_euclid(2.0 * PI) - PI
        });
        Sag {
            component,
            name,
            from_bit_m,
            md_m,
            hole_inclination_rad,
            inclination_rad: hole_inclination_rad - measured_rad,
            azimuth_rad,
        }
    };
    sensors.map(at).collect()
}

fn inclination_rad(axis: &Vector3<f64>) -> f64 {
    libm::atan2(libm::hypot(axis.x, axis.y), axis.z)
}

/// Measured depth, m, and tilt, rad, between two nodes. A bend is at a node, whose tilt is that
/// above it.
fn between(nodes: &[AssemblyNode], from_bit_m: f64) -> (f64, [f64; 2]) {
    let above = nodes.partition_point(|node| node.from_bit_m < from_bit_m);
    let above = above.clamp(1, nodes.len() - 1);
    let (low, high) = (&nodes[above - 1], &nodes[above]);
    let part = (from_bit_m - low.from_bit_m) / (high.from_bit_m - low.from_bit_m);
    let mix = |low: f64, high: f64| low + part * (high - low);
    let tilt_rad = [0, 1].map(|side| mix(low.tilt_rad[side], high.tilt_rad[side]));
    (mix(low.md_m, high.md_m), tilt_rad)
}

// Zeros of a quantity.

/// Zeros of a quantity between points of growing abscissa, by linear interpolation: for example the
/// inclination at which an assembly neither builds nor drops.
pub fn zeros(points: &[(f64, f64)]) -> Vec<f64> {
    let pairs = points.windows(2).filter(|pair| pair[0].1 * pair[1].1 <= 0.0);
    let pairs = pairs.filter(|pair| pair[0].1 != pair[1].1 && pair[1].1 != 0.0);
    pairs
        .map(|pair| {
            let [(x0, y0), (x1, y1)] = [pair[0], pair[1]];
            x0 - y0 * (x1 - x0) / (y1 - y0)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::zeros;

    #[test]
    fn signs_change_where_lines_cross_zero() {
        assert_eq!(zeros(&[(0.0, 2.0), (1.0, -2.0), (3.0, -1.0), (4.0, 1.0)]), [0.5, 3.5]);
        assert_eq!(zeros(&[(0.0, 1.0), (1.0, 2.0)]), [0.0; 0]);
        assert_eq!(zeros(&[(0.0, -1.0), (1.0, 0.0), (2.0, 1.0)]), [1.0]);
    }
}
