//! Inputs of the bit from other tables.

use wholestring::rock::DrillingSpec;

use wholestring_config::source::Files;

/// Inputs of the bit from other tables, where they are valid.
pub(crate) struct Around<'a> {
    /// Radius of the lowest component, m.
    pub(crate) radius_m: Option<f64>,
    /// Flow rate of the pumps, m³/s.
    pub(crate) flow_m3_per_s: Option<f64>,
    /// The rock that the bit drills, if it is solid rock.
    pub(crate) drilling: Option<&'a DrillingSpec>,
    /// Whether the bit is tested, whatever its law.
    pub(crate) is_tested: bool,
    pub(crate) files: &'a dyn Files,
}
