//! Result of a calibration as a fragment of a case file.

use std::{fmt::Write, fs, path::Path};

use toml_edit::{DocumentMut, Item};
use wholestring::well::{HoleKind, HoleSection};
use wholestring_case::{Case, MAX_FRICTION, Override};
use wholestring_judge::{CheckKind, ReadingCheck};
use wholestring_plan::calibration::{Calibration, Factors, Parameter};
use wholestring_results::{CalibrationSummary, EstimateFound, ResultsError};
use wholestring_units::{Dimension, UnitSet, significant};

use super::checks;
use crate::{error::Error, readings::NamedCase};

/// Name of the file.
pub const FRAGMENT: &str = "friction.toml";

/// Smallest axial friction factor for which a case accepts a rotational one.
const MIN_AXIAL_FRICTION: f64 = 1e-3;

/// Smallest block weight that is written, N, because a case accepts no zero weight.
const MIN_BLOCK_N: f64 = 100.0;

/// The factor of a section, or a table, in the syntax of case files; static friction keeps its
/// ratio to axial friction.
fn friction(index: usize, section: &HoleSection, factors: &Factors) -> String {
    let [along, around] = factors.of_section(index, section.kind);
    let own = section.friction;
    let at_rest = match own.kinetic > 0.0 && own.at_rest > own.kinetic {
        true => Some((along * own.at_rest / own.kinetic).min(MAX_FRICTION)),
        false => None,
    };
    let is_around = (around - along).abs() >= 5e-5;
    if at_rest.is_none() && !is_around {
        return format!("{along:.4}");
    }
    let along = if is_around { along.max(MIN_AXIAL_FRICTION) } else { along };
    let mut text = format!("{{ kinetic = {along:.4}");
    if let Some(at_rest) = at_rest {
        // After rounding, static friction may not be less than kinetic friction.
        let _ = write!(text, ", static = {:.4}", at_rest.max(along));
    }
    if is_around {
        let _ = write!(text, ", around = {around:.4}");
    }
    text + " }"
}

/// Keys of the case that are set to results, with their values.
fn found_keys(
    case: &Case,
    summary: &CalibrationSummary,
    found: &Calibration,
    units: UnitSet,
) -> Vec<(String, String)> {
    let sections = case.model.well.hole.sections().iter().enumerate();
    let mut keys: Vec<(String, String)> = sections
        .map(|(index, section)| {
            (format!("well.hole.{index}.friction"), friction(index, section, &found.state.factors))
        })
        .collect();
    let weighed = summary
        .estimates
        .iter()
        .any(|estimate| estimate.parameter == Parameter::BlockWeight.name());
    // A case cannot have a block of zero weight.
    if weighed && found.state.block_weight_N > MIN_BLOCK_N {
        let unit = Dimension::Force.unit_in(units);
        let value = unit.from_si(found.state.block_weight_N);
        keys.push(("rig.block_weight".to_owned(), format!("{} {}", six(value), unit.symbol)));
    }
    keys
}

/// Sections of the first case's hole in the text of the case, with the fitted friction and block
/// weight, and the command to try them without editing the case. A check reports values that the
/// case would refuse.
pub(super) fn fragment(
    first: &NamedCase<'_>,
    summary: &CalibrationSummary,
    found: &Calibration,
    units: UnitSet,
) -> (String, Option<ReadingCheck>) {
    let case = first.case;
    let keys = found_keys(case, summary, found, units);
    let one_line = |text: &str| text.replace(|c: char| c.is_control(), " ");
    let mut text = format!(
        "# Friction of {} by the {} string, from {} readings of {}.\n",
        one_line(&case.name),
        summary.model,
        summary.readings,
        one_line(&summary.data)
    );
    for estimate in &summary.estimates {
        let error = estimate.standard_error.map_or("held at zero".to_owned(), |error| {
            format!("standard error {}", plain(estimate, error, units))
        });
        let ends = estimate
            .interval
            .map(|end| end.map_or("not found".to_owned(), |end| plain(estimate, end, units)));
        let [from, to] = ends;
        let percent = 100.0 * summary.confidence;
        let _ = writeln!(
            text,
            "# {}: {}, {error}, {percent:.0} %: {from} to {to}",
            estimate.words,
            plain(estimate, estimate.value, units)
        );
    }
    if let Some(other) = &summary.comparison {
        let values = other.estimates.iter();
        let values =
            values.map(|value| format!("{} {}", value.words, plain(value, value.value, units)));
        let which = if other.left_out { "With" } else { "Without" };
        let _ = writeln!(
            text,
            "# {which} outliers ({}): {}",
            other.outliers.join(", "),
            values.collect::<Vec<_>>().join(", ")
        );
    }
    let weighed = keys.iter().any(|(key, _)| key == "rig.block_weight");
    text += "#\n# Put the friction into the sections of the case's hole";
    text += if weighed { " and the block's weight under its [rig]" } else { "" };
    text += ", or try them with\n#  ";
    for (key, value) in &keys {
        let _ = write!(text, " --set '{key}={value}'");
    }
    text.push('\n');
    let changes: Vec<Override> =
        keys.iter().filter_map(|(key, value)| format!("{key}={value}").parse().ok()).collect();
    let changes = [first.overrides, &changes].concat();
    text += &written(first, &changes).unwrap_or_else(|| from_model(case, &found.state.factors));
    if let Some((_, block)) = keys.iter().find(|(key, _)| key == "rig.block_weight") {
        let _ = write!(text, "\n[rig]\nblock_weight = \"{block}\"\n");
    }
    let refused = first.template.case(&changes).err().map(|report| {
        let reason = report
            .diagnostics
            .first()
            .map_or(String::new(), |diagnostic| diagnostic.message.clone());
        let sentence = format!("the case would refuse the values in {FRAGMENT}: {reason}");
        checks::warning(CheckKind::CaseFragment, sentence)
    });
    (text, refused)
}

