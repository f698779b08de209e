//! Tables read unchanged.

use insta::assert_snapshot;
use wholestring_import::{Choices, Input, contents, import};

use crate::{PLAIN, components, imported, of_bytes, string};

#[test]
fn the_sample_tally_becomes_a_string() {
    let bytes = include_bytes!("../samples/own/tally.csv");
    let imported = of_bytes("tally.csv", bytes, &Choices::default());
    assert_snapshot!("sample", imported.text);
    assert_eq!(components(&imported).len(), 7);
    let contents = contents(Input::of_bytes("tally.csv", bytes)).unwrap();
    assert_snapshot!(
        "sample_contents",
        format!("{}\n{}", contents.what, contents.lines.join("\n"))
    );
}

#[test]
fn a_matrix_without_headings_is_refused_with_the_headings_that_it_needs() {
    let bytes = include_bytes!("../samples/excel/madsim-BHA_Data_ExampleAssembly.xlsx");
    let error = import(vec![Input::of_bytes("BHA.xlsx", bytes)], &Choices::default());
    assert_snapshot!(error.unwrap_err(), @"BHA.xlsx: no row names the columns; write headings above the numbers, such as 'MD (m), Inc (deg), Azi (deg)' for a survey or 'Component, OD (in), ID (in), Length (ft), Weight (lb/ft)' for a tally");
}

#[test]
fn a_plain_table_is_a_string_that_the_case_accepts() {
    let imported = imported(PLAIN);
    assert_snapshot!(string(&imported), @r#"
    [[string]]
    component = "PDC bit"
    od = "8.5 in"
    id = "2.25 in"
    length = "0.85 ft"

    [[string]]
    component = "Collar"
    od = "6.5 in"
    id = "2.25 in"
    length = "30 ft"
    mass_per_length = "99.5 lb/ft"

    [[string]]
    component = "DP"
    od = "5 in"
    id = "4.276 in"
    length = "to surface"
    mass_per_length = "21 lb/ft"
    "#);
    let components = components(&imported);
    assert_eq!(components.len(), 3);
    assert!(components[0].is_bit());
    assert!((components[1].od_m - 6.5 * 0.0254).abs() < 1e-12);
    assert!((components[1].mass_per_length_kg_per_m - 148.07).abs() < 0.01);
}
