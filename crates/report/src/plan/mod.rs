//! Contents of the page of a plan, and its pictures.

mod along;
mod broomstick;
mod buckling;
mod campaign;
mod curves;
mod levels;
mod limits;
mod measured;
mod mud;
mod overlay;
mod page;
mod peaks;
mod roadmap;
mod tables;

pub use levels::{STROKES as FRICTION_STROKES, plan_friction_label};
pub use limits::{surface_limit_is_near, surface_limit_title};
pub use page::{PLAN_PICTURES, plan_html, plan_plots};

use wholestring::{operation::OperationKind, well::FrictionLevel};
use wholestring_results::{
    PlanPeak, PlanPeakSample, PlanStation, PlanSummary, PlanSurfaceLimit, UncertainTables,
};
use wholestring_units::UnitSet;

use self::levels::{History, Level};
use crate::{Cell, Fact, PageHead, uncertain::Uncertain};

/// A plan with the head of its page. Numbers are SI; a value without an answer is not a number.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// Head of the page, under the name of the case.
    pub head: PageHead,
    /// The answer.
    pub summary: PlanSummary,
    /// The string along the hole, operation after operation; empty where the folder has none.
    along: Vec<PlanStation>,
    /// Levels of friction, from the least to the most.
    levels: [Level; 3],
    /// Time histories of the peaks of the summary, in their order.
    histories: Vec<History>,
}

impl Plan {
    /// The page of a plan, of the string in `plan_along.parquet` and of its events against time in
    /// `plan_peaks_time.parquet`; it opens in these units, by default in those of the case.
    pub fn new(
        summary: PlanSummary,
        along: Vec<PlanStation>,
        samples: &[PlanPeakSample],
        units: Option<UnitSet>,
    ) -> Self {
        let title = format!("{}: plan", summary.case);
        let head = PageHead::new(title, units, Some(&summary.settings), facts(&summary));
        let levels = FrictionLevel::ALL.map(|level| Level::new(&summary, level));
        let histories = levels::histories(&summary.peaks, samples);
        Self { head, summary, along, levels, histories }
    }

    /// Warning of an interrupted plan.
    fn message(&self) -> Option<String> {
        let PlanSummary { missing, points, .. } = &self.summary;
        (*missing > 0).then(|| {
            let all = missing + points.len();
            format!("The plan was interrupted: {missing} of {all} points are missing.")
        })
    }

    /// Effect of uncertain numbers; `None` where all are exact.
    fn samples(&self) -> Option<Uncertain<'_>> {
        Uncertain::new(self.summary.uncertain.as_ref(), &UncertainTables::PLAN)
    }

    /// The level of a friction.
    fn level(&self, friction: FrictionLevel) -> &Level {
        &self.levels[friction as usize]
    }

    /// Operations in their order.
    fn operations(&self) -> impl Iterator<Item = OperationKind> {
        self.summary.operations.iter().copied()
    }

    /// Every event with its time history.
    fn events(&self) -> impl Iterator<Item = (&PlanPeak, &History)> {
        self.summary.peaks.iter().zip(&self.histories)
    }

    /// The surface limits of a force or a torque; none for other dimensions.
    fn surface<'a>(&'a self, dimension: &'a str) -> impl Iterator<Item = &'a PlanSurfaceLimit> {
        let limited = |limit: &PlanSurfaceLimit| if limit.is_torque { "torque" } else { "force" };
        self.summary.surface_limits.iter().filter(move |limit| limited(limit) == dimension)
    }

    /// Texts of the summary in these units.
    fn texts<'a>(
        &self,
        texts: &'a [String],
        units: UnitSet,
    ) -> impl Iterator<Item = String> + use<'_, 'a> {
        texts.iter().map(move |text| self.summary.texts.in_units(text, units))
    }
}

// Key facts of a plan.

/// Facts of the head of the page.
fn facts(summary: &PlanSummary) -> Vec<Fact> {
    let quantity = |number: Option<f64>, dimension: &str| {
        number.map_or(Cell::Nothing, |value| Cell::quantity(value, dimension))
    };
    let names: Vec<&str> = summary.operations.iter().map(|operation| operation.words()).collect();
    let models: Vec<String> =
        summary.models.iter().map(|model| format!("{model} string")).collect();
    let frictions = FrictionLevel::ALL.map(|level| plan_friction_label(summary, level));
    let depths = &summary.bit_depths_m;
    let ends = [depths.first(), depths.last()].map(|depth| depth.copied().unwrap_or(f64::NAN));
    vec![
        Fact::new("Operations", Cell::Text(names.join(", "))),
        Fact::new("Solved by", Cell::Text(models.join(", "))),
        Fact::new("Friction", Cell::Text(frictions.join(", "))),
        Fact::new("Bit depths", Cell::Text(depths.len().to_string())),
        Fact::new("From", Cell::quantity(ends[0], "length")),
        Fact::new("To", Cell::quantity(ends[1], "length")),
        Fact::new("Mud density", quantity(summary.mud_density_kg_per_m3(), "density")),
        Fact::new("Weight of the block", quantity(summary.block_weight_N(), "force")),
    ]
}

#[cfg(test)]
mod tests;
