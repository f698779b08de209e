//! Whether the string fits the hole and stays down in the mud.

use wholestring::{mud::Mud, string::DrillString, well::Hole};

use wholestring_config::prelude::*;

use crate::{
    component::{ComponentTable, mm},
    hole::HoleTable,
};

/// Diameters that differ by less than this are equal, m: a thousandth of a millimetre.
const EQUAL_M: f64 = 1e-6;

/// Every component must pass the sections above its place in the hole. The bit may be as wide as
/// its hole; anything else needs clearance.
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
        let mut diagnostic =
            Diagnostic::error(message).at(od_place(table, joint), format!("{} across", mm(od_m)));
        if let Some(place) = section_table.value.diameter_place() {
            diagnostic = diagnostic.at(
                place,
                format!(
                    "hole of {} from {} to {} m",
                    mm(section.diameter_m),
                    number_text(section.from_md_m),
                    number_text(section.to_md_m)
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

/// A string that weighs less than it is to put on the bit would be pushed into the hole.
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
        let kN = |force_N: f64| number_text((force_N / 100.0).round() / 10.0);
        Diagnostic::warning("the weight on bit is more than the string weighs")
            .at(wob.place, format!("{} kN on the bit", kN(wob.value)))
            .help(format!("the whole string weighs {} kN in this mud", kN(weight_N)))
            .report(reader);
    }
}

/// The place that says how wide a component is.
fn od_place(table: &Spanned<ComponentTable>, joint: bool) -> Span {
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

/// Buoyancy must leave every component its weight.
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
        Diagnostic::error(format!("`{}` floats in this mud", short(&component.name)))
            .at(
                place,
                format!(
                    "{} kg/m of metal of {} kg/m3",
                    number_text(component.mass_per_length_kg_per_m),
                    number_text(component.material.density_kg_per_m3)
                ),
            )
            .at(mud_place, format!("mud of {} kg/m3", number_text(mud.density_kg_per_m3)))
            .report(reader);
    }
}
