//! A broomstick in memory: every operation at every depth with every friction level.

use std::{num::NonZeroUsize, sync::Mutex};

use wholestring::operation::{Operation, OperationKind};
use wholestring_case::Case;
use wholestring_plan::{
    Broomstick, BroomstickPoint, BroomstickTask, FrictionLevel, Frictions, LevelFriction, Statics,
};
use wholestring_results::{Column, Data, PlanPoint, Table, plan_broomstick_table};
use wholestring_units::Dimension;

use super::rows;
use crate::{
    cancellation::CancellationToken,
    error::Error,
    parallel::{in_parallel, jobs, lock},
    reach,
};

/// Request of a broomstick; empty lists select those of the case's plan.
#[derive(Debug)]
pub struct BroomstickRequest<'a> {
    /// The case.
    pub case: &'a Case,
    /// Static models.
    pub models: Vec<Statics>,
    /// Friction factors of all sections; if empty, the low, expected and high friction of the plan.
    pub frictions: Vec<f64>,
    /// Depths of the bit, m.
    pub bit_depths_m: Vec<f64>,
    /// Operations at every depth.
    pub operations: Vec<OperationKind>,
    /// Number of parallel jobs; one per core by default.
    pub jobs: Option<NonZeroUsize>,
}

/// Largest friction factor allowed by the case file.
const MAX_FRICTION: f64 = 2.0;

/// Name of a requested friction factor in messages.
const FRICTION: &str = "Friction factor of all hole sections";

/// A broomstick, complete or up to a cancellation.
#[derive(Debug)]
pub struct BroomstickFound {
    /// The table `plan_broomstick`.
    pub table: Table,
    /// Number of points that are missing because of a cancellation.
    pub missing: usize,
}

/// Computes the points of a broomstick: the table `plan_broomstick` of the plan of a case.
/// Requested friction factors are numbers in its column `friction`.
///
/// # Errors
/// A friction factor or a depth that is out of its range, or an operation whose set points are not
/// in the case.
pub fn broomstick(
    request: &BroomstickRequest<'_>,
    cancellation: &CancellationToken,
) -> Result<BroomstickFound, Error> {
    let case = request.case;
    let depths_m = depths_m(request)?;
    let models =
        if request.models.is_empty() { case.plan.models.clone() } else { request.models.clone() };
    let operations: Vec<Operation> = match &request.operations[..] {
        [] => case.plan.operations.clone(),
        kinds => kinds.iter().map(|kind| operation(case, *kind)).collect::<Result<_, _>>()?,
    };
    let setup = case.setup();
    let with = |frictions: &Frictions| -> Result<Broomstick, Error> {
        let operations = operations.clone();
        let map_err =
            Broomstick::new(&setup, frictions, operations, depths_m.clone(), models.clone())
                .map_err(Error::failed)?;
        let stiff = case.dynamics.stiff_string();
        Ok(map_err.with_settings(case.soft, stiff).with_judge(case.judge(case.units)))
    };
    // A broomstick has three friction levels at a time.
    let levels = &FrictionLevel::ALL[..];
    let sets: Vec<(Broomstick, &[FrictionLevel])> = match &request.frictions[..] {
        [] => vec![(with(&case.plan.frictions)?, levels)],
        factors => {
            let set = |some: &[f64]| {
                if let Some(factor) =
                    some.iter().find(|factor| !(0.0..=MAX_FRICTION).contains(*factor))
                {
                    let reason = format!("a friction factor of {factor} is outside 0 to 2");
                    return Err(Error::BadInput(reason));
                }
                let level = |place: usize| LevelFriction::uniform(some[place.min(some.len() - 1)]);
                let set = with(&Frictions { low: level(0), expected: level(1), high: level(2) })?;
                Ok((set, &levels[..some.len()]))
            };
            factors.chunks(levels.len()).map(set).collect::<Result<_, Error>>()?
        }
    };
    let tasks: Vec<(usize, BroomstickTask)> = (0..sets.len())
        .flat_map(|set| sets[set].0.tasks().into_iter().map(move |task| (set, task)))
        .collect();
    let done: Vec<Mutex<Option<Vec<BroomstickPoint>>>> =
        tasks.iter().map(|_| Mutex::default()).collect();
    let order: Vec<usize> = (0..tasks.len()).collect();
    in_parallel(jobs(request.jobs), &order, |index| {
        if !cancellation.is_cancelled() {
            let (set, task) = &tasks[index];
            let (sets, levels) = &sets[*set];
            *lock(&done[index]) = Some(sets.solve_at(task, levels));
        }
    });
    let (mut found, mut missing) = (Vec::new(), 0);
    for ((set, _), one) in tasks.iter().zip(&done) {
        match lock(one).take() {
            Some(points) => found
                .extend(points.into_iter().enumerate().map(|(place, point)| (*set, place, point))),
            None => missing += sets[*set].1.len(),
        }
    }
    // Sorted curve by curve, as in a plan, because a task contains the friction levels of one
    // depth.
    found.sort_by_key(|(set, place, point): &(usize, usize, BroomstickPoint)| {
        let model = models.iter().position(|model| *model == point.model);
        let operation = operations.iter().position(|one| one.kind == point.operation);
        (model, operation, *set, *place)
    });
    let points: Vec<BroomstickPoint> = found.iter().map(|(_, _, point)| point.clone()).collect();
    let rows: Vec<PlanPoint> = rows::points(&points);
    let table = plan_broomstick_table(&rows, case.model.rig.block_weight_N);
    if request.frictions.is_empty() {
        return Ok(BroomstickFound { table, missing });
    }
    let factor = |(set, place, _): &(usize, usize, _)| {
        Some(request.frictions[FrictionLevel::ALL.len() * set + place])
    };
    let factors = Data::Number(found.iter().map(factor).collect());
    let columns = table.columns().iter().cloned().map(|column| match column.name.as_str() {
        "friction" => Column { meaning: FRICTION.into(), data: factors.clone(), ..column },
        _ => column,
    });
    Ok(BroomstickFound { table: Table::new(columns.collect()), missing })
}

/// Depths of the bit that string and well allow, increasing.
fn depths_m(request: &BroomstickRequest<'_>) -> Result<Vec<f64>, Error> {
    let case = request.case;
    if request.bit_depths_m.is_empty() {
        return Ok(case.plan.bit_depths_m.clone());
    }
    let hole_m = case.model.well.hole.sections().last().map_or(0.0, |section| section.to_md_m);
    let deepest_m = hole_m.min(case.model.well.path.last_md_m());
    let least_m = case.setup().least_depth_m();
    let mut depths_m = request.bit_depths_m.clone();
    let is_there = |depth_m: &f64| *depth_m > least_m && *depth_m <= deepest_m;
    if let Some(depth_m) = depths_m.iter().find(|depth_m| !is_there(depth_m)) {
        let depth = |md_m: f64| Dimension::Length.format(md_m, case.units);
        return Err(Error::BadInput(format!(
            "a bit depth of {} is out of range: expected more than {}, and no more than {}, where \
             hole and survey end",
            depth(*depth_m),
            depth(least_m),
            depth(deepest_m)
        )));
    }
    depths_m.sort_by(f64::total_cmp);
    depths_m.dedup();
    Ok(depths_m)
}

/// The plan's operation of a kind; if there is none, one with the case's set points.
fn operation(case: &Case, kind: OperationKind) -> Result<Operation, Error> {
    let planned = case.plan.operations.iter().find(|operation| operation.kind == kind);
    planned.map_or_else(
        || reach::operation(case, kind).map_err(Error::BadInput),
        |planned| Ok(*planned),
    )
}
