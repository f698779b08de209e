//! The string elsewhere in its hole.

use super::{SoftError, SoftProfile, SoftSettings, SoftString, error};
use crate::{model::Model, operation::Operation, outcome::Scalars};

/// The scalars of the same string, no longer and no shorter, with its bit deeper by `down_m`, or
/// shallower where that is negative.
///
/// The integral reaches from the bit to the surface. The contribution per metre at the surface is
/// subtracted for the metres of hole that the string's top has left behind, and added for those by
/// which it is above: as if the hole continued there unchanged, to first order in `down_m`.
///
/// # Errors
/// Those of [`solve`](super::solve), and a bit that would not be in the hole.
pub(crate) fn scalars_at(
    model: &Model,
    operation: &Operation,
    settings: &SoftSettings,
    down_m: f64,
) -> Result<Scalars, SoftError> {
    error::check_string(model, operation.bit_depth_m, settings)?;
    error::check_operation(model, operation)?;
    let there = Operation { bit_depth_m: operation.bit_depth_m + down_m, ..*operation };
    if there.bit_depth_m <= 0.0 {
        return Err(SoftError::BitDepth(there.bit_depth_m));
    }
    let string = SoftString::elsewhere(model, there.bit_depth_m, settings);
    let (rows, mut integral) = string.rows(&there)?;
    integral.totals = integral.totals + integral.per_metre_at_surface * -down_m;
    Ok(SoftProfile::new(model, &there, rows, &integral).scalars)
}

#[cfg(test)]
mod tests;
