//! Counts of the contents of a log.

use std::collections::BTreeMap;

use super::{
    motion::Motion,
    window::{Kind, Refusal},
};

/// Work done with a stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Work {
    /// The hole got deeper.
    Drilled,
    /// The string was pulled out.
    TrippedOut,
    /// The string was run in.
    TrippedIn,
    /// None of these.
    Other,
}

/// Consecutive stands with the same direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trip {
    /// Whether the direction is out of the hole.
    pub out: bool,
    /// Bit depth at the start, m.
    pub from_m: f64,
    /// Bit depth at the end, m.
    pub to_m: f64,
    /// Number of stands.
    pub stands: usize,
}

/// Counts of the contents of a log.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Counts {
    /// Rows with a time.
    pub rows: usize,
    /// Rows without a time, or with one that occurred before.
    pub rows_without_time: usize,
    /// Gaps in the log that separate two stands.
    pub gaps: usize,
    /// Stands: from slips to slips.
    pub stands: usize,
    /// Stands in which the hole got deeper.
    pub drilled: usize,
    /// Connections.
    pub connections: usize,
    /// Periods in slips in which the block stayed at about the same height.
    pub slips_alone: usize,
    /// Time in connections, s.
    pub connections_s: f64,
    /// Time in slips without connections, s.
    pub slips_alone_s: f64,
    /// Trips of several stands.
    pub trips: Vec<Trip>,
    /// Time of each motion on the hook, s.
    pub motions_s: BTreeMap<Motion, f64>,
    /// Accepted windows, by kind.
    pub accepted: BTreeMap<Kind, usize>,
    /// Refused windows, by kind and reason.
    pub refused: BTreeMap<(Kind, Refusal), usize>,
}

/// Minimum number of stands of a trip: two are a wiper stroke.
const TRIP: usize = 3;

impl Counts {
    /// Adds a stand that moved the bit between two depths.
    pub(super) fn stand(&mut self, work: Work, from_m: f64, to_m: f64, trip: &mut Option<Trip>) {
        self.stands += 1;
        self.drilled += usize::from(work == Work::Drilled);
        let out = match work {
            Work::TrippedOut => Some(true),
            Work::TrippedIn => Some(false),
            Work::Drilled => None,
            // Other work neither begins nor ends a trip, since some trips have pauses.
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

    /// Adds the trip that ends.
    pub(super) fn end_trip(&mut self, trip: &mut Option<Trip>) {
        self.trips.extend(trip.take().filter(|trip| trip.stands >= TRIP));
    }
}
