//! Every input of a case, defaults included, as tables.

use serde_json::{Map, Value as Json};
use wholestring_case::dimension_of;
use wholestring_units::Dimension;

use crate::{Cell, PageTable, Place, cell::capital};

/// The settings of a summary: a table for each table of the case file, and one for each list in
/// them.
pub fn input_tables(settings: &Json) -> Vec<PageTable> {
    let Some(settings) = settings.as_object() else {
        return Vec::new();
    };
    let mut page_tables = Vec::new();
    let mut general = Vec::new();
    let mut others = Vec::new();
    for (key, value) in settings {
        match value {
            Json::Object(table) => tables(&label(key), table, &mut others),
            Json::Array(list) if list.iter().any(Json::is_object) => {
                others.push(list_table(&label(key), list));
            }
            other => general.push(vec![Cell::Text(label(key)), cell(key, other)]),
        }
    }
    page_tables.push(page_table("Case", Vec::new(), general));
    page_tables.extend(others);
    page_tables
}

/// Adds a table of keys and values, and one for each list or set of columns in it.
fn tables(title: &str, table: &Map<String, Json>, page_tables: &mut Vec<PageTable>) {
    let place = page_tables.len();
    let mut rows = Vec::new();
    gather("", title, table, &mut rows, page_tables);
    if !rows.is_empty() {
        page_tables.insert(place, page_table(title, Vec::new(), rows));
    }
}

fn gather(
    prefix: &str,
    title: &str,
    table: &Map<String, Json>,
    rows: &mut Vec<Vec<Cell>>,
    page_tables: &mut Vec<PageTable>,
) {
    for (key, value) in table {
        let name = under(prefix, key);
        let below = || format!("{title}: {}", lower(&name));
        match value {
            Json::Object(inner) if is_columns(inner) => {
                page_tables.push(columns_table(&below(), inner))
            }
            Json::Object(inner) => gather(&name, title, inner, rows, page_tables),
            Json::Array(list) if list.iter().any(Json::is_object) => {
                page_tables.push(list_table(&below(), list));
            }
            other => rows.push(vec![Cell::Text(name), cell(key, other)]),
        }
    }
}

/// Whether a table contains number lists of equal length, as the columns of a survey.
fn is_columns(table: &Map<String, Json>) -> bool {
    let lengths: Vec<Option<usize>> = table
        .values()
        .map(|value| {
            let list = value.as_array()?;
            list.iter().all(Json::is_number).then_some(list.len())
        })
        .collect();
    matches!(lengths[..], [Some(first), ..] if lengths.iter().all(|length| *length == Some(first)))
}

fn columns_table(title: &str, table: &Map<String, Json>) -> PageTable {
    // JSON does not preserve the order of columns; a depth is put first.
    let mut names: Vec<&String> = table.keys().collect();
    names.sort_by_key(|name| (name.as_str() != "md_m", name.as_str() == "azimuth_rad"));
    let rows = table.values().filter_map(Json::as_array).map(Vec::len);
    let rows = (0..rows.max().unwrap_or(0))
        .map(|row| names.iter().map(|name| cell(name, &table[*name][row])).collect())
        .collect();
    page_table(title, names.iter().map(|name| label(name)).collect(), rows)
}

/// A table with a row for each item.
fn list_table(title: &str, list: &[Json]) -> PageTable {
    let mut names: Vec<String> = Vec::new();
    let flat: Vec<Vec<(String, Cell)>> = list
        .iter()
        .map(|item| {
            let mut cells = Vec::new();
            flatten("", item, &mut cells);
            cells
        })
        .collect();
    for (name, _) in flat.iter().flatten() {
        if !names.contains(name) {
            names.push(name.clone());
        }
    }
    let value = |cells: &[(String, Cell)], name: &String| {
        let cell = cells.iter().find(|(other, _)| other == name);
        cell.map_or(Cell::Nothing, |(_, cell)| cell.clone())
    };
    // Columns without any value are left out.
    names.retain(|name| flat.iter().any(|cells| value(cells, name) != Cell::Nothing));
    // The name of an item comes first; items that lack a key do not move its column.
    names.sort_by_key(|name| {
        let first = ["Component", "Kind", "At"].contains(&name.as_str());
        (!first, name.to_lowercase())
    });
    let rows =
        flat.iter().map(|cells| names.iter().map(|name| value(cells, name)).collect()).collect();
    page_table(title, names, rows)
}

fn flatten(prefix: &str, item: &Json, cells: &mut Vec<(String, Cell)>) {
    for (key, value) in item.as_object().into_iter().flatten() {
        let name = under(prefix, key);
        match value {
            Json::Object(_) => flatten(&name, value, cells),
            other => cells.push((name, cell(key, other))),
        }
    }
}

fn page_table(title: &str, heads: Vec<String>, rows: Vec<Vec<Cell>>) -> PageTable {
    PageTable { place: Place::Inputs, title: title.into(), heads, rows }
}

/// A value of the settings.
fn cell(key: &str, value: &Json) -> Cell {
    match value {
        Json::Null => Cell::Nothing,
        Json::Bool(yes) => Cell::Text(if *yes { "yes" } else { "no" }.into()),
        Json::String(text) => Cell::Text(text.clone()),
        Json::Number(number) => {
            let value = number.as_f64().unwrap_or(f64::NAN);
            match setting_dimension(key) {
                Some((dimension, _)) => Cell::quantity(value, dimension),
                None => Cell::number(value),
            }
        }
        Json::Array(items) => {
            let values: Vec<f64> = items.iter().filter_map(Json::as_f64).collect();
            if let Some((dimension, _)) = setting_dimension(key)
                && !items.is_empty()
                && values.len() == items.len()
            {
                return Cell::Quantities { values, dimension: dimension.into() };
            }
            let text = |item: &Json| match item {
                Json::String(text) => text.replace('_', " "),
                other => other.to_string(),
            };
            Cell::Text(items.iter().map(text).collect::<Vec<_>>().join(", "))
        }
        Json::Object(_) => Cell::Text(value.to_string()),
    }
}

