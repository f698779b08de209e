//! The hole's wall along its depth: its radius, without steps, and its axis.

use crate::well::{Hole, HoleSection, Path, PathPoint, Relief, Roughness};

/// Change of radius with depth in the cone that a step in diameter becomes.
const SLOPE: f64 = 0.01;

/// Longest way over which a smooth wall is known well enough from one of its points, m. The path is
/// then known to the third order in it: for a dogleg that changes by 3 deg/30 m within 30 m, to
/// 2e-9 m.
const REACH_M: f64 = 0.05;

/// Part of a wave that may be lost on the way from one point to the next. It sets the ways over
/// which a rough wall is known from one of its points: the radius to second order, `(k z)²/2` of a
/// wave; the axis to third, `(k z)³/6`.
const LOST: f64 = 1e-4;

/// The hole as the string feels it while it moves along: sections joined by cones, rough or smooth.
///
/// A tool joint that slides over the casing shoe climbs a chamfer in a real hole; in a model a step
/// would push it out with an unphysical blow. Each step becomes a cone of slope 1:100, centred on
/// it; where a section is shorter than its cones, they add up and the radius stays continuous.
#[derive(Debug, Clone)]
pub struct Bore {
    hole: Hole,
    relief: Option<Relief>,
}

/// The wall at one depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BorePoint {
    /// The hole's axis: the path's, but for micro-tortuosity.
    pub axis: PathPoint,
    /// Radius of the hole, m.
    pub radius_m: f64,
    /// Increase of the radius per metre of depth.
    pub slope: f64,
}

impl Bore {
    /// The bore of `hole`.
    pub fn new(hole: &Hole) -> Self {
        let rough = |r: &&Roughness| r.radius_rms_m > 0.0 || r.tortuosity_rms_m > 0.0;
        Self { hole: hole.clone(), relief: hole.roughness().filter(rough).map(Relief::new) }
    }

    /// Takes the friction of another hole, which is the same but for it.
    pub fn set_friction_of(&mut self, hole: Hole) {
        self.hole = hole;
    }

    /// The section at a measured depth.
    pub fn section(&self, md_m: f64) -> &HoleSection {
        self.hole.at(md_m)
    }

    /// Whether the radius changes along the hole other than in cones.
    pub fn undulates(&self) -> bool {
        self.relief.is_some() && self.hole.roughness().is_some_and(|r| r.radius_rms_m > 0.0)
    }

    /// Longest way along the hole over which the wall is known well enough from one of its points,
    /// m.
    pub fn reach_m(&self) -> f64 {
        let Some(roughness) = self.hole.roughness().filter(|_| self.relief.is_some()) else {
            return REACH_M;
        };
        let turn = if self.undulates() { (2.0 * LOST).sqrt() } else { libm::cbrt(6.0 * LOST) };
        REACH_M.min(turn * roughness.shortest_m / std::f64::consts::TAU)
    }

    /// The wall at a measured depth of the hole along `path`.
    pub fn at(&self, path: &Path, md_m: f64) -> BorePoint {
        let axis = path.at(md_m);
        let [radius_m, slope] = self.smooth(md_m);
        let Some(relief) = &self.relief else {
            return BorePoint { axis, radius_m, slope };
        };
        let relief = relief.at(md_m).scaled(self.share(md_m));
        BorePoint {
            axis: shifted(&axis, relief.offset),
            radius_m: radius_m + relief.radius[0],
            slope: slope + relief.radius[1],
        }
    }

    /// Radius of the smooth hole at a measured depth, m. Above its first section and below its last
    /// the hole continues as it begins and ends.
    pub fn smooth_radius_m(&self, md_m: f64) -> f64 {
        self.smooth(md_m)[0]
    }

    /// Radius of the smooth hole, m, and its increase per metre.
    fn smooth(&self, md_m: f64) -> [f64; 2] {
        let sections = self.hole.sections();
        let mut radius = 0.5 * sections[0].diameter_m;
        let mut slope = 0.0;
        for pair in sections.windows(2) {
            let change = 0.5 * (pair[1].diameter_m - pair[0].diameter_m);
            let half_width = 0.5 * change.abs() / SLOPE;
            let from_step = md_m - pair[0].to_md_m;
            radius += if from_step >= half_width {
                change
            } else if from_step <= -half_width {
                0.0
            } else {
                slope += SLOPE.copysign(change);
                change * 0.5 * (1.0 + from_step / half_width)
            };
        }
        [radius, slope]
    }

