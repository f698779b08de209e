//! The body of the string that carries the stress at each node.

use serde::{Deserialize, Serialize};

use super::look::Lane;
use crate::{
    dynamics::chain::place,
    model::Model,
    rod::{lanes::LANES, mesh::Mesh},
};

/// Of each node, the weakest body within half an element on either side: the one with the smallest
/// section modulus `I/(D/2)`.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Strength {
    blocks: Vec<Metal>,
    yield_Pa: Vec<Option<f64>>,
}

/// The metal at a row of nodes.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub struct Metal {
    /// Inverse of the metal's area, 1/m².
    pub per_area: Lane,
    /// Inverse of the section modulus, 1/m³.
    pub per_modulus: Lane,
}

impl Strength {
    /// The bodies of a string.
    pub fn new(model: &Model, mesh: &Mesh) -> Self {
        let mut blocks = vec![
            Metal {
                per_area: [0.0; LANES],
                per_modulus: [0.0; LANES],
            };
            mesh.nodes.len().div_ceil(LANES)
        ];
        let components = model.string.components();
        let mut yield_Pa = Vec::with_capacity(mesh.nodes.len());
        for (index, node) in mesh.nodes.iter().enumerate() {
            let half = |element: Option<usize>| {
                let element = element.and_then(|e| mesh.elements.get(e));
                element.map_or(0.0, |e| 0.5 * e.length_m)
            };
            let below = node.from_bit_m - half(Some(index));
            let above = node.from_bit_m + half(index.checked_sub(1));
            let (first, _) = model.string.component_at(below);
            let (last, _) = model.string.component_at(above);
            let modulus = |c: usize| components[c].second_moment_m4() / (0.5 * components[c].od_m);
            let weakest = (first..=last)
                .min_by(|a, b| modulus(*a).total_cmp(&modulus(*b)))
                .unwrap_or(first);
            let (row, lane) = place(blocks.len(), index);
            let metal = &mut blocks[row];
            metal.per_area[lane] = 1.0 / components[weakest].area_m2();
            metal.per_modulus[lane] = 1.0 / modulus(weakest);
            yield_Pa.push(components[weakest].yield_strength_Pa);
        }
        Self { blocks, yield_Pa }
    }

    /// A row of nodes.
    #[inline(always)]
    pub fn block(&self, block: usize) -> &Metal {
        &self.blocks[block]
    }

    /// Inverse of the section modulus at a node, 1/m³.
    pub fn per_modulus_m3(&self, index: usize) -> f64 {
        let (row, lane) = place(self.blocks.len(), index);
        self.blocks[row].per_modulus[lane]
    }

    /// Minimum yield strength at a node, Pa, where it is known.
    pub fn yield_Pa(&self, index: usize) -> Option<f64> {
        self.yield_Pa[index]
    }
}
