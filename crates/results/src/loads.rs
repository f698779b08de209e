//! Loads that are weights or torques: in a table each has a column of its own.

/// A value of a weight; `None` for a torque.
pub(crate) fn weight<V>(is_torque: bool, value: V) -> Option<V> {
    (!is_torque).then_some(value)
}

/// A value of a torque; `None` for a weight.
pub(crate) fn torque<V>(is_torque: bool, value: V) -> Option<V> {
    is_torque.then_some(value)
}
