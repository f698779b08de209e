//! Body that carries the cutters: blades, or the whole face.

use std::f64::consts::TAU;

use nalgebra::Vector3;

use super::profile::Profile;

/// The bit's body: the region behind the profile by an offset, and gauge pads; for a bladed bit
/// only the part of it within a blade's width behind the cutters.
///
/// The floor between the blades is not there: rock that gets as deep as a blade is high has no
/// place in this model.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Body {
    /// Exposure of the cutters in front of it, m.
    pub offset_m: f64,
    /// Radius of the gauge pads, m.
    pub pad_radius_m: f64,
    pub blades: Option<Blades>,
}

/// Blades at even angles. The front of the first one is at the angle `−lag r`, and the tips of its
/// cutters are above it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Blades {
    pub count: usize,
    pub width_m: f64,
    /// Angle by which a blade trails per metre of radius, rad/m.
    pub lag_rad_per_m: f64,
}

impl Blades {
    /// Angle of the front of a blade at a radius, rad.
    pub(super) fn front_rad(&self, blade: usize, radius_m: f64) -> f64 {
        TAU * blade as f64 / self.count as f64 - self.lag_rad_per_m * radius_m
    }

    /// Depth below the front or the back of the nearest blade, m, with the shortest direction out;
    /// nothing where the blades have merged; `None` outside a blade. Exact for straight blades; of
    /// curved ones to the first order.
    fn depth(&self, radius_m: f64, angle_rad: f64) -> Option<Option<(f64, [f64; 2])>> {
        let pitch = TAU / self.count as f64;
        if self.width_m >= radius_m * pitch {
            return Some(None);
        }
        let behind = (self.front_rad(0, radius_m) - angle_rad).rem_euclid(pitch);
        let left = self.width_m - radius_m * behind;
        if left <= 0.0 {
            return None;
        }
        // Gradient of the way behind the front, r (θ_k(r) − θ): outwards, and the way that the bit
        // turns.
        let turn = self.lag_rad_per_m * radius_m;
        let front = 1.0 / libm::hypot(turn, 1.0);
        let back = 1.0 / libm::hypot(behind - turn, 1.0);
        let (ahead, astern) = (radius_m * behind * front, left * back);
        Some(Some(if ahead <= astern {
            (ahead, [turn * front, front])
        } else {
            (astern, [(behind - turn) * back, -back])
        }))
    }
}

impl Body {
    /// Distance from the body of revolution in the plane of radius and depth, negative inside, m,
    /// and the direction in which it grows.
    pub(super) fn distance(&self, profile: &Profile, radius_m: f64, z_m: f64) -> (f64, [f64; 2]) {
        let (distance, normal) = profile.distance(radius_m, z_m);
        let face = (distance + self.offset_m, normal);
        let (wall, floor) = (radius_m - self.pad_radius_m, z_m - profile.gauge_z_m());
        let pad = if wall > floor { (wall, [1.0, 0.0]) } else { (floor, [0.0, 1.0]) };
        if face.0 <= pad.0 { face } else { pad }
    }

    /// Depth of a point of the bit's frame inside the body, m, and the shortest direction out.
    pub(super) fn depth(
        &self,
        profile: &Profile,
        position_m: Vector3<f64>,
    ) -> Option<(f64, Vector3<f64>)> {
        let radius_m = position_m.xy().norm();
        let (distance, [n_r, n_z]) = self.distance(profile, radius_m, position_m.z);
        if distance >= 0.0 || position_m.z < profile.top_z_m() {
            return None;
        }
        let out = if radius_m > 0.0 {
            Vector3::new(position_m.x / radius_m, position_m.y / radius_m, 0.0)
        } else {
            Vector3::x()
        };
        let below = (-distance, out * n_r + Vector3::z() * n_z);
        let Some(blades) = &self.blades else {
            return Some(below);
        };
        let beside = blades.depth(radius_m, libm::atan2(position_m.y, position_m.x))?;
        Some(match beside {
            Some((depth, [n_r, n_t])) if depth < below.0 => {
                (depth, out * n_r + Vector3::new(-out.y, out.x, 0.0) * n_t)
            }
            _ => below,
        })
    }
}
