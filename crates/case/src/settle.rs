//! How long a dynamic run settles before its window.

use serde_json::{Value as Json, json};
use wholestring_config::prelude::*;

/// What stands for as long as it takes.
pub(crate) const AUTO: &str = "auto";

/// The time before the window.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Settle {
    /// Until the string is steady.
    Auto,
    /// A given one, s.
    Seconds(f64),
}

/// A time, or "auto".
pub(crate) struct SettleRule;

impl SettleRule {
    fn quantity() -> Quantity {
        Quantity::si(Dimension::Time, Range::from_to(0.0, 86_400.0), "20 s")
    }
}

impl Rule for SettleRule {
    type Value = Settle;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<Settle> {
        if let Value::Text { text, .. } = &node.value {
            if text == AUTO {
                return Some(Settle::Auto);
            }
            if nearest(text, [AUTO]).is_some() {
                return Diagnostic::error(format!("`{}` is not a time", short(text)))
                    .at(node.place, "expected a time or \"auto\"")
                    .help("did you mean \"auto\"?")
                    .refuse(reader);
            }
        }
        Self::quantity().read(node, reader).map(Settle::Seconds)
    }

    fn schema(&self) -> Json {
        let mut schema = Self::quantity().schema();
        if let Some(either) = schema["anyOf"].as_array_mut() {
            either.push(json!({
                "const": AUTO,
                "description": "Until the string is steady."
            }));
        }
        schema
    }

    fn example(&self) -> Option<String> {
        Self::quantity().example()
    }

    fn written(&self, default: &Json) -> String {
        default.to_string()
    }

    fn json(&self, value: &Settle) -> Json {
        match value {
            Settle::Auto => json!(AUTO),
            Settle::Seconds(settle_s) => json!(settle_s),
        }
    }
}
