//! What was found, as a piece of a case file.

use std::{fmt::Write, fs, path::Path};

use toml_edit::{DocumentMut, Item};
use wholestring::well::{HoleKind, HoleSection};
use wholestring_case::{Case, MAX_FRICTION, Override};
use wholestring_judge::{CheckKind, ReadingCheck};
use wholestring_plan::calibration::{Calibration, Factors, Parameter};
use wholestring_results::{CalibrationSummary, EstimateFound, ResultsError};
use wholestring_units::{Dimension, UnitSet};

use super::checks;
use crate::{error::Error, readings::NamedCase};

/// Name of the file.
pub const FRAGMENT: &str = "friction.toml";

/// Least factor along the hole beside which a case takes one around it.
const LEAST: f64 = 1e-3;

/// Least weight of a block that is written, N: a case takes none that weighs nothing.
const LEAST_BLOCK_N: f64 = 100.0;

/// The factor of a section, or a table, as case files write it; friction at rest keeps its ratio to that along
/// the hole.
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
    let along = if is_around { along.max(LEAST) } else { along };
    let mut text = format!("{{ kinetic = {along:.4}");
    if let Some(at_rest) = at_rest {
        // Rounded, it may not be less.
        let _ = write!(text, ", static = {:.4}", at_rest.max(along));
    }
    if is_around {
        let _ = write!(text, ", around = {around:.4}");
    }
    text + " }"
}

/// The keys of the case that are given what was found, with their values.
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
    let weighed = summary.estimates.iter().any(|of| of.parameter == Parameter::BlockWeight.name());
    // A case has no block of nothing.
    if weighed && found.state.block_weight_N > LEAST_BLOCK_N {
        let unit = Dimension::Force.unit_in(units);
        let value = unit.from_si(found.state.block_weight_N);
        keys.push(("rig.block_weight".to_owned(), format!("{} {}", six(value), unit.symbol)));
    }
    keys
}

/// The sections of the first case's hole as the case writes them, with the friction that was found, and the
/// block's weight; how they are tried without writing them in. A check says where the case would refuse them.
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
    for of in &summary.estimates {
        let error = of.standard_error.map_or("held at zero".to_owned(), |error| {
            format!("standard error {}", plain(of, error, units))
        });
        let ends =
            of.interval.map(|end| end.map_or("not found".to_owned(), |end| plain(of, end, units)));
        let [from, to] = ends;
        let percent = 100.0 * summary.confidence;
        let _ = writeln!(
            text,
            "# {}: {}, {error}, {percent:.0} %: {from} to {to}",
            of.words,
            plain(of, of.value, units)
        );
    }
    if let Some(other) = &summary.comparison {
        let values = other.estimates.iter();
        let values = values.map(|of| format!("{} {}", of.words, plain(of, of.value, units)));
        let which = if other.left_out { "With" } else { "Without" };
        let _ = writeln!(
            text,
            "# {which} the {} outliers found by {}'s loss: {}",
            other.outliers.len(),
            other.loss,
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
        let reason = report.diagnostics.first().map_or(String::new(), |of| of.message.clone());
        let sentence = format!("the case does not take what {FRAGMENT} has: {reason}");
        checks::warning(CheckKind::CaseFragment, sentence)
    });
    (text, refused)
}

/// The sections as the case writes them, with their changes; nothing where its text cannot be changed so.
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
                Some(entries.map(|(key, of)| (key.to_owned(), Item::Value(of.clone()))).collect())
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

/// The keys of a case that the fragment in a folder gives what was found, each with its TOML value.
///
/// # Errors
/// A fragment that is not there, or is not one.
pub fn changes(folder: &Path) -> Result<Vec<(String, String)>, Error> {
    let path = folder.join(FRAGMENT);
    let text = fs::read_to_string(&path)
        .map_err(|source| ResultsError::Read { path: path.clone(), source })?;
    let wrong = |reason: String| ResultsError::Format { path: path.clone(), reason };
    let document: DocumentMut = text.parse().map_err(|error| wrong(format!("{error}")))?;
    let sections = document.get("well").and_then(|well| well.get("hole")?.as_array_of_tables());
    let sections = sections.ok_or_else(|| wrong("it has no [[well.hole]]".to_owned()))?;
    let given = |key: String, item: Option<&Item>| {
        Some((key, item?.as_value()?.clone().decorated("", "").to_string()))
    };
    let frictions = sections.iter().enumerate();
    let frictions = frictions.filter_map(|(place, section)| {
        given(format!("well.hole.{place}.friction"), section.get("friction"))
    });
    let block = document.get("rig").and_then(|rig| rig.get("block_weight"));
    Ok(frictions.chain(given("rig.block_weight".to_owned(), block)).collect())
}

/// A number in six digits.
fn six(value: f64) -> String {
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    wholestring_units::number_text(rounded)
}

/// A factor in four decimals; a force or torque in the case's unit.
fn plain(of: &EstimateFound, value: f64, units: UnitSet) -> String {
    let dimension = match of.parameter.as_str() {
        "block_weight_N" => Dimension::Force,
        "bit_torque_N_m" => Dimension::Torque,
        _ => return format!("{value:.4}"),
    };
    let unit = dimension.unit_in(units);
    format!("{} {}", six(unit.from_si(value)), unit.symbol)
}
