//! Surge and swab: the pressure of a string that moves with its pumps off.

use std::convert::Infallible;

use wholestring::{mud::Motion, operation::Operation};

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
