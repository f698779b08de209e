//! What a method answers of one operation: the same parts, whatever the method.

use super::{
    along_string::Profile, contact_map::ContactMap, history::EarlierRows, history::History,
    hole_wear::HoleWear, method::ModelKind, scalars::Scalars,
};
use crate::{
    dynamics::{DynamicOutcome, Indicators, Numerics, Statistic, TableUse},
    mud::Hydraulics,
    statics::{
        soft::SoftProfile,
        stiff::{EquilibriumSummary, StiffProfile},
    },
};

/// The answer of a method, for whoever writes it down, draws it or compares it.
#[derive(Debug, Clone, Copy)]
pub struct Solution<'a> {
    /// The method.
    pub model: ModelKind,
    /// Torque and drag.
    pub scalars: Scalars,
    /// What the mud does; none without a rheology.
    pub hydraulics: Option<Hydraulics>,
    /// Along the string.
    pub profile: &'a Profile,
    /// Along the hole.
    pub wear: &'a HoleWear,
    /// Of an equilibrium: how it was found, and what its bit does. The stiff string only.
    pub at_rest: Option<EquilibriumSummary>,
    /// In time; none of a method that answers with a state of equilibrium.
    pub in_time: Option<InTime<'a>>,
}

/// What a method in time answers besides.
#[derive(Debug, Clone, Copy)]
pub struct InTime<'a> {
    /// Distributions over the window of the scalars that vary, by their name.
    pub statistics: &'a [(&'static str, Statistic)],
    /// How it was computed.
    pub numerics: &'a Numerics,
    /// What the motion amounts to.
    pub indicators: &'a Indicators,
    /// How often a bit with a table was where the table is not; none of another bit.
    pub bit_table: Option<TableUse>,
    /// Contact over depth and time.
    pub contact: &'a ContactMap,
    /// Scalars against time.
    pub history: History<'a>,
}

impl<'a> Solution<'a> {
    /// The same with the rows of its history that were handed over.
    #[must_use]
    pub fn with_earlier(mut self, earlier: Option<&'a dyn EarlierRows>) -> Self {
        if let Some(in_time) = &mut self.in_time {
            in_time.history = History::new(earlier, in_time.history.series());
        }
        self
    }
}

impl<'a> From<&'a SoftProfile> for Solution<'a> {
    fn from(of: &'a SoftProfile) -> Self {
        // Every field is named: a new one is either a part of every solution or the method's own.
        let SoftProfile { profile, contact_direction: _, wear, scalars, hydraulics } = of;
        Self {
            model: ModelKind::Soft,
            scalars: *scalars,
            hydraulics: *hydraulics,
            profile,
            wear,
            at_rest: None,
            in_time: None,
        }
    }
}

impl<'a> From<&'a StiffProfile> for Solution<'a> {
    fn from(of: &'a StiffProfile) -> Self {
        let StiffProfile {
            profile,
            wear,
            scalars,
            hydraulics,
            bit_side_force_N: _,
            bit_tilt_rad: _,
            axis: _,
            deepest_penetration_m: _,
            convergence: _,
        } = of;
        Self {
            model: ModelKind::Stiff,
            scalars: *scalars,
            hydraulics: *hydraulics,
            profile,
            wear,
            at_rest: Some(of.into()),
            in_time: None,
        }
    }
}

impl<'a> From<&'a DynamicOutcome> for Solution<'a> {
    fn from(outcome: &'a DynamicOutcome) -> Self {
        let DynamicOutcome {
            scalars,
            statistics,
            hydraulics,
            numerics,
            indicators,
            bit_table,
            nodes,
            wear,
            contact,
            series,
        } = outcome;
        Self {
            model: ModelKind::Dynamic,
            scalars: *scalars,
            hydraulics: *hydraulics,
            profile: nodes,
            wear,
            at_rest: None,
            in_time: Some(InTime {
                statistics,
                numerics,
                indicators,
                bit_table: *bit_table,
                contact,
                history: History::new(None, series),
            }),
        }
    }
}
