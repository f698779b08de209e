//! Readings at the surface, and the strings that they belong to.

use std::{borrow::Cow, path::Path};

use wholestring_case::{Case, Override, Template};
use wholestring_judge::{CheckKind, Quantity, ReadingCheck, Rounding, Severity, Wording};
use wholestring_plan::calibration::{Assembly, Channel, Reading};
use wholestring_tabular::{ImportedReading, ImportedReadings, read_readings};
use wholestring_units::{Dimension, Unit, UnitSet};

use crate::{error::Error, survey};

/// Readings with the strings in the hole.
#[derive(Debug, Default, Clone)]
pub(crate) struct Readings {
    pub(crate) readings: Vec<Reading>,
    /// Position of each in its file.
    pub(crate) places: Vec<String>,
    /// Readings that are not part of the fit, and their positions.
    pub(crate) held_out: Vec<Reading>,
    pub(crate) held_out_places: Vec<String>,
    /// Strings in their holes: one for each combination of case, mud density and other changes of a
    /// row.
    pub(crate) assemblies: Vec<Assembly>,
    /// Case of each.
    pub(crate) cases: Vec<usize>,
    /// Interpretation of the file.
    pub(crate) notes: Vec<String>,
    /// Checks of the readings themselves.
    pub(crate) checks: Vec<ReadingCheck>,
    /// Units of the columns, by channel.
    pub(crate) units: [Option<&'static Unit>; Channel::ALL.len()],
}

/// Bit depths within this distance of the end of the hole are equal to it, m.
const ROUNDED_M: f64 = 1e-3;

/// Content of a file, from the disk or from memory.
pub(crate) fn bytes<'a>(file: &Path, content: Option<&'a [u8]>) -> Result<Cow<'a, [u8]>, Error> {
    match content {
        Some(content) => Ok(content.into()),
        None => Ok(survey::bytes(file, "readings")?.into()),
    }
}

