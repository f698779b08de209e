//! Why there is no map.

use wholestring::{dynamics::SetupError, statics::soft::SoftError};

/// Why linear vibration about steady rotation cannot be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum StabilityError {
    /// The string does not turn on bottom.
    #[error("torsional stability is that of a string that drills and turns: kind = \"drill\"")]
    NotDrilling,
    /// A bit on solid rock.
    #[error(
        "a bit on solid rock has no law with known slopes: measure it with a bit test, and give \
         its table to the bit"
    )]
    SolidRock,
    /// Nothing in the case falls with speed, and every point of the map is stable.
    #[error(
        "neither the torque of the bit nor the axial friction falls with speed in this case, \
        and its weights are too small for the rate of penetration to drive stick-slip (`heaviest` of \
        [modes]), so that every speed and weight of the map is stable. Give the hole a \
        static friction above the kinetic one, such as friction = {{ kinetic = {kinetic}, static = \
        {at_rest} }}, or the bit a law that loses torque with speed (`bit.law` \"regenerative\" or \
        \"table\"); `modes.static_over_kinetic = {ratio}` assumes that ratio for this map alone"
    )]
    NothingFalls {
        /// Kinetic friction of the deepest section.
        kinetic: f64,
        /// A usual static friction to go with it.
        at_rest: f64,
        /// A usual ratio of the two.
        ratio: f64,
    },
    /// The bit does not turn.
    #[error("the bit does not turn: its motor stalls, or the string does not turn")]
    Stands,
    /// A user-defined controller or friction law.
    #[error("a user-defined {0} has no known slopes")]
    Custom(&'static str),
    /// A range that holds nothing.
    #[error("{0} must be positive, the second above the first, in two steps at least")]
    Range(&'static str),
    /// Settings that no run can use.
    #[error(transparent)]
    Setup(#[from] SetupError),
    /// The string cannot be laid in its hole.
    #[error(transparent)]
    Soft(#[from] SoftError),
}
