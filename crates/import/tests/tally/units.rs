//! Units, fractions, and dates that a spreadsheet makes of them.

use insta::assert_snapshot;
use rust_xlsxwriter::{ExcelDateTime, Format, Worksheet};
use wholestring_import::{Choices, Input, contents, import};

use crate::{
    PLAIN, components, header, imported, notes, of_bytes, refused, refused_with, saved, string,
};

#[test]
fn units_are_asked_for_and_never_guessed() {
    let bare = "Component,OD,ID,Length,Weight\nBit,8.5,2,1,\nDC,6.5,2.25,30,99\nDP,5,4.276,90,21\n";
    assert_snapshot!(refused(bare), @"tally.csv, line 1, column 11: the outside diameter under 'OD' has no unit; give it with --unit od=mm, or one of mm, in, m, cm, ft, km, yd, usft");
    let refusal = |choices: Choices| refused_with(bare, &choices);
    let choices = Choices::default().unit("diameter", "in");
    assert_snapshot!(refusal(choices.clone()), @"tally.csv, line 1, column 17: the length under 'Length' has no unit; give it with --unit length=m, or one of m, ft, mm, in, cm, km, yd, usft");
    let choices = choices.unit("length", "ft");
    assert_snapshot!(refusal(choices.clone()), @"tally.csv, line 1, column 24: the weight per length under 'Weight' has no unit; give it with --unit weight=kg/m, or one of kg/m, lb/ft, t/m");
    let whole = of_bytes("a.csv", bare.as_bytes(), &choices.clone().unit("weight", "lb/ft"));
    assert_eq!(components(&whole).len(), 3);
    // By the name of the column itself, and not of another dimension.
    assert_snapshot!(refusal(choices.unit("weight", "kN")), @"tally.csv: --unit weight=kN: expected a unit of mass per length: kg/m, lb/ft, t/m");
    let choices = Choices::default().unit("od", "mm");
    assert_snapshot!(refused_with(PLAIN, &choices), @"tally.csv, line 1, column 11: the outside diameter is in 'in' in the file and in 'mm' as given; keep one of them");
    let what = contents(Input::of_bytes("a.csv", bare.as_bytes())).unwrap();
    assert_snapshot!(format!("{}: {}", what.what, what.lines.join("; ")), @"a tally: to import it: line 1, column 11: the outside diameter under 'OD' has no unit; give it with --unit od=mm, or one of mm, in, m, cm, ft, km, yd, usft");
}

#[test]
fn units_stand_in_headings_in_a_row_or_in_cells_and_differ_by_column() {
    let imported = imported(
        "No.;Description;OD mm;ID, in;Length;Weight\n;;;;m;kg/m\n1;Bit;215,9;2 1/4 in;0,3;\n\
         2;DC;6-1/2\";57,15 mm;9,15;148,1\n3;DP;5 in;108,6 mm;2500;31,9\n",
    );
    assert_snapshot!(string(&imported), @r#"
    [[string]]
    component = "Bit"
    od = "215.9 mm"
    id = "2.25 in"
    length = "0.3 m"

    [[string]]
    component = "DC"
    od = "6.5 in"
    id = "57.15 mm"
    length = "9.15 m"
    mass_per_length = "148.1 kg/m"

    [[string]]
    component = "DP"
    od = "5 in"
    id = "108.6 mm"
    length = "to surface"
    mass_per_length = "31.9 kg/m"
    "#);
    let components = components(&imported);
    assert!((components[1].od_m - 0.1651).abs() < 1e-9);
    assert!((components[1].id_m - 0.05715).abs() < 1e-9);
}

#[test]
fn fractions_are_read_however_they_are_written() {
    for written in ["8 1/2", "8-1/2", "8½", "8 1/2\"", "8-1/2 in", "8.5", "8.5\""] {
        let imported =
            imported(&PLAIN.replace("8.5", &format!("\"{}\"", written.replace('"', "\"\""))));
        assert!(string(&imported).contains("od = \"8.5 in\""), "{written}: {}", imported.text);
    }
    assert_snapshot!(refused(&PLAIN.replace("8.5", "8/1")), @"tally.csv, line 2, column 9: '8/1' is not a number; the outside diameter was expected");
}

#[test]
fn dates_that_a_spreadsheet_made_of_fractions_are_refused_with_their_cell() {
    assert_snapshot!(refused(&PLAIN.replace("8.5", "08-Jan")), @"tally.csv, line 2, column 9: the outside diameter is a date: a spreadsheet made one of a fraction such as 8-1/2, and what was typed is lost; format the cell as a number and type it again as a decimal, such as 8.5");
    let mut sheet = Worksheet::new();
    sheet.set_name("BHA").unwrap();
    header(&mut sheet, 0, &["Component", "OD (in)", "ID (in)", "Length (ft)"]);
    sheet.write(1, 0, "Bit").unwrap();
    let date = ExcelDateTime::from_ymd(2026, 1, 8).unwrap();
    sheet.write_with_format(1, 1, &date, &Format::new().set_num_format("d-mmm")).unwrap();
    sheet.write(1, 2, 2).unwrap();
    sheet.write(1, 3, 1).unwrap();
    let bytes = saved(vec![sheet]);
    let error = import(vec![Input::of_bytes("BHA.xlsx", &bytes)], &Choices::default());
    assert_snapshot!(error.unwrap_err(), @"BHA.xlsx, sheet 'BHA', cell B2: the outside diameter is a date: a spreadsheet made one of a fraction such as 8-1/2, and what was typed is lost; format the cell as a number and type it again as a decimal, such as 8.5");
}

/// Pounds per foot under kg/m make every component lighter than its body.
#[test]
fn weights_in_pounds_under_kilograms_are_warned_of_with_their_unit() {
    let metric = PLAIN.replace("(lb/ft)", "(kg/m)");
    let found = notes(&imported(&metric));
    let hint = "give its density too; if lb/ft was meant, correct the unit";
    assert_eq!(found.matches(hint).count(), 2, "{found}");
    assert!(!notes(&imported(PLAIN)).contains("was meant"));
    let heavy = PLAIN.replace("99.5", "148");
    assert_snapshot!(refused(&heavy), @"tally.csv, line 3, column 'Weight (lb/ft)': the weight per length 148 lb/ft of 'Collar' is out of range; expected at most the 113.1 lb/ft of a solid bar of 165.1 mm; if kg/m was meant, correct the unit");
}
