//! The components one above the other, as long as the bit is deep.

use wholestring::{
    rig::Rig,
    string::{
        AssemblyError, ComponentLength, ComponentSpec, DrillString, Material, NEAREST_BEND_M,
        StringSpec,
    },
};

use wholestring_config::prelude::*;

use crate::{catalogue::OwnCatalogue, string::component::ComponentTable};

/// The string specification as the case gives it.
pub(crate) fn spec(
    tables: &[Spanned<ComponentTable>],
    steel: &Material,
    own: &OwnCatalogue,
    reader: &mut Reader,
) -> Option<StringSpec> {
    let mut components = Vec::with_capacity(tables.len());
    let mut valid = true;
    for (index, table) in tables.iter().enumerate() {
        if let Some(length) = table.value.length.given()
            && length.value == ComponentLength::ToSurface
        {
            let above = &tables[index + 1..];
            if let Some(mistake) = not_topmost(table, length.place, above) {
                reader.report(mistake);
                valid = false;
            }
        }
        match table.value.build(index == 0 && tables.len() > 1, table.place, steel, own, reader) {
            Some(component) => components.push(component),
            None => valid = false,
        }
    }
    valid.then_some(StringSpec { components })
}

/// The main component of the string: the one that runs to the surface, or else the longest.
pub(crate) fn longest(spec: &StringSpec) -> Option<&ComponentSpec> {
    let length_m = |component: &ComponentSpec| match component.length {
        ComponentLength::ToSurface => f64::INFINITY,
        ComponentLength::Metres(length_m) => length_m,
    };
    spec.components.iter().max_by(|a, b| length_m(a).total_cmp(&length_m(b)))
}

/// Whether the string is coiled tubing in an injector head, which does not rotate it: pipe without
/// joints, and a rig that pushes.
pub(crate) fn is_injected(spec: &StringSpec, rig: &Rig) -> bool {
    let has_joints = longest(spec).is_none_or(|pipe| pipe.joints.is_some());
    rig.snubbing_force_N.is_some() && !has_joints
}

/// The mistake of a component that runs to the surface although other components are above it.
fn not_topmost(
    table: &Spanned<ComponentTable>,
    place: Span,
    above: &[Spanned<ComponentTable>],
) -> Option<Diagnostic> {
    if above.is_empty() {
        return None;
    }
    let diagnostic = Diagnostic::error(format!(
        "{} runs to the surface, but more components are above it",
        called(table)
    ))
    .at(place, "no length remains for the components after it");
    let other = above.iter().find_map(|table| {
        let length = table.value.length.given()?;
        (length.value == ComponentLength::ToSurface).then_some(length.place)
    });
    Some(
        match other {
            Some(other) => diagnostic.at(other, "this one runs to the surface too"),
            None => diagnostic,
        }
        .help("components are listed from the bit up: only the last one can run to the surface"),
    )
}

/// Name of a component in messages.
fn called(table: &Spanned<ComponentTable>) -> String {
    match table.value.component.get() {
        Some(name) => format!("`{}`", short(name)),
        None => "the component".to_owned(),
    }
}

/// The string for a depth of the bit.
pub(crate) fn assemble(
    spec: &StringSpec,
    tables: &[Spanned<ComponentTable>],
    bit_depth_m: f64,
    bit_place: Option<Span>,
    reader: &mut Reader,
) -> Option<DrillString> {
    let error = match spec.assemble(bit_depth_m) {
        Ok(string) => return Some(string),
        Err(error) => error,
    };
    let units = reader.units();
    let length = |value: f64| shown(Dimension::Length, value, units);
    let top = tables.last().map(|table| table.place).unwrap_or_default();
    let bit = |diagnostic: Diagnostic| match bit_place {
        Some(place) => diagnostic.at(place, "the bit depth"),
        None => diagnostic
            .help("without bit_depth under [operation] the bit is at the last survey station"),
    };
    let diagnostic = match &error {
        AssemblyError::AssemblyTooLong { assembly_m, bit_depth_m, .. } => {
            bit(Diagnostic::error(format!(
                "the string is longer than the depth of the hole: {} are below the top component, \
                 the bit is at {}",
                length(*assembly_m),
                length(*bit_depth_m)
            ))
            .at(top, "no length remains for this component"))
        }
        AssemblyError::LengthMismatch { string_m, bit_depth_m } => bit(Diagnostic::error(format!(
            "the string is {} long, the bit is at {}",
            length(*string_m),
            length(*bit_depth_m)
        ))
        .at(
            top,
            format!(
                "{} {}",
                length((bit_depth_m - string_m).abs()),
                if string_m > bit_depth_m { "too long" } else { "too short" }
            ),
        )
        .help("length = \"to surface\" in the last component fills the rest")),
        AssemblyError::Dimension {
            index, field: field @ ("bend_at" | "lateral_force_at"), ..
        } => {
            let table = tables.get(*index);
            let entry = table.and_then(|table| match *field {
                "bend_at" => table.value.bend_at.given(),
                _ => table.value.lateral_force_at.given(),
            });
            let place = entry.map(|at| at.place).or(table.map(|table| table.place)).unwrap_or(top);
            let what = if *field == "bend_at" { "the bend" } else { "the lateral force" };
            Diagnostic::error(format!("{what} is at the end of the string")).at(
                place,
                format!(
                    "expected {} or more from the bit and from the surface",
                    length(NEAREST_BEND_M)
                ),
            )
        }
        AssemblyError::Dimension { index, .. } => {
            let place = tables.get(*index).map(|table| table.place).unwrap_or(top);
            Diagnostic::error(short(&error.to_string())).at(place, "this component")
        }
        _ => Diagnostic::error(short(&error.to_string())).at(top, "the string"),
    };
    diagnostic.refuse(reader)
}
