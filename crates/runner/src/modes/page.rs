//! `report.html` and the pictures of linear vibration, made from the files in its folder.

use std::path::Path;

use wholestring_report::{
    Cell, CriticalRow, Fact, MODES_PICTURES, ModeRow, Modes, PageHead, Plot, in_sets, modes_html,
    modes_plots,
};
use wholestring_results::{ModesSummary, ResultsError, Spot};
use wholestring_units::UnitSet;

use super::{
    shapes, stability,
    tables::{ANSWER, DIAGRAM, MODES, SHAPES, STABILITY},
};
use crate::{page::table, results_kind::Results};

impl Results for Modes {
    const NOUN: &'static str = "modes";
    const TABLE: &'static str = MODES;
    const PICTURES: &'static [&'static str] = &MODES_PICTURES;
    const WITH_NUMBERS: bool = true;

    fn gather(folder: &Path, units: Option<UnitSet>) -> Result<Self, ResultsError> {
        let summary = ModesSummary::read(&folder.join("summary.json"))?;
        let title = format!("{}: natural frequencies", summary.case);
        let head = PageHead::new(title, units, Some(&summary.settings), facts(&summary));
        let place = |spot: &Spot| (spot.md_m, spot.component.clone());
        Ok(Self {
            head,
            operation: summary.operation,
            rotary_rad_per_s: summary.rotary_speed_rad_per_s,
            stable: summary.stable,
            forcing: in_sets(|units| summary.texts.in_units(&summary.forcing, units)),
            modes: summary
                .modes
                .iter()
                .map(|mode| ModeRow {
                    family: mode.family.clone(),
                    number: mode.number,
                    frequency_Hz: mode.frequency_Hz,
                    whirl: mode.whirl.clone(),
                    energy: mode.energy,
                    most_strained: place(&mode.most_strained),
                })
                .collect(),
            critical: summary
                .critical_speeds
                .iter()
                .map(|critical_speed| CriticalRow {
                    order: critical_speed.order,
                    rotary_rad_per_s: critical_speed.rotary_speed_rad_per_s,
                    frequency_Hz: critical_speed.frequency_Hz,
                    family: critical_speed.family.clone(),
                    number: critical_speed.number,
                    most_strained: place(&critical_speed.most_strained),
                })
                .collect(),
            shapes: shapes::shapes(&table(folder, SHAPES)?),
            branches: shapes::branches(&table(folder, DIAGRAM)?),
            answer: shapes::answer(&table(folder, ANSWER)?),
            stability: in_sets(|units| match &summary.torsional_stability {
                Some(map) => stability::sentences(summary.operation, map, units),
                None => summary.no_torsional_stability.iter().cloned().collect(),
            }),
            stability_map: match &summary.torsional_stability {
                Some(map) => Some(stability::picture(&table(folder, STABILITY)?, map)),
                None => None,
            },
            message: summary.warning(),
        })
    }

    fn html(&self) -> Option<String> {
        Some(modes_html(self))
    }

    fn plots(&self) -> Vec<Plot> {
        modes_plots(self, &self.head.units)
    }
}

/// Key facts of the state.
fn facts(summary: &ModesSummary) -> Vec<Fact> {
    let fact = |label: &str, value: Cell| Fact { label: label.into(), value };
    vec![
        fact("Operation", Cell::Text(summary.operation.words().to_owned())),
        fact("Rotary speed", Cell::quantity(summary.rotary_speed_rad_per_s, "rotary speed")),
        fact("Assembly", Cell::quantity(summary.assembly_length_m, "length")),
        fact("Elements", Cell::Text(summary.elements.to_string())),
    ]
}
