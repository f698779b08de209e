//! `wholestring catalogue` as the user writes it.

use std::path::PathBuf;

use clap::Args;
use wholestring_units::UnitSet;

#[derive(Debug, Args)]
pub(crate) struct CatalogueArgs {
    /// Size, weight, grade, class or kind, such as `5-1/2`, `S-135`, `premium`, `hwdp`, `casing` or
    /// `rig`; what has all of them is listed
    #[arg(value_name = "WORD")]
    pub(crate) words: Vec<String>,

    /// Tubulars of your own, TOML or CSV, as `catalogue` of a case names them
    #[arg(long, value_name = "FILE")]
    pub(crate) with: Option<PathBuf>,

    /// Units of the table [default: si]
    #[arg(long, value_name = "si|metric|field")]
    pub(crate) units: Option<UnitSet>,
}
