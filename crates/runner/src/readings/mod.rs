//! Readings at the surface, and the strings that they were made with.

mod named_case;

pub use named_case::NamedCase;

use std::{borrow::Cow, path::Path};

use wholestring_case::Override;
use wholestring_judge::{CheckKind, ReadingCheck, Severity};
use wholestring_plan::calibration::{Assembly, Channel, Reading};
use wholestring_tabular::{ImportedReading, ImportedReadings, read_readings};
use wholestring_units::{Dimension, Unit, UnitSet};

use crate::{error::Error, survey};

/// Readings with what was in the hole.
#[derive(Debug, Default, Clone)]
pub(crate) struct Readings {
    pub(crate) readings: Vec<Reading>,
    /// Where each stands in its file.
    pub(crate) places: Vec<String>,
    /// Those that take no part in the fit, and where each stands.
    pub(crate) held_out: Vec<Reading>,
    pub(crate) held_out_places: Vec<String>,
    /// Strings in their holes: one for each case, density of mud and what else a row changes.
    pub(crate) assemblies: Vec<Assembly>,
    /// Each one's case.
    pub(crate) cases: Vec<usize>,
    /// How the file was understood.
    pub(crate) notes: Vec<String>,
    /// What is to be said of the readings themselves.
    pub(crate) checks: Vec<ReadingCheck>,
    /// Units of the columns, by channel.
    pub(crate) units: [Option<&'static Unit>; Channel::ALL.len()],
}

/// Bits this near to the end of the hole are at it, m.
const ROUNDED_M: f64 = 1e-3;

/// What a file holds, or would hold.
pub(crate) fn bytes<'a>(file: &Path, content: Option<&'a [u8]>) -> Result<Cow<'a, [u8]>, Error> {
    match content {
        Some(content) => Ok(content.into()),
        None => Ok(survey::bytes(file, "readings")?.into()),
    }
}

/// Reads the bytes of a file, and finds each row's case; readings that cannot be any are left out and said.
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

/// Units in which the first case is shown.
fn units_of(cases: &[NamedCase<'_>]) -> UnitSet {
    cases.first().map_or(UnitSet::Si, |of| of.case.units)
}

/// The checks that leave no answer, as one error.
pub(crate) fn refused(name: &str, checks: &[ReadingCheck]) -> Result<(), Error> {
    let errors = checks.iter().filter(|of| of.check.severity == Severity::Error);
    let errors: Vec<&str> = errors.map(|of| of.check.sentence.as_str()).collect();
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
        let known = data.cases.iter().zip(&changes).position(|of| of == (&case, &change));
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
            within(row, half_digit_m, &data.assemblies[setup], units, &mut data.checks)
                .map_err(bad)?;
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

/// What a row changes of its case: density of the mud, kg/m³, and keys with their values.
type Changes<'a> = (Option<f64>, &'a [(String, String)]);

/// The string, the hole and the mud of a row.
fn assembly(of: &NamedCase<'_>, (density, keys): Changes<'_>) -> Result<Assembly, String> {
    let changed = match keys {
        [] => None,
        keys => {
            let own = keys.iter().map(|(key, value)| format!("{key}={value}").parse::<Override>());
            let own: Vec<Override> =
                own.collect::<Result<_, _>>().map_err(|error| error.to_string())?;
            let all = [of.overrides, &own].concat();
            Some(of.template.case(&all).map_err(|report| report.to_string())?)
        }
    };
    let case = changed.as_ref().unwrap_or(of.case);
    let mut setup = case.setup();
    if let Some(density) = density {
        setup.mud.density_kg_per_m3 = density;
    }
    Ok(Assembly::new(setup, &case.operations))
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
pub(crate) fn deepest_m(assembly: &Assembly) -> f64 {
    let well = &assembly.setup.well;
    let hole_m = well.hole.sections().last().map_or(0.0, |section| section.to_md_m);
    hole_m.min(well.path.last_md_m())
}

/// The depth of a reading's bit in its case, m: the end of the hole where the depth as it is written is rounded
/// beyond it.
fn within(
    row: &ImportedReading,
    half_digit_m: f64,
    assembly: &Assembly,
    units: UnitSet,
    checks: &mut Vec<ReadingCheck>,
) -> Result<f64, String> {
    let depth_m = row.bit_depth_m;
    let (least, most) = (assembly.setup.assembly_m(), deepest_m(assembly));
    let shown = |depth_m: f64| {
        let unit = Dimension::Length.unit_in(units);
        format!("{:.1} {}", unit.from_si(depth_m), unit.symbol)
    };
    if depth_m > most + half_digit_m.max(ROUNDED_M) {
        return Err(format!(
            "the bit is at {}, but hole and survey of its case end at {}",
            shown(depth_m),
            shown(most)
        ));
    }
    if depth_m > most + ROUNDED_M {
        let sentence = format!(
            "{}: the bit is at {}, rounded beyond the end of hole and survey at {}; taken as at the end",
            row.place,
            shown(depth_m),
            shown(most)
        );
        let check = ReadingCheck::new(CheckKind::RoundedDepth, Severity::Note, sentence);
        checks.push(check.numbers([depth_m, most].map(Some)).on(vec![row.place.clone()]));
    }
    let depth_m = depth_m.min(most);
    if depth_m <= least {
        return Err(format!(
            "the bit is at {}, but the string of its case is {} long below its drill pipe",
            shown(depth_m),
            shown(least)
        ));
    }
    Ok(depth_m)
}
