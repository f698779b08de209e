//! WITSML 1.3.1.1, 1.4.1.1, 2.0 and 2.1: trajectories, tubulars, runs of the BHA, geometries of the
//! wellbore and mud reports.

mod bha_run;
mod body;
mod component;
mod fittings;
mod geometry;
mod measure;
mod mud_report;
mod object;
mod pipe;
mod sections;
mod trajectory;
mod tree;
mod tubular;

use object::Kind;

use self::{
    measure::{Source, short},
    object::{Object, Objects},
};
use crate::{
    choices::Choices,
    error::{ImportError, ImportErrorKind},
    fragment::{Contents, Entry, Fragment, Note, Origin, Value},
    input::Input,
    xml::{Element, Xml},
};

/// Roots of logs, which have their own reader.
const LOGS: &[&str] = &["logs", "log", "channelSet", "channel"];

/// Whether a file with this root is WITSML without logs.
pub(crate) fn is_witsml(root: &Element) -> bool {
    if LOGS.iter().any(|name| name.eq_ignore_ascii_case(&root.name)) {
        return false;
    }
    let named = Kind::of(&root.name).or(Kind::of_several(&root.name)).is_some();
    let spaces = ["witsml.org/schemas", "energyml/data/witsmlv2"];
    let in_space = |value: &str| spaces.iter().any(|space| value.contains(space));
    named || root.attributes.iter().any(|(_, value)| in_space(value))
}

/// Reads one object of each kind of a file.
pub(crate) fn read(input: Input, choices: &Choices) -> Result<Fragment, ImportError> {
    let objects = objects(input)?;
    let (name, objects) = objects;
    let source = Source { file: &name, choices };
    let mut fragment = Fragment::default();
    let mut labels = Vec::new();
    let mut well: Option<String> = None;
    for kind in Kind::ALL {
        let Some(object) = one(kind, &objects.read, &source)? else { continue };
        labels.push(object.label());
        if let Some(node) = object.well() {
            match &well {
                None => {
                    well = Some(node.text.clone());
                    let origin = Origin::at(format!("line {}, {}", node.line, node.name));
                    let value = Value::text(short(&node.text));
                    fragment.name = Some(Entry { key: "name", value, origin });
                }
                Some(well) if *well != node.text => {
                    fragment.notes.push(Note::Warning(format!(
                        "{} is of the well '{}', others of '{}': are they of one well?",
                        object.label(),
                        short(&node.text),
                        short(well)
                    )));
                }
                Some(_) => {}
            }
        }
        match kind {
            Kind::Trajectory => trajectory::read(object, &source, &mut fragment)?,
            Kind::Tubular => tubular::read(object, &source, &mut fragment)?,
            Kind::BhaRun => bha_run::read(object, &source, &mut fragment)?,
            Kind::Geometry => geometry::read(object, &source, &mut fragment)?,
            Kind::MudReport => mud_report::read(object, &source, &mut fragment)?,
        }
        let state = object.node.child("commonData").and_then(|data| data.text_of("itemState"));
        if let Some(state) = state.filter(|state| *state != "actual") {
            let text = format!("{}: its itemState is '{}'", object.label(), short(state));
            fragment.notes.push(Note::Read(text));
        }
    }
    for (other, count) in &objects.others {
        fragment.notes.push(Note::LeftOut(format!("{count} of <{}>: not read", short(other))));
    }
    fragment.what = format!("WITSML {}, {}", objects.version, labels.join(" and "));
    Ok(fragment)
}

/// Lists the objects of a file.
pub(crate) fn contents(input: Input) -> Result<Contents, ImportError> {
    let (_, objects) = objects(input)?;
    let uid =
        |object: &Object| object.uid().map_or(String::new(), |uid| format!(" ({})", short(uid)));
    let line = |object: &Object| {
        let well =
            object.well().map_or(String::new(), |well| format!(", of '{}'", short(&well.text)));
        format!("{}{}: {}{well}", object.label(), uid(object), object.counted())
    };
    let mut lines: Vec<String> = objects.read.iter().map(line).collect();
    lines.extend(
        objects.others.iter().map(|(name, count)| format!("{count} of <{name}>: not read")),
    );
    Ok(Contents { what: format!("WITSML {}", objects.version), lines, ..Contents::default() })
}

/// Returns the name of a file and its objects, of which there is at least one.
fn objects(input: Input) -> Result<(String, Objects), ImportError> {
    let mut xml = Xml::new(input);
    let name = xml.file().to_owned();
    let objects = Objects::read(&mut xml)?;
    if objects.read.is_empty() {
        let others: Vec<String> = objects.others.keys().map(|name| format!("<{name}>")).collect();
        let holds = if others.is_empty() { "nothing".to_owned() } else { others.join(", ") };
        let kinds = Kind::ALL.map(Kind::name).join(", ");
        let kind = ImportErrorKind::Refused(format!(
            "it is WITSML {} and holds {}; expected one of: {kinds}, log",
            objects.version,
            short(&holds)
        ));
        return Err(ImportError::new(&name, None, kind));
    }
    Ok((name, objects))
}

/// Returns the object of a kind: the only one, or the one picked by name or uid.
fn one<'a>(
    kind: Kind,
    objects: &'a [Object],
    source: &Source,
) -> Result<Option<&'a Object>, ImportError> {
    let of_kind: Vec<&Object> = objects.iter().filter(|object| object.kind == kind).collect();
    if let [] | [_] = of_kind[..] {
        return Ok(of_kind.first().copied());
    }
    let alike = |name: &str| of_kind.iter().filter(|object| object.name() == name).count();
    let names: Vec<String> = of_kind
        .iter()
        .map(|object| match (alike(&object.name()), object.uid()) {
            (2.., Some(uid)) => uid.to_owned(),
            _ => object.name(),
        })
        .collect();
    let what = kind.name().to_owned();
    let at = |kind| ImportError::new(source.file, None, kind);
    let Some(picked) = source.choices.picked(kind.name()) else {
        return Err(at(ImportErrorKind::Ambiguous { what, names }));
    };
    let found = (0..names.len())
        .find(|&index| names[index] == picked || of_kind[index].uid() == Some(picked));
    match found {
        Some(index) => Ok(Some(of_kind[index])),
        None => Err(at(ImportErrorKind::NoSuch { what, name: picked.to_owned(), names })),
    }
}
