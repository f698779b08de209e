//! The body of the string that carries the stress at each node.

use serde::{Deserialize, Serialize};

use super::lane::{Lane, at};
use crate::{
    damage::{Damaged, ensure},
    dynamics::kernel::layout::Layout,
    model::Model,
    rod::mesh::Mesh,
    simd::{lanes::DOUBLES, number::Doubles},
    string::BodySection,
};

/// Of each node, the weakest body within half an element on either side: the one with the smallest
/// section modulus `I/(D/2)`.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Strength {
    layout: Layout,
    blocks: Vec<Metal>,
    yield_Pa: Vec<Option<f64>>,
}

/// The metal at a block of nodes, and of the elements below them.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[repr(C, align(64))]
pub struct Metal {
    /// Inverse of the metal's area, 1/m².
    pub per_area: Lane,
    /// Inverse of the section modulus, 1/m³.
    pub per_modulus: Lane,
    /// Inner over outer diameter.
    pub bore_part: Lane,
    /// Area of the bore over that of the metal.
    pub bore_per_area: Lane,
    /// Square of the pressure inside less that outside, Pa².
    pub burst_square: Lane,
    /// Elongation of the element below per newton, m/N; zero below the bit, where there is none.
    pub compliance: Lane,
}

impl Metal {
    /// [`BodySection::von_mises_Pa`] of the bodies at lanes.
    #[inline(always)]
    pub fn stress_Pa<N: Doubles>(
        &self,
        lane: usize,
        tension_N: N,
        bending_N_m: N,
        torque_N_m: N,
    ) -> N {
        let section = BodySection {
            per_area_m2: at(&self.per_area, lane),
            per_modulus_m3: at(&self.per_modulus, lane),
            bore_part: at(&self.bore_part, lane),
            bore_per_area: at(&self.bore_per_area, lane),
        };
        section.von_mises_Pa(tension_N, bending_N_m, torque_N_m, at(&self.burst_square, lane))
    }
}

impl Strength {
    /// Whether a stored one is that of so many nodes in this layout.
    pub(super) fn check(&self, nodes: usize, layout: Layout) -> Result<(), Damaged> {
        let fits = self.layout == layout
            && self.blocks.len() == layout.blocks()
            && self.yield_Pa.len() == nodes;
        ensure(fits, "the bodies of the string")
    }

    /// The bodies of a string.
    pub fn new(model: &Model, mesh: &Mesh, layout: Layout) -> Self {
        let mut blocks = vec![
            Metal {
                per_area: [0.0; DOUBLES],
                per_modulus: [0.0; DOUBLES],
                bore_part: [0.0; DOUBLES],
                bore_per_area: [0.0; DOUBLES],
                burst_square: [0.0; DOUBLES],
                compliance: [0.0; DOUBLES],
            };
            layout.blocks()
        ];
        let mut yield_Pa = Vec::with_capacity(mesh.nodes.len());
        for index in 0..mesh.nodes.len() {
            let (block, lane) = layout.place(index);
            let metal = &mut blocks[block];
            let component = mesh.weakest_body(&model.string, index);
            let section = BodySection::of(component);
            metal.per_area[lane] = section.per_area_m2;
            metal.per_modulus[lane] = section.per_modulus_m3;
            metal.bore_part[lane] = section.bore_part;
            metal.bore_per_area[lane] = section.bore_per_area;
            if let Some(element) = mesh.elements.get(index) {
                metal.compliance[lane] = element.length_m / element.section.axial_stiffness_N;
            }
            yield_Pa.push(component.yield_strength_Pa);
        }
        Self { layout, blocks, yield_Pa }
    }

    /// Sets the pressure inside less that outside at each node, Pa.
    pub fn press(&mut self, difference_Pa: impl Fn(usize) -> f64) {
        for (index, (block, lane)) in self.layout.places().take(self.yield_Pa.len()).enumerate() {
            let difference_Pa = difference_Pa(index);
            self.blocks[block].burst_square[lane] = difference_Pa * difference_Pa;
        }
    }

    /// A block of nodes.
    #[inline(always)]
    pub fn block(&self, block: usize) -> &Metal {
        &self.blocks[block]
    }

    /// Inverse of the section modulus at a node, 1/m³.
    pub fn per_modulus_m3(&self, index: usize) -> f64 {
        let (block, lane) = self.layout.place(index);
        self.blocks[block].per_modulus[lane]
    }

    /// Elongation of the element below a node per newton, m/N; zero below the bit.
    pub fn compliance_m_per_N(&self, index: usize) -> f64 {
        let (block, lane) = self.layout.place(index);
        self.blocks[block].compliance[lane]
    }

    /// Minimum yield strength at a node, Pa, where it is known.
    pub fn yield_Pa(&self, index: usize) -> Option<f64> {
        self.yield_Pa[index]
    }
}
