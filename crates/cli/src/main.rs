//! The `wholestring` command.
fn main() {}