    /// Factor of the roughness at a measured depth, and its first two derivatives: zero above the
    /// hole, each section's own in it. It changes between sections over the shortest wavelength.
    fn share(&self, md_m: f64) -> [f64; 3] {
        let sections = self.hole.sections();
        let width = self.hole.roughness().map_or(1.0, |r| r.shortest_m);
        let top = &sections[0];
        let mut share = [0.0; 3];
        let mut add = |change: f64, from: f64| {
            if change != 0.0 {
                let step = smooth_step((md_m - from) / width);
                share[0] += change * step[0];
                share[1] += change * step[1] / width;
                share[2] += change * step[2] / (width * width);
            }
        };
        add(top.roughness, top.from_md_m);
        for pair in sections.windows(2) {
            let change = pair[1].roughness - pair[0].roughness;
            add(change, pair[0].to_md_m - 0.5 * width);
        }
        share
    }
}

/// From 0 at 0 to 1 at 1 with two continuous derivatives, and these: `6x⁵ − 15x⁴ + 10x³`.
fn smooth_step(x: f64) -> [f64; 3] {
    if x <= 0.0 {
        [0.0; 3]
    } else if x >= 1.0 {
        [1.0, 0.0, 0.0]
    } else {
        let y = x * (1.0 - x);
        [x * x * x * (10.0 + x * (6.0 * x - 15.0)), 30.0 * y * y, 60.0 * y * (1.0 - 2.0 * x)]
    }
}

/// A point of the path, moved by the component across the path of an offset, which is given with
/// its first two derivatives along it.
///
/// `δ = g − (g·t) t`. With `t' = κ` its derivatives are `δ' = g' − (g'·t + g·κ) t − (g·t) κ` and,
/// but for terms in `κ'` and `κ²`, `δ'' = g'' − (g''·t + 2 g'·κ) t − 2 (g'·t) κ`: the terms left
/// out bend the axis by 1e-7 1/m where the path's dogleg changes by 3 deg/30 m within 30 m and the
/// offset is 2 mm.
fn shifted(point: &PathPoint, [g, g1, g2]: [nalgebra::Vector3<f64>; 3]) -> PathPoint {
    let (t, kappa) = (point.tangent, point.curvature_per_m);
    let along = g.dot(&t);
    let tilt = g1 - t * (g1.dot(&t) + g.dot(&kappa)) - kappa * along;
    let bend = g2 - t * (g2.dot(&t) + 2.0 * g1.dot(&kappa)) - kappa * (2.0 * g1.dot(&t));
    let direction = t + tilt;
    let tangent = direction.normalize();
    let turn = (kappa + bend) / direction.norm_squared();
    PathPoint {
        position_m: point.position_m + g - t * along,
        tangent,
        curvature_per_m: turn - tangent * turn.dot(&tangent),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::well::{Friction, HoleKind};

    #[test]
    fn a_step_becomes_a_cone() {
        let section = |from_md_m, to_md_m, diameter_m| HoleSection {
            kind: HoleKind::Casing,
            from_md_m,
            to_md_m,
            diameter_m,
            friction: Friction::uniform(0.3),
            youngs_modulus_Pa: 210e9,
            poisson_ratio: 0.3,
            roughness: 1.0,
            casing: None,
        };
        let hole = Hole::new(vec![section(0.0, 100.0, 0.3), section(100.0, 200.0, 0.2)]).unwrap();
        let bore = Bore::new(&hole);
        assert_eq!(bore.smooth_radius_m(-1.0), 0.15);
        assert_eq!(bore.smooth_radius_m(50.0), 0.15);
        assert!((bore.smooth_radius_m(150.0) - 0.1).abs() < 1e-15);
        assert!((bore.smooth_radius_m(100.0) - 0.125).abs() < 1e-12);
        // 5 cm of radius at 1:100 take 5 m.
        assert!((bore.smooth_radius_m(98.0) - 0.145).abs() < 1e-12);
        assert_eq!(bore.smooth_radius_m(97.4), 0.15);
    }
}
