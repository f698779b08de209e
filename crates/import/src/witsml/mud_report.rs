//! `mudReport`, since 2.0 `FluidsReport`: density and rheology of the mud.

use wholestring_units::Dimension;

use super::{
    measure::{Measure, Source, short},
    object::Object,
    tree::Node,
};
use crate::{
    error::ImportError,
    fragment::{Fragment, Note, Origin, Value},
};

/// The mud of the last fluid that has a density.
pub(crate) fn read(
    object: &Object,
    source: &Source,
    fragment: &mut Fragment,
) -> Result<(), ImportError> {
    let notes = &mut fragment.notes;
    let mut fluids: Vec<(&Node, Measure)> = Vec::new();
    for node in object.node.all("fluid") {
        let density = source.measure(node, "density", Dimension::Density)?;
        fluids.extend(density.filter(|density| density.number > 0.0).map(|found| (node, found)));
    }
    let Some((node, density)) = fluids.last() else {
        let text = format!("{}: none of its fluids has a density", object.label());
        notes.push(Note::LeftOut(text));
        return Ok(());
    };
    if fluids.len() > 1 {
        notes.push(Note::Assumed(format!(
            "of {} fluids of {} the mud is the last, of {} in line {}",
            fluids.len(),
            object.label(),
            density.written,
            density.line
        )));
    }
    if let Some(kind) = node.text_of("type") {
        notes.push(Note::Read(format!("the mud is '{}'", short(kind))));
    }
    fragment.mud.push("density", density.value(), density.origin.clone());
    let viscosity = source.optional(node, "pv", Dimension::Viscosity, notes)?;
    let yield_point = source.optional(node, "yp", Dimension::ShearStress, notes)?;
    if let (Some(viscosity), Some(yield_point)) = (viscosity, yield_point)
        && viscosity.number > 0.0
        && yield_point.number >= 0.0
    {
        let from = "pv and yp, which are those of a Bingham mud".to_owned();
        fragment.mud.push("rheology", Value::text("bingham"), Origin::Derived { from });
        fragment.mud.push("plastic_viscosity", viscosity.value(), viscosity.origin);
        fragment.mud.push("yield_point", yield_point.value(), yield_point.origin);
    }
    let gel = source.optional(node, "gel10Min", Dimension::ShearStress, notes)?;
    if let Some(gel) = gel.filter(|gel| gel.number > 0.0) {
        fragment.mud.push("gel_strength", gel.value(), gel.origin);
    }
    Ok(())
}
