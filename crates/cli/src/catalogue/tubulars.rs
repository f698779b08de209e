//! Tubulars as tables.

use wholestring::{
    string::catalogue::{CatalogueEntry, TubularKind},
    string::{Component, Material},
    well::casing::Casing,
};
use wholestring_case::STEEL_DENSITY_KG_PER_M3;
use wholestring_units::{Dimension, Unit, UnitSet};

use super::cells::{heading, number, units_of};
use crate::screen_table::Table;

fn title(kind: TubularKind) -> &'static str {
    match kind {
        TubularKind::DrillPipe => "Drill pipe",
        TubularKind::HeavyWeight => "Heavy-weight drill pipe",
        TubularKind::Collar => "Drill collars",
        TubularKind::CoiledTubing => "Coiled tubing",
    }
}

pub(super) fn of_string(kind: TubularKind, entries: &[CatalogueEntry], units: UnitSet) -> String {
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

pub(super) fn casing(casings: &[Casing], units: UnitSet) -> String {
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
