//! A string as a WITSML tubular.

use std::io;

use wholestring_units::Dimension;

use super::{
    Version,
    xml::{Xml, uid},
};
use crate::look::Look;

const NAME: &str = "String of the case";

/// Type of a component by its name: a word of the name, and the type in WITSML.
const TYPES: &[(&str, &str)] = &[
    ("bit", "bit"),
    ("motor", "motor"),
    ("stabiliser", "stabilizer"),
    ("stabilizer", "stabilizer"),
    ("reamer", "reamer"),
    ("lwd", "logging while drilling tool"),
    ("jar", "jar"),
    ("heavy-weight", "heavy weight drill pipe"),
    ("heavyweight", "heavy weight drill pipe"),
    ("hwdp", "heavy weight drill pipe"),
    ("collar", "drill collar"),
    ("collars", "drill collar"),
    ("casing", "casing"),
    ("liner", "liner"),
    ("pipe", "drill pipe"),
];

/// The tubular of these components, from the bit up.
///
/// # Errors
/// None for valid components.
pub fn tubular(look: &Look, components: &[Component], version: Version) -> io::Result<String> {
    match version {
        Version::V1411 => v1411(look, components),
        Version::V20 | Version::V21 => v2(look, components, version),
    }
}

fn v1411(look: &Look, components: &[Component]) -> io::Result<String> {
    let well = uid(&look.name);
    let mut xml = Xml::new()?;
    xml.open_series_1("tubulars")?;
    let uids = [("uidWell", well.as_str()), ("uidWellbore", &well), ("uid", "string")];
    xml.open("tubular", &uids)?;
    xml.leaf("nameWell", &[], &look.name)?;
    xml.leaf("nameWellbore", &[], &look.name)?;
    xml.leaf("name", &[], NAME)?;
    xml.leaf("typeTubularAssy", &[], "drilling")?;
    for (place, component) in components.iter().enumerate() {
        let sequence = (place + 1).to_string();
        xml.open("tubularComponent", &[("uid", &sequence)])?;
        xml.leaf("typeTubularComp", &[], kind(component))?;
        xml.leaf("sequence", &[], &sequence)?;
        xml.leaf("description", &[], &component.name)?;
        measures(&mut xml, look, component, str::to_owned)?;
        xml.close("tubularComponent")?;
    }
    xml.open("commonData", &[])?;
    xml.leaf("sourceName", &[], &look.program)?;
    xml.leaf("dTimCreation", &[], &look.created)?;
    xml.close("commonData")?;
    xml.close("tubular")?;
    xml.close("tubulars")?;
    xml.finish()
}

fn v2(look: &Look, components: &[Component], version: Version) -> io::Result<String> {
    let mut xml = Xml::new()?;
    xml.open_series_2("Tubular", look, NAME, version)?;
    xml.leaf("TypeTubularAssy", &[], "drilling")?;
    for (place, component) in components.iter().enumerate() {
        let sequence = (place + 1).to_string();
        xml.open("TubularComponent", &[("uid", &sequence)])?;
        match version {
            Version::V21 => xml.leaf("TypeTubularComponent", &[], kind_21(component))?,
            Version::V1411 | Version::V20 => xml.leaf("TypeTubularComp", &[], kind(component))?,
        }
        xml.leaf("Sequence", &[], &sequence)?;
        xml.leaf("Description", &[], &component.name)?;
        measures(&mut xml, look, component, capital)?;
        xml.close("TubularComponent")?;
    }
    xml.wellbore(look, version)?;
    xml.close("Tubular")?;
    xml.finish()
}

/// The type in 2.1, which has no type for a plain bit.
fn kind_21(component: &Component) -> &'static str {
    let name = component.name.to_lowercase();
    match kind(component) {
        "bit" if name.contains("pdc") => "bit PDC fixed cutter",
        "bit" if name.contains("cone") => "bit insert roller cone",
        "bit" if name.contains("diamond") => "bit diamond fixed cut",
        "bit" => "other",
        kind => kind,
    }
}

/// Capitalises a name, as in version 2.
fn capital(name: &str) -> String {
    let mut letters = name.chars();
    letters
        .next()
        .map_or(String::new(), |first| first.to_ascii_uppercase().to_string() + letters.as_str())
}

