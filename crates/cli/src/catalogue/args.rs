//! Arguments of `wholestring catalogue`.

use std::path::PathBuf;

use clap::Args;
use wholestring_units::UnitSet;

#[derive(Debug, Args)]
pub(crate) struct CatalogueArgs {
    /// Size, weight, grade, class or kind, such as `5-1/2`, `S-135`, `premium`, `hwdp`, `casing` or
    /// `rig`; entries that match all of them are listed
    #[arg(value_name = "WORD")]
    pub(crate) words: Vec<String>,

    /// File of your own tubulars, TOML or CSV, as in the key `catalogue` of a case
    #[arg(long, value_name = "FILE")]
    pub(crate) with: Option<PathBuf>,

    /// Units of the table [default: si]
    #[arg(long, value_name = "si|metric|field")]
    pub(crate) units: Option<UnitSet>,
}
