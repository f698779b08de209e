//! Values that several tables share.

pub(crate) mod auto;
pub(crate) mod dimension;

use wholestring::outcome::ModelKind;
use wholestring_config::{Json, prelude::*};
use wholestring_plan::Statics;
use wholestring_units::UnitSet;

// Names of models and unit sets, and of the engine's enumerations.

/// Returns all values of an enumeration by their names, for a
/// [`Choice`](wholestring_config::rule::Choice).
macro_rules! words {
    ($enumeration:ident) => {
        &{
            let mut words = [("", $enumeration::ALL[0]); $enumeration::ALL.len()];
            let mut i = 0;
            while i < words.len() {
                words[i] = ($enumeration::ALL[i].name(), $enumeration::ALL[i]);
                i += 1;
            }
            words
        }
    };
}

pub(crate) use words;

/// A set of units by name.
pub const UNIT_SETS: Choice<UnitSet> = Choice {
    noun: "a unit set",
    words: &[("si", UnitSet::Si), ("metric", UnitSet::Metric), ("field", UnitSet::Field)],
};

/// The models that can solve a case.
pub(crate) const MODELS: &[(&str, ModelKind)] = &{
    let mut models = [("", ModelKind::Soft); ModelKind::ALL.len()];
    let mut place = 0;
    while place < models.len() {
        let model = ModelKind::ALL[place];
        models[place] = (model.name(), model);
        place += 1;
    }
    models
};

/// A model by name.
#[derive(Debug, Clone, Copy)]
pub struct ModelRule;

impl ModelRule {
    fn choice() -> Choice<ModelKind> {
        Choice { noun: "a model", words: MODELS }
    }
}

impl Rule for ModelRule {
    type Value = ModelKind;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<ModelKind> {
        Self::choice().read(node, reader)
    }

    fn schema(&self) -> Json {
        Self::choice().schema()
    }

    fn json(&self, value: &ModelKind) -> Json {
        Self::choice().json(value)
    }
}

/// The models of a plan.
pub(crate) const STATICS: &[(&str, Statics)] = words!(Statics);
