//! Surveys to which no hole from the surface leads.

use wholestring_case::{Case, Report, parse};

use crate::{
    common::{EXAMPLE, changed, read, survey_files},
    refused,
};

fn with_survey(survey: &str) -> Result<Case, Report> {
    parse("case.toml", EXAMPLE.as_bytes(), &survey_files(survey.as_bytes()), &[])
}

fn with_stations(stations: &str) -> Result<Case, Report> {
    let survey = "survey = \"np13-x1042-survey.csv\"      # md, inc, azi; unit row or units in the \
                  header; CSV or Excel";
    read(&changed(survey, &format!("stations = {stations}")))
}

/// With any position, because straight on above the first station is not from the wellhead.
#[test]
fn the_first_station_is_inclined_below_the_surface() {
    refused("survey_begins_inclined", with_survey("MD (m),Inc,Azi\n1500,60,30\n4305,60,30\n"));
    refused("stations_begin_inclined", with_stations("[[500, 20, 0], [4305, 20, 0]]"));
    let stated = "MD (m),Inc,Azi,TVD (m),N (m),E (m)\n1500,60,30,1350,300,200\n4305,60,30,,,\n";
    assert!(with_survey(stated).is_err(), "the file's position is not on a straight line");
    let survey = "survey = \"np13-x1042-survey.csv\" ";
    let tied = changed(survey, &format!("tie_in = {{ tvd = \"1350 m\" }}\n{survey}"));
    let files = survey_files(b"MD (m),Inc,Azi\n1500,60,30\n4305,60,30\n");
    assert!(parse("case.toml", tied.as_bytes(), &files, &[]).is_err());
}

#[test]
fn a_straight_hole_above_the_first_station_is_noted() {
    let notes = |case: Result<Case, Report>| {
        let case = case.unwrap_or_else(|report| panic!("{report}"));
        assert!(case.warnings.is_empty(), "{}", case.warnings);
        case.survey_notes.join("\n")
    };
    // A slant hole: cos 30° and sin 30° of 100 m.
    let slant =
        "MD (m),Inc,Azi,TVD (m),N (m),E (m)\n100,30,0,86.6,50,0\n4305,30,0,3728.2,2152.5,0\n";
    let text = notes(with_survey(slant));
    assert!(text.contains("straight, inclined by 30 deg"), "{text}");
    assert!(text.contains("begins at a true vertical depth of 0 m"), "{text}");
    // As most surveys begin.
    let text = notes(with_stations("[[30, 0.5, 0], [4305, 0.5, 0]]"));
    assert!(text.contains("the first station at 30 m is straight, inclined by 0.5 deg"), "{text}");
    let text = notes(with_survey("MD (m),Inc,Azi\n30,0,0\n4305,0,0\n"));
    assert!(!text.contains("straight"), "{text}");
}

#[test]
fn the_hole_comes_out_of_the_ground() {
    refused(
        "stations_out_of_the_ground",
        with_stations("[[0, 0, 0], [600, 0, 0], [1200, 140, 30], [4305, 140, 30]]"),
    );
    refused(
        "survey_out_of_the_ground",
        with_survey("MD (m),Inc,Azi\n0,0,0\n600,0,0\n1200,140,30\n4305,140,30\n"),
    );
    // Upward and yet below the wellhead.
    let toe_up = with_survey("MD (m),Inc,Azi\n0,0,0\n2000,0,0\n3000,95,30\n4305,95,30\n");
    assert!(toe_up.is_ok(), "{}", toe_up.unwrap_err());
}

/// Files may count a turn twice; the case ends at one.
#[test]
fn an_azimuth_of_more_than_a_turn_is_reduced() {
    let case = with_survey("MD (m),Inc,Azi\n0,0,0\n600,0,0\n1200,40,405\n4305,40,400\n");
    let case = case.unwrap_or_else(|report| panic!("{report}"));
    let azimuth = case.model.well.path.stations()[2].azimuth_rad;
    assert!((azimuth - 45_f64.to_radians()).abs() < 1e-12, "{azimuth}");
    let notes = case.survey_notes.join("\n");
    let note = "the azimuth of 2 stations, more than 360 deg, is reduced by 360 deg (the first in \
                line 4)";
    assert!(notes.contains(note), "{notes}");
}
