//! What a page reports of numbers that are not known exactly, of plans and reaches alike.

mod figure;
mod tables;
#[cfg(test)]
mod tests;

pub(crate) use figure::figure;
pub(crate) use tables::{bands, inputs, owed, stops};

/// What stands under the picture.
pub(crate) const CAPTION: &str = "With the bit at its deepest: the total Sobol index of each uncertain number \
    is the length of its bar, its first-order index the point. Where they differ the number acts together \
    with others.";

/// What is not known exactly, and what comes of it. Numbers are SI.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Uncertain {
    /// What the bands are of, and what is missing from them, in sentences.
    pub notes: Vec<String>,
    /// Keys of the inputs, and how they are distributed.
    pub inputs: Vec<[String; 2]>,
    /// How numbers scatter.
    pub bands: Vec<UncertainNumber>,
    /// What stops a well first, and in how many of the samples; of a reach.
    pub stops: Vec<(String, usize)>,
    /// The names of its tables: of bands, indices, samples and stops; a plan has none of stops.
    pub files: [String; 4],
}

/// How a number scatters.
#[derive(Debug, Clone, PartialEq)]
pub struct UncertainNumber {
    /// What it is, as the tables have it: `hook_load`, ...
    pub quantity: String,
    /// The same in words, with its limit.
    pub title: String,
    /// The limit in words; empty of others.
    pub limit: String,
    /// Name of its operation; empty of all.
    pub operation: String,
    /// Friction factor of all sections; none where they have their own.
    pub friction: Option<f64>,
    /// Measured depth of the bit, m; none of all depths.
    pub bit_depth_m: Option<f64>,
    /// Its dimension.
    pub dimension: String,
    /// The case's own; not a number where it has none.
    pub expected: f64,
    /// Below these lie 5, 10, 50, 90 and 95 % of the samples.
    pub quantiles: [f64; 5],
    /// Samples that have it.
    pub answers: usize,
    /// Samples without an answer.
    pub without_answer: usize,
    /// Of a depth, samples whose limit is not met.
    pub not_met: usize,
    /// What it is owed to; none where it does not scatter.
    pub owed: Option<UncertainShares>,
}

/// Which inputs a number owes its scatter to.
#[derive(Debug, Clone, PartialEq)]
pub struct UncertainShares {
    /// First-order indices; not a number where they are not known.
    pub first: Vec<f64>,
    /// Total indices.
    pub total: Vec<f64>,
    /// What part of the variance the fit predicts.
    pub predicts: f64,
}

impl Uncertain {
    /// The band of an operation down the hole: depth, and between which values 90 % of the samples lie.
    pub(crate) fn band<'a>(
        &'a self,
        quantity: &'a str,
        operation: &'a str,
    ) -> impl Iterator<Item = (f64, [f64; 2])> + 'a {
        let of = self.bands.iter();
        let of = of.filter(move |of| of.quantity == quantity && of.operation == operation);
        of.filter_map(|of| Some((of.bit_depth_m?, [of.quantiles[0], of.quantiles[4]])))
    }

    /// What the bands are, for the head of a picture.
    pub(crate) fn said(&self) -> String {
        self.notes.first().map_or_else(String::new, |note| note.trim_end_matches('.').to_owned())
    }

    /// What is told of one depth: of several, the deepest; and of each kind of limit, the operation that
    /// is nearest to it.
    fn told(&self) -> impl Iterator<Item = &UncertainNumber> {
        let depths = self.bands.iter().filter(|of| of.quantity != "margin");
        let deepest_m = depths.clone().filter_map(|of| of.bit_depth_m).fold(0.0, f64::max);
        let deepest =
            depths.filter(move |of| of.bit_depth_m.is_none_or(|depth_m| depth_m == deepest_m));
        deepest.filter(|of| of.quantity != "reserve" || self.is_nearest(of))
    }

    /// Whether no other operation has less of a limit left.
    fn is_nearest(&self, of: &UncertainNumber) -> bool {
        let mut alike = self.bands.iter();
        let less = |one: &UncertainNumber| one.quantiles[0] < of.quantiles[0];
        !alike.any(|one| one.quantity == of.quantity && one.limit == of.limit && less(one))
    }

    /// Whether what is told is of more than one friction.
    fn has_frictions(&self) -> bool {
        self.bands.windows(2).any(|pair| pair[0].friction != pair[1].friction)
    }
}
