//! Keys that do not suit the kind of bit, and cutters that do not suit any bit.

use wholestring_units::Dimension;

use wholestring_config::{diagnostic::Diagnostic, names::any_of, reader::Reader, rule::Table};

use super::table::{FaceTable, Tip};
use crate::bit::kind::Kind;

/// Smallest width of a cutter, as a part of the bit's diameter.
const FINEST: f64 = 0.02;

impl FaceTable {
    /// Refuses cutters that are finer than those of any bit, because the search for a layout grows
    /// with their number.
    pub(super) fn check_width(&self, diameter_m: f64, reader: &mut Reader) -> Option<()> {
        let min_m = FINEST * diameter_m;
        let fine = [(&self.cutter_diameter, "cutters"), (&self.insert_diameter, "inserts")]
            .into_iter()
            .find_map(|(field, what)| Some((field.given().filter(|at| at.value < min_m)?, what)));
        let Some((entry, what)) = fine else {
            return Some(());
        };
        let least = reader.at_least(Dimension::Diameter, min_m);
        Diagnostic::error(format!("the {what} are too fine for this bit"))
            .at(entry.place, format!("expected at least {least}, a fiftieth of its diameter"))
            .refuse(reader)
    }

    pub(super) fn warn_of_idle_keys(&self, kind: Kind, reader: &mut Reader) {
        let cones = self.insert_shape.get() == Some(&Tip::Cone);
        for key in self.written() {
            let why = match key.name {
                "cone_angle" if kind == Kind::Core => "a core bit has no cone".to_owned(),
                _ if !key.is_used_with(kind.word()) => {
                    format!("used with kind = {}", any_of(&key.used_with))
                }
                "half_angle" | "tip_radius" if !cones => {
                    "used with insert_shape = \"cone\"".to_owned()
                }
                _ => continue,
            };
            reader.report(Diagnostic::idle(key.name, key.place, why));
        }
    }
}
