//! Every operation in the dynamics, against the soft string.
#[test]
fn x() {}