/// Dimension of a key of the settings on the page, and its name without the unit; `None` for a bare
/// number.
pub fn setting_dimension(key: &str) -> Option<(&'static str, &str)> {
    if let Some(name) = key.strip_suffix("_J_per_m3") {
        return Some(("work per volume", name));
    }
    let (dimension, name) = dimension_of(key)?;
    Some(match dimension {
        // In GPa, unlike other stresses.
        Dimension::Stress if name.ends_with("modulus") => ("modulus", name),
        other => (other.name(), name),
    })
}

/// Label of a key without its unit: `bit_depth_m` is the bit depth.
fn label(key: &str) -> String {
    let name = setting_dimension(key).map_or(key, |(_, name)| name);
    match name {
        "md" => return "Measured depth".into(),
        "od" => return "OD".into(),
        "id" => return "ID".into(),
        "rop" => return "Rate of penetration".into(),
        "wob" => return "Weight on bit".into(),
        "tvd" => return "TVD".into(),
        _ => {}
    }
    let words = name
        .replace('_', " ")
        .replace("youngs", "Young's")
        .replace("poisson", "Poisson's")
        .replace(" od", " OD");
    capital(&words)
}

/// Label of a key of a nested table: `damping.mass_per_s` is "Damping, mass".
fn under(above: &str, key: &str) -> String {
    match (above, label(key)) {
        ("", own) => own,
        (above, own) if own.chars().nth(1).is_some_and(char::is_uppercase) => {
            format!("{above}, {own}")
        }
        (above, own) => format!("{above}, {}", lower(&own)),
    }
}

fn lower(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_lowercase().chain(letters).collect())
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;
    use crate::display_units;

    #[test]
    fn keys_of_the_settings_have_their_dimension() {
        for (key, expected) in [
            ("bit_depth_m", "length"),
            ("od_m", "diameter"),
            ("diameter_m", "diameter"),
            ("gauge_relief_m", "diameter"),
            ("mass_per_length_kg_per_m", "mass per length"),
            ("youngs_modulus_Pa", "modulus"),
            ("yield_strength_Pa", "stress"),
            ("largest_von_mises_stress_Pa", "stress"),
            ("pump_pressure_limit_Pa", "pressure"),
            ("pump_pressure_Pa", "pressure"),
            ("rock_stiffness_N_per_m", "stiffness"),
            ("top_drive_torque_N_m", "torque"),
            ("rotary_speed_rad_per_s", "rotary speed"),
            ("gain_m_per_s_per_N", "hoist gain"),
            ("rop_m_per_s", "rate of penetration"),
            ("settle_s", "time"),
        ] {
            let found = setting_dimension(key).map(|(dimension, _)| dimension);
            assert_eq!(found, Some(expected), "{key}");
            assert!(display_units().contains_key(expected), "{expected}");
        }
        assert_eq!(setting_dimension("seed"), None);
    }

    #[test]
    fn every_input_has_its_place() {
        let settings = json!({
            "name": "A well",
            "model": ["soft", "dynamic"],
            "well": {
                "survey": null,
                "stations": {
                    "azimuth_rad": [0.0, 0.0],
                    "inclination_rad": [0.0, 0.1],
                    "md_m": [0.0, 100.0],
                },
                "hole": [{ "kind": "open", "diameter_m": 0.2, "friction": { "kinetic": 0.3 } }],
            },
            "dynamics": { "damping": { "mass_per_s": 0.5 }, "seed": 1 },
            "bit_test": { "wob_N": [1e4, 2e4], "cells": [3, 4] },
        });
        let page_tables = input_tables(&settings);
        let titles: Vec<&str> =
            page_tables.iter().map(|page_table| page_table.title.as_str()).collect();
        assert_eq!(
            titles,
            ["Case", "Bit test", "Dynamics", "Well", "Well: hole", "Well: stations"]
        );
        let find =
            |title: &str| page_tables.iter().find(|page_table| page_table.title == title).unwrap();
        assert_eq!(
            find("Dynamics").rows,
            [
                vec![Cell::Text("Damping, mass".into()), Cell::quantity(0.5, "frequency")],
                vec![Cell::Text("Seed".into()), Cell::Number(1.0)],
            ]
        );
        let weights = Cell::Quantities { values: vec![1e4, 2e4], dimension: "force".into() };
        assert_eq!(
            find("Bit test").rows,
            [
                vec![Cell::Text("Cells".into()), Cell::Text("3, 4".into())],
                vec![Cell::Text("Weight on bit".into()), weights],
            ]
        );
        let stations = find("Well: stations");
        assert_eq!(stations.heads, ["Measured depth", "Inclination", "Azimuth"]);
        assert_eq!(
            stations.rows[1],
            [("length", 100.0), ("angle", 0.1), ("angle", 0.0)]
                .map(|(dimension, value)| Cell::quantity(value, dimension))
        );
        let hole = find("Well: hole");
        assert_eq!(hole.heads, ["Kind", "Diameter", "Friction, kinetic"]);
    }
}
