//! Answers of the server, compared with their description.

use serde_json::{Value, json};

use crate::common::{CASE, Served};

/// The description of the API.
struct Document(Value);

impl Document {
    /// Asserts that an answer to a request is as described.
    fn check(&self, method: &str, path: &str, answer: &Value) {
        let described = &self.0["paths"][path][method]["responses"]["200"]["content"];
        let schema = &described["application/json"]["schema"];
        assert!(schema.is_object(), "{method} {path} describes no answer");
        let fault = self.fault(schema, answer, "answer");
        assert_eq!(fault, None, "{method} {path}");
    }

    /// The first place where a value differs from a schema.
    fn fault(&self, schema: &Value, value: &Value, place: &str) -> Option<String> {
        if let Some(path) = schema["$ref"].as_str() {
            let name = path.rsplit('/').next().unwrap();
            let named = &self.0["components"]["schemas"][name];
            assert!(named.is_object(), "{name} is not described");
            return self.fault(named, value, place);
        }
        if let Some(all) = schema["allOf"].as_array() {
            return all.iter().find_map(|one| self.fault(one, value, place));
        }
        if let Some(any) = schema["oneOf"].as_array() {
            let faults: Option<Vec<_>> =
                any.iter().map(|one| self.fault(one, value, place)).collect();
            return faults.map(|faults| faults.join("; or "));
        }
        if let Some(words) = schema["enum"].as_array() {
            return (!words.contains(value)).then(|| format!("{place} is {value}"));
        }
        let kind = match value {
            Value::Null => "null",
            Value::Bool(_) => "boolean",
            Value::Number(_) => "number",
            Value::String(_) => "string",
            Value::Array(_) => "array",
            Value::Object(_) => "object",
        };
        let is_kind = |described: &Value| {
            described == kind
                || described == "integer" && value.as_f64().is_some_and(|n| n.fract() == 0.0)
        };
        let kinds = &schema["type"];
        let is_described = match kinds {
            Value::Null => true,
            Value::Array(kinds) => kinds.iter().any(is_kind),
            kind => is_kind(kind),
        };
        if !is_described {
            return Some(format!("{place} is {kind}, described as {kinds}"));
        }
        match value {
            Value::Array(items) => {
                for (bound, is_within) in [
                    (
                        "minItems",
                        schema["minItems"].as_u64().is_none_or(|least| least <= items.len() as u64),
                    ),
                    (
                        "maxItems",
                        schema["maxItems"].as_u64().is_none_or(|most| most >= items.len() as u64),
                    ),
                ] {
                    if !is_within {
                        return Some(format!("{place} has {} items: {bound}", items.len()));
                    }
                }
                let mut items = items.iter().enumerate();
                items.find_map(|(at, item)| {
                    self.fault(&schema["items"], item, &format!("{place}.{at}"))
                })
            }
            Value::Object(entries) => {
                let required = schema["required"].as_array().into_iter().flatten();
                let mut missing =
                    required.filter(|name| !entries.contains_key(name.as_str().unwrap()));
                if let Some(name) = missing.next() {
                    return Some(format!("{place} has no {name}"));
                }
                entries.iter().find_map(|(name, entry)| {
                    let property = match &schema["properties"][name] {
                        Value::Null => &schema["additionalProperties"],
                        property => property,
                    };
                    self.fault(property, entry, &format!("{place}.{name}"))
                })
            }
            _ => None,
        }
    }
}

#[test]
fn answers_are_as_described() {
    let served = Served::with(&[("slant.toml", CASE)]);
    let document = Document(served.get("/api/openapi.json").ok());
    let id = served.id("slant.toml");
    for (path, real) in [
        ("/api/session", "/api/session".to_owned()),
        ("/api/cases", "/api/cases".to_owned()),
        ("/api/cases/{id}", format!("/api/cases/{id}")),
        ("/api/examples", "/api/examples".to_owned()),
        ("/api/units", "/api/units".to_owned()),
        ("/api/catalogue", "/api/catalogue?word=drill".to_owned()),
        ("/api/jobs", "/api/jobs".to_owned()),
        ("/api/results", "/api/results".to_owned()),
        ("/api/live", "/api/live".to_owned()),
    ] {
        document.check("get", path, &served.get(&real).ok());
    }
    let text = json!({"text": CASE});
    for action in ["answer", "broomstick", "assembly", "check"] {
        let path = format!("/api/cases/{{id}}/{action}");
        let answer = served.post(&format!("/api/cases/{id}/{action}"), &text).ok();
        document.check("post", &path, &answer);
    }
    let live = served.post("/api/live", &json!({"case": id, "text": CASE})).ok();
    document.check("post", "/api/live", &live);
    let id = live["id"].as_str().expect("an id");
    document.check("get", "/api/live/{id}", &served.get(&format!("/api/live/{id}")).ok());
}
