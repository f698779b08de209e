//! Tables of uncertain numbers.

use wholestring::operation::OperationKind;
use wholestring_results::UncertainBand;

use super::{Uncertain, dimension, title, uncertain_notes};
use crate::{
    Grid, StudyPart, Verdict,
    cell::four,
    grid_cells::{head, row},
    plots::DisplayUnits,
    uncertain,
};

/// A fit that predicts less of the variance than this is of little use.
const PREDICTS: f64 = 0.9;

fn part(title: &str, caption: String, grid: Grid, files: &str) -> Option<StudyPart> {
    (!grid.rows.is_empty()).then(|| StudyPart::Table {
        title: title.to_owned(),
        caption,
        grid,
        files: files.to_owned(),
        endings: &["csv", "parquet"],
    })
}

/// The uncertain inputs.
pub(crate) fn inputs(uncertain: Uncertain<'_>) -> Option<StudyPart> {
    let heads = vec![head("key of the case", true), head("distribution", true)];
    let inputs = uncertain.summary.inputs.iter();
    let rows = inputs.map(|input| row(vec![input.key.clone(), input.distribution.clone()]));
    let grid = Grid { heads, rows: rows.collect() };
    let caption = uncertain_notes(uncertain.summary).join(" ");
    part("Uncertain inputs", caption, grid, uncertain.tables.samples)
}

/// Cells that identify a number.
fn named(number: &UncertainBand, all: Uncertain<'_>) -> Vec<String> {
    let operation = number.operation.map_or("any", OperationKind::words);
    let mut cells = vec![title(number), operation.to_owned()];
    if all.has_frictions() {
        cells.push(number.friction.map_or_else(|| "the case's".to_owned(), four));
    }
    cells
}

fn names(all: Uncertain<'_>) -> Vec<crate::Head> {
    let mut heads = vec![head("number", true), head("operation", true)];
    if all.has_frictions() {
        heads.push(head("friction", false));
    }
    heads
}

/// Distributions of the numbers, at the deepest depth where they are of one.
pub(crate) fn bands(uncertain: Uncertain<'_>, display: DisplayUnits<'_>) -> Option<StudyPart> {
    let mut heads = names(uncertain);
    for text in ["unit", "the case", "5 %", "50 %", "95 %", "without an answer"] {
        heads.push(head(text, text == "unit"));
    }
    // Nothing rotates: no torque.
    let is_something = |number: &&UncertainBand| number.quantiles.iter().any(|value| *value != 0.0);
    let rows = uncertain.listed().filter(is_something).map(|one| {
        let value = |si: f64| four(display.value(si, dimension(one)));
        let mut cells = named(one, uncertain);
        cells.push(display.symbol(dimension(one)).to_owned());
        cells.push(value(one.expected.unwrap_or(f64::NAN)));
        let [low, _, middle, _, high] = one.quantiles;
        let all = one.answers + one.without_answer;
        // For limits that are not reached, a depth is at least the last one.
        let depth = |part: f64, si: f64| {
            let met = (all - one.not_met) as f64;
            let is_met = one.not_met == 0 || part * all as f64 <= met;
            if is_met { value(si) } else { format!("over {}", value(si)) }
        };
        cells.extend([depth(0.05, low), depth(0.5, middle), depth(0.95, high)]);
        cells.push(one.without_answer.to_string());
        row(cells)
    });
    let rows = rows.collect();
    let caption =
        "The 5th, 50th and 95th percentiles of the samples. Hook load, torque and weight \
        to buckle with the bit at its deepest; a reserve is the least factor over the required one \
        of all depths and components, below the required factor where it is less than one, here \
        for the operation with the least reserve. Samples without an answer are in no band."
            .to_owned();
    part("Bands", caption, Grid { heads, rows }, uncertain.tables.bands)
}

/// Sensitivity to the inputs.
pub(crate) fn owed(uncertain: Uncertain<'_>) -> Option<StudyPart> {
    let mut heads = names(uncertain);
    heads.extend(
        uncertain.summary.inputs.iter().map(|input| head(format!("{}, %", input.key), false)),
    );
    heads.push(head("predicted, %", false));
    let has_rest = |first: &[Option<f64>]| first.iter().any(Option::is_none);
    let rows = uncertain.listed().filter_map(|one| {
        let owed = one.owed.as_ref()?;
        let mut cells = row(named(one, uncertain));
        cells.extend(owed.first.iter().zip(&owed.total).map(|(first, total)| {
            let first = first.map_or_else(|| "–".to_owned(), percent);
            (format!("{first} / {}", percent(*total)), Verdict::None)
        }));
        let is_poor = owed.predicts < PREDICTS && !has_rest(&owed.first);
        let verdict = if is_poor { Verdict::Near } else { Verdict::None };
        cells.push((percent(owed.predicts), verdict));
        Some(cells)
    });
    let rows = rows.collect();
    let caption = "First-order / total Sobol index: the part of the variance that would vanish if \
        the input were known, and the part that would remain if all others were. The last column \
        is the part of the variance that the fit predicts at samples outside the fit: below 90 % \
        the indices mean little. A choice among more than four values has the part that the others \
        do not explain, and no first-order index."
        .to_owned();
    part("Sobol indices", caption, Grid { heads, rows }, uncertain.tables.indices)
}

/// Limits that stop the well first, and their frequency.
pub(crate) fn stops(uncertain: Uncertain<'_>) -> Option<StudyPart> {
    let heads = vec![head("stops the well first", true), head("samples", false)];
    let stops = uncertain.summary.stops.iter();
    let rows = stops.map(|stop| row(vec![uncertain::stop(stop), stop.samples.to_string()]));
    let grid = Grid { heads, rows: rows.collect() };
    part(
        "Limits that stop the samples",
        String::new(),
        grid,
        uncertain.tables.stops.unwrap_or_default(),
    )
}

fn percent(part: f64) -> String {
    format!("{:.0}", 100.0 * part.clamp(0.0, 1.0))
}
