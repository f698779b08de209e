//! Times of rows.

use wholestring_import::Choices;

use crate::{notes, read, refused, rows};

fn times_s(text: &str) -> Vec<f64> {
    read(text).0.iter().map(|row| row.time_s).collect()
}

fn csv(heading: &str, times: &[&str]) -> String {
    let rows: String = times.iter().map(|time| format!("{time},5,1\n")).collect();
    format!("{heading},Hook Load (kN),Block Position (m)\n{rows}")
}

#[test]
fn times_are_counted_from_the_first_row() {
    for (heading, times, expected) in [
        ("Time (s)", ["100", "100.5", "160"], [0.0, 0.5, 60.0]),
        ("Time (min)", ["1", "2", "2.5"], [0.0, 60.0, 90.0]),
        (
            "Time",
            ["2021-03-24T23:59:59Z", "2021-03-25T00:00:00.5Z", "2021-03-25T01:00:59+01:00"],
            [0.0, 1.5, 60.0],
        ),
        (
            "DateTime",
            ["24-Mar-2021 10:00:00", "24-Mar-2021 10:00:01", "25-Mar-2021 10:00:00"],
            [0.0, 1.0, 86_400.0],
        ),
        (
            "Timestamp",
            ["3/24/2021 11:59:59 AM", "3/24/2021 12:00:00 PM", "3/24/2021 1:00:00 PM"],
            [0.0, 1.0, 3601.0],
        ),
        ("Time", ["23:59:58", "23:59:59", "00:00:03"], [0.0, 1.0, 5.0]),
    ] {
        let text = csv(heading, &times);
        for (time, expected) in times_s(&text).iter().zip(expected) {
            assert!((time - expected).abs() < 1e-6, "{heading}: {time} {expected}");
        }
    }
}

#[test]
fn what_numbers_count_is_said() {
    for (times, note) in [
        (["44279.5", "44279.6", "44279.7"], "days as Excel counts them"),
        (["1616587200", "1616587205", "1616587210"], "seconds since 1970"),
        (["1616587200000", "1616587205000", "1616587210000"], "milliseconds since 1970"),
    ] {
        let text = csv("Timestamp", &times);
        let (_, log) = read(&text);
        assert!(notes(&log).contains(note), "{}", notes(&log));
    }
    // Counts of a computer's clock, whatever unit the heading has.
    for (heading, times) in [
        ("Timestamp", ["1616587200000", "1616587205000", "1616587210000"]),
        ("Time (s)", ["1616587200000", "1616587205000", "1616587210000"]),
        ("Time (ms)", ["1616587200000", "1616587205000", "1616587210000"]),
        ("Time (unix ms)", ["1616587200000", "1616587205000", "1616587210000"]),
        ("Time (s)", ["1616587200000000", "1616587205000000", "1616587210000000"]),
        ("Time (s)", ["1616587200", "1616587205", "1616587210"]),
        ("Time (epoch)", ["1616587200", "1616587205", "1616587210"]),
    ] {
        let (rows, log) = read(&csv(heading, &times));
        let times_s: Vec<f64> = rows.iter().map(|row| row.time_s).collect();
        assert_eq!(times_s, [0.0, 5.0, 10.0], "{heading} {times:?}");
        assert_eq!(log.start.as_deref(), Some("2021-03-24 12:00:00 UTC"), "{heading} {times:?}");
    }
    let las = "~V\nVERS. 2.0:\n~C\nTIME.S :\nHKLD.kN :\n~A\n1616587200000 5\n1616587205000 6\n";
    let (rows, log) = read(las);
    assert_eq!(rows[1].time_s, 5.0);
    assert!(notes(&log).contains("TIME is taken to be milliseconds since 1970"), "{}", notes(&log));

    let text = csv("Timestamp", &["44279.5", "44279.6", "44279.7"]);
    let (rows, log) = read(&text);
    assert!((rows[1].time_s - 8640.0).abs() < 1e-3);
    assert_eq!(log.start.as_deref(), Some("2021-03-24 12:00:00"));
    let error = refused(&csv("Time", &["0", "1", "2"]));
    assert!(
        error.starts_with("a log: the time Time has no unit; give it with --unit time="),
        "{error}"
    );
}

