//! What a page and a live string say to each other.

use std::sync::Arc;

use serde::{Deserialize, Serialize};
use utoipa::ToSchema;

use super::{
    layout::Layout,
    live_string::{LiveString, Viewer},
    pace::Pace,
    packet::samples_packet,
    set_points::SetPoints,
    status::Status,
};

/// What a page is told, as text; samples and frames are binary.
#[derive(Debug, Serialize, ToSchema)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum Told<'a> {
    /// What a viewer has to know first.
    Layout(&'a Layout),
    /// How the string is doing.
    Status(&'a Status),
    /// What was asked cannot be.
    Refused {
        /// Why.
        message: String,
    },
}

impl Told<'_> {
    /// As it is sent.
    pub fn text(&self) -> String {
        // It is made of strings, numbers and lists; were it no JSON, its absence would show.
        serde_json::to_string(self).unwrap_or_default()
    }
}

/// What a page asks, as text.
#[derive(Debug, Deserialize, ToSchema)]
#[serde(deny_unknown_fields, rename_all = "snake_case")]
pub enum Said {
    /// The samples that the page has already: those of this epoch up to this number. Said first, or
    /// all that is kept is sent.
    Have {
        /// The epoch.
        epoch: u32,
        /// The number of the next sample.
        next: u64,
    },
    /// Sets something.
    Set(SetPoints),
    /// Takes another pace.
    Pace(Pace),
    /// Goes on, or waits.
    Run(bool),
    /// Goes on by so many seconds, and waits then.
    Step(f64),
}

/// Samples in a message at most: the rest follows in the next.
const MOST_SAMPLES: usize = 4096;

/// A page that looks at a live string, and what it has been given.
pub struct Viewing {
    string: Arc<LiveString>,
    epoch: u32,
    next: u64,
    _viewer: Viewer,
}

impl Viewing {
    /// One that has been given nothing.
    pub fn of(string: &Arc<LiveString>) -> Self {
        Self { string: string.clone(), epoch: u32::MAX, next: 0, _viewer: string.view() }
    }

    /// Samples that are new, as they are sent, and whether more of them wait; none where there are
    /// no newer ones.
    pub fn samples(&mut self) -> Option<(Vec<u8>, bool)> {
        let samples = self.string.samples(self.epoch, self.next, MOST_SAMPLES)?;
        let more = samples.end() - samples.first == MOST_SAMPLES as u64;
        (self.epoch, self.next) = (samples.epoch, samples.end());
        Some((samples_packet(&samples), more))
    }

    /// Does what the page says; why not, where it cannot be.
    pub fn hear(&mut self, text: &str) -> Option<String> {
        let said: Said = match serde_json::from_str(text) {
            Ok(said) => said,
            Err(error) => return Some(format!("this is not understood: {error}")),
        };
        let string = &self.string;
        let done = match said {
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
        };
        done.err().map(|error| error.to_string())
    }
}
