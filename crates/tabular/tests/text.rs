//! Surveys as text, in typical layouts.

use wholestring_tabular::{Column, ImportedSurvey, Said, TableErrorKind, read, read_as, read_csv};
use wholestring_units::Dimension;

#[track_caller]
fn survey(text: &str) -> ImportedSurvey {
    read_csv(text.as_bytes(), "a.csv").unwrap_or_else(|error| panic!("{error}"))
}

/// Measured depths in m, inclinations and azimuths in degrees.
#[track_caller]
fn assert_stations(survey: &ImportedSurvey, expected: &[[f64; 3]]) {
    assert_eq!(survey.stations.len(), expected.len(), "{:?}", survey.notes);
    for (station, &[md_m, inclination, azimuth]) in survey.stations.iter().zip(expected) {
        // One multiplication by a factor, one here: a few units in the last place.
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-14 * b.abs().max(1.0);
        assert!(near(station.md_m, md_m), "{station:?}, {md_m}");
        assert!(near(station.inclination_rad, inclination.to_radians()), "{station:?}");
        assert!(near(station.azimuth_rad, azimuth.to_radians()), "{station:?}");
    }
}

#[track_caller]
fn noted(survey: &ImportedSurvey, part: &str) {
    assert!(survey.notes.iter().any(|note| note.contains(part)), "{:#?}", survey.notes);
}

#[test]
fn feet_with_a_row_of_units_and_azimuths_through_north() {
    let survey = survey(
        "MD,INCL,Azimuth\nft,deg,deg\n0,0,0\n1000,0,359.5\n1100,3,0.5\n1200,6,-10\n1300,8,365\n",
    );
    let foot = 0.3048;
    assert_stations(
        &survey,
        &[
            [0.0, 0.0, 0.0],
            [1000.0 * foot, 0.0, 359.5],
            [1100.0 * foot, 3.0, 0.5],
            [1200.0 * foot, 6.0, -10.0],
            [1300.0 * foot, 8.0, 5.0],
        ],
    );
    assert_eq!(survey.tie_in, None);
    noted(&survey, "measured depth from 'MD' in ft");
    assert!(!survey.notes.iter().any(|note| note.contains("no unit")));
}

#[test]
fn columns_in_any_order_with_others_between() {
    let survey = survey(
        "Comment,Azimuth Grid ( deg ),TVD ( ft ),Measured Depth ( ft ),DLS ( deg/100 ft ),Inclination ( deg )\n\
         tie,10,0,0,0,0\n,20,100,100,1,1\nlast,30,199.9,200,1,2\n",
    );
    let foot = 0.3048;
    assert_stations(
        &survey,
        &[[0.0, 0.0, 10.0], [100.0 * foot, 1.0, 20.0], [200.0 * foot, 2.0, 30.0]],
    );
}

#[test]
fn semicolons_with_decimal_commas() {
    let survey = survey("MD (m);Inc (°);Azi (°)\n0,0;0,0;0\n30,5;1,25;90,125\n1.060,5;1,25;90\n");
    assert_stations(&survey, &[[0.0, 0.0, 0.0], [30.5, 1.25, 90.125], [1060.5, 1.25, 90.0]]);
    noted(&survey, "comma is read as the decimal sign");
    noted(&survey, "columns separated by semicolons");
}

#[test]
fn tabs_titles_comments_quotes_and_empty_rows() {
    let survey = survey(
        "Well S-1, survey \"as drilled\"\r\n# made by hand\r\n\r\n\"MD\n(m)\"\tInc[deg]\tAzi[deg]\r\n\
         0\t0\t0\r\n\r\n\"1,030.5\"\t0.5\t45\r\n\t\t\r\nEnd of survey\t\t\r\n\r\n",
    );
    assert_stations(&survey, &[[0.0, 0.0, 0.0], [1030.5, 0.5, 45.0]]);
    noted(&survey, "line 10 is skipped: 'End of survey'");
}

/// The user's unit for a file that does not give one.
fn said(unit: &str) -> Said {
    Said { length_unit: Dimension::Length.find_unit(unit), ..Said::default() }
}

