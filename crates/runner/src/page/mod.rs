//! `report.html`: pages and pictures of results, made from their files.

mod run;
mod tables;

use std::io;

use wholestring_contain::{Panicked, contain};
use wholestring_report::figure::Figure;
use wholestring_results::{ResultsError, ResultsFolder};

use crate::error::mistake_of;

pub(crate) use run::{PROFILE, complete, lacking, page, write, write_profile};
pub(crate) use tables::{read_rows, rows_of, table};
pub(crate) use wholestring_report::PROGRAM;

/// Name of the file.
pub(crate) const FILE: &str = "report.html";

/// Dots per inch that printers and journals require.
const DOTS_PER_INCH: f64 = 300.0;

/// Writes a picture as SVG, and as PNG if requested.
///
/// # Errors
/// Files that cannot be written.
pub fn write_picture(
    folder: &ResultsFolder,
    name: &str,
    figure: &Figure,
    png: bool,
) -> Result<(), ResultsError> {
    let path = folder.path().join(format!("{name}.svg"));
    let images = contain(|| {
        let drawing = figure.drawing();
        (drawing.svg(), png.then(|| drawing.png(DOTS_PER_INCH)))
    });
    let (svg, painted) = images.map_err(|Panicked(mistake)| ResultsError::Write {
        path,
        source: io::Error::other(mistake_of(&mistake)),
    })?;
    folder.write_file(&format!("{name}.svg"), svg.as_bytes())?;
    let name = format!("{name}.png");
    match painted {
        Some(bytes) => folder.write_file(&name, &bytes),
        // An earlier PNG image does not belong to the new picture.
        None => folder.remove(&name),
    }
}
