//! Declared rows: columns, cells, JSON, and rows that are read back.

use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::json;
use wholestring::{operation::OperationKind, outcome::ModelKind, well::FrictionLevel};

use super::*;
use crate::columns::MODEL;

rows! {
    /// Each type of a field that is a column.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct Flat {
        model: ModelKind => Words as MODEL, "The model";
        operation: Option<OperationKind> => Words, "The operation, or empty",
            null_where "it concerns all operations";
        level: FrictionLevel => Words, "Level of friction";
        name: String => Words, "A name";
        message: Option<String> => Words, "A message, or empty", null_where "there is none";
        count: usize => Ratio, "A count";
        depth_m: f64 => Depth, "A depth";
        force_N: Option<f64> => Force, "A force, or `null`", null_where "there is none";
        stops: bool => Ratio, "1 where it stops, else 0";
        steady: Option<bool> => Words, "`yes` or `no`, or empty", null_where "nobody knows";
    }

    /// Columns of flat rows.
    pub const FLAT, read;
}

/// A structure in a row.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Place {
    md_m: f64,
    component: String,
}

parts![Place];

rows! {
    /// Fields of several columns, fields without a column and columns without a field.
    #[derive(Debug, Clone, PartialEq, Serialize)]
    pub struct Nested {
        is_torque: bool, "Whether it is a torque";
        #[serde(rename = "amount")]
        value: f64, "The value";
        value_N = |row| (!row.is_torque).then_some(row.value * factor) => Force,
            "The value of a force, or `null`",
            null_where "it is a torque";
        pair_Pa: Option<[f64; 2]>, "A pair", columns {
            low_Pa = |pair| pair[0] => Pressure, "Its first, or `null`", null_where "there is none";
            high_Pa = |pair| pair[1] => Pressure, "Its second, or `null`",
                null_where "there is none";
        };
        place: Place, "A place", columns {
            md_m => Depth, "Its depth";
            component => Words, "Its component";
        };
        other: Option<Place>, "Another place", columns {
            other_component = |place| &place.component => Words, "Its component, or empty",
                null_where "there is none";
        };
        factor = |_| factor => Ratio, "The factor";
    }

    /// Columns of nested rows.
    pub const NESTED with factor: f64;
}

rows! {
    /// Weights and torques.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Loaded {
        name: String => Words, "A name";
        is_torque = |row| row.name.starts_with("torque"), loads {
            measured: f64, "Measured weight" | "Measured torque";
            expected: f64, "The expected one";
        };
        is_sound: bool => Ratio, "1 where it is sound, else 0";
    }

    /// Columns of loads.
    pub const LOADED, read;
}

rows! {
    /// Weights and torques that follow from the fields.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Derived {
        is_torque: bool, "Whether it is a torque";
        value: Option<f64>, "The value";
        is_torque = |row| row.is_torque, loads {
            value = |row| row.value, "The value", unanswered;
            twice = |row| row.value.map(|value| 2.0 * value), "Twice the value" | _,
                unanswered "as the value";
        };
    }

    /// Columns of derived loads.
    pub const DERIVED;
}

struct Foreign {
    width_m: f64,
    ends_m: [f64; 2],
}

rows! {
    for Foreign {
        width_m => Length, "Its width";
        name = |_| name => Words, "Its name";
        end_m = |foreign| foreign.ends_m[1] => Length, "Its end";
    }

    /// Columns of an existing type.
    pub const FOREIGN with name: &str;
}

fn flat() -> [Flat; 2] {
    let full = Flat {
        model: ModelKind::Stiff,
        operation: Some(OperationKind::TripOut),
        level: FrictionLevel::High,
        name: "collar".into(),
        message: Some("locked up".into()),
        count: 3,
        depth_m: 1200.5,
        force_N: Some(-2.0),
        stops: true,
        steady: Some(false),
    };
    let empty = Flat {
        operation: None,
        message: None,
        force_N: None,
        stops: false,
        steady: None,
        ..full.clone()
    };
    [full, empty]
}

