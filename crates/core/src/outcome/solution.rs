//! Results of a method for one operation: the same parts for every method.

use super::{
    along_hole::{ContactMap, HoleWear},
    along_string::Profile,
    history::{EarlierRows, History},
    method::ModelKind,
    scalars::Scalars,
};
use crate::{
    dynamics::{DynamicOutcome, Indicators, Numerics, Statistic, TableUse},
    mud::Hydraulics,
    statics::{
        soft::SoftProfile,
        stiff::{EquilibriumSummary, StiffProfile},
    },
};

/// Results of a method, to be written, drawn or compared.
#[derive(Debug, Clone, Copy)]
pub struct Solution<'a> {
    /// The method.
    pub model: ModelKind,
    /// Torque and drag.
    pub scalars: Scalars,
    /// Effect of the mud; none without a rheology.
    pub hydraulics: Option<Hydraulics>,
    /// Along the string.
    pub profile: &'a Profile,
    /// Along the hole.
    pub wear: &'a HoleWear,
    /// For an equilibrium: the method of its solution, and the loads of its bit. The stiff string
    /// only.
    pub at_rest: Option<EquilibriumSummary>,
    /// In time; none for a method that computes a state of equilibrium.
    pub in_time: Option<InTime<'a>>,
}

/// Additional results of a method in time.
#[derive(Debug, Clone, Copy)]
pub struct InTime<'a> {
    /// Distributions over the window of the scalars that vary, by their name.
    pub statistics: &'a [(&'static str, Statistic)],
    /// Method and accuracy of the computation.
    pub numerics: &'a Numerics,
    /// Indicators of the motion.
    pub indicators: &'a Indicators,
    /// Count of the excursions of a bit outside its table; none for a bit without a table.
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
    fn from(soft: &'a SoftProfile) -> Self {
        // Every field is named: a new one is either a part of every solution or the method's own.
        let SoftProfile { profile, contact_direction: _, wear, scalars, hydraulics } = soft;
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
    fn from(stiff: &'a StiffProfile) -> Self {
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
        } = stiff;
        Self {
            model: ModelKind::Stiff,
            scalars: *scalars,
            hydraulics: *hydraulics,
            profile,
            wear,
            at_rest: Some(stiff.into()),
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
