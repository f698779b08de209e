//! A cutter or an insert, whose tip is on the profile.

use std::f64::consts::TAU;

use nalgebra::Vector3;

use super::{profile::ProfilePoint, revolved::Revolved};

/// A cutter of a drag bit, or an insert, in the bit's frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Cutter {
    /// The blade that carries it, or the row of inserts.
    pub blade: usize,
    /// Point of contact with the profile, m.
    pub tip_m: Vector3<f64>,
    /// Direction of the profile's normal there, into the rock.
    pub normal: Vector3<f64>,
    /// Axis of revolution: out of a cutter's face, or out of the tip of an insert.
    pub axis: Vector3<f64>,
    /// Between the face and the normal of the rock, the edge trailing, rad; zero of an insert.
    pub back_rake_rad: f64,
    /// Of the face about the normal, positive where it pushes cuttings outwards, rad; zero of an
    /// insert.
    pub side_rake_rad: f64,
    /// Origin of the solid's coordinates: the middle of a cutter's face, of an insert's tip sphere.
    pub(super) origin: Vector3<f64>,
    pub(super) solid: Revolved,
    /// Squared half width of the solid, its lowest and highest point along the axis.
    reach: (f64, [f64; 2]),
    /// A direction across the axis, for points on it; of a cutter, from the middle of its face to
    /// its tip.
    pub(super) across: Vector3<f64>,
    /// Lines on its surface: turned about the bit's axis they sweep the cutter's track. Let go once
    /// that is known.
    pub(super) lines: Vec<Vec<Vector3<f64>>>,
}

/// Distance of the first track from the axis as a fraction of the tracks' spacing: near enough for
/// its cutter to cut the axis.
pub(super) const OFF_AXIS: f64 = 0.25;

/// Points of a circle around a cutter. On one of 8 mm the straight lines between them are within
/// 0.3 μm.
const CIRCLE_POINTS: usize = 361;

/// Circles around a cutter, from its edge to its back. Near the bit's axis the back of a cutter,
/// which runs straight, sweeps rings that its edge does not.
const CIRCLES: usize = 13;

/// Shape of a cutter, m.
#[derive(Debug, Clone, Copy)]
pub(super) struct Disc {
    pub radius_m: f64,
    pub length_m: f64,
    pub chamfer_m: f64,
}

/// The directions at an angle about the bit's axis: outwards, and the way that the bit turns.
fn around(angle_rad: f64) -> (Vector3<f64>, Vector3<f64>) {
    let (sin, cos) = libm::sincos(angle_rad);
    (Vector3::new(cos, sin, 0.0), Vector3::new(-sin, cos, 0.0))
}

/// Squared half width, lowest and highest point, with a tolerance for rounding.
fn reach(solid: &Revolved) -> (f64, [f64; 2]) {
    let (rho, [low, high]) = solid.extent();
    (rho * rho * (1.0 + 1e-9), [low - 1e-12, high + 1e-12])
}

impl Cutter {
    /// A disc with its edge on `point` of the profile at an angle about the bit's axis.
    ///
    /// With `t` the way it moves, `s` along the profile outwards and `n` its normal, the face looks
    /// along `f = cos β (cos δ t + sin δ s) + sin β n`, back rake `β`, side rake `δ`, and its tip
    /// is in the direction from its middle `m = cos β n − sin β (cos δ t + sin δ s)`.
    pub(super) fn disc(
        blade: usize,
        point: ProfilePoint,
        angle_rad: f64,
        [back_rake_rad, side_rake_rad]: [f64; 2],
        disc: Disc,
    ) -> Self {
        let (out, ahead) = around(angle_rad);
        let [nr, nz] = point.normal;
        let normal = out * nr + Vector3::z() * nz;
        let outwards = out * nz - Vector3::z() * nr;
        let tip_m = out * point.radius_m + Vector3::z() * point.z_m;
        let (sin, cos) = libm::sincos(back_rake_rad);
        let facing = ahead * libm::cos(side_rake_rad) + outwards * libm::sin(side_rake_rad);
        let axis = facing * cos + normal * sin;
        let across = normal * cos - facing * sin;
        let Disc { radius_m: a, length_m, chamfer_m: ch } = disc;
        let origin = tip_m - across * a + axis * ch;
        let side = axis.cross(&across);
        let circle = |height: f64| {
            (0..CIRCLE_POINTS)
                .map(|i| TAU * i as f64 / (CIRCLE_POINTS - 1) as f64)
                .map(|turn| {
                    origin + axis * height + (across * libm::cos(turn) + side * libm::sin(turn)) * a
                })
                .collect()
        };
        let lines = (0..CIRCLES)
            .map(|i| i as f64 / (CIRCLES - 1) as f64)
            .map(|share| circle(-ch - (length_m - ch) * share))
            .collect();
        let solid = Revolved::new(
            &[[0.0, 0.0], [a - ch, 0.0], [a, -ch], [a, -length_m], [0.0, -length_m]],
            0.0,
        );
        Self {
            blade,
            tip_m,
            normal,
            axis,
            back_rake_rad,
            side_rake_rad,
            origin,
            across,
            lines,
            reach: reach(&solid),
            solid,
        }
    }

