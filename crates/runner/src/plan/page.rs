//! The page, the pictures and the workbook of a plan, made from the files that it left.

use std::path::Path;

use serde_json::Value as Json;
use wholestring_plan::dynamic::Event;
use wholestring_report::{
    BucklingCurve, Cell, Fact, Plan, PlanCurve, PlanFatigueHourRow, PlanFatigueRow, PlanLevel,
    PlanLimitRow, PlanMeasured, PlanOverlay, PlanOverlayDifference, PlanOverlayRow, PlanSpot,
    PlanVerdict, PlanWearRow, Section, Severity, operation_name, shown_dimension,
};
use wholestring_results::{
    PlanCheck, PlanFatigue, PlanPoint, PlanSummary, PlanWear, ResultsError, ResultsFolder, Table,
};
use wholestring_units::UnitSet;

use super::{
    files::{FATIGUE, PEAKS_TIME, Tables, WEAR, WORKBOOK},
    governing::governing_sentences,
    levels::{LEVELS, label, short},
    mud, peaks, surface, weight,
    workbook::workbook,
};
use crate::{
    page::{self, table},
    results_kind::Results,
    uncertain::{self, Names},
};

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

/// Makes page, pictures and workbook again.
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

/// The tables of a plan that its summary does not hold.
fn tables(folder: &Path, summary: &PlanSummary, peaks_time: Table) -> Result<Tables, ResultsError> {
    // Limits are read by programs alone: what a page shows of them is in the summary.
    let [fatigue, wear] = [FATIGUE, WEAR].map(|name| table(folder, name));
    let samples = summary.uncertain.as_ref().map(|_| table(folder, Names::PLAN.samples));
    let samples = samples.transpose()?;
    Ok(Tables {
        limits: Table::new(Vec::new()),
        fatigue: fatigue?,
        wear: wear?,
        samples,
        peaks_time,
    })
}

/// Everything that is reported of a plan.
pub(super) fn gather(folder: &Path, units: Option<UnitSet>) -> Result<Plan, ResultsError> {
    let summary = PlanSummary::read(&folder.join("summary.json"))?;
    Ok(of_summary(&summary, &table(folder, PEAKS_TIME)?, units))
}

fn of_summary(summary: &PlanSummary, peaks_time: &Table, units: Option<UnitSet>) -> Plan {
    let settings = &summary.settings;
    let number = |of: &Json| of.as_f64();
    let message = (summary.missing > 0).then(|| {
        format!(
            "The plan was interrupted: {} of {} points are missing.",
            summary.missing,
            summary.missing + summary.points.len()
        )
    });
    Plan {
        head: page::head(format!("{}: plan", summary.case), units, Some(settings), facts(summary)),
        message,
        models: summary.models.clone(),
        levels: LEVELS.iter().map(|name| level(summary, name)).collect(),
        curves: curves(summary),
        buckling: buckling(summary),
        mud: mud::shown(summary),
        hole: hole(summary),
        limits: summary.checks.iter().filter_map(limit).collect(),
        checks: verdicts(summary),
        first: [UnitSet::Si, UnitSet::Metric, UnitSet::Field]
            .map(|units| governing_sentences(summary, units)),
        unchecked: summary.unchecked.clone(),
        counted: summary.counted.clone(),
        not_counted: summary.not_counted.clone(),
        fatigue: summary.fatigue.iter().map(fatigue).collect(),
        wear: summary.wear.iter().map(wear).collect(),
        events: peaks::events(summary, peaks_time),
        block_N: number(&settings["rig"]["block_weight_N"]),
        surface_limits: summary.surface_limits.iter().map(surface::shown).collect(),
        uncertain: summary.uncertain.as_ref().map(|of| uncertain::shown(of, &Names::PLAN)),
        weight_on_bit_N: weight::on_bit_N(summary),
        measured: summary.measured.iter().map(measured).collect(),
        overlay: summary.overlay.as_ref().map(overlay),
    }
}