/// Measurements of a component, in the order of all schemas.
fn measures(
    xml: &mut Xml,
    look: &Look,
    component: &Component,
    called: fn(&str) -> String,
) -> io::Result<()> {
    let (length, diameter) = (look.uom(Dimension::Length), look.uom(Dimension::Diameter));
    xml.quantity(&called("id"), diameter, component.id_m)?;
    xml.quantity(&called("od"), diameter, component.od_m)?;
    // Maximum diameter beyond the body: joints or blades.
    if let Some(widest_m) = component.blade_od_m.or(component.joint_od_m) {
        xml.quantity(&called("odMx"), diameter, widest_m)?;
    }
    xml.quantity(&called("len"), length, component.length_m)?;
    if let Some(spacing_m) = component.joint_spacing_m {
        xml.quantity(&called("lenJointAv"), length, spacing_m)?;
    }
    let mass = look.uom(Dimension::MassPerLength);
    xml.quantity(&called("wtPerLen"), mass, component.mass_per_length_kg_per_m)?;
    if let Some(strength_Pa) = component.yield_strength_Pa {
        xml.quantity(&called("tensYield"), look.uom(Dimension::Stress), strength_Pa)?;
    }
    // The diameter of the tool joints, which readers expect here.
    if let Some(joint_m) = component.joint_od_m {
        let connection = called("connection");
        xml.open(&connection, &[("uid", "1")])?;
        xml.quantity(&called("od"), diameter, joint_m)?;
        xml.close(&connection)?;
    }
    if let Some(blades_m) = component.blade_od_m {
        let stabilizer = called("stabilizer");
        let long_m = component.blade_length_m;
        xml.open(&stabilizer, &[("uid", "1")])?;
        if let Some(long_m) = long_m {
            xml.quantity(&called("lenBlade"), length, long_m)?;
        }
        xml.quantity(&called("odBladeMx"), diameter, blades_m)?;
        if let Some(long_m) = long_m {
            let below_m = 0.5 * (component.length_m - long_m);
            xml.quantity(&called("distBladeBot"), length, below_m)?;
        }
        xml.close(&stabilizer)?;
    }
    Ok(())
}

/// The type of a component by the last word of its name that has one; a component with tool joints
/// is pipe.
fn kind(component: &Component) -> &'static str {
    let name = component.name.to_lowercase();
    let words = name.split(|c: char| !c.is_alphanumeric() && c != '-').rev();
    let type_of =
        |word: &str| TYPES.iter().find(|(known, _)| *known == word).map(|(_, kind)| *kind);
    let heavy = name.contains("heavy");
    match words.into_iter().find_map(type_of) {
        Some("drill pipe") if heavy => "heavy weight drill pipe",
        Some(kind) => kind,
        None if component.joint_od_m.is_some() => "drill pipe",
        None => "unknown",
    }
}

// A component of a string in a tally.

/// A component, from the bit up.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Component {
    /// Its name.
    pub name: String,
    /// Length, m.
    pub length_m: f64,
    /// Outside diameter of the body, m.
    pub od_m: f64,
    /// Inside diameter of the body, m.
    pub id_m: f64,
    /// Mass per length in air, kg/m, including tool joints.
    pub mass_per_length_kg_per_m: f64,
    /// Outside diameter of the tool joints, m, if it has any.
    pub joint_od_m: Option<f64>,
    /// Distance between tool joints, m, if it has any.
    pub joint_spacing_m: Option<f64>,
    /// Diameter over the blades, m, if it has any.
    pub blade_od_m: Option<f64>,
    /// Length of the blades, which are at its middle, m, if it has any.
    pub blade_length_m: Option<f64>,
    /// Density of its metal, kg/m³, if other than the usual steel.
    pub density_kg_per_m3: Option<f64>,
    /// Young's modulus and shear modulus of its metal, Pa, if other than the usual steel.
    pub moduli_Pa: Option<[f64; 2]>,
    /// Minimum yield strength, Pa, if known.
    pub yield_strength_Pa: Option<f64>,
}
