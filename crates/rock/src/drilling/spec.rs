//! Specification of a bit that drills.

use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::{Bit, BitShape};
use crate::{
    bit_face::{ContactLaw, FaceError},
    block::BlockSpec,
    edges::Edge,
    material::{Rock, RockError},
};

/// A bit and the block that it is to drill.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DrillingSpec {
    /// The block. The bit begins in the middle of its upper face.
    pub block: BlockSpec,
    /// The bit.
    pub bit: BitShape,
    /// Contact of bit and rock.
    pub contact: ContactLaw,
    /// Height of the hole's wall above the bit's lowest point that is kept, m; higher elements are
    /// dropped while the block follows the bit.
    pub wall_m: f64,
    /// Whether the bit begins in the hole that it would have drilled (default), its nose as deep as
    /// `wall_m`, or on the flat top.
    pub seated: bool,
}

/// Why a bit cannot drill.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum DrillingError {
    /// The rock.
    #[error(transparent)]
    Rock(#[from] RockError),
    /// The bit.
    #[error(transparent)]
    Face(#[from] FaceError),
    /// A block too shallow to follow the bit.
    #[error(
        "a block {depth_m} m deep under a wall of {wall_m} m: expected three layers of elements \
         more than the wall"
    )]
    Shallow {
        /// Depth of the block, m.
        depth_m: f64,
        /// Height of the wall that is kept, m.
        wall_m: f64,
    },
}

/// Factor on the rock's density by default.
const DENSITY_FACTOR: f64 = 400.0;

/// Slabs that a block is cut into: as many threads have something to do.
const SLABS: usize = 4;

impl DrillingSpec {
    /// A bit on cubes of this size.
    ///
    /// The block is two elements, or an eighth of the diameter, wider than the bit on each side,
    /// and as deep as the face from its nose to the gauge, and a quarter of the diameter, or four
    /// elements, below. It is held at the bottom, so that the weight does not push it away; there
    /// is more rock around. Its density is 400 times the rock's: four times as much moves mean
    /// forces by less than 5 % while `ρ v²`, with the scaled density and the speed of the bit's
    /// rim, stays below a quarter of the rock's strength.
    ///
    /// # Errors
    /// Numbers that make no face.
    pub fn new(rock: Rock, bit: BitShape, size_m: f64) -> Result<Self, FaceError> {
        let face = bit.face()?;
        let diameter_m = 2.0 * face.profile().radius_m();
        let elements = |m: f64| (m / size_m).ceil() as usize;
        let across = elements(diameter_m) + 2 * elements(0.125 * diameter_m).max(2);
        let wall = elements(-face.profile().gauge_z_m()) + 1;
        let below = elements(0.25 * diameter_m).max(4);
        let mut block = BlockSpec::new(rock, [across, across, wall + 1 + below], size_m);
        block.edges[5] = Edge::Held;
        block.layers_per_slab = block.cells[2].div_ceil(SLABS);
        block.numerics.density_factor = DENSITY_FACTOR;
        Ok(Self {
            block,
            bit,
            contact: ContactLaw::for_rock(rock.ucs_Pa(), size_m),
            wall_m: wall as f64 * size_m,
            seated: true,
        })
    }

    /// Whether a bit can drill it, found without building the block.
    ///
    /// # Errors
    /// No rock, no face, or a block that is not three layers deeper than the wall that is kept.
    pub fn check(&self) -> Result<(), DrillingError> {
        self.valid_bit().map(drop)
    }

    /// The bit, if it can drill the block.
    pub(super) fn valid_bit(&self) -> Result<Bit, DrillingError> {
        self.block.constants()?;
        let bit = Bit::try_from(self.bit)?;
        let (layers, height_m) = (self.block.cells[2] as f64, self.block.size_m[2]);
        let depth_m = layers * height_m;
        if !(self.wall_m >= 0.0 && depth_m - self.wall_m > 2.5 * height_m) {
            return Err(DrillingError::Shallow { depth_m, wall_m: self.wall_m });
        }
        Ok(bit)
    }
}
