//! Requests for the results of a text.

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
    /// Values by key, as in `--set KEY=VALUE`; `friction_multiplier` scales every section's own
    /// friction and that of the plan, `friction` applies to all sections alike.
    #[serde(default)]
    set: BTreeMap<String, String>,
}

/// The same, with models.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct AskedOfModels {
    /// The text.
    text: String,
    /// Values by key, as in `--set KEY=VALUE`.
    #[serde(default)]
    set: BTreeMap<String, String>,
    /// The models: `soft`, `stiff`. Both by default.
    #[serde(default)]
    models: Vec<String>,
    /// Units of the sentences: `si`, `metric`, `field`. By default those of the case.
    #[serde(default)]
    units: Option<String>,
}

/// The same, with an operation.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub struct AskedOfOperation {
    /// The text.
    text: String,
    /// Values by key, as in `--set KEY=VALUE`.
    #[serde(default)]
    set: BTreeMap<String, String>,
    /// The operation: `drill`, ...; by default the first that drills, or else the first.
    #[serde(default)]
    operation: Option<String>,
}

impl Asked {
    /// The case of the text, in a file of this name next to these files.
    fn case(&self, name: &str, files: &dyn Files) -> Result<Case, Refusal> {
        let set = trial::overrides(&self.text, &self.set)?;
        Ok(parse(name, self.text.as_bytes(), files, &set)?)
    }

    /// Hook load and torque against bit depth, with low, expected and high friction, by the soft
    /// string.
    ///
    /// # Errors
    /// An invalid case, and a cancellation.
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
    /// Solves the text by soft and stiff string, in a file of this name next to these files.
    ///
    /// # Errors
    /// An invalid case, an unknown model, and a cancellation.
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
        let request = Asked { text, set };
        let mut case = request.case(name, files)?;
        let set_points = SetPoints::of(&case, &request.text);
        case.units = units.unwrap_or(case.units);
        Ok(answer::answer(case, models, set_points, cancellation)?)
    }
}

impl AskedOfOperation {
    /// Static analysis of the bottom-hole assembly: its shape in the hole and its loads on the bit.
    ///
    /// # Errors
    /// An invalid case, an operation that it lacks, and a cancellation.
    pub fn assembly(
        self,
        name: &str,
        files: &dyn Files,
        cancellation: &CancellationToken,
    ) -> Result<AssemblyView, Refusal> {
        let Self { text, set, operation: word } = self;
        let kind = word.as_deref().map(operation).transpose()?;
        let case = Asked { text, set }.case(name, files)?;
        Ok(assembly::assembly(&case, kind, cancellation)?)
    }
}

fn models(names: &[String]) -> Result<Vec<ModelKind>, Refusal> {
    let statics = || ModelKind::ALL.iter().copied().filter(|model| !model.method().in_time);
    if names.is_empty() {
        return Ok(statics().collect());
    }
    let named = |name: &String| {
        statics().find(|model| model.name() == name).ok_or_else(|| {
            let names: Vec<&str> = statics().map(ModelKind::name).collect();
            let names = names.join(", ");
            Refusal::bad_input(format!("no model `{name}` answers at once: {names} do"))
        })
    };
    names.iter().map(named).collect()
}

fn operation(name: &str) -> Result<OperationKind, Refusal> {
    let found = OperationKind::ALL.iter().copied().find(|kind| kind.name() == name);
    found.ok_or_else(|| {
        let names: Vec<&str> = OperationKind::ALL.iter().map(|kind| kind.name()).collect();
        Refusal::bad_input(format!("no operation is called `{name}`: {} are", names.join(", ")))
    })
}
