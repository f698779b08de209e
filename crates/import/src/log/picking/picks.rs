//! Values picked from a log.

use wholestring_tabular::ImportedReading;
use wholestring_units::{Dimension, Unit, UnitSet, number_text};

use super::{
    block::{BlockWeight, shown},
    counts::{Counts, Work, plural},
    estimate::{Estimate, median},
    trace::Trace,
    window::{Kind, Refused, Window},
};
use crate::fragment::Note;

/// Number of windows, and the relative change of their weights, from which and up to which a hook
/// load is one that never changes; fewer windows suffice if no row differs.
const STUCK_WINDOWS: usize = 6;
const UNCHANGED: f64 = 1e-6;

/// Values picked from a log, and the evidence of their quality.
#[derive(Debug, Clone, PartialEq)]
pub struct Picks {
    /// Name of the log's file.
    pub file: String,
    /// The block's weight, and whether the logged hook loads include it. Those of the windows
    /// always do.
    pub block: BlockWeight,
    /// Time between two rows, s.
    pub step_s: f64,
    /// The best window of each kind of each stand, in log order.
    pub windows: Vec<Window>,
    /// Whether the hook load is one number in all rows at the beginning of the log, though the bit
    /// travels.
    pub(super) is_unchanged: bool,
    /// Counts of rows, stands and windows of the log.
    pub counts: Counts,
    /// Trace of the whole log.
    pub overview: Trace,
    /// Some stands, evenly spaced over the log.
    pub details: Vec<Detail>,
    /// Depth difference within which picks of a stand share a row, m.
    pub(super) same_depth_m: f64,
    /// Units of depths, torques and written readings: field units if the hook loads have one.
    pub units: UnitSet,
    /// Unit of the log's hook loads.
    pub(super) unit: &'static Unit,
    pub(super) notes: Vec<Note>,
}

/// A stand: the string on the hook from slips to slips.
#[derive(Debug, Clone, PartialEq)]
pub struct Detail {
    /// Number of the stand in the log, from 1.
    pub stand: usize,
    /// Work done with the stand.
    pub work: Work,
    /// Trace of the stand.
    pub trace: Trace,
    /// Accepted windows of the stand.
    pub windows: Vec<Window>,
    /// Refused windows of the stand, with reasons.
    pub refused: Vec<Refused>,
}

impl Picks {
    /// Weights and torques by bit depth, as `calibrate` reads them: weights include the block.
    pub fn readings(&self) -> Vec<ImportedReading> {
        let stuck = self.stuck_N().is_some();
        let mut readings = Vec::new();
        for stand in self.windows.chunk_by(|a, b| a.stand == b.stand) {
            let mut windows: Vec<&Window> =
                stand.iter().filter(|window| is_in_hole(window)).collect();
            windows.sort_by(|a, b| a.bit_depth_m.total_cmp(&b.bit_depth_m));
            let mut rest = windows.as_slice();
            while let [first, ..] = rest {
                let near =
                    |window: &&&Window| window.bit_depth_m - first.bit_depth_m <= self.same_depth_m;
                let count = rest.iter().take_while(near).count().max(1);
                let (own, others) = rest.split_at(count);
                rest = others;
                let row = reading(own);
                readings.extend(if stuck { without_weights(row) } else { Some(row) });
            }
        }
        readings
    }

    /// Notes on the interpretation of the log, assumptions and omissions.
    pub fn notes(&self) -> Vec<Note> {
        let mut notes = vec![self.said_of_log()];
        notes.extend(self.said_of_trips());
        notes.push(self.block.note(self.unit));
        notes.extend(self.said_of_windows());
        notes.extend(self.said_of_sensor());
        notes.extend(self.notes.iter().cloned());
        notes
    }

    pub(super) fn step(&self) -> String {
        number_text((100.0 * self.step_s).round() / 100.0)
    }

