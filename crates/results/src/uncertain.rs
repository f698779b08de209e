//! Uncertain inputs and their effect, for plans and reaches alike.

use serde::{Deserialize, Serialize};
use wholestring::{operation::OperationKind, outcome::ModelKind};

use crate::{Table, UNCERTAIN, UNCERTAIN_INDICES, UNCERTAIN_STOPS, or_empty};

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

/// Distribution of a number.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct UncertainBand {
    /// `hook_load`, `surface_torque`, `reserve`, `sinusoidal_weight`, `helical_weight`, `depth` or
    /// `margin`.
    pub quantity: String,
    /// The limit; empty for other numbers.
    pub limit: String,
    /// The operation; none for all, empty in the file.
    #[serde(with = "or_empty")]
    pub operation: Option<OperationKind>,
    /// Friction factor of all sections; none where they have their own.
    pub friction: Option<f64>,
    /// Measured depth of the bit, m; none for all depths.
    pub bit_depth_m: Option<f64>,
    /// SI unit.
    pub unit: String,
    /// The case's own number.
    pub expected: Option<f64>,
    /// The 5th, 10th, 50th, 90th and 95th percentiles of the samples.
    pub quantiles: [f64; 5],
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub std: f64,
    /// Samples that have it.
    pub answers: usize,
    /// Samples without an answer.
    pub without_answer: usize,
    /// For a depth, samples whose limit is not reached.
    pub not_met: usize,
    /// Sensitivity to the inputs (Sobol indices); none where it was not computed or the number does
    /// not scatter.
    pub owed: Option<UncertainOwed>,
}

/// Sensitivity of a number to the inputs (Sobol indices); one value for each input.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct UncertainOwed {
    /// First-order indices.
    pub first: Vec<Option<f64>>,
    /// Total indices.
    pub total: Vec<f64>,
    /// Part of the variance that the fit predicts.
    pub predicts: f64,
    /// Degree of its polynomials.
    pub degree: usize,
}

/// Limit that stops a well first.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct UncertainStop {
    /// Friction factor of all sections; none where they have their own.
    pub friction: Option<f64>,
    /// The operation; none where nothing stops it, empty in the file.
    #[serde(with = "or_empty")]
    pub operation: Option<OperationKind>,
    /// The limit; empty where nothing stops it.
    pub limit: String,
    /// Number of samples.
    pub samples: usize,
}

/// Name of an operation; empty where there is none.
fn name(operation: Option<OperationKind>) -> &'static str {
    operation.map_or("", OperationKind::name)
}

impl UncertainSummary {
    /// A row for each number that scatters.
    pub fn table(&self) -> Table {
        let mut table = Table::with_columns(UNCERTAIN);
        for band in &self.bands {
            let [p05, p10, p50, p90, p95] = band.quantiles.map(|value| [value]);
            table.append(
                &[
                    ("quantity", &[&band.quantity]),
                    ("limit", &[&band.limit]),
                    ("operation", &[name(band.operation)]),
                    ("unit", &[&band.unit]),
                ],
                &[
                    ("friction", &number(band.friction)),
                    ("bit_depth_m", &number(band.bit_depth_m)),
                    ("expected", &number(band.expected)),
                    ("p05", &p05),
                    ("p10", &p10),
                    ("p50", &p50),
                    ("p90", &p90),
                    ("p95", &p95),
                    ("mean", &[band.mean]),
                    ("std", &[band.std]),
                    ("answers", &[band.answers as f64]),
                    ("without_answer", &[band.without_answer as f64]),
                    ("not_met", &[band.not_met as f64]),
                ],
            );
        }
        table
    }

    /// A row for each stop and friction.
    pub fn stops_table(&self) -> Table {
        let mut table = Table::with_columns(UNCERTAIN_STOPS);
        for stop in &self.stops {
            table.append(
                &[("operation", &[name(stop.operation)]), ("limit", &[&stop.limit])],
                &[("friction", &number(stop.friction)), ("samples", &[stop.samples as f64])],
            );
        }
        table
    }

    /// A row for each number and input.
    pub fn indices_table(&self) -> Table {
        let mut table = Table::with_columns(UNCERTAIN_INDICES);
        for band in &self.bands {
            let Some(owed) = &band.owed else { continue };
            let each = self.inputs.iter().zip(&owed.first).zip(&owed.total);
            for ((input, first), total) in each {
                table.append(
                    &[
                        ("quantity", &[&band.quantity]),
                        ("limit", &[&band.limit]),
                        ("operation", &[name(band.operation)]),
                        ("input", &[&input.key]),
                    ],
                    &[
                        ("friction", &number(band.friction)),
                        ("bit_depth_m", &number(band.bit_depth_m)),
                        ("first_order", &number(*first)),
                        ("total", &[*total]),
                        ("predicts", &[owed.predicts]),
                        ("degree", &[owed.degree as f64]),
                    ],
                );
            }
        }
        table
    }
}

fn number(value: Option<f64>) -> [f64; 1] {
    [value.unwrap_or(f64::NAN)]
}
