//! The lines of a case file.

use std::fmt::Write;

use wholestring_tabular::under_origin;
use wholestring_units::{Dimension, UnitSet};

use super::complete::Missing;
use crate::{
    fragment::{Block, Entry, Note, Origin, Part, Survey, Value, rounded},
    merge::{Draft, Sourced},
};

/// Column in which comments begin.
const COMMENTS: usize = 40;

/// The whole case file.
pub(crate) fn text(draft: &Draft, missing: &[Missing]) -> String {
    let mut text = head(draft, missing);
    let lacks = |part: Part| missing.iter().find(|missing| missing.part == part);
    match &draft.name {
        Some(name) => entry(&mut text, draft, name.file, &name.item),
        None => line(&mut text, "name", "\"Imported well\"", "no file names the well"),
    }
    line(&mut text, "model", "\"soft\"", "or \"stiff\", \"dynamic\", or a list of them");
    let set = shown_units(draft);
    let units = format!("\"{}\"", set.name());
    line(&mut text, "units", &units, "units of results: \"si\", \"metric\" or \"field\"");

    text.push_str("\n[well]\n");
    match (&draft.survey, lacks(Part::Survey)) {
        (Some(Sourced { file, item }), _) => survey(&mut text, *file, item, set),
        (None, lacking) => example(&mut text, lacking),
    }
    match &draft.hole {
        Some(hole) => blocks(&mut text, draft, "well.hole", hole),
        None => example(&mut text, lacks(Part::Hole)),
    }
    table(&mut text, draft, "mud", &draft.mud);
    example(&mut text, lacks(Part::Mud));
    if let Some(string) = &draft.string {
        blocks(&mut text, draft, "string", string);
    }
    // The whole string, or the pipe above an assembly.
    example(&mut text, lacks(Part::String));
    table(&mut text, draft, "bit", &draft.bit);
    table(&mut text, draft, "rig", &draft.rig);
    table(&mut text, draft, "operation", &draft.operation);
    text
}

/// Head of the file: its sources, assumptions and omissions.
fn head(draft: &Draft, missing: &[Missing]) -> String {
    let mut text = String::from("# Imported from\n");
    for (index, (name, what)) in draft.files.iter().enumerate() {
        let _ = writeln!(text, "#   [{}] {}: {}", index + 1, plain(name), plain(what));
    }
    text.push_str(
        "# Values are as found in the files, in their units; the comment after each gives its \
         file and place.\n",
    );
    for kind in ["warning", "assumed", "left out", "checked", "read"] {
        let of_kind: Vec<&(Option<usize>, Note)> =
            draft.notes.iter().filter(|(_, note)| note.kind() == kind).collect();
        if of_kind.is_empty() {
            continue;
        }
        let _ = writeln!(text, "#\n# {}{}:", kind[..1].to_uppercase(), &kind[1..]);
        for (file, note) in of_kind {
            let file = file.map_or(String::new(), |file| format!("[{}] ", file + 1));
            let _ = writeln!(text, "#   {file}{}", plain(note.text()));
        }
    }
    if !missing.is_empty() {
        text.push_str("#\n# Missing, and to be filled in below:\n");
        for missing in missing {
            let _ = writeln!(text, "#   {}", missing.sentence);
        }
    }
    text.push('\n');
    text
}

/// Units of the case: field units if the files use feet, or pounds for measured weights.
pub(super) fn shown_units(draft: &Draft) -> UnitSet {
    let survey = draft.survey.iter().map(|survey| survey.item.units.as_str());
    let blocks = [&draft.hole, &draft.string].into_iter().flatten();
    let values = blocks.flat_map(|block| &block.item).flat_map(|block| &block.entries);
    let in_feet = values.filter(|entry| {
        let feet = Dimension::Length.unit_in(UnitSet::Field);
        matches!(&entry.value, Value::Quantity { unit, .. } if unit.symbol == feet.symbol)
    });
    let feet = in_feet.count() > 0 || survey.into_iter().any(|units| units.contains("ft"));
    if feet || draft.units == Some(UnitSet::Field) { UnitSet::Field } else { UnitSet::Si }
}

