//! What was found, as a piece of a case file.

use std::{fmt::Write, fs, path::Path};

use toml_edit::{DocumentMut, Item};
use wholestring::well::HoleKind;
use wholestring_case::Case;
use wholestring_plan::calibration::{Calibration, Factors, Parameter};
use wholestring_results::{CalibrationSummary, ResultsError};

use crate::error::Error;

/// Name of the file.
pub const FRAGMENT: &str = "friction.toml";

/// Least factor along the hole beside which a case takes one around it.
const LEAST: f64 = 1e-3;

/// The factor of a section, or a table of two, as case files write it.
fn friction(section: usize, kind: HoleKind, factors: &Factors) -> String {
    let [along, around] = factors.of_section(section, kind);
    match (around - along).abs() < 5e-5 {
        true => format!("{along:.4}"),
        false => format!("{{ kinetic = {:.4}, around = {around:.4} }}", along.max(LEAST)),
    }
}

/// The sections of the first case's hole with the friction that was found, and the block's weight;
/// how they are tried without writing them in.
pub(super) fn fragment(case: &Case, summary: &CalibrationSummary, found: &Calibration) -> String {
    let factors = &found.state.factors;
    let sections = case.model.well.hole.sections();
    let mut text = format!(
        "# Friction of {} by the {} string, from {} readings of {}.\n",
        case.name,
        summary.model,
        summary.readings,
        summary.data.replace(['\n', '\r'], " ")
    );
    for of in &summary.estimates {
        let error = of
            .standard_error
            .map_or("held at zero".to_owned(), |error| format!("standard error {}", plain(error)));
        let ends = of.interval.map(|end| end.map_or("not found".to_owned(), plain));
        let [from, to] = ends;
        let percent = 100.0 * summary.confidence;
        let _ = writeln!(
            text,
            "# {} = {}, {error}, {percent:.0} %: {from} to {to}",
            of.parameter,
            plain(of.value)
        );
    }
    let weighed = summary.estimates.iter().any(|of| of.parameter == Parameter::BlockWeight.name());
    text += "#\n# Put the friction into the sections of the case's hole";
    text += if weighed { " and the block's weight under its [rig]" } else { "" };
    text += ", or try them with\n#  ";
    for (index, section) in sections.iter().enumerate() {
        let _ = write!(
            text,
            " --set 'well.hole.{index}.friction={}'",
            friction(index, section.kind, factors)
        );
    }
    if weighed {
        let _ = write!(text, " --set 'rig.block_weight={:.0} N'", found.state.block_weight_N);
    }
    text.push('\n');
    for (index, section) in sections.iter().enumerate() {
        let kind = match section.kind {
            HoleKind::Casing => "casing",
            HoleKind::Open => "open",
        };
        let _ = write!(
            text,
            "\n[[well.hole]]\nkind = \"{kind}\"\nto = \"{} m\"\ndiameter = \"{} m\"\nfriction = {}\n",
            rounded(section.to_md_m, 1e3),
            rounded(section.diameter_m, 1e6),
            friction(index, section.kind, factors)
        );
    }
    if weighed {
        let _ = write!(text, "\n[rig]\nblock_weight = \"{:.0} N\"\n", found.state.block_weight_N);
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

/// A length to the millimetre or the micrometre.
fn rounded(length_m: f64, parts_per_m: f64) -> f64 {
    (length_m * parts_per_m).round() / parts_per_m
}

/// A factor in four decimals, a force or torque in whole units.
fn plain(value: f64) -> String {
    if value.abs() < 10.0 { format!("{value:.4}") } else { format!("{value:.0}") }
}
