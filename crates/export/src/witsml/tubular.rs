//! A string as a WITSML tubular.

use std::io;

use wholestring_units::Dimension;

use super::{
    version::Version,
    xml::{Xml, uid},
};
use crate::{look::Look, tally::Component};

const NAME: &str = "String of the case";

/// What a name says that a component is: a word of it, and the type in WITSML.
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
/// None that components give.
pub fn tubular(look: &Look, components: &[Component], version: Version) -> io::Result<String> {
    match version {
        Version::V1411 => v1411(look, components),
        Version::V20 => v20(look, components),
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
        xml.leaf("typeTubularComp", &[], kind(&component.name))?;
        xml.leaf("sequence", &[], &sequence)?;
        xml.leaf("description", &[], &component.name)?;
        measures(&mut xml, look, component, |name| name)?;
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

fn v20(look: &Look, components: &[Component]) -> io::Result<String> {
    let mut xml = Xml::new()?;
    xml.open_series_2("Tubular", look, NAME)?;
    xml.leaf("TypeTubularAssy", &[], "drilling")?;
    for (place, component) in components.iter().enumerate() {
        let sequence = (place + 1).to_string();
        xml.open("TubularComponent", &[("uid", &sequence)])?;
        xml.leaf("TypeTubularComp", &[], kind(&component.name))?;
        xml.leaf("Sequence", &[], &sequence)?;
        xml.leaf("Description", &[], &component.name)?;
        let capital = |name: &'static str| match name {
            "id" => "Id",
            "od" => "Od",
            "odMx" => "OdMx",
            "len" => "Len",
            "lenJointAv" => "LenJointAv",
            "wtPerLen" => "WtPerLen",
            "tensYield" => "TensYield",
            other => other,
        };
        measures(&mut xml, look, component, capital)?;
        xml.close("TubularComponent")?;
    }
    xml.wellbore(look)?;
    xml.close("Tubular")?;
    xml.finish()
}

/// What is measured of a component, in the order of both schemas.
fn measures(
    xml: &mut Xml,
    look: &Look,
    component: &Component,
    called: impl Fn(&'static str) -> &'static str,
) -> io::Result<()> {
    let (length, diameter) = (look.uom(Dimension::Length), look.uom(Dimension::Diameter));
    xml.quantity(called("id"), diameter, component.id_m)?;
    xml.quantity(called("od"), diameter, component.od_m)?;
    // What stands out over the body: joints or blades.
    if let Some(widest_m) = component.blade_od_m.or(component.joint_od_m) {
        xml.quantity(called("odMx"), diameter, widest_m)?;
    }
    xml.quantity(called("len"), length, component.length_m)?;
    if let Some(spacing_m) = component.joint_spacing_m {
        xml.quantity(called("lenJointAv"), length, spacing_m)?;
    }
    let mass = look.uom(Dimension::MassPerLength);
    xml.quantity(called("wtPerLen"), mass, component.mass_per_length_kg_per_m)?;
    if let Some(strength_Pa) = component.yield_strength_Pa {
        xml.quantity(called("tensYield"), look.uom(Dimension::Pressure), strength_Pa)?;
    }
    Ok(())
}

/// The type of a component by the last word of its name that says one.
fn kind(name: &str) -> &'static str {
    let name = name.to_lowercase();
    let words = name.split(|c: char| !c.is_alphanumeric() && c != '-').rev();
    let of = |word: &str| TYPES.iter().find(|(of, _)| *of == word).map(|(_, kind)| *kind);
    let heavy = name.contains("heavy");
    match words.into_iter().find_map(of) {
        Some("drill pipe") if heavy => "heavy weight drill pipe",
        Some(kind) => kind,
        None => "unknown",
    }
}