fn names(columns: &[ColumnSpec]) -> Vec<&'static str> {
    columns.iter().map(|column| column.name).collect()
}

/// A table with one column replaced.
fn with_column(table: &Table, column: Column) -> Table {
    let columns = table.columns().iter().map(|own| match own.name == column.name {
        true => column.clone(),
        false => own.clone(),
    });
    Table::new(columns.collect())
}

fn error(table: &Table) -> String {
    let error = Flat::read(table, Path::new("flat.parquet")).expect_err("a defect");
    error.to_string()
}

#[test]
fn columns_follow_the_declaration() {
    let expected = [
        "model",
        "operation",
        "level",
        "name",
        "message",
        "count",
        "depth_m",
        "force_N",
        "stops",
        "steady",
    ];
    assert_eq!(names(FLAT), expected);
    assert_eq!(FLAT[0], MODEL);
    assert_eq!(
        FLAT[7],
        ColumnSpec::number(
            "force_N",
            wholestring::outcome::QuantityKind::Force,
            "A force, or `null`"
        )
        .null_where("there is none")
    );
    assert_eq!(
        names(NESTED),
        ["value_N", "low_Pa", "high_Pa", "md_m", "component", "other_component", "factor"]
    );
    assert_eq!(names(FOREIGN), ["width_m", "name", "end_m"]);
}

#[test]
fn cells_of_every_type() {
    let table = Flat::table(flat());
    assert!(table.is_like(&Table::with_columns(FLAT)));
    let words = |name: &str| table.words(name).expect("words").to_vec();
    assert_eq!(words("model"), ["stiff", "stiff"]);
    assert_eq!(words("operation"), ["trip_out", ""]);
    assert_eq!(words("level"), ["high", "high"]);
    assert_eq!(words("message"), ["locked up", ""]);
    assert_eq!(words("steady"), ["no", ""]);
    let numbers = |name: &str| table.numbers(name).expect("numbers").to_vec();
    assert_eq!(numbers("count"), [Some(3.0); 2]);
    assert_eq!(numbers("force_N"), [Some(-2.0), None]);
    assert_eq!(numbers("stops"), [Some(1.0), Some(0.0)]);
    let endless = Flat { depth_m: f64::INFINITY, ..flat()[0].clone() };
    assert_eq!(Flat::table([&endless]).numbers("depth_m"), Some(&[None][..]));
}

#[test]
fn parts_and_derived_columns() {
    let place = Place { md_m: 10.0, component: "bit".into() };
    let full = Nested {
        is_torque: false,
        value: 4.0,
        pair_Pa: Some([1.0, 2.0]),
        place: place.clone(),
        other: Some(place),
    };
    let empty = Nested { is_torque: true, pair_Pa: None, other: None, ..full.clone() };
    let table = Row::table([(&full, 2.0), (&empty, 3.0)]);
    let numbers = |name: &str| table.numbers(name).expect("numbers").to_vec();
    assert_eq!(numbers("value_N"), [Some(8.0), None]);
    assert_eq!(numbers("low_Pa"), [Some(1.0), None]);
    assert_eq!(numbers("high_Pa"), [Some(2.0), None]);
    assert_eq!(numbers("md_m"), [Some(10.0); 2]);
    assert_eq!(numbers("factor"), [Some(2.0), Some(3.0)]);
    assert_eq!(table.words("component").expect("words"), ["bit", "bit"]);
    assert_eq!(table.words("other_component").expect("words"), ["bit", ""]);
    assert_eq!(
        serde_json::to_value(&empty).expect("JSON"),
        json!({"is_torque": true, "amount": 4.0, "pair_Pa": null,
            "place": {"md_m": 10.0, "component": "bit"}, "other": null})
    );
    let foreign = Foreign { width_m: 0.2, ends_m: [1.0, 2.0] };
    let table = Row::table([(&foreign, "left")]);
    assert_eq!(table.numbers("width_m"), Some(&[Some(0.2)][..]));
    assert_eq!(table.words("name").expect("words"), ["left"]);
    assert_eq!(table.numbers("end_m"), Some(&[Some(2.0)][..]));
}

