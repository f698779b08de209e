//! `well` in the record of a run.

use serde_json::{Value as Json, json};
use wholestring::well::{HoleSection, Roughness, Station, Well};

use super::fields::{Fields, json, word};

pub(super) fn well(well: &Well, survey: Option<&String>, tortuosity: Option<Json>) -> Json {
    let column = |value: fn(&Station) -> f64| -> Vec<f64> {
        well.path.stations().iter().map(value).collect()
    };
    let start = well.path.at(well.path.first_md_m()).position_m;
    let sections = well.hole.sections().iter();
    json!({
        "survey": survey,
        "stations": {
            "md_m": column(|station| station.md_m),
            "inclination_rad": column(|station| station.inclination_rad),
            "azimuth_rad": column(|station| station.azimuth_rad),
        },
        "path": word(&well.path.interpolation()),
        "tie_in": { "north_m": start.x, "east_m": start.y, "tvd_m": start.z },
        "tortuosity": tortuosity,
        "roughness": well.hole.roughness().map(|rough| Json::from(roughness(rough))),
        "hole": sections.map(|part| Json::from(section(part))).collect::<Vec<_>>(),
    })
}

fn roughness(roughness: &Roughness) -> Fields {
    Fields::of(roughness).renamed([
        ("radius_rms_m", "rms_m"),
        ("tortuosity_rms_m", "tortuosity_m"),
        ("shortest_m", "shortest_wavelength_m"),
        ("longest_m", "longest_wavelength_m"),
    ])
}

fn section(section: &HoleSection) -> Fields {
    let friction = &section.friction;
    // The engine stores it as a part of the kinetic one.
    let around = friction.kinetic * friction.around;
    let friction =
        Fields::of(friction).renamed([("at_rest", "static")]).with("around", json(&around));
    Fields::of(section)
        .words(["kind"])
        .renamed([("from_md_m", "from_m"), ("to_md_m", "to_m")])
        .with("friction", friction)
}
