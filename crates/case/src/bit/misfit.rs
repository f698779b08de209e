//! The reason why the numbers of a case do not give the face of a bit.

use wholestring::rock::bit_face::FaceError;
use wholestring_config::{diagnostic::Diagnostic, reader::shown, rule::Table, source::Span};
use wholestring_units::{Dimension, UnitSet, number_text};

use super::build::BitTable;

/// The key of each number, by its name in errors of the face; the diameters are keys of other
/// tables.
const KEYS: [(&str, &str); 24] = [
    ("nose position", "nose"),
    ("nose radius", "nose_radius"),
    ("nose radius of a core bit", "nose_radius"),
    ("shoulder radius", "shoulder_radius"),
    ("gauge length", "gauge_length"),
    ("cone angle", "cone_angle"),
    ("number of blades", "blades"),
    ("cutters per blade", "cutters_per_blade"),
    ("cutters per track", "cutters_per_track"),
    ("cutter diameter", "cutter_diameter"),
    ("cutter length", "cutter_length"),
    ("chamfer", "chamfer"),
    ("back rake", "back_rake"),
    ("side rake", "side_rake"),
    ("gauge relief", "gauge_relief"),
    ("spiral of the blades", "spiral"),
    ("exposure", "exposure"),
    ("blade width", "blade_width"),
    ("centre spacing", "centre_spacing"),
    ("insert diameter", "insert_diameter"),
    ("protrusion", "protrusion"),
    ("rows of inserts", "rows"),
    ("pitch of the inserts", "pitch"),
    ("half angle of the inserts", "half_angle"),
];

/// Returns the mistake, at those of its numbers that the case gives; `od` is the diameter's place.
pub(crate) fn misfit(error: &FaceError, bit: &BitTable, od: Span, units: UnitSet) -> Diagnostic {
    let size = |length_m: f64| shown(Dimension::Diameter, length_m, units);
    let whole = bit.laws.rock.face.at().map_or(od, |at| at.place);
    let place_of = |key: &str| {
        let keys = bit.laws.rock.face.get()?.written();
        keys.iter().find(|at| at.name == key).map(|at| at.place)
    };
    // The first of these keys that the case gives.
    let first = |keys: &[&str]| keys.iter().find_map(|key| place_of(key)).unwrap_or(whole);
    match error {
        FaceError::OutOfRange { quantity, value, expected } => {
            let (key, place) = match *quantity {
                "diameter" => ("od", Some(od)),
                "core diameter" => ("core_diameter", bit.laws.kind.core_diameter.place()),
                "tip radius of the inserts" => ("tip_radius", place_of("tip_radius")),
                other => {
                    let known = KEYS.iter().find(|(name, _)| *name == other);
                    let key = known.map_or(other, |(_, key)| *key);
                    (key, place_of(key))
                }
            };
            let diagnostic = Diagnostic::error(format!("`{key}` does not suit the bit"));
            match place {
                Some(place) => diagnostic.at(place, format!("expected {expected}")),
                None => diagnostic.at(
                    whole,
                    format!(
                        "it is {} where none is given: expected {expected}",
                        number_text(*value)
                    ),
                ),
            }
        }
        FaceError::Profile { nose_radius_m, shoulder_radius_m, reach_m } => {
            let reach = size(*reach_m);
            Diagnostic::error("the arcs of the bit's nose and shoulder cannot meet")
                .at(
                    first(&["nose_radius", "shoulder_radius", "nose"]),
                    format!("arcs of {} and {}", size(*nose_radius_m), size(*shoulder_radius_m)),
                )
                .help(format!(
                    "of nose_radius and shoulder_radius one must be no smaller, the other no \
                     larger than the {reach} from \
                     the nose to the gauge"
                ))
        }
        FaceError::Unspread { cutters_per_track, blades } => {
            Diagnostic::error("the cutters of a track do not spread evenly over the blades").at(
                first(&["cutters_per_track", "blades"]),
                format!("{cutters_per_track} do not divide {blades} blades"),
            )
        }
        FaceError::Overlap { distance_m, diameter_m, .. } => {
            Diagnostic::error("two cutters of a blade overlap")
                .at(
                    first(&["cutters_per_blade", "cutter_diameter", "blades", "centre_spacing"]),
                    format!("they are {} wide and {} apart", size(*diameter_m), size(*distance_m)),
                )
                .help(
                    "lower cutters_per_blade or cutter_diameter, or leave the number of cutters to \
                   the program",
                )
        }
        FaceError::UncutRing { from_m, to_m } => {
            Diagnostic::error("the bit leaves a ring of the bottom uncut")
                .at(
                    first(&[
                        "cutters_per_blade",
                        "rows",
                        "cutter_diameter",
                        "insert_diameter",
                        "exposure",
                        "protrusion",
                        "blades",
                        "centre_spacing",
                    ]),
                    format!(
                        "no cutter reaches the rock between the radii {} and {}",
                        size(*from_m),
                        size(*to_m)
                    ),
                )
                .help("more, wider or more exposed cutters reach it")
        }
        other => Diagnostic::error(other.to_string()).at(whole, "the face of the bit"),
    }
}
