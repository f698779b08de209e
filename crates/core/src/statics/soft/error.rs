//! Errors of the soft string, and the settings of its integration.

use serde::Serialize;

use crate::{model::Model, mud::FluidsError, operation::Operation};

/// Why the soft string has no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SoftError {
    /// The step is out of its range.
    #[error("the step along the hole must be from 0.05 m to 100 m, got {0} m")]
    Step(f64),
    /// The bit is too deep, or not at a depth at all.
    #[error("the bit depth must be a positive number of metres up to 100 km, got {0} m")]
    BitDepth(f64),
    /// The string does not reach from the bit to the surface.
    #[error("the string is {string_m:.3} m long, but the bit is {bit_depth_m:.3} m deep")]
    StringLength {
        /// Length of the string, m.
        string_m: f64,
        /// Depth of the bit, m.
        bit_depth_m: f64,
    },
    /// A set point of the operation, or the mud's density, is out of its range.
    #[error("the {quantity} must be {expected}, got {value}")]
    SetPoint {
        /// Name of the quantity.
        quantity: &'static str,
        /// Expected range, with its unit.
        expected: &'static str,
        /// Value, SI.
        value: f64,
    },
    /// The fluids that replace the mud are no column.
    #[error(transparent)]
    Fluids(FluidsError),
    /// Its helix, whose side force counts, takes any push, however great.
    #[error(
        "the string locks up: any further push from above MD {md_m:.0} m is absorbed by the helix, so that no hook load \
         brings the load at the bit there"
    )]
    LocksUp {
        /// Measured depth, m.
        md_m: f64,
    },
    /// The tension or torque left the range of floating-point numbers.
    #[error(
        "tension or torque is not a finite number at MD {md_m:.1} m: a dimension, a weight or a \
         set point is out of proportion"
    )]
    NotFinite {
        /// Measured depth, m.
        md_m: f64,
    },
}

/// Deepest bit that is taken, m; the longest wells are 15 km.
const DEEPEST_BIT_M: f64 = 1e5;

/// A string may differ from the bit depth by this, m: rounding of sums of lengths.
const LENGTH_TOLERANCE_M: f64 = 1e-3;

/// Of a string with its bit at a depth, m.
pub(super) fn check_string(
    model: &Model,
    bit_depth_m: f64,
    settings: &SoftSettings,
) -> Result<(), SoftError> {
    if !(0.05..=100.0).contains(&settings.step_m) {
        return Err(SoftError::Step(settings.step_m));
    }
    if !(bit_depth_m > 0.0 && bit_depth_m <= DEEPEST_BIT_M) {
        return Err(SoftError::BitDepth(bit_depth_m));
    }
    model.fluids.check().map_err(SoftError::Fluids)?;
    let string_m = model.string.length_m();
    if (string_m - bit_depth_m).abs() > LENGTH_TOLERANCE_M {
        return Err(SoftError::StringLength { string_m, bit_depth_m });
    }
    Ok(())
}

/// Of the set points of an operation.
pub(super) fn check_operation(model: &Model, operation: &Operation) -> Result<(), SoftError> {
    let rotation = operation.rotation_rad_per_s();
    let axial = operation.axial_velocity_m_per_s();
    let density = model.mud.density_kg_per_m3;
    let weight_on_bit = operation.weight_on_bit_now_N();
    let bit_pull = operation.bit_pull_now_N();
    let bit_torque = operation.bit_torque_now_N_m();
    for (quantity, expected, value, valid) in [
        (
            "rotary speed",
            "positive (rad/s) where the string rotates",
            rotation,
            rotation.is_finite() && (rotation > 0.0 || !operation.kind.rotates()),
        ),
        ("axial speed", "a finite number (m/s)", axial, axial.is_finite()),
        ("mud density", "zero or more (kg/m³)", density, density.is_finite() && density >= 0.0),
        ("weight on bit", "a finite number (N)", weight_on_bit, weight_on_bit.is_finite()),
        ("pull on the bit", "a finite number (N)", bit_pull, bit_pull.is_finite()),
        ("bit torque", "a finite number (N·m)", bit_torque, bit_torque.is_finite()),
    ] {
        if !valid {
            return Err(SoftError::SetPoint { quantity, expected, value });
        }
    }
    Ok(())
}

// Settings of the soft string's integration.

/// Settings of the soft string's integration.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SoftSettings {
    /// Longest step along the hole, m, from 0.05 to 100. Steps also end at survey stations, at the
    /// ends of a spline's transitions, of components and of hole sections. The rows of the profile
    /// are the steps' ends.
    ///
    /// Default 1 m. The method is of fourth order. Where the pipe changes sides `|q|` has a kink:
    /// a step there is halved until 2e-8 N are left, so that no force depends on where steps fall.
    pub step_m: f64,
    /// Whether a string that is a helix by [`Model::buckling`](crate::model::Model::buckling) is
    /// pressed to the wall by that too, `r F²/(4 EI)` more per metre (Mitchell 1986), and rubs so
    /// much more. Default no.
    pub helix_side_force: bool,
}

impl Default for SoftSettings {
    fn default() -> Self {
        Self { step_m: 1.0, helix_side_force: false }
    }
}
