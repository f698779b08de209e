//! Effect of circulation and tripping on the pressure in the hole, against the depth of the bit.
//!
//! Pressures are those of the engine's mud ([`wholestring::mud`]): laminar and turbulent, pipe and
//! hole concentric, the pipe's own motion and rotation in the flow. The equivalent density is that
//! of a column with the pressure of mud and friction together, `ρ + Δp/(g z)` at the vertical depth
//! `z`. Theory: `docs/src/theory/mud.md`.

mod passage;
#[cfg(test)]
mod tests;
mod trip;

pub use trip::{GelBreak, StringEnd, gel_break};

use wholestring::{
    GRAVITY_M_PER_S2,
    model::Model,
    mud::Motion,
    operation::Operation,
    string::AssemblyError,
    well::{Hole, HoleKind},
};

use crate::Setup;
use passage::Passages;

/// Equivalent densities, kg/m³.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EquivalentDensity {
    /// At the deepest casing shoe, wherever the bit is; `None` for a hole without casing.
    pub shoe_kg_per_m3: Option<f64>,
    /// At the bit.
    pub bit_kg_per_m3: f64,
}

/// The mud with the bit at one depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HydraulicsRow {
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// Pressure at the standpipe, Pa: bore, bit, motor and annulus.
    pub standpipe_Pa: f64,
    /// Friction in the bore, Pa.
    pub bore_loss_Pa: f64,
    /// Pressure drop of bit and motor, Pa.
    pub bit_loss_Pa: f64,
    /// Friction in the annulus, Pa.
    pub annulus_loss_Pa: f64,
    /// With the pumps and rotation of the operation.
    pub circulating: EquivalentDensity,
    /// Running in at the trip speed, the string closed and open.
    pub surge: [EquivalentDensity; 2],
    /// Pulling out at the trip speed, the string closed and open.
    pub swab: [EquivalentDensity; 2],
}

/// The ends of [`HydraulicsRow::surge`] and [`HydraulicsRow::swab`], in their order.
pub const STRING_ENDS: [StringEnd; 2] = [StringEnd::Closed, StringEnd::Open];

/// The reason why there is no result.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum HydraulicsError {
    /// The mud has no rheology.
    #[error("the mud has no rheology: pressures need one")]
    NoRheology,
    /// The string cannot have its bit at that depth.
    #[error(transparent)]
    Assembly(#[from] AssemblyError),
}

/// Returns the mud with the bit at each depth, m: circulating as in `operation`, and tripping at
/// its trip speed. The operation's own depth is not used.
///
/// # Errors
/// A mud without a rheology; a depth that no string can be made for.
pub fn hydraulics(
    setup: &Setup,
    operation: &Operation,
    bit_depths_m: &[f64],
) -> Result<Vec<HydraulicsRow>, HydraulicsError> {
    if !setup.fluids.has_rheology(&setup.mud) {
        return Err(HydraulicsError::NoRheology);
    }
    let at = |&bit_depth_m: &f64| Ok(row(&setup.at(bit_depth_m)?, operation, bit_depth_m));
    bit_depths_m.iter().map(at).collect()
}

/// Returns the measured depth of the deepest casing shoe, m.
pub fn casing_shoe_m(hole: &Hole) -> Option<f64> {
    let casings = hole.sections().iter().filter(|section| section.kind == HoleKind::Casing);
    casings.map(|section| section.to_md_m).reduce(f64::max)
}

fn row(model: &Model, operation: &Operation, bit_depth_m: f64) -> HydraulicsRow {
    let passages = Passages::of(model, bit_depth_m);
    let shoe_md_m = casing_shoe_m(&model.well.hole);
    let loss_Pa =
        |motion: &Motion| passages.annulus_loss_Pa(motion, [shoe_md_m.unwrap_or(0.0), bit_depth_m]);
    let vertical_m = |md_m: f64| model.well.path.at(md_m).position_m.z;
    let column = model.mud_column();
    let equivalent = |[at_shoe_Pa, at_bit_Pa]: [f64; 2]| {
        let density = |loss_Pa: f64, md_m: f64| {
            let depth_m = vertical_m(md_m) - vertical_m(0.0);
            column.annulus.equivalent_density(md_m, vertical_m(md_m))
                + loss_Pa / (GRAVITY_M_PER_S2 * depth_m)
        };
        EquivalentDensity {
            shoe_kg_per_m3: shoe_md_m.map(|md_m| density(at_shoe_Pa, md_m)),
            bit_kg_per_m3: density(at_bit_Pa, bit_depth_m),
        }
    };
    let flow_m3_per_s = operation.flow_now_m3_per_s();
    let circulating_Pa = loss_Pa(&Motion {
        axial_m_per_s: operation.axial_velocity_m_per_s(),
        spin_rad_per_s: operation.rotation_rad_per_s(),
        flow_m3_per_s,
    });
    let [_, annulus_loss_Pa] = circulating_Pa;
    let bore_loss_Pa = passages.bore_loss_Pa(flow_m3_per_s);
    let bit_loss_Pa = operation.bit_loss_Pa(flow_m3_per_s) + operation.motor_loss_Pa();
    let tripping = |velocity_m_per_s: f64| {
        STRING_ENDS.map(|end| {
            equivalent(loss_Pa(&trip::motion(&passages, operation, end, velocity_m_per_s)))
        })
    };
    HydraulicsRow {
        bit_depth_m,
        standpipe_Pa: bore_loss_Pa + bit_loss_Pa + annulus_loss_Pa,
        bore_loss_Pa,
        bit_loss_Pa,
        annulus_loss_Pa,
        circulating: equivalent(circulating_Pa),
        surge: tripping(operation.trip_speed_m_per_s),
        swab: tripping(-operation.trip_speed_m_per_s),
    }
}
