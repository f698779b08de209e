//! `report.html` and the pictures of small motions, made from the files that they left.

use std::path::Path;

use wholestring_report::{Cell, CriticalRow, Fact, ModeRow, Modes, modes_html, modes_plots};
use wholestring_results::{ModesSummary, ResultsError, ResultsFolder, Spot};
use wholestring_units::UnitSet;

use super::{
    shapes, stability,
    tables::{ANSWER, DIAGRAM, MODES, SHAPES, STABILITY},
};
use crate::page::{self, FILE, table, write_picture};

/// Whether a folder is one that small motions were written to.
pub(crate) fn is_modes(folder: &Path) -> bool {
    folder.join(format!("{MODES}.parquet")).is_file()
}

/// Writes the page and its pictures.
pub(crate) fn write(folder: &ResultsFolder, modes: &Modes, png: bool) -> Result<(), ResultsError> {
    for plot in modes_plots(modes, &modes.head.units) {
        write_picture(folder, &plot.name, &plot.figure, png)?;
    }
    folder.write_file(FILE, modes_html(modes).as_bytes())
}

/// Everything that is reported of small motions.
pub(crate) fn gather(folder: &Path, units: Option<UnitSet>) -> Result<Modes, ResultsError> {
    let summary = ModesSummary::read(&folder.join("summary.json"))?;
    let title = format!("{}: natural frequencies", summary.case);
    let head = page::head(title, units, Some(&summary.settings), facts(&summary));
    let set: UnitSet = head.units.parse().unwrap_or_default();
    let place = |of: &Spot| (of.md_m, of.component.clone());
    Ok(Modes {
        head,
        operation: summary.operation.clone(),
        rotary_rad_per_s: summary.rotary_speed_rad_per_s,
        stable: summary.stable,
        forcing: summary.forcing.clone(),
        modes: summary
            .modes
            .iter()
            .map(|of| ModeRow {
                family: of.family.clone(),
                number: of.number,
                frequency_Hz: of.frequency_Hz,
                whirl: of.whirl.clone(),
                energy: of.energy,
                most_strained: place(&of.most_strained),
            })
            .collect(),
        critical: summary
            .critical_speeds
            .iter()
            .map(|of| CriticalRow {
                order: of.order,
                rotary_rad_per_s: of.rotary_speed_rad_per_s,
                frequency_Hz: of.frequency_Hz,
                family: of.family.clone(),
                number: of.number,
                most_strained: place(&of.most_strained),
            })
            .collect(),
        shapes: shapes::shapes(&table(folder, SHAPES)?),
        branches: shapes::branches(&table(folder, DIAGRAM)?),
        answer: shapes::answer(&table(folder, ANSWER)?),
        stability: match &summary.torsional_stability {
            Some(of) => stability::sentences(of, set),
            None => summary.no_torsional_stability.iter().cloned().collect(),
        },
        stability_map: match &summary.torsional_stability {
            Some(of) => Some(stability::picture(&table(folder, STABILITY)?, of)),
            None => None,
        },
    })
}

/// The state in a few facts.
fn facts(summary: &ModesSummary) -> Vec<Fact> {
    let fact = |label: &str, value: Cell| Fact { label: label.into(), value };
    vec![
        fact("Operation", Cell::Text(summary.operation.replace('_', " "))),
        fact("Rotary speed", Cell::quantity(summary.rotary_speed_rad_per_s, "rotary speed")),
        fact("Assembly", Cell::quantity(summary.assembly_length_m, "length")),
        fact("Elements", Cell::Text(summary.elements.to_string())),
    ]
}
