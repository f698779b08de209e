//! The events of a string that starts to move.

use serde::{Deserialize, Serialize};

use super::OperationKind;

/// Start of motion of a string that hangs at rest.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Event {
    /// The block lifts the string out of the slips and accelerates to the trip speed.
    PickUpFromSlips,
    /// The block lowers the string from rest to the trip speed.
    SlackOffFromSlips,
    /// The pumps start, the string hanging still.
    BreakCirculation,
    /// The rotary starts, pumps off.
    BreakRotation,
}

impl Event {
    /// Every event.
    pub const ALL: [Self; 4] = [
        Self::PickUpFromSlips,
        Self::SlackOffFromSlips,
        Self::BreakCirculation,
        Self::BreakRotation,
    ];

    /// Returns the name in case files and results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::PickUpFromSlips => "pick_up_from_slips",
            Self::SlackOffFromSlips => "slack_off_from_slips",
            Self::BreakCirculation => "break_circulation",
            Self::BreakRotation => "break_rotation",
        }
    }

    /// The name with spaces: "pick up from slips", ...
    pub const fn words(self) -> &'static str {
        match self {
            Self::PickUpFromSlips => "pick up from slips",
            Self::SlackOffFromSlips => "slack off from slips",
            Self::BreakCirculation => "break circulation",
            Self::BreakRotation => "break rotation",
        }
    }

    /// Returns the name for display.
    pub const fn label(self) -> &'static str {
        match self {
            Self::PickUpFromSlips => "pick-up from slips",
            Self::SlackOffFromSlips => "slack-off from slips",
            Self::BreakCirculation => "breaking circulation",
            Self::BreakRotation => "breaking rotation",
        }
    }

    /// Returns the event of that name, if there is one.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|event| event.name() == name)
    }

    /// Returns the operation that it leads to.
    pub const fn operation(self) -> OperationKind {
        match self {
            Self::PickUpFromSlips => OperationKind::TripOut,
            Self::SlackOffFromSlips => OperationKind::TripIn,
            Self::BreakCirculation | Self::BreakRotation => OperationKind::RotateOffBottom,
        }
    }

    /// Whether the string starts to rotate.
    pub const fn turns(self) -> bool {
        matches!(self, Self::BreakRotation)
    }

    /// Whether the pumps start.
    pub const fn circulates(self) -> bool {
        matches!(self, Self::BreakCirculation)
    }
}

#[cfg(test)]
mod tests {
    use super::Event;

    #[test]
    fn an_event_has_one_name() {
        for event in Event::ALL {
            assert_eq!(Event::from_name(event.name()), Some(event));
            assert_eq!(event.name().replace('_', " "), event.words());
            assert_eq!(serde_json::to_value(event).expect("a name"), event.name());
        }
    }
}
