//! The readers: each with valid files of its kind, their words, and its function for an input.

mod cases;
mod folders;
mod imports;
mod logs;
mod reader;
mod readings;
mod results;
mod stored;
mod surveys;
mod workbooks;

use reader::New;
pub(crate) use reader::Reader;

/// All readers.
fn all() -> impl Iterator<Item = (&'static str, New)> {
    let lists = [
        cases::READERS,
        surveys::READERS,
        readings::READERS,
        imports::READERS,
        logs::READERS,
        results::READERS,
        stored::READERS,
        folders::READERS,
    ];
    lists.into_iter().flatten().copied()
}

/// The names of all readers.
pub(crate) fn names() -> Vec<&'static str> {
    all().map(|(name, _)| name).collect()
}

/// The reader of this name.
pub(crate) fn of(name: &str) -> Result<Reader, String> {
    let found = all().find(|(known, _)| *known == name);
    let (_, new) = found.ok_or_else(|| format!("`{name}` is not a reader"))?;
    Ok(new())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A seed that is refused tests nothing beyond its first error.
    #[test]
    fn every_seed_is_accepted() {
        let mut refused = Vec::new();
        for (name, new) in all() {
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
        for (_, new) in all() {
            let [one, two] = [new(), new()];
            for number in 0..20 {
                let inputs = [&one, &two].map(|reader| crate::worker::input(reader, 3, number));
                assert!(inputs[0] == inputs[1], "{} {number}", one.name);
            }
        }
    }
}
