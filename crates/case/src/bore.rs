//! The bore of a section of hole.

use wholestring::well::CasingPipe;

/// How wide a section is, and the casing that says so.
pub(crate) struct Bore {
    pub(crate) diameter_m: f64,
    pub(crate) casing: Option<CasingPipe>,
}
