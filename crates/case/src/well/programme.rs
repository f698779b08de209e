//! The casing programme: sections that cannot have been run through those above them, and parts of
//! the string that are wider than the drift of a casing.

use wholestring::{
    string::DrillString,
    well::{Hole, HoleKind, HoleSection},
};

use wholestring_config::prelude::*;

use crate::{
    catalogue::OwnCatalogue,
    string::{component::ComponentTable, fit::od_place},
    well::hole::HoleTable,
};

/// Largest bore of a casing over that of the casing above it. Heavier walls at the top of a string
/// of 9-5/8 in casing make its lower bore 4 % wider; the next size is 10 % wider.
const TAPER: f64 = 1.08;

/// Reports casings that do not pass the section above, rock above a casing, and a drift that is wider
/// than its bore. Returns notes on the casings that are taken as liners.
pub(crate) fn check(
    hole: &Hole,
    tables: &[Spanned<HoleTable>],
    reader: &mut Reader,
) -> Vec<String> {
    let mut notes = Vec::new();
    let sections: Vec<(&HoleSection, &Spanned<HoleTable>)> =
        hole.sections().iter().zip(tables).collect();
    for (index, (section, table)) in sections.iter().enumerate() {
        if let Some(drift) = table.value.drift.given()
            && drift.value > section.diameter_m
        {
            Diagnostic::error("the drift mandrel does not pass the casing")
                .at(drift.place, width(section, reader))
                .report(reader);
        }
        if section.kind != HoleKind::Casing {
            continue;
        }
        let above = &sections[..index];
        if let Some((narrower, at)) = above.iter().find(|(above, _)| does_not_pass(section, above))
        {
            Diagnostic::error("a casing does not pass the section above it")
                .at(place(table), width(section, reader))
                .at(place(at), width(narrower, reader))
                .help("sections are listed from the surface down, each with the innermost casing at its depth")
                .report(reader);
        } else if let Some((_, at)) = above.iter().find(|(above, _)| above.kind == HoleKind::Open) {
            Diagnostic::warning("open hole is listed above a casing")
                .at(place(at), "open hole")
                .at(place(table), "casing below it")
                .help("casing that was run reaches up to the casing above or to the surface")
                .report(reader);
        } else if let Some((above, _)) = above.last() {
            notes.extend(liner(section, &table.value, above, reader));
        }
    }
    notes
}

/// Note on a casing that is narrower than the one above it, of which the case does not give the
/// upper end: sections end where the next begins, so that it is hung below the casing above.
fn liner(
    casing: &HoleSection,
    table: &HoleTable,
    above: &HoleSection,
    reader: &Reader,
) -> Option<String> {
    let is_narrower = match (casing.casing, above.casing) {
        (Some(pipe), Some(pipe_above)) => pipe.od_m < pipe_above.od_m,
        _ => TAPER * casing.diameter_m < above.diameter_m,
    };
    if !is_narrower || above.kind != HoleKind::Casing || table.from.given().is_some() {
        return None;
    }
    let name = match table.casing.given() {
        Some(name) => short(name.value.split_once(" in ").map_or(&name.value, |(size, _)| size)),
        None => reader.shown(Dimension::Diameter, casing.diameter_m),
    };
    let name = match table.casing.given() {
        Some(whole) if whole.value.contains(" in ") => format!("{name} in casing"),
        Some(_) => format!("casing `{name}`"),
        None => format!("casing with a bore of {name}"),
    };
    let from = reader.shown(Dimension::Length, casing.from_md_m);
    Some(format!(
        "{name} is taken from {from} down, as a liner is; where it reaches the surface, leave out \
         the sections above it; where it is a liner, from = \"{from}\" in its section confirms it"
    ))
}

/// Whether a casing is too wide for a section above it. Sections of one casing string, whose walls
/// differ, have the same outside diameter.
fn does_not_pass(casing: &HoleSection, above: &HoleSection) -> bool {
    let od_m = |section: &HoleSection| section.casing.map(|pipe| pipe.od_m);
    match (od_m(casing), od_m(above)) {
        (Some(od_m), Some(above_od_m)) => {
            od_m > above_od_m || (od_m < above_od_m && od_m > above.diameter_m)
        }
        (Some(od_m), None) if above.kind == HoleKind::Open => od_m > above.diameter_m,
        _ => casing.diameter_m > TAPER * above.diameter_m,
    }
}

/// Diameters that differ by less are equal, m: drifts are tabulated to a thousandth of an inch.
const SAME_M: f64 = 1.3e-5;

/// Warns of parts of the string that are wider than the drift mandrel of a casing they pass.
pub(crate) fn check_drift(
    string: &DrillString,
    components: &[Spanned<ComponentTable>],
    hole: &Hole,
    tables: &[Spanned<HoleTable>],
    own: &OwnCatalogue,
    reader: &mut Reader,
) {
    let bit_depth_m = string.length_m();
    for (span, component) in string.spans().zip(components) {
        let od_m = 2.0 * span.component.contact_radius_m();
        let bottom_md_m = bit_depth_m - span.from_bit_m;
        let passed = hole.sections().iter().zip(tables);
        let tight = passed.filter(|(section, _)| section.from_md_m < bottom_md_m).find_map(
            |(section, table)| {
                let (drift_m, place) = drift(&table.value, own)?;
                (od_m > drift_m + SAME_M && od_m <= section.diameter_m).then_some((
                    drift_m,
                    section.diameter_m,
                    place,
                ))
            },
        );
        let Some((drift_m, bore_m, place)) = tight else { continue };
        let diameter = |m: f64| reader.shown(Dimension::Diameter, m);
        let [od, drift, bore] = [od_m, drift_m, bore_m].map(diameter);
        Diagnostic::warning(format!(
            "`{}` is wider than the drift of a casing that it passes",
            short(&span.component.name)
        ))
        .at(od_place(component, span.component.joints.is_some()), format!("{od} across"))
        .at(place, format!("drift {drift}, bore {bore}"))
        .help("for a casing of a special drift, give its `drift`")
        .report(reader);
    }
}

/// Drift diameter of a casing, m, and the key that gives it; `None` where it is not known.
fn drift(table: &HoleTable, own: &OwnCatalogue) -> Option<(f64, Span)> {
    if let Some(drift) = table.drift.given() {
        return Some((drift.value, drift.place));
    }
    let name = table.casing.given()?;
    own.find_casing(&name.value).ok().map(|casing| (casing.drift_m, name.place))
}

fn width(section: &HoleSection, reader: &Reader) -> String {
    let diameter = |m: f64| reader.shown(Dimension::Diameter, m);
    match (section.kind, section.casing) {
        (HoleKind::Casing, Some(pipe)) => {
            format!(
                "outside diameter {}, bore {}",
                diameter(pipe.od_m),
                diameter(section.diameter_m)
            )
        }
        (HoleKind::Casing, None) => format!("bore {}", diameter(section.diameter_m)),
        (HoleKind::Open, _) => format!("hole of {}", diameter(section.diameter_m)),
    }
}

/// Place of the key that gives the width of a section.
fn place(table: &Spanned<HoleTable>) -> Span {
    let casing = table.value.casing.given().map(|name| name.place);
    casing.or(table.value.diameter_place()).unwrap_or(table.place)
}
