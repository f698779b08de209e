//! A component of a string in a tally.

/// A component, from the bit up.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Component {
    /// Its name.
    pub name: String,
    /// Length, m.
    pub length_m: f64,
    /// Outside diameter of the body, m.
    pub od_m: f64,
    /// Inside diameter of the body, m.
    pub id_m: f64,
    /// Mass per length in air, kg/m, including tool joints.
    pub mass_per_length_kg_per_m: f64,
    /// Outside diameter of the tool joints, m, if it has any.
    pub joint_od_m: Option<f64>,
    /// Distance between tool joints, m, if it has any.
    pub joint_spacing_m: Option<f64>,
    /// Diameter over the blades, m, if it has any.
    pub blade_od_m: Option<f64>,
    /// Length of the blades, which are at its middle, m, if it has any.
    pub blade_length_m: Option<f64>,
    /// Density of its metal, kg/m³, if other than the usual steel.
    pub density_kg_per_m3: Option<f64>,
    /// Young's modulus and shear modulus of its metal, Pa, if other than the usual steel.
    pub moduli_Pa: Option<[f64; 2]>,
    /// Minimum yield strength, Pa, if known.
    pub yield_strength_Pa: Option<f64>,
}
