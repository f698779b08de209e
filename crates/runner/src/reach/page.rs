//! `report.html` and the picture of a reach, made from the files in its folder.

use std::path::Path;

use wholestring_plan::reach::Limit;
use wholestring_report::{
    Cell, Fact, Plot, REACH_PICTURES, Reach, ReachCurve, ReachRow, ReachVerdict, reach_html,
    reach_plots,
};
use wholestring_results::{ReachCheck, ReachOfFriction, ReachSummary, ResultsError, Table};
use wholestring_units::UnitSet;

use super::{sentences, tables::REACH};
use crate::{
    column::{numbers, operation, words},
    page::{self, checks::in_sets, table},
    results_kind::Results,
    uncertain::{self, Names},
};

impl Results for Reach {
    const NOUN: &'static str = "a reach";
    const TABLE: &'static str = REACH;
    const PICTURES: &'static [&'static str] = &REACH_PICTURES;
    const WITH_NUMBERS: bool = true;

    fn gather(folder: &Path, units: Option<UnitSet>) -> Result<Self, ResultsError> {
        let summary = ReachSummary::read(&folder.join("summary.json"))?;
        let title = format!("{}: reach", summary.case);
        let head = page::head(title, units, Some(&summary.settings), facts(&summary));
        Ok(Self {
            head,
            checks: summary.checks.iter().map(check).collect(),
            answers: in_sets(|set| sentences::answers(&summary, set)),
            notes: in_sets(|set| sentences::notes(&summary, set)),
            frictions: summary.frictions.iter().map(sentences::friction).collect(),
            titles: Limit::ALL.map(|limit| limit.title().to_owned()).to_vec(),
            limits: summary.frictions.iter().enumerate().flat_map(rows).collect(),
            curves: curves(
                &table(folder, REACH)?,
                &folder.join(format!("{REACH}.parquet")),
                &summary,
            )?,
            depths_m: [summary.from_m, summary.to_m],
            uncertain: summary
                .uncertain
                .as_ref()
                .map(|uncertain| uncertain::shown(uncertain, &Names::REACH)),
        })
    }

    fn html(&self) -> Option<String> {
        Some(reach_html(self))
    }

    fn plots(&self) -> Vec<Plot> {
        reach_plots(self, &self.head.units)
    }
}

fn check(row: &ReachCheck) -> ReachVerdict {
    ReachVerdict {
        severity: row.check.severity,
        friction: sentences::friction_words(row.friction),
        sentences: in_sets(|units| row.check.sentence_in(units)),
    }
}

fn facts(summary: &ReachSummary) -> Vec<Fact> {
    let fact = |label: &str, value: Cell| Fact { label: label.into(), value };
    vec![
        fact("From", Cell::quantity(summary.from_m, "length")),
        fact("To", Cell::quantity(summary.to_m, "length")),
        fact("Inclination", Cell::quantity(summary.inclination_rad, "angle")),
    ]
}

fn rows((friction, reach): (usize, &ReachOfFriction)) -> Vec<ReachRow> {
    let row = |limit: &wholestring_results::ReachLimit| ReachRow {
        operation: limit.operation,
        limit: limit.title.clone(),
        stops: limit.stops,
        friction,
        depth_m: limit.depth_m,
        already: limit.already,
        margins: [limit.margin_at_from, limit.margin_at_to],
        md_m: limit.at_md_m,
        first: reach
            .first
            .as_ref()
            .is_some_and(|first| first.limit == limit.limit && first.operation == limit.operation),
    };
    reach.limits.iter().map(row).collect()
}

/// Curves of `reach.parquet`: rows that differ only in depth.
fn curves(
    table: &Table,
    path: &Path,
    summary: &ReachSummary,
) -> Result<Vec<ReachCurve>, ResultsError> {
    let (operations, limit) = (words(table, "operation"), words(table, "limit"));
    let friction = numbers(table, "friction");
    let (depth_m, margin) = (numbers(table, "bit_depth_m"), numbers(table, "margin"));
    let number = |value: Option<f64>| value.unwrap_or(f64::NAN);
    let mut curves: Vec<ReachCurve> = Vec::new();
    let mut last = None;
    for row in 0..operations.len().min(limit.len()).min(margin.len()) {
        let key = (&operations[row], &limit[row], friction[row].map(f64::to_bits));
        if last != Some(key) {
            let place = summary.frictions.iter().position(|reach| reach.friction == friction[row]);
            let titled = summary.frictions.iter().flat_map(|friction| &friction.limits);
            let title = titled.clone().find(|titled| titled.limit == limit[row]);
            curves.push(ReachCurve {
                operation: operation(table, row, path)?,
                limit: title.map_or_else(|| limit[row].clone(), |title| title.title.clone()),
                friction: place.unwrap_or(0),
                points: Vec::new(),
            });
            last = Some(key);
        }
        if let Some(curve) = curves.last_mut() {
            curve.points.push((number(depth_m[row]), number(margin[row])));
        }
    }
    Ok(curves)
}
