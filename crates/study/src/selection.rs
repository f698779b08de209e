//! Cases of a sweep, chosen by the values of its keys.

use std::cmp::Ordering;

use serde_json::{Value as Json, json};
use wholestring_case::Variation;
use wholestring_config::prelude::*;

/// Cases of a sweep: the accepted values of each varied key.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Selection {
    terms: Vec<Term>,
}

#[derive(Debug, Clone, PartialEq)]
struct Term {
    key: String,
    key_place: Span,
    wanted: Vec<Wish>,
}

#[derive(Debug, Clone, PartialEq)]
struct Wish {
    /// First and last value; none at an open end of the range. A single value is both.
    from: Option<String>,
    to: Option<String>,
    place: Span,
}

impl Wish {
    fn has(&self, value: &str) -> bool {
        if self.from == self.to {
            return self.from.as_deref().is_some_and(|only| same(only, value));
        }
        let from = self.from.as_deref().map(|from| compare(value, from));
        let to = self.to.as_deref().map(|to| compare(value, to));
        from.is_none_or(|order| order.is_some_and(Ordering::is_ge))
            && to.is_none_or(|order| order.is_some_and(Ordering::is_le))
    }
}

impl Term {
    fn has(&self, value: &str) -> bool {
        self.wanted.iter().any(|wish| wish.has(value))
    }
}

impl Selection {
    /// Whether it includes the case with these values of these keys.
    pub fn has(&self, keys: &[String], values: &[String]) -> bool {
        self.terms.iter().all(|term| {
            let place = keys.iter().position(|key| *key == term.key);
            place.is_some_and(|place| term.has(&values[place]))
        })
    }

    /// The same, with the values of `other` for the keys that `other` names.
    pub fn narrowed(&self, other: &Self) -> Self {
        let rest = self.terms.iter().filter(|term| !other.names(&term.key));
        Self { terms: rest.chain(&other.terms).cloned().collect() }
    }

    /// The same, with any value for one key.
    pub(crate) fn without(&self, key: &str) -> Self {
        let rest = self.terms.iter().filter(|term| term.key != key);
        Self { terms: rest.cloned().collect() }
    }

    /// Whether it includes this value of a key.
    pub(crate) fn has_value(&self, key: &str, value: &str) -> bool {
        let mut terms = self.terms.iter().filter(|term| term.key == key);
        terms.all(|term| term.has(value))
    }

    fn names(&self, key: &str) -> bool {
        self.terms.iter().any(|term| term.key == key)
    }

    /// Whether the sweep varies every key that it names, to a value that it includes.
    pub(crate) fn check(&self, sweep: &str, vary: &[Variation], reader: &mut Reader) -> Option<()> {
        let mut valid = Some(());
        for term in &self.terms {
            let Some(varied) = vary.iter().find(|varied| varied.key == term.key) else {
                let message = format!("sweep `{}` does not vary `{}`", sweep, short(&term.key));
                let keys = vary.iter().map(|varied| varied.key.as_str());
                let mut diagnostic =
                    Diagnostic::error(message).at(term.key_place, "expected a key that it varies");
                if let Some(near) = nearest(&term.key, keys.clone()) {
                    diagnostic = diagnostic.help(format!("did you mean `{near}`?"));
                }
                let keys: Vec<&str> = keys.collect();
                let keys = if keys.is_empty() { "none".into() } else { keys.join(", ") };
                reader.report(diagnostic.help(format!("keys that it varies: {keys}")));
                valid = None;
                continue;
            };
            for wish in &term.wanted {
                if !varied.bare_values().any(|value| wish.has(value)) {
                    let message = format!("no case of sweep `{}` has this `{}`", sweep, term.key);
                    let values: Vec<&str> = varied.bare_values().collect();
                    Diagnostic::error(message)
                        .at(wish.place, "expected one of its values")
                        .help(format!("its values: {}", values.join(", ")))
                        .report(reader);
                    valid = None;
                }
            }
        }
        valid
    }
}

/// The notation of a selection: `{ bit_depth = "..1200 m", friction = [0.1, 0.2] }`.
pub(crate) struct SelectionRule;

