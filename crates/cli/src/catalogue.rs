//! `wholestring catalogue`: the tubulars that a case can name.

use wholestring::{
    string::catalogue::{CatalogueEntry, TubularKind},
    well::casing::Casing,
};
use wholestring_case::STEEL_DENSITY_KG_PER_M3;
use wholestring_runner::Tubulars;
use wholestring_units::{Dimension, Unit, UnitSet};

use crate::{args::CatalogueArgs, failure::Failure, screen_table::Table, terminal::print_stdout};

pub(crate) fn catalogue(args: &CatalogueArgs) -> Result<(), Failure> {
    let query = args.words.join(" ");
    let units = args.units.unwrap_or(UnitSet::Si);
    let found = Tubulars::described(&query);
    if found.is_empty() {
        return Err(Failure::BadInput(format!(
            "error: the catalogue has nothing of `{query}`\n\
             help: search by size, weight, grade or kind, such as 5-1/2, 21.9, S-135, hwdp, \
             collar, casing; \
             without a word everything is listed"
        )));
    }
    let string = found.string.iter();
    let mut tables: Vec<String> =
        string.map(|(kind, entries)| tubulars(heading(*kind), entries, units)).collect();
    if !found.casings.is_empty() {
        tables.push(casing_table(&found.casings, units));
    }
    let sources: Vec<String> =
        found.sources().iter().map(|source| format!("  {source}\n")).collect();
    print_stdout(&format!(
        "{}\n\
         In a case: catalogue = \"NAME\" under [[string]]; casing = \"NAME\" under [[well.hole]]\n\
         Sources:\n{}",
        tables.join("\n"),
        sources.concat()
    ))
}

fn heading(kind: TubularKind) -> &'static str {
    match kind {
        TubularKind::DrillPipe => "Drill pipe",
        TubularKind::HeavyWeight => "Heavy-weight drill pipe",
        TubularKind::Collar => "Drill collars",
    }
}

fn tubulars(heading: &str, entries: &[CatalogueEntry], units: UnitSet) -> String {
    let [across, mass, strength] =
        [Dimension::Diameter, Dimension::MassPerLength, Dimension::Pressure]
            .map(|dimension| dimension.unit_in(units));
    let has_joints = entries.iter().any(|entry| entry.joints.is_some());
    let mut headings = vec!["name".to_owned()];
    if has_joints {
        headings.push("connection".to_owned());
    }
    headings.push(format!("OD {}", across.symbol));
    headings.push(format!("ID {}", across.symbol));
    if has_joints {
        headings.push(format!("joint OD {}", across.symbol));
    }
    headings.push(format!("mass {}", mass.symbol));
    headings.push(format!("yield {}", strength.symbol));
    let headings: Vec<&str> = headings.iter().map(String::as_str).collect();
    let mut table = Table::new(heading, if has_joints { 2 } else { 1 }, &headings);
    for entry in entries {
        let mut row = vec![entry.designation.clone()];
        row.extend(entry.joints.map(|joints| joints.connection.to_owned()));
        row.push(diameter(across, entry.od_m));
        row.push(diameter(across, entry.id_m));
        row.extend(entry.joints.map(|joints| diameter(across, joints.od_m)));
        row.push(format!(
            "{:.1}",
            mass.from_si(entry.mass_per_length_kg_per_m(STEEL_DENSITY_KG_PER_M3))
        ));
        row.push(format!("{:.0}", strength.from_si(entry.yield_strength_Pa)));
        table.row(row);
    }
    table.text()
}

fn casing_table(casings: &[Casing], units: UnitSet) -> String {
    let [across, mass] =
        [Dimension::Diameter, Dimension::MassPerLength].map(|dimension| dimension.unit_in(units));
    let headings = [
        "name".to_owned(),
        format!("OD {}", across.symbol),
        format!("ID {}", across.symbol),
        format!("drift {}", across.symbol),
        format!("mass {}", mass.symbol),
    ];
    let headings: Vec<&str> = headings.iter().map(String::as_str).collect();
    let mut table = Table::new("Casing", 1, &headings);
    for one in casings {
        table.row(vec![
            one.designation.clone(),
            diameter(across, one.od_m),
            diameter(across, one.id_m),
            diameter(across, one.drift_m),
            format!("{:.1}", mass.from_si(one.mass_per_length_kg_per_m)),
        ]);
    }
    table.text()
}

/// As the standards print it: to the thousandth of an inch, or the hundredth of a millimetre.
fn diameter(unit: &Unit, si: f64) -> String {
    let decimals = if unit.symbol == "in" { 3 } else { 2 };
    format!("{:.decimals$}", unit.from_si(si))
}
