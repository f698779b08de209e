//! The tables of linear vibration, and its page and pictures, made from the files in its folder.

use std::path::Path;

use wholestring_report::{MODES_PICTURES, Modes, Plot, modes_html, modes_plots};
use wholestring_results::{
    CampbellRow, CriticalSpeed, ModeFound, ModeShapeRow, ModesRows, ModesSummary, ResponseRow,
    ResultsError, ResultsFolder, Row as _, StabilityRow, Table,
};
use wholestring_units::UnitSet;
use wholestring_vibration::modal::{Answer, Campbell, Family, Mode, SmallMotions};

use super::stability::Stability;
use crate::{
    page::{read_rows, table},
    results_kind::Results,
};

/// Names of the tables, without their extensions.
const MODES: &str = "modes";
const SHAPES: &str = "mode_shapes";
const DIAGRAM: &str = "campbell";
const CRITICAL: &str = "critical_speeds";
const ANSWER: &str = "response";
const STABILITY: &str = "stability";

/// Writes the summary and all tables, also as CSV, because the page links to them.
pub(super) fn write(
    folder: &ResultsFolder,
    summary: &ModesSummary,
    rows: &ModesRows,
) -> Result<(), ResultsError> {
    folder.write_table(MODES, &ModeFound::table(&summary.modes), true)?;
    folder.write_table(CRITICAL, &CriticalSpeed::table(&summary.critical_speeds), true)?;
    let shapes = ModeShapeRow::table(&rows.shapes);
    folder.write_table(SHAPES, &shapes, true)?;
    // The picture of the whole string's modes uses the same table, and has its numbers as CSV too.
    shapes.write_csv(&folder.path().join("string_shapes.csv"))?;
    folder.write_table(DIAGRAM, &CampbellRow::table(&rows.campbell), true)?;
    folder.write_table(ANSWER, &ResponseRow::table(&rows.response), true)?;
    summary.write(&folder.path().join("summary.json"))
}

/// Writes the map of torsional stability; without one, removes that of an earlier run and its
/// picture.
pub(super) fn write_stability(
    folder: &ResultsFolder,
    map: Option<&Stability>,
) -> Result<(), ResultsError> {
    match map {
        Some(map) => {
            folder.write_table(STABILITY, &StabilityRow::table(StabilityRow::all(&map.lines)), true)
        }
        None => ["parquet", "csv", "svg", "png"]
            .iter()
            .try_for_each(|ending| folder.remove(&format!("{STABILITY}.{ending}"))),
    }
}

/// Mode shapes: lateral modes in the assembly, the others in the whole string.
pub(super) fn shapes(
    motions: &SmallMotions,
    found: &[ModeFound],
    modes: &[Mode],
    top: usize,
) -> Vec<ModeShapeRow> {
    let rows = found.iter().zip(modes).flat_map(|(row, mode)| {
        let first = if mode.family == Family::Lateral { top } else { 0 };
        (first..motions.nodes()).map(move |node| ModeShapeRow {
            family: row.family.clone(),
            number: row.number,
            md_m: motions.md_m(node),
            high_m: mode.shape[node][0].re,
            right_m: mode.shape[node][1].re,
            // Of exp(iωt), a quarter of a period later.
            high_later_m: -mode.shape[node][0].im,
            right_later_m: -mode.shape[node][1].im,
            along_m: mode.shape[node][2].re,
            turn_rad: mode.shape[node][5].re,
        })
    });
    rows.collect()
}

/// A row for each branch at each speed.
pub(super) fn campbell(campbell: &Campbell) -> Vec<CampbellRow> {
    let rows = campbell.branches.iter().enumerate().flat_map(|(index, branch)| {
        let speeds = campbell.rotary_rad_per_s.iter().zip(&branch.frequency_Hz);
        speeds.map(move |(rotary_speed_rad_per_s, frequency_Hz)| CampbellRow {
            branch: index,
            family: branch.family.name().to_owned(),
            number: branch.number,
            whirl: branch.whirl.map(|whirl| whirl.name().to_owned()),
            rotary_speed_rad_per_s: *rotary_speed_rad_per_s,
            frequency_Hz: *frequency_Hz,
        })
    });
    rows.collect()
}

/// A row for each speed.
pub(super) fn response(answers: &[Answer]) -> Vec<ResponseRow> {
    let rows = answers.iter().map(|answer| ResponseRow {
        rotary_speed_rad_per_s: answer.rotary_rad_per_s,
        amplitude_m: answer.amplitude_m,
        amplitude_md_m: answer.widest.md_m,
        bending_stress_Pa: answer.bending_stress_Pa,
        bending_stress_md_m: answer.most_bent.md_m,
        component: answer.most_bent.component.to_string(),
    });
    rows.collect()
}

// `report.html` and the pictures of linear vibration, made from the files in its folder.

impl Results for Modes {
    const NOUN: &'static str = "modes";
    const TABLE: &'static str = MODES;
    const PICTURES: &'static [&'static str] = &MODES_PICTURES;
    const WITH_NUMBERS: bool = true;

    fn check_summary(path: &Path) -> Result<(), ResultsError> {
        ModesSummary::read(path).map(drop)
    }

    fn gather(folder: &Path, units: Option<UnitSet>) -> Result<Self, ResultsError> {
        let summary = ModesSummary::read(&folder.join("summary.json"))?;
        let rows = ModesRows {
            shapes: read_rows(folder, SHAPES)?,
            campbell: read_rows(folder, DIAGRAM)?,
            response: read_rows(folder, ANSWER)?,
        };
        let stability = match &summary.torsional_stability {
            Some(_) => table(folder, STABILITY)?,
            None => Table::new(Vec::new()),
        };
        Ok(Self::new(summary, rows, &stability, units))
    }

    fn html(&self) -> Option<String> {
        Some(modes_html(self))
    }

    fn plots(&self) -> Vec<Plot> {
        modes_plots(self, &self.head.units)
    }
}
