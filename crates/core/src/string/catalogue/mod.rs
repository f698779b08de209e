//! Catalogue of tubulars: API drill pipe, heavy-weight drill pipe, drill collars and coiled tubing.
//!
//! Only dimensions and grades are stored, as facts with the standard that they come from; masses
//! and strengths are computed from them. One tool joint is chosen for each pipe and grade where the
//! standards offer several: copy the [`CatalogueEntry`], change its dimensions, and the mass
//! follows.
//!
//! The computed mass of a drill pipe is within 3 % of the approximate weights of API RP 7G, mostly
//! below them: those count the upsets too.
//!
//! Torques of connections are computed by API RP 7G's formula from the dimensions of their threads
//! ([`RotaryConnection`](crate::string::RotaryConnection)). Used drill pipe,
//! `5 in 19.50 lb/ft S-135 premium` or `... class 2`, has lost a fifth or three tenths of its wall,
//! evenly from outside; its tool joints are counted as new.

mod class;
mod coiled;
mod connections;
mod designation;
mod entry;
mod nominal;
pub(crate) mod parts;
mod tables;

pub use class::PipeClass;
pub use connections::{connection, tool_joint};
pub use designation::{describes, find};
pub use entry::{CatalogueEntry, EntryConnection, JointDimensions, TubularKind};
pub use nominal::nominal_pipe;

/// Why a designation names no entry.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CatalogueError {
    /// No entry of that name.
    #[error("the catalogue has no `{designation}`; the nearest entries are {}", quoted(.nearest))]
    Unknown {
        /// The requested designation.
        designation: String,
        /// Designations of the nearest entries, the nearest first.
        nearest: Vec<String>,
    },
}

fn quoted(names: &[String]) -> String {
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

/// All entries, new: drill pipe, heavy-weight drill pipe, collars, coiled tubing, each by size.
pub fn entries() -> Vec<CatalogueEntry> {
    tables::entries()
}
