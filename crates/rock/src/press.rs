//! Forces on the surface.

use nalgebra::Vector3;

use super::{
    bit_face::{BitFace, BitLoad, Contact, ContactLaw, Pose, RockNode},
    block::{Block, at},
};

/// Result of pressing a bit on a block for a step.
#[derive(Debug, Clone, Copy)]
pub struct Pressed {
    /// On the bit.
    pub load: BitLoad,
    /// Work done on the rock, J.
    pub pushed_J: f64,
}

impl Block {
    /// Presses a face on the block after a step. All nodes meet it before the first is pushed; sums
    /// run in the order of [`Self::exposed`].
    ///
    /// Of a thousand nodes in reach a dozen touch: only the test for contact is computed for each.
    pub fn press(&mut self, face: &BitFace, pose: &Pose, law: &ContactLaw) -> Pressed {
        let dt_s = self.dt_s();
        // A wall one element thick has two sides that look apart: it must be met all the same.
        let min_m2 = [0, 2, 4].map(|face| 0.25 * self.grid.area_m2(face));
        let min_m2 = min_m2.into_iter().fold(f64::INFINITY, f64::min);
        let mut contact = Contact::new(face, pose, law, dt_s);
        let mut pushes = Vec::new();
        for &index in self.surface.exposed() {
            let index = index as usize;
            let position_m = Vector3::from(self.position_m(index));
            if !contact.reaches(position_m) {
                continue;
            }
            let mass_kg = self.mass_kg(index);
            let velocity_before = Vector3::from(at(&self.velocity_before, index));
            // Force of the rock on the node.
            let force_N =
                (Vector3::from(at(&self.velocity, index)) - velocity_before) * mass_kg / dt_s;
            let node = RockNode { position_m, velocity_m_per_s: velocity_before, force_N, mass_kg };
            let area_m2 = || {
                let area_m2 = self.surface.area_m2(&self.grid, index);
                Vector3::from(area_m2).norm().max(min_m2)
            };
            if let Some(force) = contact.touch(&node, area_m2) {
                // The part lost to rounding in the sum with the rock's own force is not applied,
                // because the node would not receive it either.
                pushes.push((index, (force_N + force) - force_N));
            }
        }
        let pushes = pushes.into_iter().filter(|(_, push)| *push != Vector3::zeros());
        let pushed_J = pushes.map(|(index, push)| self.push(index, push.into())).sum();
        Pressed { load: contact.load(), pushed_J }
    }
}
