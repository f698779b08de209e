//! The scalars against time that spectra can be taken of.

use std::borrow::Cow;

use serde::Serialize;

use super::{
    quantity::{Column, Values},
    time_series::{TIME_SERIES, TimeSeries},
};

/// A scalar against time.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
pub enum Signal {
    /// Hook load.
    HookLoad,
    /// Surface torque.
    SurfaceTorque,
    /// Friction torque.
    FrictionTorque,
    /// Axial friction.
    AxialFriction,
    /// Side force, summed along the string.
    SideForceTotal,
    /// Weight on bit.
    WeightOnBit,
    /// Bit torque.
    BitTorque,
    /// Rotary speed of the bit.
    BitRotarySpeed,
    /// Block velocity.
    BlockVelocity,
    /// Turn of the top against the bit.
    Twist,
    /// Elongation.
    Stretch,
}

impl Signal {
    /// Every signal.
    pub const ALL: [Self; 11] = [
        Self::HookLoad,
        Self::SurfaceTorque,
        Self::FrictionTorque,
        Self::AxialFriction,
        Self::SideForceTotal,
        Self::WeightOnBit,
        Self::BitTorque,
        Self::BitRotarySpeed,
        Self::BlockVelocity,
        Self::Twist,
        Self::Stretch,
    ];

    /// Name in case files and results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::HookLoad => "hook_load",
            Self::SurfaceTorque => "surface_torque",
            Self::FrictionTorque => "friction_torque",
            Self::AxialFriction => "axial_friction",
            Self::SideForceTotal => "side_force_total",
            Self::WeightOnBit => "weight_on_bit",
            Self::BitTorque => "bit_torque",
            Self::BitRotarySpeed => "bit_rotary_speed",
            Self::BlockVelocity => "block_velocity",
            Self::Twist => "twist",
            Self::Stretch => "stretch",
        }
    }

    /// The column that it is.
    ///
    /// # Panics
    /// Never: each is one, which the tests hold.
    fn column(self) -> &'static Column<TimeSeries> {
        let mut all = TIME_SERIES.iter();
        all.find(|column| column.quantity.stem() == self.name())
            .expect("a signal is a column against time")
    }

    /// Symbol of its unit.
    pub fn unit(self) -> &'static str {
        self.column().quantity.unit
    }

    /// Its samples.
    pub fn of(self, series: &TimeSeries) -> &[f64] {
        match (self.column().of)(series) {
            Values::Numbers(Cow::Borrowed(samples)) => samples,
            // A column with gaps has no spectrum, and is no signal.
            Values::Numbers(Cow::Owned(_)) | Values::Words(_) => &[],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_signal_is_a_column_without_gaps() {
        let series = TimeSeries::default();
        for signal in Signal::ALL {
            let values = (signal.column().of)(&series);
            assert!(matches!(values, Values::Numbers(Cow::Borrowed(_))), "{signal:?}");
        }
    }
}
