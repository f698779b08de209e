//! Words of the JSON that other crates declare, for the description of the API.

use std::borrow::Cow;

use serde::Serialize;
use utoipa::{
    PartialSchema, ToSchema,
    openapi::{ObjectBuilder, RefOr, Schema, Type},
};
use wholestring::well;
pub use wholestring_judge::Severity;
use wholestring_plan::Statics;
use wholestring_units as units;

/// Declares the description of words: its name, and the words themselves as they are declared.
macro_rules! words {
    ($($(#[doc = $about:literal])+ $name:ident: $words:expr;)+) => {$(
        $(#[doc = $about])+
        #[derive(Debug, Serialize)]
        pub enum $name {}

        impl PartialSchema for $name {
            fn schema() -> RefOr<Schema> {
                let about = concat!($($about),+).trim();
                let words = ObjectBuilder::new().schema_type(Type::String);
                words.description(Some(about)).enum_values(Some($words)).into()
            }
        }

        impl ToSchema for $name {
            fn name() -> Cow<'static, str> {
                stringify!($name).into()
            }
        }
    )+};
}

/// Name of a kind of hole.
pub(crate) const fn hole_kind(kind: well::HoleKind) -> &'static str {
    match kind {
        well::HoleKind::Casing => "casing",
        well::HoleKind::Open => "open",
    }
}

words! {
    /// A method that answers without steps of time.
    StaticModel: Statics::ALL.map(|model| model.kind().name());
    /// A level of friction.
    FrictionLevel: well::FrictionLevel::ALL.map(well::FrictionLevel::name);
    /// A set of units.
    UnitSet: units::UnitSet::ALL.iter().map(|set| set.name());
    /// A kind of hole.
    HoleKind: [well::HoleKind::Casing, well::HoleKind::Open].map(hole_kind);
}
