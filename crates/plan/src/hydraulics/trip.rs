//! Surge and swab: the pressure of a string that moves with its pumps off.

use std::convert::Infallible;

use wholestring::{
    model::Model,
    mud::{AnnulusGel, Motion, gel::bore_gradient_Pa_per_m},
    operation::Operation,
};

use super::passage::Passages;
use crate::root;

/// Upper limit of the search for a flow through a string that is large enough, m³/s.
const MOST_M3_PER_S: f64 = 1e3;
/// Relative tolerance of that flow.
const EXACT: f64 = 1e-12;

/// Whether mud enters the string as it moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StringEnd {
    /// It does not enter: a float valve, a plugged bit.
    Closed,
    /// It enters through the nozzles, where the operation gives their pressure drop: the pressure
    /// at the bit is the same on both ways up.
    Open,
}

/// Returns the motion of mud and string at a velocity of the string, m/s, positive towards the bit.
pub(super) fn motion(
    passages: &Passages,
    operation: &Operation,
    end: StringEnd,
    velocity_m_per_s: f64,
) -> Motion {
    let at = |flow_m3_per_s: f64| Motion {
        axial_m_per_s: velocity_m_per_s,
        spin_rad_per_s: 0.0,
        flow_m3_per_s,
    };
    match end {
        StringEnd::Closed => at(0.0),
        StringEnd::Open => {
            let speed_m_per_s = velocity_m_per_s.abs();
            let up_m3_per_s = through_bore_m3_per_s(passages, operation, speed_m_per_s);
            // Running in it flows up the bore, pulling out down.
            at(-up_m3_per_s * velocity_m_per_s.signum())
        }
    }
}

/// Returns the flow through the bore of a string at a speed, relative to it, m³/s, for which
/// annulus and bore add the same pressure at the bit; the difference falls with the flow.
fn through_bore_m3_per_s(passages: &Passages, operation: &Operation, speed_m_per_s: f64) -> f64 {
    let difference_Pa = |flow_m3_per_s: f64| {
        let motion = Motion {
            axial_m_per_s: speed_m_per_s,
            spin_rad_per_s: 0.0,
            flow_m3_per_s: -flow_m3_per_s,
        };
        let [annulus_Pa] = passages.annulus_loss_Pa(&motion, [f64::INFINITY]);
        annulus_Pa - passages.bore_loss_Pa(flow_m3_per_s) - operation.bit_loss_Pa(flow_m3_per_s)
    };
    let (mut low, mut at_low) = (0.0, difference_Pa(0.0));
    if at_low <= 0.0 {
        return 0.0;
    }
    let mut high = 1e-3 * speed_m_per_s;
    let mut at_high = difference_Pa(high);
    while at_high > 0.0 && high < MOST_M3_PER_S {
        (low, at_low) = (high, at_high);
        high *= 4.0;
        at_high = difference_Pa(high);
    }
    if at_high > 0.0 {
        return high;
    }
    let difference = |flow_m3_per_s: f64| Ok::<_, Infallible>(difference_Pa(flow_m3_per_s));
    let Ok(flow_m3_per_s) = root(difference, [(low, at_low), (high, at_high)], EXACT * high);
    flow_m3_per_s
}

// Breaking of the gel of a mud that has rested.

/// Pressures that break the gel on the whole path of the mud at once, down the bore and up the
/// annulus: an upper limit of the pump pressure before anything flows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GelBreak {
    /// In the bore, Pa.
    pub bore_Pa: f64,
    /// In the annulus, Pa.
    pub annulus_Pa: f64,
    /// Reduction of the hook load by the gel in the annulus meanwhile, N, where no wall holds the
    /// string.
    pub lift_N: f64,
}

impl GelBreak {
    /// Returns the required pressure of the pump, Pa.
    pub fn pressure_Pa(&self) -> f64 {
        self.bore_Pa + self.annulus_Pa
    }
}

/// Returns the pressures that break a gel of this strength, Pa, with the bit at a measured depth,
/// m.
pub fn gel_break(model: &Model, bit_depth_m: f64, gel_strength_Pa: f64) -> GelBreak {
    let mut all = GelBreak { bore_Pa: 0.0, annulus_Pa: 0.0, lift_N: 0.0 };
    for (length_m, annulus, bore_m2) in Passages::of(model, bit_depth_m).lengths() {
        let AnnulusGel { gradient_Pa_per_m, lift_N_per_m } = annulus.gel(gel_strength_Pa);
        all.bore_Pa += length_m * bore_gradient_Pa_per_m(gel_strength_Pa, bore_m2);
        all.annulus_Pa += length_m * gradient_Pa_per_m;
        all.lift_N += length_m * lift_N_per_m;
    }
    all
}
