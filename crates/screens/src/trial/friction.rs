//! Friction of a text: every coefficient of the hole sections and of the levels of its plan.

use wholestring_case::MAX_FRICTION;
use wholestring_config::node::{Entries, Node, Value};
use wholestring_units::significant;

/// Casing or rock.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Cased,
    Open,
}

impl Kind {
    const ALL: [Self; 2] = [Self::Cased, Self::Open];

    const fn name(self) -> &'static str {
        match self {
            Self::Cased => "cased",
            Self::Open => "open",
        }
    }
}

/// Role of a coefficient.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Role {
    Section,
    Low,
    Expected,
    High,
}

/// Levels of a plan by key.
const LEVELS: [(&str, Role); 3] =
    [("low", Role::Low), ("expected", Role::Expected), ("high", Role::High)];

/// Coefficients of one key: a number, or a table of several.
#[derive(Debug)]
struct Given {
    role: Role,
    kinds: Vec<Kind>,
    /// Dotted key and value of each, `kinetic` first.
    numbers: Vec<(String, f64)>,
    around: Option<f64>,
}

impl Given {
    fn read(key: String, node: &Node, role: Role, kinds: Vec<Kind>) -> Option<Self> {
        let Value::Table(table) = &node.value else {
            let numbers = vec![(key, number(node)?)];
            return Some(Self { role, kinds, numbers, around: None });
        };
        let value = |name: &str| Some((format!("{key}.{name}"), number(table.get(name)?)?));
        let around = value("around");
        let rest = [value("static"), around.clone()];
        let numbers = [value("kinetic")?].into_iter().chain(rest.into_iter().flatten()).collect();
        Some(Self { role, kinds, numbers, around: around.map(|(_, value)| value) })
    }

    fn kinetic(&self) -> f64 {
        self.numbers[0].1
    }

    fn around(&self) -> f64 {
        self.around.unwrap_or_else(|| self.kinetic())
    }

    /// Ratio of the largest coefficient to the kinetic one.
    fn largest_ratio(&self) -> f64 {
        let largest = self.numbers.iter().fold(0.0_f64, |largest, (_, value)| largest.max(*value));
        if self.kinetic() > 0.0 { largest / self.kinetic() } else { 1.0 }
    }

    fn has_own_around(&self) -> bool {
        self.around() != self.kinetic()
    }
}

fn number(node: &Node) -> Option<f64> {
    match &node.value {
        Value::Number { value, .. } => Some(*value),
        Value::Text { text, .. } => text.trim().parse().ok(),
        _ => None,
    }
}

/// Range of a slider.
pub(crate) type Range = [f64; 2];

/// All coefficients of a text.
#[derive(Debug, Default)]
pub(crate) struct Frictions(Vec<Given>);

/// Smallest axial coefficient to which a rotational one may be in a ratio.
const LEAST: f64 = 1e-3;

/// Number of digits of a scaled coefficient.
const SCALED_DIGITS: usize = 4;

/// Number of digits of a coefficient that keeps its ratio to another one, which may be at a bound
/// of the plan.
const RATIO_DIGITS: usize = 6;

impl Frictions {
    /// The coefficients of a text; empty if it has none.
    pub(crate) fn of(root: &Entries) -> Self {
        let mut all = Vec::new();
        if let Some(Value::Table(well)) = root.get("well").map(|node| &node.value)
            && let Some(Value::List(sections)) = well.get("hole").map(|node| &node.value)
        {
            for (i, section) in sections.iter().enumerate() {
                let Value::Table(section) = &section.value else { continue };
                let Some(node) = section.get("friction") else { continue };
                let is_open = matches!(section.get("kind").map(|node| &node.value),
                    Some(Value::Text { text, .. }) if text == "open");
                let kind = if is_open { Kind::Open } else { Kind::Cased };
                let key = format!("well.hole.{i}.friction");
                all.extend(Given::read(key, node, Role::Section, vec![kind]));
            }
        }
        let plan = root.get("plan").map(|node| &node.value);
        let levels = plan.and_then(|plan| match plan {
            Value::Table(plan) => plan.get("friction"),
            _ => None,
        });
        if let Some(Value::Table(levels)) = levels.map(|node| &node.value) {
            for (name, role) in LEVELS {
                let Some(level) = levels.get(name) else { continue };
                let key = format!("plan.friction.{name}");
                let Value::Table(table) = &level.value else {
                    all.extend(Given::read(key, level, role, Kind::ALL.to_vec()));
                    continue;
                };
                for kind in Kind::ALL {
                    let Some(node) = table.get(kind.name()) else { continue };
                    let key = format!("{key}.{}", kind.name());
                    all.extend(Given::read(key, node, role, vec![kind]));
                }
            }
        }
        Self(all)
    }

    fn of_kind(&self, role: Role, kind: Kind) -> Option<&Given> {
        self.0.iter().find(|group| group.role == role && group.kinds.contains(&kind))
    }

    /// Every coefficient times a factor, with its dotted key: sections, and low, expected and high
    /// of the plan, which thus keep their order.
    pub(crate) fn scaled(&self, factor: f64) -> Vec<(String, f64)> {
        let numbers = self.0.iter().flat_map(|group| &group.numbers);
        numbers
            .map(|(key, value)| (key.clone(), significant(value * factor, SCALED_DIGITS)))
            .collect()
    }

