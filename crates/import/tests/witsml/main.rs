//! WITSML: whole outputs of samples, and each difficulty by itself.

mod hole;
mod hostile;
mod objects;
mod trajectory;
mod tubular;

use std::{collections::BTreeMap, path::Path};

use wholestring_case::Template;
use wholestring_import::{Choices, Imported, Input, import};

pub fn sample(name: &str) -> Vec<u8> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/samples").join(name);
    std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

pub fn imported(files: &[(&str, &[u8])], choices: &Choices) -> Result<Imported, String> {
    let inputs = files.iter().map(|&(name, bytes)| Input::of_bytes(name, bytes)).collect();
    import(inputs, choices).map_err(|error| error.to_string())
}

/// The case of a text with its notes, or the refusal.
pub fn whole(files: &[(&str, &[u8])], choices: &Choices) -> String {
    match imported(files, choices) {
        Ok(imported) => imported.text,
        Err(refusal) => refusal,
    }
}

/// The output of samples of one folder.
pub fn of_samples(folder: &str, names: &[&str]) -> String {
    let bytes: Vec<Vec<u8>> =
        names.iter().map(|name| sample(&format!("{folder}/{name}"))).collect();
    let files: Vec<(&str, &[u8])> =
        names.iter().zip(&bytes).map(|(name, bytes)| (*name, bytes.as_slice())).collect();
    whole(&files, &Choices::default())
}

/// Checks that the written case can be solved.
pub fn assert_solvable(text: &str) {
    let template = Template::in_memory("case.toml", text, BTreeMap::new());
    if let Err(report) = template.case(&[]) {
        panic!("{report:?}\n{text}");
    }
}

/// An object of WITSML 1.4.1.1 in its plural.
pub fn one_series(name: &str, objects: &str) -> String {
    format!(
        "<{name}s xmlns='http://www.witsml.org/schemas/1series' version='1.4.1.1'>{objects}</{name}s>"
    )
}

pub fn station(md: &str, incl: &str, azi: &str) -> String {
    format!(
        "<trajectoryStation><md uom='m'>{md}</md><incl uom='dega'>{incl}</incl>\
         <azi uom='dega'>{azi}</azi></trajectoryStation>"
    )
}

pub fn trajectory(stations: &str) -> String {
    one_series("trajectory", &format!("<trajectory uid='1'><name>T</name>{stations}</trajectory>"))
}

pub fn component(kind: &str, sequence: &str, more: &str) -> String {
    format!(
        "<tubularComponent><typeTubularComp>{kind}</typeTubularComp>{sequence}\
         <id uom='in'>3</id><od uom='in'>5</od><len uom='m'>10</len>{more}</tubularComponent>"
    )
}

pub fn numbered(kind: &str, sequence: usize) -> String {
    component(kind, &format!("<sequence>{sequence}</sequence>"), "")
}

pub fn tubular(components: &str) -> String {
    one_series("tubular", &format!("<tubular uid='1'><name>S</name>{components}</tubular>"))
}

pub fn section(kind: &str, top: f64, bottom: f64, more: &str) -> String {
    format!(
        "<wbGeometrySection><typeHoleCasing>{kind}</typeHoleCasing><mdTop uom='m'>{top}</mdTop>\
         <mdBottom uom='m'>{bottom}</mdBottom>{more}</wbGeometrySection>"
    )
}

pub fn geometry(sections: &str) -> String {
    one_series("wbGeometry", &format!("<wbGeometry uid='1'><name>G</name>{sections}</wbGeometry>"))
}

pub fn text_of(file: &str) -> String {
    let imported = imported(&[("a.xml", file.as_bytes())], &Choices::default());
    imported.unwrap_or_else(|refusal| panic!("{refusal}")).text
}

pub fn refusal(file: &str) -> String {
    imported(&[("a.xml", file.as_bytes())], &Choices::default()).unwrap_err()
}

/// The values of a key, in the order of the case.
pub fn values<'a>(text: &'a str, key: &str) -> Vec<&'a str> {
    let pairs = text.lines().filter_map(|line| line.split_once(" = "));
    let of_key = pairs.filter(|(own, _)| *own == key);
    of_key.map(|(_, rest)| rest.split(" #").next().unwrap_or(rest).trim()).collect()
}

pub const WELL: [&str; 4] =
    ["witsml-trajectory.xml", "witsml-wbgeometry.xml", "witsml-tubular.xml", "witsml-bharun.xml"];

pub const WELL_21: [&str; 5] = [
    "witsml21-trajectory.xml",
    "witsml21-geometry.xml",
    "witsml21-fluids.xml",
    "witsml21-tubular.xml",
    "witsml21-bharun.xml",
];
