//! A reader: its valid files, its words, and its function for an input.

use fastrand::Rng;

use crate::mutation;

/// Constructs a reader.
pub(super) type New = fn() -> Reader;

/// Reads an input; returns whether it is accepted.
pub(super) type Read = Box<dyn FnMut(&[u8]) -> bool>;

/// Makes an input.
pub(super) type Generator = dyn Fn(&mut Rng) -> Vec<u8>;

/// Way to generate inputs.
pub(super) enum Make {
    /// Damaged seeds: texts are also changed by words.
    Damaged { is_text: bool },
    /// A generator of their own.
    Own(Box<Generator>),
}

/// A reader.
pub(crate) struct Reader {
    pub(crate) name: &'static str,
    pub(super) seeds: Vec<Vec<u8>>,
    pub(super) words: Vec<&'static str>,
    pub(super) make: Make,
    pub(super) read: Read,
}

impl Reader {
    /// A reader of texts.
    pub(super) fn text<const N: usize>(
        name: &'static str,
        seeds: [&[u8]; N],
        words: &[&'static str],
        read: impl FnMut(&[u8]) -> bool + 'static,
    ) -> Self {
        Self {
            name,
            seeds: seeds.map(<[u8]>::to_vec).into(),
            words: words.to_vec(),
            make: Make::Damaged { is_text: true },
            read: Box::new(read),
        }
    }

    /// A reader of other files.
    pub(super) fn binary(
        name: &'static str,
        seeds: Vec<Vec<u8>>,
        read: impl FnMut(&[u8]) -> bool + 'static,
    ) -> Self {
        Self {
            name,
            seeds,
            words: Vec::new(),
            make: Make::Damaged { is_text: false },
            read: Box::new(read),
        }
    }

    /// An input.
    pub(crate) fn input(&self, rng: &mut Rng) -> Vec<u8> {
        match &self.make {
            // An unchanged seed is accepted: otherwise nothing would be tested beyond the first
            // error.
            Make::Damaged { .. } if rng.u8(..100) == 0 => {
                rng.choice(&self.seeds).cloned().unwrap_or_default()
            }
            Make::Damaged { is_text } => mutation::damaged(&self.seeds, &self.words, *is_text, rng),
            Make::Own(make) => make(rng),
        }
    }

    /// Reads an input; returns whether it is accepted.
    pub(crate) fn read(&mut self, input: &[u8]) -> bool {
        (self.read)(input)
    }
}
