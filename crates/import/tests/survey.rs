//! Surveys as planning programs print them and as people write them.

use std::{collections::BTreeMap, fs, path::Path};

use insta::assert_snapshot;
use proptest::prelude::*;
use rust_xlsxwriter::Workbook;
use wholestring_import::{Choices, ImportErrorKind, Imported, Input, import};
use wholestring_units::Dimension;

fn sample(name: &str) -> Vec<u8> {
    fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/samples").join(name)).unwrap()
}

fn imported_as(name: &str, bytes: &[u8], choices: Choices) -> Imported {
    import(vec![Input::of_bytes(name, bytes)], &choices).unwrap_or_else(|error| panic!("{error}"))
}

fn of(text: &str) -> Imported {
    imported_as("survey.txt", text.as_bytes(), Choices::default())
}

fn refused(text: &str, choices: &Choices) -> String {
    let file = vec![Input::of_bytes("survey.txt", text.as_bytes())];
    import(file, choices).map(|import| import.text).unwrap_err().to_string()
}

/// The stations of the case: measured depth in m, angles in degrees.
fn stations(imported: &Imported) -> Vec<[f64; 3]> {
    let lines = imported.text.lines().map(str::trim);
    let lines = lines.filter_map(|line| line.strip_prefix('[')?.strip_suffix("],"));
    // A depth has a unit, or is in metres.
    let number = |text: &str| match text.trim_matches('"') {
        bare if bare == text => bare.parse().unwrap(),
        quantity => Dimension::Length.parse(quantity).unwrap(),
    };
    let numbers = |line: &str| line.split(", ").map(number).collect::<Vec<f64>>();
    lines.map(|line| numbers(line).try_into().unwrap()).collect()
}

#[track_caller]
fn noted(imported: &Imported, kind: &str, part: &str) {
    let found = imported.notes.iter().any(|(_, n)| n.kind() == kind && n.text().contains(part));
    assert!(found, "{kind}: {part}\n{:#?}", imported.notes);
}

#[test]
fn a_report_of_a_planning_program() {
    let bytes = sample("own/survey-wellpath-report.txt");
    let imported = imported_as("survey-wellpath-report.txt", &bytes, Choices::default());
    assert_snapshot!(imported.text);
}

/// Once the missing parts are filled in by hand, the case of a survey is valid.
#[test]
fn the_case_is_sound_once_it_has_a_hole_a_mud_and_a_string() {
    let bytes = sample("own/survey-wellpath-report.txt");
    let imported = imported_as("survey.txt", &bytes, Choices::default());
    let marks = ["[[well.hole]]", "kind", "to ", "casing", "friction", "[mud]", "density"];
    let marks =
        marks.iter().chain(&["[[string]]", "component", "od", "length", "catalogue", "diameter"]);
    let marks: Vec<String> = marks.map(|mark| format!("# {mark}")).collect();
    let lines = imported.text.lines().map(|line| {
        let is_example = marks.iter().any(|mark| line.starts_with(mark.as_str()));
        if is_example { &line[2..] } else { line }
    });
    let text = lines.collect::<Vec<_>>().join("\n").replace("\"1800 m\"", "\"900 m\"");
    let text = text.replace("\"900 m\"\ncasing", "\"400 m\"\ncasing");
    // The assumed operation turns the string.
    let rpm = if text.contains("rpm = ") { "" } else { "\nrpm = 60\n" };
    let text = text + rpm;
    let case = wholestring_case::Template::in_memory("case.toml", &text, BTreeMap::new()).case(&[]);
    if let Err(report) = case {
        panic!("{}\n{text}", report.render(false));
    }
}

/// Two pages of a printed report: repeated headings, and page feet with dates and numbers.
const PAGES: &str = "\
Company:   Made up                              Database:   DEMO
Well:      S-1                                  North Reference:   Grid
Wellbore:  S-1 ST1                              Survey Calculation Method:   Minimum Curvature

Survey
   Measured                          Vertical                      Vertical    Dogleg
    Depth    Inclination  Azimuth     Depth      +N/-S     +E/-W    Section      Rate
     (m)         (°)        (°)        (m)        (m)       (m)      (m)      (°/30m)
       0.00      0.00        0.00        0.00       0.00      0.00      0.00      0.00  Tie on
   1,000.00      0.00        0.00    1,000.00       0.00      0.00      0.00      0.00
   1,030.00      3.00       90.00    1,029.99       0.00      0.79      0.00      3.00  MWD 8 1/2
24 March 2020 10:33:24AM                    Page 2                      COMPASS 5000.14 Build 85

Company:   Made up                              Database:   DEMO
Well:      S-1                                  North Reference:   Grid
Survey
   Measured                          Vertical                      Vertical    Dogleg
    Depth    Inclination  Azimuth     Depth      +N/-S     +E/-W    Section      Rate
     (m)         (°)        (°)        (m)        (m)       (m)      (m)      (°/30m)
   1,060.00      6.00       90.00    1,059.89       0.00      3.14      0.00      3.00
 ! 1,090.00      9.00       90.00    1,089.63       0.00      7.06      0.00      3.00
