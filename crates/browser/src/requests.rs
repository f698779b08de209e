//! Requests about a text, and requests for constant data.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use wholestring_case::{InMemory, schema};
use wholestring_runner::CancellationToken;
use wholestring_screens::{
    answers::{Asked, AskedOfModels, AskedOfOperation},
    cases::Title,
    catalogue::{Wanted, catalogue},
    check::{Text, check},
    edit::{Changes, edit},
    examples::{example, list},
    refusal::Refusal,
    survey::{Pasted, survey},
    trial::Applying,
    units::units,
};

/// A request of the page.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Request {
    /// The kind of request: `check`, `answer`, `units`, ...
    pub asks: String,
    /// Identifier of the live string that is to start.
    #[serde(default)]
    pub id: String,
    /// The name of the case's file.
    #[serde(default)]
    pub file: String,
    /// The files next to it, by name.
    #[serde(default)]
    pub beside: BTreeMap<String, String>,
    /// The body, or the parts of the address, of the local app's request.
    #[serde(default)]
    pub body: Value,
}

/// A request by name.
#[derive(Debug, Deserialize)]
struct Named {
    name: String,
}

/// List entry of a case.
#[derive(Debug, Serialize)]
struct Listed {
    name: Option<String>,
    problem: Option<String>,
}

/// The program.
#[derive(Debug, Serialize)]
struct Program {
    version: &'static str,
}

impl Request {
    /// The files next to the case.
    pub fn files(&self) -> InMemory {
        let bytes = |(name, text): (&String, &String)| (name.clone(), text.as_bytes().to_owned());
        InMemory(self.beside.iter().map(bytes).collect())
    }

    /// The body as the requested type.
    ///
    /// # Errors
    /// A body of another type.
    pub fn body<'a, T: Deserialize<'a>>(&'a self) -> Result<T, Refusal> {
        T::deserialize(&self.body).map_err(|error| Refusal::new(400, "bad_json", error.to_string()))
    }

    /// The response, as JSON.
    ///
    /// # Errors
    /// An invalid request, and one that is not supported in a browser.
    pub fn answer(&self) -> Result<String, Refusal> {
        let (file, files) = (self.file.as_str(), self.files());
        // There is one thread here: a client that no longer waits terminates all of it.
        let none = CancellationToken::new();
        match self.asks.as_str() {
            "program" => json(&Program { version: env!("CARGO_PKG_VERSION") }),
            "schema" => json(&schema()),
            "units" => json(&units()),
            "catalogue" => json(&catalogue(&self.body::<Wanted>()?)),
            "survey" => json(&survey(&self.body::<Pasted>()?)?),
            "examples" => json(&list()),
            "example" => json(&example(&self.body::<Named>()?.name)?),
            "title" => {
                let Title { name, problem, .. } =
                    Title::of(file, &self.body::<Text>()?.text, &files);
                json(&Listed { name, problem })
            }
            "check" => json(&check(file, &self.body::<Text>()?.text, &files)),
            "edit" => json(&edit(self.body::<Changes>()?)?),
            "answer" => json(&self.body::<AskedOfModels>()?.answer(file, &files, &none)?),
            "apply" => json(&self.body::<Applying>()?.apply(file, &files)?),
            "broomstick" => json(&self.body::<Asked>()?.broomstick(file, &files, &none)?),
            "assembly" => json(&self.body::<AskedOfOperation>()?.assembly(file, &files, &none)?),
            other => {
                let message = format!("`{other}` is not answered in a browser alone");
                Err(Refusal::not_found(message))
            }
        }
    }
}

/// Serializes as JSON.
///
/// # Errors
/// None for a response.
pub fn json(serialize: &impl Serialize) -> Result<String, Refusal> {
    serde_json::to_string(serialize).map_err(Refusal::failed)
}
