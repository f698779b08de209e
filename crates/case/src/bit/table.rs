//! The keys of `[bit]`.

use std::f64::consts::PI;

use wholestring::dynamics::BitSettings;
use wholestring_config::prelude::*;

use super::{law::Laws, motor::MotorTable};

table! {
    /// The bit on the rock.
    BitTable in "[bit]" {
        ..laws: Laws;
        /// Speed at which a mud motor turns the bit relative to the string, whatever the torque; a
        /// bare number is in rev/min. "slide" needs it, or `[bit.motor]`, where the bit's angle
        /// counts: in all laws but the rate law, and with an excitation.
        motor_speed: f64 = optional(
            Quantity::si(
                Dimension::RotarySpeed,
                Range::from_to(0.0, 1000.0 * PI / 30.0).usual(10.0 * PI / 30.0, 600.0 * PI / 30.0),
                "120 rpm",
            )
            .bare("rev/min", PI / 30.0),
        );
        /// A mud motor whose speed depends on flow and torque.
        motor: MotorTable = optional(Section::<MotorTable>::RULE);
        /// Side cutting: sideways cut of the bit per side force over its axial cut per weight.
        /// Raising it lets a side force move the bit off the hole's axis faster. Only the dynamic
        /// model uses it.
        steerability: f64 = default(Number::up_to(1.0), 0.0);
        /// Lateral stiffness that holds the bit to the hole's axis, in place of contact and
        /// friction with the wall, because the bit fills its hole. Raising it holds the bit closer.
        /// On solid rock it represents wall detail finer than the elements; with 0 the elements
        /// alone hold the bit. The soft string does not use it.
        lateral_stiffness: f64 = default(
            Quantity::si(Dimension::Stiffness, Range::from_to(0.0, 1e12).usual(1e4, 1e10), "1e7 N/m"),
            BitSettings::default().lateral_stiffness_N_per_m,
        );
    }
}