/// Metres for feet would go unnoticed: a well a third as deep is plausible too.
#[test]
fn lengths_without_a_unit_are_refused_until_it_is_said() {
    let foot = 0.3048;
    let in_feet = [[0.0, 0.0, 0.0], [30.0 * foot, 1.5, 45.0]];
    for text in [
        "0,0,0\n30,1.5,45\n",
        "0 0 0\n30 1.5 45\n",
        "0;0;0\n30;1,5;45\n",
        "# x\n0\t0\t0\n30\t1.5\t45",
    ] {
        let error = read_csv(text.as_bytes(), "a.csv").unwrap_err();
        assert_eq!(error.kind(), &TableErrorKind::NoUnits, "{text}");
        let headless = read_as(text.as_bytes(), "a.csv", &said("ft")).unwrap();
        assert_stations(&headless, &in_feet);
        noted(&headless, "no header");
        noted(&headless, "three columns read as measured depth in ft as given");
    }
    let text = b"md,inc,azi\n0,0,0\n30,1.5,45\n";
    let error = read_csv(text, "a.csv").unwrap_err();
    assert!(matches!(error.kind(), TableErrorKind::MissingUnit { .. }), "{error}");
    let bare = read_as(text, "a.csv", &said("ft")).unwrap();
    assert_stations(&bare, &in_feet);
    noted(&bare, "no unit for measured depth: read in ft as given");
    noted(&bare, "no unit for inclination and azimuth: read in degrees");
}

#[test]
fn what_is_said_must_be_what_the_file_tells() {
    let text = b"MD (m),Inc,Azi\n0,0,0\n30,1.5,45\n";
    assert!(read_as(text, "a.csv", &said("m")).is_ok());
    let error = read_as(text, "a.csv", &said("ft")).unwrap_err();
    assert_eq!(
        error.to_string(),
        "a.csv, line 1, column 1: the measured depth is in 'm' in the file and in 'ft' as given; \
         keep one of them"
    );
}

#[test]
fn angles_without_a_unit_are_degrees_and_say_so() {
    let expected = [[0.0, 0.0, 0.0], [30.0, 1.5, 45.0]];
    let degrees = survey("MD (m),Inc,Azi\n0,0,0\n30,1.5,45\n");
    assert_stations(&degrees, &expected);
    noted(&degrees, "no unit for inclination and azimuth: read in degrees");
    let radians = survey("md_m,inc_rad,azi_rad\n0,0,0\n30,0.5,1\n");
    assert_eq!(radians.stations[1].inclination_rad, 0.5);
}

#[test]
fn encodings_of_the_degree_sign() {
    let text = "MD (m),Inc (°),Azi (°)\n0,0,0\n30,1.5,45\n";
    let latin1: Vec<u8> = text.chars().map(|c| c as u8).collect();
    let marked = [b"\xef\xbb\xbf", text.as_bytes()].concat();
    let utf16: Vec<u8> = [0xfffeu16.swap_bytes()]
        .into_iter()
        .chain(text.encode_utf16())
        .flat_map(u16::to_le_bytes)
        .collect();
    for bytes in [text.as_bytes().to_vec(), latin1, marked, utf16] {
        let survey = read(&bytes, "a.csv").unwrap_or_else(|error| panic!("{error}"));
        assert_stations(&survey, &[[0.0, 0.0, 0.0], [30.0, 1.5, 45.0]]);
    }
}

#[test]
fn the_first_row_ties_the_survey_in() {
    let tied = survey(
        "MD (m),Inc (deg),Azi (deg),TVD (m),N/S (ft),E/W (ft)\n\
         500,10,45,495,100,-200\n530,10,45,524.5,110,-190\n",
    );
    let tie_in = tied.tie_in.unwrap();
    assert_eq!((tie_in.tvd_m, tie_in.north_m, tie_in.east_m), (495.0, 30.48, -60.96));

    let depth_only = survey("MD (m),Inc (deg),Azi (deg),TVD (m)\n500,10,45,495\n530,10,45,524\n");
    let tie_in = depth_only.tie_in.unwrap();
    assert_eq!((tie_in.tvd_m, tie_in.north_m, tie_in.east_m), (495.0, 0.0, 0.0));
    noted(&depth_only, "the first station has no north: taken as 0");

    let no_depth = survey("MD (m),Inc (deg),Azi (deg),N (m),E (m)\n500,10,45,1,2\n530,10,45,3,4\n");
    assert_eq!(no_depth.tie_in, None);
    assert_eq!(no_depth.start().tvd_m, 500.0);
    noted(&no_depth, "the first station is at 500 m");
    noted(&no_depth, "north and east are not used");
    let surface = survey("MD (m),Inc (deg),Azi (deg),N (m),E (m)\n0,10,45,1,2\n530,10,45,3,4\n");
    assert_eq!(surface.tie_in.unwrap().north_m, 1.0);
}

