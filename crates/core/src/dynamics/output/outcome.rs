//! Results of a dynamic run.

use std::borrow::Cow;

use serde::{Deserialize, Serialize};

use super::{energy::EnergyBalance, indicators::Indicators, statistic::Statistic};
use crate::{
    dynamics::boundary::bit::TableUse,
    mud::Hydraulics,
    outcome::{ContactMap, HoleWear, Profile, Scalars, TimeSeries, VARYING},
    rod::buckled_element::BuckledElement,
};

/// Deepest penetration of the wall by a node that touches it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct DeepestContact {
    /// Depth in the wall, m.
    pub penetration_m: f64,
    /// Measured depth at that time, m.
    pub md_m: f64,
}

/// Method and accuracy of the computation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Numerics {
    /// Number of elements.
    pub elements: usize,
    /// Step, s.
    #[serde(with = "crate::finite::unsigned_zero")]
    pub time_step_s: f64,
    /// Steps of the bottom-hole assembly in each, where it has steps of its own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub assembly_steps: Option<u32>,
    /// Steps done.
    pub steps: u64,
    /// Axial mass added by scaling to short elements over that of the string.
    #[serde(with = "crate::finite::unsigned_zero")]
    pub added_axial_mass_fraction: f64,
    /// Deepest penetration of the wall at any sample, m, by the geometry: of the nodes that touch
    /// it, and of the bit, which is held to the axis of the hole that it cuts.
    #[serde(with = "crate::finite::unsigned_zero")]
    pub max_penetration_m: f64,
    /// The same of the nodes that touch the wall alone, with its place; none where no node touched.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub deepest_contact: Option<DeepestContact>,
    /// Work put in at top drive, hoist and bit less the change of energy and every loss, over the
    /// largest of them, of the kinetic energy and of the energy that lifts the string by a
    /// millimetre: the gain or loss of the integration itself. From the start of the window. 1, and
    /// no parts, in a run that diverged.
    #[serde(with = "crate::finite::unsigned_zero")]
    pub energy_residual: f64,
    /// Its parts; none before the window began and in a run that diverged.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub energy: Option<EnergyBalance>,
    /// Instruction set that the time loop was compiled for.
    pub instructions: Cow<'static, str>,
    /// Time at which the window begins, s: that of its first sample, at the earliest. The time
    /// reached in a run that is still settling. Not a number in files of versions that did not
    /// write it.
    #[serde(
        with = "crate::finite::unsigned_zero",
        default = "crate::finite::unknown",
        skip_serializing_if = "crate::finite::is_unknown"
    )]
    pub settle_s: f64,
    /// Whether the string was steady then; none where the time was given, and of a run that settles
    /// yet.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub settled: Option<bool>,
    /// Measured depth of the bit, on average over the window, m; as [`Self::settle_s`].
    #[serde(
        with = "crate::finite::unsigned_zero",
        default = "crate::finite::unknown",
        skip_serializing_if = "crate::finite::is_unknown"
    )]
    pub mean_bit_depth_m: f64,
    /// Travel of the bit in the window, m, positive downwards; missing values as for
    /// [`Self::settle_s`].
    #[serde(
        with = "crate::finite::unsigned_zero",
        default = "crate::finite::unknown",
        skip_serializing_if = "crate::finite::is_unknown"
    )]
    pub bit_travel_m: f64,
    /// The element that buckled most beyond its own load between its nodes, at any time of the run;
    /// none of a string whose elements are short enough for the compression on them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub buckled_element: Option<BuckledElement>,
}

impl DynamicOutcome {
    /// The scalars that [`Self::statistics`] reports, in its order.
    pub fn quantities() -> impl Iterator<Item = &'static str> {
        VARYING.into_iter().map(|column| column.quantity.name)
    }

    /// The statistic of one of [`Self::quantities`].
    pub fn statistic(&self, name: &str) -> Option<&Statistic> {
        self.statistics
            .iter()
            .find(|(statistic, _)| *statistic == name)
            .map(|(_, statistic)| statistic)
    }
}

/// Everything that a run answers.
#[derive(Debug, Clone, PartialEq)]
pub struct DynamicOutcome {
    /// Means over the window under the names that every solver shares.
    pub scalars: Scalars,
    /// Distributions over the window of the scalars that vary, by their name.
    pub statistics: Vec<(&'static str, Statistic)>,
    /// Means of the mud's effects over the window; none without a rheology.
    pub hydraulics: Option<Hydraulics>,
    /// Method of the computation.
    pub numerics: Numerics,
    /// Indicators of the motion that the field uses.
    pub indicators: Indicators,
    /// Count of the bit's excursions outside its table over the window; none for a bit without a
    /// table.
    pub bit_table: Option<TableUse>,
    /// Profile along the string.
    pub nodes: Profile,
    /// Wear along the hole.
    pub wear: HoleWear,
    /// Contact over depth and time.
    pub contact: ContactMap,
    /// Scalars against time.
    pub series: TimeSeries,
}
