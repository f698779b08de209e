//! Sheets as they are handed over, and as programs write them.

use insta::assert_snapshot;
use wholestring_import::Choices;

use crate::{components, imported, notes, of_bytes, refused, string};

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
    blade_od = "12.125 in"

    [[string]]
    component = "String Stabilizer"
    od = "8.25 in"
    id = "2.8125 in"
    length = "2.1 m"
    blade_od = "12.125 in"

    [[string]]
    component = "8 1/4\" MWD"
    od = "8.25 in"
    id = "3.25 in"
    length = "8.9 m"

    [[string]]
    component = "12 x 5\" HWDP"
    catalogue = "HWDP 5 in 49.3 lb/ft"
    length = "112.4 m"
    joint_od = "6.5 in"

    [[string]]
    component = "5\" DP 19.5# S-135"
    catalogue = "5 in 19.50 lb/ft S-135"
    length = "to surface"
    "#);
    assert_snapshot!(notes(&imported), @r#"
    read: the tally is read as listed, from the bit up: the bit, 'PDC Bit 12 1/4"', is in line 3
    read: '12 x 5" HWDP' is the catalogue's 'HWDP 5 in 49.3 lb/ft': od and id agree, and the case uses the catalogue's
    read: '5" DP 19.5# S-135' is the catalogue's '5 in 19.50 lb/ft S-135': od and id agree, and the case uses the catalogue's
    assumed: '9 5/8" Motor (1.15 deg bend)', 'String Stabilizer': the gauge is assumed for blades along the whole component; give blade_length if they are shorter
    assumed: 'PDC Bit 12 1/4"', '9 5/8" Motor (1.15 deg bend)', 'String Stabilizer', '8 1/4" MWD': no weight; computed from the diameters as steel
    read: header in line 2, columns separated by commas
    read: component from 'Description'
    read: outside diameter from 'OD (in)' in in
    read: length from 'Length (m)' in m
    read: inside diameter from 'ID (in)' in in
    read: gauge from 'Max OD (in)' in in
    read: connection from 'Top Conn'
    read: number from 'Item'
    left out: the column 'Serial No'
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

/// Blades are assumed along the whole component only where the tally gives no length of theirs.
#[test]
fn lengths_of_blades_are_not_assumed_where_they_are_given() {
    let table = |length: &str| {
        imported(&format!(
            "component,od_m,id_m,length_m,blade_od_m,blade_length_m\nbit,0.216,0.05,0.3,,\n\
             stabiliser,0.165,0.07,1.5,0.21,{length}\nDC,0.165,0.07,100,,\n"
        ))
    };
    let is_assumed = |length: &str| notes(&table(length)).contains("blades along the whole");
    assert!(!is_assumed("0.6"));
    assert!(is_assumed(""));
}

/// A joint of pipe has 5 to 16 m, which proves the unit of the lengths of several.
#[test]
fn joints_of_no_usual_length_are_warned_of() {
    let tally = |joints: &str, length: &str| {
        notes(&imported(&format!(
            "Component,Joints,OD (in),ID (in),Length (ft)\nBit,1,8.5,,0.85\nHWDP 5 \
             in,{joints},5,3,{length}\n"
        )))
    };
    let metres = tally("9", "84.22");
    assert!(
        metres.contains("9 joints in 84.22 ft are 9.358 ft each, and joints are 5 to 16 m long")
            && metres.contains("IS THE UNIT of the lengths m and not ft?"),
        "{metres}"
    );
    let many = tally("600", "180");
    assert!(many.contains("is the length or the number of joints wrong?"), "{many}");
    let usual = tally("9", "276.3");
    assert!(!usual.contains("IS THE UNIT") && !usual.contains("joints are 5 to"), "{usual}");
}

#[test]
fn a_bit_of_another_size_than_its_name_is_warned_of() {
    let tally = |bit_od: &str, gauge: &str| {
        notes(&imported(&format!(
            "Component,OD (in),ID (in),Gauge (in),Length (m)\n\"8 1/2\"\" PDC \
             Bit\",{bit_od},,,0.3\nStabiliser,6.5,2.8,{gauge},2\nDrill collar,6.5,2.8,,90\n"
        )))
    };
    let other = tally("6", "");
    assert!(other.contains("HAS A DIAMETER of 6 in, and its name begins with 8 1/2 in"), "{other}");
    let wide = tally("8.5", "9.875");
    assert!(
        wide.contains("9.875 in, is above that of the bit, 8.5 in: it does not fit in the hole"),
        "{wide}"
    );
    let sound = tally("8.5", "8.375");
    assert!(!sound.contains("HAS A DIAMETER") && !sound.contains("is above that"), "{sound}");
}