    /// The same axial coefficient for all sections, and for the expected level of the plan if it
    /// has one; static and rotational coefficients keep their ratio to it.
    pub(crate) fn uniform(&self, coefficient: f64) -> Vec<(String, f64)> {
        let set =
            self.0.iter().filter(|group| matches!(group.role, Role::Section | Role::Expected));
        let of_given = |group: &Given| -> Vec<(String, f64)> {
            let kinetic = group.kinetic();
            let value = |(place, (key, old)): (usize, &(String, f64))| {
                let ratio = if place > 0 && kinetic > 0.0 { old / kinetic } else { 1.0 };
                let new = coefficient * ratio;
                (key.clone(), if place == 0 { new } else { significant(new, RATIO_DIGITS) })
            };
            group.numbers.iter().enumerate().map(value).collect()
        };
        set.flat_map(of_given).collect()
    }

    /// The factors that [`Self::scaled`] accepts.
    pub(crate) fn scales(&self) -> Range {
        let numbers = || self.0.iter().flat_map(|group| &group.numbers).map(|(_, value)| *value);
        let largest = numbers().fold(0.0, f64::max);
        let most = if largest > 0.0 { (MAX_FRICTION / largest).min(2.0) } else { 2.0 };
        let of_ratio = self.0.iter().filter(|group| group.has_own_around());
        let smallest = of_ratio.map(Given::kinetic).fold(f64::INFINITY, f64::min);
        let least = if smallest.is_finite() { (1.01 * LEAST / smallest).max(0.1) } else { 0.0 };
        [least.min(1.0), most.max(1.0)]
    }

    /// The coefficients that [`Self::uniform`] accepts, from zero to `most`, within the low and
    /// high levels of the plan; none if these exclude all.
    pub(crate) fn uniforms(&self, most: f64) -> Option<Range> {
        let mut range = [0.0, most];
        for group in &self.0 {
            if !matches!(group.role, Role::Section | Role::Expected) {
                continue;
            }
            range[1] = range[1].min(MAX_FRICTION / group.largest_ratio());
            if group.has_own_around() {
                range[0] = range[0].max(LEAST);
            }
            let ratio = if group.kinetic() > 0.0 { group.around() / group.kinetic() } else { 1.0 };
            for kind in &group.kinds {
                // The expected friction of a plan replaces the section's own.
                if group.role == Role::Section && self.of_kind(Role::Expected, *kind).is_some() {
                    continue;
                }
                if let Some(low) = self.of_kind(Role::Low, *kind) {
                    range[0] = range[0].max(low.kinetic()).max(low.around() / ratio);
                }
                if let Some(high) = self.of_kind(Role::High, *kind) {
                    range[1] = range[1].min(high.kinetic()).min(high.around() / ratio);
                }
            }
        }
        let range = [(1e4 * range[0] - 1e-6).ceil() / 1e4, (1e4 * range[1] + 1e-6).floor() / 1e4];
        (range[0] < range[1]).then_some(range)
    }
}

#[cfg(test)]
mod tests {
    use wholestring_config::node::parse_text;

    use super::*;

    const FORGE: &str = r#"
[[well.hole]]
kind = "casing"
friction = { kinetic = 0.097, around = 0.175 }
[[well.hole]]
kind = "open"
friction = { kinetic = 0.534, around = 0.220 }
[plan.friction]
low = { cased = { kinetic = 0.050, around = 0.133 }, open = { kinetic = 0.435, around = 0.150 } }
high = { cased = { kinetic = 0.191, around = 0.217 }, open = { kinetic = 0.619, around = 0.290 } }
"#;

    const PLAIN: &str = r#"
[[well.hole]]
kind = "casing"
friction = 0.2
[[well.hole]]
kind = "open"
friction = 0.3
"#;

    fn frictions(text: &str) -> Frictions {
        Frictions::of(&parse_text(text, 0).expect("TOML"))
    }

    #[test]
    fn every_coefficient_is_scaled_by_itself() {
        let scaled = frictions(FORGE).scaled(0.8);
        let value = |key: &str| scaled.iter().find(|(other, _)| other == key).expect(key).1;
        assert_eq!(scaled.len(), 12);
        assert_eq!(value("well.hole.0.friction.kinetic"), 0.0776);
        assert_eq!(value("well.hole.1.friction.around"), 0.176);
        assert_eq!(value("plan.friction.high.open.kinetic"), 0.4952);
    }

    #[test]
    fn a_plan_leaves_a_range_or_none() {
        assert_eq!(frictions(FORGE).uniforms(2.0), None);
        assert_eq!(frictions(PLAIN).uniforms(0.6), Some([0.0, 0.6]));
        let held = format!("{PLAIN}[plan.friction]\nlow = 0.1\nhigh = 0.4\n");
        assert_eq!(frictions(&held).uniforms(0.6), Some([0.1, 0.4]));
        let expected = format!("{held}expected = {{ open = 0.25 }}\n");
        let uniform = frictions(&expected).uniform(0.35);
        assert_eq!(uniform.len(), 3);
        assert!(uniform.contains(&("plan.friction.expected.open".to_owned(), 0.35)));
    }
}
