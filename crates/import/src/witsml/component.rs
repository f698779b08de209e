//! A component of a tubular: its type and its name in the case.

use wholestring_units::Dimension;

use super::{
    measure::{Measure, Source, short},
    tree::Node,
};
use crate::error::{ImportError, ImportErrorKind};

/// WITSML puts the noun first.
const TURNED: &[(&str, &str)] =
    &[("sub-", "sub"), ("stabilizer ", "stabilizer"), ("motor ", "motor"), ("mill ", "mill")];

/// A component as its tubular describes it.
pub(crate) struct Component<'a> {
    pub(crate) node: &'a Node,
    pub(crate) sequence: Option<i64>,
    /// `typeTubularComp`, in lower case.
    kind: String,
}

impl<'a> Component<'a> {
    pub(crate) fn of(node: &'a Node, source: &Source) -> Result<Self, ImportError> {
        let sequence = match node.child("sequence") {
            Some(child) => source.number_of(child, "sequence")?.map(|number| (number, child.line)),
            None => None,
        };
        if let Some((number, line)) = sequence.filter(|(number, _)| number.fract() != 0.0) {
            let (what, found) = ("sequence".to_owned(), number.to_string());
            return Err(source.error(line, ImportErrorKind::NotANumber { what, found }));
        }
        let kind = node.text_of("typeTubularComp|TypeTubularComponent").unwrap_or_default();
        let sequence = sequence.map(|(number, _)| number as i64);
        Ok(Self { node, sequence, kind: short(&kind.to_lowercase()) })
    }

    /// Whether it is the bit, as opposed to a hole opener above one.
    pub(crate) fn is_bit(&self) -> bool {
        let opens = ["bit hole opener", "bit under reamer"].contains(&self.kind.as_str());
        let named = self.kind == "bit" || self.kind.starts_with("bit ") && !opens;
        let unnamed = ["", "other", "unknown"].contains(&self.kind.as_str());
        named || unnamed && self.node.child("bitRecord").is_some()
    }

    /// Whether it is made of joints.
    pub(crate) fn is_pipe(&self) -> bool {
        ["drill pipe", "tubing", "casing", "liner"].iter().any(|word| self.kind.contains(word))
    }

    /// Whether it is drill pipe of a kind in the catalogue.
    pub(crate) fn is_drill_pipe(&self) -> bool {
        self.kind.contains("drill pipe") && !self.kind.contains("heavy")
    }

    /// Name in the case: the usual oilfield term for that of WITSML.
    pub(crate) fn name(&self) -> String {
        let kind = self.kind.strip_suffix(" lh").unwrap_or(&self.kind);
        if self.is_bit() {
            return match kind.strip_prefix("bit ") {
                Some(rest) => format!("{} bit", rest.replace("pdc", "PDC")),
                None => "bit".to_owned(),
            };
        }
        match kind {
            "bit hole opener" => "hole opener".to_owned(),
            "bit under reamer" => "under-reamer".to_owned(),
            "heavy weight drill pipe" => "heavy-weight drill pipe".to_owned(),
            "logging while drilling tool" => "LWD tool".to_owned(),
            "rotary steering tool" => "rotary steerable".to_owned(),
            "" | "other" | "unknown" => match self.node.text_of("description") {
                Some(description) => short(description),
                None => "component".to_owned(),
            },
            _ => {
                let turned = TURNED.iter().find_map(|(first, noun)| {
                    Some(format!("{} {noun}", kind.strip_prefix(first)?))
                });
                turned.unwrap_or_else(|| kind.replace("mwd", "MWD"))
            }
        }
    }

    /// Label in messages: `component 3 (stabilizer)`.
    pub(crate) fn label(&self) -> String {
        match self.sequence {
            Some(sequence) => format!("component {sequence} ({})", self.name()),
            None => format!("the {} in line {}", self.name(), self.node.line),
        }
    }

    /// Its length, m, if given.
    pub(crate) fn length(&self, source: &Source) -> Result<Option<Measure>, ImportError> {
        source.measure(self.node, "len", Dimension::Length)
    }
}
