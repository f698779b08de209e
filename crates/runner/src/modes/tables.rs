//! The tables of linear vibration.

use wholestring_results::{
    CampbellRow, CriticalSpeed, ModeFound, ModeShapeRow, ModesRows, ModesSummary, ResponseRow,
    ResultsError, ResultsFolder, Row as _, StabilityRow,
};
use wholestring_vibration::modal::{Answer, Campbell, Family, Mode, SmallMotions};

use super::stability::Stability;

/// Names of the tables, without their extensions.
pub(super) const MODES: &str = "modes";
pub(super) const SHAPES: &str = "mode_shapes";
pub(super) const DIAGRAM: &str = "campbell";
pub(super) const CRITICAL: &str = "critical_speeds";
pub(super) const ANSWER: &str = "response";
pub(super) const STABILITY: &str = "stability";

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
