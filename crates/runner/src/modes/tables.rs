//! The tables of linear vibration.

use wholestring::modal::{Answer, Campbell, Family, Mode, SmallMotions};
use wholestring_results::{
    CAMPBELL, MODE_SHAPES, ModeFound, ModesSummary, ModesTables, RESPONSE, ResultsError,
    ResultsFolder, Table, stability_table,
};

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
    tables: &ModesTables,
) -> Result<(), ResultsError> {
    folder.write_table(MODES, &summary.modes_table(), true)?;
    folder.write_table(CRITICAL, &summary.critical_speeds_table(), true)?;
    folder.write_table(SHAPES, &tables.shapes, true)?;
    // The picture of the whole string's modes uses the same table, and has its numbers as CSV too.
    tables.shapes.write_csv(&folder.path().join("string_shapes.csv"))?;
    folder.write_table(DIAGRAM, &tables.campbell, true)?;
    folder.write_table(ANSWER, &tables.response, true)?;
    summary.write(&folder.path().join("summary.json"))
}

/// Writes the map of torsional stability; without one, removes that of an earlier run and its
/// picture.
pub(super) fn write_stability(
    folder: &ResultsFolder,
    map: Option<&Stability>,
) -> Result<(), ResultsError> {
    match map {
        Some(map) => folder.write_table(STABILITY, &stability_table(&map.lines), true),
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
) -> Table {
    let mut table = Table::with_columns(MODE_SHAPES);
    for (row, mode) in found.iter().zip(modes) {
        let first = if mode.family == Family::Lateral { top } else { 0 };
        let nodes = first..motions.nodes();
        let each = |value: &dyn Fn(usize) -> f64| nodes.clone().map(value).collect::<Vec<f64>>();
        table.append(
            &[("family", &[&row.family])],
            &[
                ("number", &each(&|_| row.number as f64)),
                ("md_m", &each(&|node| motions.md_m(node))),
                ("high_m", &each(&|node| mode.shape[node][0].re)),
                ("right_m", &each(&|node| mode.shape[node][1].re)),
                // Of exp(iωt), a quarter of a period later.
                ("high_later_m", &each(&|node| -mode.shape[node][0].im)),
                ("right_later_m", &each(&|node| -mode.shape[node][1].im)),
                ("along_m", &each(&|node| mode.shape[node][2].re)),
                ("turn_rad", &each(&|node| mode.shape[node][5].re)),
            ],
        );
    }
    table
}

/// A row for each branch at each speed.
pub(super) fn campbell(campbell: &Campbell) -> Table {
    let mut table = Table::with_columns(CAMPBELL);
    for (index, branch) in campbell.branches.iter().enumerate() {
        let each = |value: f64| vec![value; campbell.rotary_rad_per_s.len()];
        let whirl = branch.whirl.map_or("", |whirl| whirl.name());
        table.append(
            &[("family", &[branch.family.name()]), ("whirl", &[whirl])],
            &[
                ("branch", &each(index as f64)),
                ("number", &each(branch.number as f64)),
                ("rotary_speed_rad_per_s", &campbell.rotary_rad_per_s),
                ("frequency_Hz", &branch.frequency_Hz),
            ],
        );
    }
    table
}

/// A row for each speed.
pub(super) fn response(answers: &[Answer]) -> Table {
    let mut table = Table::with_columns(RESPONSE);
    let components: Vec<&str> = answers.iter().map(|answer| &*answer.most_bent.component).collect();
    let each = |answer: fn(&Answer) -> f64| answers.iter().map(answer).collect::<Vec<f64>>();
    table.append(
        &[("component", &components)],
        &[
            ("rotary_speed_rad_per_s", &each(|answer| answer.rotary_rad_per_s)),
            ("amplitude_m", &each(|answer| answer.amplitude_m)),
            ("amplitude_md_m", &each(|answer| answer.widest.md_m)),
            ("bending_stress_Pa", &each(|answer| answer.bending_stress_Pa)),
            ("bending_stress_md_m", &each(|answer| answer.most_bent.md_m)),
        ],
    );
    table
}
