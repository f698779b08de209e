//! The page, the pictures and the workbook of a plan, made from the files in its folder.

use std::path::Path;

use serde_json::Value as Json;
use wholestring::{operation::OperationKind, well::FrictionLevel};
use wholestring_report::{
    BucklingCurve, Cell, Fact, PageHead, Plan, PlanCurve, PlanLevel, PlanLimitRow, PlanSpot,
    PlanVerdict, Section, Severity, in_sets, shown_dimension,
};
use wholestring_results::{
    PlanCheck, PlanOperation, PlanPoint, PlanSummary, ResultsError, ResultsFolder, Table,
    UncertainTables,
};
use wholestring_units::UnitSet;

use super::{
    files::{FATIGUE, PEAKS_TIME, Tables, WEAR, WORKBOOK},
    levels::{label, short},
    mud, peaks, weight,
    workbook::workbook,
};
use crate::{page::table, results_kind::Results};

/// Writes the workbook in these units.
pub(super) fn write_workbook(
    folder: &ResultsFolder,
    summary: &PlanSummary,
    tables: &Tables,
    units: UnitSet,
) -> Result<(), crate::error::Error> {
    let bytes = workbook(summary, tables, units).bytes().map_err(crate::error::Error::failed)?;
    Ok(folder.write_file(WORKBOOK, &bytes)?)
}

/// Rewrites page, pictures and workbook.
pub(super) fn write_again(
    folder: &ResultsFolder,
    units: Option<UnitSet>,
) -> Result<(), crate::error::Error> {
    let summary = PlanSummary::read(&folder.path().join("summary.json"))?;
    let peaks_time = table(folder.path(), PEAKS_TIME)?;
    let plan = of_summary(&summary, &peaks_time, units);
    let units = plan.head.units.parse().unwrap_or_default();
    plan.write(folder, false)?;
    write_workbook(folder, &summary, &tables(folder.path(), &summary, peaks_time)?, units)
}

/// The workbook of the plan in a folder.
pub(crate) fn workbook_of(
    folder: &Path,
    units: UnitSet,
) -> Result<wholestring_report::Workbook, ResultsError> {
    let summary = PlanSummary::read(&folder.join("summary.json"))?;
    let tables = tables(folder, &summary, table(folder, PEAKS_TIME)?)?;
    Ok(workbook(&summary, &tables, units))
}

/// Tables of a plan that are not in its summary.
fn tables(folder: &Path, summary: &PlanSummary, peaks_time: Table) -> Result<Tables, ResultsError> {
    // The table of limits is for programs only; the page reads them from the summary.
    let [fatigue, wear] = [FATIGUE, WEAR].map(|name| table(folder, name));
    let samples = summary.uncertain.as_ref().map(|_| table(folder, UncertainTables::PLAN.samples));
    let samples = samples.transpose()?;
    Ok(Tables {
        limits: Table::new(Vec::new()),
        fatigue: fatigue?,
        wear: wear?,
        samples,
        peaks_time,
    })
}

/// Texts of a plan in these units.
pub(super) fn texts(summary: &PlanSummary, texts: &[String], units: UnitSet) -> Vec<String> {
    texts.iter().map(|text| summary.texts.in_units(text, units)).collect()
}

/// Page data of a plan.
pub(super) fn gather(folder: &Path, units: Option<UnitSet>) -> Result<Plan, ResultsError> {
    let summary = PlanSummary::read(&folder.join("summary.json"))?;
    Ok(of_summary(&summary, &table(folder, PEAKS_TIME)?, units))
}

