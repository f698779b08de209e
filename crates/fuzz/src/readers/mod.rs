//! The readers: each with sound files of its kind, the words that stand in them, and what it does with an input.

mod cases;
mod results;
mod stored;
mod surveys;

use fastrand::Rng;

use crate::mutation;

/// What reads inputs; whether it accepts one.
type Read = Box<dyn FnMut(&[u8]) -> bool>;

/// Makes an input.
type Generator = dyn Fn(&mut Rng) -> Vec<u8>;

/// How inputs are made.
enum Make {
    /// Damaged seeds: texts are changed by their words too.
    Damaged { is_text: bool },
    /// In a way of their own.
    Own(Box<Generator>),
}

/// A reader.
pub(crate) struct Reader {
    pub(crate) name: &'static str,
    seeds: Vec<Vec<u8>>,
    words: &'static [&'static str],
    make: Make,
    read: Read,
}

impl Reader {
    /// A reader of texts.
    fn text<const N: usize>(
        name: &'static str,
        seeds: [&[u8]; N],
        words: &'static [&'static str],
        read: impl FnMut(&[u8]) -> bool + 'static,
    ) -> Self {
        Self {
            name,
            seeds: seeds.map(<[u8]>::to_vec).into(),
            words,
            make: Make::Damaged { is_text: true },
            read: Box::new(read),
        }
    }

    /// A reader of other files.
    fn binary(
        name: &'static str,
        seeds: Vec<Vec<u8>>,
        read: impl FnMut(&[u8]) -> bool + 'static,
    ) -> Self {
        Self {
            name,
            seeds,
            words: &[],
            make: Make::Damaged { is_text: false },
            read: Box::new(read),
        }
    }

    /// An input.
    pub(crate) fn input(&self, rng: &mut Rng) -> Vec<u8> {
        match &self.make {
            // Whatever is not changed is accepted: else nothing would be tried beyond the first mistake.
            Make::Damaged { .. } if rng.u8(..100) == 0 => {
                rng.choice(&self.seeds).cloned().unwrap_or_default()
            }
            Make::Damaged { is_text } => mutation::damaged(&self.seeds, self.words, *is_text, rng),
            Make::Own(make) => make(rng),
        }
    }

    /// Reads an input; whether it is accepted.
    pub(crate) fn read(&mut self, input: &[u8]) -> bool {
        (self.read)(input)
    }
}

/// Makes a reader ready.
type New = fn() -> Reader;

const READERS: [(&str, New); 17] = [
    ("case", cases::case),
    ("override", cases::overrides),
    ("vary", cases::vary),
    ("study", cases::study),
    ("bit-table", cases::bit_table),
    ("quantity", cases::quantity),
    ("survey-csv", surveys::csv),
    ("survey-tsv", surveys::tsv),
    ("survey-fixed", surveys::fixed),
    ("survey-xlsx", surveys::xlsx),
    ("survey-xls", surveys::xls),
    ("summary", results::summary),
    ("parquet", results::parquet),
    ("sweep-csv", results::csv),
    ("checkpoint", stored::file),
    ("simulation", stored::simulation),
    ("trial", stored::trial),
];

/// The names of all readers.
pub(crate) const NAMES: [&str; READERS.len()] = {
    let mut names = [""; READERS.len()];
    let mut i = 0;
    while i < names.len() {
        names[i] = READERS[i].0;
        i += 1;
    }
    names
};

/// The reader of that name.
pub(crate) fn of(name: &str) -> Result<Reader, String> {
    let found = READERS.iter().find(|(known, _)| *known == name);
    let (_, new) = found.ok_or_else(|| format!("`{name}` is no reader"))?;
    Ok(new())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A seed that is refused tries nothing beyond its first mistake.
    #[test]
    fn every_seed_is_accepted() {
        let mut refused = Vec::new();
        for (name, new) in READERS {
            let mut reader = new();
            assert_eq!(reader.name, name);
            for index in 0..reader.seeds.len() {
                let seed = reader.seeds[index].clone();
                if !reader.read(&seed) {
                    refused.push((name, index));
                }
            }
        }
        assert_eq!(refused, []);
    }

    #[test]
    fn inputs_are_the_same_again() {
        for (_, new) in READERS {
            let [one, two] = [new(), new()];
            for number in 0..20 {
                let inputs = [&one, &two].map(|reader| crate::worker::input(reader, 3, number));
                assert!(inputs[0] == inputs[1], "{} {number}", one.name);
            }
        }
    }
}
