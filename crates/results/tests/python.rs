//! The fields of Python's classes of rows are those of the rows.

use std::{env, fs, path::Path};

use serde_json::Value;
use utoipa::PartialSchema;
use wholestring_judge::Check;
use wholestring_results::{EstimateFound, PlanCheck};

/// A class in a file of the package.
struct Class {
    file: &'static str,
    name: &'static str,
    schema: Value,
    /// Fields of the row that it lacks.
    without: &'static [&'static str],
    /// Fields that are empty by default, because folders of earlier versions lack them.
    empty: &'static [&'static str],
}

fn schema<Row: PartialSchema>() -> Value {
    serde_json::to_value(Row::schema()).expect("JSON")
}

fn classes() -> [Class; 3] {
    let class = |file, name, schema| Class { file, name, schema, without: &[], empty: &[] };
    let check = class("_base.py", "Check", schema::<Check>());
    [
        Class { without: &["parts"], empty: &["verdict", "unit"], ..check },
        class("planning.py", "PlanCheck", schema::<PlanCheck>()),
        class("calibration.py", "Estimate", schema::<EstimateFound>()),
    ]
}

/// The type in Python of a value; words, whose schema is another's, are texts.
fn type_of(schema: &Value) -> String {
    let one = |kind: &Value| match kind.as_str() {
        Some("number") => "float".to_owned(),
        Some("integer") => "int".to_owned(),
        Some("boolean") => "bool".to_owned(),
        Some("null") => "None".to_owned(),
        Some("array") => {
            let count = schema["maxItems"].as_u64().expect("a fixed number of items");
            let item = type_of(&schema["items"]);
            format!("tuple[{}]", vec![item; count as usize].join(", "))
        }
        _ => "str".to_owned(),
    };
    match &schema["type"] {
        Value::Array(kinds) => kinds.iter().map(one).collect::<Vec<_>>().join(" | "),
        kind => one(kind),
    }
}

/// The words of a text in lines, indented as the text of an attribute.
fn wrapped(text: &str) -> String {
    let mut lines = vec![String::from("       ")];
    let stop = if text.ends_with('.') { "" } else { "." };
    let text = format!("{text}{stop}").replace('`', "``");
    for word in text.split_whitespace() {
        if lines[lines.len() - 1].len() + 1 + word.len() > 100 {
            lines.push(String::from("       "));
        }
        let last = lines.len() - 1;
        lines[last] += &format!(" {word}");
    }
    lines.join("\n")
}

impl Class {
    /// Own fields, with their schemas; not those of a row within the row, which are inherited.
    fn fields(&self) -> Vec<(&str, &Value)> {
        let parts = self.schema["allOf"].as_array();
        let parts = parts.map_or(std::slice::from_ref(&self.schema), Vec::as_slice);
        let properties = parts.iter().filter_map(|part| part["properties"].as_object()).flatten();
        let own = properties.map(|(name, schema)| (name.as_str(), schema));
        own.filter(|(name, _)| !self.without.contains(name)).collect()
    }

    /// The source with the fields of the row, and their texts: fields that it has remain in their
    /// order, others follow.
    fn written(&self, source: &str) -> String {
        let class = format!("\nclass {}", self.name);
        let from = source.find(&class).unwrap_or_else(|| panic!("no class {}", self.name));
        let (before, class) = source.split_at(from);
        let (head, rest) = class.split_once("    ----------\n").expect("attributes");
        let (_, rest) = rest.split_once("\n\n").expect("an end of the attributes");
        let (example, rest) = rest.split_once("    \"\"\"\n\n").expect("an end of the docstring");
        let (former, rest) = rest.split_once("\n\n").expect("an end of the fields");
        let place = |name: &str| {
            let names = former.lines().map(|line| line.trim().split(':').next());
            names.into_iter().position(|other| other == Some(name)).unwrap_or(usize::MAX)
        };
        let mut fields = self.fields();
        fields.sort_by_key(|(name, _)| place(name));
        let (mut texts, mut lines) = (String::new(), String::new());
        for (name, schema) in fields {
            let meaning = schema["description"].as_str().expect("a meaning");
            texts += &format!("    {name}\n{}\n", wrapped(meaning));
            let kind = type_of(schema);
            let default = match () {
                () if kind.ends_with("| None") => " = None",
                () if self.empty.contains(&name) => " = \"\"",
                () => "",
            };
            lines += &format!("    {name}: {kind}{default}\n");
        }
        format!("{before}{head}    ----------\n{texts}\n{example}    \"\"\"\n\n{lines}\n{rest}")
    }
}

/// With `WHOLESTRING_UPDATE_DOCS=1` it writes them.
#[test]
fn classes_of_rows_have_their_fields() {
    let package = Path::new(env!("CARGO_MANIFEST_DIR")).join("../python/python/wholestring");
    for class in classes() {
        let path = package.join(class.file);
        let found = fs::read_to_string(&path).expect("a file of the package").replace("\r\n", "\n");
        let expected = class.written(&found);
        if env::var_os("WHOLESTRING_UPDATE_DOCS").is_some() {
            fs::write(path, expected).expect("a written file");
            continue;
        }
        assert!(
            found == expected,
            "{} of {} has other fields than its row: WHOLESTRING_UPDATE_DOCS=1 writes them",
            class.name,
            class.file
        );
    }
}