fn of_summary(summary: &PlanSummary, peaks_time: &Table, units: Option<UnitSet>) -> Plan {
    let settings = &summary.settings;
    let number = |value: &Json| value.as_f64();
    let message = (summary.missing > 0).then(|| {
        format!(
            "The plan was interrupted: {} of {} points are missing.",
            summary.missing,
            summary.missing + summary.points.len()
        )
    });
    Plan {
        head: PageHead::new(
            format!("{}: plan", summary.case),
            units,
            Some(settings),
            facts(summary),
        ),
        message,
        models: summary.models.clone(),
        levels: FrictionLevel::ALL.map(|level| shown_level(summary, level)).into(),
        curves: curves(summary),
        buckling: buckling(summary),
        mud: mud::shown(summary),
        hole: hole(summary),
        limits: summary.checks.iter().filter_map(limit).collect(),
        checks: verdicts(summary),
        unchecked: in_sets(|units| texts(summary, &summary.unchecked, units)),
        counted: in_sets(|units| texts(summary, &summary.counted, units)),
        not_counted: in_sets(|units| texts(summary, &summary.not_counted, units)),
        fatigue: summary.fatigue.clone(),
        wear: summary.wear.clone(),
        events: peaks::events(summary, peaks_time),
        block_N: number(&settings["rig"]["block_weight_N"]),
        surface_limits: summary.surface_limits.clone(),
        uncertain: summary.uncertain.clone(),
        weight_on_bit_N: weight::on_bit_N(summary),
        measured: summary.measured.clone(),
        overlay: summary.overlay.clone(),
    }
}

fn shown_level(summary: &PlanSummary, level: FrictionLevel) -> PlanLevel {
    let sections = summary.frictions.iter().filter(|friction| friction.friction == level);
    let sections = sections.map(|section| {
        let kind = if section.kind == "casing" { "casing" } else { "open hole" };
        let around = match section.around == section.along {
            true => String::new(),
            false => format!(", rotational {}", short(section.around)),
        };
        format!("{kind} {}{around}", short(section.along))
    });
    let mut sections: Vec<String> = sections.collect();
    sections.dedup();
    PlanLevel { name: level.name().to_owned(), label: label(summary, level), sections }
}

fn curves(summary: &PlanSummary) -> Vec<PlanCurve> {
    let mut curves = Vec::new();
    for model in summary.models.iter().copied() {
        for operation in summary.operations.iter().copied() {
            for (level, friction) in FrictionLevel::ALL.into_iter().enumerate() {
                curves.push(PlanCurve {
                    model,
                    operation,
                    level,
                    points: summary
                        .curve(model, operation, friction)
                        .map(|point| spot(summary, point))
                        .collect(),
                });
            }
        }
    }
    curves
}

fn spot(summary: &PlanSummary, point: &PlanPoint) -> PlanSpot {
    let number = |value: Option<f64>| value.unwrap_or(f64::NAN);
    PlanSpot {
        bit_depth_m: point.bit_depth_m,
        hook_load_N: number(point.scalars.map(|scalar| scalar.hook_load_N)),
        torque_N_m: number(point.scalars.map(|scalar| scalar.surface_torque_N_m)),
        buckling: point.buckling.clone().unwrap_or_default(),
        worst: point.worst.as_ref().map(|worst| (worst.kind.label().to_owned(), worst.severity)),
        message: point.message.as_ref().map(|message| {
            in_sets(|units| match &point.worst {
                Some(worst) if worst.sentence == *message => worst.sentence_in(units),
                _ => summary.texts.in_units(message, units),
            })
        }),
    }
}

fn buckling(summary: &PlanSummary) -> Vec<BucklingCurve> {
    let mut curves = Vec::new();
    for operation in [OperationKind::Drill, OperationKind::Slide] {
        for (level, friction) in FrictionLevel::ALL.into_iter().enumerate() {
            let rows = summary.buckling.iter();
            let rows = rows.filter(|row| row.operation == operation && row.friction == friction);
            let number = |value: Option<f64>| value.unwrap_or(f64::NAN);
            let points = rows.map(|row| {
                let weights = [row.sinusoidal_weight_N, row.helical_weight_N];
                (row.bit_depth_m, weights.map(number))
            });
            let points = points.collect();
            curves.push(BucklingCurve { operation, level, points });
        }
    }
    curves
}

