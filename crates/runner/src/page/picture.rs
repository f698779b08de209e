//! Pictures as files.

use wholestring_report::figure::Figure;
use wholestring_results::{ResultsError, ResultsFolder};

/// Dots per inch that printers and journals require.
const DOTS_PER_INCH: f64 = 300.0;

/// Writes a picture as SVG, and as PNG if that is requested.
///
/// # Errors
/// Files that cannot be written.
pub fn write_picture(
    folder: &ResultsFolder,
    name: &str,
    figure: &Figure,
    png: bool,
) -> Result<(), ResultsError> {
    let drawing = figure.drawing();
    folder.write_file(&format!("{name}.svg"), drawing.svg().as_bytes())?;
    let painted = format!("{name}.png");
    if png {
        folder.write_file(&painted, &drawing.png(DOTS_PER_INCH))
    } else {
        // One that was painted before is not of what was drawn now.
        folder.remove(&painted)
    }
}
