//! The workbook of a plan is read back: every cell equals that of the table, in the unit of its
//! heading.

use std::{f64::consts::PI, path::Path};

use calamine::{Data as Read, Range, Reader, Xlsx, open_workbook};
use wholestring::{operation::OperationKind, outcome::ModelKind, well::FrictionLevel};
use wholestring_case::{Override, Template};
use wholestring_results::{Data, PlanSummary, Table};
use wholestring_runner::{CancellationToken, Existing, Output, Silent, plan};
use wholestring_units::UnitSet;

/// Sheets after the charts, and their tables.
const SHEETS: [(&str, &str); 7] = [
    ("Broomstick", "plan_broomstick"),
    ("Weight to buckle", "plan_buckling"),
    ("Surface limits", "plan_surface_limits"),
    ("Fatigue", "plan_fatigue"),
    ("Casing wear", "plan_wear"),
    ("Friction", "plan_friction"),
    ("Hydraulics", "plan_hydraulics"),
];

/// SI value of each unit in sheets with US field units, from the foot and the pound of 1959 and the
/// gallon of 231 cubic inches.
const UNITS: [(&str, f64); 7] = [
    ("ft", 0.3048),
    ("in", 0.0254),
    ("klbf", 4_448.221_615_260_5),
    ("ft·lbf", 0.3048 * 4.448_221_615_260_5),
    ("psi", 4.448_221_615_260_5 / (0.0254 * 0.0254)),
    ("ppg", 0.453_592_37 / (231.0 * 0.0254 * 0.0254 * 0.0254)),
    ("°", PI / 180.0),
];

/// Relative rounding error of converting there and back.
const ROUNDED: f64 = 1e-12;

fn changes() -> Vec<Override> {
    let changes = [
        "plan.depths=3",
        "operation.kind=[\"drill\"]",
        "operation.flow_rate=30 l/s",
        "mud.rheology=bingham",
        "mud.plastic_viscosity=0.02 Pa.s",
        "mud.yield_point=7 Pa",
        "rig.block_weight=150 kN",
        "rig.hoist_capacity=600 kN",
    ];
    changes.iter().map(|change| change.parse().expect("an override")).collect()
}

#[test]
fn every_cell_is_that_of_a_table() {
    let place = tempfile::tempdir().expect("a folder");
    let folder = place.path().join("out");
    let file = Path::new("../../cases/slant.toml");
    let (template, overrides) = (Template::read(file).expect("a case"), changes());
    let case = template.case(&overrides).expect("a valid case");
    let request = plan::Request {
        case: &case,
        template: &template,
        overrides: &overrides,
        units: Some(UnitSet::Field),
        output: Output {
            folder: Some(folder.clone()),
            existing: Existing::Protect,
            ..Output::default()
        },
        jobs: std::num::NonZeroUsize::new(1),
        checkpoint_every: None,
        overlay: None,
        png: false,
    };
    plan::run(&request, &Silent, &CancellationToken::new()).expect("a plan");

    let mut file: Xlsx<_> = open_workbook(folder.join("plan.xlsx")).expect("a workbook");
    let names = file.sheet_names();
    assert_eq!(names[..4], ["Inputs", "Verdict", "Roadmap", "Charts"]);
    assert_eq!(names.last().map(String::as_str), Some("Columns"));
    let mut numbers = 0;
    for (sheet, name) in SHEETS {
        let table = Table::read_parquet(&folder.join(format!("{name}.parquet"))).expect("a table");
        assert!(table.rows() > 0, "{name}");
        let cells = file.worksheet_range(sheet).expect("a sheet");
        assert_eq!(cells.height(), table.rows() + 1, "{sheet}");
        numbers += compare(sheet, &cells, &table);
    }
    assert!(numbers > 300, "{numbers} numbers");
    // A row for each check, the most severe first.
    let summary = PlanSummary::read(&folder.join("summary.json")).expect("a summary");
    let verdicts = file.worksheet_range("Verdict").expect("a sheet");
    assert_eq!(verdicts.height(), summary.checks.len() + 1);
    let most_severe = summary.checks.iter().map(|row| row.check.severity).max().expect("checks");
    assert_eq!(verdicts.get((1, 0)).expect("a cell").to_string(), most_severe.name());
    // What the verdict does not include.
    let unchecked = file.worksheet_range("Not checked").map_or(1, |sheet| sheet.height());
    assert_eq!(unchecked, summary.unchecked.len() + 1);
    // The inputs equal those of the case, in display units.
    let inputs = file.worksheet_range("Inputs").expect("a sheet");
    let has = |line: [&str; 3]| inputs.rows().any(|row| row.iter().zip(line).all(|(a, b)| *a == b));
    assert!(has(["Mud", "Density", "9.17994 ppg"]), "{inputs:?}");
    assert!(has(["Rig", "Hoist capacity", "134.885 klbf"]), "{inputs:?}");
    assert!(has(["Plan", "Campaign, wear factors", "5e-10/psi"]), "{inputs:?}");
    // A row of the roadmap contains all operations at a depth, as in the broomstick.
    let roadmap = file.worksheet_range("Roadmap").expect("a sheet");
    assert_eq!(roadmap.height(), summary.bit_depths_m.len() + 1);
    let column = |heading: &str| {
        let mut heads = roadmap.rows().next().expect("a heading").iter();
        heads.position(|head| *head == heading).unwrap_or_else(|| panic!("{heading}"))
    };
    let last = roadmap.rows().next_back().expect("a row");
    let deepest_m = summary.bit_depths_m.last().copied();
    for (operation, level, heading, unit) in [
        (OperationKind::TripOut, FrictionLevel::High, "trip out hook load high, klbf", UNITS[2].1),
        (OperationKind::Drill, FrictionLevel::Low, "drill torque low, ft·lbf", UNITS[3].1),
    ] {
        let mut curve = summary.curve(ModelKind::Soft, operation, level);
        let scalars = curve.find(|point| Some(point.bit_depth_m) == deepest_m).expect("a point");
        let scalars = scalars.scalars.expect("an answer");
        let is_torque = heading.contains("torque");
        let si = if is_torque { scalars.surface_torque_N_m } else { scalars.hook_load_N };
        let Read::Float(read) = last[column(heading)] else { panic!("{heading}") };
        assert!((read * unit - si).abs() <= ROUNDED * si.abs(), "{heading}: {read} for {si}");
    }
    // Explanations of the rows and of each column.
    let columns = file.worksheet_range("Columns").expect("a sheet");
    assert!(columns.rows().all(|row| row[3] != Read::Empty));

    // It prints on a few sheets of paper, with only the first rows of a long table.
    let areas: Vec<(String, String)> = file.defined_names().to_vec();
    let mut printed_rows = 0;
    let mut longest = 0;
    for sheet in &names {
        let rows = file.worksheet_range(sheet).expect("a sheet").height();
        let is_its = |(name, area): &&(String, String)| {
            let quoted = [format!("{sheet}!"), format!("'{sheet}'!")];
            name.contains("Print_Area") && quoted.iter().any(|start| area.starts_with(start))
        };
        let last = |area: &str| area.rsplit('$').next().and_then(|row| row.parse().ok());
        let printed = areas.iter().find(is_its).and_then(|(_, area)| last(area)).unwrap_or(rows);
        let is_read_first = ["Inputs", "Verdict", "Roadmap", "Columns"].contains(&sheet.as_str());
        assert!(printed <= 51 || is_read_first, "{sheet}: {printed} of {rows} rows");
        printed_rows += printed;
        longest = longest.max(rows);
    }
    assert!(longest > 100 && printed_rows < 700, "{longest} rows, {printed_rows} printed");
}

