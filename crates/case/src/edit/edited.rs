//! The text of a case with other values in it.

use toml_edit::{
    Array, ArrayOfTables, DocumentMut, InlineTable, Item, Table, TableLike, Value as Written,
};
use wholestring_config::{
    diagnostic::Report,
    file::tree,
    node::{Key, Node},
    prelude::*,
};

use crate::{
    case::build::CASE_FILE,
    edit::overrides::{self, Override},
};

/// Returns the text of a case with these changes written into it; all other text is preserved,
/// comments included. Whether the case is valid is decided by [`parse`](crate::parse).
///
/// ```
/// use wholestring_case::edited;
///
/// let text = "[operation]\nkind = \"drill\" # to the end\nbit_depth = \"300 m\"\n";
/// let deeper = edited("well.toml", text, &["bit_depth = 310 m".parse()?, "rpm = 60".parse()?])?;
/// let expected =
///     "[operation]\nkind = \"drill\" # to the end\nbit_depth = \"310 m\"\nrpm = 60\n";
/// assert_eq!(deeper, expected);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// A text that is not TOML, and a change of a key that is not possible.
pub fn edited(name: &str, text: &str, changes: &[Override]) -> Result<String, Report> {
    let (before, mut reader) = tree(name, text.as_bytes(), &CASE_FILE)?;
    let mut after = before.clone();
    for change in changes {
        overrides::apply(&mut after, change, &mut reader);
    }
    if reader.has_errors() {
        return Err(reader.into_report());
    }
    // The tree was read by a parser that recovers from errors; this parser reads text that it has
    // found valid.
    let mut document: DocumentMut =
        text.trim_start_matches('\u{feff}').parse().map_err(|error: toml_edit::TomlError| {
            Report::about_file(name, Diagnostic::error(error.to_string()))
        })?;
    change_table(document.as_table_mut(), &before, &after);
    Ok(document.to_string())
}

/// Changes a table from its original tree to the new one.
fn change_table(table: &mut dyn TableLike, before: &Entries, after: &Entries) {
    for (key, _) in before.0.iter().filter(|(key, _)| after.get(&key.name).is_none()) {
        table.remove(&key.name);
    }
    for (key, value) in &after.0 {
        match (before.get(&key.name), table.get_mut(&key.name)) {
            (Some(old), Some(item)) => change(item, &old.value, &value.value),
            _ => {
                table.insert(&key.name, item(&value.value));
            }
        }
    }
}

fn change(place: &mut Item, before: &Value, after: &Value) {
    if is_same(before, after) {
        return;
    }
    match (before, after) {
        (Value::Table(old), Value::Table(new)) => {
            if let Some(table) = place.as_table_like_mut() {
                return change_table(table, old, new);
            }
        }
        (Value::List(old), Value::List(new)) if old.len() == new.len() => {
            if let Some(tables) = place.as_array_of_tables_mut() {
                return change_tables(tables, old, new);
            }
        }
        _ => {}
    }
    // A comment after a value is kept.
    let decor = place.as_value().map(|old| old.decor().clone());
    *place = item(after);
    if let (Some(decor), Some(new)) = (decor, place.as_value_mut()) {
        *new.decor_mut() = decor;
    }
}

fn change_tables(tables: &mut ArrayOfTables, before: &[Node], after: &[Node]) {
    for (table, (old, new)) in tables.iter_mut().zip(before.iter().zip(after)) {
        if let (Value::Table(old), Value::Table(new)) = (&old.value, &new.value) {
            change_table(table, old, new);
        }
    }
}

fn is_same(one: &Value, other: &Value) -> bool {
    match (one, other) {
        (Value::Text { text: one, .. }, Value::Text { text: other, .. }) => one == other,
        (
            Value::Number { value: one, whole: one_whole },
            Value::Number { value: other, whole: other_whole },
        ) => one.to_bits() == other.to_bits() && one_whole == other_whole,
        (Value::Boolean(one), Value::Boolean(other)) => one == other,
        (Value::Date, Value::Date) => true,
        (Value::List(one), Value::List(other)) => {
            let mut pairs = one.iter().zip(other);
            one.len() == other.len() && pairs.all(|(a, b)| is_same(&a.value, &b.value))
        }
        (Value::Table(one), Value::Table(other)) => {
            let same = |((a, one), (b, other)): (&(Key, Node), &(Key, Node))| {
                a.name == b.name && is_same(&one.value, &other.value)
            };
            one.0.len() == other.0.len() && one.0.iter().zip(&other.0).all(same)
        }
        _ => false,
    }
}

