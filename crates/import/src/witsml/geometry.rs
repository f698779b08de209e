//! `wbGeometry`, since 2.0 `WellboreGeometry`: the hole.

use wholestring::well::casing;
use wholestring_units::{Dimension, number_text};

use super::{
    measure::{Measure, Source, datum, name_of, short},
    object::{Kind, Object},
    sections::{Wall, innermost},
    tree::Node,
};
use crate::{
    error::{ImportError, ImportErrorKind},
    fragment::{Block, Entry, Fragment, Note, Origin, Value},
};

/// Maximum number of sections of a wellbore. A well has fewer than ten.
const MOST: usize = 500;

/// Maximum measured depth of a hole, m.
const DEEPEST_M: f64 = 1e5;

/// Kinds of pipe in which a string moves.
const CASED: &[&str] = &["casing", "liner", "conductor", "curved conductor", "riser"];

/// A section of the file.
struct Section<'a> {
    node: &'a Node,
    kind: String,
    /// Keys of the case except kind and depths.
    entries: Vec<Entry>,
}

/// Reads the sections of the hole that the string touches.
pub(crate) fn read(
    object: &Object,
    source: &Source,
    fragment: &mut Fragment,
) -> Result<(), ImportError> {
    let notes = &mut fragment.notes;
    let (mut sections, mut walls) = (Vec::new(), Vec::new());
    for node in object.node.all(Kind::Geometry.parts().0) {
        if walls.len() == MOST {
            let found = format!("a geometry of more than {MOST} sections");
            let kind = ImportErrorKind::TooMuch { found, most: MOST.to_string() };
            return Err(source.error(node.line, kind));
        }
        if let Some((section, wall)) = section(node, source, notes)? {
            sections.push(section);
            walls.push(wall);
        }
    }
    if sections.is_empty() {
        let what = format!("a section of {} in which a string moves", object.label());
        return Err(source.error(object.node.line, ImportErrorKind::Missing { what }));
    }
    let stretches = innermost(&walls);
    for (index, (section, wall)) in sections.iter().zip(&walls).enumerate() {
        if !stretches.iter().any(|stretch| stretch.wall == index) {
            notes.push(Note::LeftOut(format!(
                "{} from {} to {}: hidden behind other sections",
                label(section),
                wall.top.written,
                wall.bottom.written
            )));
        }
    }
    notes.extend(datum(depth(sections[0].node, "mdTop|mdMin")));
    for stretch in &stretches {
        let section = &sections[stretch.wall];
        let mut block = Block { remark: remark(section), ..Block::default() };
        let cased = walls[stretch.wall].cased;
        let kind = Value::text(if cased { "casing" } else { "open" });
        let written = Origin::written(place(section.node, "typeHoleCasing"), &section.kind);
        block.push("kind", kind, written);
        if stretch.gap {
            block.push("from", stretch.from.value(), stretch.from.origin.clone());
            notes.push(Note::LeftOut(format!(
                "the hole above {}, the top of {}: no section describes it; write it into the case",
                stretch.from.written,
                label(section)
            )));
        }
        if stretch.several {
            notes.push(Note::Assumed(format!(
                "several open holes end at or below {}: the last one in the file is used there",
                stretch.to.written
            )));
        }
        block.push("to", stretch.to.value(), stretch.to.origin.clone());
        block.entries.extend(section.entries.iter().cloned());
        fragment.hole.push(block);
    }
    Ok(())
}

/// Reads a section in which a string may move; `None` for other sections.
fn section<'a>(
    node: &'a Node,
    source: &Source,
    notes: &mut Vec<Note>,
) -> Result<Option<(Section<'a>, Wall)>, ImportError> {
    let kind = short(&node.text_of("typeHoleCasing").unwrap_or_default().to_lowercase());
    let cased = CASED.contains(&kind.as_str());
    if kind.is_empty() {
        let what = "typeHoleCasing of this section".to_owned();
        return Err(source.error(node.line, ImportErrorKind::Missing { what }));
    }
    if !cased && kind != "open hole" {
        notes.push(Note::LeftOut(format!("the section of '{kind}' in line {}", node.line)));
        return Ok(None);
    }
    let edge = |names: &str| -> Result<Measure, ImportError> {
        let found = match depth(node, names) {
            Some(depth) => {
                source.measure_of(depth, name_of(names), interval_unit(node), Dimension::Length)?
            }
            None => None,
        };
        let what =
            || ImportErrorKind::Missing { what: format!("{} of this section", name_of(names)) };
        let found = found.ok_or_else(|| source.error(node.line, what()))?;
        match (0.0..=DEEPEST_M).contains(&found.si()) {
            true => Ok(found),
            false => Err(source.out_of_range(&found, name_of(names), "0 to 100 km")),
        }
    };
    let (top, bottom) = (edge("mdTop|mdMin")?, edge("mdBottom|mdBase|mdMax")?);
    if bottom.si() <= top.si() {
        let expected = format!("more than the mdTop, {}", top.written);
        return Err(source.out_of_range(&bottom, "mdBottom", &expected));
    }
    let mut section = Section { node, kind, entries: Vec::new() };
    let id_m = width(&mut section, cased, source, notes)?;
    if let Some(friction) = node.child("factFric")
        && let Some(number) = source.number_of(friction, "factFric")?
    {
        if !(0.0..=wholestring_case::MAX_FRICTION).contains(&number) {
            let kind = ImportErrorKind::OutOfRange {
                what: "factFric".to_owned(),
                found: short(&friction.text),
                expected: format!("0 to {}", wholestring_case::MAX_FRICTION),
            };
            return Err(source.error(friction.line, kind));
        }
        if number > 0.0 {
            let origin = Origin::at(place(node, "factFric"));
            section.entries.push(Entry { key: "friction", value: Value::Number(number), origin });
        } else {
            let text = format!("the factFric of {}, which is 0: not known", label(&section));
            notes.push(Note::LeftOut(text));
        }
    }
    Ok(Some((section, Wall { top, bottom, cased, id_m })))
}

