//! `[records]`: what a dynamic run keeps beside its tables.

use serde::Serialize;
use wholestring::dynamics::{Channel, DynamicsSettings, NodeSignal, Probe, Signal};
use wholestring_config::prelude::*;

/// Depths whose signals are kept: they stay in memory until the run ends.
const MAX_DEPTHS: usize = 10;

/// Segments that a window is cut into, half overlapping, where the case gives no length.
const SEGMENTS: f64 = 4.0;

/// A segment of fewer samples shows nothing.
const FEWEST_SAMPLES: f64 = 16.0;

fn usual() -> Vec<Spanned<Channel>> {
    let at = |value| Spanned { value, place: Span::default() };
    Channel::USUAL.map(at).to_vec()
}

table! {
    /// What a dynamic run keeps beside its tables.
    RecordsTable in "[records]" {
        /// How often the whole string is written to `frames.parquet`, rounded to whole samples;
        /// never where it is not given. 10 Hz of a string of 1350 nodes are some 0.5 MB a second.
        frames: f64 = optional(Quantity::si(
            Dimension::Frequency,
            Range::positive_to(1e4).usual(0.01, 2000.0),
            "10 Hz",
        ));
        /// What a frame holds of every node: "position" (offset from the hole's axis),
        /// "coordinates" (north, east, vertical depth), "velocity", "rotation" (rotary speed,
        /// twist), "tilt" (against the hole), "contact", "friction", "force" (tension, torque),
        /// "stress" (bending moment, von Mises).
        channels: Vec<Spanned<Channel>> = default(
            List::or_one(
                Choice { noun: "a channel", words: Channel::BY_NAME },
                "channels",
                Channel::BY_NAME.len(),
            ),
            usual(),
        );
        /// Scalars whose power spectral density over the window goes to `spectra.parquet`, by the
        /// names of their columns in `time.parquet` without the unit; none where it is not given.
        spectra: Vec<Spanned<Signal>> = optional(List::or_one(
            Choice { noun: "a signal", words: Signal::BY_NAME }, "signals", Signal::BY_NAME.len(),
        ));
        /// Quantities of single nodes whose spectra go there too, at each depth of
        /// `node_spectra_at`: "tension", "torque", "bending_moment", "von_mises_stress",
        /// "contact_force", "offset_high" and "offset_right" (from the hole's axis),
        /// "velocity_high", "velocity_right", "axial_velocity", "rotary_speed"; none where it is
        /// not given.
        node_spectra: Vec<Spanned<NodeSignal>> = optional(List::or_one(
            Choice { noun: "a signal of a node", words: NodeSignal::BY_NAME },
            "signals of nodes",
            NodeSignal::BY_NAME.len(),
        ));
        /// Measured depths of them with the bit at `bit_depth`. The node that is nearest then is
        /// taken, and stays the same as the string moves.
        node_spectra_at: Vec<Spanned<f64>> = optional(List::or_one(
            Quantity::si(Dimension::Length, Range::from_to(0.0, 20_000.0), "4290 m"),
            "depths",
            MAX_DEPTHS,
        ));
        /// Length of the segments whose periodograms a spectrum is the mean of; they overlap by
        /// half. Default: a quarter of the window. A longer one separates closer frequencies (they
        /// are one over it apart), a shorter one gives a smoother spectrum.
        spectrum_segment: f64 = optional(Quantity::si(
            Dimension::Time,
            Range::positive_to(86_400.0),
            "20 s",
        ));
    }
}

/// What a dynamic run keeps beside its tables.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Records {
    /// Time between two frames, s; none where none are kept.
    pub frame_interval_s: Option<f64>,
    /// What a frame holds.
    pub channels: Vec<Channel>,
    /// Scalars of which spectra are kept.
    pub spectra: Vec<Signal>,
    /// Places of the string of which spectra are kept.
    pub probes: Vec<Probe>,
    /// Length of the segments of a spectrum, s.
    pub spectrum_segment_s: f64,
}

