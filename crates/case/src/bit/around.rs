//! What other tables tell of the bit.

use wholestring::rock::DrillingSpec;

use wholestring_config::source::Files;

/// What other tables tell of the bit, if they are valid.
pub(crate) struct Around<'a> {
    /// Radius of the lowest component, m.
    pub(crate) radius_m: Option<f64>,
    /// What the pumps deliver, m³/s.
    pub(crate) flow_m3_per_s: Option<f64>,
    /// What it is to drill, if that is solid rock.
    pub(crate) drilling: Option<&'a DrillingSpec>,
    /// Whether it is tested, whatever its law.
    pub(crate) is_tested: bool,
    pub(crate) files: &'a dyn Files,
}
