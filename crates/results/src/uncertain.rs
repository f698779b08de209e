//! What is not known exactly and what comes of it, of plans and reaches alike.

use serde::{Deserialize, Serialize};

use crate::{Table, UNCERTAIN, UNCERTAIN_INDICES, UNCERTAIN_STOPS};

/// What samples of uncertain numbers came to.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct UncertainSummary {
    /// Name of the model that solved the samples.
    pub model: String,
    /// How many were drawn.
    pub samples: usize,
    /// How many of them were solved: fewer where the work was interrupted.
    pub solved: usize,
    /// How many of these have points without an answer.
    pub lacking: usize,
    /// Why, and of how many samples it is the first reason.
    pub reasons: Vec<(String, usize)>,
    /// Seed of the draw.
    pub seed: u64,
    /// The inputs.
    pub inputs: Vec<UncertainKey>,
    /// How the answers scatter.
    pub bands: Vec<UncertainBand>,
    /// Of a reach, what stops the well first, and in how many samples; most first.
    pub stops: Vec<UncertainStop>,
}

/// An uncertain number.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct UncertainKey {
    /// Its key.
    pub key: String,
    /// How it is distributed, in words.
    pub distribution: String,
}

/// How a number scatters.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct UncertainBand {
    /// `hook_load`, `surface_torque`, `reserve`, `sinusoidal_weight`, `helical_weight`, `depth`, `margin`.
    pub quantity: String,
    /// The limit; empty of others.
    pub limit: String,
    /// The operation; empty of all.
    pub operation: String,
    /// Friction factor of all sections; none where they have their own.
    pub friction: Option<f64>,
    /// Measured depth of the bit, m; none of all depths.
    pub bit_depth_m: Option<f64>,
    /// SI unit.
    pub unit: String,
    /// The case's own number.
    pub expected: Option<f64>,
    /// Below these lie 5, 10, 50, 90 and 95 % of the samples.
    pub quantiles: [f64; 5],
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub std: f64,
    /// Samples that have it.
    pub answers: usize,
    /// Samples without an answer.
    pub without_answer: usize,
    /// Of a depth, samples whose limit is not met.
    pub not_met: usize,
    /// Which inputs it is owed to; none where that was not looked for or it does not scatter.
    pub owed: Option<UncertainOwed>,
}

/// Which inputs a number owes its scatter to; one value for each input.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct UncertainOwed {
    /// First-order indices.
    pub first: Vec<Option<f64>>,
    /// Total indices.
    pub total: Vec<f64>,
    /// What part of the variance the fit predicts.
    pub predicts: f64,
    /// Degree of its polynomials.
    pub degree: usize,
}

/// What stops a well first.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct UncertainStop {
    /// Friction factor of all sections; none where they have their own.
    pub friction: Option<f64>,
    /// The operation; empty where nothing stops it.
    pub operation: String,
    /// The limit; empty where nothing stops it.
    pub limit: String,
    /// In how many samples.
    pub samples: usize,
}

impl UncertainSummary {
    /// A row for each number that scatters.
    pub fn table(&self) -> Table {
        let mut table = Table::with_columns(UNCERTAIN);
        for of in &self.bands {
            let [p05, p10, p50, p90, p95] = of.quantiles.map(|value| [value]);
            table.append(
                &[
                    ("quantity", &[&of.quantity]),
                    ("limit", &[&of.limit]),
                    ("operation", &[&of.operation]),
                    ("unit", &[&of.unit]),
                ],
                &[
                    ("friction", &number(of.friction)),
                    ("bit_depth_m", &number(of.bit_depth_m)),
                    ("expected", &number(of.expected)),
                    ("p05", &p05),
                    ("p10", &p10),
                    ("p50", &p50),
                    ("p90", &p90),
                    ("p95", &p95),
                    ("mean", &[of.mean]),
                    ("std", &[of.std]),
                    ("answers", &[of.answers as f64]),
                    ("without_answer", &[of.without_answer as f64]),
                    ("not_met", &[of.not_met as f64]),
                ],
            );
        }
        table
    }

    /// A row for each stop and friction.
    pub fn stops_table(&self) -> Table {
        let mut table = Table::with_columns(UNCERTAIN_STOPS);
        for of in &self.stops {
            table.append(
                &[("operation", &[&of.operation]), ("limit", &[&of.limit])],
                &[("friction", &number(of.friction)), ("samples", &[of.samples as f64])],
            );
        }
        table
    }

    /// A row for each number and input.
    pub fn indices_table(&self) -> Table {
        let mut table = Table::with_columns(UNCERTAIN_INDICES);
        for of in &self.bands {
            let Some(owed) = &of.owed else { continue };
            let each = self.inputs.iter().zip(&owed.first).zip(&owed.total);
            for ((input, first), total) in each {
                table.append(
                    &[
                        ("quantity", &[&of.quantity]),
                        ("limit", &[&of.limit]),
                        ("operation", &[&of.operation]),
                        ("input", &[&input.key]),
                    ],
                    &[
                        ("friction", &number(of.friction)),
                        ("bit_depth_m", &number(of.bit_depth_m)),
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

fn number(of: Option<f64>) -> [f64; 1] {
    [of.unwrap_or(f64::NAN)]
}
