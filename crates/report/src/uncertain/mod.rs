//! Contents of a page on uncertain numbers, for plans and reaches alike.

mod figure;
mod tables;
mod words;

use wholestring::operation::OperationKind;
use wholestring_results::{UncertainBand, UncertainSummary, UncertainTables};

#[cfg(test)]
mod tests;

pub(crate) use figure::figure;
pub(crate) use tables::{bands, inputs, owed, stops};
pub use words::uncertain_notes;

/// Caption of the picture.
pub(crate) const CAPTION: &str = "With the bit at its deepest: the length of each bar is the total \
    Sobol index of an uncertain number, the point its first-order index. Where they differ, the \
    number interacts with others.";

/// Uncertain inputs and their effect, with the names of the tables next to the page.
#[derive(Clone, Copy)]
pub(crate) struct Uncertain<'a> {
    /// The inputs and the distributions of the results.
    pub(crate) summary: &'a UncertainSummary,
    /// The tables of a plan or of a reach.
    pub(crate) tables: &'static UncertainTables,
}

impl<'a> Uncertain<'a> {
    /// Uncertain inputs of a summary; `None` where all are exact.
    pub(crate) fn new(
        summary: Option<&'a UncertainSummary>,
        tables: &'static UncertainTables,
    ) -> Option<Self> {
        summary.map(|summary| Self { summary, tables })
    }

    /// The band of an operation down the hole: depth, and the values between which 90 % of the
    /// samples are.
    pub(crate) fn band(
        self,
        quantity: &'a str,
        operation: OperationKind,
    ) -> impl Iterator<Item = (f64, [f64; 2])> + 'a {
        let bands = self.summary.bands.iter();
        let numbers = bands.filter(move |number| {
            number.quantity == quantity && number.operation == Some(operation)
        });
        numbers.filter_map(|number| {
            Some((number.bit_depth_m?, [number.quantiles[0], number.quantiles[4]]))
        })
    }

    /// Description of the bands, for the head of a picture.
    pub(crate) fn description(self) -> String {
        let notes = uncertain_notes(self.summary);
        notes.first().map_or_else(String::new, |note| note.trim_end_matches('.').to_owned())
    }

    /// The listed numbers: of one depth, the deepest of several; and for each kind of limit, the
    /// operation that is nearest to it.
    fn listed(self) -> impl Iterator<Item = &'a UncertainBand> {
        let depths = self.summary.bands.iter().filter(|band| band.quantity != "margin");
        let deepest_m = depths.clone().filter_map(|depth| depth.bit_depth_m).fold(0.0, f64::max);
        let deepest = depths
            .filter(move |depth| depth.bit_depth_m.is_none_or(|depth_m| depth_m == deepest_m));
        deepest.filter(move |deepest| deepest.quantity != "reserve" || self.is_nearest(deepest))
    }

    /// Whether no other operation has a smaller reserve of a limit.
    fn is_nearest(self, number: &UncertainBand) -> bool {
        let mut alike = self.summary.bands.iter();
        let less = |one: &UncertainBand| one.quantiles[0] < number.quantiles[0];
        !alike.any(|one| one.quantity == number.quantity && one.limit == number.limit && less(one))
    }

    /// Whether the listed numbers are of more than one friction.
    fn has_frictions(self) -> bool {
        let bands = &self.summary.bands;
        bands.windows(2).any(|pair| pair[0].friction != pair[1].friction)
    }
}
