//! What is said once for several components.

use crate::fragment::Note;

/// What is said once for several components.
#[derive(Debug, Default)]
pub(crate) struct Said {
    /// Blades without a length.
    pub(crate) bladed: Vec<String>,
    /// Called stabilisers, without a gauge.
    pub(crate) bladeless: Vec<String>,
    /// Pipe without a weight.
    pub(crate) unweighed_pipe: Vec<String>,
    /// Without a weight.
    pub(crate) unweighed: Vec<String>,
    /// With a nominal weight alone.
    pub(crate) nominal: Vec<String>,
}

impl Said {
    pub(crate) fn tell(self, notes: &mut Vec<Note>) {
        let mut tell = |names: Vec<String>, text: &str| {
            if names.is_empty() {
                return;
            }
            let names: Vec<String> = names.iter().map(|name| format!("'{name}'")).collect();
            notes.push(Note::Assumed(format!("{}: {text}", names.join(", "))));
        };
        tell(
            self.bladed,
            "the gauge is that of blades all along the component; give blade_length where they are \
             shorter",
        );
        tell(
            self.bladeless,
            "called a stabiliser or reamer, and without a gauge: it touches the wall with its body; \
             give blade_od",
        );
        tell(
            self.unweighed_pipe,
            "no weight; computed from the diameters as steel, WITHOUT TOOL JOINTS, which make pipe a \
             tenth heavier or more: give mass_per_length, or catalogue",
        );
        tell(self.unweighed, "no weight; computed from the diameters as steel");
        tell(self.nominal, "the nominal weight is taken for the weight, without tool joints");
    }
}
