//! Whether the string fits the hole and its weight exceeds buoyancy.

use wholestring::{
    mud::Mud,
    string::{Component, DrillString, nested_casings},
    well::{Hole, HoleKind},
};

use wholestring_config::prelude::*;
use wholestring_tabular::{is_bit, is_stabiliser};

use crate::{string::component::ComponentTable, well::hole::HoleTable};

/// Diameters that differ by less than this are equal, m: a thousandth of a millimetre.
const EQUAL_M: f64 = 1e-6;

/// Least diameter of a bit as a part of its open hole, which otherwise was drilled by another bit:
/// a washout of an eighth is an exception.
const DRILLS: f64 = 0.88;

/// Least diameter of a wall-contacting component, as a part of the hole's.
const FILLS: f64 = 0.9;

/// Refuses a component that does not pass the sections above its place in the hole. The bit may be
/// as wide as its hole; anything else needs clearance.
pub(crate) fn check_clearance(
    string: &DrillString,
    components: &[Spanned<ComponentTable>],
    hole: &Hole,
    sections: &[Spanned<HoleTable>],
    reader: &mut Reader,
) {
    let bit_depth_m = string.length_m();
    for (index, span) in string.spans().enumerate() {
        let Some(table) = components.get(index) else {
            continue;
        };
        let bottom_md_m = bit_depth_m - span.from_bit_m;
        let od_m = 2.0 * span.component.contact_radius_m();
        let tight = |diameter_m: f64| match index {
            0 => od_m > diameter_m + EQUAL_M,
            _ => od_m > diameter_m - EQUAL_M,
        };
        let found = hole
            .sections()
            .iter()
            .zip(sections)
            .find(|(section, _)| section.from_md_m < bottom_md_m && tight(section.diameter_m));
        let Some((section, section_table)) = found else {
            continue;
        };
        let name = short(&span.component.name);
        let joint = span.component.joints.is_some();
        let part = match span.component.blades {
            Some(_) => "blades of ",
            None if joint => "tool joint of ",
            None => "",
        };
        let verb = match span.component.blades {
            Some(_) => ["leave", "do"],
            None => ["leaves", "does"],
        };
        let equal = (od_m - section.diameter_m).abs() <= EQUAL_M;
        let message = if equal {
            format!("{part}`{name}` {} no clearance in the hole", verb[0])
        } else {
            format!("{part}`{name}` {} not pass the hole", verb[1])
        };
        let mut diagnostic = Diagnostic::error(message).at(
            od_place(table, joint),
            format!("{} across", reader.shown(Dimension::Diameter, od_m)),
        );
        if let Some(place) = section_table.value.diameter_place() {
            diagnostic = diagnostic.at(
                place,
                format!(
                    "hole of {} from {} to {}",
                    reader.shown(Dimension::Diameter, section.diameter_m),
                    reader.shown(Dimension::Length, section.from_md_m),
                    reader.shown(Dimension::Length, section.to_md_m)
                ),
            );
        }
        if equal {
            diagnostic = diagnostic.help(
                "only the bit may be as wide as the hole; a full-gauge tool is a little smaller: \
                 give its worn gauge",
            );
        }
        reader.report(diagnostic);
    }
}

/// Warns of a bit that is narrower than its open hole, and of stabilisers without blades.
pub(crate) fn check_gauge(
    string: &DrillString,
    components: &[Spanned<ComponentTable>],
    hole: &Hole,
    sections: &[Spanned<HoleTable>],
    reader: &mut Reader,
) {
    let bit_depth_m = string.length_m();
    let at_depth = |md_m: f64| {
        let mut found = hole.sections().iter().zip(sections);
        found.find(|(section, _)| section.from_md_m < md_m && md_m <= section.to_md_m + EQUAL_M)
    };
    let diameter = |reader: &Reader, m: f64| reader.shown(Dimension::Diameter, m);
    let opened = |diameter_m: f64| {
        // Tool joints do not drill.
        let width_m = |part: &Component| part.blades.map_or(part.od_m, |blades| blades.od_m);
        let widest = string.components().iter().skip(1).map(width_m);
        widest.fold(0.0, f64::max) > DRILLS * diameter_m
    };
    if let (Some(bit), Some(table), Some((section, at))) =
        (string.components().first(), components.first(), at_depth(bit_depth_m))
        && bit.is_bit()
        && section.kind == HoleKind::Open
        && bit.od_m < DRILLS * section.diameter_m
        && !opened(section.diameter_m)
    {
        let mut diagnostic = Diagnostic::warning(format!(
            "`{}` is {} narrower than the hole at its depth",
            short(&bit.name),
            diameter(reader, section.diameter_m - bit.od_m)
        ))
        .at(od_place(table, false), format!("{} across", diameter(reader, bit.od_m)));
        if let Some(place) = at.value.diameter_place() {
            let label = format!("hole of {}", diameter(reader, section.diameter_m));
            diagnostic = diagnostic.at(place, label);
        }
        diagnostic.help("the od of a bit is its gauge, not that of its shank").report(reader);
    }
    for (span, table) in string.spans().zip(components).skip(1) {
        if is_bit(&span.component.name) {
            Diagnostic::warning(format!(
                "`{}` is called a bit and is not the lowest component",
                short(&span.component.name)
            ))
            .at(table.place, "the components are listed from the bit up")
            .help("a string has one bit; are these two strings, one above the other?")
            .report(reader);
        }
    }
    for (span, table) in string.spans().zip(components) {
        let part = span.component;
        let Some((section, _)) = at_depth(bit_depth_m - span.from_bit_m) else { continue };
        let fills = 2.0 * part.contact_radius_m() > FILLS * section.diameter_m;
        if part.blades.is_some() || fills || !is_stabiliser(&part.name) {
            continue;
        }
        Diagnostic::warning(format!(
            "`{}` is called a stabiliser or reamer and has no blades",
            short(&part.name)
        ))
        .at(
            od_place(table, false),
            format!("it touches the wall with its body of {}", diameter(reader, part.od_m)),
        )
        .help("give its gauge as blade_od")
        .report(reader);
    }
}

