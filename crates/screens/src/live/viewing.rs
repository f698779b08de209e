//! Messages between a page and a live string.

use std::sync::Arc;

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;
use wholestring_units::{UnitSet, UnknownUnitSet};

use super::{
    command::LiveError,
    layout::Layout,
    live_string::{LiveString, Viewer},
    pace::Pace,
    packet::samples_packet,
    set_points::SetPoints,
    status::Status,
};

/// Text messages to a page; samples and frames are binary.
#[derive(Debug, Serialize, ToSchema)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum Told<'a> {
    /// The layout that a viewer needs first.
    Layout(&'a Layout),
    /// The status of the string.
    Status(&'a Status),
    /// A request was refused.
    Refused {
        /// Reason.
        message: String,
    },
}

impl Told<'_> {
    /// The message as sent.
    pub fn text(&self) -> String {
        // It consists of strings, numbers and lists; if serialization failed, the empty text would
        // reveal it.
        serde_json::to_string(self).unwrap_or_default()
    }
}

/// Text messages from a page.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields, rename_all = "snake_case")]
#[schema(as = ViewerMessage)]
pub enum Said {
    /// The samples that the page already has: those of this epoch up to this number. Unless this is
    /// the first message, all samples of the ring are sent.
    Have {
        /// The epoch.
        epoch: u32,
        /// The number of the next sample.
        next: u64,
    },
    /// Applies set points.
    Set(SetPoints),
    /// Changes the pace.
    Pace(Pace),
    /// Runs or pauses the string.
    Run(bool),
    /// Advances by this many seconds, and pauses then.
    Step(f64),
    /// Changes the units of the sentences: `si`, `metric` or `field`.
    Units(String),
}

/// Maximum number of samples in a message; the others follow in the next one.
const MOST_SAMPLES: usize = 4096;

/// A page that views a live string, and the state sent to it.
pub struct Viewing {
    string: Arc<LiveString>,
    epoch: u32,
    next: u64,
    /// Units of the sentences; by default those of the case.
    units: UnitSet,
    _viewer: Viewer,
}

impl Viewing {
    /// A page to which nothing was sent.
    pub fn of(string: &Arc<LiveString>) -> Self {
        let units = string.case().units;
        Self { string: string.clone(), epoch: u32::MAX, next: 0, units, _viewer: string.view() }
    }

    /// New samples, as sent, and whether more are waiting; none if there are no newer ones.
    pub fn samples(&mut self) -> Option<(Vec<u8>, bool)> {
        let samples = self.string.samples(self.epoch, self.next, MOST_SAMPLES)?;
        let more = samples.end() - samples.first == MOST_SAMPLES as u64;
        (self.epoch, self.next) = (samples.epoch, samples.end());
        Some((samples_packet(&samples), more))
    }

    /// Handles a message of the page; returns the reason if it is refused.
    pub fn hear(&mut self, text: &str) -> Option<String> {
        let message: Said = match serde_json::from_str(text) {
            Ok(message) => message,
            Err(error) => return Some(format!("this is not understood: {error}")),
        };
        let string = &self.string;
        let done = match message {
            Said::Have { epoch, next } => {
                (self.epoch, self.next) = (epoch, next);
                Ok(())
            }
            Said::Set(set) => string.set(set),
            Said::Pace(pace) => string.pace(pace),
            Said::Run(runs) => {
                string.run(runs);
                Ok(())
            }
            Said::Step(seconds) => string.step(seconds),
            Said::Units(name) => name
                .parse()
                .map(|units| self.units = units)
                .map_err(|error: UnknownUnitSet| LiveError::Refused(error.to_string())),
        };
        done.err().map(|error| error.in_units(self.units))
    }

    /// The status with its sentences in the units of the page.
    pub fn status(&self, status: &Status) -> Status {
        status.in_units(self.units)
    }
}
