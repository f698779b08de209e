//! The readers: each with sound files of its kind, the words that stand in them, and what it does
//! with an input.

mod cases;
mod reader;
mod results;
mod stored;
mod surveys;

pub(crate) use reader::Reader;

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