    /// A depth in whole units.
    fn depth(&self, depth_m: f64) -> String {
        let unit = Dimension::Length.unit_in(self.units);
        format!("{:.0} {}", unit.from_si(depth_m), unit.symbol)
    }

    pub(super) fn torque_unit(&self) -> &'static Unit {
        Dimension::Torque.unit_in(self.units)
    }

    fn said_of_log(&self) -> Note {
        let Counts { stands, drilled, connections, connections_s, slips_alone, .. } = self.counts;
        let mut text = format!(
            "{}, {drilled} of them drilled; {}",
            plural(stands, "stand"),
            plural(connections, "connection")
        );
        if connections > 0 {
            let mean = connections_s / connections as f64 / 60.0;
            text += &format!(" of {mean:.1} min on average");
        }
        if slips_alone > 0 {
            text += &format!(", and {} in slips without one", plural(slips_alone, "time"));
        }
        Note::Read(text)
    }

    /// The weight that all windows have, N, if the hook load never changes: that of a sensor that
    /// does not work.
    fn stuck_N(&self) -> Option<f64> {
        let mut weights = self.windows.iter().filter_map(|window| Some(window.weight_N?.value));
        let first_N = weights.next()?;
        let mut count = 1;
        let is_one = weights
            .inspect(|_| count += 1)
            .all(|weight_N| (weight_N - first_N).abs() <= UNCHANGED * first_N.abs());
        (is_one && (self.is_unchanged || count >= STUCK_WINDOWS)).then_some(first_N)
    }

    fn said_of_sensor(&self) -> Option<Note> {
        let weight = shown(self.stuck_N()?, self.unit);
        Some(Note::Warning(format!(
            "THE HOOK LOAD NEVER CHANGES: it is {weight} in {}, whether the string goes up, down or \
             turns, and at every depth; a sensor that does not work gives no reading, and the \
             weights are left out",
            match self.windows.len() {
                _ if self.is_unchanged => "all rows".to_owned(),
                count => format!("all {count} windows"),
            }
        )))
    }

    fn said_of_trips(&self) -> Option<Note> {
        /// Maximum number of trips that are listed one by one.
        const MAX_LISTED: usize = 8;
        let trips = &self.counts.trips;
        let texts = trips.iter().take(MAX_LISTED).map(|trip| {
            let way = if trip.out { "out" } else { "in" };
            format!(
                "{way} from {} to {} in {} stands",
                self.depth(trip.from_m),
                self.depth(trip.to_m),
                trip.stands
            )
        });
        let mut texts: Vec<String> = texts.collect();
        if trips.len() > MAX_LISTED {
            texts.push(format!("and {} more", trips.len() - MAX_LISTED));
        }
        (!texts.is_empty())
            .then(|| Note::Read(format!("{}: {}", plural(trips.len(), "trip"), texts.join("; "))))
    }

    fn said_of_windows(&self) -> Vec<Note> {
        let picked = Kind::ALL.map(|kind| {
            let count = self.windows.iter().filter(|window| window.kind == kind).count();
            format!("{count} of {}", kind.words())
        });
        let mut text = format!("windows picked, the best of each stand: {}", picked.join(", "));
        let errors = |estimate: fn(&Window) -> Option<Estimate>| {
            let estimates = self.windows.iter().filter_map(estimate);
            let errors = estimates.map(|estimate| estimate.standard_error);
            median(&mut errors.collect())
        };
        let weight = errors(|window| window.weight_N).map(|error| shown(error, self.unit));
        let torque =
            errors(|window| window.torque_N_m).map(|error| shown(error, self.torque_unit()));
        let known: Vec<String> = [("weight", weight), ("torque", torque)]
            .into_iter()
            .filter_map(|(what, error)| Some(format!("{} of a {what}", error?)))
            .collect();
        if !known.is_empty() {
            text += &format!("; median standard error {}", known.join(", "));
        }
        let mut notes = vec![Note::Read(text)];
        if !self.counts.refused.is_empty() {
            let refused = self.counts.refused.iter().map(|((kind, why), count)| {
                format!("{count} of {}: {}", kind.words(), why.words())
            });
            let refused: Vec<String> = refused.collect();
            notes.push(Note::LeftOut(format!("windows refused: {}", refused.join("; "))));
        }
        if !self.counts.refused_torques.is_empty() {
            let refused = self.counts.refused_torques.iter();
            let refused = refused.map(|(why, count)| format!("{count}: {}", why.words()));
            notes.push(Note::LeftOut(format!(
                "torques of windows of {}: {}",
                Kind::Rotating.words(),
                refused.collect::<Vec<_>>().join("; ")
            )));
        }
        notes.extend(self.said_of_nothing());
        notes
    }

    /// Reasons why no reading follows from the log, or not from all windows.
    fn said_of_nothing(&self) -> Option<Note> {
        let at_surface = self.windows.iter().filter(|window| !is_in_hole(window)).count();
        if at_surface > 0 {
            let all = self.windows.len();
            return Some(Note::LeftOut(format!(
                "{at_surface} of {all} picked windows, because their bit depth is 0 or less: a \
                 weight without a depth is no reading; check the channel of the bit depth{}",
                if at_surface == all { "; no file of readings is written" } else { "" }
            )));
        }
        if !self.windows.is_empty() {
            return None;
        }
        let motions = self.counts.motions_s.iter().filter(|(_, time_s)| **time_s > 0.0);
        let motions =
            motions.map(|(motion, time_s)| format!("{:.1} min {}", time_s / 60.0, motion.words()));
        let motions: Vec<String> = motions.collect();
        let motions = match motions[..] {
            [] => "the string was never on the hook".to_owned(),
            _ => format!("the time on the hook was {}", motions.join(", ")),
        };
        Some(Note::LeftOut(format!(
            "all weights and torques, because no window was picked: {motions}; no file of \
             readings is written"
        )))
    }
}

