//! `wholestring catalogue`: tubulars that a case can name, and common rig equipment.

use std::path::PathBuf;

use clap::Args;
use wholestring::{
    rig::catalogue::{HoistClass, Span, TopDriveClass},
    string::{
        Component, Material,
        catalogue::{CatalogueEntry, TubularKind},
    },
    well::casing::Casing,
};
use wholestring_case::{OwnCatalogue, STEEL_DENSITY_KG_PER_M3};
use wholestring_runner::Found;
use wholestring_units::{Dimension, Unit, UnitSet};

use crate::{failure::Failure, screen::Table, terminal::print_stdout};

pub(crate) fn catalogue(args: &CatalogueArgs) -> Result<(), Failure> {
    let query = args.words.join(" ");
    let units = args.units.unwrap_or(UnitSet::Si);
    let own = match &args.with {
        Some(path) => OwnCatalogue::load(path)?,
        None => OwnCatalogue::default(),
    };
    let found = Found::described(&query, own.entries(), own.casings());
    if found.is_empty() {
        return Err(Failure::BadInput(format!(
            "error: the catalogue has nothing of `{query}`\n\
             help: search by size, weight, grade, class or kind, such as 5-1/2, 21.9, S-135, \
             premium, hwdp, collar, coiled, casing, rig; \
             without a word everything is listed"
        )));
    }
    let string = found.string.iter();
    let mut tables: Vec<String> =
        string.map(|(kind, entries)| of_string(*kind, entries, units)).collect();
    if !found.casings.is_empty() {
        tables.push(casing(&found.casings, units));
    }
    if !found.top_drives.is_empty() {
        tables.push(top_drives(&found.top_drives, units));
    }
    if !found.hoists.is_empty() {
        tables.push(hoists(&found.hoists, units));
    }
    let how =
        "In a case: catalogue = \"NAME\" under [[string]]; casing = \"NAME\" under [[well.hole]]\n";
    let sources: Vec<String> =
        found.sources().iter().map(|source| format!("  {source}\n")).collect();
    print_stdout(&format!(
        "{}\n\
         {}\
         Sources:\n{}",
        tables.join("\n"),
        if found.has_tubulars() { how } else { "" },
        sources.concat()
    ))
}

// Arguments of `wholestring catalogue`.

#[derive(Debug, Args)]
pub(crate) struct CatalogueArgs {
    /// Size, weight, grade, class or kind, such as `5-1/2`, `S-135`, `premium`, `hwdp`, `casing` or
    /// `rig`; entries that match all of them are listed
    #[arg(value_name = "WORD")]
    pub(crate) words: Vec<String>,

    /// File of your own tubulars, TOML or CSV, as in the key `catalogue` of a case
    #[arg(long, value_name = "FILE")]
    pub(crate) with: Option<PathBuf>,

    /// Units of the table [default: si]
    #[arg(long, value_name = "si|metric|field")]
    pub(crate) units: Option<UnitSet>,
}

// Tubulars as tables.

fn title(kind: TubularKind) -> &'static str {
    match kind {
        TubularKind::DrillPipe => "Drill pipe",
        TubularKind::HeavyWeight => "Heavy-weight drill pipe",
        TubularKind::Collar => "Drill collars",
        TubularKind::CoiledTubing => "Coiled tubing",
    }
}

fn of_string(kind: TubularKind, entries: &[CatalogueEntry], units: UnitSet) -> String {
    let [across, mass, strength, force, torque] = units_of(
        [
            Dimension::Diameter,
            Dimension::MassPerLength,
            Dimension::Stress,
            Dimension::Force,
            Dimension::Torque,
        ],
        units,
    );
    let has_joints = entries.iter().any(|entry| entry.joints.is_some());
    let has_connections = entries.iter().any(|entry| entry.connection.is_some());
    let mut headings = vec!["name".to_owned()];
    headings.extend(has_connections.then(|| "connection".to_owned()));
    headings.extend([heading("OD", across), heading("ID", across)]);
    headings.extend(has_joints.then(|| heading("joint", across)));
    headings.extend([heading("mass", mass), heading("yield", strength)]);
    headings.extend([heading("tension", force), heading("torque", torque)]);
    if has_connections {
        headings.extend([heading("joint", torque), heading("make-up", torque)]);
    }
    let headings: Vec<&str> = headings.iter().map(String::as_str).collect();
    let mut table = Table::new(title(kind), if has_connections { 2 } else { 1 }, &headings);
    for entry in entries {
        let body = Component {
            yield_strength_Pa: Some(entry.yield_strength_Pa),
            ..Component::uniform("", entry.od_m, entry.id_m, 1.0, Material::STEEL)
        };
        let known =
            |unit: &Unit, si: Option<f64>| si.map_or("–".to_owned(), |si| number(unit, si));
        let mut row = vec![entry.designation.clone()];
        row.extend(entry.connection.as_ref().map(|connection| connection.name.to_string()));
        row.push(diameter(across, entry.od_m));
        row.push(diameter(across, entry.id_m));
        row.extend(entry.joints.map(|joints| diameter(across, joints.od_m)));
        let kg_per_m = entry.mass_per_length_kg_per_m(STEEL_DENSITY_KG_PER_M3);
        row.push(format!("{:.1}", mass.from_si(kg_per_m)));
        row.push(format!("{:.0}", strength.from_si(entry.yield_strength_Pa)));
        row.push(known(force, body.tensile_yield_N()));
        row.push(known(torque, body.torsional_yield_N_m()));
        if let Some(connection) = &entry.connection {
            row.push(known(torque, connection.strength.torsional_yield_N_m));
            row.push(known(torque, connection.strength.make_up_torque_N_m));
        }
        table.row(row);
    }
    table.text()
}

