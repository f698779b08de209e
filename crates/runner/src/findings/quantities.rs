//! The scalars of an answer as people know them.

use std::f64::consts::TAU;

use wholestring::outcome::Scalars;
use wholestring_units::{Dimension, UnitSet};

/// What people call a quantity, how it is read, and its key in the statistics.
pub struct Quantity {
    /// What people call it.
    pub label: &'static str,
    /// What it is measured in.
    pub unit: Unit,
    /// Its name in the summary and in its statistics.
    pub key: &'static str,
    /// Its number; none where it does not apply.
    pub value: fn(&Scalars) -> Option<f64>,
}

/// What a quantity is measured in. Those of one unit show the same decimals, so that they can be
/// added up.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Unit {
    /// The unit of a dimension.
    Of(Dimension),
    /// A length, but thousands of times longer than a stretch.
    Depth,
    /// Turns of the string say more than radians.
    Turns,
}

impl Unit {
    /// Its symbol in a set of units.
    pub fn symbol(&self, units: UnitSet) -> &'static str {
        match self {
            Self::Of(dimension) => dimension.unit_in(units).symbol,
            Self::Depth => Dimension::Length.unit_in(units).symbol,
            Self::Turns => "rev",
        }
    }

    /// A value in it.
    pub fn shown(&self, si: f64, units: UnitSet) -> f64 {
        match self {
            Self::Of(dimension) => dimension.unit_in(units).from_si(si),
            Self::Depth => Dimension::Length.unit_in(units).from_si(si),
            Self::Turns => si / TAU,
        }
    }
}

const FORCE: Unit = Unit::Of(Dimension::Force);
const TORQUE: Unit = Unit::Of(Dimension::Torque);

/// The quantities, in the order in which people read them.
pub const QUANTITIES: &[Quantity] = &[
    Quantity {
        label: "Hook load without block",
        unit: FORCE,
        key: "hook_load_N",
        value: |of| Some(of.hook_load_N),
    },
    Quantity {
        label: "Axial friction",
        unit: FORCE,
        key: "axial_friction_N",
        value: |of| Some(of.axial_friction_N),
    },
    Quantity {
        label: "Weight on bit",
        unit: FORCE,
        key: "weight_on_bit_N",
        value: |of| Some(of.weight_on_bit_N),
    },
    Quantity {
        label: "Side force, total",
        unit: FORCE,
        key: "side_force_total_N",
        value: |of| Some(of.side_force_total_N),
    },
    Quantity {
        label: "Surface torque",
        unit: TORQUE,
        key: "surface_torque_N_m",
        value: |of| Some(of.surface_torque_N_m),
    },
    Quantity {
        label: "Friction torque",
        unit: TORQUE,
        key: "friction_torque_N_m",
        value: |of| Some(of.friction_torque_N_m),
    },
    Quantity {
        label: "Bit torque",
        unit: TORQUE,
        key: "bit_torque_N_m",
        value: |of| Some(of.bit_torque_N_m),
    },
    Quantity {
        label: "Twist",
        unit: Unit::Turns,
        key: "twist_rad",
        value: |of| Some(of.twist_rad),
    },
    Quantity {
        label: "Stretch",
        unit: Unit::Of(Dimension::Length),
        key: "stretch_m",
        value: |of| Some(of.stretch_m),
    },
    Quantity {
        label: "Neutral point",
        unit: Unit::Depth,
        key: "neutral_point_m",
        value: |of| of.neutral_point_m,
    },
    Quantity {
        label: "Cut-off depth",
        unit: Unit::Depth,
        key: "cutoff_depth_m",
        value: |of| of.cutoff_depth_m,
    },
];

/// A deviation with the two digits that it deserves; `0` where it is less than anybody measures.
pub fn deviation(shown: f64) -> String {
    if !shown.is_finite() {
        return "–".to_owned();
    }
    if shown < 1e-4 {
        return "0".to_owned();
    }
    let decimals = (1.0 - shown.log10().floor()).clamp(0.0, 4.0) as usize;
    format!("{shown:.decimals$}")
}