Page 3 of 3
Projected to bit
";

#[test]
fn pages_with_headings_and_feet() {
    let imported = of(PAGES);
    let depths: Vec<f64> = stations(&imported).iter().map(|station| station[0]).collect();
    assert_eq!(depths, [0.0, 1000.0, 1030.0, 1060.0, 1090.0]);
    assert!(imported.text.contains("name = \"S-1 ST1\""), "{}", imported.text);
    noted(&imported, "checked", "within rounding");
    noted(&imported, "checked", "within rounding");
    noted(&imported, "read", "north reference is 'Grid' (line 2)");
    assert_snapshot!("pages", imported.text);
}

#[test]
fn a_report_of_two_header_lines_with_sides_and_marks() {
    let imported = of("\
Well Seeker style survey listing
Operator: Made up
Well: S-2
   MD       Inc      Azi       TVD       NS         EW       DLS
   ft       deg      deg       ft        ft         ft     deg/100ft
   0.00     0.00     0.00      0.00    0.00 N     0.00 E    0.00
1000.00     0.00     0.00   1000.00    0.00 N     0.00 E    0.00
1100.00*    3.00   225.00   1099.95    1.85 S     1.85 W    3.00
1200.00     6.00   225.00   1199.63    7.40 S     7.40 W    3.00
");
    let foot = 0.3048;
    let depths: Vec<f64> = stations(&imported).iter().map(|station| station[0]).collect();
    let expected = [0.0, 1000.0 * foot, 1100.0 * foot, 1200.0 * foot];
    assert!(depths.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9), "{depths:?}");
    noted(&imported, "checked", "north by 0.00 ft, east by 0.00 ft");
    noted(&imported, "read", "the mark '*' after a number in line 8 is ignored");
    assert!(imported.text.contains("# line 3, well"), "{}", imported.text);
}