impl RecordsTable {
    pub(crate) fn build(
        &self,
        dynamics: &DynamicsSettings,
        bit_depth_m: Option<f64>,
        reader: &mut Reader,
    ) -> Option<Records> {
        let frames = self.frames.optional()?;
        let channels = self.channels.get()?;
        let spectra = self.spectra.optional()?.map_or(&[][..], |at| &at.value[..]);
        let segment = self.spectrum_segment.optional()?;
        once_each(channels, Channel::name, reader)?;
        once_each(spectra, Signal::name, reader)?;
        let probes = self.probes(bit_depth_m, reader)?;
        let none = spectra.is_empty() && probes.is_empty();
        if let (None, Some(given)) = (frames, self.channels.given()) {
            Diagnostic::idle("channels", given.place, "what a frame holds")
                .help("no frames are kept: add frames = \"10 Hz\" to [records]")
                .report(reader);
        }
        if let (true, Some(given)) = (none, segment) {
            let what = "length of the segments of a spectrum";
            Diagnostic::idle("spectrum_segment", given.place, what)
                .help("no spectra are kept: add spectra = \"surface_torque\" to [records]")
                .report(reader);
        }
        let sample_s = dynamics.sample_interval_s;
        if let Some(given) = frames
            // A rounded rate is no mistake.
            && given.value * sample_s > 1.0 + 1e-9
        {
            return Diagnostic::error("frames are taken at samples: there are not so many")
                .at(given.place, format!("expected at most {} Hz", number_text(1.0 / sample_s)))
                .help(format!(
                    "lower it, or lower dynamics.sample_interval, which is {} s",
                    number_text(sample_s)
                ))
                .refuse(reader);
        }
        let window_s = dynamics.duration_s;
        let segment_s = segment.map_or(window_s / SEGMENTS, |at| at.value);
        if let Some(given) = segment.filter(|_| !none)
            && !(FEWEST_SAMPLES * sample_s..=window_s).contains(&given.value)
        {
            return Diagnostic::error(
                "a segment of a spectrum must fit in the window and hold 16 samples",
            )
            .at(
                given.place,
                format!(
                    "expected {} to {} s",
                    number_text(FEWEST_SAMPLES * sample_s),
                    number_text(window_s)
                ),
            )
            .refuse(reader);
        }
        Some(Records {
            frame_interval_s: frames.map(|at| 1.0 / at.value),
            channels: channels.iter().map(|at| at.value).collect(),
            spectra: spectra.iter().map(|at| at.value).collect(),
            probes,
            spectrum_segment_s: segment_s,
        })
    }

    /// Every signal at every depth.
    fn probes(&self, bit_depth_m: Option<f64>, reader: &mut Reader) -> Option<Vec<Probe>> {
        let (signals, depths) = (self.node_spectra.optional()?, self.node_spectra_at.optional()?);
        let (signals, depths) = match (signals, depths) {
            (None, None) => return Some(Vec::new()),
            (Some(signals), Some(depths)) => (&signals.value, &depths.value),
            (Some(signals), None) => {
                return Diagnostic::error("`node_spectra` needs `node_spectra_at`")
                    .at(signals.place, "at which depths?")
                    .help("add node_spectra_at = \"4290 m\" to [records]")
                    .refuse(reader);
            }
            (None, Some(depths)) => {
                Diagnostic::idle("node_spectra_at", depths.place, "depths of signals of nodes")
                    .help(
                        "no signal is named: add node_spectra = \"bending_moment\" to \
                               [records]",
                    )
                    .report(reader);
                return Some(Vec::new());
            }
        };
        once_each(signals, NodeSignal::name, reader)?;
        for (i, depth) in depths.iter().enumerate() {
            let twice = depths[..i].iter().find(|first| first.value == depth.value);
            let too_deep = bit_depth_m.filter(|bit_m| depth.value > *bit_m);
            let diagnostic = match (twice, too_deep) {
                (Some(first), _) => Diagnostic::error(format!(
                    "{} is listed twice",
                    reader.shown(Dimension::Length, depth.value)
                ))
                .at(depth.place, "again here")
                .at(first.place, "first here"),
                (None, Some(bit_m)) => {
                    Diagnostic::error("a depth of `node_spectra_at` is below the bit").at(
                        depth.place,
                        format!("expected at most {}", reader.shown(Dimension::Length, bit_m)),
                    )
                }
                (None, None) => continue,
            };
            return diagnostic.refuse(reader);
        }
        let at_depth = |depth: &Spanned<f64>| {
            let md_m = depth.value;
            signals.iter().map(move |at| Probe { md_m, signal: at.value })
        };
        Some(depths.iter().flat_map(at_depth).collect())
    }
}
