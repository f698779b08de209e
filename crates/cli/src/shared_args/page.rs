//! Arguments of commands that write a page.

use clap::Args;
use wholestring_units::UnitSet;

use super::screen::ScreenOptions;

#[derive(Debug, Args)]
pub(crate) struct PageArgs {
    /// Also write PNG images, with 300 dots per inch
    #[arg(long)]
    pub(crate) png: bool,

    /// Units on the screen and the page [default: the case's]
    #[arg(long, value_name = "si|metric|field")]
    pub(crate) units: Option<UnitSet>,

    /// Print nothing but errors
    #[arg(short, long)]
    pub(crate) quiet: bool,

    /// Exit with status 4 if a check of the results is an error
    #[arg(long)]
    pub(crate) strict: bool,
}

impl PageArgs {
    /// Options of the screen.
    pub(crate) fn screen(&self) -> ScreenOptions {
        ScreenOptions { quiet: self.quiet, strict: self.strict, json: false }
    }
}
