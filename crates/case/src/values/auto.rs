//! A quantity, or "auto" for a value that the program chooses.

use serde_json::{Value as Json, json};
use wholestring_config::prelude::*;

/// The word for a value that the program chooses.
pub(crate) const AUTO: &str = "auto";

/// A number, or the program's own choice.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum AutoOr {
    /// The program chooses.
    Auto,
    /// A given one, SI.
    Given(f64),
}

impl AutoOr {
    /// Returns the number, if one is given.
    pub(crate) fn given(self) -> Option<f64> {
        match self {
            Self::Auto => None,
            Self::Given(number) => Some(number),
        }
    }
}

/// A quantity, or "auto".
pub(crate) struct AutoOrQuantity {
    /// The quantity that may be given.
    pub(crate) quantity: Quantity,
    /// Name of the quantity, with its article.
    pub(crate) noun: &'static str,
    /// Meaning of "auto", a sentence.
    pub(crate) auto: &'static str,
}

impl Rule for AutoOrQuantity {
    type Value = AutoOr;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<AutoOr> {
        if let Value::Text { text, .. } = &node.value {
            if text == AUTO {
                return Some(AutoOr::Auto);
            }
            if nearest(text, [AUTO]).is_some() {
                return Diagnostic::error(format!("`{}` is not {}", short(text), self.noun))
                    .at(node.place, format!("expected {} or \"auto\"", self.noun))
                    .help("did you mean \"auto\"?")
                    .refuse(reader);
            }
        }
        self.quantity.read(node, reader).map(AutoOr::Given)
    }

    fn schema(&self) -> Json {
        let mut schema = self.quantity.schema();
        if let Some(either) = schema["anyOf"].as_array_mut() {
            either.push(json!({
                "const": AUTO,
                "description": self.auto
            }));
        }
        schema
    }

    fn example(&self) -> Option<String> {
        self.quantity.example()
    }

    fn written(&self, default: &Json) -> String {
        default.to_string()
    }

    fn json(&self, value: &AutoOr) -> Json {
        match value {
            AutoOr::Auto => json!(AUTO),
            AutoOr::Given(number) => json!(number),
        }
    }
}
