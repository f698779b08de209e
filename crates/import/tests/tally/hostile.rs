//! Large, random or damaged tables.

use insta::assert_snapshot;
use proptest::prelude::*;
use rust_xlsxwriter::Worksheet;
use wholestring_import::{Choices, Input, contents, import};

use crate::{PLAIN, components, header, imported, of_bytes, refused, refused_with, saved};

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
    // The limit allows for a debug build on a busy machine; an algorithm that is not linear in the
    // file would take hours.
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
        for (index, (component, (od_m, id_m, length_m, mass))) in
            components.iter().zip(&expected).enumerate()
        {
            prop_assert!((component.od_m - od_m).abs() < 1e-9);
            prop_assert!((component.id_m - id_m).abs() < 1e-9);
            // Twelve digits are written.
            prop_assert!((component.mass_per_length_kg_per_m - mass).abs() < 1e-10 * mass);
            if index < last {
                prop_assert!((component.length_m - length_m).abs() < 1e-10 * length_m);
            }
        }
    }

    #[test]
    fn damaged_tallies_do_not_panic(at in 0..400_usize, byte in any::<u8>(), cut in 0..400_usize) {
        let mut bytes = include_bytes!("../samples/own/tally.csv").to_vec();
        let at = at % bytes.len();
        bytes[at] = byte;
        bytes.truncate(bytes.len() - cut % bytes.len());
        let _ = import(vec![Input::of_bytes("a.csv", &bytes)], &Choices::default());
        let _ = contents(Input::of_bytes("a.csv", &bytes));
    }
}

/// A comma of thousands that also separates the columns would move the weight under another
/// heading.
#[test]
fn a_row_with_more_cells_than_the_header_is_refused() {
    let cut = PLAIN.replace("2.25,30,99.5", "2.25,1,230,99.5");
    assert_snapshot!(refused(&cut), @"tally.csv, line 3, column 17: 6 cells in this row, but the header has 5 columns: '1' and '230' look like one number with thousands; numbers with a separator of thousands need quotation marks, or another separator between the columns, such as semicolons");
    let trailing = PLAIN.replace("99.5", "99.5,,");
    assert_eq!(components(&imported(&trailing)).len(), 3);
}
