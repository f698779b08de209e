//! The bit that drills.

use serde::{Deserialize, Serialize};

use crate::bit_face::{BitFace, FaceError, InsertBit, PdcBit};

/// The numbers that make a face.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum BitShape {
    /// A drag bit, or a core bit.
    Pdc(PdcBit),
    /// Inserts that scrape.
    Insert(InsertBit),
}

impl BitShape {
    /// Diameter, m.
    pub fn diameter_m(&self) -> f64 {
        match self {
            Self::Pdc(bit) => bit.diameter_m,
            Self::Insert(bit) => bit.diameter_m,
        }
    }

    /// Blades that carry the cutters; none of a bit with inserts.
    pub fn blades(&self) -> Option<usize> {
        match self {
            Self::Pdc(bit) => Some(bit.blades),
            Self::Insert(_) => None,
        }
    }

    /// The face.
    ///
    /// # Errors
    /// Numbers that make none.
    pub fn face(&self) -> Result<BitFace, FaceError> {
        match self {
            Self::Pdc(bit) => bit.face(),
            Self::Insert(bit) => bit.face(),
        }
    }
}

/// A bit: its numbers, and the face that they make. Only the numbers are stored.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(try_from = "BitShape", into = "BitShape")]
pub struct Bit {
    shape: BitShape,
    face: BitFace,
}

impl Bit {
    /// The numbers.
    pub fn shape(&self) -> &BitShape {
        &self.shape
    }

    /// The face.
    pub fn face(&self) -> &BitFace {
        &self.face
    }
}

impl TryFrom<BitShape> for Bit {
    type Error = FaceError;

    fn try_from(shape: BitShape) -> Result<Self, FaceError> {
        let face = shape.face()?;
        Ok(Self { shape, face })
    }
}

impl From<Bit> for BitShape {
    fn from(bit: Bit) -> Self {
        bit.shape
    }
}
