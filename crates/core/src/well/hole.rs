//! Sections of the hole: casing and open hole.

/// What the wall is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HoleKind {
    /// Steel casing or liner.
    Casing,
    /// Rock.
    Open,
}

/// Coulomb friction of a wall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Friction {
    /// Coefficient while sliding.
    pub kinetic: f64,
    /// Coefficient at rest; at least the kinetic one.
    pub at_rest: f64,
}

/// One stretch of hole with the same diameter, wall and friction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HoleSection {
    /// Casing or rock.
    pub kind: HoleKind,
    /// Measured depth where the section begins, m.
    pub from_md_m: f64,
    /// Measured depth where the section ends, m.
    pub to_md_m: f64,
    /// Diameter of the hole, or inside diameter of the casing, m.
    pub diameter_m: f64,
    /// Friction between string and wall.
    pub friction: Friction,
    /// Young's modulus of the wall, Pa.
    pub youngs_modulus_Pa: f64,
    /// Poisson's ratio of the wall.
    pub poisson_ratio: f64,
}

/// The hole's sections, from the surface down, without gaps or overlaps.
#[derive(Debug, Clone, PartialEq)]
pub struct Hole {
    sections: Vec<HoleSection>,
}

/// Why sections make no hole.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum HoleError {
    /// No section at all.
    #[error("a hole needs at least one section")]
    Empty,
}
