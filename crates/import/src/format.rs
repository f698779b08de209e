//! Supported formats, recognised by content.

use crate::{
    choices::Choices,
    edm,
    error::{ImportError, ImportErrorKind},
    fragment::{Contents, Fragment},
    input::Input,
    log, tables, witsml, xml,
};

/// A supported format.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Rows of cells: text or a workbook.
    Table,
    /// WITSML except logs: trajectories, tubulars, runs, geometries, mud reports.
    Witsml,
    /// An export of Landmark's Engineer's Data Model.
    Edm,
    /// A log of the sensors of a rig.
    Log(log::Kind),
}

impl Format {
    /// Determines the format of a file by its first bytes; its name is ignored.
    ///
    /// # Errors
    /// It cannot be read, or its format is not supported.
    pub fn of(input: &mut Input) -> Result<Self, ImportError> {
        let name = input.name().to_owned();
        let head = input.head()?;
        // Texts within an uncompressed archive are not those of the file.
        if wholestring_tabular::is_workbook(head) {
            return Ok(Format::Table);
        }
        xml::check(&name, head)?;
        if let Some(kind) = log::Kind::of(head) {
            return Ok(Format::Log(kind));
        }
        if let Some(root) = xml::root(head) {
            if witsml::is_witsml(&root) {
                return Ok(Format::Witsml);
            }
            if root.name.eq_ignore_ascii_case(edm::ROOT) {
                return Ok(Format::Edm);
            }
            let found = format!("it is XML with the root element <{}>", root.name);
            return Err(ImportError::new(&name, None, ImportErrorKind::NotRecognised { found }));
        }
        Ok(Format::Table)
    }

    /// Reads a file of this format.
    pub(crate) fn read(self, input: Input, choices: &Choices) -> Result<Fragment, ImportError> {
        match self {
            Format::Table => tables::read(input, choices),
            Format::Witsml => witsml::read(input, choices),
            Format::Edm => edm::read(input, choices),
            Format::Log(kind) => log::read(input, kind, choices),
        }
    }

    /// Describes a file of this format and its contents.
    pub(crate) fn contents(self, input: Input) -> Result<Contents, ImportError> {
        match self {
            Format::Table => tables::contents(input),
            Format::Witsml => witsml::contents(input),
            Format::Edm => edm::contents(input),
            Format::Log(kind) => log::contents(input, kind),
        }
    }
}
