//! Torque and drag computed by Landmark: a curve to draw over a plan.

use wholestring_tabular::{ImportedReading, is_null};

use super::{
    chooser::Chosen,
    datum::Depths,
    reader::{Reader, children},
    table::Table,
    unit_set::{Found, Measure},
};
use crate::error::ImportError;

const KEYS: [&str; 4] = ["well_id", "wellbore_id", "scenario_id", "case_id"];

/// The rows of the drag chart of the chosen case, by depth.
pub(super) fn read(
    reader: &mut Reader,
    chosen: &Chosen,
    depths: Depths,
) -> Result<Vec<ImportedReading>, ImportError> {
    let Some(case) = chosen.case else { return Ok(Vec::new()) };
    let rows = children(reader.rows, Table::DragChart, case, &KEYS)?;
    let units = reader.units.clone();
    let mut readings = Vec::with_capacity(rows.len());
    let (mut without, mut nulls) = (0, 0);
    for row in rows {
        let depth = units.quantity(row, "run_depth", Measure::Length)?;
        let depth_m = depth.map_or(0.0, |depth| depth.si() + depths.shift_m);
        let load = |column| units.quantity(row, column, Measure::Force);
        let torque = |column| units.quantity(row, column, Measure::ChartTorque);
        let mut si = |found: Option<Found>| {
            let is_null = |found: &Found| is_null(found.number);
            nulls += usize::from(found.as_ref().is_some_and(is_null));
            found.filter(|found| !is_null(found)).map(Found::si)
        };
        let reading = ImportedReading {
            place: format!("line {}, WP_TDA_DRAGCHART", row.line()),
            bit_depth_m: depth_m,
            pick_up_N: si(load("to_hookload")?),
            slack_off_N: si(load("ti_hookload")?),
            rotating_N: si(load("ob_hookload")?),
            torque_N_m: si(torque("ob_torque")?),
            torque_on_bottom_N_m: si(torque("rd_torque")?),
            mud_density_kg_per_m3: None,
            case: None,
            held_out: false,
            keys: Vec::new(),
        };
        // A string that is not yet in the hole has no weight and no torque.
        match depth_m > 0.0 {
            true => readings.push(reading),
            false => without += 1,
        }
    }
    readings.sort_by(|a, b| a.bit_depth_m.total_cmp(&b.bit_depth_m));
    if nulls > 0 {
        let mean = if nulls == 1 { "means" } else { "mean" };
        reader.left_out(format!(
            "{nulls} of the values of the drag chart {mean} no value, such as -999.25"
        ));
    }
    let is_crossed = |reading: &&ImportedReading| {
        reading.pick_up_N.zip(reading.slack_off_N).is_some_and(|(up_N, down_N)| up_N < down_N)
    };
    let crossed = readings.iter().filter(is_crossed).count();
    if let Some(first) = readings.iter().find(is_crossed) {
        reader.warning(format!(
            "the to_hookload of the drag chart is below its ti_hookload in {crossed} of {} rows, \
             the first in {}: friction makes pick-up ≥ slack-off; are the two exchanged?",
            readings.len(),
            first.place
        ));
    }
    if without > 0 {
        reader.left_out(format!("{without} rows of the drag chart without a depth of the bit"));
    }
    if !readings.is_empty() {
        reader.read(format!(
            "the drag chart has {} depths: its trip out is our pick-up, its trip in our slack-off, \
             and its ob_hookload and ob_torque are taken as rotating off bottom, its rd_torque as \
             the torque on bottom",
            readings.len()
        ));
        for options in children(reader.rows, Table::DragOptions, case, &KEYS)? {
            let column = "hoist_equip_weight";
            if let Some(weight) = units.positive(options, column, Measure::Force)? {
                reader.read(format!(
                    "line {} gives the hoisting equipment a weight of {}: hook loads of the drag \
                     chart are unchanged; if they include that weight, subtract it before you \
                     compare them, because those of wholestring never do",
                    options.line(),
                    weight.text()
                ));
            }
        }
    }
    parameters(reader, chosen)?;
    Ok(readings)
}

/// Friction of the analysis, in addition to that of the hole sections.
fn parameters(reader: &mut Reader, chosen: &Chosen) -> Result<(), ImportError> {
    let Some(case) = chosen.case else { return Ok(()) };
    for row in children(reader.rows, Table::DragParameters, case, &KEYS)? {
        let columns =
            ["cof_casing_trip_out", "cof_oh_trip_out", "cof_casing_trip_in", "cof_oh_trip_in"];
        let mut values = Vec::new();
        for column in columns {
            if let Some(number) = row.number(column)?.filter(|number| *number > 0.0) {
                values.push(format!("{column} {number}"));
            }
        }
        if !values.is_empty() {
            reader.left_out(format!(
                "the friction factors of single operations in line {} ({}): those of the hole \
                 sections are used",
                row.line(),
                values.join(", ")
            ));
        }
    }
    Ok(())
}