/// The sections in the text of the case, with their changes; `None` if its text cannot be changed
/// this way.
fn written(first: &NamedCase<'_>, changes: &[Override]) -> Option<String> {
    let text = first.template.text(changes).ok()?;
    let document: DocumentMut = text.parse().ok()?;
    let hole = document.get("well")?.get("hole")?;
    let sections: Vec<Vec<(String, Item)>> = match hole {
        Item::ArrayOfTables(tables) => tables
            .iter()
            .map(|table| table.iter().map(|(key, item)| (key.to_owned(), item.clone())).collect())
            .collect(),
        other => other
            .as_array()?
            .iter()
            .map(|section| {
                let table = section.as_inline_table()?;
                let entries = table.iter();
                Some(
                    entries
                        .map(|(key, entry)| (key.to_owned(), Item::Value(entry.clone())))
                        .collect(),
                )
            })
            .collect::<Option<_>>()?,
    };
    let mut text = String::new();
    for section in sections {
        text += "\n[[well.hole]]\n";
        for (key, item) in section {
            let value = item.into_value().ok()?.decorated("", "");
            let _ = writeln!(text, "{key} = {value}");
        }
    }
    Some(text)
}

/// The sections in SI, from the model.
fn from_model(case: &Case, factors: &Factors) -> String {
    let mut text = String::new();
    for (index, section) in case.model.well.hole.sections().iter().enumerate() {
        let kind = match section.kind {
            HoleKind::Casing => "casing",
            HoleKind::Open => "open",
        };
        let _ = write!(
            text,
            "\n[[well.hole]]\nkind = \"{kind}\"\nto = \"{} m\"\ndiameter = \"{} m\"\nfriction = {}\n",
            section.to_md_m,
            section.diameter_m,
            friction(index, section, factors)
        );
    }
    text
}

/// Keys of a case that the fragment in a folder sets to results, each with its TOML value.
///
/// # Errors
/// The fragment does not exist, or is invalid.
pub fn changes(folder: &Path) -> Result<Vec<(String, String)>, Error> {
    let path = folder.join(FRAGMENT);
    let text = fs::read_to_string(&path)
        .map_err(|source| ResultsError::Read { path: path.clone(), source })?;
    let wrong = |reason: String| ResultsError::Format { path: path.clone(), reason };
    let document: DocumentMut = text.parse().map_err(|error| wrong(format!("{error}")))?;
    let sections = document.get("well").and_then(|well| well.get("hole")?.as_array_of_tables());
    let sections = sections.ok_or_else(|| wrong("it has no [[well.hole]]".to_owned()))?;
    let entry = |key: String, item: Option<&Item>| {
        Some((key, item?.as_value()?.clone().decorated("", "").to_string()))
    };
    let frictions = sections.iter().enumerate();
    let frictions = frictions.filter_map(|(place, section)| {
        entry(format!("well.hole.{place}.friction"), section.get("friction"))
    });
    let block = document.get("rig").and_then(|rig| rig.get("block_weight"));
    Ok(frictions.chain(entry("rig.block_weight".to_owned(), block)).collect())
}

/// A number in six digits.
fn six(value: f64) -> String {
    wholestring_units::number_text(significant(value, 6))
}

/// A factor in four decimals; a force or torque in the case's unit.
fn plain(estimate: &EstimateFound, value: f64, units: UnitSet) -> String {
    let dimension = match estimate.parameter.as_str() {
        "block_weight_N" => Dimension::Force,
        "bit_torque_N_m" => Dimension::Torque,
        _ => return format!("{value:.4}"),
    };
    let unit = dimension.unit_in(units);
    format!("{} {}", six(unit.from_si(value)), unit.symbol)
}
