//! Mistakes of spelling and form, in any table.

use wholestring_case::{load, parse};

use crate::{
    common::{EXAMPLE, SURVEY, changed, read, survey_files},
    each_refused, refused,
};

#[test]
fn quantities() {
    each_refused(
        r#"
        unit_misspelt: `1.2 sg` -> `1.2 sgg`
        unit_of_another_dimension: `"1.2 sg"` -> `"1.2 bar"`
        unit_missing_in_quotes: `"1.2 sg"` -> `"1200"`
        quantity_not_in_quotes: `"1.2 sg"` -> `1.2 sg`
        quantity_with_decimal_comma: `"1.2 sg"` -> `"1,2 sg"`
        quantity_without_number: `"1.2 sg"` -> `"heavy"`
        quantity_empty: `"1.2 sg"` -> `""`
        quantity_is_a_list: `"1.2 sg"` -> `[1.2, "sg"]`
        quantity_in_typographic_quotes: `"1.2 sg"` -> `“1.2 sg”`
        quantity_too_large_in_its_own_unit: `"1.2 sg"` -> `"90 ppg"`
        quantity_is_true: `"1.2 sg"` -> `true`
        "#,
    );
}

#[test]
fn keys_and_tables() {
    each_refused(
        r#"
        key_misspelt: `friction_law` -> `friction_lw`
        key_misspelt_in_well: `path = "spline"` -> `curve = "spline"\nsurvay = 1`
        key_misspelt_at_top: `name = "NP13` -> `nmae = "NP13`
        key_of_another_table: `torque = "3.1 kN.m"` -> `torque = "3.1 kN.m"\nwob = "6 tf"`
        key_at_top_of_a_table: `model = "dynamic"` -> `model = "dynamic"\nrpm = 70`
        key_twice: `rpm = 70` -> `rpm = 70\nrpm = 80`
        table_misspelt: `[mud]` -> `[mudd]`
        table_twice: `[mesh]` -> `[mud]\ndensity = 1000\n[mesh]`
        double_mud_brackets: `[mud]` -> `[[mud]]`
        single_hole_brackets: `[[well.hole]]\nkind = "casing"` -> `[well.hole]\nkind = "casing"`
        table_as_value: `[mud]\ndensity = "1.2 sg"` -> `mud = "1.2 sg"`
        "#,
    );
}

#[test]
fn toml() {
    each_refused(
        r#"
        bracket_open: `[mud]` -> `[mud`
        quote_open: `"1.2 sg"` -> `"1.2 sg`
        value_missing: `density = "1.2 sg"` -> `density =`
        "#,
    );
}

/// Windows paths, in the quotes in which a backslash begins an escape.
#[test]
fn windows_paths() {
    let survey = "\"np13-x1042-survey.csv\"";
    for (name, path) in [
        ("path_with_backslashes", r#""C:\Users\me\survey.csv""#),
        ("path_with_valid_escapes", r#""C:\temp\new.csv""#),
        ("path_with_backslash_in_text", r#""wells\survey.csv" # "quoted""#),
    ] {
        refused(name, read(&changed(survey, path)));
    }
    let files = {
        let mut files = survey_files(SURVEY.as_bytes());
        let survey = files.0.values().next().expect("a survey").clone();
        files.0.insert(r"C:\Users\me\survey.csv".to_owned(), survey);
        files
    };
    let text = changed(survey, r"'C:\Users\me\survey.csv'");
    let case = parse("case.toml", text.as_bytes(), &files, &[]);
    assert!(case.is_ok(), "{}", case.unwrap_err());
}

#[test]
fn keys_at_the_top() {
    each_refused(
        r#"
        model_misspelt: `model = "dynamic"` -> `model = "dynamics"`
        units_unknown: `model = "dynamic"` -> `model = "dynamic"\nunits = "imperial"`
        name_not_text: `"NP13-X1042 at total depth"` -> `1042`
        name_empty: `"NP13-X1042 at total depth"` -> `""`
        "#,
    );
    let only_top = &EXAMPLE[..EXAMPLE.find("[well]").expect("[well]")];
    refused("only_a_name", read(only_top));
}

#[test]
fn several_at_once() {
    let text = changed("\"1.2 sg\"", "\"1.2 sgg\"")
        .replace("friction_law", "friction_lw")
        .replace("to = \"4305 m\"", "to = \"4000 m\"")
        .replace("od = \"215.9 mm\"", "od = \"9 in\"");
    refused("several_at_once", read(&text));
}

/// A file that is not a case at all is not reported line by line.
#[test]
fn a_hundred_at_most() {
    let keys: String = (0..20_000).map(|i| format!("key_{i} = {i}\n")).collect();
    let report = read(&keys).expect_err("no case");
    assert_eq!(report.diagnostics.len(), 100);
    assert!(report.render(false).ends_with("and 80 more\n"));
}

#[test]
fn what_is_no_case_file() {
    let files = survey_files(SURVEY.as_bytes());
    let binary = [0x89, b'P', b'N', b'G', b'\r', b'\n', 0x1a, b'\n', 0, 0, 0, 13];
    refused("file_empty", parse("case.toml", b"", &files, &[]));
    refused("file_blank", parse("case.toml", b"\n  \n", &files, &[]));
    refused("file_binary", parse("case.toml", &binary, &files, &[]));
    refused("file_with_zero_bytes", parse("case.toml", b"name = \"a\"\0\0", &files, &[]));
    refused("file_not_toml", parse("case.toml", b"<case>\n  <well/>\n</case>\n", &files, &[]));
    refused("file_missing", load("no-such-case.toml".as_ref(), &[]));
    refused("file_is_a_folder", load("tests".as_ref(), &[]));
}
