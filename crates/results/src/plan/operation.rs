//! Subjects of the checks of a plan: operations, and events of its dynamic part.

use serde::{Deserialize, Serialize};
use wholestring::operation::{Event, OperationKind};

use crate::row::named;

/// An operation of a plan, or an event of its dynamic part. The file has its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(into = "&'static str", try_from = "String")]
pub enum PlanOperation {
    /// An operation.
    Kind(OperationKind),
    /// An event.
    Event(Event),
}

impl PlanOperation {
    /// The operation or the event of that name, if there is one.
    pub fn from_name(name: &str) -> Option<Self> {
        let kind = OperationKind::from_name(name).map(Self::Kind);
        kind.or_else(|| Event::from_name(name).map(Self::Event))
    }

    /// Name in results: `trip_out`, `pick_up_from_slips`, ...
    pub const fn name(self) -> &'static str {
        match self {
            Self::Kind(kind) => kind.name(),
            Self::Event(event) => event.name(),
        }
    }

    /// Name in messages and tables: "trip out", "pick up from slips", ...
    pub const fn words(self) -> &'static str {
        match self {
            Self::Kind(kind) => kind.words(),
            Self::Event(event) => event.words(),
        }
    }
}

named! {
    PlanOperation: name, "an operation or an event", Self::from_name;
}

impl From<PlanOperation> for &'static str {
    fn from(operation: PlanOperation) -> Self {
        operation.name()
    }
}

impl TryFrom<String> for PlanOperation {
    type Error = String;

    fn try_from(name: String) -> Result<Self, String> {
        Self::from_name(&name)
            .ok_or_else(|| format!("'{name}' is neither an operation nor an event"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_file_has_the_name() {
        let kinds = OperationKind::ALL.map(PlanOperation::Kind);
        for operation in kinds.into_iter().chain(Event::ALL.map(PlanOperation::Event)) {
            let value = serde_json::to_value(operation).expect("a name");
            assert_eq!(value, operation.name());
            let read: PlanOperation = serde_json::from_value(value).expect("an operation");
            assert_eq!(read, operation);
        }
        assert!(serde_json::from_str::<PlanOperation>(r#""trip""#).is_err());
    }
}
