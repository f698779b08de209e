//! Laws of the bit by name.

/// The laws of the bit, without their numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Law {
    Rate,
    Regenerative,
    DetournayDefourny,
    Table,
    Rock,
}

pub(crate) const RATE: &str = "rate";
pub(crate) const REGENERATIVE: &str = "regenerative";
pub(crate) const DETOURNAY: &str = "detournay-defourny";
pub(crate) const TABLE: &str = "table";
pub(crate) const ROCK: &str = "rock";

/// Laws of a rock front.
pub(crate) const FRONT: &[&str] = &[RATE, DETOURNAY, TABLE];

/// Laws of cutters and wear flats.
pub(crate) const CUTTERS: &[&str] = &[REGENERATIVE, DETOURNAY];

/// Laws that ask how a bit breaks rock.
pub(crate) const SHAPED: &[&str] = &[REGENERATIVE, DETOURNAY, ROCK];

impl Law {
    pub(crate) const WORDS: &[(&str, Self)] = &[
        (RATE, Self::Rate),
        (REGENERATIVE, Self::Regenerative),
        (DETOURNAY, Self::DetournayDefourny),
        (TABLE, Self::Table),
        (ROCK, Self::Rock),
    ];

    pub(crate) fn word(self) -> &'static str {
        let found = Self::WORDS.iter().find(|(_, law)| *law == self);
        found.map_or("", |(word, _)| word)
    }
}
