//! A quantity of a result: its name, unit and meaning, the methods that provide it, and the cases
//! in which it has no value.

use super::{method::ModelKind, quantity_kind::QuantityKind};

/// Name, unit and meaning of a quantity in results, and the methods that provide it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Quantity {
    /// Name in results, with the unit in it.
    pub name: &'static str,
    /// Unit symbol; empty where there is none.
    pub unit: &'static str,
    /// Meaning, in one sentence.
    pub meaning: &'static str,
    /// Common label, where it differs from the name.
    pub label: Option<&'static str>,
    /// Its kind; a ratio for words.
    pub kind: QuantityKind,
    /// Whether it is words rather than numbers.
    pub text: bool,
    /// The methods that provide it; the others leave it out.
    pub known_by: &'static [ModelKind],
    /// Cases in which a method that provides it has no value (empty for a text); none where there
    /// always is one.
    pub null_where: Option<&'static str>,
}

impl Quantity {
    /// Words that every method provides.
    pub const fn text(name: &'static str, meaning: &'static str) -> Self {
        Self { text: true, ..Self::number(name, QuantityKind::Ratio, meaning) }
    }

    /// Numbers that every method provides.
    ///
    /// # Panics
    /// Where the name does not end in the unit: in a constant this is a compile error.
    pub const fn number(name: &'static str, kind: QuantityKind, meaning: &'static str) -> Self {
        assert!(kind.stem(name).is_some(), "the name of a quantity ends in its unit");
        Self {
            name,
            unit: kind.unit(),
            meaning,
            label: None,
            kind,
            text: false,
            known_by: ModelKind::ALL,
            null_where: None,
        }
    }

    /// The same, provided by these methods alone.
    pub const fn of(self, known_by: &'static [ModelKind]) -> Self {
        Self { known_by, ..self }
    }

    /// The same with this label.
    pub const fn labelled(self, label: &'static str) -> Self {
        Self { label: Some(label), ..self }
    }

    /// The same, without a value in these cases.
    pub const fn null_where(self, place: &'static str) -> Self {
        Self { null_where: Some(place), ..self }
    }

    /// Whether a method provides values of it.
    pub fn is_known_by(&self, model: ModelKind) -> bool {
        self.known_by.contains(&model)
    }

    /// Its name without the unit: `hook_load`.
    pub const fn stem(&self) -> &'static str {
        match self.kind.stem(self.name) {
            Some(stem) => stem,
            None => self.name,
        }
    }

    /// Label for display: `Hook load`.
    pub fn label(&self) -> String {
        self.label.map_or_else(
            || {
                let words = self.words();
                let mut letters = words.chars();
                let first = letters.next().into_iter().flat_map(char::to_uppercase);
                first.chain(letters).collect()
            },
            String::from,
        )
    }

    /// Its name in words, without the unit: `hook load`.
    pub fn words(&self) -> String {
        match self.stem() {
            "md" => "measured depth".into(),
            "tvd" => "true vertical depth".into(),
            other => other.replace('_', " "),
        }
    }
}

/// Whether two names are the same, while compiling.
pub(super) const fn is_same(a: &str, b: &str) -> bool {
    let (a, b) = (a.as_bytes(), b.as_bytes());
    let mut same = a.len() == b.len();
    let mut place = 0;
    while same && place < a.len() {
        same = a[place] == b[place];
        place += 1;
    }
    same
}
