//! Equal shares of many cases, for several machines.

use std::{fmt, str::FromStr};

/// Folder of the files of shares, in that of their batch.
pub(crate) const SHARES: &str = ".shares";

/// One share of the cases: every `of`-th, beginning with the `index`-th, counted from one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    index: usize,
    of: usize,
}

impl Default for Shard {
    fn default() -> Self {
        Self::ALL
    }
}

impl Shard {
    /// All cases.
    pub const ALL: Self = Self { index: 1, of: 1 };

    /// The `index`-th of so many shares, counted from one; none where there is no such share.
    pub fn new(index: usize, of: usize) -> Option<Self> {
        (1..=of).contains(&index).then_some(Self { index, of })
    }

    /// Whether it is a part of the cases only.
    pub fn is_part(self) -> bool {
        self.of > 1
    }

    /// How many shares there are.
    pub(crate) fn count(self) -> usize {
        self.of
    }

    /// All shares of as many, itself included.
    pub(crate) fn siblings(self) -> impl Iterator<Item = Self> {
        (1..=self.of).map(move |index| Self { index, of: self.of })
    }

    /// Whether it has the case of that number, counted from zero.
    pub fn has(self, case: usize) -> bool {
        case % self.of == self.index - 1
    }
}

/// `1/4`.
impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.of)
    }
}

/// `1/4`.
impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parts = text.split_once('/');
        let parts = parts.and_then(|(index, of)| Some((index.parse().ok()?, of.parse().ok()?)));
        let shard = parts.and_then(|(index, of)| Self::new(index, of));
        shard.ok_or_else(|| "expected such as 1/4, from 1/4 to 4/4".to_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_are_disjoint_and_have_every_case() {
        let shards: Vec<Shard> =
            ["1/3", "2/3", "3/3"].iter().map(|text| text.parse().expect("a share")).collect();
        for case in 0..10 {
            let having = shards.iter().filter(|shard| shard.has(case));
            assert_eq!(having.count(), 1, "{case}");
            assert!(Shard::ALL.has(case));
        }
        for wrong in ["0/3", "4/3", "1/0", "1", "a/b"] {
            assert!(wrong.parse::<Shard>().is_err(), "{wrong}");
        }
    }
}
