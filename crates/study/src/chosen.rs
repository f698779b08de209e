//! Selection of the results of a figure or a number.

use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_case::rules::{KindRule, ModelRule};
use wholestring_config::prelude::*;

use crate::{
    selection::{Selection, SelectionRule},
    sweep::Sweep,
};

/// Selection of the results of a figure or a number.
#[derive(Debug, Clone, PartialEq)]
pub struct Chosen {
    /// Sweeps, as indices into [`Study::sweeps`](crate::Study::sweeps).
    pub sweeps: Vec<usize>,
    /// Models; empty for all.
    pub models: Vec<ModelKind>,
    /// Operations; empty for all.
    pub operations: Vec<OperationKind>,
    /// Cases.
    pub only: Selection,
}

keys! {
    /// The keys that select cases, of a figure, a table and a row.
    ChoosingKeys {
        /// Sweeps whose cases it shows, in a table one column each. Default: all, in a row those of
        /// the table.
        sweeps: Vec<Spanned<String>> = optional(List::or_one(Text, "names of sweeps", 100));
        /// Models that it shows. Default: all solved ones, in a row those of the table.
        models: Vec<Spanned<ModelKind>> = optional(List::or_one(ModelRule, "models", 10));
        /// Operations that it shows. Default: all solved ones, in a row those of the table.
        operations: Vec<Spanned<OperationKind>> =
            optional(List::or_one(KindRule, "operations", 7));
        /// Cases that it shows, by values of varied keys: single, listed or in a range such as
        /// "..1200 m". Default: all. A row shows a number of one case: omitted keys are those of
        /// the table, and all varied keys need a value.
        only: Selection = optional(SelectionRule);
    }
}

impl ChoosingKeys {
    /// The selection; that of `outer` for missing keys.
    pub(crate) fn within(
        &self,
        outer: &Chosen,
        sweeps: &[Sweep],
        reader: &mut Reader,
    ) -> Option<Chosen> {
        let named = match self.sweeps.optional()? {
            None => Some(outer.sweeps.clone()),
            Some(names) => names.value.iter().map(|at| sweep_named(at, sweeps, reader)).collect(),
        };
        let models = self.models.optional()?;
        let operations = self.operations.optional()?;
        let mut only = outer.only.clone();
        if let Some(more) = self.only.optional()? {
            only = only.narrowed(&more.value);
        }
        let chosen = Chosen {
            sweeps: named?,
            models: models.map_or_else(
                || outer.models.clone(),
                |at| at.value.iter().map(|at| at.value).collect(),
            ),
            operations: operations.map_or_else(
                || outer.operations.clone(),
                |at| at.value.iter().map(|at| at.value).collect(),
            ),
            only,
        };
        for sweep in &chosen.sweeps {
            chosen.only.check(&sweeps[*sweep].name, &sweeps[*sweep].vary, reader)?;
        }
        Some(chosen)
    }
}

impl Chosen {
    pub(crate) fn all(sweeps: &[Sweep]) -> Self {
        Self {
            sweeps: (0..sweeps.len()).collect(),
            models: Vec::new(),
            operations: Vec::new(),
            only: Selection::default(),
        }
    }
}

fn sweep_named(at: &Spanned<String>, sweeps: &[Sweep], reader: &mut Reader) -> Option<usize> {
    let found = sweeps.iter().position(|sweep| sweep.name == at.value);
    if found.is_none() {
        let names: Vec<&str> = sweeps.iter().map(|sweep| sweep.name.as_str()).collect();
        let mut diagnostic = Diagnostic::error(format!("there is no sweep `{}`", short(&at.value)))
            .at(at.place, "expected the name of a [[sweep]]");
        if let Some(near) = nearest(&at.value, names.iter().copied()) {
            diagnostic = diagnostic.help(format!("did you mean \"{near}\"?"));
        }
        reader.report(diagnostic.help(format!("sweeps of this study: {}", names.join(", "))));
    }
    found
}

/// Warns about keys without effect here.
pub(crate) fn unheeded(
    fields: impl IntoIterator<Item = (&'static str, Option<Span>)>,
    why: &str,
    reader: &mut Reader,
) {
    for (name, place) in fields {
        if let Some(place) = place {
            reader.report(Diagnostic::idle(name, place, why));
        }
    }
}
