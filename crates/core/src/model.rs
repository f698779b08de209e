//! The model that every solver shares: one well, one string, one mud, one rig.

use crate::{mud::Mud, rig::Rig, string::DrillString, well::Well};

/// Everything about the drill string and its surroundings that does not depend on what the driller
/// is doing. All solvers read the same one, so that their answers can be held against each other.
#[derive(Debug, Clone)]
pub struct Model {
    /// Path of the hole and its sections.
    pub well: Well,
    /// Components from the bit up; they fill the hole from the bit to the surface.
    pub string: DrillString,
    /// Drilling fluid, the same inside and outside the string.
    pub mud: Mud,
    /// Hoist and top drive.
    pub rig: Rig,
}
