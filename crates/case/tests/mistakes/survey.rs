//! Mistakes in the file of the survey.

use wholestring_case::parse;

use crate::{
    common::{EXAMPLE, changed, read, survey_files},
    refused,
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
