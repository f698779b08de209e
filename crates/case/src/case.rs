//! A case in which everything has been checked.

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

use crate::{bit_test::BitTest, modes::Modes, plan, plan::Plan, records::Records};

/// A case in which everything has been checked.
#[derive(Debug, Clone)]
pub struct Case {
    /// What it is called.
    pub name: String,
    /// Units that people are shown.
    pub units: UnitSet,
    /// The models to solve, in the order of the case.
    pub models: Vec<ModelKind>,
    /// Well, string, mud and rig.
    pub model: Model,
    /// The string before it was cut to the depth of the bit.
    pub string: StringSpec,
    /// The operations to solve, in the order of the case.
    pub operations: Vec<Operation>,
    /// The bit alone on its rock: of a case with `[bit_test]`, and of one whose operation drills
    /// solid rock.
    pub bit_test: Option<BitTest>,
    /// Which natural frequencies are looked for, and what meets them.
    pub modes: Modes,
    /// What a plan computes.
    pub plan: Plan,
    /// What the soft string needs beside these.
    pub soft: SoftSettings,
    /// What a dynamic run needs beside these.
    pub dynamics: DynamicsSettings,
    /// Whether the top hangs on a constant lift that is found before each dynamic run, such that
    /// the mean weight on bit is the operation's: [`wholestring::dynamics::tune_hook_load`].
    pub tunes_hook_load: bool,
    /// Wall-clock time between checkpoints of a dynamic run, s.
    pub checkpoint_interval_s: f64,
    /// What a dynamic run keeps beside its tables.
    pub records: Records,
    /// How the survey file was understood, in sentences; empty where the stations stand in the
    /// case.
    pub survey_notes: Vec<String>,
    /// What was fitted to readings of the mud, in sentences.
    pub mud_notes: Vec<String>,
    /// What is probably not meant, but can be computed.
    pub warnings: Report,
    /// The case with all defaults filled in: SI numbers, units in the names of the keys.
    pub settings: serde_json::Value,
}

impl Case {
    /// The string at every depth, with every friction, of its plan.
    ///
    /// # Errors
    /// A friction factor or a casing that is out of its range, which the reader of a case has seen to.
    pub fn broomstick(&self) -> Result<Broomstick, PlanError> {
        let of = self.broomstick_at(self.plan.bit_depths_m.clone())?;
        Ok(of.with_campaign(&self.plan.campaign)?)
    }

    /// The same at other depths, m, and without the campaign that wears and tires it.
    ///
    /// # Errors
    /// A friction factor that is out of its range, which the reader of a case has seen to.
    pub fn broomstick_at(&self, bit_depths_m: Vec<f64>) -> Result<Broomstick, PlanError> {
        let Plan { frictions, operations, models, .. } = self.plan.clone();
        let of = Broomstick::new(&self.setup(), &frictions, operations, bit_depths_m, models)?;
        Ok(of
            .with_settings(self.soft, self.dynamics.stiff_string())
            .with_judge(self.judge(self.units)))
    }

    /// The judge of the case's answers, with its limits, in these units.
    pub fn judge(&self, units: UnitSet) -> Judge {
        let soft_has_helix_friction = self.soft.helix_side_force;
        Judge { soft_has_helix_friction, ..Judge::new(self.plan.limits, units) }
    }

    /// Whether the forces that a model answers with hold the friction of a helix.
    pub fn has_helix_friction(&self, model: ModelKind) -> bool {
        model.method().has_helix_friction || model == ModelKind::Soft && self.soft.helix_side_force
    }

    /// What the model is made of, to be made again at other depths and frictions.
    pub fn setup(&self) -> Setup {
        plan::setup(&self.model, &self.string)
    }

    /// Bit and solid rock, in a run or in a bit test; none where nothing requires them.
    pub fn drilling(&self) -> Option<&DrillingSpec> {
        match &self.dynamics.bit.law {
            BitLaw::Rock(law) => Some(&law.drilling),
            _ => self.bit_test.as_ref().map(|test| &test.drilling),
        }
    }
}
