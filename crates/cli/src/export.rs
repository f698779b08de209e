//! `wholestring export`: results, the survey and the string of a case in the formats of other
//! programs.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use wholestring_runner::export::{self, Format, Request, What, WitsmlVersion};
use wholestring_units::UnitSet;

use crate::{
    failure::Failure,
    terminal::{print_stderr, print_stdout},
};

#[derive(Debug, Args)]
pub(crate) struct ExportArgs {
    /// Folder of results, or a case file
    #[arg(value_name = "DIR|CASE.toml")]
    pub(crate) from: PathBuf,

    /// Format
    #[arg(long = "to", value_enum, value_name = "FORMAT")]
    pub(crate) format: FormatArg,

    /// Content to write; a case file has no results [default: results]
    #[arg(long, value_enum, value_name = "WHAT")]
    pub(crate) what: Option<WhatArg>,

    // Not a doc comment, which would read `<what>` as HTML.
    #[arg(
        short,
        long,
        value_name = "FILE",
        help = "File, or folder for the tables of results as CSV [default: in DIR, or next to the case]"
    )]
    pub(crate) output: Option<PathBuf>,

    /// Units [default: the case's]
    #[arg(long, value_name = "si|metric|field")]
    pub(crate) units: Option<UnitSet>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum FormatArg {
    /// Comma-separated text; for results one file per table
    Csv,
    /// An Excel workbook
    Xlsx,
    /// Fixed-width report of a survey
    Text,
    /// WITSML 1.4.1.1: logs against bit depth, trajectory, tubular
    Witsml,
    /// WITSML 2.0
    Witsml2,
    /// WITSML 2.1
    Witsml21,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum WhatArg {
    /// Tables of a results folder
    Results,
    /// Stations of the well
    Survey,
    /// Components of the string, from the bit up
    Tally,
}

pub(crate) fn export(args: &ExportArgs) -> Result<(), Failure> {
    let exported = export::export(&Request {
        from: args.from.clone(),
        what: args.what.map(|what| match what {
            WhatArg::Results => What::Results,
            WhatArg::Survey => What::Survey,
            WhatArg::Tally => What::Tally,
        }),
        format: match args.format {
            FormatArg::Csv => Format::Csv,
            FormatArg::Xlsx => Format::Xlsx,
            FormatArg::Text => Format::Text,
            FormatArg::Witsml => Format::Witsml(WitsmlVersion::V1411),
            FormatArg::Witsml2 => Format::Witsml(WitsmlVersion::V20),
            FormatArg::Witsml21 => Format::Witsml(WitsmlVersion::V21),
        },
        output: args.output.clone(),
        units: args.units,
    })?;
    for note in &exported.notes {
        print_stderr(&format!("note: {note}\n"));
    }
    let files = exported.files.iter();
    print_stdout(&files.map(|file| format!("{}\n", file.display())).collect::<String>())
}
