//! The order of the components, their lengths and joints.

use insta::assert_snapshot;
use wholestring_import::{Choices, Imported};

use crate::{components, imported, notes, of_bytes, refused, refused_with, string};

#[test]
fn the_order_is_found_by_the_bit_the_cumulative_length_or_the_numbers() {
    let tally = |rows: &str| {
        imported(&format!("No,Component,OD (in),ID (in),Length (ft),Cum. length (ft)\n{rows}"))
    };
    let order = |imported: &Imported| {
        let notes = notes(imported);
        notes.lines().find(|line| line.contains("the tally is")).unwrap().to_owned()
    };
    let by_bit = tally(",DP,5,4,TO SURFACE,\n,DC,6,2,30,31\n,Bit,8.5,2,1,1\n");
    assert_snapshot!(order(&by_bit), @"read: the tally is listed from the surface down, and reversed: the bit, 'Bit', is in line 4");
    assert!(components(&by_bit)[0].is_bit());
    let by_cumulative = tally(",DP,5,4,90,130\n,DC,6,2,30,40\n,Mill,8.5,2,10,10\n");
    assert_snapshot!(order(&by_cumulative), @"assumed: the tally is listed from the surface down, and reversed: the cumulative length decreases down the table, and counts from the bit");
    assert_eq!(components(&by_cumulative)[0].name, "Mill");
    let by_growing = tally(",Mill,8.5,2,10,10\n,DC,6,2,30,40\n,DP,5,4,90,130\n");
    assert_snapshot!(order(&by_growing), @"assumed: the tally is read as listed, from the bit up: the cumulative length increases down the table, and counts from the bit");
    let by_number = tally("3,DP,5,4,90,\n2,DC,6,2,30,\n1,Mill,8.5,2,10,\n");
    assert_snapshot!(order(&by_number), @"assumed: the tally is listed from the surface down, and reversed: the numbers count from the bit");
    assert_eq!(components(&by_number)[0].name, "Mill");
}

#[test]
fn an_order_that_nothing_tells_is_asked_for() {
    let text = "Component,OD (in),ID (in),Length (ft)\nDP,5,4,90\nDC,6,2,30\nMill,8.5,2,10\n";
    assert_snapshot!(refused(text), @"tally.csv: it is unknown which end of the tally is the bit's: no row is a bit, and neither a cumulative length nor numbers count from it; choose with --pick order=bit-first or --pick order=bit-last");
    let picked = |order: &str| Choices::default().pick("order", order);
    let last = of_bytes("a.csv", text.as_bytes(), &picked("bit-last"));
    assert_eq!(components(&last)[0].name, "Mill");
    let first = of_bytes("a.csv", text.as_bytes(), &picked("bit-first"));
    assert_eq!(components(&first)[0].name, "DP");
    assert_snapshot!(refused_with(text, &picked("up")), @"tally.csv: there is no order 'up'; it holds: 'bit-first', 'bit-last'");
    let within = "Component,OD (in),ID (in),Length (ft)\nDC,6,2,30\nBit,8.5,2,1\nDP,5,4,90\n";
    assert_snapshot!(refused(within), @"tally.csv, line 3: the bit, 'Bit', is neither first nor last; expected the components of one string, from the bit up or from the surface down (--pick order=bit-first or bit-last if it is not a bit)");
}

#[test]
fn cumulative_lengths_and_totals_are_held_against_the_lengths() {
    let tally = |cumulative: &str, total: &str| {
        imported(&format!(
            "Component,OD (in),ID (in),Length (ft),Cum. (ft)\nBit,8.5,2,0.85,0.85\nRSS,6.75,2,\
             13.6,14.45\nDC,6.5,2,30.90,{cumulative}\nTOTAL,,,{total},\n"
        ))
    };
    let checked = |imported: &Imported| {
        let notes = notes(imported);
        let checked =
            notes.lines().filter(|line| line.starts_with("checked") || line.starts_with("warning"));
        checked.collect::<Vec<_>>().join("\n")
    };
    assert_snapshot!(checked(&tally("45.35", "45.35")), @r"
    checked: the cumulative length agrees with the lengths in 3 rows
    checked: the total agrees with the lengths: 45.35 ft (line 5, column 'Length (ft)')
    ");
    assert_snapshot!(checked(&tally("54.35", "45.85")), @r"
    warning: THE CUMULATIVE LENGTH DIFFERS from the sum of the lengths: 54.35 ft (line 4, column 'Cum. (ft)') against 45.35 ft; the lengths are used
    warning: THE TOTAL DIFFERS from the sum of the lengths: 45.85 ft (line 5, column 'Length (ft)') against 45.35 ft
    ");
    // The last digit may be rounded.
    assert!(checked(&tally("45.36", "45.34")).contains("agrees"));
}

#[test]
fn lengths_of_several_joints_are_told_apart() {
    let tally = |rows: &str| {
        format!("Component,OD (in),ID (in),Jts,Length (ft),Cum (ft)\nBit,8.5,2,1,1,1\n{rows}")
    };
    let length = |imported: &Imported| components(imported)[1].length_m / 0.3048;
    let near = |imported: &Imported, feet: f64| assert!((length(imported) - feet).abs() < 1e-6);
    let top = "DP,5,4,,TO SURFACE,\n";
    near(&imported(&tally(&format!("DC,6.5,2,3,90.3,91.3\n{top}"))), 90.3);
    let each = imported(&tally(&format!("DC,6.5,2,3,30.1,91.3\n{top}")));
    near(&each, 90.3);
    assert!(notes(&each).contains("is that of each joint: the cumulative lengths confirm it"));
    near(&imported(&tally(&format!("DC,6.5,2,3,90.3,\n{top}"))), 90.3);
    let unclear = tally(&format!("DC,6.5,2,3,30.1,\n{top}"));
    assert_snapshot!(refused(&unclear), @"tally.csv, line 3: the length '30.1' of 3 joints may be that of all or of each, and no cumulative length decides; choose with --pick length=total or --pick length=each");
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

/// Two tallies, one below the other, are not one string, in whatever order.
#[test]
fn two_bits_are_two_strings() {
    let head = "Component,OD (in),ID (in),Length (ft)\n";
    let bha = "PDC bit,8.5,,1\nCollar,6.75,2.8,90\nDrill pipe,5,4.276,1000\n";
    for between in ["", head, "BHA 8,,,\nComponent,OD (in),ID (in),Length (ft)\n"] {
        let text = format!("{head}{bha}{between}{bha}");
        for order in [None, Some("bit-first")] {
            let choices = match order {
                Some(order) => Choices::default().pick("order", order),
                None => Choices::default(),
            };
            let error = refused_with(&text, &choices);
            assert!(error.contains("two rows are bits, 'PDC bit' in line 2"), "{error}");
        }
    }
    let metres = format!("{head}{bha}Component,OD (in),ID (in),Length (m)\nCollar,8,3,27\n");
    let error = refused(&metres);
    assert!(error.contains("the length is in 'ft' above and in 'm' from here on"), "{error}");
}
