//! Search of tubulars that a case can name and of common rig equipment by words.

use wholestring::{
    rig::catalogue as rigs,
    string::catalogue::{self, CatalogueEntry, PipeClass, TubularKind, describes},
    well::casing::{self, Casing},
};

/// Source of a user's own casings.
const OWN_CATALOGUE: &str = "a catalogue of one's own";

/// Kinds of tubulars of a string, and the words that find them.
const KINDS: [(TubularKind, &str); 4] = [
    (TubularKind::DrillPipe, "drill pipe dp"),
    (TubularKind::HeavyWeight, "heavy-weight drill pipe hwdp hwt"),
    (TubularKind::Collar, "drill collars dc"),
    (TubularKind::CoiledTubing, "coiled tubing ct"),
];

/// The words that find casing, top drives and hoists.
const CASING_WORDS: &str = "casing csg liner";
const TOP_DRIVE_WORDS: &str = "rig";
const HOIST_WORDS: &str = "rig hoists";

/// Catalogue entries that match a query.
#[derive(Debug)]
pub struct Found {
    /// Tubulars of a string by kind, each kind with at least one entry.
    pub string: Vec<(TubularKind, Vec<CatalogueEntry>)>,
    /// Casings, the user's own first.
    pub casings: Vec<Casing>,
    /// Number of the user's own casings among them.
    pub own_casings: usize,
    /// Top drives.
    pub top_drives: Vec<rigs::TopDriveClass>,
    /// Hoists.
    pub hoists: Vec<rigs::HoistClass>,
}

impl Found {
    /// Finds the entries that match all of these words and numbers, whole or shortened; without
    /// any, everything. Worn drill pipe and grades of casing are found only if the query contains
    /// their word. `own` and `own_casings` come first in each kind.
    pub fn described(query: &str, own: &[CatalogueEntry], own_casings: &[Casing]) -> Self {
        let class = PipeClass::ALL.into_iter().rfind(|class| describes(query, class.suffix()));
        let class = class.unwrap_or_default();
        let entries = catalogue::entries().into_iter().map(|entry| match entry.kind {
            TubularKind::DrillPipe if class != PipeClass::New => entry.worn(class),
            _ => entry,
        });
        let entries: Vec<CatalogueEntry> = own.iter().cloned().chain(entries).collect();
        let found = KINDS.iter().map(|(kind, words)| {
            let alike = entries.iter().filter(|entry| entry.kind == *kind);
            let found = alike.filter(|entry| {
                let connection =
                    entry.connection.as_ref().map_or("", |connection| connection.name.as_ref());
                describes(&format!("{} {words} {connection}", entry.designation), query)
            });
            (*kind, found.cloned().collect::<Vec<_>>())
        });
        let string = found.filter(|(_, entries)| !entries.is_empty()).collect();
        let grade = casing::grades().find(|grade| describes(query, grade.name));
        let name = grade.map_or("", |grade| grade.name);
        let mut casings = casing::entries();
        casings.iter_mut().for_each(|one| one.grade = grade);
        casings
            .retain(|one| describes(&format!("{} {name} {CASING_WORDS}", one.designation), query));
        let is_found =
            |one: &&Casing| describes(&format!("{} {CASING_WORDS}", one.designation), query);
        let found: Vec<Casing> = own_casings.iter().filter(is_found).cloned().collect();
        let own_casings = found.len();
        let casings = [found, casings].concat();
        let mut top_drives = rigs::top_drives();
        top_drives
            .retain(|one| describes(&format!("{} {TOP_DRIVE_WORDS}", one.designation), query));
        let mut hoists = rigs::hoists();
        hoists.retain(|one| describes(&format!("{} {HOIST_WORDS}", one.designation), query));
        Self { string, casings, own_casings, top_drives, hoists }
    }

    /// Whether nothing was found.
    pub fn is_empty(&self) -> bool {
        let Self { string, casings, top_drives, hoists, .. } = self;
        string.is_empty() && casings.is_empty() && top_drives.is_empty() && hoists.is_empty()
    }

    /// Whether there are entries that a case can name.
    pub fn has_tubulars(&self) -> bool {
        !self.string.is_empty() || !self.casings.is_empty()
    }

    /// Sources of all entries, in their order.
    pub fn sources(&self) -> Vec<String> {
        let entries = self.string.iter().flat_map(|(_, entries)| entries);
        let mut sources: Vec<String> = entries.map(|entry| entry.source.to_string()).collect();
        sources.extend((self.own_casings > 0).then(|| OWN_CATALOGUE.to_owned()));
        let has_others = self.casings.len() > self.own_casings;
        sources.extend(has_others.then(|| casing::SOURCE.to_owned()));
        let has_rigs = !self.top_drives.is_empty() || !self.hoists.is_empty();
        sources.extend(has_rigs.then(|| rigs::SOURCE.to_owned()));
        let mut seen = std::collections::HashSet::new();
        sources.retain(|source| seen.insert(source.clone()));
        sources
    }
}
