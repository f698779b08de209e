//! Features that are fixed in a component's body and turn with it.

use serde::Serialize;

use super::Material;

/// A bend of the body: of a motor's housing, of a bent sub.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct BodyBend {
    /// Angle between the axes above and below, rad.
    pub angle_rad: f64,
    /// Distance of the bend from the component's lower end, m.
    pub from_lower_end_m: f64,
    /// Tool face at the start: the direction to which the part below is bent, rad from the high
    /// side, clockwise as one looks down the hole.
    pub toolface_rad: f64,
}

/// Nearest that a bend may be to the bit, to the surface or to a stabiliser's middle and still have
/// a node of its own, m.
pub const NEAREST_BEND_M: f64 = 0.3;

/// Content of the cavity on one side of an eccentric component.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub enum Cavity {
    /// The mud: a bore off the axis, a slot, a worn side. It makes up for part of the missing
    /// steel.
    #[default]
    Mud,
    /// Air or next to nothing: a sealed pocket.
    Sealed,
}

/// A component whose steel has its centre of mass off the axis of the pipe.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Eccentricity {
    /// Distance of the steel's centre of mass from the axis, m.
    pub offset_m: f64,
    /// Its direction at the start, rad from the high side, clockwise as one looks down the hole.
    pub phase_rad: f64,
    /// Content of the cavity.
    pub cavity: Cavity,
}

/// Largest offset, as a part of the outside diameter. More is no pipe: a bore that touches the
/// outside of a collar moves the centre of mass by a tenth of the diameter or so.
pub const MAX_ECCENTRIC: f64 = 0.1;

impl Eccentricity {
    /// The offset that the steel alone would need for the same imbalance, m.
    ///
    /// With mud in the place of missing steel, `e (1 − ρ_m/ρ_s)`. Theory:
    /// `docs/src/theory/bends.md`.
    pub fn effective_offset_m(&self, mud_kg_per_m3: f64, steel: &Material) -> f64 {
        match self.cavity {
            Cavity::Sealed => self.offset_m,
            Cavity::Mud => self.offset_m * (1.0 - mud_kg_per_m3 / steel.density_kg_per_m3),
        }
    }
}

// A force across the string.

/// A force across a component, fixed in space: of a rotary steerable, whose pads are controlled to
/// a direction while the tool turns.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LateralForce {
    /// Force on the tool, N; its pads press the wall on the other side by as much.
    pub force_N: f64,
    /// Distance of the force from the component's lower end, m.
    pub from_lower_end_m: f64,
    /// Direction to which the tool is pushed, rad from the high side at the bit, clockwise as one
    /// looks down the hole.
    pub toolface_rad: f64,
}
