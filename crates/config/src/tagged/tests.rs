use super::*;
use crate::{
    file,
    kind::Kind,
    number::Number,
    rule::{Choice, Table},
    source::Span,
    table::{default, keys, required, table},
};

pub(crate) trait Law {
    fn sum(&self) -> Option<f64>;
}

keys! {
    /// Keys of both words.
    Shared {
        /// It must be there.
        both: f64 = required(Number::up_to(1.0));
    }
}

keys! {
    /// The first.
    One {
        /// Its own.
        one: f64 = required(Number::up_to(1.0));
        ..shared: Shared;
    }
}

keys! {
    /// The second.
    Two {
        ..shared: Shared;
        /// Its own.
        two: f64 = default(Number::up_to(1.0), 0.5);
    }
}

impl Variant for One {
    const WORD: &'static str = "one";
    const MEANING: &'static str = "the first";
}

impl Variant for Two {
    const WORD: &'static str = "two";
    const MEANING: &'static str = "the second";
}

impl Law for One {
    fn sum(&self) -> Option<f64> {
        Some(self.one.get()? + self.shared.both.get()?)
    }
}

impl Law for Two {
    fn sum(&self) -> Option<f64> {
        Some(self.two.get()? + self.shared.both.get()?)
    }
}

tagged! {
    /// A choice.
    Choices as dyn Law {
        /// The rest.
        law: Word = required(Choice { noun: "a law", words: Word::WORDS });
        One => one: One;
        Two => two: Two;
    }
}

table! {
    /// A table.
    File in "the file" {
        /// Before.
        before: f64 = default(Number::up_to(1.0), 0.0);
        ..choices: Choices;
        /// After.
        after: f64 = default(Number::up_to(1.0), 0.0);
    }
}

fn tables() -> &'static crate::Json {
    static TABLES: std::sync::LazyLock<crate::Json> = std::sync::LazyLock::new(File::schema);
    &TABLES
}
static KIND: Kind = Kind { noun: "file", needs: "a law", tables };

/// The value of the law, the keys that only another law uses, and the diagnostics.
fn read(text: &str) -> (Option<f64>, Vec<&'static str>, String) {
    let (root, mut reader) = file::tree("file.toml", text.as_bytes(), &KIND).expect("TOML");
    let file = File::read(&root, Span::default(), &mut reader);
    let sum = file.choices.chosen().and_then(Law::sum);
    let chosen = file.choices.word();
    let idle = file.written().into_iter().filter(|key| !key.is_used_with(chosen.unwrap_or("")));
    (sum, idle.map(|key| key.name).collect(), reader.into_report().render(false))
}

#[test]
fn the_word_chooses_the_keys() {
    assert_eq!(read("law = \"one\"\none = 0.25\nboth = 0.5"), (Some(0.75), vec![], String::new()));
    let (sum, idle, wrong) = read("law = \"two\"\none = 0.25\nboth = 0.25\nafter = 1");
    assert_eq!((sum, idle, wrong.as_str()), (Some(0.75), vec!["one"], ""));
}

/// The keys of the chosen word are required; a mistake in a key of another word is reported as
/// well, and one in a shared key once.
#[test]
fn mistakes_are_reported_once() {
    let (sum, _, wrong) = read("law = \"two\"");
    assert_eq!(sum, None);
    assert_eq!(wrong.matches("error").count(), 1, "{wrong}");
    assert!(wrong.contains("lacks `both`"), "{wrong}");
    let (_, _, wrong) = read("law = \"two\"\none = 2\nboth = 3");
    assert_eq!(wrong.matches("error").count(), 2, "{wrong}");
    let (_, _, wrong) = read("law = \"three\"");
    assert_eq!(wrong.matches("error").count(), 1, "{wrong}");
    let (_, _, wrong) = read("law = \"one\"\none = 0\nboth = 0\ntow = 1");
    assert!(wrong.contains("did you mean `two`?"), "{wrong}");
    assert!(wrong.contains("keys of the file: before, law, one, both, two, after"), "{wrong}");
}

#[test]
fn the_schema_says_which_word_uses_a_key() {
    let schema = File::schema();
    let about = |key: &str| schema["properties"][key]["description"].as_str().expect("a text");
    assert_eq!(about("law"), "\"one\" (the first) or \"two\" (the second). The rest.");
    assert_eq!(about("one"), "Its own. Required with law = \"one\".");
    assert_eq!(about("both"), "It must be there. Required with law = \"one\" or \"two\".");
    assert_eq!(about("two"), "Its own. Used with law = \"two\". Default: 0.5.");
    assert_eq!(about("after"), "After. Default: 0.");
    assert_eq!(schema["required"], serde_json::json!(["law"]));
}