/// Inside diameter of a section, as given or from the casing of its size and weight.
fn width(
    section: &mut Section,
    cased: bool,
    source: &Source,
    notes: &mut Vec<Note>,
) -> Result<Option<f64>, ImportError> {
    let (node, name) = (section.node, label(section));
    let inside = source.positive(node, "idSection", Dimension::Diameter, (&name, notes))?;
    let outside = source.positive(node, "odSection", Dimension::Diameter, (&name, notes))?;
    let mut push = |key, value, origin| section.entries.push(Entry { key, value, origin });
    match (inside, outside) {
        (Some(inside), _) => {
            push("diameter", inside.value(), inside.origin.clone());
            Ok(Some(inside.si()))
        }
        (None, Some(outside)) if !cased => {
            let text = format!("{name} has no idSection: its odSection, {}", outside.written);
            notes.push(Note::Assumed(text));
            push("diameter", outside.value(), outside.origin.clone());
            Ok(Some(outside.si()))
        }
        (None, Some(outside)) => {
            let weight = (&name[..], &mut *notes);
            let weight = source.positive(node, "wtPerLen", Dimension::MassPerLength, weight)?;
            let found = weight.as_ref().and_then(|weight| pipe(outside.si(), weight.si()));
            match found {
                Some(pipe) => {
                    let weight = weight.map_or(String::new(), |weight| weight.written);
                    let from = format!(
                        "line {}, no idSection: casing of odSection {} and wtPerLen {weight}",
                        outside.line, outside.written
                    );
                    push("casing", Value::text(pipe.designation), Origin::Derived { from });
                    Ok(Some(pipe.id_m))
                }
                None => {
                    notes.push(Note::LeftOut(format!(
                        "the diameter of {name}: it has no idSection, and no casing of API Spec \
                         5CT has its odSection of {} and its wtPerLen; write it into the case",
                        outside.written
                    )));
                    Ok(None)
                }
            }
        }
        (None, None) => {
            notes.push(Note::LeftOut(format!(
                "the diameter of {name}: it has no idSection; write it into the case"
            )));
            Ok(None)
        }
    }
}

/// Casing of a size and a nominal weight, m and kg/m.
fn pipe(od_m: f64, mass_kg_per_m: f64) -> Option<casing::Casing> {
    let inches = Dimension::Diameter.find_unit("in")?.from_si(od_m);
    let pounds = Dimension::MassPerLength.find_unit("lb/ft")?.from_si(mass_kg_per_m);
    let pounds = (pounds * 100.0).round() / 100.0;
    casing::find(&format!("{} in {} lb/ft", number_text(inches), number_text(pounds))).ok()
}

/// Start or end depth of a section, in the section itself or, since 2.0, in its interval.
fn depth<'a>(node: &'a Node, names: &str) -> Option<&'a Node> {
    node.child(names).or_else(|| interval(node)?.child(names))
}

fn interval(node: &Node) -> Option<&Node> {
    node.child("sectionMdInterval|mdInterval")
}

/// Unit of an interval, which 2.1 gives as a sibling of its depths.
fn interval_unit(node: &Node) -> Option<&str> {
    let interval = interval(node)?;
    interval.text_of("uom").or_else(|| interval.attribute("uom"))
}

fn place(node: &Node, name: &str) -> String {
    format!("line {}, {name}", node.child(name).map_or(node.line, |child| child.line))
}

fn label(section: &Section) -> String {
    format!("the {} in line {}", section.kind, section.node.line)
}

fn remark(section: &Section) -> Option<String> {
    let grade = section.node.text_of("grade").map(|grade| format!(", grade {}", short(grade)));
    let outside = section.node.child("odSection").filter(|od| !od.text.is_empty());
    let outside = outside.map(|od| {
        format!(", outside {} {}", short(&od.text), short(od.attribute("uom").unwrap_or_default()))
    });
    let known = outside.is_some() || grade.is_some();
    let (outside, grade) = (outside.unwrap_or_default(), grade.unwrap_or_default());
    known.then(|| format!("{}{}{grade}", section.kind, outside.trim_end()))
}
