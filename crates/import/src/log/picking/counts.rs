//! Counts of the contents of a log.

use std::collections::BTreeMap;

use super::{
    motion::Motion,
    row::Row,
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

/// Rows on the hook with the bit far below the bottom of the hole, where the motion is unknown.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct BelowBottom {
    /// Their number.
    pub rows: usize,
    /// Number of all rows on the hook.
    pub of_rows: usize,
    /// Largest depth of the bit below the bottom, m.
    pub by_m: f64,
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
    /// Windows of rotation off bottom whose weight is accepted and whose torque is not, by reason.
    pub refused_torques: BTreeMap<Refusal, usize>,
    /// Rows on the hook with the bit below the bottom of the hole.
    pub below_bottom: BelowBottom,
    /// Travel of the bit over that of the block in each tripped stand, in log order.
    pub bit_over_block: Vec<f64>,
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

    /// Adds the rows of a stand that have the bit below bottom by more than `beyond_m`.
    pub(super) fn below_bottom(&mut self, rows: &[Row], beyond_m: f64) {
        self.below_bottom.of_rows += rows.len();
        let below = rows.iter().map(|row| -row.height_m()).filter(|below_m| *below_m > beyond_m);
        for below_m in below {
            self.below_bottom.rows += 1;
            self.below_bottom.by_m = self.below_bottom.by_m.max(below_m);
        }
    }

    /// Adds the trip that ends.
    pub(super) fn end_trip(&mut self, trip: &mut Option<Trip>) {
        self.trips.extend(trip.take().filter(|trip| trip.stands >= TRIP));
    }
}

/// A count with its noun: `1 value`, `12 values`.
pub(super) fn plural(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}
