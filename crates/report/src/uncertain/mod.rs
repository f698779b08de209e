//! Contents of a page on uncertain numbers, for plans and reaches alike.

mod figure;
mod tables;

pub(crate) use figure::figure;
pub(crate) use tables::{bands, inputs, owed, stops};

use wholestring::operation::OperationKind;
use wholestring_judge::{CheckKind, DepthLimit};
use wholestring_results::{UncertainBand, UncertainStop, UncertainSummary, UncertainTables};

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

// Words for the numbers of uncertain inputs.

/// Largest number of reasons that are listed; the others are counted.
const REASONS: usize = 3;

/// Notes on the bands and on missing samples.
pub fn uncertain_notes(summary: &UncertainSummary) -> Vec<String> {
    let numbers = match summary.inputs.len() {
        1 => "one uncertain number".to_owned(),
        count => format!("{count} uncertain numbers"),
    };
    let mut notes = vec![format!(
        "Bands: 5 to 95 % of {} samples of {numbers}, {} string, seed {}.",
        summary.solved, summary.model, summary.seed
    )];
    if summary.solved < summary.samples {
        notes.push(format!(
            "Interrupted: {} of {} samples were solved.",
            summary.solved, summary.samples
        ));
    }
    if summary.lacking > 0 {
        let reasons = summary.reasons.iter().take(REASONS);
        let reasons: Vec<String> = reasons.map(|(why, count)| format!("{why} ({count})")).collect();
        let more = summary.reasons.len().saturating_sub(REASONS);
        let more = if more > 0 { format!("; and {more} other reasons") } else { String::new() };
        notes.push(format!(
            "{} of {} samples have points without an answer, which are in no band: {}{more}.",
            summary.lacking,
            summary.solved,
            reasons.join("; ")
        ));
    }
    notes
}

/// A limit in words; limits of a plan and of a reach may have the same name.
fn limit(name: &str, of_reach: bool) -> &str {
    let found = match of_reach {
        true => DepthLimit::named(name).map(DepthLimit::title),
        false => CheckKind::named(name).map(CheckKind::label),
    };
    found.unwrap_or(name)
}

/// The limit of a number in words; empty for other numbers.
fn band_limit(band: &UncertainBand) -> &str {
    let of_reach = matches!(band.quantity.as_str(), "depth" | "margin");
    if band.limit.is_empty() { "" } else { limit(&band.limit, of_reach) }
}

/// Name of a number in words, with its limit.
fn title(band: &UncertainBand) -> String {
    let limit = band_limit(band);
    match band.quantity.as_str() {
        "reserve" => format!("reserve: {limit}"),
        "depth" if limit.is_empty() => "depth of the first stop".to_owned(),
        "depth" => format!("depth: {limit}"),
        "sinusoidal_weight" => "weight to buckle: sinusoid".to_owned(),
        "helical_weight" => "weight to buckle: helix".to_owned(),
        other => other.replace('_', " "),
    }
}

/// Dimension of a number.
fn dimension(band: &UncertainBand) -> &'static str {
    match band.unit.as_str() {
        "N" => "force",
        "N·m" => "torque",
        "m" => "length",
        _ => "ratio",
    }
}

/// A limit that stops a well first, with its operation and friction; `nothing` where none does.
fn stop(stop: &UncertainStop) -> String {
    let at = stop.friction.map_or_else(String::new, |friction| format!(", friction {friction}"));
    match stop.limit {
        None => format!("nothing{at}"),
        Some(limit) => {
            let operation = stop.operation.map_or("", OperationKind::words);
            format!("{}, {operation}{at}", limit.title())
        }
    }
}

#[cfg(test)]
mod tests;