/// The stations: depths in the unit of their file, angles in degrees.
fn survey(text: &mut String, file: usize, survey: &Survey, set: UnitSet) {
    let place = match survey.place.is_empty() {
        true => String::new(),
        false => format!(", {}", plain(&survey.place)),
    };
    let found = survey.units.split(',').next().and_then(|unit| Dimension::Length.find_unit(unit));
    let unit = found.unwrap_or(Dimension::Length.unit_in(set));
    // A bare number is in metres, which causes a warning where other units are shown.
    let is_bare = set == UnitSet::Si && unit.factor == 1.0;
    let _ = writeln!(text, "# measured depth, inclination and azimuth; angles in deg");
    let _ = writeln!(text, "{:<COMMENTS$} # [{}]{place}", "stations = [", file + 1);
    for station in &survey.stations {
        let md = rounded(unit.from_si(station.md_m));
        let md = if is_bare { md.to_string() } else { format!("\"{md} {}\"", unit.symbol) };
        let angles = [station.inclination_rad, station.azimuth_rad];
        let [inc, azi] = angles.map(|angle| rounded(angle.to_degrees()));
        let _ = writeln!(text, "    [{md}, {inc}, {azi}],");
    }
    text.push_str("]\n");
    line(text, "path", "\"minimum-curvature\"", "arcs, as the positions of a survey are computed");
    // By default, the first station is vertically below the origin.
    let tie_in = survey.tie_in.filter(|tie_in| *tie_in != under_origin(&survey.stations));
    if let Some(tie_in) = tie_in {
        text.push_str("\n[well.tie_in]\n");
        let values = [("north", tie_in.north_m), ("east", tie_in.east_m), ("tvd", tie_in.tvd_m)];
        for (key, value_m) in values {
            line(text, key, &format!("\"{} m\"", rounded(value_m)), &format!("[{}]", file + 1));
        }
    }
}

/// Writes a list of tables.
fn blocks(
    text: &mut String,
    draft: &Draft,
    name: &str,
    Sourced { file, item }: &Sourced<Vec<Block>>,
) {
    for block in item {
        let _ = writeln!(text, "\n[[{name}]]");
        if let Some(remark) = &block.remark {
            let _ = writeln!(text, "# {}", plain(remark));
        }
        for one in &block.entries {
            entry(text, draft, *file, one);
        }
    }
}

/// Writes a table of keys, if there are any.
fn table(text: &mut String, draft: &Draft, name: &str, entries: &[Sourced<Entry>]) {
    if entries.is_empty() {
        return;
    }
    let _ = writeln!(text, "\n[{name}]");
    for one in entries {
        entry(text, draft, one.file, &one.item);
    }
}

/// Writes a key, its value and its origin.
fn entry(text: &mut String, draft: &Draft, file: usize, entry: &Entry) {
    let mark = match draft.files.len() {
        1 => String::new(),
        _ => format!("[{}] ", file + 1),
    };
    let comment = match &entry.origin {
        Origin::Found { place, written: None } => format!("{mark}{place}"),
        Origin::Found { place, written: Some(written) } => format!("{mark}{place}: '{written}'"),
        Origin::Derived { from } => format!("{mark}{from}"),
        Origin::Assumed { because } => format!("assumed: {because}"),
    };
    line(text, entry.key, &entry.value.toml(), &comment);
}

fn line(text: &mut String, key: &str, value: &str, comment: &str) {
    let pair = format!("{key} = {value}");
    let _ = writeln!(text, "{pair:<COMMENTS$} # {}", plain(comment));
}

/// Writes a missing part as comments to fill in.
fn example(text: &mut String, missing: Option<&Missing>) {
    let Some(missing) = missing else { return };
    let _ = writeln!(text, "\n# Missing: {}", missing.sentence);
    for line in missing.example.lines() {
        let _ = writeln!(text, "# {line}");
    }
}

/// A text without line ends, which would end its comment.
fn plain(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}
