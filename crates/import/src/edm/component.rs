//! A component of an assembly.

use wholestring::string::{
    Material,
    catalogue::{self, CatalogueEntry},
};

use super::{
    reader::{Reader, children},
    row::Row,
    table::Table,
    unit_set::{Found, Measure},
};
use crate::{
    error::{ImportError, ImportErrorKind},
    fragment::{Block, Origin, Value},
};

const KEYS: [&str; 4] = ["well_id", "wellbore_id", "assembly_id", "assembly_comp_id"];

/// Tolerance of diameters of one tubular, m, from rounding to thousandths of an inch.
const SAME_M: f64 = 2e-4;

/// Meaning of the codes of `sect_type_code`.
const NAMES: [(&[&str], &str); 20] = [
    (&["BIT", "PDC", "TRI"], BIT),
    (&["DP", "DRP"], "drill pipe"),
    (&["HW", "HWDP", "HWT"], "heavy-weight drill pipe"),
    (&["DC", "SDC", "COL"], "drill collar"),
    (&["NMDC", "MDC"], "non-magnetic drill collar"),
    (&["STAB", "STB", "IBS", "SBS", "NBS"], "stabiliser"),
    (&["MWD"], "MWD"),
    (&["LWD"], "LWD"),
    (&["MTR", "MOT", "PDM", "MM", "TUR"], "motor"),
    (&["RSS"], "rotary steerable"),
    (&["JAR"], "jar"),
    (&["ACC"], "accelerator"),
    (&["SUB", "BSUB"], "sub"),
    (&["XO", "XOV"], "crossover"),
    (&["UR", "HO", "REAM", "RMR"], "reamer"),
    (&["SHOCK", "SHK"], "shock sub"),
    (&["CT"], "coiled tubing"),
    (&["CAS", "CSG"], "casing"),
    (&["LIN", "LINER"], "liner"),
    (&["TUB", "TBG"], "tubing"),
];

const BIT: &str = "bit";

/// Name of a component from its code.
fn name(row: Row) -> Option<&'static str> {
    let code = row.get("sect_type_code")?;
    let known = |codes: &[&str]| codes.iter().any(|own| own.eq_ignore_ascii_case(code));
    NAMES.iter().find(|(codes, _)| known(codes)).map(|(_, name)| *name)
}

pub(super) fn is_bit(row: Row) -> bool {
    name(row) == Some(BIT)
}

/// Reads the component of a row; `None` if it has no length.
pub(super) fn read(
    reader: &mut Reader,
    row: Row,
    assembly: Option<Row>,
    first: bool,
) -> Result<Option<Block>, ImportError> {
    let described = row.get("catalog_key_desc").or(row.get("description")).or(row.get("comp_name"));
    let Some(length) = reader.units.positive(row, "length", Measure::Length)? else {
        reader.left_out(format!(
            "the component of line {} ({}), which has no length",
            row.line(),
            described.or(row.get("sect_type_code")).unwrap_or("without a name")
        ));
        return Ok(None);
    };
    let mut block = Block { remark: described.map(str::to_owned), ..Block::default() };
    let code = row.get("sect_type_code").unwrap_or_default();
    let called = match name(row) {
        Some(name) => name.to_owned(),
        None => {
            let called = row.get("comp_name").unwrap_or(code);
            let called = if called.is_empty() { "component" } else { called };
            reader.read(format!(
                "the code '{code}' of line {} is not known; its component is called '{called}'",
                row.line()
            ));
            called.to_owned()
        }
    };
    block.push(
        "component",
        Value::text(called),
        Origin::written(row.place("sect_type_code"), code),
    );
    block.push("length", length.value(), Origin::at(row.place("length")));
    let listed = diameters(reader, row, assembly, first, &mut block)?;
    let is_listed = listed.is_some();
    mass(reader, row, listed, &mut block)?;
    touching(reader, row, length, is_listed, &mut block)?;
    reader.units.push(&mut block, "yield_strength", row, "min_yield_stress", Measure::Stress)?;
    reader.units.push(&mut block, "make_up_torque", row, "makeup_torque", Measure::Torque)?;
    Ok(Some(block))
}

/// Adds the catalogue entry that the row plainly is, or its diameters; returns the entry.
fn diameters(
    reader: &mut Reader,
    row: Row,
    assembly: Option<Row>,
    first: bool,
    block: &mut Block,
) -> Result<Option<CatalogueEntry>, ImportError> {
    let od = reader.units.positive(row, "od_body", Measure::Diameter)?;
    let id = reader.units.quantity(row, "id_body", Measure::Diameter)?;
    if let (Some(od), Some(id), Some(described)) = (od, id, row.get("catalog_key_desc"))
        && let Ok(entry) = catalogue::find(described)
    {
        let same = |found: Found, entry_m: f64| (found.si() - entry_m).abs() < SAME_M;
        if same(od, entry.od_m) && same(id, entry.id_m) {
            let place = row.place("catalog_key_desc");
            let agrees = format!("{described}; od_body and id_body agree");
            block.push(
                "catalogue",
                Value::text(&entry.designation),
                Origin::written(place, agrees),
            );
            return Ok(Some(entry));
        }
        reader.warning(format!(
            "line {} is called '{described}', but its diameters {} and {} are not that one's; the \
             diameters are used",
            row.line(),
            od.text(),
            id.text()
        ));
    }
    let od = match od {
        Some(od) => {
            block.push("od", od.value(), Origin::at(row.place("od_body")));
            od
        }
        None => size(reader, row, assembly, block)?,
    };
    match id.filter(|id| id.number > 0.0) {
        Some(id) if id.si() < od.si() => {
            block.push("id", id.value(), Origin::at(row.place("id_body")));
        }
        Some(id) => {
            let kind = ImportErrorKind::OutOfRange {
                what: "inside diameter".to_owned(),
                found: id.text(),
                expected: format!("less than the outside one, {}", od.text()),
            };
            return Err(row.error("id_body", kind));
        }
        None if first => {}
        None => {
            let because = "the file has no id_body; solid".to_owned();
            let unit = reader.units.of(Measure::Diameter);
            block.push("id", Value::quantity(0.0, unit), Origin::Assumed { because });
            reader.assumed(format!(
                "the component of line {} is solid, without an id_body",
                row.line()
            ));
        }
    }
    Ok(None)
}

