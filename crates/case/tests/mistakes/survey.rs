//! Mistakes in the file of the survey.

use wholestring_case::parse;

use crate::{
    common::{EXAMPLE, changed, read, survey_files},
    refused, warned,
};

#[test]
fn what_the_file_holds() {
    let cases: [(&str, &[u8]); 11] = [
        ("survey_runs_backwards", b"MD (m),Inc,Azi\n0,0,0\n900,10,45\n600,20,45\n4305,20,45\n"),
        ("survey_inclination", b"MD (m),Inc,Azi\n0,0,0\n900,190,45\n4305,20,45\n"),
        ("survey_not_a_number", b"MD (m),Inc,Azi\n0,0,0\n900,1o,45\n4305,20,45\n"),
        ("survey_nan", b"MD (m),Inc,Azi\n0,0,0\n900,nan,45\n4305,20,45\n"),
        ("survey_lacks_azimuth", b"MD (m),Inc,TVD\n0,0,0\n900,10,45\n"),
        ("survey_lacks_unit", b"Measured Depth,Inclination,Azimuth,TVD\n0,0,0,0\n900,10,45,890\n"),
        ("survey_unit_of_another_dimension", b"MD (kg),Inc,Azi\n0,0,0\n900,10,45\n"),
        ("survey_of_one_station", b"MD (m),Inc,Azi\n0,0,0\n"),
        ("survey_empty", b""),
        ("survey_not_text", b"\x89PNG\r\n\x1a\n\0\0\0\x0d"),
        ("survey_workbook_corrupt", b"PK\x03\x04 this was a workbook once"),
    ];
    for (name, survey) in cases {
        refused(name, parse("case.toml", EXAMPLE.as_bytes(), &survey_files(survey), &[]));
    }
    refused("survey_missing", read(&changed("np13-x1042-survey.csv", "np13-survey.csv")));
    refused("survey_bend", {
        let survey = b"MD (m),Inc,Azi\n0,0,0\n900,0,45\n901,30,45\n4305,30,45\n";
        parse("case.toml", EXAMPLE.as_bytes(), &survey_files(survey), &[])
    });
    refused(
        "survey_missing_in_case",
        read(&changed("survey = \"np13-x1042-survey.csv\"", "# no survey")),
    );
}

/// The file of the survey is underlined: where the hole turns by 180 deg, at a slip, at a position
/// that differs.
#[test]
fn rows_of_the_file_are_underlined() {
    let example =
        |survey: &[u8]| parse("case.toml", EXAMPLE.as_bytes(), &survey_files(survey), &[]);
    refused("survey_turns_back", example(b"MD (m),Inc,Azi\n0,0,0\n100,180,0\n4305,180,0\n"));
    warned(
        "warn_survey_slip",
        example(b"MD (m),Inc,Azi\n0,0,45\n1200,40,45\n1230,4.1,45\n1260,41,45\n4305,41,45\n"),
    );
    warned(
        "warn_survey_positions",
        example(
            b"MD (m),Inc,Azi,TVD (m)\n0,0,45,0\n600,0,45,600\n1200,60,45,1096.2\n1800,60,45,1396.2\n4305,60,45,2750\n",
        ),
    );
    let field = format!("units = \"field\"\n{EXAMPLE}");
    let survey = b"MD (m),Inc,Azi\n0,0,45\n1200,0,45\n1230,31,45\n4305,31,45\n";
    warned("warn_sharp_turn", parse("case.toml", field.as_bytes(), &survey_files(survey), &[]));
}

/// The positions of the curve that a case runs on are compared: for a plan of few stations those of
/// the spline differ.
#[test]
fn positions_are_compared_on_the_curve_of_the_case() {
    let plan =
        b"MD (m),Inc,Azi,TVD (m)\n0,0,30,0\n600,0,30,600\n1200,90,30,981.97\n4305,90,30,981.97\n";
    let read = |text: &str| parse("case.toml", text.as_bytes(), &survey_files(plan), &[]);
    let arcs = read(&EXAMPLE.replace("path = \"spline\"", "path = \"minimum-curvature\""));
    let arcs = arcs.unwrap_or_else(|report| panic!("{report}"));
    assert!(arcs.survey_notes.iter().any(|note| note.contains("within rounding")));
    assert!(!arcs.warnings.to_string().contains("than computed"), "{}", arcs.warnings);
    let spline = read(EXAMPLE).unwrap_or_else(|report| panic!("{report}")).warnings.to_string();
    assert!(
        spline.contains("12.") && spline.contains("by minimum curvature they agree"),
        "{spline}"
    );
}
