//! The results of a task, for each friction.

use wholestring::{
    model::Model,
    operation::Operation,
    outcome::Solution,
    statics::{
        buckling::{Pushed, push_through, segments},
        soft::{self, SoftSettings},
        stiff::{self, Equilibrium, StiffError},
    },
};
use wholestring_judge::{Checks, NoAnswer};

use super::{
    Broomstick, BroomstickPoint, BroomstickTask,
    point::{PointAnswer, Statics},
};
use crate::FrictionLevel;

/// A result with its checks.
type Judged = (PointAnswer, Checks);

impl Broomstick {
    /// Returns the points of a task, one for each of [`FrictionLevel::ALL`]. A point without a
    /// result has the reason and its verdict.
    pub fn solve(&self, task: &BroomstickTask) -> Vec<BroomstickPoint> {
        self.solve_at(task, &FrictionLevel::ALL)
    }

    /// Returns the points of a task at these levels of friction only.
    pub fn solve_at(
        &self,
        task: &BroomstickTask,
        levels: &[FrictionLevel],
    ) -> Vec<BroomstickPoint> {
        let operation = &task.operation;
        match task.model {
            Statics::Soft => {
                let point = |level: &FrictionLevel| {
                    self.point(task, *level, self.by_soft(*level, operation))
                };
                levels.iter().map(point).collect()
            }
            Statics::Stiff => {
                // The equilibrium at another friction is close to that at the expected one.
                let expected = levels.iter().find(|level| **level == FrictionLevel::Expected);
                let Some(&first) = expected.or(levels.first()) else { return Vec::new() };
                let (judged, near) = self.by_stiff(first, operation, None);
                let locked = operation.slides_down() && is_locked_up(&judged);
                let mut judged = Some(judged);
                let point = |&level: &FrictionLevel| {
                    let own = judged.take_if(|_| level == first);
                    let by_more = || {
                        let locked = locked && self.rubs_more(level, first);
                        locked.then(|| self.locked_up_at(level, operation)).flatten().map(Err)
                    };
                    let solve = || self.by_stiff(level, operation, near.as_ref()).0;
                    self.point(task, level, own.or_else(by_more).unwrap_or_else(solve))
                };
                levels.iter().map(point).collect()
            }
        }
    }

    fn point(
        &self,
        task: &BroomstickTask,
        friction: FrictionLevel,
        judged: Result<Judged, NoAnswer>,
    ) -> BroomstickPoint {
        let (outcome, checks) = match judged {
            Ok((answer, checks)) => (Ok(answer), checks),
            Err(why) => {
                let checks = self.judge.unsolved(&why);
                (Err(why), checks)
            }
        };
        BroomstickPoint {
            model: task.model,
            friction,
            operation: task.operation.kind,
            bit_depth_m: task.operation.bit_depth_m,
            outcome,
            checks,
        }
    }

    fn by_soft(&self, level: FrictionLevel, operation: &Operation) -> Result<Judged, NoAnswer> {
        let model = self.setup(level).at(operation.bit_depth_m)?;
        let solved = soft::solve(&model, operation, &self.soft)?;
        let checks = self.judge.soft(&model, operation, &solved);
        Ok((self.answer(level, &model, operation, &(&solved).into()), checks))
    }

    /// Returns the result, and the equilibrium of the string, as a start of another search.
    fn by_stiff(
        &self,
        level: FrictionLevel,
        operation: &Operation,
        near: Option<&Equilibrium>,
    ) -> (Result<Judged, NoAnswer>, Option<Equilibrium>) {
        let model = match self.setup(level).at(operation.bit_depth_m) {
            Ok(model) => model,
            Err(error) => return (Err(error.into()), None),
        };
        let found: Result<Equilibrium, StiffError> = match near {
            Some(near) => stiff::equilibrium_beside(&model, operation, &self.stiff, near),
            None => stiff::equilibrium(&model, operation, &self.stiff),
        };
        match found {
            Ok(found) => {
                let solved = found.profile(&model, operation);
                let checks = self.judge.stiff(&model, operation, &solved);
                let answer = self.answer(level, &model, operation, &(&solved).into());
                (Ok((answer, checks)), Some(found))
            }
            Err(error) => (Err(error.into()), None),
        }
    }

    /// Whether the friction of every section at a level is at least that at another: a string that
    /// locks up under the latter locks up under the former.
    fn rubs_more(&self, level: FrictionLevel, other: FrictionLevel) -> bool {
        let sections = |level| self.setup(level).well.hole.sections();
        let mut pairs = sections(level).iter().zip(sections(other));
        pairs.all(|(own, other)| own.friction.kinetic >= other.friction.kinetic)
    }

    /// Returns where a string locks up by the wall force of its helix at this friction, without a
    /// search for its equilibrium; `None` where it goes down by that.
    fn locked_up_at(&self, level: FrictionLevel, operation: &Operation) -> Option<NoAnswer> {
        let model = self.setup(level).at(operation.bit_depth_m).ok()?;
        let settings = SoftSettings { helix_side_force: false, ..self.soft };
        let soft = soft::solve(&model, operation, &settings).ok()?;
        let stretches = segments(&model, operation, &soft.md_m);
        match push_through(&stretches, operation.weight_on_bit_now_N(), model.buckling) {
            Pushed::LocksUp(above_bit_m) => {
                let md_m = operation.bit_depth_m - above_bit_m;
                Some(NoAnswer::Stiff(StiffError::LocksUp { md_m }))
            }
            Pushed::Through(_) => None,
        }
    }

    fn answer(
        &self,
        level: FrictionLevel,
        model: &Model,
        operation: &Operation,
        solution: &Solution<'_>,
    ) -> PointAnswer {
        let campaign = self.campaign.as_ref().filter(|_| level == FrictionLevel::Expected);
        let share = campaign.and_then(|campaign| campaign.share(model, operation, solution));
        PointAnswer::new(solution.scalars, solution.profile, share)
    }
}

/// Whether a string has no result because it locks up.
fn is_locked_up(judged: &Result<Judged, NoAnswer>) -> bool {
    matches!(judged, Err(NoAnswer::Stiff(StiffError::LocksUp { .. } | StiffError::RunsAway { .. })))
}