fn level(summary: &PlanSummary, name: &str) -> PlanLevel {
    let sections = summary.frictions.iter().filter(|of| of.friction == name);
    let sections = sections.map(|of| {
        let kind = if of.kind == "casing" { "casing" } else { "open hole" };
        let around = match of.around == of.along {
            true => String::new(),
            false => format!(", {} around", short(of.around)),
        };
        format!("{kind} {}{around}", short(of.along))
    });
    let mut sections: Vec<String> = sections.collect();
    sections.dedup();
    PlanLevel { name: name.to_owned(), label: label(summary, name), sections }
}

fn curves(summary: &PlanSummary) -> Vec<PlanCurve> {
    let mut curves = Vec::new();
    for model in &summary.models {
        for operation in &summary.operations {
            for (level, friction) in LEVELS.iter().enumerate() {
                curves.push(PlanCurve {
                    model: model.clone(),
                    operation: operation.clone(),
                    level,
                    points: summary.curve(model, operation, friction).map(spot).collect(),
                });
            }
        }
    }
    curves
}

fn spot(of: &PlanPoint) -> PlanSpot {
    let number = |of: Option<f64>| of.unwrap_or(f64::NAN);
    PlanSpot {
        bit_depth_m: of.bit_depth_m,
        hook_load_N: number(of.scalars.map(|of| of.hook_load_N)),
        torque_N_m: number(of.scalars.map(|of| of.surface_torque_N_m)),
        buckling: of.buckling.clone().unwrap_or_default(),
        worst: of.worst.as_ref().map(|worst| (worst.kind.label().to_owned(), worst.severity)),
        message: of.message.clone(),
    }
}

fn buckling(summary: &PlanSummary) -> Vec<BucklingCurve> {
    let mut curves = Vec::new();
    for operation in ["drill", "slide"] {
        for (level, friction) in LEVELS.iter().enumerate() {
            let rows = summary.buckling.iter();
            let rows = rows.filter(|of| of.operation == operation && of.friction == *friction);
            let number = |of: Option<f64>| of.unwrap_or(f64::NAN);
            let points = rows.map(|of| {
                let weights = [of.sinusoidal_weight_N, of.helical_weight_N];
                (of.bit_depth_m, weights.map(number))
            });
            let points = points.collect();
            curves.push(BucklingCurve { operation: operation.to_owned(), level, points });
        }
    }
    curves
}