#[test]
fn date_and_time_may_stand_apart() {
    let text = "YYYY/MM/DD,HH:MM:SS,Hook Load (klbs),Block Height (feet)\n\
        2021/03/24,23:59:58,1,2\n2021/03/25,00:00:03,1,2\n";
    let (rows, log) = read(text);
    assert_eq!(rows[1].time_s, 5.0);
    assert_eq!(log.start.as_deref(), Some("2021-03-24 23:59:58"));
}

#[test]
fn day_or_month_is_seen_or_asked_for() {
    let unsure = csv("Time", &["03/04/2021 10:00:00", "03/05/2021 10:00:00"]);
    assert_eq!(
        refused(&unsure),
        "a log: the date '03/04/2021 10:00:00' may begin with the day or with the month; choose \
         with --pick date=dmy or --pick date=mdy"
    );
    for (order, days) in [("mdy", 1.0), ("dmy", 30.0)] {
        let choices = Choices::default().pick("date", order);
        let (rows, _) = rows("a.csv", unsure.as_bytes(), &choices).unwrap();
        assert_eq!(rows[1].time_s, days * 86_400.0);
    }
    assert_eq!(times_s(&csv("Time", &["03/31/2021 10:00:00", "04/01/2021 10:00:00"]))[1], 86_400.0);
    assert_eq!(times_s(&csv("Time", &["31/03/2021 10:00:00", "01/04/2021 10:00:00"]))[1], 86_400.0);
}

#[test]
fn rows_that_go_back_are_left_out_and_said() {
    let more: Vec<String> = (3..12).map(|ten| format!("{ten}0")).collect();
    let mut times = vec!["0", "10", "5", "10", "20", ""];
    times.extend(more.iter().map(String::as_str));
    let text = csv("Time (s)", &times);
    let (rows, log) = read(&text);
    let times: Vec<f64> = rows.iter().map(|row| row.time_s).take(5).collect();
    assert_eq!(times, [0.0, 10.0, 10.0, 20.0, 30.0]);
    assert_eq!(
        notes(&log),
        "left out: 1 row, the first in line 4: earlier than one above (a clock that was set back, or \
         parts of a log that overlap)\n\
         left out: 1 row without a time, the first in line 7\n\
         read: 1 row with the time of the row above\n"
    );
}

#[test]
fn a_log_against_time_backwards_is_refused() {
    // A log with the newest row first is read from its last row on.
    assert_eq!(times_s(&csv("Time (s)", &["30", "20", "10", "0"])), [0.0, 10.0, 20.0, 30.0]);
    let text = csv("Time (s)", &["30", "20", "10", "40", "5", "3"]);
    assert_eq!(
        refused(&text),
        "a log: the time goes back: 4 of 6 rows are earlier than one above, the first in line 3; \
         expected rows in the order of time (cut the file there and read its parts one by one, or \
         choose another column with --pick time=CHANNEL)"
    );
}

#[test]
fn gaps_stay() {
    assert_eq!(times_s(&csv("Time (s)", &["0", "1", "100000"])), [0.0, 1.0, 100_000.0]);
}

#[test]
fn what_is_no_time_is_refused_with_its_line() {
    let text = csv("Time", &["2021-03-24T10:00:00", "2021-02-30T10:00:00"]);
    assert_eq!(
        refused(&text),
        "a log, line 3: '2021-02-30T10:00:00' is not a time in the format of the rows above"
    );
    assert!(refused(&csv("Time", &["soon"])).contains("'soon' in the column Time is not a time"));
}

#[test]
fn a_date_and_its_time_may_be_parted_by_the_blank_of_a_las_file() {
    let text =
        "~V\nVERS. 2.0:\n~C\nTIME. :\nHKLD.kN:\n~A\n2021-03-24 10:00:00 5\n2021-03-24 10:00:02 6\n";
    let (rows, _) = read(text);
    assert_eq!((rows[1].time_s, rows[1].hook_load_N), (2.0, 6000.0));
}

#[test]
fn a_date_in_the_first_curve_goes_with_its_time() {
    let text =
        "~V\nVERS. 2.0:\n~C\nDATE.D :\nTIME.HHMMSS :\nHKLD.kN :\n~A\n210324 235958 5\n210325 3 6\n";
    let (rows, log) = read(text);
    assert_eq!(rows[1].time_s, 5.0);
    assert_eq!(log.start.as_deref(), Some("2021-03-24 23:59:58"));
}
