//! Sheet of a plan's inputs: well, string, mud, rig, operations and campaign, a line for each.

use serde_json::{Map, Value as Json};
use wholestring_judge::strength::PSI_PA;
use wholestring_report::{Cell, Cells, PageTable, Sheet, SheetColumn};
use wholestring_results::PlanSummary;
use wholestring_units::UnitSet;

use crate::page::{dimensions, inputs};

/// Keys of the settings that a plan depends on, without those of the dynamics only.
const KEYS: [&str; 10] =
    ["name", "units", "well", "string", "bit", "mud", "rig", "operation", "buckling", "plan"];

/// Longer lists, such as the stations of a survey, are shown as a count.
const MAX_ITEMS: usize = 40;

/// The inputs of a plan.
pub(super) fn inputs_sheet(summary: &PlanSummary, units: UnitSet) -> Sheet {
    let mut rows: Vec<[String; 3]> = Vec::new();
    for key in KEYS {
        let Some(value) = summary.settings.get(key) else { continue };
        let value = if key == "plan" { as_read(value) } else { value.clone() };
        let one = Json::Object(Map::from_iter([(key.to_owned(), value)]));
        for table in inputs::page_tables(&one) {
            rows.extend(lines(&table, units));
        }
    }
    let campaign = |word: &str, texts: &[String]| -> Vec<[String; 3]> {
        let line = |text: &String| {
            let text = summary.texts.in_units(text, units);
            ["Campaign".to_owned(), word.to_owned(), text]
        };
        texts.iter().map(line).collect()
    };
    rows.extend(campaign("counted", &summary.counted));
    rows.extend(campaign("not counted", &summary.not_counted));
    let words = |heading: &str, meaning: &str, place: usize| SheetColumn {
        heading: heading.to_owned(),
        unit: String::new(),
        meaning: meaning.to_owned(),
        cells: Cells::Words(rows.iter().map(|row| row[place].clone()).collect()),
    };
    Sheet {
        name: "Inputs".to_owned(),
        about: "The inputs of the plan with all defaults filled in".to_owned(),
        columns: vec![
            words("table", "Part of the case", 0),
            words("input", "Name of the input, or of the item of a list", 1),
            words("value", "Its value, with its unit", 2),
        ],
    }
}

/// Settings of a plan for display: without the depths, which the roadmap lists, with only the
/// operations of the campaign, and with wear factors in their own unit.
fn as_read(plan: &Json) -> Json {
    let mut plan = plan.clone();
    let Some(settings) = plan.as_object_mut() else { return plan };
    settings.remove("bit_depths_m");
    let Some(campaign) = settings.get_mut("campaign").and_then(Json::as_object_mut) else {
        return plan;
    };
    campaign.remove("operations");
    if let Some(factors) = campaign.get_mut("wear_factors") {
        let per_psi = |per_Pa: &Json| {
            let of_unit = per_Pa.as_f64()? * PSI_PA * 1e10;
            Some(format!("{}e-10/psi", number(of_unit)))
        };
        let usual = per_psi(&factors["usual_per_Pa"]);
        let own = factors["of_section_per_Pa"].as_array().into_iter().flatten();
        let of_section = |one: &Json| {
            let section = one[0].as_u64()? + 1;
            Some(format!("section {section} {}", per_psi(&one[1])?))
        };
        let all: Vec<String> = usual.into_iter().chain(own.filter_map(of_section)).collect();
        *factors = Json::String(all.join("; "));
    }
    plan
}

/// Lines of a table, one for each input or list item.
fn lines(table: &PageTable, units: UnitSet) -> Vec<[String; 3]> {
    let title = || table.title.clone();
    if table.heads.is_empty() {
        let line = |row: &Vec<Cell>| {
            let [name, value] = &row[..] else { return None };
            Some([title(), text(name, units)?, text(value, units)?])
        };
        return table.rows.iter().filter_map(line).collect();
    }
    if table.rows.len() > MAX_ITEMS {
        return vec![[title(), "rows".to_owned(), table.rows.len().to_string()]];
    }
    let line = |(place, row): (usize, &Vec<Cell>)| {
        let value = |(head, cell): (&String, &Cell)| Some(format!("{head} {}", text(cell, units)?));
        let is_named = matches!(row.first(), Some(Cell::Text(_)));
        let name = row.first().filter(|_| is_named).and_then(|cell| text(cell, units));
        let values = table.heads.iter().zip(row).skip(usize::from(is_named));
        let values: Vec<String> = values.filter_map(value).collect();
        [title(), name.unwrap_or_else(|| (place + 1).to_string()), values.join("; ")]
    };
    table.rows.iter().enumerate().map(line).collect()
}

/// A value with its unit; `None` for an empty cell.
fn text(cell: &Cell, units: UnitSet) -> Option<String> {
    let quantities = |values: &[f64], dimension: &str| {
        let unit = dimensions::unit(dimension, units);
        let factor = unit.as_ref().map_or(1.0, |unit| unit.factor);
        let numbers: Vec<String> = values.iter().map(|value| number(value / factor)).collect();
        let symbol = unit.map(|unit| unit.symbol).filter(|symbol| !symbol.is_empty());
        let numbers = numbers.join(", ");
        symbol.map_or_else(|| numbers.clone(), |symbol| format!("{numbers} {symbol}"))
    };
    match cell {
        Cell::Quantity { value, dimension, .. } => Some(quantities(&[*value], dimension)),
        Cell::Quantities { values, dimension } => Some(quantities(values, dimension)),
        Cell::Number(value) => Some(number(*value)),
        Cell::Link { text, .. } | Cell::Text(text) => {
            Some(text.clone()).filter(|it| !it.is_empty())
        }
        Cell::Nothing => None,
    }
}

/// A number in six digits, without trailing zeros.
fn number(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let scientific = format!("{value:.5e}");
    let exponent = scientific.rsplit_once('e').and_then(|(_, exponent)| exponent.parse().ok());
    let Some(exponent @ -4..9) = exponent else { return scientific };
    let decimals = (5 - exponent).max(0) as usize;
    let text = format!("{value:.decimals$}");
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}