/// Reads the bytes of a file and finds the case of each row; impossible readings are left out and
/// reported.
pub(crate) fn read(file: &Path, bytes: &[u8], cases: &[NamedCase<'_>]) -> Result<Readings, Error> {
    let name = file.display().to_string();
    let imported = read_readings(bytes, &name).map_err(|error| survey::explained(&error))?;
    let (imported, checks) = imported.measured(units_of(cases));
    refused(&name, &checks)?;
    let ImportedReadings { readings, notes, half_digit_m, units } = imported;
    let mut data = of_rows(&name, &readings, half_digit_m, cases)?;
    data.checks.splice(0..0, checks);
    Ok(Readings { notes, units, ..data })
}

/// Units of the first case.
fn units_of(cases: &[NamedCase<'_>]) -> UnitSet {
    cases.first().map_or(UnitSet::Si, |case| case.case.units)
}

/// The checks with severity error as one error.
pub(crate) fn refused(name: &str, checks: &[ReadingCheck]) -> Result<(), Error> {
    let errors = checks.iter().filter(|check| check.check.severity == Severity::Error);
    let errors: Vec<&str> = errors.map(|error| error.check.sentence.as_str()).collect();
    match errors[..] {
        [] => Ok(()),
        _ => Err(Error::BadInput(format!("{name}: {}", errors.join("\n")))),
    }
}

/// Finds the case of each row of a file.
pub(crate) fn of_rows(
    name: &str,
    rows: &[ImportedReading],
    half_digit_m: f64,
    cases: &[NamedCase<'_>],
) -> Result<Readings, Error> {
    let mut data = Readings::default();
    let mut changes: Vec<Changes<'_>> = Vec::new();
    for row in rows {
        let bad = |reason: String| Error::BadInput(format!("{name}, {}: {reason}", row.place));
        let case = of_row(row, cases).map_err(bad)?;
        let change: Changes<'_> = (row.mud_density_kg_per_m3, &row.keys);
        let known = data
            .cases
            .iter()
            .zip(&changes)
            .position(|known_change| known_change == (&case, &change));
        let setup = match known {
            Some(setup) => setup,
            None => {
                data.assemblies.push(assembly(&cases[case], change).map_err(bad)?);
                data.cases.push(case);
                changes.push(change);
                data.cases.len() - 1
            }
        };
        let units = cases[case].case.units;
        let bit_depth_m =
            match within(row, half_digit_m, &data.assemblies[setup], units, &mut data.checks) {
                Ok(bit_depth_m) => bit_depth_m,
                Err(reason) if row.held_out => {
                    let sentence =
                        format!("{}: {reason}; the row is not used and left out", row.place);
                    let kind = CheckKind::NoReadings;
                    let check = ReadingCheck::new(kind, Severity::Warning, sentence);
                    data.checks.push(check.on(vec![row.place.clone()]));
                    continue;
                }
                Err(reason) => return Err(bad(reason)),
            };
        let values = [
            row.pick_up_N,
            row.slack_off_N,
            row.rotating_N,
            row.torque_N_m,
            row.torque_on_bottom_N_m,
        ];
        for (channel, value) in Channel::ALL.into_iter().zip(values) {
            let Some(value) = value else { continue };
            let (readings, places) = match row.held_out {
                false => (&mut data.readings, &mut data.places),
                true => (&mut data.held_out, &mut data.held_out_places),
            };
            readings.push(Reading { setup, bit_depth_m, channel, value });
            places.push(row.place.clone());
        }
    }
    Ok(data)
}

/// Changes of the case in a row: mud density, kg/m³, and keys with their values.
type Changes<'a> = (Option<f64>, &'a [(String, String)]);

/// String, hole and mud of a row.
fn assembly(named: &NamedCase<'_>, (density, keys): Changes<'_>) -> Result<Assembly, String> {
    let changed = match keys {
        [] => None,
        keys => {
            let own = keys.iter().map(|(key, value)| format!("{key}={value}").parse::<Override>());
            let own: Vec<Override> =
                own.collect::<Result<_, _>>().map_err(|error| error.to_string())?;
            let all = [named.overrides, &own].concat();
            Some(named.template.case(&all).map_err(|report| report.to_string())?)
        }
    };
    let case = changed.as_ref().unwrap_or(named.case);
    let mut setup = case.setup();
    if let Some(density) = density {
        setup.mud.density_kg_per_m3 = density;
    }
    Ok(Assembly::new(setup, &case.operations))
}

/// Case of a row, by the name of the case or of its file.
fn of_row(row: &ImportedReading, cases: &[NamedCase<'_>]) -> Result<usize, String> {
    let names = || {
        let names = cases.iter().map(|case| format!("'{}' ({})", case.case.name, case.file));
        names.collect::<Vec<_>>().join(", ")
    };
    let Some(name) = &row.case else {
        return match cases {
            [_] => Ok(0),
            _ => Err(format!("it names no case: give a column `case` with one of {}", names())),
        };
    };
    let is = |case: &NamedCase<'_>| {
        [&case.case.name, &case.file].iter().any(|known| known.eq_ignore_ascii_case(name))
    };
    let found = cases.iter().position(is);
    found.ok_or_else(|| format!("there is no case '{name}'; expected one of {}", names()))
}

/// Deepest bit of a string, m.
pub(crate) fn deepest_m(assembly: &Assembly) -> f64 {
    let well = &assembly.setup.well;
    let hole_m = well.hole.sections().last().map_or(0.0, |section| section.to_md_m);
    hole_m.min(well.path.last_md_m())
}

/// Bit depth of a reading in its case, m: the end of the hole if the written depth exceeds it by
/// rounding.
fn within(
    row: &ImportedReading,
    half_digit_m: f64,
    assembly: &Assembly,
    units: UnitSet,
    checks: &mut Vec<ReadingCheck>,
) -> Result<f64, String> {
    let depth_m = row.bit_depth_m;
    let (least, most) = (assembly.setup.assembly_m(), deepest_m(assembly));
    let depth = |depth_m: f64| Quantity::new(Dimension::Length, depth_m, Rounding::OneDecimal);
    let text = |depth_m: f64| Wording::from(depth(depth_m).to_string()).in_units(units);
    if depth_m > most + half_digit_m.max(ROUNDED_M) {
        return Err(format!(
            "the bit is at {}, but hole and survey of its case end at {}",
            text(depth_m),
            text(most)
        ));
    }
    if depth_m > most + ROUNDED_M {
        let sentence = format!(
            "{}: the bit is at {}, rounded beyond the end of hole and survey at {}; taken as at the end",
            row.place,
            depth(depth_m),
            depth(most)
        );
        let check =
            ReadingCheck::new(CheckKind::RoundedDepth, Severity::Note, sentence).in_units(units);
        checks.push(check.numbers([depth_m, most].map(Some)).on(vec![row.place.clone()]));
    }
    let depth_m = depth_m.min(most);
    if depth_m <= least {
        return Err(format!(
            "the bit is at {}, but the string of its case is {} long below its drill pipe",
            text(depth_m),
            text(least)
        ));
    }
    Ok(depth_m)
}

// A case and the name of its file.

/// A case with the name of its file, without extension.
#[derive(Debug, Clone)]
pub struct NamedCase<'a> {
    /// Name of its file.
    pub file: String,
    /// Text of the case, which is read again with the changes of a row of readings.
    pub template: &'a Template,
    /// Changes of the case for all rows.
    pub overrides: &'a [Override],
    /// The case.
    pub case: &'a Case,
}
