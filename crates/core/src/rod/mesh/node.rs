//! A node of the mesh.

/// A node of the string.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshNode {
    /// Distance from the bit along the unloaded string, m.
    pub from_bit_m: f64,
    /// Radius that touches the wall here: of the joint, of the stabiliser or of the body, m.
    pub contact_radius_m: f64,
}
