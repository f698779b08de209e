//! A reader: its sound files, its words, and what it does with an input.

use fastrand::Rng;

use crate::mutation;

/// Makes a reader ready.
pub(super) type New = fn() -> Reader;

/// What reads inputs; whether it accepts one.
pub(super) type Read = Box<dyn FnMut(&[u8]) -> bool>;

/// Makes an input.
pub(super) type Generator = dyn Fn(&mut Rng) -> Vec<u8>;

/// How inputs are made.
pub(super) enum Make {
    /// Damaged seeds: texts are changed by their words too.
    Damaged { is_text: bool },
    /// In a way of their own.
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
            // Whatever is not changed is accepted: else nothing would be tried beyond the first
            // mistake.
            Make::Damaged { .. } if rng.u8(..100) == 0 => {
                rng.choice(&self.seeds).cloned().unwrap_or_default()
            }
            Make::Damaged { is_text } => mutation::damaged(&self.seeds, &self.words, *is_text, rng),
            Make::Own(make) => make(rng),
        }
    }

    /// Reads an input; whether it is accepted.
    pub(crate) fn read(&mut self, input: &[u8]) -> bool {
        (self.read)(input)
    }
}
