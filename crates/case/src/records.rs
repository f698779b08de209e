//! `[records]`: what a dynamic run keeps beside its tables.

use serde_json::{Value as Json, json};
use wholestring::dynamics::{Channel, DynamicsSettings, Signal};
use wholestring_units::Dimension;

use crate::{
    diagnostic::Diagnostic,
    quantity::Quantity,
    range::{Range, number_text},
    reader::Reader,
    rule::{At, Choice, List, once_each},
    source::Place,
    table::{default, optional, table},
};

/// Channels by their names.
const CHANNELS: &[(&str, Channel)] = &[
    (Channel::Position.name(), Channel::Position),
    (Channel::Coordinates.name(), Channel::Coordinates),
    (Channel::Velocity.name(), Channel::Velocity),
    (Channel::Rotation.name(), Channel::Rotation),
    (Channel::Tilt.name(), Channel::Tilt),
    (Channel::Contact.name(), Channel::Contact),
    (Channel::Friction.name(), Channel::Friction),
    (Channel::Force.name(), Channel::Force),
    (Channel::Stress.name(), Channel::Stress),
];

/// Signals by their names.
const SIGNALS: &[(&str, Signal)] = &[
    (Signal::HookLoad.name(), Signal::HookLoad),
    (Signal::SurfaceTorque.name(), Signal::SurfaceTorque),
    (Signal::FrictionTorque.name(), Signal::FrictionTorque),
    (Signal::AxialFriction.name(), Signal::AxialFriction),
    (Signal::SideForceTotal.name(), Signal::SideForceTotal),
    (Signal::WeightOnBit.name(), Signal::WeightOnBit),
    (Signal::BitTorque.name(), Signal::BitTorque),
    (Signal::BitRotarySpeed.name(), Signal::BitRotarySpeed),
    (Signal::BlockVelocity.name(), Signal::BlockVelocity),
    (Signal::Twist.name(), Signal::Twist),
    (Signal::Stretch.name(), Signal::Stretch),
];

/// Segments that a window is cut into, half overlapping, where the case gives no length.
const SEGMENTS: f64 = 4.0;

/// A segment of fewer samples shows nothing.
const FEWEST_SAMPLES: f64 = 16.0;

fn usual() -> Vec<At<Channel>> {
    let at = |value| At {
        value,
        place: Place::default(),
    };
    Channel::USUAL.map(at).to_vec()
}

table! {
    /// What a dynamic run keeps beside its tables.
    RecordsTable in "[records]" {
        /// How often the whole string is written to `frames.parquet`, rounded to whole samples; never where
        /// it is not given. 10 Hz of a string of 1350 nodes are some 0.5 MB a second.
        frames: f64 = optional(Quantity::si(
            Dimension::Frequency,
            Range::positive_to(1e4),
            "10 Hz",
        ));
        /// What a frame holds of every node: "position" (offset from the hole's axis), "coordinates"
        /// (north, east, vertical depth), "velocity", "rotation" (rotary speed, twist), "tilt" (against the
        /// hole), "contact", "friction", "force" (tension, torque), "stress" (bending moment, von Mises).
        channels: Vec<At<Channel>> = default(
            List {
                item: Choice { noun: "a channel", words: CHANNELS },
                or_one: true,
                noun: "channels",
                most: CHANNELS.len(),
            },
            usual(),
        );
        /// Scalars whose power spectral density over the window goes to `spectra.parquet`, by the names of
        /// their columns in `time.parquet` without the unit; none where it is not given.
        spectra: Vec<At<Signal>> = optional(List {
            item: Choice { noun: "a signal", words: SIGNALS },
            or_one: true,
            noun: "signals",
            most: SIGNALS.len(),
        });
        /// Length of the segments whose periodograms a spectrum is the mean of; they overlap by half.
        /// Default: a quarter of the window. A longer one separates closer frequencies (they are one
        /// over it apart), a shorter one gives a smoother spectrum.
        spectrum_segment: f64 = optional(Quantity::si(
            Dimension::Time,
            Range::positive_to(86_400.0),
            "20 s",
        ));
    }
}

/// What a dynamic run keeps beside its tables.
#[derive(Debug, Clone, PartialEq)]
pub struct Records {
    /// Time between two frames, s; none where none are kept.
    pub frame_interval_s: Option<f64>,
    /// What a frame holds.
    pub channels: Vec<Channel>,
    /// Scalars of which spectra are kept.
    pub spectra: Vec<Signal>,
    /// Length of the segments of a spectrum, s.
    pub spectrum_segment_s: f64,
}

impl RecordsTable {
    pub(crate) fn build(
        &self,
        dynamics: &DynamicsSettings,
        reader: &mut Reader,
    ) -> Option<Records> {
        let frames = self.frames.optional()?;
        let channels = self.channels.get()?;
        let spectra = self.spectra.optional()?.map_or(&[][..], |at| &at.value[..]);
        let segment = self.spectrum_segment.optional()?;
        once_each(channels, Channel::name, reader)?;
        once_each(spectra, Signal::name, reader)?;
        if let (None, Some(given)) = (frames, self.channels.given()) {
            reader.report(
                Diagnostic::warning("`channels` has no effect here")
                    .at(given.place, "what a frame holds")
                    .help("no frames are kept: add frames = \"10 Hz\" to [records]"),
            );
        }
        if let (true, Some(given)) = (spectra.is_empty(), segment) {
            reader.report(
                Diagnostic::warning("`spectrum_segment` has no effect here")
                    .at(given.place, "length of the segments of a spectrum")
                    .help("no spectra are kept: add spectra = \"surface_torque\" to [records]"),
            );
        }
        let sample_s = dynamics.sample_interval_s;
        if let Some(given) = frames
            // A rounded rate is no mistake.
            && given.value * sample_s > 1.0 + 1e-9
        {
            reader.report(
                Diagnostic::error("frames are taken at samples: there are not so many")
                    .at(
                        given.place,
                        format!("expected at most {} Hz", number_text(1.0 / sample_s)),
                    )
                    .help(format!(
                        "lower it, or lower dynamics.sample_interval, which is {} s",
                        number_text(sample_s)
                    )),
            );
            return None;
        }
        let window_s = dynamics.duration_s;
        let segment_s = segment.map_or(window_s / SEGMENTS, |at| at.value);
        if let Some(given) = segment.filter(|_| !spectra.is_empty())
            && !(FEWEST_SAMPLES * sample_s..=window_s).contains(&given.value)
        {
            reader.report(
                Diagnostic::error(
                    "a segment of a spectrum must fit in the window and hold 16 samples",
                )
                .at(
                    given.place,
                    format!(
                        "expected {} to {} s",
                        number_text(FEWEST_SAMPLES * sample_s),
                        number_text(window_s)
                    ),
                ),
            );
            return None;
        }
        Some(Records {
            frame_interval_s: frames.map(|at| 1.0 / at.value),
            channels: channels.iter().map(|at| at.value).collect(),
            spectra: spectra.iter().map(|at| at.value).collect(),
            spectrum_segment_s: segment_s,
        })
    }
}

impl Records {
    /// For the record of a run.
    pub(crate) fn settings(&self) -> Json {
        json!({
            "frame_interval_s": self.frame_interval_s,
            "channels": self.channels.iter().map(|channel| channel.name()).collect::<Vec<_>>(),
            "spectra": self.spectra.iter().map(|signal| signal.name()).collect::<Vec<_>>(),
            "spectrum_segment_s": self.spectrum_segment_s,
        })
    }
}
