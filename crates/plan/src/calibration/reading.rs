//! Surface measurements, and the motion of the string during them.

/// Motion of the string during a reading.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Motion {
    /// Pulled out of the hole without rotation.
    PickUp,
    /// Run into the hole without rotation.
    SlackOff,
    /// Turned off bottom.
    Rotating,
    /// Turned with weight on the bit.
    Drilling,
}

impl Motion {
    /// Every motion.
    pub const ALL: [Self; 4] = [Self::PickUp, Self::SlackOff, Self::Rotating, Self::Drilling];

    /// Whether the string turns, so that it rubs around the hole.
    pub const fn turns(self) -> bool {
        matches!(self, Self::Rotating | Self::Drilling)
    }
}

/// Kind of reading.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Channel {
    /// Hook load while the string is pulled out.
    PickUp,
    /// Hook load while it is run in.
    SlackOff,
    /// Hook load while it turns off bottom.
    Rotating,
    /// Torque at surface off bottom.
    OffBottomTorque,
    /// Torque at surface on bottom.
    OnBottomTorque,
}

impl Channel {
    /// Every channel, weights first.
    pub const ALL: [Self; 5] =
        [Self::PickUp, Self::SlackOff, Self::Rotating, Self::OffBottomTorque, Self::OnBottomTorque];

    /// Name in tables: `pick_up`, ...
    pub const fn name(self) -> &'static str {
        match self {
            Self::PickUp => "pick_up",
            Self::SlackOff => "slack_off",
            Self::Rotating => "rotating",
            Self::OffBottomTorque => "torque",
            Self::OnBottomTorque => "torque_on_bottom",
        }
    }

    /// The channel of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|channel| channel.name() == name)
    }

    /// Returns the motion of the string.
    pub const fn motion(self) -> Motion {
        match self {
            Self::PickUp => Motion::PickUp,
            Self::SlackOff => Motion::SlackOff,
            Self::Rotating | Self::OffBottomTorque => Motion::Rotating,
            Self::OnBottomTorque => Motion::Drilling,
        }
    }

    /// Whether it is a torque and no weight.
    pub const fn is_torque(self) -> bool {
        matches!(self, Self::OffBottomTorque | Self::OnBottomTorque)
    }

    /// Returns the error of its readings.
    pub const fn error(self) -> ErrorKind {
        match self {
            Self::PickUp | Self::SlackOff => ErrorKind::Tripping,
            Self::Rotating => ErrorKind::Rotating,
            Self::OffBottomTorque | Self::OnBottomTorque => ErrorKind::Torque,
        }
    }
}

/// Readings that err alike.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum ErrorKind {
    /// Pick-up and slack-off weights.
    Tripping,
    /// Rotating weights.
    Rotating,
    /// Torques.
    Torque,
}

impl ErrorKind {
    /// Every kind.
    pub const ALL: [Self; 3] = [Self::Tripping, Self::Rotating, Self::Torque];

    /// In a sentence.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Tripping => "pick-up and slack-off weights",
            Self::Rotating => "rotating weights",
            Self::Torque => "torques",
        }
    }

    /// Returns its index in [`Self::ALL`].
    pub const fn place(self) -> usize {
        self as usize
    }
}

/// A reading.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reading {
    /// Index of the setup in the hole.
    pub setup: usize,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// The kind of reading.
    pub channel: Channel,
    /// Its value, N or N·m; weights include the block's.
    pub value: f64,
}
