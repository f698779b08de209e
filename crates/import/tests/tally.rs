//! Tallies as text and workbooks, and what traps they hold.

use std::collections::BTreeMap;

use insta::assert_snapshot;
use proptest::prelude::*;
use rust_xlsxwriter::{ExcelDateTime, Format, Workbook, Worksheet};
use wholestring_case::Template;
use wholestring_import::{Choices, Imported, Input, contents, import};

#[path = "../../tabular/tests/old_excel/mod.rs"]
mod old_excel;

use old_excel::Value as Old;

fn imported(text: &str) -> Imported {
    of_bytes("tally.csv", text.as_bytes(), &Choices::default())
}

fn of_bytes(name: &str, bytes: &[u8], choices: &Choices) -> Imported {
    match import(vec![Input::of_bytes(name, bytes)], choices) {
        Ok(imported) => imported,
        Err(error) => panic!("{error}"),
    }
}

fn refused_with(text: &str, choices: &Choices) -> String {
    match import(vec![Input::of_bytes("tally.csv", text.as_bytes())], choices) {
        Ok(imported) => panic!("{}", imported.text),
        Err(error) => error.to_string(),
    }
}

fn refused(text: &str) -> String {
    refused_with(text, &Choices::default())
}

/// The blocks of the string in a case, without comments, parted by blank lines.
fn string(imported: &Imported) -> String {
    let text = &imported.text;
    let from = text.find("\n[[string]]\n").unwrap_or_else(|| panic!("no string: {text}"));
    let lines = text[from + 1..].lines().take_while(|line| !line.starts_with("[operation]"));
    let plain = lines.map(|line| line.split(" #").next().unwrap_or(line).trim_end());
    plain.collect::<Vec<_>>().join("\n").trim().to_owned()
}

fn notes(imported: &Imported) -> String {
    let notes = imported.notes.iter().map(|(_, note)| format!("{}: {}", note.kind(), note.text()));
    notes.collect::<Vec<_>>().join("\n")
}

/// The components of the case, which accepts them: what the file lacks besides is filled in.
fn components(imported: &Imported) -> Vec<wholestring::string::Component> {
    let text = imported.text.replace(
        "\n[well]\n",
        "\n[well]\nstations = [[0, 0, 0], [\"1000 m\", 0, 0], [\"3000 m\", 40, 90]]\n[[well.hole]]\nkind = \
         \"open\"\nto = \"3000 m\"\ndiameter = \"26 in\"\nfriction = 0.3\n[mud]\ndensity = \"1.2 \
         sg\"\n",
    );
    // Above an assembly alone stands pipe.
    let lacks_pipe = imported.missing.iter().any(|missing| missing.starts_with("the pipe above"));
    let pipe = "[[string]]\ncomponent = \"pipe\"\nod = \"5 in\"\nid = \"4 in\"\nlength = \"to surface\"\n\n";
    let text =
        if lacks_pipe { text.replace("[operation]", &format!("{pipe}[operation]")) } else { text };
    let template = Template::in_memory("imported.toml", &text, BTreeMap::new());
    match template.case(&[]) {
        Ok(case) => {
            let mut components = case.model.string.components().to_vec();
            components.truncate(components.len() - usize::from(lacks_pipe));
            components
        }
        Err(report) => panic!("{}", report.render(false)),
    }
}

const PLAIN: &str = "Component,OD (in),ID (in),Length (ft),Weight (lb/ft)\n\
    PDC bit,8.5,2.25,0.85,\n\
    Collar,6.5,2.25,30,99.5\n\
    DP,5,4.276,TO SURFACE,21\n";