/// A value as TOML: tables under their own headings.
fn item(tree: &Value) -> Item {
    match tree {
        Value::Table(entries) => {
            let mut table = Table::new();
            for (key, node) in &entries.0 {
                table.insert(&key.name, item(&node.value));
            }
            Item::Table(table)
        }
        other => Item::Value(value(other)),
    }
}

/// A value as TOML, on one line.
fn value(tree: &Value) -> Written {
    match tree {
        Value::Text { text, .. } => text.into(),
        Value::Number { whole: Some(whole), .. } => (*whole).into(),
        Value::Number { value, .. } => (*value).into(),
        Value::Boolean(truth) => (*truth).into(),
        // No key has a date as its value, which the reader reports.
        Value::Date => "a date".into(),
        Value::List(items) => {
            Written::Array(items.iter().map(|node| value(&node.value)).collect::<Array>())
        }
        Value::Table(entries) => {
            let pairs = entries.0.iter().map(|(key, node)| (&key.name, value(&node.value)));
            Written::InlineTable(pairs.collect::<InlineTable>())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{InMemory, Quote, parse};

    const CASE: &str = r#"# A slant well.
name = "slant"

[well]
stations = [["0 m", "0 deg", "0 deg"], ["1000 m", "30 deg", "0 deg"]]

[[well.hole]]   # cased
kind = "casing"
to = "500 m"
diameter = "220 mm"
friction = { kinetic = 0.2, around = 0.1 }

[[well.hole]]
kind = "open"
to = "1000 m"
diameter = "8-1/2 in"
friction = 0.3  # a guess

[mud]
density = "1.2 sg"

[[string]]
component = "drill pipe"
od = "127 mm"
id = "108.6 mm"
mass_per_length = "30 kg/m"
length = "to surface"

[operation]
kind = "trip_out"
"#;

    fn changed(changes: &[&str]) -> String {
        let changes: Vec<Override> = changes.iter().map(|change| change.parse().unwrap()).collect();
        edited("well.toml", CASE, &changes)
            .unwrap_or_else(|report| panic!("{}", report.render(false)))
    }

    #[test]
    fn a_change_leaves_the_rest_as_it_is_written() {
        assert_eq!(changed(&[]), CASE);
        let text = changed(&["well.hole.1.friction=0.4", "mud.density=\"9 ppg\""]);
        let expected = CASE
            .replace("friction = 0.3  # a guess", "friction = 0.4  # a guess")
            .replace("1.2 sg", "9 ppg");
        assert_eq!(text, expected);
    }

    /// A key is removed with its comment; the neighbouring keys and their comments are kept.
    #[test]
    fn a_key_is_removed() {
        let removal = |key: &str| {
            let (text, all) = (key.into(), 0..key.len());
            let quote =
                Quote { name: "test".into(), text, key: all.clone(), value: all, verbatim: true };
            Override::removal(key, quote)
        };
        let text = edited("well.toml", CASE, &[removal("name"), removal("friction")]).unwrap();
        assert!(!text.contains("name =") && !text.contains("friction"), "{text}");
        assert!(text.contains("[[well.hole]]   # cased") && text.starts_with("\n[well]"), "{text}");
        for key in ["wob", "operation.fish", "well.hole.1", "string.0.", ""] {
            let report = edited("well.toml", CASE, &[removal(key)]).unwrap_err().render(false);
            assert!(report.contains("could be removed"), "{report}");
        }
    }

    /// The text reads like the case with the overrides, including short keys and new tables.
    #[test]
    fn the_text_is_the_case_with_the_changes() {
        let changes =
            ["friction=0.4", "bit_depth=900m", "rig.block_weight=\"200 kN\"", "model=soft"];
        let text = changed(&changes);
        let changes: Vec<Override> = changes.iter().map(|change| change.parse().unwrap()).collect();
        let read = |text: &str, changes: &[Override]| {
            parse("well.toml", text.as_bytes(), &InMemory::default(), changes)
                .unwrap_or_else(|report| panic!("{}", report.render(false)))
        };
        assert_eq!(read(&text, &[]).settings, read(CASE, &changes).settings);
        assert!(text.contains("friction = { kinetic = 0.4, around = 0.2 }"), "{text}");
        assert!(text.contains("[rig]\nblock_weight = \"200 kN\""), "{text}");
    }

    #[test]
    fn a_change_that_cannot_be_is_reported() {
        let report = edited("well.toml", CASE, &["well.hole.7.friction=0.4".parse().unwrap()]);
        assert!(report.unwrap_err().render(false).contains("well.hole.7.friction"));
        assert!(edited("well.toml", "name = ", &[]).is_err());
    }
}
