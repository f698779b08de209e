//! Settings of the assembly's solution.

use crate::statics::stiff::StiffSettings;

/// Part of the string that is solved with the assembly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Extent {
    /// All of it.
    Whole,
    /// The assembly and so much of the pipe above it, m; the top of that is on the hole's axis.
    PipeAbove(f64),
}

/// Settings of the assembly's solution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AssemblySettings {
    /// Wall, bit and upper end. Its element lengths are not used.
    pub stiff: StiffSettings,
    /// Part of the string that is solved.
    pub extent: Extent,
    /// Length of the elements of the assembly, m. Those of jointed pipe are an eighth of a joint.
    pub element_length_m: f64,
}

impl Default for AssemblySettings {
    /// 100 m of pipe above the assembly, elements of 0.3 m.
    fn default() -> Self {
        Self {
            stiff: StiffSettings::default(),
            extent: Extent::PipeAbove(100.0),
            element_length_m: 0.3,
        }
    }
}
