//! Solid rock, the face of its bit and the test of a bit in the record of a run.

use wholestring::rock::{
    BitShape, DrillingSpec,
    bit_face::{InsertBit, InsertShape},
};

use super::fields::{Fields, json};
use crate::bit_test::BitTest;

/// The rock in elements.
pub(super) fn rock(spec: &DrillingSpec) -> Fields {
    let (rock, block) = (&spec.block.rock, &spec.block);
    Fields::of(rock)
        .with("strength_Pa", rock.ucs_Pa())
        .with("pressure_Pa", block.pressure_Pa)
        .with("confinement_Pa", block.confinement_Pa)
        .with("friction", spec.contact.friction)
        .with("element_size_m", block.size_m[0])
        .with("density_factor", block.numerics.density_factor)
        .with("cells", json(&block.cells))
}

/// The bit's face.
pub(super) fn face(shape: &BitShape) -> Fields {
    match shape {
        BitShape::Pdc(bit) => Fields::of(bit),
        BitShape::Insert(bit) => inserts(bit),
    }
}

fn inserts(bit: &InsertBit) -> Fields {
    let (half_angle_rad, tip_radius_m) = match bit.shape {
        InsertShape::Hemisphere => (None, None),
        InsertShape::Cone { half_angle_rad, tip_radius_m } => {
            (Some(half_angle_rad), Some(tip_radius_m))
        }
    };
    Fields::of(bit)
        .spread_variant("shape", "insert_shape")
        .with("half_angle_rad", half_angle_rad)
        .with("tip_radius_m", tip_radius_m)
}

/// The settings of a bit test; bit and rock have tables of their own.
pub(super) fn bit_test(test: &BitTest) -> Fields {
    Fields::of(test)
        .without(["drilling"])
        .renamed([("weights_N", "wob_N"), ("rotary_speeds_rad_per_s", "rotary_speed_rad_per_s")])
}