/// Headings in the words of the field, and the names of their columns.
const HEADINGS: [(&str, &str); 3] =
    [("measured depth", "md"), ("axial friction", "along"), ("rotational friction", "around")];

/// Compares a sheet with its table; returns the number of numeric cells.
fn compare(sheet: &str, cells: &Range<Read>, table: &Table) -> usize {
    let cell = |row: usize, column: usize| cells.get((row, column)).cloned().unwrap_or_default();
    let row_units = table.columns().iter().position(|column| column.name == "unit");
    let mut numbers = 0;
    for (place, column) in table.columns().iter().enumerate() {
        let heading = cell(0, place).to_string();
        let (stem, unit) = heading.split_once(", ").unwrap_or((&heading, ""));
        let renamed = HEADINGS.iter().find(|(heading, _)| *heading == stem);
        let names = [Some(stem), renamed.map(|(_, name)| *name)];
        let mut names = names.into_iter().flatten().map(|name| name.replace(' ', "_"));
        let is_column = names.any(|name| column.name.starts_with(&name));
        assert!(is_column, "{sheet}: {heading} of {}", column.name);
        assert_eq!(unit.is_empty(), column.unit.is_empty(), "{sheet}: {heading}");
        let own = ["load", "capacity"].contains(&column.name.as_str());
        for row in 0..table.rows() {
            let read = cell(row + 1, place);
            let place = format!("{sheet}: {heading}, row {row}");
            match &column.data {
                Data::Number(values) => {
                    let unit = match row_units.filter(|_| own) {
                        Some(units) => cell(row + 1, units).to_string(),
                        None => unit.to_owned(),
                    };
                    let known = UNITS.iter().find(|unit_row| unit_row.0 == unit);
                    assert!(unit.is_empty() || known.is_some(), "{place}: {unit}");
                    let factor = known.map_or(1.0, |unit_row| unit_row.1);
                    match (read, values[row]) {
                        (Read::Empty, None) => {}
                        (Read::Float(read), Some(si)) => {
                            let off = (read * factor - si).abs();
                            assert!(off <= ROUNDED * si.abs(), "{place}: {read} {unit} of {si}");
                            numbers += 1;
                        }
                        (read, value) => panic!("{place}: {read:?} of {value:?}"),
                    }
                }
                Data::Text(words) => {
                    let word = match column.name.as_str() {
                        "operation" => {
                            let operation = OperationKind::from_name(&words[row]);
                            operation.expect("an operation").words().to_owned()
                        }
                        "worst_check" | "kind" => {
                            let kind = wholestring_judge::CheckKind::named(&words[row]);
                            kind.map_or_else(|| words[row].clone(), |kind| kind.label().to_owned())
                        }
                        // In display units.
                        "unit" => continue,
                        _ => words[row].clone(),
                    };
                    assert_eq!(read.to_string(), word, "{place}");
                }
            }
        }
    }
    numbers
}
