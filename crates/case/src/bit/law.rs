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

impl Law {
    pub(crate) const WORDS: &[(&str, Self)] = &[
        ("rate", Self::Rate),
        ("regenerative", Self::Regenerative),
        ("detournay-defourny", Self::DetournayDefourny),
        ("table", Self::Table),
        ("rock", Self::Rock),
    ];

    /// Laws of a rock front.
    pub(crate) const FRONT: &[Self] = &[Self::Rate, Self::DetournayDefourny, Self::Table];

    /// Laws of cutters and wear flats.
    pub(crate) const CUTTERS: &[Self] = &[Self::Regenerative, Self::DetournayDefourny];

    pub(crate) fn word(self) -> &'static str {
        let found = Self::WORDS.iter().find(|(_, law)| *law == self);
        found.map_or("", |(word, _)| word)
    }
}