/// Feet under `TVD (m)`: the reading is right, the file is wrong, and a note reports it.
#[test]
fn positions_in_another_unit_are_found_out() {
    let imported = of("\
MD (m),Inc (deg),Azi (deg),TVD (m),N (m),E (m),DLS (deg/30m)
0,0,0,0,0,0,0
1000,0,0,3280.8,0,0,0
1030,3,0,3379.2,2.6,0,9.0
");
    noted(&imported, "warning", "that of feet to metres: is a unit wrong?");
    noted(&imported, "warning", "north of the file is 1.81 m more");
    noted(&imported, "warning", "which exceeds rounding");
}

/// Missing rows are found, too.
#[test]
fn positions_of_another_path_are_found_out() {
    let imported = of("\
MD (m),Inc (deg),Azi (deg),TVD (m)
0,0,0,0
1000,0,0,1000
1500,40,0,1499
");
    noted(&imported, "warning", "missing stations?");
}

#[test]
fn mixed_units_and_units_that_are_said() {
    let mixed = "MD (ft);Inc;Azi;TVD (m)\n0;0;0;0\n1.000,0;0;0;304,8\n1.100,0;3,5;90;335,2\n";
    let imported = of(mixed);
    let [md_m, ..] = stations(&imported)[2];
    assert!((md_m - 335.28).abs() < 1e-9);
    noted(&imported, "read", "a comma is read as the decimal sign");
    noted(&imported, "assumed", "no unit for inclination and azimuth: read in degrees");
    noted(&imported, "checked", "true vertical depth by 0.");

    let bare = "MD,Inc,Azi,TVD\n0,0,0,0\n1000,0,0,304.8\n1100,0,0,335.28\n";
    assert_eq!(
        refused(bare, &Choices::default()),
        "survey.txt, line 1, column 1: the measured depth has no unit; give it with --unit md=m, \
         or one of m, ft, mm, in, cm, km, yd, usft"
    );
    let both = Choices::default().unit("md", "ft").unit("tvd", "m");
    // The unit of depths also applies to positions without one, so that theirs is unused.
    let unused = refused(bare, &both);
    assert!(unused.contains("no file uses --unit tvd"), "{unused}");
    let half = "MD (ft),Inc,Azi,TVD\n0,0,0,0\n1000,0,0,304.8\n1100,0,0,335.28\n";
    let error = refused(half, &Choices::default());
    assert!(
        error.contains("the true vertical depth has no unit; give it with --unit tvd=m"),
        "{error}"
    );
    let imported = imported_as("a.csv", half.as_bytes(), Choices::default().unit("tvd", "m"));
    noted(&imported, "checked", "true vertical depth by 0.00 ft");
    let wrong = refused(half, &Choices::default().unit("md", "m"));
    assert!(wrong.contains("in 'ft' in the file and in 'm' as given"), "{wrong}");
    let none = refused("0 0 0\n1000 0 0\n", &Choices::default());
    assert!(none.contains("give it with --unit md=m"), "{none}");
}

const TWO: &str = "\
Plan 2
MD (m),Inc (deg),Azi (deg)
0,0,0
1000,0,0
1500,20,90

As drilled
MD (ft),Inc (deg),Azi (deg),TVD (ft)
0,0,0,0
2000,0.5,90,2000
";

/// Plan and survey in one text: the user must choose one.
#[test]
fn two_surveys_in_a_text() {
    let question = refused(TWO, &Choices::default());
    assert_eq!(
        question,
        "survey.txt: it holds 2 of the kind 'table': 'Plan 2', 'As drilled'; pick one: --pick \
         table=NAME"
    );
    let pick = |name: &str| Choices::default().pick("table", name);
    let plan = imported_as("survey.txt", TWO.as_bytes(), pick("Plan 2"));
    assert_eq!(stations(&plan).len(), 3);
    noted(&plan, "left out", "the survey 'As drilled', because 'Plan 2' was picked");
    let drilled = imported_as("survey.txt", TWO.as_bytes(), pick("As drilled"));
    assert_eq!(stations(&drilled)[1], [609.6, 0.5, 90.0]);
    assert!(drilled.text.contains("lines 9 to 10"), "{}", drilled.text);
    let other = refused(TWO, &pick("Plan 3"));
    assert!(other.contains("there is no table 'Plan 3'"), "{other}");
    // Columns separated by blanks have other positions in the second table.
    let blanks = TWO.replace(',', "    ");
    let drilled = imported_as("survey.txt", blanks.as_bytes(), pick("As drilled"));
    assert_eq!(stations(&drilled)[1], [609.6, 0.5, 90.0]);
    // A case that names such a file cannot pick.
    let error = wholestring_tabular::read(TWO.as_bytes(), "survey.txt").unwrap_err();
    assert!(error.to_string().contains("holds 2 surveys, one below the other"), "{error}");
}

/// A decreasing depth is not a second survey.
#[test]
fn a_depth_that_runs_backwards_is_an_error() {
    let text = "MD (m),Inc,Azi\n0,0,0\n30,1,1\nreamed,,\n20,1,1\n";
    let error = refused(text, &Choices::default());
    assert!(error.contains("line 5, column 1: the measured depth runs backwards"), "{error}");
}

fn workbook(sheets: &[(&str, &[&[&str]])]) -> Vec<u8> {
    let mut workbook = Workbook::new();
    for (name, rows) in sheets {
        let sheet = workbook.add_worksheet();
        sheet.set_name(*name).unwrap();
        for (row, cells) in (0..).zip(*rows) {
            for (column, text) in (0..).zip(*cells) {
                match text.parse::<f64>() {
                    Ok(number) => sheet.write_number(row, column, number).unwrap(),
                    Err(_) => sheet.write_string(row, column, *text).unwrap(),
                };
            }
        }
    }
    workbook.save_to_buffer().unwrap()
}

#[test]
fn sheets_of_a_workbook() {
    let bytes = workbook(&[
        ("Well", &[&["Well", "S-3"], &["Rig", "7"]]),
        (
            "Plan",
            &[
                &["Well", "S-3"],
                &["Measured depth", "Inclination", "Azimuth"],
                &["m", "deg", "deg"],
                &["0", "0", "0"],
                &["100", "1", "2"],
            ],
        ),
        ("Form", &[&["MD (m)", "Inc", "Azi"]]),
        (
            "Actual",
            &[&["MD (ft)", "Inc", "Azi"], &["0", "0", "0"], &["100", "1", "2"], &["x", "1", "2"]],
        ),
    ]);
    let read = |choices: &Choices| import(vec![Input::of_bytes("s.xlsx", &bytes)], choices);
    let error = read(&Choices::default()).unwrap_err();
    let ImportErrorKind::Ambiguous { names, .. } = error.kind() else { panic!("{error}") };
    assert_eq!(names, &["Plan", "Actual"]);
    let plan = read(&Choices::default().pick("table", "Plan")).unwrap();
    assert!(plan.text.contains("rows 4 to 5 of sheet 'Plan'"), "{}", plan.text);
    assert!(plan.text.contains("row 1 of sheet 'Plan', well"), "{}", plan.text);
    let actual = read(&Choices::default().pick("table", "Actual")).unwrap_err();
    assert!(
        actual.to_string().contains("sheet 'Actual', cell A4: 'x' is not a number"),
        "{actual}"
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Any deletion in a report or insertion into it gives a case or an error.
    #[test]
    fn damaged_reports_get_an_answer(at in 0..PAGES.len(), length in 0usize..200, with in "\\PC{0,40}") {
        let mut start = at;
        while !PAGES.is_char_boundary(start) { start -= 1; }
        let mut end = (start + length).min(PAGES.len());
        while !PAGES.is_char_boundary(end) { end += 1; }
        let text = format!("{}{with}{}", &PAGES[..start], &PAGES[end..]);
        let file = vec![Input::of_bytes("a.txt", text.as_bytes())];
        match import(file, &Choices::default()) {
            Ok(imported) => prop_assert!(!imported.text.is_empty()),
            Err(error) => prop_assert!(error.to_string().len() > 10),
        }
    }
}
