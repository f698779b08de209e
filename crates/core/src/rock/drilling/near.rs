//! The nodes of the rock within reach of the bit.

use nalgebra::Vector3;

use crate::rock::{
    bit_face::{BitFace, BitLoad, ContactLaw, Pose, SurfaceNodes},
    block::Block,
};

/// Nodes within reach of the bit, component by component. Kept from step to step for its memory alone.
#[derive(Debug, Clone, Default)]
pub struct Near {
    /// Which nodes of the block.
    nodes: Vec<usize>,
    surface: Vec<u32>,
    position_m: [Vec<f64>; 3],
    came_m_per_s: [Vec<f64>; 3],
    mass_kg: Vec<f64>,
    area_m2: Vec<f64>,
    /// What the rock does to them.
    rock_N: [Vec<f64>; 3],
    force_N: [Vec<f64>; 3],
}

/// What came of a contact.
#[derive(Debug, Clone, Copy)]
pub struct Contact {
    /// On the bit.
    pub load: BitLoad,
    /// Work done on the rock, J.
    pub pushed_J: f64,
}

impl Near {
    /// Presses a face on a block after a step of the block.
    pub fn press(
        &mut self,
        block: &mut Block,
        face: &BitFace,
        pose: &Pose,
        law: &ContactLaw,
    ) -> Contact {
        let dt_s = block.dt_s();
        self.gather(block, face, pose, dt_s);
        for (all, rock) in self.force_N.iter_mut().zip(&self.rock_N) {
            all.clone_from(rock);
        }
        let [fx, fy, fz] = &mut self.force_N;
        let load = face.touch(
            pose,
            law,
            dt_s,
            &mut SurfaceNodes {
                surface: &self.surface,
                position_m: self.position_m.each_ref().map(Vec::as_slice),
                velocity_m_per_s: self.came_m_per_s.each_ref().map(Vec::as_slice),
                mass_kg: &self.mass_kg,
                area_m2: &self.area_m2,
                force_N: [fx, fy, fz],
            },
        );
        let mut pushed_J = 0.0;
        for (place, &node) in self.nodes.iter().enumerate() {
            let push = [0, 1, 2].map(|axis| self.force_N[axis][place] - self.rock_N[axis][place]);
            if push != [0.0; 3] {
                pushed_J += block.push(node, push);
            }
        }
        Contact { load, pushed_J }
    }

    fn gather(&mut self, block: &Block, face: &BitFace, pose: &Pose, dt_s: f64) {
        self.nodes.clear();
        self.surface.clear();
        self.mass_kg.clear();
        self.area_m2.clear();
        for field in [
            &mut self.position_m,
            &mut self.came_m_per_s,
            &mut self.rock_N,
        ] {
            field.iter_mut().for_each(Vec::clear);
        }
        let grid = block.grid();
        // A wall one brick thick has two sides that look apart: it must be met all the same.
        let least_m2 = 0.25 * grid.area_m2(0).min(grid.area_m2(2)).min(grid.area_m2(4));
        let reach = face.reach(pose);
        for node in block.exposed() {
            if !reach.contains(Vector3::from(node.position_m) - pose.position_m) {
                continue;
            }
            self.surface.push(self.nodes.len() as u32);
            self.nodes.push(node.index);
            self.mass_kg.push(node.mass_kg);
            self.area_m2
                .push(Vector3::from(node.area_m2).norm().max(least_m2));
            for axis in 0..3 {
                let came = node.came_m_per_s[axis];
                self.position_m[axis].push(node.position_m[axis]);
                self.came_m_per_s[axis].push(came);
                self.rock_N[axis].push(node.mass_kg * (node.velocity_m_per_s[axis] - came) / dt_s);
            }
        }
    }
}
