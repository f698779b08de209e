//! The tubulars that a case can name, found by words.

use wholestring::{
    string::catalogue::{self, CatalogueEntry, TubularKind, describes},
    well::casing::{self, Casing},
};

/// The kinds of tubulars of a string, and the words by which they are found.
const KINDS: [(TubularKind, &str); 3] = [
    (TubularKind::DrillPipe, "drill pipe dp"),
    (TubularKind::HeavyWeight, "heavy-weight drill pipe hwdp hwt"),
    (TubularKind::Collar, "drill collars dc"),
];

/// The words by which casing is found.
const CASING_WORDS: &str = "casing csg liner";

/// What the catalogue has of some words.
#[derive(Debug)]
pub struct Tubulars {
    /// Those of a string, kind after kind; none is without an entry.
    pub string: Vec<(TubularKind, Vec<CatalogueEntry>)>,
    /// Those of a hole.
    pub casings: Vec<Casing>,
}

impl Tubulars {
    /// What has all of these words and numbers, whole or cut short; without any, everything.
    pub fn described(query: &str) -> Self {
        let entries = catalogue::entries();
        let found = KINDS.iter().map(|(kind, words)| {
            let alike = entries.iter().filter(|entry| entry.kind == *kind);
            let found = alike.filter(|entry| {
                let connection = entry.joints.map_or("", |joints| joints.connection);
                describes(&format!("{} {words} {connection}", entry.designation), query)
            });
            (*kind, found.cloned().collect::<Vec<_>>())
        });
        let string = found.filter(|(_, entries)| !entries.is_empty()).collect();
        let mut casings = casing::entries();
        casings.retain(|one| describes(&format!("{} {CASING_WORDS}", one.designation), query));
        Self { string, casings }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.string.is_empty() && self.casings.is_empty()
    }

    /// Where their dimensions come from, in the order of the tubulars.
    pub fn sources(&self) -> Vec<&'static str> {
        let entries = self.string.iter().flat_map(|(_, entries)| entries);
        let mut sources: Vec<&'static str> = entries.map(|entry| entry.source).collect();
        sources.extend((!self.casings.is_empty()).then_some(casing::SOURCE));
        sources.dedup();
        sources
    }
}
