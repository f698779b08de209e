//! Positions of a file that are not those of its path, and turns that are hardly the hole's, as
//! notes.

use wholestring::well::{Path, Station, USUAL_DOGLEG_RAD_PER_M};
use wholestring_tabular::{StatedPosition, position_checks, station_doubts};
use wholestring_units::UnitSet;

use crate::fragment::Note;

/// Notes on more turns than this are only counted.
const NOTED: usize = 5;

/// Notes on the positions that a file states against those of its path by minimum curvature;
/// `place` says where in its file a station is.
pub(crate) fn positions(
    stations: &[Station],
    stated: &[StatedPosition],
    path: &Path,
    set: UnitSet,
    place: impl Fn(usize) -> String,
) -> Vec<Note> {
    let checks = position_checks(stations, stated, path, set).into_iter();
    let notes = checks.map(|check| match check.agrees {
        true => Note::Checked(check.sentence),
        false => {
            let place = place(check.index);
            Note::Checked(format!("{} ({place}); {}", check.sentence, check.reason))
        }
    });
    notes.collect()
}

/// Notes on the doubtful turns of a survey; `place` says where in its file a station is.
pub(crate) fn notes(
    stations: &[Station],
    set: UnitSet,
    place: impl Fn(usize) -> String,
) -> Vec<Note> {
    let doubts = station_doubts(stations, USUAL_DOGLEG_RAD_PER_M, set);
    let mut notes: Vec<Note> = doubts
        .iter()
        .take(NOTED)
        .map(|doubt| {
            let place = place(doubt.index);
            Note::Checked(format!("{} ({place}: {}); {}", doubt.sentence, doubt.label, doubt.help))
        })
        .collect();
    if doubts.len() > NOTED {
        notes.push(Note::Checked(format!("{} more turns of this kind", doubts.len() - NOTED)));
    }
    notes
}

/// The units of sentences on a survey whose lengths are in feet or not.
pub(crate) fn unit_set(units: &str) -> UnitSet {
    if units.contains("ft") { UnitSet::Field } else { UnitSet::Si }
}