/// A limit as the page shows it; none of a check without a load and a capacity.
fn limit(row: &PlanCheck) -> Option<PlanLimitRow> {
    let check = &row.check;
    Some(PlanLimitRow {
        breaks: check.kind.stops(),
        kind: check.kind.label().to_owned(),
        operation: operation(row),
        friction: row.friction.clone(),
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

fn operation(row: &PlanCheck) -> String {
    Event::from_name(&row.operation)
        .map_or_else(|| row.operation.clone(), |event| format!("{}, dynamics", event.label()))
}

/// The checks that need attention, the most severe first.
fn verdicts(summary: &PlanSummary) -> Vec<PlanVerdict> {
    let mut rows: Vec<&PlanCheck> =
        summary.checks.iter().filter(|row| row.check.severity >= Severity::Warning).collect();
    rows.sort_by_key(|row| std::cmp::Reverse(row.check.severity));
    let verdict = |row: &&PlanCheck| PlanVerdict {
        severity: row.check.severity,
        verdict: row.check.verdict.words().to_owned(),
        label: row.check.kind.label().to_owned(),
        model: row.model.clone(),
        operation: operation(row),
        friction: row.friction.clone(),
        bit_depth_m: row.bit_depth_m,
        sentence: row.check.sentence.clone(),
    };
    rows.iter().map(verdict).collect()
}

fn fatigue(of: &PlanFatigue) -> PlanFatigueRow {
    PlanFatigueRow {
        model: of.model.clone(),
        component: of.component.clone(),
        damage: of.damage,
        hour: of.hour.map(|hour| PlanFatigueHourRow {
            md_m: hour.md_m,
            damage_per_hour: hour.damage_per_hour,
            bending_Pa: hour.bending_Pa,
            doglegs_rad_per_m: [Some(hour.dogleg_rad_per_m), hour.permissible_dogleg_rad_per_m]
                .map(|of| of.unwrap_or(f64::NAN)),
        }),
    }
}

fn wear(of: &PlanWear) -> PlanWearRow {
    let number = |of: Option<f64>| of.unwrap_or(f64::NAN);
    PlanWearRow {
        model: of.model.clone(),
        section: of.section,
        md_m: of.md_m,
        groove_m: number(of.groove_m),
        wall_left_m: number(of.wall_left_m),
        worn: number(of.worn),
        burst_Pa: of.burst_Pa.unwrap_or([f64::NAN; 2]),
        collapse_Pa: of.collapse_Pa.unwrap_or([f64::NAN; 2]),
    }
}

fn measured(of: &wholestring_results::PlanMeasured) -> PlanMeasured {
    PlanMeasured {
        model: of.model.clone(),
        place: of.place.clone(),
        operation: of.operation.clone(),
        is_torque: of.is_torque,
        held_out: of.held_out,
        bit_depth_m: of.bit_depth_m,
        measured: of.measured,
        block_N: of.block_N,
        predicted: of.predicted.map(|value| value.unwrap_or(f64::NAN)),
        between: of.between(),
        message: of.message.clone(),
    }
}

fn overlay(of: &wholestring_results::PlanOverlay) -> PlanOverlay {
    let rows = of.rows.iter().map(|row| PlanOverlayRow {
        model: row.model.clone(),
        operation: row.operation.clone(),
        is_torque: row.is_torque,
        bit_depth_m: row.bit_depth_m,
        theirs: row.theirs,
    });
    let differences = of.differences.iter().map(|of| PlanOverlayDifference {
        model: of.model.clone(),
        operation: of.operation.clone(),
        is_torque: of.is_torque,
        count: of.count,
        mean: of.mean,
        largest: of.largest,
        largest_at_m: of.largest_at_m,
        theirs_there: of.theirs_there,
        largest_part: of.largest_part,
    });
    PlanOverlay { file: of.file.clone(), rows: rows.collect(), differences: differences.collect() }
}

/// Sections of the hole with the friction that is expected.
fn hole(summary: &PlanSummary) -> Vec<Section> {
    let holes = summary.settings["well"]["hole"].as_array();
    let diameters = holes.into_iter().flatten().map(|of| of["diameter_m"].as_f64());
    let sections = summary.frictions.iter().filter(|of| of.friction == "expected");
    let section = |(of, diameter_m): (&wholestring_results::PlanFriction, Option<f64>)| Section {
        kind: of.kind.clone(),
        from_m: of.from_md_m,
        to_m: of.to_md_m,
        diameter_m: diameter_m.unwrap_or(f64::NAN),
        friction: of.along,
    };
    sections.zip(diameters).map(section).collect()
}

/// The plan in a few facts.
fn facts(summary: &PlanSummary) -> Vec<Fact> {
    let settings = &summary.settings;
    let fact = |label: &str, value: Cell| Fact { label: label.into(), value };
    let quantity = |of: &Json, dimension: &str| {
        of.as_f64().map_or(Cell::Nothing, |value| Cell::quantity(value, dimension))
    };
    let names: Vec<String> = summary.operations.iter().map(|of| operation_name(of)).collect();
    let models: Vec<String> = summary.models.iter().map(|of| format!("{of} string")).collect();
    let frictions: Vec<String> = LEVELS.iter().map(|of| label(summary, of)).collect();
    let depths = &summary.bit_depths_m;
    let ends = [depths.first(), depths.last()].map(|of| of.copied().unwrap_or(f64::NAN));
    vec![
        fact("Operations", Cell::Text(names.join(", "))),
        fact("Solved by", Cell::Text(models.join(", "))),
        fact("Friction", Cell::Text(frictions.join(", "))),
        fact("Bit depths", Cell::Text(depths.len().to_string())),
        fact("From", Cell::quantity(ends[0].round(), "length")),
        fact("To", Cell::quantity(ends[1].round(), "length")),
        fact("Mud density", quantity(&settings["mud"]["density_kg_per_m3"], "density")),
        fact("Weight of the block", quantity(&settings["rig"]["block_weight_N"], "force")),
    ]
}
