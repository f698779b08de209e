//! What a log holds, counted.

use std::collections::BTreeMap;

use super::{
    motion::Motion,
    window::{Kind, Refusal},
};

/// What was done with a stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Work {
    /// The hole got deeper.
    Drilled,
    /// It was pulled out.
    TrippedOut,
    /// It was run in.
    TrippedIn,
    /// None of these.
    Other,
}

/// A run of stands that all went the same way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trip {
    /// Whether it went out of the hole.
    pub out: bool,
    /// Depth of the bit where it began, m.
    pub from_m: f64,
    /// Depth of the bit where it ended, m.
    pub to_m: f64,
    /// Stands that it took.
    pub stands: usize,
}

/// What a log holds, counted.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Counts {
    /// Rows with a time.
    pub rows: usize,
    /// Rows without one, or of one that was there already.
    pub rows_without_time: usize,
    /// Silences of the log that part two stands.
    pub gaps: usize,
    /// Stands: from slips to slips.
    pub stands: usize,
    /// Those in which the hole got deeper.
    pub drilled: usize,
    /// Connections.
    pub connections: usize,
    /// Times in slips in which the block stayed about where it was.
    pub slips_alone: usize,
    /// Time in connections, s.
    pub connections_s: f64,
    /// Time in slips, connections apart, s.
    pub slips_alone_s: f64,
    /// Trips of several stands.
    pub trips: Vec<Trip>,
    /// Time of each motion on the hook, s.
    pub motions_s: BTreeMap<Motion, f64>,
    /// Windows that were told, by what they are for.
    pub told: BTreeMap<Kind, usize>,
    /// Windows that were refused, by what they were for and why.
    pub refused: BTreeMap<(Kind, Refusal), usize>,
}

/// Stands that make a trip: two are a wiper stroke.
const TRIP: usize = 3;

impl Counts {
    /// Takes a stand that moved the bit from one depth to the other.
    pub(super) fn stand(&mut self, work: Work, from_m: f64, to_m: f64, trip: &mut Option<Trip>) {
        self.stands += 1;
        self.drilled += usize::from(work == Work::Drilled);
        let out = match work {
            Work::TrippedOut => Some(true),
            Work::TrippedIn => Some(false),
            Work::Drilled => None,
            // It neither begins nor ends a trip: some wait on the way.
            Work::Other => return,
        };
        match (trip.as_mut(), out) {
            (Some(trip), Some(out)) if trip.out == out => {
                trip.to_m = to_m;
                trip.stands += 1;
            }
            _ => {
                self.end_trip(trip);
                *trip = out.map(|out| Trip { out, from_m, to_m, stands: 1 });
            }
        }
    }

    /// Takes the trip that ends.
    pub(super) fn end_trip(&mut self, trip: &mut Option<Trip>) {
        self.trips.extend(trip.take().filter(|trip| trip.stands >= TRIP));
    }
}
