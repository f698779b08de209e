//! Fatigue and casing wear on a plan's page.

use wholestring_results::{PlanFatigue, PlanWear};

use super::Plan;
use crate::{Grid, StudyPart, Verdict, cell::four, grid_cells::head, plots::DisplayUnits};

/// A damage, or a worn part of a wall, above which its colour is no longer that of a good state.
const MUCH: f64 = 0.5;

type Cell = (String, Verdict);

fn plain(text: String) -> Cell {
    (text, Verdict::None)
}

/// A part in percent.
fn percent(part: f64) -> String {
    const LEAST: f64 = 1e-5;
    if part > 0.0 && part < LEAST {
        return format!("under {} %", 100.0 * LEAST);
    }
    format!("{} %", four(100.0 * part))
}

/// A used-up part of a life or of a wall; one is all of it.
fn part_of(all: f64) -> Cell {
    let light = match all {
        all if all.is_nan() => return plain("not known".to_owned()),
        all if all >= 1.0 => Verdict::Differs,
        all if all > MUCH => Verdict::Near,
        _ => Verdict::Agrees,
    };
    let word = if all >= 1.0 { " used up" } else { "" };
    (percent(all) + word, light)
}

fn quantity(display: DisplayUnits<'_>, si: Option<f64>, dimension: &str) -> Cell {
    let text = si.map(|si| four(display.value(si, dimension)));
    plain(text.unwrap_or_else(|| "not known".into()))
}

/// A depth in whole metres or feet, whose unit is in the heading.
fn place(display: DisplayUnits<'_>, md_m: f64) -> Cell {
    plain(format!("{:.0}", display.value(md_m, "length")))
}

/// The parts of the campaign, counted and not counted.
pub(super) fn parts(plan: &Plan, display: DisplayUnits<'_>) -> Option<StudyPart> {
    let row =
        |word: &str, verdict: Verdict, text: String| vec![(word.to_owned(), verdict), plain(text)];
    let counted = plan.texts(&plan.summary.counted, display.unit_set());
    let counted = counted.map(|text| row("counted", Verdict::Agrees, text));
    let not_counted = plan.texts(&plan.summary.not_counted, display.unit_set());
    let not_counted = not_counted.map(|text| row("not counted", Verdict::Near, text));
    let rows: Vec<_> = not_counted.chain(counted).collect();
    let caption = "The parts of the campaign whose fatigue and casing wear are summed, with the \
        expected friction, and the parts left out. Above the shallowest depth of the plan and \
        between depths that are far apart, the campaign has depths of its own.";
    let heads = vec![head("", true), head("part of the campaign", true)];
    (!rows.is_empty()).then(|| part("Campaign", caption, Grid { heads, rows }, "plan_wear"))
}

/// Fatigue of each component.
pub(super) fn fatigue(plan: &Plan, display: DisplayUnits<'_>) -> Option<StudyPart> {
    let [length, stress, dogleg] =
        ["length", "stress", "dogleg severity"].map(|dimension| display.symbol(dimension));
    let heads = vec![
        head("component", true),
        head("model", true),
        head("life used", false),
        head("an hour of drilling", false),
        head(format!("at, {length}"), false),
        head(format!("bending, {stress}"), false),
        head(format!("dogleg, {dogleg}"), false),
        head(format!("permissible, {dogleg}"), false),
    ];
    let row = |row: &PlanFatigue| {
        let mut cells = vec![
            plain(row.component.clone()),
            plain(row.model.name().to_owned()),
            part_of(row.damage),
        ];
        match &row.hour {
            Some(hour) => cells.extend([
                plain(percent(hour.damage_per_hour)),
                place(display, hour.md_m),
                quantity(display, Some(hour.bending_Pa), "stress"),
                quantity(display, Some(hour.dogleg_rad_per_m), "dogleg severity"),
                quantity(display, hour.permissible_dogleg_rad_per_m, "dogleg severity"),
            ]),
            None => cells.extend((0..5).map(|_| plain(String::new()))),
        }
        cells
    };
    let rows: Vec<_> = plan.summary.fatigue.iter().map(row).collect();
    let caption = "Part of the life that the campaign uses up in each component's worst part, by \
        Miner's rule, with the expected friction; and the same in an hour of drilling at the \
        deepest depth, at the place of the largest damage. The S-N curve is that of the plan: that \
        of smooth pipe where the case gives none.";
    (!rows.is_empty()).then(|| part("Fatigue", caption, Grid { heads, rows }, "plan_fatigue"))
}

/// Wear of each casing.
pub(super) fn wear(plan: &Plan, display: DisplayUnits<'_>) -> Option<StudyPart> {
    let [length, diameter, pressure] =
        ["length", "diameter", "pressure"].map(|dimension| display.symbol(dimension));
    let heads = vec![
        head("casing", true),
        head("model", true),
        head("wall gone", false),
        head(format!("at, {length}"), false),
        head(format!("groove, {diameter}"), false),
        head(format!("wall left, {diameter}"), false),
        head(format!("burst new, {pressure}"), false),
        head(format!("worn, {pressure}"), false),
        head(format!("collapse new, {pressure}"), false),
        head(format!("worn, {pressure}"), false),
    ];
    let row = |row: &PlanWear| {
        let mut cells = vec![
            plain(format!("section {}", row.section)),
            plain(row.model.name().to_owned()),
            part_of(row.worn.unwrap_or(f64::NAN)),
            place(display, row.md_m),
            quantity(display, row.groove_m, "diameter"),
            quantity(display, row.wall_left_m, "diameter"),
        ];
        for new_and_worn_Pa in [row.burst_Pa, row.collapse_Pa] {
            let ends = [0, 1].map(|end| new_and_worn_Pa.map(|pressures_Pa| pressures_Pa[end]));
            cells.extend(ends.map(|si| quantity(display, si, "pressure")));
        }
        cells
    };
    let rows: Vec<_> = plan.summary.wear.iter().map(row).collect();
    let caption = "For each casing the most worn stretch, with the expected friction and the wear \
        factors of the plan. Collapse is that of a casing with the remaining wall all round. Where \
        it is not known: give the casing by its size, weight and grade. For the model \"dynamic\", \
        parts that the plan requests of the dynamics wear by its friction work, the rest as by the \
        first model.";
    (!rows.is_empty()).then(|| part("Casing wear", caption, Grid { heads, rows }, "plan_wear"))
}

fn part(title: &str, caption: &str, grid: Grid, files: &str) -> StudyPart {
    StudyPart::Table {
        title: title.to_owned(),
        caption: caption.to_owned(),
        grid,
        files: files.to_owned(),
        endings: &["csv", "parquet"],
    }
}
