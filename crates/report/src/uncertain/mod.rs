//! Contents of a page on uncertain numbers, for plans and reaches alike.

mod figure;
mod tables;
use wholestring::operation::OperationKind;

#[cfg(test)]
mod tests;

pub(crate) use figure::figure;
pub(crate) use tables::{bands, inputs, owed, stops};

/// Caption of the picture.
pub(crate) const CAPTION: &str = "With the bit at its deepest: the length of each bar is the total \
    Sobol index of an uncertain number, the point its first-order index. Where they differ, the \
    number interacts with others.";

/// Uncertain inputs and their effect. Numbers are SI.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Uncertain {
    /// Description of the bands, and of the samples missing from them, in sentences.
    pub notes: Vec<String>,
    /// Keys of the inputs, and their distributions.
    pub inputs: Vec<[String; 2]>,
    /// Distributions of the results.
    pub bands: Vec<UncertainNumber>,
    /// Limits that stop a well first, and the number of samples of each; for a reach.
    pub stops: Vec<(String, usize)>,
    /// The names of its tables: bands, indices, samples and stops; a plan has no stops.
    pub files: [String; 4],
}

/// Distribution of a number.
#[derive(Debug, Clone, PartialEq)]
pub struct UncertainNumber {
    /// Its name in the tables: `hook_load`, ...
    pub quantity: String,
    /// The same in words, with its limit.
    pub title: String,
    /// The limit in words; empty for other numbers.
    pub limit: String,
    /// Its operation; none for all.
    pub operation: Option<OperationKind>,
    /// Friction factor of all sections; `None` where they have their own.
    pub friction: Option<f64>,
    /// Measured depth of the bit, m; `None` for all depths.
    pub bit_depth_m: Option<f64>,
    /// Its dimension.
    pub dimension: String,
    /// The case's own value; not a number where it has none.
    pub expected: f64,
    /// The 5th, 10th, 50th, 90th and 95th percentiles of the samples.
    pub quantiles: [f64; 5],
    /// Samples that have it.
    pub answers: usize,
    /// Samples without an answer.
    pub without_answer: usize,
    /// For a depth, samples whose limit is not reached.
    pub not_met: usize,
    /// Its sensitivity to the inputs; `None` where it does not scatter.
    pub owed: Option<UncertainShares>,
}

/// Sensitivity of a number to the inputs (Sobol indices).
#[derive(Debug, Clone, PartialEq)]
pub struct UncertainShares {
    /// First-order indices; not a number where they are not known.
    pub first: Vec<f64>,
    /// Total indices.
    pub total: Vec<f64>,
    /// Part of the variance that the fit predicts.
    pub predicts: f64,
}

impl Uncertain {
    /// The band of an operation down the hole: depth, and the values between which 90 % of the
    /// samples are.
    pub(crate) fn band<'a>(
        &'a self,
        quantity: &'a str,
        operation: OperationKind,
    ) -> impl Iterator<Item = (f64, [f64; 2])> + 'a {
        let bands = self.bands.iter();
        let numbers = bands.filter(move |number| {
            number.quantity == quantity && number.operation == Some(operation)
        });
        numbers.filter_map(|number| {
            Some((number.bit_depth_m?, [number.quantiles[0], number.quantiles[4]]))
        })
    }

    /// Description of the bands, for the head of a picture.
    pub(crate) fn description(&self) -> String {
        self.notes.first().map_or_else(String::new, |note| note.trim_end_matches('.').to_owned())
    }

    /// The listed numbers: of one depth, the deepest of several; and for each kind of limit, the
    /// operation that is nearest to it.
    fn listed(&self) -> impl Iterator<Item = &UncertainNumber> {
        let depths = self.bands.iter().filter(|band| band.quantity != "margin");
        let deepest_m = depths.clone().filter_map(|depth| depth.bit_depth_m).fold(0.0, f64::max);
        let deepest = depths
            .filter(move |depth| depth.bit_depth_m.is_none_or(|depth_m| depth_m == deepest_m));
        deepest.filter(|deepest| deepest.quantity != "reserve" || self.is_nearest(deepest))
    }

    /// Whether no other operation has a smaller reserve of a limit.
    fn is_nearest(&self, number: &UncertainNumber) -> bool {
        let mut alike = self.bands.iter();
        let less = |one: &UncertainNumber| one.quantiles[0] < number.quantiles[0];
        !alike.any(|one| one.quantity == number.quantity && one.limit == number.limit && less(one))
    }

    /// Whether the listed numbers are of more than one friction.
    fn has_frictions(&self) -> bool {
        self.bands.windows(2).any(|pair| pair[0].friction != pair[1].friction)
    }
}
