//! Rows of a survey that are passed over, and those that must not be.

use wholestring_tabular::{Column, TableError, TableErrorKind, read_csv};

/// Measured depths of a survey, m.
fn depths_m(text: &str) -> Result<Vec<f64>, TableError> {
    let survey = read_csv(text.as_bytes(), "a.csv")?;
    Ok(survey.stations.iter().map(|station| station.md_m).collect())
}

/// `#` begins a comment, but `#1` beside other cells is the number of a row, and an error of a
/// spreadsheet is a value that is missing.
#[test]
fn numbers_of_rows_and_errors_are_no_comments() {
    let numbered = "No,MD (m),Inc (deg),Azi (deg)\n#1,0,0,0\n#2,100,1,10\n# a remark\n";
    assert_eq!(depths_m(numbered).expect("a survey"), [0.0, 100.0]);
    let unused = "No,MD (m),Inc (deg),Azi (deg)\n1,0,0,0\n#REF!,100,1,10\n";
    assert_eq!(depths_m(unused).expect("a survey"), [0.0, 100.0]);
    for error in ["#N/A", "#DIV/0!", "#VALUE!"] {
        let text = format!("MD (m),Inc (deg),Azi (deg)\n0,0,0\n{error},1,10\n200,2,10\n");
        let refused = depths_m(&text).expect_err("a depth is missing").to_string();
        assert!(refused.contains("line 3, column 1") && refused.contains(error), "{refused}");
    }
}

/// A second table below the first, in another unit, is not read in that of the first.
#[test]
fn units_do_not_change_within_a_table() {
    let head = "MD,Inc,Azi\nft,deg,deg\n0,0,0\n1500,0,0\n1600,3,45\n";
    for second in ["MD,Inc,Azi\nm,deg,deg\n900,30,45\n", "m,deg,deg\n900,30,45\n"] {
        let refused = depths_m(&format!("{head}{second}")).expect_err("two units");
        let TableErrorKind::UnitChanges { column, above, below } = refused.kind() else {
            panic!("{refused}")
        };
        assert_eq!((*column, *above, *below), (Column::MeasuredDepth, "ft", "m"));
    }
    // The headings of another page, with the same units.
    let again = format!("{head}MD,Inc,Azi\nft,deg,deg\n2900,30,45\n");
    assert_eq!(depths_m(&again).expect("a survey").len(), 4);
    let brackets = "MD (ft),Inc,Azi\n0,0,0\n1600,3,45\nMD (m),Inc,Azi\n900,30,45\n";
    assert!(depths_m(brackets).is_err());
}
