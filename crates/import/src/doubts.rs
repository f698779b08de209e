//! Notes on positions in a file that differ from those of its path, and on implausible turns.

use wholestring::well::{Path, Station, USUAL_DOGLEG_RAD_PER_M};
use wholestring_tabular::{
    StatedPosition, StationDoubt, position_checks, station_doubts, surface_doubts,
};
use wholestring_units::UnitSet;

use crate::fragment::Note;

/// Maximum number of turns with a note each; further ones are counted.
const NOTED: usize = 5;

/// Notes on a path to which no hole from the surface leads, and on the positions that a file states
/// against those of its path by minimum curvature; `place` returns the location of a station in its
/// file.
pub(crate) fn positions(
    stations: &[Station],
    stated: &[StatedPosition],
    path: &Path,
    set: UnitSet,
    place: impl Fn(usize) -> String,
) -> Vec<Note> {
    let surface = surface_doubts(path, set).into_iter();
    let surface = surface.map(|doubt| warning(&doubt, &place(doubt.index)));
    let mut notes: Vec<Note> = surface.collect();
    let checks = position_checks(stations, stated, path, set).into_iter();
    notes.extend(checks.map(|check| match check.agrees {
        true => Note::Checked(check.sentence),
        false => {
            let place = place(check.index);
            Note::Warning(format!("{} ({place}); {}", check.sentence, check.reason))
        }
    }));
    notes
}

fn warning(doubt: &StationDoubt, place: &str) -> Note {
    Note::Warning(format!("{} ({place}: {}); {}", doubt.sentence, doubt.label, doubt.help))
}

/// Notes on the doubtful turns of a survey; `place` returns the location of a station in its file.
pub(crate) fn notes(
    stations: &[Station],
    set: UnitSet,
    place: impl Fn(usize) -> String,
) -> Vec<Note> {
    let doubts = station_doubts(stations, USUAL_DOGLEG_RAD_PER_M, set);
    let mut notes: Vec<Note> =
        doubts.iter().take(NOTED).map(|doubt| warning(doubt, &place(doubt.index))).collect();
    if doubts.len() > NOTED {
        notes.push(Note::Warning(format!("{} more turns of this kind", doubts.len() - NOTED)));
    }
    notes
}

/// Units of sentences on a survey, depending on whether its lengths are in feet.
pub(crate) fn unit_set(units: &str) -> UnitSet {
    if units.contains("ft") { UnitSet::Field } else { UnitSet::Si }
}

// Notes of the reader of tables.

/// Classifies a note as information on reading or as omission of hidden contents.
pub(crate) fn table_note(text: String) -> Note {
    match text.ends_with("hidden and not read") {
        true => Note::LeftOut(text),
        false => Note::Read(text),
    }
}
