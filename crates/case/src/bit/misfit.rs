//! The reason why the numbers of a case do not give the face of a bit.

use wholestring::rock::bit_face::{FaceError, FaceNumber};
use wholestring_config::{diagnostic::Diagnostic, reader::shown, rule::Table, source::Span};
use wholestring_units::{Dimension, UnitSet, number_text};

use super::build::BitTable;

/// The key of a number of the face.
const fn key(number: FaceNumber) -> &'static str {
    match number {
        FaceNumber::Diameter => "od",
        FaceNumber::CoreDiameter => "core_diameter",
        FaceNumber::Nose => "nose",
        FaceNumber::NoseRadius | FaceNumber::CoreNoseRadius => "nose_radius",
        FaceNumber::ShoulderRadius => "shoulder_radius",
        FaceNumber::GaugeLength => "gauge_length",
        FaceNumber::ConeAngle => "cone_angle",
        FaceNumber::Blades => "blades",
        FaceNumber::CuttersPerBlade => "cutters_per_blade",
        FaceNumber::CuttersPerTrack => "cutters_per_track",
        FaceNumber::CutterDiameter => "cutter_diameter",
        FaceNumber::CutterLength => "cutter_length",
        FaceNumber::Chamfer => "chamfer",
        FaceNumber::BackRake => "back_rake",
        FaceNumber::SideRake => "side_rake",
        FaceNumber::GaugeRelief => "gauge_relief",
        FaceNumber::Spiral => "spiral",
        FaceNumber::Exposure => "exposure",
        FaceNumber::BladeWidth => "blade_width",
        FaceNumber::CentreSpacing => "centre_spacing",
        FaceNumber::InsertDiameter => "insert_diameter",
        FaceNumber::Protrusion => "protrusion",
        FaceNumber::Rows => "rows",
        FaceNumber::Pitch => "pitch",
        FaceNumber::HalfAngle => "half_angle",
        FaceNumber::TipRadius => "tip_radius",
    }
}

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
        FaceError::OutOfRange { number, value, expected } => {
            let key = key(*number);
            let place = match number {
                FaceNumber::Diameter => Some(od),
                FaceNumber::CoreDiameter => bit.laws.kind.core_diameter.place(),
                _ => place_of(key),
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
