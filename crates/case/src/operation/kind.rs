//! Operations by the names that drillers give them.

use serde_json::{Value as Json, json};
use wholestring::operation::OperationKind;
use wholestring_config::{names::all_near, prelude::*};

use crate::values::words;

/// All operations.
const KINDS: &[(&str, OperationKind)] = words!(OperationKind);

/// An operation by name.
const KIND: Choice<OperationKind> = Choice { noun: "an operation", words: KINDS };

/// Drillers' words.
const WORDS: &[(&str, OperationKind)] = {
    use OperationKind::{BackReam, Drill, Ream, RotateOffBottom, Slide, TripIn, TripOut};
    &[
        ("tripping out", TripOut),
        ("trip out of hole", TripOut),
        ("pick-up", TripOut),
        ("picking up", TripOut),
        ("pull out", TripOut),
        ("pulling out", TripOut),
        ("pull out of hole", TripOut),
        ("pulling out of hole", TripOut),
        ("hoisting", TripOut),
        ("tripping in", TripIn),
        ("trip in hole", TripIn),
        ("slack-off", TripIn),
        ("slacking off", TripIn),
        ("run in", TripIn),
        ("running in", TripIn),
        ("run in hole", TripIn),
        ("running in hole", TripIn),
        ("lowering", TripIn),
        ("rotating off bottom", RotateOffBottom),
        ("off bottom rotation", RotateOffBottom),
        ("rotation off bottom", RotateOffBottom),
        ("free rotation", RotateOffBottom),
        ("free rotating", RotateOffBottom),
        ("drilling", Drill),
        ("drill ahead", Drill),
        ("drilling ahead", Drill),
        ("rotary drilling", Drill),
        ("rotate on bottom", Drill),
        ("rotating on bottom", Drill),
        ("sliding", Slide),
        ("slide drilling", Slide),
        ("oriented drilling", Slide),
        ("reaming", Ream),
        ("ream in", Ream),
        ("reaming in", Ream),
        ("ream down", Ream),
        ("reaming down", Ream),
        ("back-reaming", BackReam),
        ("ream out", BackReam),
        ("reaming out", BackReam),
        ("ream up", BackReam),
        ("reaming up", BackReam),
    ]
};

/// Abbreviations, which are too short for spelling suggestions.
const ABBREVIATIONS: &[(&str, OperationKind)] = {
    use OperationKind::{TripIn, TripOut};
    &[
        ("POOH", TripOut),
        ("POH", TripOut),
        ("TOOH", TripOut),
        ("TOH", TripOut),
        ("PU", TripOut),
        ("RIH", TripIn),
        ("TIH", TripIn),
        ("SO", TripIn),
    ]
};

/// Separators that may be between the parts of a name and around it, in any number.
const SEPARATORS: [char; 3] = ['_', ' ', '-'];

/// Whether a text is a word, in any capitals, its parts separated otherwise or not at all.
fn is_spelt(text: &str, word: &str) -> bool {
    let mut rest = text.trim_start_matches(SEPARATORS);
    for part in word.split(SEPARATORS) {
        match rest.split_at_checked(part.len()) {
            Some((head, tail)) if head.eq_ignore_ascii_case(part) => {
                rest = tail.trim_start_matches(SEPARATORS);
            }
            _ => return false,
        }
    }
    rest.is_empty()
}

/// Returns the regular expression of the texts that [`is_spelt`] accepts for one of the words.
fn spellings(words: impl Iterator<Item = &'static str>) -> String {
    let any_capitals =
        |letter: char| format!("[{}{}]", letter.to_ascii_uppercase(), letter.to_ascii_lowercase());
    let spelling = |word: &str| {
        let parts = word.split(SEPARATORS);
        parts
            .map(|part| part.chars().map(any_capitals).collect())
            .collect::<Vec<String>>()
            .join("[_ -]*")
    };
    format!("^[_ -]*({})[_ -]*$", words.map(spelling).collect::<Vec<_>>().join("|"))
}

/// Returns the operation with this name, or with this driller's word for it, as a case has it.
pub fn operation_named(text: &str) -> Option<OperationKind> {
    let mut names = KindRule::names_and_abbreviations();
    names.find(|(word, _)| is_spelt(text, word)).map(|(_, kind)| kind)
}

/// An operation by its name, or by a driller's word for it.
#[derive(Debug, Clone, Copy)]
pub struct KindRule;

impl KindRule {
    fn names() -> impl Iterator<Item = (&'static str, OperationKind)> {
        KIND.words.iter().chain(WORDS).copied()
    }

    fn names_and_abbreviations() -> impl Iterator<Item = (&'static str, OperationKind)> {
        Self::names().chain(ABBREVIATIONS.iter().copied())
    }
}

impl Rule for KindRule {
    type Value = OperationKind;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<OperationKind> {
        let Value::Text { text, .. } = &node.value else {
            return KIND.read(node, reader);
        };
        if let Some(kind) = operation_named(text) {
            return Some(kind);
        }
        let words: Vec<&str> = KIND.words.iter().map(|(word, _)| *word).collect();
        let mut diagnostic = Diagnostic::error(format!("`{}` is not {}", short(text), KIND.noun))
            .at(node.place, format!("expected {}", any_of(&words)));
        // Several words may name one operation, and half a word several.
        let mut meant: Vec<&str> = Vec::new();
        for near in all_near(text, Self::names().map(|(word, _)| word)) {
            let kind = Self::names().find(|(word, _)| *word == near);
            if let Some((_, kind)) = kind
                && !meant.contains(&kind.name())
            {
                meant.push(kind.name());
            }
        }
        if !meant.is_empty() {
            diagnostic = diagnostic.help(format!("did you mean {}?", any_of(&meant)));
        }
        diagnostic.refuse(reader)
    }

    fn example(&self) -> Option<String> {
        KIND.example()
    }

    fn schema(&self) -> Json {
        let words = WORDS.iter().chain(ABBREVIATIONS).map(|(word, _)| *word);
        let words: Vec<&str> = words.collect();
        json!({ "anyOf": [
            KIND.schema(),
            { "type": "string", "enum": words, "description": "A driller's word for it." },
            {
                "type": "string",
                "description": "Either in any capitals, its parts separated otherwise or not at \
                all.",
                "pattern": spellings(Self::names_and_abbreviations().map(|(word, _)| word)),
            },
        ] })
    }

    fn json(&self, value: &OperationKind) -> Json {
        KIND.json(value)
    }
}