/// A limit in the form of the page; `None` for a check without a load and a capacity.
fn limit(row: &PlanCheck) -> Option<PlanLimitRow> {
    let check = &row.check;
    Some(PlanLimitRow {
        breaks: check.kind.stops(),
        kind: check.kind.label().to_owned(),
        operation: operation(row),
        friction: row.friction,
        bit_depth_m: row.bit_depth_m,
        component: check.component.clone().unwrap_or_default(),
        md_m: check.md_m,
        load: check.value?,
        capacity: check.limit?,
        dimension: shown_dimension(check.kind.quantity()).to_owned(),
        factor: check.factor?,
        required: check.required?,
        verdict: check.verdict.words().to_owned(),
        severity: check.severity,
    })
}

/// The operation in words, or the event.
fn operation(row: &PlanCheck) -> String {
    match row.operation {
        PlanOperation::Event(event) => format!("{}, dynamics", event.label()),
        PlanOperation::Kind(kind) => kind.words().to_owned(),
    }
}

/// Checks that require attention, the most severe first, then the governing limit of each operation
/// that is not among them.
fn verdicts(summary: &PlanSummary) -> Vec<PlanVerdict> {
    let mut rows: Vec<&PlanCheck> =
        summary.checks.iter().filter(|row| row.check.severity >= Severity::Warning).collect();
    rows.sort_by_key(|row| std::cmp::Reverse(row.check.severity));
    let others: Vec<&PlanCheck> =
        summary.governing.iter().filter(|governing| !rows.contains(governing)).collect();
    rows.extend(others);
    let verdict = |row: &&PlanCheck| PlanVerdict {
        severity: row.check.severity,
        verdict: row.check.verdict.words().to_owned(),
        governs: summary.governing.contains(row),
        model: row.model,
        operation: operation(row),
        friction: row.friction,
        bit_depth_m: row.bit_depth_m,
        sentences: in_sets(|units| row.check.sentence_in(units)),
    };
    rows.iter().map(verdict).collect()
}

/// Sections of the hole with the expected friction.
fn hole(summary: &PlanSummary) -> Vec<Section> {
    let holes = summary.settings["well"]["hole"].as_array();
    let diameters = holes.into_iter().flatten().map(|hole| hole["diameter_m"].as_f64());
    let sections =
        summary.frictions.iter().filter(|friction| friction.friction == FrictionLevel::Expected);
    let section =
        |(friction, diameter_m): (&wholestring_results::PlanFriction, Option<f64>)| Section {
            kind: friction.kind.clone(),
            from_m: friction.from_md_m,
            to_m: friction.to_md_m,
            diameter_m: diameter_m.unwrap_or(f64::NAN),
            friction: friction.along,
        };
    sections.zip(diameters).map(section).collect()
}

/// Key facts of the plan.
fn facts(summary: &PlanSummary) -> Vec<Fact> {
    let settings = &summary.settings;
    let fact = |label: &str, value: Cell| Fact { label: label.into(), value };
    let quantity = |number: &Json, dimension: &str| {
        number.as_f64().map_or(Cell::Nothing, |value| Cell::quantity(value, dimension))
    };
    let names: Vec<&str> = summary.operations.iter().map(|operation| operation.words()).collect();
    let models: Vec<String> =
        summary.models.iter().map(|model| format!("{model} string")).collect();
    let frictions: Vec<String> = FrictionLevel::ALL.map(|level| label(summary, level)).into();
    let depths = &summary.bit_depths_m;
    let ends = [depths.first(), depths.last()].map(|depth| depth.copied().unwrap_or(f64::NAN));
    vec![
        fact("Operations", Cell::Text(names.join(", "))),
        fact("Solved by", Cell::Text(models.join(", "))),
        fact("Friction", Cell::Text(frictions.join(", "))),
        fact("Bit depths", Cell::Text(depths.len().to_string())),
        fact("From", Cell::quantity(ends[0], "length")),
        fact("To", Cell::quantity(ends[1], "length")),
        fact("Mud density", quantity(&settings["mud"]["density_kg_per_m3"], "density")),
        fact("Weight of the block", quantity(&settings["rig"]["block_weight_N"], "force")),
    ]
}
