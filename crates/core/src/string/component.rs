//! One component of the string: a bit, a motor, a stand of collars, all the drill pipe.

/// Elastic and inertial properties of a component's metal.
///
/// `E` and `G` are independent inputs: published models do not always keep them consistent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Density, kg/m³.
    pub density_kg_per_m3: f64,
    /// Young's modulus, Pa.
    pub youngs_modulus_Pa: f64,
    /// Shear modulus, Pa.
    pub shear_modulus_Pa: f64,
}

/// Tool joints: the thick, short ends of a pipe, the only part of it that usually touches the wall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToolJoints {
    /// Outside diameter of the joint, m.
    pub od_m: f64,
    /// Distance between joints along the string, m.
    pub spacing_m: f64,
}

/// A uniform stretch of the string.
#[derive(Debug, Clone, PartialEq)]
pub struct Component {
    /// What the user calls it.
    pub name: String,
    /// Length, m.
    pub length_m: f64,
    /// Outside diameter of the body, m.
    pub od_m: f64,
    /// Inside diameter of the body, m.
    pub id_m: f64,
    /// Mass per length in air, kg/m, tool joints included.
    pub mass_per_length_kg_per_m: f64,
    /// Tool joints, if it has any. Without them the contact radius is `od_m / 2`.
    pub joints: Option<ToolJoints>,
    /// What it is made of.
    pub material: Material,
    /// Minimum yield strength, Pa, where known.
    pub yield_strength_Pa: Option<f64>,
}
