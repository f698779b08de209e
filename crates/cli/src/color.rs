//! Whether text is coloured: on a terminal, unless the user has turned colours off.

use std::{
    env,
    io::{self, IsTerminal},
};

/// Whether diagnostics are coloured: on a terminal, unless the user has turned colours off.
pub(crate) fn color() -> bool {
    io::stderr().is_terminal() && env::var_os("NO_COLOR").is_none_or(|no| no.is_empty())
}

/// Whether text on standard output is coloured.
pub(crate) fn screen_color() -> bool {
    io::stdout().is_terminal() && env::var_os("NO_COLOR").is_none_or(|no| no.is_empty())
}