#[test]
fn north_without_east_numbers_the_rows() {
    let survey = survey("N,MD (m),Inc,Azi\n1,0,0,0\n2,30,1,1\n");
    assert_eq!(survey.tie_in, None);
    noted(&survey, "the column 'N' is not used");
}

#[test]
fn the_ends_of_the_ranges_are_in_them() {
    let ends = survey("MD (m),Inc,Azi\n0,0,-360\n100000,180,720\n");
    // The case's range ends at a turn.
    assert_stations(&ends, &[[0.0, 0.0, -360.0], [100_000.0, 180.0, 360.0]]);
    noted(&ends, "the azimuth of 1 station, more than 360 deg, is reduced by 360 deg");
}

/// A null value is no depth, and the path does not begin at it.
#[test]
fn positions_that_stand_for_no_value_are_left_out() {
    let found = survey("MD (m),Inc,Azi,TVD (m)\n0,0,0,-999.25\n500,0,0,500\n600,3,0,-999.25\n");
    assert_eq!(found.tie_in, None);
    let tvd_m: Vec<Option<f64>> = found.stated.iter().map(|stated| stated.tvd_m).collect();
    assert_eq!(tvd_m, [None, Some(500.0), None]);
    noted(&found, "positions of 2 stations that stand for no value, such as -999.25");
}

#[test]
fn bare_headers_may_have_a_bare_position() {
    let text = b"md,inc,azi,tvd,north,east\n10,0,0,9,1,2\n30,1,1,29,1,2\n";
    let survey = read_as(text, "a.csv", &said("m")).unwrap();
    let tie_in = survey.tie_in.unwrap();
    assert_eq!((tie_in.tvd_m, tie_in.north_m, tie_in.east_m), (9.0, 1.0, 2.0));
}

#[test]
fn the_better_of_two_azimuths_is_taken() {
    let survey = survey("MD (m),Inc,Azimuth (magnetic),Azimuth (grid)\n0,0,10,12\n30,1,20,22\n");
    assert_stations(&survey, &[[0.0, 0.0, 12.0], [30.0, 1.0, 22.0]]);
    noted(&survey, "the column 'Azimuth (magnetic)' is not used");
}

const REPORT: &str = "\
Company:   Made up                    Database:   DEMO
Well:      S-1                        MD Reference:   RKB @ 82.0ft (Rig 7)

Survey
   Measured                          Vertical                      Vertical    Dogleg
    Depth    Inclination  Azimuth     Depth      +N/-S     +E/-W    Section      Rate
     (ft)        (°)        (°)        (ft)       (ft)      (ft)     (ft)     (°/100ft)
       0.0      0.00        0.00        0.0        0.0       0.0       0.0      0.00
   1,500.0      0.00        0.00    1,500.0        0.0       0.0       0.0      0.00
   1,600.0      3.00      359.50    1,599.9        2.6       0.0       2.6      3.00
 ! 1,700.0      6.00        0.50    1,699.6       10.5       0.1      10.5      3.00
";

#[test]
fn a_text_report_with_stacked_headings() {
    let survey = survey(REPORT);
    let foot = 0.3048;
    assert_stations(
        &survey,
        &[
            [0.0, 0.0, 0.0],
            [1500.0 * foot, 0.0, 0.0],
            [1600.0 * foot, 3.0, 359.5],
            [1700.0 * foot, 6.0, 0.5],
        ],
    );
    noted(&survey, "the mark '!' in line 11 is ignored");
    assert_eq!(survey.tie_in.map(|tie_in| tie_in.tvd_m), Some(0.0));
}