#[test]
fn the_sample_tally_becomes_a_string() {
    let bytes = include_bytes!("samples/own/tally.csv");
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
    let bytes = include_bytes!("samples/excel/madsim-BHA_Data_ExampleAssembly.xlsx");
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

#[test]
fn units_are_asked_for_and_never_guessed() {
    let bare = "Component,OD,ID,Length,Weight\nBit,8.5,2,1,\nDC,6.5,2.25,30,99\nDP,5,4.276,90,21\n";
    assert_snapshot!(refused(bare), @"tally.csv, line 2, column 5: the outside diameter under 'OD' has no unit; say it: --unit od=mm, or one of mm, in, m, cm, ft, km, yd, usft");
    let said = |choices: Choices| refused_with(bare, &choices);
    let choices = Choices::default().unit("diameter", "in");
    assert_snapshot!(said(choices.clone()), @"tally.csv, line 2, column 11: the length under 'Length' has no unit; say it: --unit length=m, or one of m, ft, mm, in, cm, km, yd, usft");
    let choices = choices.unit("length", "ft");
    assert_snapshot!(said(choices.clone()), @"tally.csv, line 3, column 16: the weight per length under 'Weight' has no unit; say it: --unit weight=kg/m, or one of kg/m, lb/ft, t/m");
    let whole = of_bytes("a.csv", bare.as_bytes(), &choices.clone().unit("weight", "lb/ft"));
    assert_eq!(components(&whole).len(), 3);
    // By the name of the column itself, and not of another dimension.
    assert_snapshot!(said(choices.unit("weight", "kN")), @"tally.csv: --unit weight=kN: expected a unit of mass per length: kg/m, lb/ft, t/m");
    let choices = Choices::default().unit("od", "mm");
    assert_snapshot!(refused_with(PLAIN, &choices), @"tally.csv, line 1, column 11: the outside diameter is in 'in' by the file and in 'mm' by what was said; leave one of them");
    let what = contents(Input::of_bytes("a.csv", bare.as_bytes())).unwrap();
    assert_snapshot!(format!("{}: {}", what.what, what.lines.join("; ")), @"a tally: to import it: line 2, column 5: the outside diameter under 'OD' has no unit; say it: --unit od=mm, or one of mm, in, m, cm, ft, km, yd, usft");
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

#[test]
fn the_order_is_found_by_the_bit_the_cumulative_length_or_the_numbers() {
    let of = |rows: &str| {
        imported(&format!("No,Component,OD (in),ID (in),Length (ft),Cum. length (ft)\n{rows}"))
    };
    let order = |imported: &Imported| {
        let notes = notes(imported);
        notes.lines().find(|line| line.contains("the tally is")).unwrap().to_owned()
    };
    let by_bit = of(",DP,5,4,TO SURFACE,\n,DC,6,2,30,31\n,Bit,8.5,2,1,1\n");
    assert_snapshot!(order(&by_bit), @"read: the tally is listed from the surface down, and turned over: the bit, 'Bit', is in line 4");
    assert!(components(&by_bit)[0].is_bit());
    let by_cumulative = of(",DP,5,4,90,130\n,DC,6,2,30,40\n,Mill,8.5,2,10,10\n");
    assert_snapshot!(order(&by_cumulative), @"assumed: the tally is listed from the surface down, and turned over: the cumulative length falls down the table, and counts from the bit");
    assert_eq!(components(&by_cumulative)[0].name, "Mill");
    let by_growing = of(",Mill,8.5,2,10,10\n,DC,6,2,30,40\n,DP,5,4,90,130\n");
    assert_snapshot!(order(&by_growing), @"assumed: the tally is read as listed, from the bit up: the cumulative length grows down the table, and counts from the bit");
    let by_number = of("3,DP,5,4,90,\n2,DC,6,2,30,\n1,Mill,8.5,2,10,\n");
    assert_snapshot!(order(&by_number), @"assumed: the tally is listed from the surface down, and turned over: the numbers count from the bit");
    assert_eq!(components(&by_number)[0].name, "Mill");
}

#[test]
fn an_order_that_nothing_tells_is_asked_for() {
    let text = "Component,OD (in),ID (in),Length (ft)\nDP,5,4,90\nDC,6,2,30\nMill,8.5,2,10\n";
    assert_snapshot!(refused(text), @"tally.csv: nothing tells which end of the tally is the bit's: no row is a bit, and neither a cumulative length nor numbers count from it; say it: --pick order=bit-first, or --pick order=bit-last");
    let picked = |order: &str| Choices::default().pick("order", order);
    let last = of_bytes("a.csv", text.as_bytes(), &picked("bit-last"));
    assert_eq!(components(&last)[0].name, "Mill");
    let first = of_bytes("a.csv", text.as_bytes(), &picked("bit-first"));
    assert_eq!(components(&first)[0].name, "DP");
    assert_snapshot!(refused_with(text, &picked("up")), @"tally.csv: there is no order 'up'; it holds: 'bit-first', 'bit-last'");
    let within = "Component,OD (in),ID (in),Length (ft)\nDC,6,2,30\nBit,8.5,2,1\nDP,5,4,90\n";
    assert_snapshot!(refused(within), @"tally.csv, line 3: the bit, 'Bit', stands neither first nor last; expected the components of one string, from the bit up or from the surface down (--pick order=bit-first or bit-last if it is no bit)");
}

#[test]
fn cumulative_lengths_and_totals_are_held_against_the_lengths() {
    let of = |cumulative: &str, total: &str| {
        imported(&format!(
            "Component,OD (in),ID (in),Length (ft),Cum. (ft)\nBit,8.5,2,0.85,0.85\nRSS,6.75,2,\
             13.6,14.45\nDC,6.5,2,30.90,{cumulative}\nTOTAL,,,{total},\n"
        ))
    };
    let checked = |imported: &Imported| {
        let notes = notes(imported);
        let checked = notes.lines().filter(|line| line.starts_with("checked"));
        checked.collect::<Vec<_>>().join("\n")
    };
    assert_snapshot!(checked(&of("45.35", "45.35")), @r"
    checked: the cumulative length agrees with the lengths in 3 rows
    checked: the total agrees with the lengths: 45.35 ft (line 5, column 'Length (ft)')
    ");
    assert_snapshot!(checked(&of("54.35", "45.85")), @r"
    checked: THE CUMULATIVE LENGTH DIFFERS from the sum of the lengths: 54.35 ft (line 4, column 'Cum. (ft)') against 45.35 ft; the lengths are taken
    checked: THE TOTAL DIFFERS from the sum of the lengths: 45.85 ft (line 5, column 'Length (ft)') against 45.35 ft
    ");
    // The last digit may be rounded.
    assert!(checked(&of("45.36", "45.34")).contains("agrees"));
}

#[test]
fn lengths_of_several_joints_are_told_apart() {
    let of = |rows: &str| {
        format!("Component,OD (in),ID (in),Jts,Length (ft),Cum (ft)\nBit,8.5,2,1,1,1\n{rows}")
    };
    let length = |imported: &Imported| components(imported)[1].length_m / 0.3048;
    let near = |imported: &Imported, feet: f64| assert!((length(imported) - feet).abs() < 1e-6);
    let top = "DP,5,4,,TO SURFACE,\n";
    near(&imported(&of(&format!("DC,6.5,2,3,90.3,91.3\n{top}"))), 90.3);
    let each = imported(&of(&format!("DC,6.5,2,3,30.1,91.3\n{top}")));
    near(&each, 90.3);
    assert!(notes(&each).contains("is that of each joint: the cumulative lengths add up so"));
    near(&imported(&of(&format!("DC,6.5,2,3,90.3,\n{top}"))), 90.3);
    let unclear = of(&format!("DC,6.5,2,3,30.1,\n{top}"));
    assert_snapshot!(refused(&unclear), @"tally.csv, line 3: the length '30.1' of 3 joints may be that of all or of each, and no cumulative length tells; say it: --pick length=total, or --pick length=each");
    let picked = Choices::default().pick("length", "each");
    near(&of_bytes("a.csv", unclear.as_bytes(), &picked), 90.3);
    // A column of its own for the length of a joint.
    let average = "Component,OD (in),ID (in),Joints,Avg. length (ft)\nBit,8.5,2,1,1\n\
                   DC,6.5,2,3,30.1\nDP,5,4,,TO SURFACE\n";
    near(&imported(average), 90.3);
}

#[test]
fn joints_listed_one_by_one_are_one_component() {
    let mut text = "Jt;Description;OD (in);ID (in);TJ OD (in);Length (m);Weight (kg/m)\n\
                    0;Bit;8.5;2;;0.3;\n"
        .to_owned();
    for joint in 1..=60 {
        text +=
            &format!("{joint};DP 5\";5;4.276;6.625;{:.2};31\n", 9.5 + 0.01 * f64::from(joint % 5));
    }
    let imported = imported(&text);
    assert_snapshot!(string(&imported), @r#"
    [[string]]
    component = "Bit"
    od = "8.5 in"
    id = "2 in"
    length = "0.3 m"

    [[string]]
    component = "DP 5\""
    od = "5 in"
    id = "4.276 in"
    length = "to surface"
    joint_od = "6.625 in"
    joint_spacing = "9.52 m"
    mass_per_length = "31 kg/m"
    "#);
    assert!(notes(&imported).contains("60 joints, line 3 to line 62, are one component"));
}

#[test]
fn titles_footnotes_empty_rows_and_repeated_headings_are_passed_over() {
    let imported = imported(
        "Rig 7,,,,\nBHA no. 3,,,,\n,,,,\nItem,Component,OD,ID,Length\n,,[in],[in],[m]\n,,,,\n\
         1,Bit,8.5,2.25,0.3\nBottom-hole assembly,,,,\n2,DC,6.5,2.25,\"1,009.1\"\nItem,Component,OD,\
         ID,Length\n,,[in],[in],[m]\n3,DP,5,4.276,TO SURFACE\nSub-total,,,,1009.4\n,,,,\n* all from \
         the maker,,,,\n",
    );
    assert_snapshot!(string(&imported), @r#"
    [[string]]
    component = "Bit"
    od = "8.5 in"
    id = "2.25 in"
    length = "0.3 m"

    [[string]]
    component = "DC"
    od = "6.5 in"
    id = "2.25 in"
    length = "1009.1 m"

    [[string]]
    component = "DP"
    od = "5 in"
    id = "4.276 in"
    length = "to surface"
    "#);
    assert_snapshot!(notes(&imported), @r"
    read: the tally is read as listed, from the bit up: the bit, 'Bit', is in line 7
    checked: the total agrees with the lengths below the topmost component: 1009.4 m (line 13, column 'Length')
    assumed: 'DP': no weight; computed from the diameters as steel, WITHOUT TOOL JOINTS, which make pipe a tenth heavier or more: give mass_per_length, or catalogue
    assumed: 'Bit', 'DC': no weight; computed from the diameters as steel
    read: header in line 4, columns parted by commas
    read: component from 'Component'
    read: outside diameter from 'OD' in in
    read: length from 'Length' in m
    read: inside diameter from 'ID' in in
    read: number from 'Item'
    left out: line 8: 'Bottom-hole assembly'
    left out: line 10: 'Item'
    left out: line 11: '[in]'
    left out: line 15: '* all from the maker'
    ");
}

#[test]
fn tabs_semicolons_and_columns_of_blanks_part_the_cells() {
    let tabs = imported(&PLAIN.replace(',', "\t"));
    let semicolons = imported(&PLAIN.replace(',', ";").replace('.', ","));
    let fixed = imported(
        "BHA 7                       page 1\n\n\
         Component     OD     ID      Length       Weight\n\
        \x20             in     in      ft           lb/ft\n\
         -----------------------------------------------\n\
         PDC bit       8.5    2.25    0.85\n\
         Collar        6.5    2.25    30           99.5\n\
         DP            5      4.276   TO SURFACE   21\n",
    );
    let plain = string(&imported(PLAIN));
    assert_eq!(string(&tabs), plain);
    assert_eq!(string(&semicolons), plain);
    assert_eq!(string(&fixed), plain);
}

#[test]
fn a_weight_may_be_per_length_or_of_the_whole_and_a_force() {
    let of = |heading: &str, weight: &str| {
        format!(
            "Component,OD (in),ID (in),Length (ft),{heading}\nBit,8.5,2,1,\nDC,6.5,2.25,30,{weight}\n\
             DP,5,4.276,TO SURFACE,\n"
        )
    };
    let mass = |text: &str| components(&imported(text))[1].mass_per_length_kg_per_m;
    let near = |text: &str, kg_per_m: f64| assert!((mass(text) - kg_per_m).abs() < 0.01, "{text}");
    near(&of("Weight (lb/ft)", "99.5"), 148.07);
    near(&of("Weight [ppf]", "99.5"), 148.07);
    near(&of("Wt lbs/ft", "99.5"), 148.07);
    near(&of("Weight (kg/m)", "148.07"), 148.07);
    near(&of("Weight (kN/m)", "1.452"), 148.06);
    near(&of("Total weight (lb)", "2985"), 148.07);
    near(&of("Weight (klb)", "2.985"), 148.07);
    near(&of("Weight (lbs)", "2985"), 148.07);
    near(&of("Weight", "99.5 lb/ft"), 148.07);
    assert_snapshot!(refused(&of("Weight (lbs)", "99.5")), @"tally.csv, line 3, column 'Weight (lbs)': the weight per length 4.935744 kg/m of 'DC' is out of range; expected about the 148.1 kg/m of its body or more (is the column the weight per length, and in the right unit?)");
    assert_snapshot!(refused(&of("Weight (kg/m)", "500")), @"tally.csv, line 3, column 'Weight (kg/m)': the weight per length 500 kg/m of 'DC' is out of range; expected at most the 168.3 kg/m of a solid bar of 165.1 mm");
    assert_snapshot!(refused(&of("Weight (furlong)", "500")), @"tally.csv, line 1, column 39: 'furlong' is not a unit of mass per length; expected kg/m, lb/ft, t/m");
    let both = imported(
        "Component,OD (in),ID (in),Length (ft),Weight (lb/ft),Total weight (lb)\nBit,8.5,2,1,,\n\
         DC,6.5,2.25,30,99.5,3300\nDP,5,4.276,TO SURFACE,,\n",
    );
    assert!(notes(&both).contains("THE WEIGHTS of 'DC' DIFFER: 99.5 lb/ft per length against"));
}

#[test]
fn pipe_that_the_catalogue_has_is_named_if_its_diameters_agree() {
    let of = |name: &str, id: &str| {
        imported(&format!(
            "Component,OD (in),ID (in),Jts,Length (ft),Connection,Grade\nBit,8.5,2,1,1,,\n{name},5,{id},\
             ,TO SURFACE,HT50,S-135\n"
        ))
    };
    let listed = of("DP 5in 19.50# S-135", "4.28");
    assert_snapshot!(string(&listed), @r#"
    [[string]]
    component = "Bit"
    od = "8.5 in"
    id = "2 in"
    length = "1 ft"

    [[string]]
    component = "DP 5in 19.50# S-135"
    catalogue = "5 in 19.50 lb/ft S-135"
    length = "to surface"
    "#);
    assert_snapshot!(notes(&listed), @r"
    read: the tally is read as listed, from the bit up: the bit, 'Bit', is in line 2
    read: 'DP 5in 19.50# S-135' is the catalogue's '5 in 19.50 lb/ft S-135': od and id agree, and the case leaves them to it
    left out: the connection HT50 of 'DP 5in 19.50# S-135': the case has the catalogue's NC50; where tool joints or their torques matter, give joint_od and make_up_torque
    assumed: 'Bit': no weight; computed from the diameters as steel
    read: header in line 1, columns parted by commas
    read: component from 'Component'
    read: outside diameter from 'OD (in)' in in
    read: length from 'Length (ft)' in ft
    read: inside diameter from 'ID (in)' in in
    read: number of joints from 'Jts'
    read: connection from 'Connection'
    read: grade from 'Grade'
    ");
    let other = of("DP 5in 19.50# S-135", "4.0");
    assert_snapshot!(string(&other), @r#"
    [[string]]
    component = "Bit"
    od = "8.5 in"
    id = "2 in"
    length = "1 ft"

    [[string]]
    component = "DP 5in 19.50# S-135"
    od = "5 in"
    id = "4 in"
    length = "to surface"
    yield_strength = "135000 psi"
    "#);
    assert!(notes(&other).contains("is called like the catalogue's '5 in 19.50 lb/ft S-135', but"));
    let columns = imported(
        "Component,OD (in),ID (in),Nom. Weight (lb/ft),Length (ft),Grade\nBit,8.5,2,,1,\n\
         Drill pipe,5,4.276,19.5,TO SURFACE,S-135\n",
    );
    assert!(
        string(&columns).contains("catalogue = \"5 in 19.50 lb/ft S-135\""),
        "{}",
        columns.text
    );
    assert!((components(&listed)[1].id_m - 0.108612).abs() < 1e-4);
}

#[test]
fn grades_and_tool_joints_are_taken_where_the_catalogue_is_not() {
    let imported = imported(
        "Component,OD (in),ID (in),TJ OD (in),Jts,Length (ft),Weight (lb/ft),Grade\n\
         Bit,8.5,2,,1,1,,\nPipe,5.1,4.2,6.625,90,2835,22,S-135\nPipe above,5.1,4.2,6.625,,TO \
         SURFACE,22,4145H\n",
    );
    assert_snapshot!(string(&imported), @r#"
    [[string]]
    component = "Bit"
    od = "8.5 in"
    id = "2 in"
    length = "1 ft"

    [[string]]
    component = "Pipe"
    od = "5.1 in"
    id = "4.2 in"
    length = "2835 ft"
    joint_od = "6.625 in"
    joint_spacing = "31.5 ft"
    mass_per_length = "22 lb/ft"
    yield_strength = "135000 psi"

    [[string]]
    component = "Pipe above"
    od = "5.1 in"
    id = "4.2 in"
    length = "to surface"
    joint_od = "6.625 in"
    joint_spacing = "9.6 m"
    mass_per_length = "22 lb/ft"
    "#);
    assert_snapshot!(notes(&imported), @r"
    assumed: the length (line 3, column 'Length (ft)') is that of all joints: divided by their number it is a joint's
    read: the tally is read as listed, from the bit up: the bit, 'Bit', is in line 2
    assumed: 'Pipe above': a tool joint every 9.6 m, as in range 2
    left out: the grade '4145H' of 'Pipe above' (line 4, column 'Grade'): its yield strength is not known; give yield_strength
    assumed: 'Bit': no weight; computed from the diameters as steel
    read: header in line 1, columns parted by commas
    read: component from 'Component'
    read: outside diameter from 'OD (in)' in in
    read: length from 'Length (ft)' in ft
    read: inside diameter from 'ID (in)' in in
    read: number of joints from 'Jts'
    read: weight per length from 'Weight (lb/ft)' in lb/ft
    read: outside diameter of the tool joints from 'TJ OD (in)' in in
    read: grade from 'Grade'
    ");
    let components = components(&imported);
    assert_eq!(components[1].yield_strength_Pa.map(f64::round), Some(930_792_235.0));
}

#[test]
fn what_is_missing_is_named_with_its_row() {
    let row = |row: &str| {
        refused(&format!("Component,OD (in),ID (in),Length (ft)\nBit,8.5,2,1\n{row}\n"))
    };
    assert_snapshot!(row("DC,,2,30"), @"tally.csv, line 3: the outside diameter of 'DC' is missing");
    assert_snapshot!(row("DC,6,,30"), @"tally.csv, line 3: the inside diameter of 'DC' is missing");
    assert_snapshot!(row("DC,6,2,"), @"tally.csv, line 3: the length of 'DC' (a number, or TO SURFACE for the topmost) is missing");
    assert_snapshot!(row("DC,6,6.5,30"), @"tally.csv, line 3, column 'ID (in)': the inside diameter of 'DC' 6.5 in is out of range; expected less than its outside diameter, 6 in");
    assert_snapshot!(row("DC,600,2,30"), @"tally.csv, line 3, column 'OD (in)': the outside diameter of 'DC' 600 in is out of range; expected 5 mm to 2 m (0.2 to 78 in)");
    assert_snapshot!(row("DC,6,2,-3"), @"tally.csv, line 3: the length of 'DC' -3 ft is out of range; expected 0.01 to 20000 m");
    assert_snapshot!(row("DC,6,2,TO SURFACE\nDP,5,4,90"), @"tally.csv, line 3: 'DC' reaches to the surface, and 'DP' stands above it; only the topmost component can");
    assert_snapshot!(row("DC,six,2,30"), @"tally.csv, line 3, column 4: 'six' is not a number; the outside diameter was expected");
    assert_snapshot!(row("DC,6 furlongs,2,30"), @"tally.csv, line 3, column 4: 'furlongs' is not a unit of diameter; expected mm, in, m, cm, ft, km, yd, usft");
    assert_snapshot!(refused("Component,ID (in),Length (ft),Weight (lb/ft)\nBit,2,1,\n"), @"tally.csv, line 1, column 1: no column of outside diameter; the header has: 'Component', 'ID (in)', 'Length (ft)', 'Weight (lb/ft)'");
    assert_snapshot!(refused("Component,OD (in),ID (in),Length (ft)\n"), @"tally.csv, line 1, column 1: no component follows the header; the components of a string were expected, under a header such as 'Component, OD (in), ID (in), Length (ft), Weight (lb/ft)'");
}

#[test]
fn stabilisers_have_blades() {
    let of = |gauge: &str| {
        format!(
            "Component,OD (in),ID (in),Gauge (in),Length (ft)\nBit,6.5,2,8.5,1\nStab,6.75,2.8,{gauge},6\nDP,5,4,,TO SURFACE\n"
        )
    };
    let imported = imported(&of("8 3/8"));
    assert_snapshot!(string(&imported), @r#"
    [[string]]
    component = "Bit"
    od = "8.5 in"
    id = "2 in"
    length = "1 ft"

    [[string]]
    component = "Stab"
    od = "6.75 in"
    id = "2.8 in"
    length = "6 ft"
    blade_od = "8.375 in"

    [[string]]
    component = "DP"
    od = "5 in"
    id = "4 in"
    length = "to surface"
    "#);
    assert!(components(&imported)[1].blades.is_some());
    assert_snapshot!(refused(&of("6.5")), @"tally.csv, line 3, column 'Gauge (in)': the gauge of 'Stab' 6.5 in is out of range; expected its outside diameter, 6.75 in, or more");
    assert!(!string(&self::imported(&of("0"))).contains("blade_od"));
}

fn header(sheet: &mut Worksheet, row: u32, texts: &[&str]) {
    for (column, text) in texts.iter().enumerate() {
        if !text.is_empty() {
            sheet.write(row, column as u16, *text).unwrap();
        }
    }
}

fn saved(sheets: Vec<Worksheet>) -> Vec<u8> {
    let mut workbook = Workbook::new();
    for sheet in sheets {
        workbook.push_worksheet(sheet);
    }
    workbook.save_to_buffer().unwrap()
}

/// A sheet whose headings stand over several columns and in three rows.
fn merged() -> Worksheet {
    let mut sheet = Worksheet::new();
    sheet.set_name("BHA 7").unwrap();
    let centre = Format::new();
    sheet.merge_range(0, 0, 0, 8, "Bottom-hole assembly 7", &centre).unwrap();
    sheet.merge_range(2, 2, 2, 3, "Body", &centre).unwrap();
    sheet.merge_range(2, 4, 2, 5, "Tool joint", &centre).unwrap();
    header(&mut sheet, 2, &["", "", "", "", "", "", "", "Cum."]);
    header(
        &mut sheet,
        3,
        &["#", "Description", "OD", "ID", "OD", "ID", "Length", "length", "Weight"],
    );
    header(&mut sheet, 4, &["", "", "(in)", "(in)", "(in)", "(in)", "(m)", "(m)", "(kg/m)"]);
    let rows: [(&str, [f64; 7]); 3] = [
        ("8 1/2\" bit", [8.5, 2.25, 0.0, 0.0, 0.3, 0.3, 0.0]),
        ("Collar", [6.5, 2.25, 0.0, 0.0, 9.1, 9.4, 148.0]),
        ("Pipe", [5.1, 4.2, 6.625, 3.25, 95.0, 104.4, 31.0]),
    ];
    for (at, (name, numbers)) in rows.iter().enumerate() {
        let row = 5 + at as u32;
        sheet.write(row, 0, at as u32 + 1).unwrap();
        sheet.write(row, 1, *name).unwrap();
        for (column, number) in numbers.iter().enumerate().filter(|(_, number)| **number != 0.0) {
            // Some numbers are stored as text.
            match column {
                2 => sheet.write(row, 2 + column as u16, number.to_string()).unwrap(),
                _ => sheet.write(row, 2 + column as u16, *number).unwrap(),
            };
        }
    }
    sheet.merge_range(9, 0, 9, 8, "Lengths without pins.", &centre).unwrap();
    sheet
}

#[test]
fn merged_headings_and_numbers_as_text_in_a_workbook() {
    let imported = of_bytes("BHA.xlsx", &saved(vec![merged()]), &Choices::default());
    components(&imported);
    assert_snapshot!("merged", imported.text);
}

#[test]
fn a_workbook_gives_survey_and_tally_of_its_sheets() {
    let mut survey = Worksheet::new();
    survey.set_name("Survey").unwrap();
    header(&mut survey, 0, &["MD (m)", "Inc (deg)", "Azi (deg)"]);
    for (row, station) in
        [[0.0, 0.0, 0.0], [1000.0, 0.0, 0.0], [2000.0, 30.0, 90.0]].iter().enumerate()
    {
        for (column, number) in station.iter().enumerate() {
            survey.write(row as u32 + 1, column as u16, *number).unwrap();
        }
    }
    let bytes = saved(vec![merged(), survey]);
    let both = of_bytes("well.xlsx", &bytes, &Choices::default());
    assert_snapshot!(both.files[0].1, @"a survey of 3 stations, and a tally of 3 components in sheet 'BHA 7'");
    assert_eq!(both.missing.len(), 2);
    // One alone, where it is picked.
    let one = of_bytes("well.xlsx", &bytes, &Choices::default().pick("table", "survey"));
    assert!(!one.text.contains("\n[[string]]"));
    // Two tallies.
    let mut other = merged();
    other.set_name("BHA 8").unwrap();
    let bytes = saved(vec![merged(), other]);
    let error = import(vec![Input::of_bytes("two.xlsx", &bytes)], &Choices::default());
    assert_snapshot!(error.unwrap_err(), @"two.xlsx: it holds 2 of the kind 'tally': 'BHA 7', 'BHA 8'; pick one: --pick tally=NAME");
    let eight = of_bytes("two.xlsx", &bytes, &Choices::default().pick("tally", "BHA 8"));
    assert!(eight.text.contains("sheet 'BHA 8', cell C6"));
}

/// As Excel writes the old format: each text once, short numbers, merged headings.
fn old_tally(od: Old<'static>) -> Vec<u8> {
    let mut cells = vec![
        (0, 0, Old::Shared("Bottom-hole assembly 7")),
        (2, 1, Old::Shared("Body")),
        (2, 3, Old::Shared("Tool joint")),
    ];
    let headings = ["Component", "OD (in)", "ID (in)", "OD (in)", "ID (in)", "Length (m)"];
    cells.extend((0..).zip(headings).map(|(column, text)| (3, column, Old::Shared(text))));
    cells.extend([(4, 0, Old::Shared("Bit")), (4, 1, od), (4, 2, Old::Short(2.25))]);
    cells.extend([(4, 5, Old::Short(0.3)), (5, 0, Old::Shared("Collar"))]);
    cells.extend([(5, 1, Old::Shorts(&[6.5, 2.25])), (5, 5, Old::Number(9.144))]);
    cells.extend([(6, 0, Old::Shared("Pipe")), (6, 1, Old::Shorts(&[5.0, 4.28, 6.63, 3.25]))]);
    cells.push((6, 5, Old::Number(95.0)));
    old_excel::workbook_merged(&cells, &[[0, 0, 0, 5], [2, 2, 1, 2], [2, 2, 3, 4]])
}

#[test]
fn an_old_workbook_as_excel_writes_it() {
    let imported = of_bytes("a.xls", &old_tally(Old::Short(8.5)), &Choices::default());
    assert_snapshot!(string(&imported));
}

/// The cell holds the day, and only its format shows that it is one.
#[test]
fn dates_of_an_old_workbook_are_refused_with_their_cell() {
    let bytes = old_tally(Old::Date(46_030.0));
    let error = import(vec![Input::of_bytes("a.xls", &bytes)], &Choices::default());
    let error = error.unwrap_err().to_string();
    assert!(
        error.starts_with("a.xls, sheet 'Survey', cell B5: the outside diameter is a date"),
        "{error}"
    );
}

#[test]
fn an_old_workbook_is_read() {
    let texts = ["Component", "OD (in)", "ID (in)", "Length (ft)"];
    let mut cells: Vec<(u16, u16, Old)> = texts
        .iter()
        .enumerate()
        .map(|(column, text)| (0, column as u16, Old::Text(text)))
        .collect();
    cells.extend([(1, 0, Old::Text("Bit")), (1, 1, Old::Text("8 1/2")), (1, 2, Old::Number(2.0))]);
    cells.extend([(1, 3, Old::Number(1.0)), (2, 0, Old::Text("DC")), (2, 1, Old::Number(6.5))]);
    cells.extend([(2, 2, Old::Number(2.25)), (2, 3, Old::Number(30.0))]);
    let imported = of_bytes("a.xls", &old_excel::workbook(&cells), &Choices::default());
    assert_snapshot!(string(&imported), @r#"
    [[string]]
    component = "Bit"
    od = "8.5 in"
    id = "2 in"
    length = "1 ft"

    [[string]]
    component = "DC"
    od = "6.5 in"
    id = "2.25 in"
    length = "30 ft"

    # Missing: the pipe above the topmost component: write it as the last [[string]], "to surface"
    # [[string]]
    # component = "drill pipe"
    # catalogue = "5 in 19.50 lb/ft S-135"
    # length = "to surface"
    "#);
    assert!(imported.text.contains("sheet 'Survey', cell B2: '8 1/2'"), "{}", imported.text);
}

#[test]
fn a_sheet_as_a_directional_driller_hands_it_over() {
    let imported = imported(
        "BHA Details,,,,,,,,\nItem,Description,Serial No,OD (in),ID (in),Max OD (in),Top Conn,Length \
         (m),Total Length (m)\n1,PDC Bit 12 1/4\",A123,12.250,3.000,12.25,6 5/8 Reg \
         Pin,0.35,0.35\n2,\"9 5/8\"\" Motor (1.15 deg bend)\",B1,9.625,6.25,12.125,6 5/8 Reg \
         Box,9.20,9.55\n3,String Stabilizer,C2,8.25,2.8125,12.125,6 5/8 Reg \
         Box,2.10,11.65\n4,\"8 1/4\"\" MWD\",D1,8.25,3.25,8.25,6 5/8 Reg Box,8.90,20.55\n5,\"12 x \
         5\"\" HWDP\",,5,3,6.5,NC50,112.4,132.95\n6,\"5\"\" DP 19.5# S-135\",,5,4.276,6.625,NC50,TO \
         SURFACE,\n",
    );
    assert_snapshot!(string(&imported), @r#"
    [[string]]
    component = "PDC Bit 12 1/4\" (bit)"
    od = "12.25 in"
    id = "3 in"
    length = "0.35 m"

    [[string]]
    component = "9 5/8\" Motor (1.15 deg bend)"
    od = "9.625 in"
    id = "6.25 in"
    length = "9.2 m"

    [[string]]
    component = "String Stabilizer"
    od = "8.25 in"
    id = "2.8125 in"
    length = "2.1 m"

    [[string]]
    component = "8 1/4\" MWD"
    od = "8.25 in"
    id = "3.25 in"
    length = "8.9 m"

    [[string]]
    component = "12 x 5\" HWDP"
    catalogue = "HWDP 5 in 49.3 lb/ft"
    length = "112.4 m"

    [[string]]
    component = "5\" DP 19.5# S-135"
    catalogue = "5 in 19.50 lb/ft S-135"
    length = "to surface"
    "#);
    assert_snapshot!(notes(&imported), @r#"
    read: the tally is read as listed, from the bit up: the bit, 'PDC Bit 12 1/4"', is in line 3
    read: '12 x 5" HWDP' is the catalogue's 'HWDP 5 in 49.3 lb/ft': od and id agree, and the case leaves them to it
    read: '5" DP 19.5# S-135' is the catalogue's '5 in 19.50 lb/ft S-135': od and id agree, and the case leaves them to it
    assumed: 'String Stabilizer': called a stabiliser or reamer, and without a gauge: it touches the wall with its body; give blade_od
    assumed: 'PDC Bit 12 1/4"', '9 5/8" Motor (1.15 deg bend)', 'String Stabilizer', '8 1/4" MWD': no weight; computed from the diameters as steel
    read: header in line 2, columns parted by commas
    read: component from 'Description'
    read: outside diameter from 'OD (in)' in in
    read: length from 'Length (m)' in m
    read: inside diameter from 'ID (in)' in in
    read: connection from 'Top Conn'
    read: number from 'Item'
    left out: the column 'Serial No'
    left out: the column 'Max OD (in)'
    left out: the column 'Total Length (m)'
    "#);
    assert_eq!(components(&imported).len(), 6);
}

#[test]
fn names_with_their_units_as_programs_write_them() {
    let imported = imported(
        "component,od_m,id_m,length_m,weight_kg_per_m,joint_od_m,joint_spacing_m,blade_od_m,\
         yield_strength_Pa,cumulative_length_m\nbit,0.2159,0.05,0.3,250,,,,,0.3\nstabiliser,0.1714,\
         0.07,2,150,,,0.2127,758000000,2.3\ndrill pipe,0.127,0.1086,2000,32.8,0.1683,9.6,,\
         930792228,2002.3\n",
    );
    assert_snapshot!(string(&imported), @r#"
    [[string]]
    component = "bit"
    od = "0.2159 m"
    id = "0.05 m"
    length = "0.3 m"
    mass_per_length = "250 kg/m"

    [[string]]
    component = "stabiliser"
    od = "0.1714 m"
    id = "0.07 m"
    length = "2 m"
    blade_od = "0.2127 m"
    mass_per_length = "150 kg/m"
    yield_strength = "758000000 Pa"

    [[string]]
    component = "drill pipe"
    od = "0.127 m"
    id = "0.1086 m"
    length = "to surface"
    joint_od = "0.1683 m"
    joint_spacing = "9.6 m"
    mass_per_length = "32.8 kg/m"
    yield_strength = "930792228 Pa"
    "#);
    let components = components(&imported);
    assert_eq!(components[2].yield_strength_Pa, Some(930_792_228.0));
    assert_eq!(components[2].joints.map(|joints| joints.spacing_m), Some(9.6));
}

#[test]
fn a_table_that_is_two_things_is_asked_about() {
    let text = "MD (m),Inc (deg),Azi (deg),Component,OD (in),ID (in),Length (m)\n0,0,0,Bit,8,2,1\n\
                9,0,0,DC,6,2,9\n";
    assert_snapshot!(refused(text), @"tally.csv: it holds 2 of the kind 'table': 'survey', 'tally'; pick one: --pick table=NAME");
    let survey = Choices::default().pick("table", "survey");
    assert!(of_bytes("a.csv", text.as_bytes(), &survey).text.contains("stations = ["));
    let tally = Choices::default().pick("table", "tally");
    assert_eq!(components(&of_bytes("a.csv", text.as_bytes(), &tally)).len(), 2);
}

#[test]
fn weights_at_the_surface_are_recognised() {
    let text = "Bit depth (m),Pick-up (kN),Slack-off (kN)\n1000,700,600\n2000,1000,800\n";
    let imported = imported(text);
    assert_eq!(imported.files[0].1, "weights and torques at 2 depths of the bit");
}

#[test]
fn many_rows_and_wide_lines_are_refused_in_time() {
    let start = std::time::Instant::now();
    let head = "Component,OD (in),ID (in),Length (ft)\n";
    let rows = head.to_owned() + &"DC 6 1/2 x y,6.5,2,30\n".repeat(30_000);
    assert!(refused(&rows).contains("at most 5000"), "{}", refused(&rows));
    let wide = "a  b  c  d  ".repeat(10_000) + "\n" + &"1  2  3  4\n".repeat(1000);
    let _ = import(vec![Input::of_bytes("a.txt", wide.as_bytes())], &Choices::default());
    // Names of which none is in the catalogue.
    let names: String = (0..4000).map(|i| format!("Tool 5 1/2 x {i} q{i} w,6.5,2,30\n")).collect();
    let bit_first = Choices::default().pick("order", "bit-first");
    let many = refused_with(&(head.to_owned() + &names), &bit_first);
    assert_snapshot!(many, @"tally.csv: it holds 4000 components; at most 500 are read");
    // A debug build on a busy machine; what is not linear in the file would take hours.
    assert!(start.elapsed().as_secs() < 60, "{:?}", start.elapsed());
}

/// A component of a random tally: OD and part of it as ID in 1/16 in, length in 0.01 ft, weight as
/// a part of the solid bar's.
fn component() -> impl Strategy<Value = (u32, u32, u32, f64)> {
    (40_u32..160, 3_u32..9, 100_u32..9000, 0.5_f64..0.95)
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(24) })]
    #[test]
    fn what_a_table_says_is_what_the_case_has(
        parts in prop::collection::vec(component(), 2..8), order in 0..2, as_workbook in 0..2,
    ) {
        let mut rows: Vec<[String; 5]> = Vec::new();
        let mut expected = Vec::new();
        for (index, (od, id, length, part)) in parts.iter().enumerate() {
            let od_in = f64::from(*od) / 16.0;
            let id_in = od_in * f64::from(*id) / 10.0;
            let id_in = (id_in * 1000.0).round() / 1000.0;
            let feet = f64::from(*length) / 100.0;
            let solid = 7860.0 * std::f64::consts::FRAC_PI_4 * 0.0254_f64.powi(2);
            let (ring, full) = (solid * (od_in * od_in - id_in * id_in), solid * od_in * od_in);
            let mass = ring + part * (full - ring) * 0.9;
            let pounds = (mass / 1.488_163_943_57 * 100.0).floor() / 100.0;
            let name = if index == 0 { "Bit".to_owned() } else { format!("Tool {}", "abcdefgh".chars().nth(index).unwrap()) };
            // Whole inches and sixteenths.
            let fraction = match od % 16 {
                0 => format!("{}", od / 16),
                sixteenths => format!("{} {sixteenths}/16", od / 16),
            };
            rows.push([name, fraction, format!("{id_in}"), format!("{feet:.2}"), format!("{pounds:.2}")]);
            expected.push((od_in * 0.0254, id_in * 0.0254, feet * 0.3048, pounds * 1.488_163_943_57));
        }
        if order == 1 {
            rows.reverse();
        }
        let head = ["Component", "OD (in)", "ID (in)", "Length (ft)", "Weight (lb/ft)"];
        let imported = if as_workbook == 1 {
            let mut sheet = Worksheet::new();
            header(&mut sheet, 0, &head);
            for (row, cells) in rows.iter().enumerate() {
                for (column, text) in cells.iter().enumerate() {
                    match text.parse::<f64>() {
                        Ok(number) => sheet.write(row as u32 + 1, column as u16, number).unwrap(),
                        Err(_) => sheet.write(row as u32 + 1, column as u16, text.as_str()).unwrap(),
                    };
                }
            }
            of_bytes("a.xlsx", &saved(vec![sheet]), &Choices::default())
        } else {
            let lines: Vec<String> = rows.iter().map(|row| row.join(";")).collect();
            imported(&format!("{}\n{}\n", head.join(";"), lines.join("\n")))
        };
        let components = components(&imported);
        prop_assert_eq!(components.len(), expected.len());
        let last = expected.len() - 1;
        for (index, (of, (od_m, id_m, length_m, mass))) in components.iter().zip(&expected).enumerate() {
            prop_assert!((of.od_m - od_m).abs() < 1e-9);
            prop_assert!((of.id_m - id_m).abs() < 1e-9);
            // Twelve digits are written.
            prop_assert!((of.mass_per_length_kg_per_m - mass).abs() < 1e-10 * mass);
            if index < last {
                prop_assert!((of.length_m - length_m).abs() < 1e-10 * length_m);
            }
        }
    }

    #[test]
    fn damaged_tallies_do_not_panic(at in 0..400_usize, byte in any::<u8>(), cut in 0..400_usize) {
        let mut bytes = include_bytes!("samples/own/tally.csv").to_vec();
        let at = at % bytes.len();
        bytes[at] = byte;
        bytes.truncate(bytes.len() - cut % bytes.len());
        let _ = import(vec![Input::of_bytes("a.csv", &bytes)], &Choices::default());
        let _ = contents(Input::of_bytes("a.csv", &bytes));
    }
}
