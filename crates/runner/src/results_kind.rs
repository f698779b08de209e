//! What wrote to a folder.

use std::path::Path;

use crate::{
    bha::page::is_bha, bit_test::page::is_bit_test, calibrate::page::is_calibration, error::Error,
    modes::page::is_modes, plan::page::is_plan, reach::page::is_reach, sweep::page::is_sweep,
};

/// What a folder holds the results of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ResultsKind {
    /// A run.
    Run,
    /// A sweep.
    Sweep,
    /// A bit test.
    BitTest,
    /// An assembly at rest.
    Bha,
    /// Small motions.
    Modes,
    /// A plan.
    Plan,
    /// A calibration.
    Calibration,
    /// How far a well can go.
    Reach,
}

impl ResultsKind {
    /// What the folder holds the results of; nothing where it holds none that pages and pictures
    /// are made of.
    pub fn of(folder: &Path) -> Option<Self> {
        if is_bit_test(folder) {
            Some(Self::BitTest)
        } else if is_bha(folder) {
            Some(Self::Bha)
        } else if is_modes(folder) {
            Some(Self::Modes)
        } else if is_plan(folder) {
            Some(Self::Plan)
        } else if is_calibration(folder) {
            Some(Self::Calibration)
        } else if is_reach(folder) {
            Some(Self::Reach)
        } else if folder.join("summary.json").is_file() {
            Some(Self::Run)
        } else if is_sweep(folder) {
            Some(Self::Sweep)
        } else {
            None
        }
    }

    /// A folder that holds none.
    pub(crate) fn none(folder: &Path) -> Error {
        Error::BadInput(format!(
            "{} holds no results: neither summary.json nor sweep.csv is there",
            folder.display()
        ))
    }
}
