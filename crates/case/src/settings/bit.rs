//! `bit` in the record of a run.

use serde_json::{Value as Json, json};
use wholestring::{
    dynamics::{BitLaw, BitSettings, BitTable, Motor, TablePoint},
    operation::Operation,
    rock::{
        BitShape, DrillingSpec,
        bit_face::{InsertBit, InsertShape},
    },
};

use super::fields::{Fields, json, json as to_json};
use crate::bit_test::BitTest;

/// Returns the bit, with the keys of its law only.
pub(super) fn bit(bit: &BitSettings, operations: &[Operation]) -> Fields {
    Fields::of(bit)
        .without(["law", "motor"])
        .with("torque_N_m", bit_torque(operations))
        .and(motor(&bit.motor))
        .and(law(&bit.law))
}

/// Returns the torque of the bit in the first operation.
pub(super) fn bit_torque(operations: &[Operation]) -> Json {
    to_json(&operations.first().map(|operation| operation.bit_torque_N_m))
}

fn motor(motor: &Motor) -> Fields {
    match motor {
        Motor::Speed(speed) => Fields::empty().with("motor_speed_rad_per_s", to_json(speed)),
        Motor::Displacement(motor) => Fields::empty().with(
            "motor",
            Fields::of(motor).renamed([("max_pressure_Pa", "max_differential_pressure_Pa")]),
        ),
    }
}

fn law(law: &BitLaw) -> Fields {
    // Rock and face have tables of their own, as have those of a bit test.
    let fields = Fields::tagged("law", law)
        .spread("cutters", "")
        .without(["drilling"])
        .mapped("excitation", excitation);
    match law {
        BitLaw::Table(law) => fields.with("table", points(&law.table)),
        _ => fields,
    }
}

fn excitation(shaken: &Json) -> Json {
    let band = |by: &str| shaken["band"][by].clone();
    Fields::of(shaken)
        .without(["band"])
        .with("waves", band("PerRevolution"))
        .with("frequency_per_s", band("PerSecond"))
        .into()
}

/// Returns the measured points, column by column.
fn points(table: &BitTable) -> Json {
    let points = table.points();
    let column = |value: fn(&TablePoint) -> f64| points.iter().map(value).collect::<Vec<_>>();
    let spread = |value: fn(&TablePoint) -> Option<f64>| {
        points.iter().map(value).collect::<Option<Vec<_>>>()
    };
    json!({
        "weight_on_bit_N": column(|p| p.weight_on_bit_N),
        "rotary_speed_rad_per_s": column(|p| p.rotary_speed_rad_per_s),
        "rate_of_penetration_m_per_s": column(|p| p.rate_of_penetration_m_per_s),
        "torque_N_m": column(|p| p.torque_N_m),
        "torque_std_N_m": spread(|p| p.torque_std_N_m),
        "weight_on_bit_std_N": spread(|p| p.weight_on_bit_std_N),
    })
}

// Solid rock, the face of its bit and the test of a bit in the record of a run.

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
