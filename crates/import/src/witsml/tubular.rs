//! `tubular`: the string.

use std::collections::BTreeSet;

use wholestring_units::{Dimension, number_text};

use super::{
    component::Component,
    measure::{Source, short},
    object::Object,
};
use crate::{
    error::{ImportError, ImportErrorKind},
    fragment::{Fragment, Note},
};

/// Maximum number of components of a string. A string has some tens.
const MOST: usize = 2000;

/// Elements of a component that are read; other elements are listed in a note.
const READ: &str = "typeTubularComp|TypeTubularComponent|sequence|description|id|od|len|lenJointAv|\
                    wtPerLen|grade|tensYield|vendor|model|count|connection|stabilizer|holeOpener|bend|\
                    bitRecord|mwdTool|rotarySteerableTool|nameTag";

/// The components of a tubular, from the bit up.
pub(crate) fn read(
    object: &Object,
    source: &Source,
    fragment: &mut Fragment,
) -> Result<(), ImportError> {
    let notes = &mut fragment.notes;
    let mut components = Vec::new();
    for node in object.node.all("tubularComponent") {
        if components.len() == MOST {
            let found = format!("a tubular of more than {MOST} components");
            let kind = ImportErrorKind::TooMuch { found, most: MOST.to_string() };
            return Err(source.error(node.line, kind));
        }
        components.push(Component::of(node, source)?);
    }
    if components.is_empty() {
        let what = format!("a tubularComponent of {}", object.label());
        return Err(source.error(object.node.line, ImportErrorKind::Missing { what }));
    }
    order(&mut components, object, source, notes)?;
    let hole = source.measure(&object.node, "diaHoleAssy", Dimension::Diameter)?;
    let hole = hole.filter(|hole| hole.number > 0.0);
    let (mut length_m, mut unit) = (0.0, None);
    for component in &components {
        if let Some(length) = component.length(source)? {
            length_m += length.si();
            unit = unit.or(Some(length.unit));
        }
        fragment.string.push(component.block(hole.as_ref(), source, notes)?);
    }
    sensors(&mut fragment.string, notes);
    let long = unit.map_or(String::new(), |unit| {
        let tenths = (unit.from_si(length_m) * 10.0).round() / 10.0;
        format!(", {} {} long", number_text(tenths), unit.symbol)
    });
    notes.push(Note::Read(format!("{}: {}{long}", object.label(), object.counted())));
    let assembly =
        object.node.text_of("typeTubularAssy").filter(|assembly| *assembly != "drilling");
    if let Some(assembly) = assembly {
        let text = format!("{}: its typeTubularAssy is '{}'", object.label(), short(assembly));
        notes.push(Note::Read(text));
    }
    let unread: BTreeSet<&str> = components
        .iter()
        .flat_map(|component| component.node.children())
        .filter(|child| !child.is(READ))
        .map(|child| child.name.as_str())
        .collect();
    if !unread.is_empty() {
        let names: Vec<&str> = unread.into_iter().collect();
        let text =
            format!("elements of the components that have no key in a case: {}", names.join(", "));
        notes.push(Note::LeftOut(text.chars().take(1000).collect()));
    }
    Ok(())
}

/// Sorts the components from the bit up.
fn order(
    components: &mut [Component],
    object: &Object,
    source: &Source,
    notes: &mut Vec<Note>,
) -> Result<(), ImportError> {
    if components.iter().all(|component| component.sequence.is_none()) {
        if components.len() > 1 {
            let text = "no component has a sequence: in the order of the file".to_owned();
            notes.push(Note::Assumed(text));
        }
    } else {
        let missing = |component: &&Component| component.sequence.is_none();
        if let Some(component) = components.iter().find(missing) {
            let what = format!("the sequence of {}, which others have,", component.label());
            let kind = ImportErrorKind::Missing { what };
            return Err(source.error(component.node.line, kind));
        }
        components.sort_by_key(|component| component.sequence);
        let twice = components.windows(2).find(|pair| pair[0].sequence == pair[1].sequence);
        if let Some([first, second]) = twice {
            let kind = ImportErrorKind::Refused(format!(
                "{} has the same sequence as that in line {}; which of them is nearer to the bit?",
                second.label(),
                first.node.line
            ));
            return Err(source.error(second.node.line, kind));
        }
    }
    let bits = |component: &Component| component.is_bit();
    let last = components.len() - 1;
    match components.iter().position(bits) {
        Some(0) => {
            notes.push(Note::Read(format!(
                "the order is from the bit up: {} first",
                components[0].label()
            )));
        }
        Some(index) if index == last => {
            notes.push(Note::Read(format!(
                "the order is reversed: {} is last, so that the components are listed from the top \
                 down",
                components[last].label()
            )));
            components.reverse();
        }
        Some(index) => {
            let kind = ImportErrorKind::Refused(format!(
                "the bit, {}, is neither the first nor the last of {}",
                components[index].label(),
                short(&object.counted())
            ));
            return Err(source.error(components[index].node.line, kind));
        }
        None => {
            notes.push(Note::Assumed(format!(
                "no component is a bit: {} is the lowest, because WITSML numbers components in \
                 the order in which they enter the hole",
                components[0].label()
            )));
        }
    }
    Ok(())
}

/// Keeps one survey sensor, the lowest.
fn sensors(string: &mut [crate::fragment::Block], notes: &mut Vec<Note>) {
    let mut found = 0;
    for block in string.iter_mut() {
        let count = block.entries.len();
        if found > 0 {
            block.entries.retain(|entry| entry.key != "survey_sensor");
        }
        found += usize::from(count != block.entries.len() || block.get("survey_sensor").is_some());
    }
    if found > 1 {
        let text = format!("of {found} directional sensors all but the lowest");
        notes.push(Note::LeftOut(text));
    }
}
