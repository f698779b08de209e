//! Keys that do not suit the kind of bit, and cutters that suit none.

use wholestring_units::number_text;

use wholestring_config::{diagnostic::Diagnostic, reader::Reader};

use super::table::{FaceTable, Tip};
use crate::bit::kind::Kind;

/// Finer cutters than this part of the bit's diameter are no bit's.
const FINEST: f64 = 0.02;

impl FaceTable {
    /// Finer ones than any bit has are looked for as long as they are found.
    pub(super) fn check_width(&self, diameter_m: f64, reader: &mut Reader) -> Option<()> {
        let least_m = FINEST * diameter_m;
        let fine = [
            (&self.cutter_diameter, "cutters"),
            (&self.insert_diameter, "inserts"),
        ]
        .into_iter()
        .find_map(|(field, what)| Some((field.given().filter(|at| at.value < least_m)?, what)));
        let Some((given, what)) = fine else {
            return Some(());
        };
        let least = number_text((least_m * 1e4).ceil() * 1e-1);
        reader.report(
            Diagnostic::error(format!("the {what} are too fine for this bit")).at(
                given.place,
                format!("expected at least {least} mm, a fiftieth of its diameter"),
            ),
        );
        None
    }

    pub(super) fn warn_of_idle_keys(&self, kind: Kind, reader: &mut Reader) {
        const OF_INSERTS: [&str; 7] = [
            "insert_diameter",
            "insert_shape",
            "half_angle",
            "tip_radius",
            "protrusion",
            "rows",
            "pitch",
        ];
        const OF_ALL: [&str; 6] = [
            "cone_angle",
            "nose",
            "nose_radius",
            "shoulder_radius",
            "gauge_length",
            "gauge_relief",
        ];
        let cones = self.insert_shape.get() == Some(&Tip::Cone);
        for (name, given) in self.places() {
            let Some(given) = given else { continue };
            let why = match name {
                "cone_angle" if kind == Kind::Core => "a core bit has no cone",
                name if OF_ALL.contains(&name) => continue,
                name if OF_INSERTS.contains(&name) && kind != Kind::Inserts => {
                    "used with kind = \"inserts\""
                }
                "half_angle" | "tip_radius" if !cones => "used with insert_shape = \"cone\"",
                name if OF_INSERTS.contains(&name) || kind != Kind::Inserts => continue,
                _ => "used with kind = \"pdc\" or \"core\"",
            };
            let message = format!("`{name}` has no effect here");
            reader.report(Diagnostic::warning(message).at(given, why));
        }
    }
}
