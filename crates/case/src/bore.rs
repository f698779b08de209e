//! The bore of a section of hole.

use wholestring::well::CasingPipe;

/// Width of a section, and the casing that determines it.
pub(crate) struct Bore {
    pub(crate) diameter_m: f64,
    pub(crate) casing: Option<CasingPipe>,
}