#[test]
fn single_blanks_between_words_and_columns() {
    let expected = [[0.0, 0.0, 0.0], [30.0, 1.5, 45.0]];
    for text in [
        "MD (m) Inc (deg) Azi (deg)\n0 0 0\n30 1.5 45\n",
        "Measured Depth (m) Inclination (deg) Azimuth (deg)\n0 0 0\n30 1.5 45\n",
        "MD   Inc   Azi\nm    deg   deg\n0    0     0\n30   1.5   45\n",
        "# md_m inc_deg azi_deg\n0 0 0\n30 1.5 45\n",
        "MD(m)\t Inc(deg)\t Azi(deg)\n0\t 0\t 0\n30\t 1.5\t 45\n",
    ] {
        assert_stations(&survey(text), &expected);
    }
}

#[test]
fn a_table_continued_on_another_page() {
    let survey = survey(
        "MD (m),Inc (deg),Azi (deg)\n0,0,0\n30,1.5,45\n\u{c}\nMD (m),Inc (deg),Azi (deg)\n60,3,45\n",
    );
    assert_stations(&survey, &[[0.0, 0.0, 0.0], [30.0, 1.5, 45.0], [60.0, 3.0, 45.0]]);
}

/// Checks the sentence and the underlined text.
#[track_caller]
fn refused(text: &str, underlined: &str, message: &str) -> TableErrorKind {
    let error = read_csv(text.as_bytes(), "a.csv").unwrap_err();
    let span = error.span().unwrap_or(0..0);
    assert_eq!(error.text().map(|text| &text[span]), Some(underlined), "{error}");
    assert_eq!(error.to_string(), message);
    error.kind().clone()
}

#[test]
fn faults_in_the_header_are_underlined() {
    let kind = refused(
        "MD (m),Inclnation (deg),Azi (deg)\n0,0,0\n30,1,1\n",
        "MD (m),Inclnation (deg),Azi (deg)",
        "a.csv, line 1, column 1: no column of inclination (is it 'Inclnation (deg)'?); \
         the header has: 'MD (m)', 'Inclnation (deg)', 'Azi (deg)'",
    );
    assert!(matches!(kind, TableErrorKind::MissingColumn { column: Column::Inclination, .. }));
    refused(
        "Title\nMD;Inc;Azi\n0;0;0\n30;1;1\n",
        "MD",
        "a.csv, line 2, column 1: the measured depth under 'MD' has no unit; write it in the \
         header, such as 'MD (m)', or in a row below it, or give it: `survey_unit = \"m\"` under \
         [well], `--unit m` for `wholestring survey`",
    );
    refused(
        "MD (bar),Inc,Azi\n0,0,0\n30,1,1\n",
        "MD (bar)",
        "a.csv, line 1, column 1: 'bar' is a unit of pressure, not a unit of length; \
         expected m, ft, mm, in, cm, km, yd, usft",
    );
    refused(
        "MD,Inc,Azi\nfurlong,deg,deg\n0,0,0\n30,1,1\n",
        "furlong",
        "a.csv, line 2, column 1: 'furlong' is not a unit of length; \
         expected m, ft, mm, in, cm, km, yd, usft",
    );
    refused(
        "MD (m),Inc,Azi\nft,deg,deg\n0,0,0\n30,1,1\n",
        "ft",
        "a.csv, line 2, column 1: the measured depth is in 'm' by its header \
         and in 'ft' by the row of units",
    );
    refused(
        "MD (m),MD (ft),Inc,Azi\n0,0,0,0\n30,100,1,1\n",
        "MD (m),MD (ft),Inc,Azi",
        "a.csv, line 1, column 1: two columns read as measured depth: 'MD (m)' and 'MD (ft)'; \
         keep one of them",
    );
    refused(
        "MD (m),Inc,Azi,TVD\n0,0,0,0\n30,1,1,30\n",
        "TVD",
        "a.csv, line 1, column 16: the true vertical depth under 'TVD' has no unit; write it in \
         the header, such as 'TVD (m)', or in a row below it, or give it: `survey_unit = \"m\"` \
         under [well], `--unit m` for `wholestring survey`",
    );
}

