//! A file as rows of cells: text that is cut at separators or at blanks, and workbooks.

pub(crate) mod archive;
pub(crate) mod blanks;
pub(crate) mod compound;
pub(crate) mod decode;
pub(crate) mod delimited;
pub(crate) mod fixed;
pub(crate) mod limits;
pub(crate) mod number;
mod open;
pub(crate) mod records;
pub(crate) mod shown;
pub(crate) mod table;
pub(crate) mod workbook;

pub(crate) use open::{above, below, is_workbook, of_text, of_workbook};