impl Rule for SelectionRule {
    type Value = Selection;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<Selection> {
        let Value::Table(entries) = &node.value else {
            reader.expected(node, "keys with values, such as { friction = 0.3 }");
            return None;
        };
        let mut terms = Vec::new();
        let valid = leaves(entries, "", &mut |key, key_place, node| {
            let items = match &node.value {
                Value::List(items) => items.as_slice(),
                _ => std::slice::from_ref(node),
            };
            let wanted: Option<Vec<Wish>> = items.iter().map(|item| wish(item, reader)).collect();
            let Some(wanted) = wanted else { return false };
            terms.push(Term { key: key.to_owned(), key_place, wanted });
            true
        });
        valid.then_some(Selection { terms })
    }

    fn schema(&self) -> Json {
        json!({ "type": "object" })
    }

    fn example(&self) -> Option<String> {
        Some("{ bit_depth = \"..1200 m\", friction = 0.3 }".to_owned())
    }
}

fn wish(node: &Node, reader: &mut Reader) -> Option<Wish> {
    let text = match &node.value {
        Value::Text { text, .. } => text.trim().to_owned(),
        Value::Number { .. } => reader.text_at(node.place).to_owned(),
        _ => {
            reader.expected(node, "a value, or a range such as \"..1200 m\"");
            return None;
        }
    };
    let end = |text: &str| Some(text.trim().to_owned()).filter(|text| !text.is_empty());
    let (from, to) = match text.split_once("..") {
        Some((from, to)) => (end(from), end(to)),
        None => (end(&text), end(&text)),
    };
    if from.is_none() && to.is_none() {
        reader.expected(node, "a value, or a range such as \"..1200 m\"");
        return None;
    }
    if let (Some(from), Some(to)) = (&from, &to)
        && from != to
        && compare(from, to).is_none_or(Ordering::is_gt)
    {
        return Diagnostic::error("this range is empty")
            .at(node.place, "expected the smaller number first, both with a unit or both without")
            .refuse(reader);
    }
    Some(Wish { from, to, place: node.place })
}

/// Visits the values of dotted keys, as long as they are valid. `a.b = 1` and `"a.b" = 1` are the
/// same.
pub(crate) fn leaves(
    entries: &Entries,
    before: &str,
    visit: &mut impl FnMut(&str, Span, &Node) -> bool,
) -> bool {
    let mut valid = true;
    for (key, node) in &entries.0 {
        let name = format!("{before}{}", key.name);
        valid &= match &node.value {
            Value::Table(inner) => leaves(inner, &format!("{name}."), visit),
            _ => visit(&name, key.place, node),
        };
    }
    valid
}

/// Whether two values are equal in any notation.
fn same(a: &str, b: &str) -> bool {
    a == b || compare(a, b).is_some_and(Ordering::is_eq)
}

/// The order of two quantities of one dimension; none if they have no order.
fn compare(a: &str, b: &str) -> Option<Ordering> {
    let bare = |text: &str| text.parse::<f64>().ok();
    let order = |a: f64, b: f64| match (a - b).abs() <= 1e-9 * a.abs().max(b.abs()) {
        true => Some(Ordering::Equal),
        false => a.partial_cmp(&b),
    };
    if let (Some(a), Some(b)) = (bare(a), bare(b)) {
        return order(a, b);
    }
    // A bare number among others is SI.
    let si = |dimension: Dimension, text| bare(text).or_else(|| dimension.parse(text).ok());
    let mut dimensions = Dimension::ALL.iter();
    let (a, b) = dimensions.find_map(|dimension| Some((si(*dimension, a)?, si(*dimension, b)?)))?;
    order(a, b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_compared_as_quantities() {
        assert!(same("1200m", "1.2 km"));
        assert!(same("0.30", "0.3"));
        assert!(same("drill", "drill"));
        assert!(!same("drill", "slide"));
        assert_eq!(compare("900 m", "1 km"), Some(Ordering::Less));
        assert_eq!(compare("6 tf", "50 kN"), Some(Ordering::Greater));
        assert_eq!(compare("6 tf", "50 m"), None);
    }
}
