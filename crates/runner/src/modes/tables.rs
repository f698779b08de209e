//! The tables of small motions.

use wholestring::modal::{Answer, Campbell, Family, Mode, SmallMotions};
use wholestring_results::{
    CAMPBELL, MODE_SHAPES, ModeFound, ModesSummary, ModesTables, RESPONSE, ResultsError,
    ResultsFolder, Table, stability_table,
};

use super::stability::Stability;

/// Names of the tables, without their endings.
pub(super) const MODES: &str = "modes";
pub(super) const SHAPES: &str = "mode_shapes";
pub(super) const DIAGRAM: &str = "campbell";
pub(super) const CRITICAL: &str = "critical_speeds";
pub(super) const ANSWER: &str = "response";
pub(super) const STABILITY: &str = "stability";

/// Writes the summary and all tables, as CSV too: the page leads to them.
pub(super) fn write(
    folder: &ResultsFolder,
    summary: &ModesSummary,
    tables: &ModesTables,
) -> Result<(), ResultsError> {
    folder.write_table(MODES, &summary.modes_table(), true)?;
    folder.write_table(CRITICAL, &summary.critical_speeds_table(), true)?;
    folder.write_table(SHAPES, &tables.shapes, true)?;
    // The picture of the whole string's modes is of the same table, and has its numbers beside it too.
    tables.shapes.write_csv(&folder.path().join("string_shapes.csv"))?;
    folder.write_table(DIAGRAM, &tables.campbell, true)?;
    folder.write_table(ANSWER, &tables.response, true)?;
    summary.write(&folder.path().join("summary.json"))
}

/// Writes the map of torsional stability; without one, that of an earlier run goes, its picture
/// too.
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

/// Shapes: of lateral modes in the assembly, of the others in the whole string.
pub(super) fn shapes(
    motions: &SmallMotions,
    found: &[ModeFound],
    modes: &[Mode],
    top: usize,
) -> Table {
    let mut table = Table::with_columns(MODE_SHAPES);
    for (of, mode) in found.iter().zip(modes) {
        let first = if mode.family == Family::Lateral { top } else { 0 };
        let nodes = first..motions.nodes();
        let each = |of: &dyn Fn(usize) -> f64| nodes.clone().map(of).collect::<Vec<f64>>();
        table.append(
            &[("family", &[&of.family])],
            &[
                ("number", &each(&|_| of.number as f64)),
                ("md_m", &each(&|node| motions.md_m(node))),
                ("high_m", &each(&|node| mode.shape[node][0].re)),
                ("right_m", &each(&|node| mode.shape[node][1].re)),
                // Of exp(iωt) a quarter of a period later.
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
pub(super) fn campbell(of: &Campbell) -> Table {
    let mut table = Table::with_columns(CAMPBELL);
    for (index, branch) in of.branches.iter().enumerate() {
        let each = |value: f64| vec![value; of.rotary_rad_per_s.len()];
        let whirl = branch.whirl.map_or("", |whirl| whirl.name());
        table.append(
            &[("family", &[branch.family.name()]), ("whirl", &[whirl])],
            &[
                ("branch", &each(index as f64)),
                ("number", &each(branch.number as f64)),
                ("rotary_speed_rad_per_s", &of.rotary_rad_per_s),
                ("frequency_Hz", &branch.frequency_Hz),
            ],
        );
    }
    table
}

/// A row for each speed.
pub(super) fn response(answers: &[Answer]) -> Table {
    let mut table = Table::with_columns(RESPONSE);
    let components: Vec<&str> = answers.iter().map(|of| &*of.most_bent.component).collect();
    let each = |of: fn(&Answer) -> f64| answers.iter().map(of).collect::<Vec<f64>>();
    table.append(
        &[("component", &components)],
        &[
            ("rotary_speed_rad_per_s", &each(|of| of.rotary_rad_per_s)),
            ("amplitude_m", &each(|of| of.amplitude_m)),
            ("amplitude_md_m", &each(|of| of.widest.md_m)),
            ("bending_stress_Pa", &each(|of| of.bending_stress_Pa)),
            ("bending_stress_md_m", &each(|of| of.most_bent.md_m)),
        ],
    );
    table
}
