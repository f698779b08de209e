//! Effect of the mud on each stretch of the string as it moves and circulates.

use crate::{
    model::Model,
    mud::{AnnulusDrag, Conduit, Hydraulics, Motion, Mud},
    operation::Operation,
    string::FreeStrain,
};

/// A stretch as the mud meets it.
pub(crate) struct Passage {
    pub(crate) length_m: f64,
    /// Bores and annuli.
    pub(crate) conduit: Conduit,
    /// Strain by the pressures that the flow adds, on the areas on which pressures act.
    pub(crate) free_strain: FreeStrain,
    /// Fluids in the bore and in the annulus.
    pub(crate) inside: Mud,
    pub(crate) annulus: Mud,
}

/// Effect of the mud on a stretch.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Circulating {
    /// Pull along the hole, N/m, positive towards the bit.
    pub(crate) pull_N_per_m: f64,
    /// Torque against the rotation, N·m/m.
    pub(crate) torque_N_m_per_m: f64,
    /// Strain by the pressures that flow adds, the mean of the stretch.
    pub(crate) strain: f64,
    /// Pressure added by the flow in the annulus at the lower end, Pa, and its decrease per metre
    /// upwards.
    pub(crate) outer_Pa: f64,
    pub(crate) outer_fall_Pa_per_m: f64,
    /// Pressure added by the flow in the bore at the lower end, Pa, and its increase per metre
    /// upwards.
    pub(crate) inner_Pa: f64,
    pub(crate) inner_rise_Pa_per_m: f64,
}

/// Losses of the flow along a stretch.
#[derive(Debug, Clone, Copy)]
struct Losses {
    drag: AnnulusDrag,
    inner_rise_Pa_per_m: f64,
}

/// The losses of stretches; computed once of neighbours that have the same bores, annuli and fluids, as
/// hundreds of elements of one pipe in one casing do.
fn losses(motion: &Motion, segments: &[Passage]) -> Vec<Losses> {
    let mut losses: Vec<Losses> = Vec::with_capacity(segments.len());
    for (index, segment) in segments.iter().enumerate() {
        let before = index.checked_sub(1);
        let same = before.filter(|before| {
            let before = &segments[*before];
            before.conduit == segment.conduit
                && before.inside == segment.inside
                && before.annulus == segment.annulus
        });
        losses.push(match same {
            Some(before) => losses[before],
            None => Losses {
                drag: segment.conduit.drag(&segment.annulus, motion),
                inner_rise_Pa_per_m: segment
                    .conduit
                    .bore_gradient_Pa_per_m(&segment.inside, motion.flow_m3_per_s),
            },
        });
    }
    losses
}

/// Effect of the mud on stretches, from the bit up, and on the whole string; none without a
/// rheology.
pub(crate) fn along(
    model: &Model,
    operation: &Operation,
    segments: &[Passage],
) -> (Vec<Circulating>, Option<Hydraulics>) {
    if !model.has_rheology() {
        return (vec![Circulating::default(); segments.len()], None);
    }
    let flow_m3_per_s = operation.flow_now_m3_per_s();
    let motion = Motion {
        axial_m_per_s: operation.axial_velocity_m_per_s(),
        spin_rad_per_s: operation.rotation_rad_per_s(),
        flow_m3_per_s,
    };
    let losses = losses(&motion, segments);
    let annulus_loss_Pa: f64 = segments
        .iter()
        .zip(&losses)
        .map(|(s, loss)| s.length_m * loss.drag.gradient_Pa_per_m)
        .sum();
    let bit_loss_Pa = operation.bit_loss_Pa(flow_m3_per_s);
    let motor_loss_Pa = operation.motor_loss_Pa();
    let below_Pa = bit_loss_Pa + motor_loss_Pa;
    let at_bit = segments.first().map_or(model.mud, |lowest| lowest.inside);
    let mut total = Hydraulics {
        jet_thrust_N: at_bit.jet_thrust_N(flow_m3_per_s, bit_loss_Pa),
        bit_loss_Pa,
        motor_loss_Pa,
        annulus_loss_Pa,
        ..Hydraulics::default()
    };
    // From the bit up the pressure falls outside and rises inside.
    let (mut outer_Pa, mut inner_Pa) = (annulus_loss_Pa, annulus_loss_Pa + below_Pa);
    let circulating = segments.iter().zip(&losses).map(|(s, losses)| {
        let Losses { drag, inner_rise_Pa_per_m } = *losses;
        let rise = s.length_m * inner_rise_Pa_per_m;
        let fall = s.length_m * drag.gradient_Pa_per_m;
        let strain = s.free_strain.by_pressures(outer_Pa - 0.5 * fall, inner_Pa + 0.5 * rise);
        let lower_end_Pa = (outer_Pa, inner_Pa);
        (outer_Pa, inner_Pa) = (outer_Pa - fall, inner_Pa + rise);
        let pull_N_per_m = drag.axial_N_per_m(motion.axial_m_per_s);
        let torque_N_m_per_m = -drag.torque_N(motion.spin_rad_per_s);
        total.mud_drag_N += s.length_m * pull_N_per_m;
        total.mud_torque_N_m += s.length_m * torque_N_m_per_m;
        total.bore_loss_Pa += rise;
        Circulating {
            pull_N_per_m,
            torque_N_m_per_m,
            strain,
            outer_Pa: lower_end_Pa.0,
            outer_fall_Pa_per_m: drag.gradient_Pa_per_m,
            inner_Pa: lower_end_Pa.1,
            inner_rise_Pa_per_m,
        }
    });
    let circulating = circulating.collect();
    total.pump_pressure_Pa = total.bore_loss_Pa + below_Pa + annulus_loss_Pa;
    (circulating, Some(total))
}
