//! The mud of a case.

use super::{
    chooser::{Chosen, label},
    reader::{Reader, agree, children, parent},
    row::Row,
    table::Table,
    unit_set::Measure,
};
use crate::{
    error::{ImportError, ImportErrorKind},
    fragment::{Block, Origin, Value},
};

const KEYS: [&str; 2] = ["well_id", "fluid_id"];

/// The keys of the mud of the chosen case.
pub(super) fn read<'a>(reader: &mut Reader<'a>, chosen: &Chosen<'a>) -> Result<Block, ImportError> {
    let mut block = Block::default();
    let Some(fluid) = fluid(reader, chosen)? else { return Ok(block) };
    let tests = children(reader.rows, Table::FluidTest, fluid, &KEYS)?;
    let sources: Vec<Row> = [fluid].into_iter().chain(tests).collect();
    let units = reader.units.clone();
    let first = |block: &mut Block, key, columns: &[&str], measure| {
        for row in &sources {
            for column in columns {
                if units.push(block, key, *row, column, measure)?.is_some() {
                    return Ok::<bool, ImportError>(true);
                }
            }
        }
        Ok(false)
    };
    let density = first(&mut block, "density", &["density", "base_density"], Measure::Density)?;
    let mut flow = Block::default();
    let viscous =
        first(&mut flow, "plastic_viscosity", &["plastic_viscosity"], Measure::Viscosity)?
            && first(&mut flow, "yield_point", &["yield_point"], Measure::ShearStress)?;
    let gel = first(&mut flow, "gel_strength", &["gels_10_min"], Measure::ShearStress)?;
    if !density {
        reader.left_out(format!("the mud '{}', which has no density", label(fluid)));
        return Ok(Block::default());
    }
    if viscous {
        let because = "the file has a plastic viscosity and a yield point".to_owned();
        block.push("rheology", Value::text("bingham"), Origin::Derived { from: because });
    }
    let is_used = |key: &str| if key == "gel_strength" { gel } else { viscous };
    block.entries.extend(flow.entries.into_iter().filter(|entry| is_used(entry.key)));
    block.remark = Some(label(fluid).to_owned());
    Ok(block)
}

/// Returns the fluid: the picked one, the case's, or the only one of the well.
fn fluid<'a>(reader: &mut Reader<'a>, chosen: &Chosen<'a>) -> Result<Option<Row<'a>>, ImportError> {
    let Some(case) = chosen.case else { return Ok(None) };
    let all = reader.rows.of(Table::Fluid);
    let mut own: Vec<Row> = all.filter(|row| agree(case, *row, &["well_id"])).collect();
    own.dedup_by(|a, b| a.same(*b));
    let names = || own.iter().map(|row| label(*row).to_owned()).collect::<Vec<_>>();
    if let Some(picked) = reader.choices.picked("fluid") {
        let called = |row: &&Row| {
            label(**row).eq_ignore_ascii_case(picked) || row.get("fluid_id") == Some(picked)
        };
        let kind = || ImportErrorKind::NoSuch {
            what: "fluid".to_owned(),
            name: picked.to_owned(),
            names: names(),
        };
        let found = own.iter().find(called).copied();
        return found.map(Some).ok_or_else(|| reader.rows.error(kind()));
    }
    if let Some(id) = case.get("fluid_id") {
        if let Some(found) = parent(reader.rows, Table::Fluid, case, &KEYS)? {
            return Ok(Some(found));
        }
        reader.read(format!("the case refers to the fluid '{id}', which the file does not have"));
    }
    match own[..] {
        [] => Ok(None),
        [only] => {
            reader.assumed(format!(
                "the mud is '{}', the only fluid of the well; the case names none",
                label(only)
            ));
            Ok(Some(only))
        }
        _ => {
            reader.left_out(format!(
                "the mud: the case names none, and the well has {}; pick one: --pick fluid=NAME",
                names().join(", ")
            ));
            Ok(None)
        }
    }
}