fn casing(casings: &[Casing], units: UnitSet) -> String {
    let [across, mass, strength] =
        units_of([Dimension::Diameter, Dimension::MassPerLength, Dimension::Stress], units);
    let mut headings = vec![
        "name".to_owned(),
        heading("OD", across),
        heading("ID", across),
        heading("drift", across),
        heading("mass", mass),
    ];
    let has_grades = casings.iter().any(|one| one.grade.is_some());
    headings.extend(has_grades.then(|| heading("yield", strength)));
    let headings: Vec<&str> = headings.iter().map(String::as_str).collect();
    let mut table = Table::new("Casing", 1, &headings);
    for one in casings {
        let grade = one.grade.map_or("", |grade| grade.name);
        let mut row = vec![
            format!("{} {grade}", one.designation).trim_end().to_owned(),
            diameter(across, one.od_m),
            diameter(across, one.id_m),
            diameter(across, one.drift_m),
            format!("{:.1}", mass.from_si(one.mass_per_length_kg_per_m)),
        ];
        let yields =
            one.grade.map(|grade| format!("{:.0}", strength.from_si(grade.yield_strength_Pa)));
        row.extend(has_grades.then(|| yields.unwrap_or_else(|| "–".to_owned())));
        table.row(row);
    }
    table.text()
}

/// As the standards print it: to 0.001 in or 0.01 mm.
fn diameter(unit: &Unit, si: f64) -> String {
    let decimals = if unit.symbol == "in" { 3 } else { 2 };
    format!("{:.decimals$}", unit.from_si(si))
}

// Top drives and hoists as tables, in ascending order of their common values.

fn top_drives(classes: &[TopDriveClass], units: UnitSet) -> String {
    let [force, torque, speed] =
        units_of([Dimension::Force, Dimension::Torque, Dimension::RotarySpeed], units);
    let headings = [
        "class".to_owned(),
        heading("carries", force),
        heading("rated torque", torque),
        heading("peak torque", torque),
        heading("highest speed", speed),
    ];
    let headings: Vec<&str> = headings.iter().map(String::as_str).collect();
    let mut table = Table::new("Top drives (typical)", 1, &headings);
    for class in classes {
        table.row(vec![
            class.designation.clone(),
            number(force, class.capacity_N),
            span(torque, class.torque_N_m),
            span(torque, class.peak_torque_N_m),
            span(speed, class.highest_speed_rad_per_s),
        ]);
    }
    table.text()
}

fn hoists(classes: &[HoistClass], units: UnitSet) -> String {
    let force = Dimension::Force.unit_in(units);
    let headings = [
        "class".to_owned(),
        heading("carries", force),
        heading("pushes", force),
        heading("block and top drive", force),
    ];
    let headings: Vec<&str> = headings.iter().map(String::as_str).collect();
    let mut table = Table::new("Hoists (typical)", 1, &headings);
    let known = |range: Option<Span>| range.map_or("–".to_owned(), |range| span(force, range));
    for class in classes {
        table.row(vec![
            class.designation.clone(),
            span(force, class.capacity_N),
            known(class.snubbing_force_N),
            known(class.block_weight_N),
        ]);
    }
    table.text()
}

fn span(unit: &Unit, span: Span) -> String {
    let [least, most] = [span.least, span.most].map(|si| number(unit, si));
    if least == most { least } else { format!("{least} – {most}") }
}

// Headings and numbers of the catalogue's tables.

/// A heading with the unit of its column.
fn heading(what: &str, unit: &Unit) -> String {
    format!("{what} {}", unit.symbol)
}

/// The units of dimensions in a set.
fn units_of<const N: usize>(dimensions: [Dimension; N], units: UnitSet) -> [&'static Unit; N] {
    dimensions.map(|dimension| dimension.unit_in(units))
}

/// Rounded to three digits or to the unit, whichever is finer.
fn number(unit: &Unit, si: f64) -> String {
    let value = unit.from_si(si);
    let decimals = if value.abs() < 99.95 { 1 } else { 0 };
    format!("{value:.decimals$}")
}