#[test]
fn faults_in_the_rows_are_underlined() {
    let after = |rows: &str| format!("MD (m),Inc (°),Azi (°)\n0,0,0\n{rows}\n");
    for (rows, underlined, message) in [
        (
            "30,x y,1",
            "x y",
            "line 3, column 4: 'x y' is not a number; the inclination was expected",
        ),
        ("30,1", "", "line 3, column 5: the azimuth is missing in this row"),
        ("30,,1", "", "line 3, column 4: the inclination is missing in this row"),
        (
            "30,1,NaN",
            "NaN",
            "line 3, column 6: 'NaN' is not a finite number; the azimuth was expected",
        ),
        (
            "1e999,1,1",
            "1e999",
            "line 3, column 1: '1e999' is not a finite number; the measured depth was expected",
        ),
        (
            "30,1,1\n20,1,1",
            "20",
            "line 4, column 1: the measured depth runs backwards: 20 m after 30 m; it must \
             increase from station to station",
        ),
        (
            "30,1,1\n30.0,1,2",
            "30.0",
            "line 4, column 1: the measured depth repeats: 30 m after 30 m; it must increase from \
             station to station",
        ),
        (
            "30,-1,1",
            "-1",
            "line 3, column 4: the inclination -1 deg is out of range; expected 0 to 180 deg",
        ),
        (
            "30,181,1",
            "181",
            "line 3, column 4: the inclination 181 deg is out of range; expected 0 to 180 deg",
        ),
        (
            "30,1,721",
            "721",
            "line 3, column 6: the azimuth 721 deg is out of range; expected -360 to 720 deg",
        ),
        (
            "30,1,-999.25",
            "-999.25",
            "line 3, column 6: the azimuth -999.25 deg is out of range; expected -360 to 720 deg",
        ),
        (
            "1e308,1,1",
            "1e308",
            "line 3, column 1: the measured depth 1e308 m is out of range; expected 0 to 100 km",
        ),
        (
            "",
            "0",
            "line 2, column 1: there is only one station; a survey needs at least two stations",
        ),
    ] {
        refused(&after(rows), underlined, &format!("a.csv, {message}"));
    }
    refused(
        "MD (m);Inc;Azi\n1,500;10;5\n2,500;10;5\n",
        "1,500",
        "a.csv, line 2, column 1: '1,500' may mean thousands or decimals; \
         write the numbers with a decimal point and without separators",
    );
    refused(
        "MD (m)  Inc  Azi\n0  0  0\n30  1\n",
        "30",
        "a.csv, line 3, column 1: 2 values in this row, 3 in the first",
    );
    refused(
        "MD (m),Inc,Azi\n",
        "MD (m)",
        "a.csv, line 1, column 1: no station follows the header; \
         a survey needs at least two stations",
    );
}

#[test]
fn a_span_counts_in_the_decoded_text() {
    let text = "MD (m),Inc (°),Azi (°)\r\n0,0,0\r\n30,zwölf,1\r\n";
    let latin1: Vec<u8> = text.chars().map(|c| c as u8).collect();
    let error = read_csv(&latin1, "a.csv").unwrap_err();
    assert_eq!(error.text(), Some(text));
    assert_eq!(&text[error.span().unwrap()], "zwölf");
}

#[test]
fn files_that_are_no_survey_get_a_sentence() {
    let message = |bytes: &[u8], name: &str| read(bytes, name).unwrap_err().to_string();
    for empty in [&b""[..], b" \n\t\n", b"\xef\xbb\xbf"] {
        assert!(message(empty, "a.csv").starts_with("a.csv: the file is empty; "));
    }
    assert!(message(b"\x00\x01\x02", "a.csv").starts_with("a.csv: the file is not text; "));
    assert!(message(b"\xff\xfe\x00", "a.csv").starts_with("a.csv: the file is not text; "));
    assert!(
        message(b"1,2,3,4\n5,6,7,8\n", "a.csv").starts_with("a.csv: no header names the columns")
    );
    assert!(
        message(b"Dear Sir, hello\n", "a.txt").starts_with("a.txt: no header names the columns")
    );
    assert!(
        message(b"a,b,c\n1,2,3\n4,5,6\n", "a.csv")
            .starts_with("a.csv: no header names the columns")
    );
    for (bytes, what) in [
        (&b"%PDF-1.7 and more"[..], "a PDF document"),
        (b"<html><table><tr><td>MD", "a web page (HTML)"),
        (b"\xef\xbb\xbf<!DOCTYPE HTML>", "a web page (HTML)"),
    ] {
        assert!(
            message(bytes, "a.xls").starts_with(&format!("a.xls: the file is {what}; a table"))
        );
    }
    // Text with the extension of a workbook is common.
    assert!(read(b"md_m\tinc\tazi\n0\t0\t0\n9\t0\t0\n", "a.xlsx").is_ok());
    assert!(read(b"md_m\tinc\tazi\n0\t0\t0\n9\t0\t0\n", "a.xls").is_ok());
}

