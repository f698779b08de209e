//! Readings, and the strings that they were made with.

use std::path::Path;

use wholestring_plan::calibration::{Assembly, Channel, Reading};
use wholestring_survey::{ImportedReading, ImportedReadings, read_readings};

use super::named_case::NamedCase;
use crate::{error::Error, survey};

/// Readings with what was in the hole.
pub(super) struct Data {
    pub(super) readings: Vec<Reading>,
    /// Where each stands in its file.
    pub(super) places: Vec<String>,
    /// Strings in their holes: one for each case and density of mud.
    pub(super) assemblies: Vec<Assembly>,
    /// Each one's case.
    pub(super) cases: Vec<usize>,
    /// How the file was understood.
    pub(super) notes: Vec<String>,
}

/// Bits this near to the end of the hole are at it, m.
const ROUNDED_M: f64 = 1e-3;

/// Reads a file and finds each row's case.
pub(super) fn read(file: &Path, cases: &[NamedCase<'_>]) -> Result<Data, Error> {
    let name = file.display().to_string();
    let bytes = survey::bytes(file, "readings")?;
    let ImportedReadings { readings: rows, notes } =
        read_readings(&bytes, &name).map_err(|error| survey::explained(&error))?;
    let mut data = Data {
        readings: Vec::new(),
        places: Vec::new(),
        assemblies: Vec::new(),
        cases: Vec::new(),
        notes,
    };
    let mut densities: Vec<Option<f64>> = Vec::new();
    for row in &rows {
        let bad = |reason: String| Error::BadInput(format!("{name}, {}: {reason}", row.place));
        let case = of_row(row, cases).map_err(bad)?;
        let density = row.mud_density_kg_per_m3;
        let known = data.cases.iter().zip(&densities).position(|of| of == (&case, &density));
        let setup = known.unwrap_or_else(|| {
            let mut setup = cases[case].case.setup();
            if let Some(density) = density {
                setup.mud.density_kg_per_m3 = density;
            }
            data.assemblies.push(Assembly::new(setup, &cases[case].case.operations));
            data.cases.push(case);
            densities.push(density);
            data.cases.len() - 1
        });
        within(row.bit_depth_m, &data.assemblies[setup]).map_err(bad)?;
        let values = [
            row.pick_up_N,
            row.slack_off_N,
            row.rotating_N,
            row.torque_N_m,
            row.torque_on_bottom_N_m,
        ];
        for (channel, value) in Channel::ALL.into_iter().zip(values) {
            let Some(value) = value else { continue };
            let bit_depth_m = row.bit_depth_m;
            data.readings.push(Reading { setup, bit_depth_m, channel, value });
            data.places.push(row.place.clone());
        }
    }
    Ok(data)
}

/// The case of a row, by the name of the case or of its file.
fn of_row(row: &ImportedReading, cases: &[NamedCase<'_>]) -> Result<usize, String> {
    let names = || {
        let names = cases.iter().map(|of| format!("'{}' ({})", of.case.name, of.file));
        names.collect::<Vec<_>>().join(", ")
    };
    let Some(name) = &row.case else {
        return match cases {
            [_] => Ok(0),
            _ => Err(format!("it does not say its case: a column `case` names one of {}", names())),
        };
    };
    let is = |of: &NamedCase<'_>| {
        [&of.case.name, &of.file].iter().any(|known| known.eq_ignore_ascii_case(name))
    };
    let found = cases.iter().position(is);
    found.ok_or_else(|| format!("no case is called '{name}'; there are {}", names()))
}

/// The deepest that the bit of a string can be, m.
pub(super) fn deepest_m(assembly: &Assembly) -> f64 {
    let well = &assembly.setup.well;
    let hole_m = well.hole.sections().last().map_or(0.0, |section| section.to_md_m);
    hole_m.min(well.path.last_md_m())
}

fn within(depth_m: f64, assembly: &Assembly) -> Result<(), String> {
    let (least, most) = (assembly.setup.shallowest_m(), deepest_m(assembly));
    if depth_m > most + ROUNDED_M {
        return Err(format!(
            "the bit is at {depth_m:.1} m, but hole and survey of its case end at {most:.1} m"
        ));
    }
    if depth_m <= least {
        return Err(format!(
            "the bit is at {depth_m:.1} m, but the string of its case is {least:.1} m long below its \
             topmost component"
        ));
    }
    Ok(())
}