    /// A solid normal to the profile, its tip the rounding's radius above the origin. `outline` is
    /// its half section seen from the origin, from the tip on, the rounding included.
    pub(super) fn upright(
        row: usize,
        point: ProfilePoint,
        angle_rad: f64,
        solid: Revolved,
        tip_radius_m: f64,
        outline: &[[f64; 2]],
    ) -> Self {
        let (out, _) = around(angle_rad);
        let [nr, nz] = point.normal;
        let axis = out * nr + Vector3::z() * nz;
        let across = out * nz - Vector3::z() * nr;
        let tip_m = out * point.radius_m + Vector3::z() * point.z_m;
        let origin = tip_m - axis * tip_radius_m;
        let half =
            |sign: f64| move |&[rho, zeta]: &[f64; 2]| origin + axis * zeta + across * (sign * rho);
        let inner = outline.iter().skip(1).rev().map(half(-1.0));
        Self {
            blade: row,
            tip_m,
            normal: axis,
            axis,
            back_rake_rad: 0.0,
            side_rake_rad: 0.0,
            origin,
            across,
            lines: vec![inner.chain(outline.iter().map(half(1.0))).collect()],
            reach: reach(&solid),
            solid,
        }
    }

    /// Distance of a point of the bit's frame from its surface, negative inside, m, and the
    /// direction in which it grows.
    pub fn distance(&self, position_m: Vector3<f64>) -> (f64, Vector3<f64>) {
        let (rho, zeta, out) = self.seen_from(position_m);
        let (distance, [n_rho, n_zeta]) = self.solid.distance(rho, zeta);
        (distance, self.axis * n_zeta + out * n_rho)
    }

    /// Depth of a point inside, m, and the shortest direction out.
    #[inline]
    pub(super) fn depth(&self, position_m: Vector3<f64>) -> Option<(f64, Vector3<f64>)> {
        // Most points are outside: they need no root.
        let from = position_m - self.origin;
        let along = from.dot(&self.axis);
        let (width2, [low, high]) = self.reach;
        if along > high || along < low || from.norm_squared() - along * along > width2 {
            return None;
        }
        let (rho, zeta, out) = self.seen_from(position_m);
        let (depth, [n_rho, n_zeta]) = self.solid.depth(rho, zeta)?;
        Some((depth, self.axis * n_zeta + out * n_rho))
    }

    /// Distance of a point from the axis and along it, and the direction away from it.
    #[inline]
    fn seen_from(&self, position_m: Vector3<f64>) -> (f64, f64, Vector3<f64>) {
        let from = position_m - self.origin;
        let zeta = from.dot(&self.axis);
        let off = from - self.axis * zeta;
        let rho = off.norm();
        let out = if rho > 1e-12 { off / rho } else { self.across };
        (rho, zeta, out)
    }

    /// Corners of a box about it, m.
    pub(super) fn bounds(&self) -> [Vector3<f64>; 2] {
        let (rho, zeta) = self.solid.extent();
        let half = self.axis.map(|a| rho * (1.0 - a * a).max(0.0).sqrt());
        let ends = zeta.map(|z| self.origin + self.axis * z);
        [ends[0].inf(&ends[1]) - half, ends[0].sup(&ends[1]) + half]
    }
}