#[test]
fn depths_from_the_kelly_bushing_are_in_feet() {
    let foot = 0.3048;
    let expected = [[0.0, 0.0, 0.0], [100.0 * foot, 1.0, 45.0]];
    for text in [
        "MD (ftKB),Inc,Azi\n0,0,0\n100,1,45\n",
        "MD ftKB,Inc,Azi\n0,0,0\n100,1,45\n",
        "MD,Inc,Azi\nftRKB,deg,deg\n0,0,0\n100,1,45\n",
        "Depth [ft MD],Inc,Azi,TVD (ftTVDKB)\n0,0,0,0\n100,1,45,100\n",
    ] {
        assert_stations(&survey(text), &expected);
    }
}

/// A text of separators or line ends only makes a table a hundred times as large as itself.
#[test]
fn texts_with_more_cells_than_any_survey_are_refused() {
    for (text, message) in [
        (",".repeat(1_000_000), "1000001 cells; at most 1000000"),
        ("x\r\n".repeat(200_000), "200001 lines; at most 200000"),
        (" 1".repeat(1_000_000), "1000001 cells; at most 1000000"),
    ] {
        let error = read_csv(text.as_bytes(), "a.csv").unwrap_err();
        assert_eq!(error.to_string(), format!("a.csv: the file holds {message} can be read"));
    }
}

/// A vertical station has no azimuth: 0 is assumed, with a note. With 0 typed in, minimum curvature
/// gives a true vertical depth of 799.86 m at 800 m.
#[test]
fn a_vertical_station_may_lack_its_azimuth() {
    for blank in ["", "-", "N/A", "-999.25"] {
        let found = survey(&format!("MD (m),Inc,Azi\n0,0,{blank}\n500,0,{blank}\n800,3,10\n"));
        assert_eq!(found.stations.len(), 3);
        assert_eq!(found.stations[1].azimuth_rad, 0.0);
        let note = "the azimuth of 2 stations, vertical and without one, is taken as 0 (the first in line 2)";
        assert!(found.notes.iter().any(|found| found == note), "{:?}", found.notes);
    }
    let error = read(b"MD (m),Inc,Azi\n0,0.5,\n500,1,10\n", "a.csv").unwrap_err();
    assert!(error.to_string().contains("the azimuth is missing in this row"), "{error}");
}

#[test]
fn a_station_that_stands_there_twice_counts_once() {
    let found =
        survey("MD (m),Inc,Azi,TVD (m)\n0,0,0,0\n500,1,10,499.9\n500,1,10,499.9\n900,8,12,899\n");
    assert_eq!((found.stations.len(), found.stated.len()), (3, 3));
    assert_eq!(found.stated[2].tvd_m, Some(899.0));
    let note = "1 station of the same depth as another and identical is left out (line 4)";
    assert!(found.notes.iter().any(|found| found == note), "{:?}", found.notes);
    assert_eq!(found.places.row_name(2), "line 5");
}

#[test]
fn the_deepest_station_may_be_first() {
    let found = survey("MD (m),Inc,Azi\n2300,61.9,340\n1900,52.1,344.2\n1530,38.25,351.7\n0,0,0\n");
    let depths: Vec<f64> = found.stations.iter().map(|station| station.md_m).collect();
    assert_eq!(depths, [0.0, 1530.0, 1900.0, 2300.0]);
    assert_eq!(found.places.row_name(0), "line 5");
    assert_eq!(found.place, "lines 2 to 5");
    assert!(found.notes.iter().any(|note| note.contains("reversed")), "{:?}", found.notes);
}

/// Map coordinates are recognised in a note.
#[test]
fn coordinates_of_a_map_are_named() {
    let found = survey(
        "MD (m),Inc,Azi,North (m),East (m)\n0,0,0,6812340.5,471250.25\n90,1,0,6812341,471250\n",
    );
    assert!(found.start().is_on_map());
    assert!(
        found.notes.iter().any(|note| note.contains("coordinates of a map")),
        "{:?}",
        found.notes
    );
    let local = survey("MD (m),Inc,Azi,North (m),East (m)\n0,0,0,12.5,-3\n90,1,0,13,-3\n");
    assert!(!local.start().is_on_map());
}

