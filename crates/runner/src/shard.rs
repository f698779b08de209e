//! Equal shares of many cases, for several machines.

use std::{fmt, str::FromStr};

/// Folder of the files of shares, in that of their batch.
pub(crate) const SHARES: &str = ".shares";

/// One share of the cases: every `count`-th, starting at the `index`-th, counted from one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    index: usize,
    count: usize,
}

impl Default for Shard {
    fn default() -> Self {
        Self::ALL
    }
}

impl Shard {
    /// All cases.
    pub const ALL: Self = Self { index: 1, count: 1 };

    /// Creates the `index`-th of `count` shares, counted from one; `None` if there is no such
    /// share.
    pub fn new(index: usize, count: usize) -> Option<Self> {
        (1..=count).contains(&index).then_some(Self { index, count })
    }

    /// Whether it contains only a part of the cases.
    pub fn is_part(self) -> bool {
        self.count > 1
    }

    /// Number of shares.
    pub(crate) fn count(self) -> usize {
        self.count
    }

    /// All shares of the same division, including this one.
    pub(crate) fn siblings(self) -> impl Iterator<Item = Self> {
        (1..=self.count).map(move |index| Self { index, count: self.count })
    }

    /// Whether it contains the case of that index, counted from zero.
    pub fn has(self, case: usize) -> bool {
        case % self.count == self.index - 1
    }
}

/// Formats as `1/4`.
impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.count)
    }
}

/// Parses `1/4`.
impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parts = text.split_once('/');
        let parts = parts.and_then(|(index, part)| Some((index.parse().ok()?, part.parse().ok()?)));
        let shard = parts.and_then(|(index, part)| Self::new(index, part));
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