/// Diameter of a bit whose body has none: its size, or that of the hole.
fn size(
    reader: &mut Reader,
    row: Row,
    assembly: Option<Row>,
    block: &mut Block,
) -> Result<Found, ImportError> {
    let missing = || {
        let what = "the outside diameter of the component".to_owned();
        row.error("od_body", ImportErrorKind::Missing { what })
    };
    if !is_bit(row) {
        return Err(missing());
    }
    let mut found = Vec::new();
    for bit in children(reader.rows, Table::Bit, row, &KEYS)? {
        found.push((bit, "bit_size"));
    }
    found.extend(assembly.map(|assembly| (assembly, "hole_size")));
    for (row, column) in found {
        if let Some(size) = reader.units.positive(row, column, Measure::Diameter)? {
            let from = format!("{}, because the bit has no od_body", row.place(column));
            block.push("od", size.value(), Origin::Derived { from });
            return Ok(size);
        }
    }
    Err(missing())
}

/// Adds the weight, with a warning where it is the nominal one of drill pipe, which excludes tool
/// joints.
fn mass(
    reader: &mut Reader,
    row: Row,
    listed: Option<CatalogueEntry>,
    block: &mut Block,
) -> Result<(), ImportError> {
    let column = "approximate_weight";
    let units = reader.units.clone();
    let Some(mass) = units.push(block, "mass_per_length", row, column, Measure::LinearWeight)?
    else {
        return Ok(());
    };
    let si_m = |column| units.positive(row, column, Measure::Diameter).map(|od| od.map(Found::si));
    let (Some(od_m), Some(id_m)) = (si_m("od_body")?, si_m("id_body")?) else { return Ok(()) };
    if listed.is_none() && name(row) != Some("drill pipe") {
        return Ok(());
    }
    if let Some(pipe) = catalogue::nominal_pipe(listed.as_ref(), od_m, id_m, mass.si()) {
        let with_joints = pipe.mass_per_length_kg_per_m(Material::STEEL.density_kg_per_m3);
        reader.warning(format!(
            "the approximate_weight of line {}, {}, is the NOMINAL WEIGHT of '{}', without tool \
             joints: with them it weighs {:.1} {}; give that as mass_per_length, or catalogue alone",
            row.line(),
            mass.text(),
            pipe.designation,
            mass.unit.from_si(with_joints),
            mass.unit.symbol
        ));
    }
    Ok(())
}

/// Adds the parts that touch the wall: blades, or tool joints.
fn touching(
    reader: &mut Reader,
    row: Row,
    length: Found,
    listed: bool,
    block: &mut Block,
) -> Result<(), ImportError> {
    let units = reader.units.clone();
    let body = units.positive(row, "od_body", Measure::Diameter)?;
    let beyond = |found: &Found| body.is_none_or(|body| found.si() > body.si() + SAME_M);
    let mut blades = None;
    for stabiliser in children(reader.rows, Table::Stabiliser, row, &KEYS)? {
        let od = units.positive(stabiliser, "stab_blade_od", Measure::Diameter)?;
        blades = od.map(|od| (od, stabiliser, "stab_blade_od", "stab_blade_length")).or(blades);
    }
    let stands_out = ["stabiliser", "reamer"].iter().any(|own| name(row) == Some(own));
    if blades.is_none() && stands_out {
        let od = units.positive(row, "od_max", Measure::Diameter)?;
        blades = od.map(|od| (od, row, "od_max", "blade_length"));
    }
    if let Some((od, from, od_column, length_column)) = blades.filter(|(od, ..)| beyond(od)) {
        if listed {
            reader.left_out(format!(
                "the blades of line {}, because its catalogue entry has tool joints",
                row.line()
            ));
            return Ok(());
        }
        block.push("blade_od", od.value(), Origin::at(from.place(od_column)));
        let blade = units.positive(from, length_column, Measure::Length)?;
        if let Some(blade) = blade.filter(|blade| blade.si() <= length.si()) {
            block.push("blade_length", blade.value(), Origin::at(from.place(length_column)));
        }
        return Ok(());
    }
    if stands_out {
        reader.left_out(format!(
            "the blades of the {} of line {}: the file has no diameter of them beyond the body's",
            name(row).unwrap_or_default(),
            row.line()
        ));
    }
    let joint = units.positive(row, "od_connection", Measure::Diameter)?.filter(beyond);
    let Some(joint) = joint.filter(|_| !is_bit(row)) else { return Ok(()) };
    let spacing = units.positive(row, "average_joint_length", Measure::Length)?;
    if spacing.is_none() && !listed {
        reader.left_out(format!(
            "the tool joints of {} of line {}, because there is no average_joint_length",
            joint.text(),
            row.line()
        ));
        return Ok(());
    }
    block.push("joint_od", joint.value(), Origin::at(row.place("od_connection")));
    if let Some(spacing) = spacing {
        let place = row.place("average_joint_length");
        block.push("joint_spacing", spacing.value(), Origin::at(place));
    }
    Ok(())
}
