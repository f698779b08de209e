//! What is asked of a text, and its answer.

use std::collections::BTreeMap;

use serde::Deserialize;
use utoipa::ToSchema;
use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_case::{Case, Files, parse};
use wholestring_runner::CancellationToken;
use wholestring_units::UnitSet;

use super::{
    answer::{self, Answer},
    assembly::{self, AssemblyView},
    broomstick::{self, Broomstick},
    set_points::SetPoints,
};
use crate::{refusal::Refusal, trial};

/// A text, with some values of it replaced.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct Asked {
    /// The text.
    text: String,
    /// Values by keys, as `--set KEY=VALUE` has them; `friction_multiplier` times every section's
    /// own friction and what the plan gives of it, `friction` for all sections alike.
    #[serde(default)]
    set: BTreeMap<String, String>,
}

/// The same, and by which models.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct AskedOfModels {
    /// The text.
    text: String,
    /// Values by keys, as `--set KEY=VALUE` has them.
    #[serde(default)]
    set: BTreeMap<String, String>,
    /// The models: `soft`, `stiff`. Both by default.
    #[serde(default)]
    models: Vec<String>,
    /// Units of the sentences: `si`, `metric`, `field`. By default those of the case.
    #[serde(default)]
    units: Option<String>,
}

/// The same, and in which operation.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct AskedOfOperation {
    /// The text.
    text: String,
    /// Values by keys, as `--set KEY=VALUE` has them.
    #[serde(default)]
    set: BTreeMap<String, String>,
    /// The operation: `drill`, ...; the first that drills, or the first, by default.
    #[serde(default)]
    operation: Option<String>,
}

impl Asked {
    /// The case that it makes, in a file of this name beside these files.
    fn case(&self, name: &str, files: &dyn Files) -> Result<Case, Refusal> {
        let set = trial::overrides(&self.text, &self.set)?;
        Ok(parse(name, self.text.as_bytes(), files, &set)?)
    }

    /// Hook load and torque against the depth of the bit, with low, expected and high friction, by
    /// the soft string.
    ///
    /// # Errors
    /// A case that is invalid, and a cancellation.
    pub fn broomstick(
        &self,
        name: &str,
        files: &dyn Files,
        cancellation: &CancellationToken,
    ) -> Result<Broomstick, Refusal> {
        Ok(broomstick::broomstick(&self.case(name, files)?, cancellation)?)
    }
}

impl AskedOfModels {
    /// What the text comes to by soft and stiff string, in a file of this name beside these files.
    ///
    /// # Errors
    /// A case that is invalid, a model that there is not, and a cancellation.
    pub fn answer(
        self,
        name: &str,
        files: &dyn Files,
        cancellation: &CancellationToken,
    ) -> Result<Answer, Refusal> {
        let Self { text, set, models: names, units } = self;
        let models = models(&names)?;
        let units = units.map(|units| units.parse::<UnitSet>());
        let units = units.transpose().map_err(|error| Refusal::bad_input(error.to_string()))?;
        let asked = Asked { text, set };
        let mut case = asked.case(name, files)?;
        let set_points = SetPoints::of(&case, &asked.text);
        case.units = units.unwrap_or(case.units);
        Ok(answer::answer(case, models, set_points, cancellation)?)
    }
}

impl AskedOfOperation {
    /// Static analysis of the bottom-hole assembly: how it lies in its hole, what it does to the bit.
    ///
    /// # Errors
    /// A case that is invalid, an operation that it has not, and a cancellation.
    pub fn assembly(
        self,
        name: &str,
        files: &dyn Files,
        cancellation: &CancellationToken,
    ) -> Result<AssemblyView, Refusal> {
        let Self { text, set, operation: wanted } = self;
        let kind = wanted.as_deref().map(operation).transpose()?;
        let case = Asked { text, set }.case(name, files)?;
        Ok(assembly::assembly(&case, kind, cancellation)?)
    }
}

fn models(names: &[String]) -> Result<Vec<ModelKind>, Refusal> {
    let statics = || ModelKind::ALL.iter().copied().filter(|of| !of.method().in_time);
    if names.is_empty() {
        return Ok(statics().collect());
    }
    let named = |name: &String| {
        statics().find(|of| of.name() == name).ok_or_else(|| {
            let names: Vec<&str> = statics().map(ModelKind::name).collect();
            let names = names.join(", ");
            Refusal::bad_input(format!("no model `{name}` answers at once: {names} do"))
        })
    };
    names.iter().map(named).collect()
}

fn operation(name: &str) -> Result<OperationKind, Refusal> {
    let found = OperationKind::ALL.iter().copied().find(|of| of.name() == name);
    found.ok_or_else(|| {
        let names: Vec<&str> = OperationKind::ALL.iter().map(|of| of.name()).collect();
        Refusal::bad_input(format!("no operation is called `{name}`: {} are", names.join(", ")))
    })
}
