//! Objects of a WITSML file.

use std::collections::BTreeMap;

use super::{
    measure::short,
    tree::{Budget, Node},
};
use crate::{
    error::{ImportError, ImportErrorKind},
    xml::{Element, Event, Xml},
};

/// Maximum number of objects in a file. Each object has hundreds of lines; a store returns some
/// tens at a time.
const MOST: usize = 1000;

/// An object of a kind that is read.
#[derive(Debug)]
pub(crate) struct Object {
    pub(crate) kind: Kind,
    pub(crate) node: Node,
}

impl Object {
    /// Its name: `name` before 2.0, the title of its citation since; its uid where it has none.
    pub(crate) fn name(&self) -> String {
        let title = || self.node.child("Citation").and_then(|citation| citation.text_of("Title"));
        let name = self.node.text_of("name").or_else(title);
        short(name.or_else(|| self.uid()).unwrap_or("without a name"))
    }

    /// Its `uid`, which distinguishes it from other objects of the same name.
    pub(crate) fn uid(&self) -> Option<&str> {
        self.node.attribute("uid").or_else(|| self.node.attribute("uuid"))
    }

    /// The well it belongs to, or since 2.0 the wellbore.
    pub(crate) fn well(&self) -> Option<&Node> {
        let well = self.node.child("nameWell").filter(|well| !well.text.is_empty());
        well.or_else(|| self.node.child("Wellbore")?.child("Title"))
    }

    /// Label in messages: `trajectory 'Plan #2'`.
    pub(crate) fn label(&self) -> String {
        format!("{} '{}'", self.kind.name(), self.name())
    }

    /// Number of its parts, in words.
    pub(crate) fn counted(&self) -> String {
        let (names, noun) = self.kind.parts();
        match self.node.all(names).count() {
            1 => format!("1 {noun}"),
            count if noun.starts_with("set") => format!("{count} {}", noun.replace("set", "sets")),
            count => format!("{count} {noun}s"),
        }
    }
}

/// Contents of a WITSML file.
#[derive(Debug)]
pub(crate) struct Objects {
    /// WITSML version that the file declares, in the form used in messages.
    pub(crate) version: String,
    /// Objects of the kinds that are read.
    pub(crate) read: Vec<Object>,
    /// Number of objects of each kind that is not read.
    pub(crate) others: BTreeMap<String, usize>,
}

impl Objects {
    /// Reads a file to its end.
    pub(crate) fn read(xml: &mut Xml) -> Result<Self, ImportError> {
        let mut budget = Budget::default();
        let mut objects =
            Self { version: String::new(), read: Vec::new(), others: BTreeMap::new() };
        let mut rooted = false;
        loop {
            let element = match xml.next()? {
                Event::Start(element) => element,
                Event::Eof => return Ok(objects),
                Event::Text(_) | Event::End => continue,
            };
            let root = !std::mem::replace(&mut rooted, true);
            if root {
                objects.version = version(&element);
            }
            if let Some(kind) = Kind::of(&element.name) {
                if objects.read.len() == MOST {
                    let found = format!("more than {MOST} objects");
                    let kind = ImportErrorKind::TooMuch { found, most: MOST.to_string() };
                    return Err(xml.error(kind));
                }
                let node = Node::read(element, xml, &mut budget)?;
                objects.read.push(Object { kind, node });
            } else if !root || element.attribute("schemaVersion").is_some() {
                // The `documentInfo` element only describes the author and is not an object.
                if element.name != "documentInfo" && objects.others.len() < MOST {
                    *objects.others.entry(element.name).or_default() += 1;
                }
                xml.skip()?;
            }
        }
    }
}

/// Version such as `1.4.1.1`, from the attributes of the root or from its namespace.
fn version(root: &Element) -> String {
    let version = root.attribute("version").or(root.attribute("schemaVersion"));
    let space = |part: &str| root.attributes.iter().any(|(_, value)| value.contains(part));
    match version.filter(|version| !version.is_empty()) {
        Some(version) => short(version),
        None if space("schemas/131") => "1.3.1.1".to_owned(),
        None if space("schemas/1series") => "1.4.1.1".to_owned(),
        None if space("witsmlv2") => "2".to_owned(),
        None => "of no version".to_owned(),
    }
}

// WITSML objects that are read.

/// A WITSML object that is read, in any version.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Trajectory,
    Tubular,
    BhaRun,
    Geometry,
    MudReport,
}

impl Kind {
    pub(crate) const ALL: [Kind; 5] =
        [Kind::Trajectory, Kind::Geometry, Kind::MudReport, Kind::Tubular, Kind::BhaRun];

    /// Its name in 1.3 and 1.4, which `--pick` also accepts, and that in 2.0 and 2.1 where it
    /// differs by more than capitals.
    fn names(self) -> [&'static str; 2] {
        match self {
            Kind::Trajectory => ["trajectory"; 2],
            Kind::Tubular => ["tubular"; 2],
            Kind::BhaRun => ["bhaRun"; 2],
            Kind::Geometry => ["wbGeometry", "WellboreGeometry"],
            Kind::MudReport => ["mudReport", "FluidsReport"],
        }
    }

    /// Its name in `--pick` and in messages.
    pub(crate) fn name(self) -> &'static str {
        self.names()[0]
    }

    /// The object of this name.
    pub(crate) fn of(name: &str) -> Option<Self> {
        let is = |kind: &Kind| kind.names().iter().any(|own| own.eq_ignore_ascii_case(name));
        Self::ALL.into_iter().find(is)
    }

    /// Returns the object whose plural element has this name: `trajectorys`.
    pub(crate) fn of_several(name: &str) -> Option<Self> {
        Self::of(name.strip_suffix('s')?)
    }

    /// Elements that it contains many of, and their name in messages.
    pub(crate) fn parts(self) -> (&'static str, &'static str) {
        match self {
            Kind::Trajectory => ("trajectoryStation", "station"),
            Kind::Tubular => ("tubularComponent", "component"),
            Kind::BhaRun => ("drillingParams", "set of drilling parameters"),
            Kind::Geometry => ("wbGeometrySection|WellboreGeometrySection", "section"),
            Kind::MudReport => ("fluid", "fluid"),
        }
    }
}
