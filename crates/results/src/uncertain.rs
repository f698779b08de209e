//! Uncertain inputs and their effect, for plans and reaches alike.

use serde::{Deserialize, Serialize};
use wholestring::outcome::ModelKind;

use crate::{Row, Table, UncertainBand, UncertainIndex, UncertainStop};

/// Names of the tables of uncertain inputs, without their extensions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct UncertainTables {
    /// Scatter of the samples.
    pub bands: &'static str,
    /// Sensitivity (Sobol) indices.
    pub indices: &'static str,
    /// Sampled inputs.
    pub samples: &'static str,
    /// The limit that stops the well first, with its frequency; none for a plan.
    pub stops: Option<&'static str>,
}

impl UncertainTables {
    /// Names for a plan.
    pub const PLAN: Self = Self {
        bands: "plan_uncertain",
        indices: "plan_uncertain_indices",
        samples: "plan_uncertain_samples",
        stops: None,
    };
    /// Names for a reach.
    pub const REACH: Self = Self {
        bands: "reach_uncertain",
        indices: "reach_uncertain_indices",
        samples: "reach_uncertain_samples",
        stops: Some("reach_uncertain_stops"),
    };
}

/// Results of samples of uncertain numbers.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct UncertainSummary {
    /// The model that solved the samples.
    pub model: ModelKind,
    /// Number of samples drawn.
    pub samples: usize,
    /// Number of samples solved: fewer where the work was interrupted.
    pub solved: usize,
    /// Number of these with points without an answer.
    pub lacking: usize,
    /// Reasons, and the number of samples for which each is the first.
    pub reasons: Vec<(String, usize)>,
    /// Seed of the draw.
    pub seed: u64,
    /// The inputs.
    pub inputs: Vec<UncertainKey>,
    /// Distribution of the answers.
    pub bands: Vec<UncertainBand>,
    /// For a reach, the limits that stop the well first, and their numbers of samples; most
    /// frequent first.
    pub stops: Vec<UncertainStop>,
}

/// An uncertain number.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct UncertainKey {
    /// Its key.
    pub key: String,
    /// Its distribution, in words.
    pub distribution: String,
}

impl UncertainSummary {
    /// A row for each number that scatters.
    pub fn table(&self) -> Table {
        UncertainBand::table(&self.bands)
    }

    /// A row for each stop and friction.
    pub fn stops_table(&self) -> Table {
        UncertainStop::table(&self.stops)
    }

    /// A row for each number and input.
    pub fn indices_table(&self) -> Table {
        let bands = self.bands.iter().filter_map(|band| Some((band, band.owed.as_ref()?)));
        let rows = bands.flat_map(|(band, owed)| {
            let each = self.inputs.iter().zip(&owed.first).zip(&owed.total);
            each.map(|((input, first), total)| UncertainIndex {
                quantity: band.quantity.clone(),
                limit: band.limit.clone(),
                operation: band.operation,
                friction: band.friction,
                bit_depth_m: band.bit_depth_m,
                input: input.key.clone(),
                first_order: *first,
                total: *total,
                predicts: owed.predicts,
                degree: owed.degree,
            })
        });
        UncertainIndex::table(rows)
    }
}
