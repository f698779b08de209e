//! The hole's radius along its depth, without steps.

use crate::well::{Hole, HoleSection};

/// Change of radius with depth in the cone that a step in diameter becomes.
const SLOPE: f64 = 0.01;

/// The hole as the string feels it while it moves along: sections joined by cones.
///
/// A tool joint that slides over the casing shoe climbs a chamfer in a real hole; in a model a step
/// would push it out with an unphysical blow. Each step becomes a cone of slope 1:100, centred on it;
/// where a section is shorter than its cones, they add up and the radius stays continuous.
#[derive(Debug, Clone)]
pub struct Bore {
    hole: Hole,
}

impl Bore {
    /// The bore of `hole`.
    pub fn new(hole: &Hole) -> Self {
        Self { hole: hole.clone() }
    }

    /// The section at a measured depth.
    pub fn section(&self, md_m: f64) -> &HoleSection {
        self.hole.at(md_m)
    }

    /// Radius at a measured depth, m. Above its first section and below its last the hole goes on as it
    /// begins and ends.
    pub fn radius_m(&self, md_m: f64) -> f64 {
        let sections = self.hole.sections();
        let mut radius = 0.5 * sections[0].diameter_m;
        for pair in sections.windows(2) {
            let change = 0.5 * (pair[1].diameter_m - pair[0].diameter_m);
            let half_width = 0.5 * change.abs() / SLOPE;
            let from_step = md_m - pair[0].to_md_m;
            radius += if from_step >= half_width {
                change
            } else if from_step <= -half_width {
                0.0
            } else {
                change * 0.5 * (1.0 + from_step / half_width)
            };
        }
        radius
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
            friction: Friction {
                kinetic: 0.3,
                at_rest: 0.3,
            },
            youngs_modulus_Pa: 210e9,
            poisson_ratio: 0.3,
        };
        let hole = Hole::new(vec![section(0.0, 100.0, 0.3), section(100.0, 200.0, 0.2)]).unwrap();
        let bore = Bore::new(&hole);
        assert_eq!(bore.radius_m(-1.0), 0.15);
        assert_eq!(bore.radius_m(50.0), 0.15);
        assert!((bore.radius_m(150.0) - 0.1).abs() < 1e-15);
        assert!((bore.radius_m(100.0) - 0.125).abs() < 1e-12);
        // 5 cm of radius at 1:100 take 5 m.
        assert!((bore.radius_m(98.0) - 0.145).abs() < 1e-12);
        assert_eq!(bore.radius_m(97.4), 0.15);
    }
}
