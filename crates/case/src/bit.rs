//! `[bit]`.

use wholestring::dynamics::{BitSettings, DynamicsSettings};
use wholestring_units::Dimension;

use crate::{
    quantity::Quantity,
    range::Range,
    table::{default, optional, table},
};

table! {
    /// The bit on the rock.
    BitTable in "[bit]" {
        /// Torque of the bit at the operation's weight on bit. Where an operation drills or slides and
        /// it is not given, the bit is taken to turn freely, and a warning says so.
        torque: f64 = optional(Quantity::si(
            Dimension::Torque,
            Range::from_to(0.0, 1e6),
            "3.1 kN.m",
        ));
        /// Stiffness of the contact between bit and rock front. Only the dynamic model uses it.
        rock_stiffness: f64 = default(
            Quantity::si(Dimension::Stiffness, Range::from_to(1e4, 1e12), "1e8 N/m"),
            DynamicsSettings::default().bit.rock_stiffness_N_per_m,
        );
        /// Lateral stiffness that holds the bit to the hole's axis, instead of contact and friction
        /// with the wall: the bit fills its hole. Only the dynamic model uses it.
        lateral_stiffness: f64 = default(
            Quantity::si(Dimension::Stiffness, Range::from_to(0.0, 1e12), "1e7 N/m"),
            DynamicsSettings::default().bit.lateral_stiffness_N_per_m,
        );
    }
}

impl BitTable {
    pub(crate) fn build(&self) -> Option<BitSettings> {
        Some(BitSettings {
            rock_stiffness_N_per_m: *self.rock_stiffness.get()?,
            lateral_stiffness_N_per_m: *self.lateral_stiffness.get()?,
        })
    }
}
