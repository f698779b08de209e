//! Numbers within an accepted range.

use serde_json::{Value as Json, json};
use wholestring_units::number_text;

/// The accepted numbers, in SI, and the usual ones among them.
#[derive(Debug, Clone, Copy)]
pub struct Range {
    pub(crate) min: f64,
    pub(crate) min_excluded: bool,
    pub(crate) max: f64,
    usual: Option<(f64, f64)>,
}

impl Range {
    /// Both ends included.
    pub const fn from_to(min: f64, max: f64) -> Self {
        Self { min, min_excluded: false, max, usual: None }
    }

    /// Greater than zero, up to `max`.
    pub const fn positive_to(max: f64) -> Self {
        Self { min: 0.0, min_excluded: true, max, usual: None }
    }

    /// The same, but a number outside of these causes a warning, because its unit is probably
    /// wrong. Zero does not, if it is accepted, because it switches something off.
    pub const fn usual(self, from: f64, to: f64) -> Self {
        Self { usual: Some((from, to)), ..self }
    }

    /// The usual numbers, if the key has them.
    pub fn usual_numbers(&self) -> Option<(f64, f64)> {
        self.usual
    }

    /// Whether a number is accepted.
    pub fn holds(&self, value: f64) -> bool {
        let above = if self.min_excluded { value > self.min } else { value >= self.min };
        above && value <= self.max
    }

    /// `expected 0.02 to 2 m`, with numbers divided by the SI value of the unit.
    pub(crate) fn text(&self, unit: &str, worth: f64) -> String {
        let show = |value: f64| number_text(value / worth);
        let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        if self.min_excluded {
            format!("more than {} and at most {}{unit}", show(self.min), show(self.max))
        } else {
            format!("{} to {}{unit}", show(self.min), show(self.max))
        }
    }

    /// Adds the range to the schema of a number whose unit has the SI value `worth`.
    pub fn describe(&self, schema: &mut Json, worth: f64) {
        let min = if self.min_excluded { "exclusiveMinimum" } else { "minimum" };
        schema[min] = json!(self.min / worth);
        schema["maximum"] = json!(self.max / worth);
        if let Some((from, to)) = self.usual {
            schema["x-usual"] = json!([from / worth, to / worth]);
        }
    }
}
