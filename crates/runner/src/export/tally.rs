//! The string of a case as a tally.

use serde_json::Value as Json;
use wholestring::string::Material;
use wholestring_export::{Component, Look, tubular};
use wholestring_results::{Column, Data, Table};

use super::{
    format::{Format, Made, one_table},
    source::Source,
};
use crate::error::Error;

/// Properties of a component without a column in a tally.
const NO_PLACE: [(&str, &str); 5] = [
    ("bend_rad", "bends"),
    ("lateral_force_N", "lateral forces"),
    ("eccentricity_m", "eccentricities"),
    ("survey_sensor_m", "survey sensors"),
    ("connection", "ratings of connections"),
];

/// Exports the tally in the requested format.
pub(super) fn export(
    source: &Source,
    look: &Look,
    format: Format,
    notes: &mut Vec<String>,
) -> Result<Made, Error> {
    let listed = source.settings["string"].as_array();
    let listed = listed.filter(|listed| !listed.is_empty());
    let Some(listed) = listed else {
        return Err(Error::bad_input("the settings of these results hold no string"));
    };
    let components: Vec<Component> = listed.iter().map(component).collect();
    let length_m: f64 = components.iter().map(|component| component.length_m).sum();
    notes.push(format!(
        "{} {} from the bit up; the topmost as long as it is with the bit at {}",
        components.len(),
        if components.len() == 1 { "component" } else { "components" },
        wholestring_units::Dimension::Length.format(length_m, look.units)
    ));
    for (key, what) in NO_PLACE {
        if listed.iter().any(|component| !component[key].is_null()) {
            notes.push(format!("{what} are left out: a tally has no place for them"));
        }
    }
    let is_steel = |component: &Component| {
        component.density_kg_per_m3.is_none() && component.moduli_Pa.is_none()
    };
    if matches!(format, Format::Witsml(_)) && !components.iter().all(is_steel) {
        let metals = "density and moduli of other metals than steel";
        notes.push(format!("{metals} are left out: a WITSML tubular has no place for them"));
    }
    let xml = |version| {
        let text = tubular(look, &components, version).map_err(Error::failed)?;
        Ok(Made::File(text.into_bytes()))
    };
    match format {
        Format::Csv | Format::Xlsx => {
            let about = "The components of the string, from the bit up";
            one_table(&table(&components), "Tally", about, look, format)
        }
        Format::Witsml(version) => xml(version),
        Format::Text => Err(Error::bad_input(
            "a string is not exported as a text report: expected CSV, Excel or WITSML",
        )),
    }
}

fn component(json: &Json) -> Component {
    let number = |key: &str| json[key].as_f64();
    let needed = |key: &str| number(key).unwrap_or(f64::NAN);
    Component {
        name: json["component"].as_str().unwrap_or_default().to_owned(),
        length_m: needed("length_m"),
        od_m: needed("od_m"),
        id_m: needed("id_m"),
        mass_per_length_kg_per_m: needed("mass_per_length_kg_per_m"),
        joint_od_m: number("joint_od_m"),
        joint_spacing_m: number("joint_spacing_m"),
        blade_od_m: number("blade_od_m"),
        blade_length_m: number("blade_length_m"),
        yield_strength_Pa: number("yield_strength_Pa"),
        density_kg_per_m3: number("density_kg_per_m3")
            .filter(|density| differs(*density, Material::STEEL.density_kg_per_m3)),
        moduli_Pa: number("youngs_modulus_Pa").zip(number("shear_modulus_Pa")).and_then(
            |(youngs, shear)| {
                let other = differs(youngs, Material::STEEL.youngs_modulus_Pa)
                    || differs(shear, Material::STEEL.shear_modulus_Pa);
                other.then_some([youngs, shear])
            },
        ),
    }
}

/// Whether two numbers differ by more than rounding.
fn differs(one: f64, other: f64) -> bool {
    (one - other).abs() > 1e-9 * other.abs()
}

/// A row for each component.
fn table(components: &[Component]) -> Table {
    type Getter = fn(&Component) -> Option<f64>;
    let columns: [(&str, &str, &str, Getter); 12] = [
        ("od_m", "m", "Outside diameter of the body", |component| Some(component.od_m)),
        ("id_m", "m", "Inside diameter of the body", |component| Some(component.id_m)),
        ("length_m", "m", "Length", |component| Some(component.length_m)),
        ("weight_kg_per_m", "kg/m", "Mass per length in air, joints included", |component| {
            Some(component.mass_per_length_kg_per_m)
        }),
        ("joint_od_m", "m", "Outside diameter of the tool joints", |component| {
            component.joint_od_m
        }),
        ("joint_spacing_m", "m", "Distance between tool joints", |component| {
            component.joint_spacing_m
        }),
        ("blade_od_m", "m", "Diameter over the blades", |component| component.blade_od_m),
        ("blade_length_m", "m", "Length of the blades", |component| component.blade_length_m),
        (
            "metal_density_kg_per_m3",
            "kg/m³",
            "Density of the metal, where it is not steel",
            |component| component.density_kg_per_m3,
        ),
        (
            "youngs_modulus_Pa",
            "Pa",
            "Young's modulus, where it is not that of steel",
            |component| component.moduli_Pa.map(|[youngs, _]| youngs),
        ),
        ("shear_modulus_Pa", "Pa", "Shear modulus, where it is not that of steel", |component| {
            component.moduli_Pa.map(|[_, shear]| shear)
        }),
        ("yield_strength_Pa", "Pa", "Minimum yield strength", |component| {
            component.yield_strength_Pa
        }),
    ];
    let names = components.iter().map(|component| component.name.clone()).collect();
    let mut all = vec![Column {
        meaning: "Name of the component".to_owned(),
        ..Column::words("component", names)
    }];
    // Optional columns are included only if a component has a value.
    let is_used = |(name, .., value_of): &(&str, &str, &str, Getter)| {
        let rare =
            ["blade_length_m", "metal_density_kg_per_m3", "youngs_modulus_Pa", "shear_modulus_Pa"];
        !rare.contains(name) || components.iter().any(|component| value_of(component).is_some())
    };
    all.extend(columns.into_iter().filter(is_used).map(|(name, unit, meaning, column)| Column {
        name: name.to_owned(),
        unit: unit.to_owned(),
        meaning: meaning.to_owned(),
        data: Data::Number(components.iter().map(column).collect()),
    }));
    let mut sum_m = 0.0;
    let below = components.iter().map(|component| {
        sum_m += component.length_m;
        Some(sum_m)
    });
    all.push(Column {
        name: "cumulative_length_m".to_owned(),
        unit: "m".to_owned(),
        meaning: "Length from the bit to its upper end".to_owned(),
        data: Data::Number(below.collect()),
    });
    Table::new(all)
}