/// Whether the bit of a window is below the surface, as that of a reading has to be.
fn is_in_hole(window: &Window) -> bool {
    window.bit_depth_m > 0.0
}

/// A row without its weights, where the sensor of the hook load does not work; `None` if it has no
/// torque either.
fn without_weights(reading: ImportedReading) -> Option<ImportedReading> {
    let has_torque = reading.torque_N_m.or(reading.torque_on_bottom_N_m).is_some();
    let row = ImportedReading { pick_up_N: None, slack_off_N: None, rotating_N: None, ..reading };
    has_torque.then_some(row)
}

/// Combines windows at about one depth into a row.
fn reading(windows: &[&Window]) -> ImportedReading {
    let first = |kind: Kind| windows.iter().find(|window| window.kind == kind);
    let weight = |kind| Some(first(kind)?.weight_N?.value);
    let torque = |kind| Some(first(kind)?.torque_N_m?.value);
    let depth_m =
        windows.iter().map(|window| window.bit_depth_m).sum::<f64>() / windows.len() as f64;
    let from_s = windows.iter().map(|window| window.from_s).fold(f64::INFINITY, f64::min);
    let to_s = windows.iter().map(|window| window.to_s).fold(f64::NEG_INFINITY, f64::max);
    let [from, to] = [from_s, to_s].map(|at_s| at_s / 3600.0);
    let stand = windows.first().map_or(0, |window| window.stand);
    let place = format!("stand {stand}, {from:.3} h to {to:.3} h");
    ImportedReading {
        place,
        bit_depth_m: depth_m,
        pick_up_N: weight(Kind::PickUp),
        slack_off_N: weight(Kind::SlackOff),
        rotating_N: weight(Kind::Rotating),
        torque_N_m: torque(Kind::Rotating),
        torque_on_bottom_N_m: torque(Kind::Drilling),
        mud_density_kg_per_m3: None,
        case: None,
        held_out: false,
        keys: Vec::new(),
    }
}
