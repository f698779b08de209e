//! Models by name.

use wholestring::outcome::ModelKind;
use wholestring_config::{Json, prelude::*};

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
