//! A pipe in its hole at one measured depth.

use nalgebra::Vector3;

use crate::{model::Model, mud::Densities, string::Component, well::PathPoint};

/// More than the rounding error of a depth, m.
const JUST_ABOVE_M: f64 = 1e-6;

/// Parameters of a pipe's buckling at one measured depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// Bending stiffness `EI` of the body, N·m².
    pub bending_stiffness_N_m2: f64,
    /// Radial clearance between hole and contact surface, m.
    pub clearance_m: f64,
    /// Magnitude of the buoyed weight per length `w`, N/m.
    pub weight_N_per_m: f64,
    /// Its part across the hole `w sin θ`, N/m.
    pub weight_across_N_per_m: f64,
    /// Build rate `θ'`, rad/m; negative in a drop.
    pub build_rad_per_m: f64,
    /// Turn rate across the hole `sin θ φ'`, rad/m.
    pub turn_rad_per_m: f64,
}

/// A pipe in a hole, wherever it runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pipe {
    bending_stiffness_N_m2: f64,
    clearance_m: f64,
    /// Negative where it floats.
    weight_N_per_m: f64,
}

impl Pipe {
    /// A component in a hole of that diameter, m, in fluids of these densities.
    pub fn new(component: &Component, hole_diameter_m: f64, densities: Densities) -> Self {
        Self {
            bending_stiffness_N_m2: component.bending_stiffness_N_m2(),
            clearance_m: 0.5 * hole_diameter_m - component.contact_radius_m(),
            weight_N_per_m: component.weight_in_N_per_m(densities),
        }
    }

    /// Wall load that a helix adds under a compression, N/m.
    pub fn helix_load_N_per_m(&self, compression_N: f64) -> f64 {
        helix_load_N_per_m(self.bending_stiffness_N_m2, self.clearance_m, compression_N)
    }

    /// The same place in a hole with that unit tangent and curvature vector, 1/m.
    pub fn at(&self, tangent: &Vector3<f64>, curvature_per_m: &Vector3<f64>) -> Place {
        // A floating pipe loads the high side in the same way as a sinking one loads the low side.
        let down = Vector3::z() * self.weight_N_per_m.signum();
        let across = down - tangent * tangent.dot(&down);
        let sin_inclination = across.norm();
        let (build_rad_per_m, turn_rad_per_m) = match across.try_normalize(1e-9) {
            // Compression presses a build to the side that the weight presses to.
            Some(weight_side) => {
                let build = -curvature_per_m.dot(&weight_side);
                (build, (curvature_per_m + weight_side * build).norm())
            }
            None => (curvature_per_m.norm(), 0.0),
        };
        Place {
            bending_stiffness_N_m2: self.bending_stiffness_N_m2,
            clearance_m: self.clearance_m,
            weight_N_per_m: self.weight_N_per_m.abs(),
            weight_across_N_per_m: self.weight_N_per_m.abs() * sin_inclination,
            build_rad_per_m,
            turn_rad_per_m,
        }
    }
}

impl Place {
    /// The pipe of a model at a measured depth with its bit at another, m.
    pub fn of(model: &Model, bit_depth_m: f64, md_m: f64) -> Self {
        Self::on(model, bit_depth_m, md_m, &model.well.path.at(md_m))
    }

    /// The same just above a measured depth, m: where a property jumps, profiles have it of the
    /// stretch above.
    pub fn above(model: &Model, bit_depth_m: f64, md_m: f64) -> Self {
        Self::of(model, bit_depth_m, (md_m - JUST_ABOVE_M).max(0.0))
    }

    /// The same where the point of the path is known.
    pub fn on(model: &Model, bit_depth_m: f64, md_m: f64, point: &PathPoint) -> Self {
        let (_, component) = model.string.component_at(bit_depth_m - md_m);
        let hole_diameter_m = model.well.hole.at(md_m).diameter_m;
        let pipe = Pipe::new(component, hole_diameter_m, model.densities_at(md_m));
        pipe.at(&point.tangent, &point.curvature_per_m)
    }

    /// `w_n`: wall load of a straight pipe under a compression, N/m; a negative compression is a
    /// tension.
    pub fn wall_load_N_per_m(&self, compression_N: f64) -> f64 {
        let built = self.weight_across_N_per_m + compression_N * self.build_rad_per_m;
        libm::hypot(built, compression_N * self.turn_rad_per_m)
    }

    /// Wall load that a helix adds under a compression, N/m.
    pub fn helix_load_N_per_m(&self, compression_N: f64) -> f64 {
        helix_load_N_per_m(self.bending_stiffness_N_m2, self.clearance_m, compression_N)
    }
}

/// Wall load that a helix adds under a compression, `r F²/(4 EI)`, N/m.
fn helix_load_N_per_m(stiffness_N_m2: f64, clearance_m: f64, compression_N: f64) -> f64 {
    clearance_m * compression_N * compression_N / (4.0 * stiffness_N_m2)
}
