//! The page of weights picked from a log, and its pictures.

mod figures;
mod page;

pub use figures::picked_stand_figure;
pub use page::picks_html;

use wholestring::operation::OperationKind;
use wholestring_import::picking::{Detail, Kind, Picks, Work};
use wholestring_units::UnitSet;

use crate::{PageHead, draw::palette::operation_colour, figure::Ink};

/// Weights picked from a log with the head of their page.
struct PickedLog<'a> {
    /// Head of the page, under the name of the log.
    head: PageHead,
    picks: &'a Picks,
}

impl<'a> PickedLog<'a> {
    /// The page opens in these units.
    fn new(picks: &'a Picks, units: UnitSet) -> Self {
        let name = picks.file.rsplit(['/', '\\']).next().unwrap_or(&picks.file);
        let title = format!("Weights picked from {name}");
        Self { head: PageHead::new(title, Some(units), None, Vec::new()), picks }
    }
}

/// Purposes of windows in the order of a legend.
const KINDS: [Kind; 4] = [Kind::SlackOff, Kind::Rotating, Kind::PickUp, Kind::Drilling];

/// Colour of a purpose, which is that of the operation on a plan's broomstick.
fn ink(kind: Kind) -> Ink {
    let operation = match kind {
        Kind::PickUp => OperationKind::TripOut,
        Kind::SlackOff => OperationKind::TripIn,
        Kind::Rotating => OperationKind::RotateOffBottom,
        Kind::Drilling => OperationKind::Drill,
    };
    Ink::Line(operation_colour(operation))
}

/// Number of a stand, and the work done with it.
fn number_and_work(stand: &Detail) -> String {
    let work = match stand.work {
        Work::Drilled => "drilled",
        Work::TrippedOut => "pulled out",
        Work::TrippedIn => "run in",
        Work::Other => "held off bottom",
    };
    format!("{}, {work}", stand.stand)
}
