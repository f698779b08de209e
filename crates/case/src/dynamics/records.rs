//! `[records]`: further outputs of a dynamic run, in addition to its tables.

use serde::Serialize;
use wholestring::dynamics::{Channel, DynamicsSettings, NodeSignal, Probe, Signal};
use wholestring_config::prelude::*;

/// Maximum number of depths with recorded signals, which remain in memory until the run ends.
const MAX_DEPTHS: usize = 10;

/// Default number of segments of a window, half overlapping.
const SEGMENTS: f64 = 4.0;

/// Minimum number of samples of a meaningful segment.
const FEWEST_SAMPLES: f64 = 16.0;

fn usual() -> Vec<Spanned<Channel>> {
    let at = |value| Spanned { value, place: Span::default() };
    Channel::USUAL.map(at).to_vec()
}

table! {
    /// Further outputs of a dynamic run, in addition to its tables.
    RecordsTable in "[records]" {
        /// Rate at which the whole string is written to `frames.parquet`, rounded to whole samples.
        /// Default: never. 10 Hz of a string of 1350 nodes are some 0.5 MB a second.
        frames: f64 = optional(Quantity::si(
            Dimension::Frequency,
            Range::positive_to(1e4).usual(0.01, 2000.0),
            "10 Hz",
        ));
        /// Quantities of every node in a frame: "position" (offset from the hole's axis),
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
        /// Scalars whose power spectral density over the window is written to `spectra.parquet`, by
        /// the names of their columns in `time.parquet` without the unit. Default: none.
        spectra: Vec<Spanned<Signal>> = optional(List::or_one(
            Choice { noun: "a signal", words: Signal::BY_NAME }, "signals", Signal::BY_NAME.len(),
        ));
        /// Quantities of single nodes whose spectra are written to the same file, at each depth of
        /// `node_spectra_at`: "tension", "torque", "bending_moment", "von_mises_stress",
        /// "contact_force", "offset_high" and "offset_right" (from the hole's axis),
        /// "velocity_high", "velocity_right", "axial_velocity", "rotary_speed". Default: none.
        node_spectra: Vec<Spanned<NodeSignal>> = optional(List::or_one(
            Choice { noun: "a signal of a node", words: NodeSignal::BY_NAME },
            "signals of nodes",
            NodeSignal::BY_NAME.len(),
        ));
        /// Measured depths of these nodes with the bit at `bit_depth`. The nearest node at that
        /// moment is recorded, also as the string moves.
        node_spectra_at: Vec<Spanned<f64>> = optional(List::or_one(
            Quantity::si(Dimension::Length, Range::from_to(0.0, 20_000.0), "4290 m"),
            "depths",
            MAX_DEPTHS,
        ));
        /// Length of the segments whose periodograms are averaged to a spectrum; they overlap by
        /// half. Default: a quarter of the window. A longer one separates closer frequencies (the
        /// resolution is one over it), a shorter one gives a smoother spectrum.
        spectrum_segment: f64 = optional(Quantity::si(
            Dimension::Time,
            Range::positive_to(86_400.0),
            "20 s",
        ));
    }
}

/// Further outputs of a dynamic run, in addition to its tables.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Records {
    /// Time between two frames, s; `None` without frames.
    pub frame_interval_s: Option<f64>,
    /// Quantities in a frame.
    pub channels: Vec<Channel>,
    /// Scalars with spectra.
    pub spectra: Vec<Signal>,
    /// Places on the string with spectra.
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
        if let (None, Some(entry)) = (frames, self.channels.given()) {
            Diagnostic::idle("channels", entry.place, "quantities of a frame")
                .help("no frames are recorded: add frames = \"10 Hz\" to [records]")
                .report(reader);
        }
        if let (true, Some(entry)) = (none, segment) {
            let what = "length of the segments of a spectrum";
            Diagnostic::idle("spectrum_segment", entry.place, what)
                .help("no spectra are recorded: add spectra = \"surface_torque\" to [records]")
                .report(reader);
        }
        let sample_s = dynamics.sample_interval_s;
        if let Some(entry) = frames
            // Rounding the rate is not a mistake.
            && entry.value * sample_s > 1.0 + 1e-9
        {
            return Diagnostic::error("frames cannot be more frequent than samples")
                .at(entry.place, format!("expected at most {} Hz", number_text(1.0 / sample_s)))
                .help(format!(
                    "lower it, or lower dynamics.sample_interval, which is {} s",
                    number_text(sample_s)
                ))
                .refuse(reader);
        }
        let window_s = dynamics.duration_s;
        let segment_s = segment.map_or(window_s / SEGMENTS, |at| at.value);
        if let Some(entry) = segment.filter(|_| !none)
            && !(FEWEST_SAMPLES * sample_s..=window_s).contains(&entry.value)
        {
            return Diagnostic::error(
                "a segment of a spectrum must fit in the window and contain 16 samples",
            )
            .at(
                entry.place,
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

    /// Returns every signal at every depth.
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
