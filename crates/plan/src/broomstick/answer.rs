//! The answers of a task, friction by friction.

use wholestring::{
    findings::{Finding, of_soft, of_stiff},
    model::Model,
    operation::Operation,
    outcome::Solution,
    statics::{
        soft,
        stiff::{self, Equilibrium, StiffError},
    },
};

use crate::limits::limits;

use super::{
    Broomstick, BroomstickPoint, BroomstickTask, FrictionLevel,
    point::{NoAnswer, PointAnswer, Statics},
};

impl Broomstick {
    /// The points of a task, one for each of [`FrictionLevel::ALL`]. What has no answer says why.
    pub fn solve(&self, task: &BroomstickTask) -> Vec<BroomstickPoint> {
        self.solve_at(task, &FrictionLevel::ALL)
    }

    /// The points of a task at these levels of friction alone.
    pub fn solve_at(
        &self,
        task: &BroomstickTask,
        levels: &[FrictionLevel],
    ) -> Vec<BroomstickPoint> {
        answers(self, task, levels)
    }
}

/// The points of a task in the order of the levels.
fn answers(
    of: &Broomstick,
    task: &BroomstickTask,
    levels: &[FrictionLevel],
) -> Vec<BroomstickPoint> {
    let operation = &task.operation;
    let point = |friction: FrictionLevel, outcome| BroomstickPoint {
        model: task.model,
        friction,
        operation: operation.kind,
        bit_depth_m: operation.bit_depth_m,
        outcome,
    };
    match task.model {
        Statics::Soft => {
            levels.iter().map(|level| point(*level, by_soft(of, *level, operation))).collect()
        }
        Statics::Stiff => {
            // The string rests with other friction much as it does with what is expected.
            let expected = levels.iter().find(|level| **level == FrictionLevel::Expected);
            let Some(&first) = expected.or(levels.first()) else { return Vec::new() };
            let (outcome, found) = by_stiff(of, first, operation, None);
            let locked = locked_up(&outcome).filter(|_| operation.slides_down()).cloned();
            let mut outcome = Some(outcome);
            let answer = |&level: &FrictionLevel| {
                let own = outcome.take_if(|_| level == first);
                let by_more = || locked.clone().filter(|_| of.rubs_more(level, first)).map(Err);
                let outcome = own.or_else(by_more);
                let solve = || by_stiff(of, level, operation, found.as_ref()).0;
                point(level, outcome.unwrap_or_else(solve))
            };
            levels.iter().map(answer).collect()
        }
    }
}

/// Why a string that locks up has no answer; none where it has one, or another reason.
fn locked_up(outcome: &Result<PointAnswer, NoAnswer>) -> Option<&NoAnswer> {
    let is_lock_up = |error: &&NoAnswer| {
        matches!(error, NoAnswer::Stiff(StiffError::LocksUp { .. } | StiffError::RunsAway { .. }))
    };
    outcome.as_ref().err().filter(is_lock_up)
}

impl Broomstick {
    /// Whether no section of the hole rubs less at a level of friction than at another: what locks
    /// up under the one locks up under the other.
    fn rubs_more(&self, level: FrictionLevel, other: FrictionLevel) -> bool {
        let sections = |level| self.setup(level).well.hole.sections();
        let mut pairs = sections(level).iter().zip(sections(other));
        pairs.all(|(own, other)| own.friction.kinetic >= other.friction.kinetic)
    }
}

fn by_soft(
    of: &Broomstick,
    level: FrictionLevel,
    operation: &Operation,
) -> Result<PointAnswer, NoAnswer> {
    let model = of.setup(level).at(operation.bit_depth_m)?;
    let solved = soft::solve(&model, operation, &of.soft)?;
    let findings = of_soft(&model, operation, &solved);
    Ok(answer(of, level, &model, operation, &(&solved).into(), findings))
}

/// What a solution comes to.
fn answer(
    of: &Broomstick,
    level: FrictionLevel,
    model: &Model,
    operation: &Operation,
    solution: &Solution<'_>,
    findings: Vec<Finding>,
) -> PointAnswer {
    let campaign = of.campaign.as_ref().filter(|_| level == FrictionLevel::Expected);
    let limits = limits(model, operation, solution, &of.limits);
    let share = campaign.and_then(|campaign| campaign.share(model, operation, solution));
    PointAnswer::new(solution.scalars, solution.profile, findings, limits, share)
}

/// The answer, and where the string rests, to begin another search with.
fn by_stiff(
    of: &Broomstick,
    level: FrictionLevel,
    operation: &Operation,
    near: Option<&Equilibrium>,
) -> (Result<PointAnswer, NoAnswer>, Option<Equilibrium>) {
    let model = match of.setup(level).at(operation.bit_depth_m) {
        Ok(model) => model,
        Err(error) => return (Err(error.into()), None),
    };
    let found: Result<Equilibrium, StiffError> = match near {
        Some(near) => stiff::equilibrium_beside(&model, operation, &of.stiff, near),
        None => stiff::equilibrium(&model, operation, &of.stiff),
    };
    match found {
        Ok(found) => {
            let solved = found.profile(&model, operation);
            let findings = of_stiff(&model, operation, &solved);
            let answer = answer(of, level, &model, operation, &(&solved).into(), findings);
            (Ok(answer), Some(found))
        }
        Err(error) => (Err(error.into()), None),
    }
}
