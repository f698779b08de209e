//! The key at a place of a case.

use wholestring_config::node::{Entries, Node, Value, parse_text};

/// The dotted keys of a text, by their first byte.
#[derive(Debug, Default)]
pub(super) struct Keys(Vec<(usize, String)>);

impl Keys {
    /// The keys of a text; empty if it is not TOML.
    pub(super) fn of(text: &str) -> Self {
        let mut keys = Self::default();
        if let Ok(entries) = parse_text(text, 0) {
            keys.table(&entries, "");
        }
        // The sort is stable, so that of keys with the same start the last stays the innermost.
        keys.0.sort_by_key(|(start, _)| *start);
        keys
    }

    /// The key at a byte of the text: the last one that begins at or before it.
    pub(super) fn at(&self, byte: usize) -> Option<String> {
        let after = self.0.partition_point(|(start, _)| *start <= byte);
        self.0[..after].last().map(|(_, key)| key.clone())
    }

    fn table(&mut self, entries: &Entries, before: &str) {
        for (key, node) in &entries.0 {
            let dotted = match before {
                "" => key.name.clone(),
                before => format!("{before}.{}", key.name),
            };
            self.0.push((key.place.start, dotted.clone()));
            self.node(node, &dotted);
        }
    }

    fn node(&mut self, node: &Node, dotted: &str) {
        match &node.value {
            Value::Table(entries) => self.table(entries, dotted),
            Value::List(items) => {
                for (index, item) in items.iter().enumerate() {
                    let dotted = format!("{dotted}.{index}");
                    self.0.push((item.place.start, dotted.clone()));
                    self.node(item, &dotted);
                }
            }
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Keys;

    #[test]
    fn a_place_belongs_to_the_innermost_key() {
        let text = "name = \"a\"\n[well]\nstations = [[0, 1], [2, 3]]\n[[well.hole]]\n\
                    kind = \"open\"\nfriction = { kinetic = 0.2, around = 7 }\n[[string]]\n\
                    od = 1\n[[string]]\nid = 2\n[mud]\n";
        let keys = Keys::of(text);
        let at = |what: &str| keys.at(text.find(what).unwrap()).unwrap();
        assert_eq!(at("\"a\""), "name");
        assert_eq!(at("3]"), "well.stations.1.1");
        assert_eq!(at("[2"), "well.stations.1");
        assert_eq!(at("[[well.hole]]"), "well.hole.0");
        assert_eq!(at("\"open\""), "well.hole.0.kind");
        assert_eq!(at("7 }"), "well.hole.0.friction.around");
        assert_eq!(at("od"), "string.0.od");
        assert_eq!(at("2\n[mud"), "string.1.id");
        assert_eq!(at("mud"), "mud");
        assert_eq!(Keys::of("name = ").at(3), None);
    }
}
