//! Tables of what is not known exactly.

use super::{Uncertain, UncertainNumber};
use crate::{
    Grid, StudyPart, Verdict,
    grid_cells::{head, row},
    operation_words::{four, operation_name},
    plots::Shown,
};

/// A fit that predicts less of the variance than this says little.
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

/// What is uncertain.
pub(crate) fn inputs(of: &Uncertain) -> Option<StudyPart> {
    let heads = vec![head("key of the case", true), head("distribution", true)];
    let rows = of.inputs.iter().map(|cells| row(cells.to_vec())).collect();
    part("What is uncertain", of.notes.join(" "), Grid { heads, rows }, &of.files[2])
}

/// Where a number is and what it is of.
fn named(of: &UncertainNumber, all: &Uncertain) -> Vec<String> {
    let operation = match of.operation.as_str() {
        "" => "any".to_owned(),
        name => operation_name(name),
    };
    let mut cells = vec![of.title.clone(), operation];
    if all.has_frictions() {
        cells.push(of.friction.map_or_else(|| "the case's".to_owned(), four));
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

/// How numbers scatter, at the deepest depth where they are of one.
pub(crate) fn bands(of: &Uncertain, shown: Shown<'_>) -> Option<StudyPart> {
    let mut heads = names(of);
    for text in ["unit", "the case", "5 %", "50 %", "95 %", "without an answer"] {
        heads.push(head(text, text == "unit"));
    }
    // Nothing turns: no torque.
    let is_something = |of: &&UncertainNumber| of.quantiles.iter().any(|value| *value != 0.0);
    let rows = of.told().filter(is_something).map(|one| {
        let value = |si: f64| four(shown.value(si, &one.dimension));
        let mut cells = named(one, of);
        cells.push(shown.symbol(&one.dimension).to_owned());
        cells.push(value(one.expected));
        let [low, _, middle, _, high] = one.quantiles;
        let all = one.answers + one.without_answer;
        // Of limits that are not met, a depth is at least the last one.
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
    let caption = "Below these values lie 5, 50 and 95 % of the samples. Hook load, torque and weight to \
        buckle with the bit at its deepest; a reserve is the least factor over the required one of all \
        depths and components, short where it is below one, here of the operation that has least. Samples \
        without an answer are in no band."
        .to_owned();
    part("Bands", caption, Grid { heads, rows }, &of.files[0])
}

/// Which inputs that is owed to.
pub(crate) fn owed(of: &Uncertain) -> Option<StudyPart> {
    let mut heads = names(of);
    heads.extend(of.inputs.iter().map(|[key, _]| head(format!("{key}, %"), false)));
    heads.push(head("predicted, %", false));
    let has_rest = |first: &[f64]| first.iter().any(|of| of.is_nan());
    let rows = of.told().filter_map(|one| {
        let owed = one.owed.as_ref()?;
        let mut cells = row(named(one, of));
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
    let caption = "First-order / total Sobol index: what part of the variance would go if the input \
        were known, and what part would stay if all others were. The last column is what the fit predicts \
        of samples that it has not seen: below 90 % the indices mean little. A choice among more than four \
        values has what the others do not tell, and no first-order index."
        .to_owned();
    part("Sobol indices", caption, Grid { heads, rows }, &of.files[1])
}

/// What stops the well first, and how often.
pub(crate) fn stops(of: &Uncertain) -> Option<StudyPart> {
    let heads = vec![head("stops the well first", true), head("samples", false)];
    let rows = of.stops.iter().map(|(what, count)| row(vec![what.clone(), count.to_string()]));
    let grid = Grid { heads, rows: rows.collect() };
    part("What stops the samples", String::new(), grid, &of.files[3])
}

fn percent(part: f64) -> String {
    format!("{:.0}", 100.0 * part.clamp(0.0, 1.0))
}
