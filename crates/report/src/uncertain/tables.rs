//! Tables of uncertain numbers.

use wholestring::operation::OperationKind;

use super::{Uncertain, UncertainNumber};
use crate::{
    Grid, StudyPart, Verdict,
    digits::four,
    grid_cells::{head, row},
    plots::DisplayUnits,
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
pub(crate) fn inputs(uncertain: &Uncertain) -> Option<StudyPart> {
    let heads = vec![head("key of the case", true), head("distribution", true)];
    let rows = uncertain.inputs.iter().map(|cells| row(cells.to_vec())).collect();
    part("Uncertain inputs", uncertain.notes.join(" "), Grid { heads, rows }, &uncertain.files[2])
}

/// Cells that identify a number.
fn named(number: &UncertainNumber, all: &Uncertain) -> Vec<String> {
    let operation = number.operation.map_or("any", OperationKind::words);
    let mut cells = vec![number.title.clone(), operation.to_owned()];
    if all.has_frictions() {
        cells.push(number.friction.map_or_else(|| "the case's".to_owned(), four));
    }
    cells
}

fn names(all: &Uncertain) -> Vec<crate::Head> {
    let mut heads = vec![head("number", true), head("operation", true)];
    if all.has_frictions() {
        heads.push(head("friction", false));
    }
    heads
}

/// Distributions of the numbers, at the deepest depth where they are of one.
pub(crate) fn bands(uncertain: &Uncertain, display: DisplayUnits<'_>) -> Option<StudyPart> {
    let mut heads = names(uncertain);
    for text in ["unit", "the case", "5 %", "50 %", "95 %", "without an answer"] {
        heads.push(head(text, text == "unit"));
    }
    // Nothing rotates: no torque.
    let is_something =
        |number: &&UncertainNumber| number.quantiles.iter().any(|value| *value != 0.0);
    let rows = uncertain.listed().filter(is_something).map(|one| {
        let value = |si: f64| four(display.value(si, &one.dimension));
        let mut cells = named(one, uncertain);
        cells.push(display.symbol(&one.dimension).to_owned());
        cells.push(value(one.expected));
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
    part("Bands", caption, Grid { heads, rows }, &uncertain.files[0])
}

/// Sensitivity to the inputs.
pub(crate) fn owed(uncertain: &Uncertain) -> Option<StudyPart> {
    let mut heads = names(uncertain);
    heads.extend(uncertain.inputs.iter().map(|[key, _]| head(format!("{key}, %"), false)));
    heads.push(head("predicted, %", false));
    let has_rest = |first: &[f64]| first.iter().any(|first| first.is_nan());
    let rows = uncertain.listed().filter_map(|one| {
        let owed = one.owed.as_ref()?;
        let mut cells = row(named(one, uncertain));
        cells.extend(owed.first.iter().zip(&owed.total).map(|(first, total)| {
            let first = if first.is_finite() { percent(*first) } else { "–".to_owned() };
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
    part("Sobol indices", caption, Grid { heads, rows }, &uncertain.files[1])
}

/// Limits that stop the well first, and their frequency.
pub(crate) fn stops(uncertain: &Uncertain) -> Option<StudyPart> {
    let heads = vec![head("stops the well first", true), head("samples", false)];
    let rows =
        uncertain.stops.iter().map(|(what, count)| row(vec![what.clone(), count.to_string()]));
    let grid = Grid { heads, rows: rows.collect() };
    part("Limits that stop the samples", String::new(), grid, &uncertain.files[3])
}

fn percent(part: f64) -> String {
    format!("{:.0}", 100.0 * part.clamp(0.0, 1.0))
}
