//! A case in which everything has been checked.

pub(crate) mod build;
mod identity;
pub(crate) mod parts;
mod stages;
pub(crate) mod table;
pub(crate) mod template;

use wholestring::{
    dynamics::{BitLaw, DynamicsSettings},
    model::Model,
    operation::Operation,
    outcome::ModelKind,
    rock::DrillingSpec,
    statics::soft::SoftSettings,
    string::StringSpec,
};
use wholestring_config::diagnostic::Report;
use wholestring_judge::Judge;
use wholestring_plan::{Broomstick, PlanError, Setup};
use wholestring_units::UnitSet;

use crate::{
    bit_test::BitTest,
    dynamics::records::Records,
    modes::Modes,
    plan::{self, Plan},
};

/// A case in which everything has been checked.
#[derive(Debug, Clone)]
pub struct Case {
    /// Name of the case.
    pub name: String,
    /// Units of displayed results.
    pub units: UnitSet,
    /// The models to solve, in the order of the case.
    pub models: Vec<ModelKind>,
    /// Well, string, mud and rig.
    pub model: Model,
    /// The string before it was cut to the depth of the bit.
    pub string: StringSpec,
    /// The operations to solve, in the order of the case.
    pub operations: Vec<Operation>,
    /// Test of bit and rock: of a case with `[bit_test]`, and of one whose operation drills solid
    /// rock.
    pub bit_test: Option<BitTest>,
    /// Settings of natural frequencies and their excitation.
    pub modes: Modes,
    /// Settings of a plan.
    pub plan: Plan,
    /// Further inputs of the soft string.
    pub soft: SoftSettings,
    /// Further inputs of a dynamic run.
    pub dynamics: DynamicsSettings,
    /// Whether the top hangs on a constant lift that is found before each dynamic run, such that
    /// the mean weight on bit equals the operation's: [`wholestring::dynamics::tune_hook_load`].
    pub tunes_hook_load: bool,
    /// Wall-clock time between checkpoints of a dynamic run, s.
    pub checkpoint_interval_s: f64,
    /// Further outputs of a dynamic run, in addition to its tables.
    pub records: Records,
    /// Interpretation of the survey file, in sentences; empty where the stations are in the case.
    pub survey_notes: Vec<String>,
    /// Interpretation of the casing programme, in sentences.
    pub hole_notes: Vec<String>,
    /// Results of fits to readings of the mud, in sentences.
    pub mud_notes: Vec<String>,
    /// Warnings: input that can be computed but is probably a mistake.
    pub warnings: Report,
    /// The case with all defaults filled in: SI numbers, units in the names of the keys.
    pub settings: serde_json::Value,
}

impl Case {
    /// Returns the string of its plan at every depth with every friction.
    ///
    /// # Errors
    /// A friction factor or a casing that is out of its range; the reader of a case excludes both.
    pub fn broomstick(&self) -> Result<Broomstick, PlanError> {
        let broomstick_at = self.broomstick_at(self.plan.bit_depths_m.clone())?;
        Ok(broomstick_at.with_campaign(&self.plan.campaign)?)
    }

    /// Like [`broomstick`](Self::broomstick) at other depths, m, without the campaign of wear and
    /// fatigue.
    ///
    /// # Errors
    /// A friction factor that is out of its range; the reader of a case excludes it.
    pub fn broomstick_at(&self, bit_depths_m: Vec<f64>) -> Result<Broomstick, PlanError> {
        let Plan { frictions, operations, models, .. } = self.plan.clone();
        let broomstick =
            Broomstick::new(&self.setup(), &frictions, operations, bit_depths_m, models)?;
        Ok(broomstick
            .with_settings(self.soft, self.dynamics.stiff_string())
            .with_judge(self.judge(self.units)))
    }

    /// Returns the judge of the case's results, with its limits, in these units.
    pub fn judge(&self, units: UnitSet) -> Judge {
        let soft_has_helix_friction = self.soft.helix_side_force;
        Judge { soft_has_helix_friction, ..Judge::new(self.plan.limits, units) }
    }

    /// Whether the forces of a model include the friction of a helix.
    pub fn has_helix_friction(&self, model: ModelKind) -> bool {
        model.method().has_helix_friction || model == ModelKind::Soft && self.soft.helix_side_force
    }

    /// Returns the parts of the model, from which it can be rebuilt at other depths and frictions.
    pub fn setup(&self) -> Setup {
        plan::setup(&self.model, &self.string)
    }

    /// Returns bit and solid rock of a run or a bit test; `None` where neither requires them.
    pub fn drilling(&self) -> Option<&DrillingSpec> {
        match &self.dynamics.bit.law {
            BitLaw::Rock(law) => Some(&law.drilling),
            _ => self.bit_test.as_ref().map(|test| &test.drilling),
        }
    }
}