/// Positions of minimum curvature are compared with the stations; an error of one station is
/// reported with its row.
#[test]
fn positions_and_slips_are_found() {
    use wholestring::well::{Interpolation, Path, USUAL_DOGLEG_RAD_PER_M};
    use wholestring_tabular::{position_checks, station_doubts};
    use wholestring_units::UnitSet;
    // The quarter of a circle of 1200/π m: it ends 381.97 m below its beginning.
    let found = survey(
        "MD (m),Inc,Azi,TVD (m)\n0,0,30,0\n600,0,30,600\n1200,90,30,981.97\n3000,90,30,981.97\n",
    );
    let checks = |interpolation| {
        let path = Path::new(&found.stations, interpolation, found.start()).expect("a path");
        position_checks(&found.stations, &found.stated, &path, UnitSet::Si)
    };
    assert!(checks(Interpolation::MinimumCurvature).iter().all(|check| check.agrees));
    let spline = checks(Interpolation::Spline);
    assert!(!spline[0].agrees && spline[0].sentence.contains("12.39 m"), "{spline:?}");
    let found = survey("MD (ft),Inc,Azi\n3937,40,44\n4035.4,4.1,44\n4133.9,41,44\n9000,41,44\n");
    let doubts = station_doubts(&found.stations, USUAL_DOGLEG_RAD_PER_M, found.unit_set());
    assert_eq!(doubts.len(), 1);
    let sentence = &doubts[0].sentence;
    assert!(sentence.contains("deg/100ft") && sentence.contains("4035.4 ft"), "{sentence}");
    assert!(doubts[0].help.ends_with("is 4.1 a typing error for 41?"), "{}", doubts[0].help);
    assert_eq!(found.places.row_name(doubts[0].index), "line 3");
}

/// Thousands of a comma that also separates the columns would move all values by a column.
#[test]
fn rows_with_more_cells_than_the_header_are_refused() {
    let refusal = |text: &str| read_csv(text.as_bytes(), "a.csv").expect_err(text).to_string();
    let split = "MD (ft),Inc,Azi\n0,0,0\n1,000,0,0\n2,000,10,45\n3,000,20,45\n4,000,30,45\n";
    let error = refusal(split);
    assert!(
        error.starts_with(
            "a.csv, line 3, column 1: 4 cells in this row, but the header has 3 columns: '1' and \
             '000' look like one number with thousands; numbers with a separator of thousands need \
             quotation marks, or another separator"
        ),
        "{error}"
    );
    // A trailing separator of the header does not make room for the rest of a number, nor do
    // blanks.
    for text in [
        split.replace("Azi\n", "Azi,\n"),
        split.replace("Azi\n", "Azi,Remark\n").replace("1,000,0,0", "1,000,0,0,KOP"),
        "MD (ft)  Inc  Azi\n0  0  0\n1 000  0  0\n2 000  10  45\n".to_owned(),
    ] {
        assert!(refusal(&text).contains("'1' and '000' look like"), "{text}");
    }
    let error = refusal("MD (ft),Inc,Azi\n0,0,0\n1000,0,0,9\n2000,10,45\n");
    assert!(
        error.starts_with(
            "a.csv, line 3, column 10: 4 cells in this row, but the header has 3 columns; '9' is \
             under none of them"
        ),
        "{error}"
    );
    for text in [
        "MD (ft),Inc,Azi\n0,0,0,,\n1000,0,0,\n2000,10,45\n",
        "MD (ft),Inc,Azi\n0,0,0\n1000,1,125,KOP, soft\n2000,10,45\n",
        "MD (ft),Inc,Azi,\n0,0,0,\n1000,1,125,KOP\n2000,10,45,\n",
        "MD (ft)  Inc  Azi\n0  0  0\n1000  1  125  KOP\n2000  10  45\n",
        "MD (ft);Inc;Azi\n0;0;0\n1,000.0;0;0\n2,000;10;45\n",
        "MD (ft),Inc,Azi\n0,0,0\n\"1,000.0\",1,125\n\"2,000\",10,45\n",
    ] {
        assert_eq!(survey(text).stations[2].md_m, 609.6, "{text}");
    }
}