#[test]
fn rows_are_read_back() {
    let rows = flat();
    let path = Path::new("flat.parquet");
    assert_eq!(Flat::read(&Flat::table(&rows), path).expect("rows"), rows);
    let json = serde_json::to_value(&rows).expect("JSON");
    assert_eq!(serde_json::from_value::<[Flat; 2]>(json).expect("rows"), rows);
    assert_eq!(Flat::read(&Table::with_columns(FLAT), path).expect("no rows"), []);
    let unknown = with_column(&Flat::table(&rows), Column::numbers("depth_m", vec![None; 2]));
    assert!(Flat::read(&unknown, path).expect("rows")[0].depth_m.is_nan());
}

#[test]
fn defects_name_file_column_and_row() {
    let table = Flat::table(flat());
    let word = Column::words("operation", vec!["drill".into(), "trip".into()]);
    assert_eq!(
        error(&with_column(&table, word)),
        "flat.parquet is not a file of results: its column `operation` is 'trip' in row 2, \
         expected an operation"
    );
    let columns = table.columns().iter().filter(|column| column.name != "depth_m");
    assert_eq!(
        error(&Table::new(columns.cloned().collect())),
        "flat.parquet is not a file of results: it has no column `depth_m`"
    );
    for (name, values, defect) in [
        (
            "count",
            [Some(1.0), Some(1.5)],
            "`count` is 1.5 in row 2, expected a whole number from 0",
        ),
        ("count", [None, None], "`count` is empty in row 1, expected a whole number from 0"),
        ("count", [Some(-1.0), None], "`count` is -1 in row 1, expected a whole number from 0"),
        ("stops", [Some(0.0), Some(2.0)], "`stops` is 2 in row 2, expected 1 or 0"),
        ("name", [None, None], "`name` holds numbers, expected words"),
    ] {
        let error = error(&with_column(&table, Column::numbers(name, values.into())));
        assert!(error.contains(defect), "{error}");
    }
    let words = Column::words("depth_m", vec!["deep".into(); 2]);
    assert!(error(&with_column(&table, words)).contains("`depth_m` holds words, expected numbers"));
}

/// A load has a column as a weight and one as a torque, the weights first, and is read back from
/// the one that has it.
#[test]
fn a_load_is_a_weight_or_a_torque() {
    assert_eq!(
        names(LOADED),
        ["name", "measured_N", "expected_N", "measured_N_m", "expected_N_m", "is_sound"]
    );
    let meanings: Vec<_> =
        LOADED.iter().map(|column| (column.meaning, column.null_where)).collect();
    assert_eq!(meanings[1], ("Measured weight; `null` for torques", Some("it is a torque")));
    assert_eq!(meanings[3], ("Measured torque; `null` for weights", Some("it is a weight")));
    assert_eq!(meanings[4], ("The expected one; `null` for weights", Some("it is a weight")));
    assert_eq!((LOADED[1].unit, LOADED[3].unit), ("N", "N·m"));
    let row =
        |name: &str| Loaded { name: name.into(), measured: 2.0, expected: 3.0, is_sound: true };
    let rows = [row("weight"), row("torque")];
    let table = Loaded::table(&rows);
    assert_eq!(table.numbers("measured_N"), Some(&[Some(2.0), None][..]));
    assert_eq!(table.numbers("expected_N_m"), Some(&[None, Some(3.0)][..]));
    assert_eq!(Loaded::read(&table, Path::new("loaded.parquet")).expect("rows"), rows);

    assert_eq!(names(DERIVED), ["value_N", "twice_N", "value_N_m"]);
    let meanings: Vec<_> =
        DERIVED.iter().map(|column| (column.meaning, column.null_where)).collect();
    let neither = Some("it is a torque, or there is no answer");
    assert_eq!(meanings[0], ("The value; `null` for torques and without an answer", neither));
    assert_eq!(meanings[1], ("Twice the value; `null` as the value", neither));
    let table = Derived::table([Derived { is_torque: false, value: Some(2.0) }]);
    assert_eq!(table.numbers("twice_N"), Some(&[Some(4.0)][..]));
}
