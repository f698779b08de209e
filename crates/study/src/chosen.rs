//! Whose results a figure or a number shows.

use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_case::rules::{KindRule, ModelRule};
use wholestring_config::{
    diagnostic::Diagnostic,
    names::{nearest, short},
    reader::Reader,
    rule::{List, Spanned, Text},
    source::Span,
    table::Field,
};

use crate::{selection::Selection, sweep::Sweep};

pub(crate) const NAMES: List<Text> =
    List { item: Text, or_one: true, noun: "names of sweeps", most: 100 };

pub(crate) const MODELS: List<ModelRule> =
    List { item: ModelRule, or_one: true, noun: "models", most: 10 };

pub(crate) const OPERATIONS: List<KindRule> =
    List { item: KindRule, or_one: true, noun: "operations", most: 7 };

/// Whose results a figure or a number shows.
#[derive(Debug, Clone, PartialEq)]
pub struct Chosen {
    /// Sweeps, as indices into [`Study::sweeps`](crate::Study::sweeps).
    pub sweeps: Vec<usize>,
    /// Models; all where it is empty.
    pub models: Vec<ModelKind>,
    /// Operations; all where it is empty.
    pub operations: Vec<OperationKind>,
    /// Cases.
    pub only: Selection,
}

/// The keys that choose cases, as a figure, a table and a row have them.
pub(crate) struct Choosing<'a> {
    pub(crate) sweeps: &'a Field<Vec<Spanned<String>>>,
    pub(crate) models: &'a Field<Vec<Spanned<ModelKind>>>,
    pub(crate) operations: &'a Field<Vec<Spanned<OperationKind>>>,
    pub(crate) only: &'a Field<Selection>,
}

impl Choosing<'_> {
    /// What is chosen; all of `outer` where a key is not given.
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

/// Warns of keys that say nothing here.
pub(crate) fn unheeded(
    fields: impl IntoIterator<Item = (&'static str, Option<Span>)>,
    why: &str,
    reader: &mut Reader,
) {
    for (name, place) in fields {
        if let Some(place) = place {
            let message = format!("`{name}` has no effect here");
            reader.report(Diagnostic::warning(message).at(place, why));
        }
    }
}
