//! Options common to commands.

use std::{num::NonZeroUsize, path::PathBuf, time::Duration};

use pyo3::prelude::*;
use wholestring_runner::{BatchOptions, Error, Output};
use wholestring_units::UnitSet;

use super::option::{bad, checkpoint_every};
use crate::existing::existing_of;

/// Options common to commands.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Common {
    folder: PathBuf,
    existing: String,
    units: Option<String>,
    pub(super) jobs: Option<NonZeroUsize>,
    checkpoint_s: Option<f64>,
    shard: Option<String>,
    pub(super) csv: bool,
    pub(super) png: bool,
}

impl Common {
    pub(super) fn output(&self) -> Output {
        Output {
            folder: Some(self.folder.clone()),
            existing: existing_of(&self.existing),
            ..Output::default()
        }
    }

    pub(super) fn units(&self) -> Result<Option<UnitSet>, Error> {
        let units = self.units.as_ref().map(|name| name.parse());
        units.transpose().map_err(|reason| bad("units", reason))
    }

    pub(super) fn checkpoint(&self) -> Result<Option<Duration>, Error> {
        checkpoint_every("checkpoint", self.checkpoint_s)
    }

    pub(super) fn batch(&self) -> Result<BatchOptions, Error> {
        let shard = self.shard.as_ref().map(|text| text.parse()).transpose();
        Ok(BatchOptions {
            output: self.output(),
            jobs: self.jobs,
            shard: shard.map_err(|reason: String| bad("shard", reason))?.unwrap_or_default(),
            checkpoint_every: self.checkpoint()?,
            csv: self.csv,
        })
    }
}