/// Warns of casings that do not fit into each other.
pub(crate) fn check_programme(
    string: &DrillString,
    components: &[Spanned<ComponentTable>],
    reader: &mut Reader,
) {
    let diameters: Vec<(f64, f64)> =
        string.components().iter().map(|part| (part.od_m, part.id_m)).collect();
    let Some(top) = components.last().filter(|_| nested_casings(&diameters)) else { return };
    Diagnostic::warning("the string has casings, one of which fits into another")
        .at(top.place, "one above the other, as a string has them")
        .help(
            "a casing programme is not a string: casings that are in the hole belong under \
               [[well.hole]]",
        )
        .report(reader);
}

/// Refuses a string that is lighter than its weight on bit, because it would have to be pushed into
/// the hole.
pub(crate) fn check_weight_on_bit(
    string: &DrillString,
    mud: &Mud,
    wob: Option<&Spanned<f64>>,
    reader: &mut Reader,
) {
    let Some(wob) = wob else { return };
    let weight_N: f64 = string
        .components()
        .iter()
        .map(|component| {
            component.length_m * component.buoyed_weight_per_length_N_per_m(mud.density_kg_per_m3)
        })
        .sum();
    if weight_N > 0.0 && wob.value > weight_N {
        let force = |force_N: f64| reader.shown(Dimension::Force, force_N);
        Diagnostic::warning("the weight on bit is more than the string weighs")
            .at(wob.place, format!("{} on the bit", force(wob.value)))
            .help(format!("the whole string weighs {} in this mud", force(weight_N)))
            .report(reader);
    }
}

/// Place of the key that gives the width of a component.
pub(crate) fn od_place(table: &Spanned<ComponentTable>, joint: bool) -> Span {
    let component = &table.value;
    let joint_od = component.joint_od.given().filter(|_| joint);
    component
        .blade_od
        .given()
        .or(joint_od)
        .or(component.od.given())
        .map(|at| at.place)
        .or(component.catalogue.given().map(|at| at.place))
        .unwrap_or(table.place)
}

/// Refuses a component that is lighter than the mud that it displaces.
pub(crate) fn check_weight(
    string: &DrillString,
    components: &[Spanned<ComponentTable>],
    mud: &Mud,
    mud_place: Span,
    reader: &mut Reader,
) {
    for (component, table) in string.components().iter().zip(components) {
        let displaced = mud.density_kg_per_m3 * component.area_m2();
        let floats = mud.density_kg_per_m3 >= component.material.density_kg_per_m3
            || displaced >= component.mass_per_length_kg_per_m;
        if !floats {
            continue;
        }
        let place = table
            .value
            .mass_per_length
            .given()
            .or(table.value.density.given())
            .map_or(table.place, |at| at.place);
        let density = |kg_per_m3: f64| reader.shown(Dimension::Density, kg_per_m3);
        let mass = |kg_per_m: f64| reader.shown(Dimension::MassPerLength, kg_per_m);
        let metal = component.material.density_kg_per_m3;
        let name = short(&component.name);
        let diagnostic = if mud.density_kg_per_m3 >= metal {
            Diagnostic::error(format!("`{name}` floats in this mud: its metal is no denser"))
                .at(place, format!("metal of {}", density(metal)))
                .help("give the density of its metal as `density`")
        } else {
            Diagnostic::error(format!(
                "`{name}` floats in this mud: it weighs {} in air, and its metal displaces {} of \
                 mud",
                mass(component.mass_per_length_kg_per_m),
                mass(displaced)
            ))
            .at(place, format!("weight in air: expected more than {}", mass(displaced)))
            .help(format!(
                "a body of its od and id in metal of {} weighs {} in air: leave \
                 `mass_per_length` out, or give the weight in air",
                density(metal),
                mass(metal * component.area_m2())
            ))
            .help(
                "mud is in the bore and around the string: a bore filled with air, as of floated \
                 casing, is not modelled",
            )
        };
        diagnostic
            .at(mud_place, format!("mud of {}", density(mud.density_kg_per_m3)))
            .report(reader);
    }
}
