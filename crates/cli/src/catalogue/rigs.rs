//! Top drives and hoists as tables, in ascending order of their common values.

use wholestring::rig::catalogue::{HoistClass, Span, TopDriveClass};
use wholestring_units::{Dimension, Unit, UnitSet};

use super::cells::{heading, number, units_of};
use crate::screen_table::Table;

pub(super) fn top_drives(classes: &[TopDriveClass], units: UnitSet) -> String {
    let [force, torque, speed] =
        units_of([Dimension::Force, Dimension::Torque, Dimension::RotarySpeed], units);
    let headings = [
        "class".to_owned(),
        heading("carries", force),
        heading("rated torque", torque),
        heading("peak torque", torque),
        heading("highest speed", speed),
    ];
    let headings: Vec<&str> = headings.iter().map(String::as_str).collect();
    let mut table = Table::new("Top drives (typical)", 1, &headings);
    for class in classes {
        table.row(vec![
            class.designation.clone(),
            number(force, class.capacity_N),
            span(torque, class.torque_N_m),
            span(torque, class.peak_torque_N_m),
            span(speed, class.highest_speed_rad_per_s),
        ]);
    }
    table.text()
}

pub(super) fn hoists(classes: &[HoistClass], units: UnitSet) -> String {
    let force = Dimension::Force.unit_in(units);
    let headings = [
        "class".to_owned(),
        heading("carries", force),
        heading("pushes", force),
        heading("block and top drive", force),
    ];
    let headings: Vec<&str> = headings.iter().map(String::as_str).collect();
    let mut table = Table::new("Hoists (typical)", 1, &headings);
    let known = |range: Option<Span>| range.map_or("–".to_owned(), |range| span(force, range));
    for class in classes {
        table.row(vec![
            class.designation.clone(),
            span(force, class.capacity_N),
            known(class.snubbing_force_N),
            known(class.block_weight_N),
        ]);
    }
    table.text()
}

fn span(unit: &Unit, span: Span) -> String {
    let [least, most] = [span.least, span.most].map(|si| number(unit, si));
    if least == most { least } else { format!("{least} – {most}") }
}
