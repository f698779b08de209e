//! What a dynamic run answers.

use serde::{Deserialize, Serialize};

use super::{
    energy::EnergyBalance, indicators::Indicators, node_profile::NodeProfile, statistic::Statistic,
    time_series::TimeSeries,
};
use crate::{dynamics::boundary::bit::TableUse, mud::Hydraulics, outcome::Scalars};

/// How much of the time a node touches the wall.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ContactClass {
    /// In less than a hundredth of the samples.
    None,
    /// Now and then.
    Intermittent,
    /// In more than ninety-nine hundredths of the samples.
    Continuous,
}

impl ContactClass {
    /// The class of a part of the samples.
    pub fn of(contact_fraction: f64) -> Self {
        if contact_fraction < 0.01 {
            Self::None
        } else if contact_fraction <= 0.99 {
            Self::Intermittent
        } else {
            Self::Continuous
        }
    }

    /// Name in results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Intermittent => "intermittent",
            Self::Continuous => "continuous",
        }
    }
}

/// How the run was computed and how well.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Numerics {
    /// Number of elements.
    pub elements: usize,
    /// Step, s.
    pub time_step_s: f64,
    /// Steps done.
    pub steps: u64,
    /// Axial mass lent to short elements over that of the string.
    pub added_axial_mass_fraction: f64,
    /// Deepest penetration of the wall at any sample, m, by the geometry: of the nodes that touch it, and of the bit,
    /// which is held to the axis of the hole that it cuts.
    pub max_penetration_m: f64,
    /// Work put in at top drive, hoist and bit less the change of energy and every loss, over the
    /// largest of them, of the kinetic energy and of what lifts the string by a millimetre: what the integration itself
    /// gained or lost. From the start of the window. 1, and no parts, in a run that diverged.
    pub energy_residual: f64,
    /// Its parts; none before the window began and in a run that diverged.
    pub energy: Option<EnergyBalance>,
    /// Instruction set that the time loop was compiled for.
    pub instructions: &'static str,
    /// Time at which the window begins, s: that of its first sample, at the earliest. The time reached of a run that settles yet.
    pub settle_s: f64,
    /// Whether the string was steady then; none where the time was given, and of a run that settles yet.
    pub settled: Option<bool>,
    /// Measured depth of the bit, on average over the window, m.
    pub mean_bit_depth_m: f64,
    /// How far the bit went in the window, m, positive downwards.
    pub bit_travel_m: f64,
}

/// Work of friction on the hole over the window, from the surface down, one row per stretch of hole.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct HoleWear {
    /// Measured depth of the middle of the stretch, m.
    pub md_m: Vec<f64>,
    /// Work per metre of hole, J/m: friction force times sliding distance.
    pub wear_work_J_per_m: Vec<f64>,
    /// Its mean rate, W/m.
    pub wear_power_W_per_m: Vec<f64>,
}

/// Contact over depth and time, coarse: row after row in time, each from the surface down. A stretch of string stands
/// in a row, at most 200 of them, and each row is an average over the time since the one before, at most 201.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct ContactMap {
    /// Time at which the row ends, s.
    pub time_s: Vec<f64>,
    /// Measured depth of the middle of the stretch, m.
    pub md_m: Vec<f64>,
    /// Mean signed side force per metre, positive on the high side, N/m.
    pub side_force_N_per_m: Vec<f64>,
    /// Mean magnitude of the contact force per metre, N/m.
    pub contact_force_N_per_m: Vec<f64>,
}

impl DynamicOutcome {
    /// The scalars that [`Self::statistics`] tells of, in its order.
    pub fn quantities() -> impl Iterator<Item = &'static str> {
        crate::dynamics::output::varying::varying(&TimeSeries::default())
            .map(|scalar| scalar.name)
            .into_iter()
    }
}

/// Everything that a run answers.
#[derive(Debug, Clone, PartialEq)]
pub struct DynamicOutcome {
    /// Means over the window under the names that every solver shares.
    pub scalars: Scalars,
    /// Distributions over the window of the scalars that vary, by their name.
    pub statistics: Vec<(&'static str, Statistic)>,
    /// What the mud did, on average over the window; none without a rheology.
    pub hydraulics: Option<Hydraulics>,
    /// How it was computed.
    pub numerics: Numerics,
    /// What the motion amounts to, in the figures of the field.
    pub indicators: Indicators,
    /// How often a bit with a table was where the table is not, over the window; none of another bit.
    pub bit_table: Option<TableUse>,
    /// Profile along the string.
    pub nodes: NodeProfile,
    /// Wear along the hole.
    pub wear: HoleWear,
    /// Contact over depth and time.
    pub contact: ContactMap,
    /// Scalars against time.
    pub series: TimeSeries,
}
