//! Properties of a component: its weight, its pipe in the catalogue, its blades.

use insta::assert_snapshot;

use crate::{components, imported, notes, refused, string};

#[test]
fn a_weight_may_be_per_length_or_of_the_whole_and_a_force() {
    let tally = |heading: &str, weight: &str| {
        format!(
            "Component,OD (in),ID (in),Length (ft),{heading}\nBit,8.5,2,1,\nDC,6.5,2.25,30,{weight}\n\
             DP,5,4.276,TO SURFACE,\n"
        )
    };
    let mass = |text: &str| components(&imported(text))[1].mass_per_length_kg_per_m;
    let near = |text: &str, kg_per_m: f64| assert!((mass(text) - kg_per_m).abs() < 0.01, "{text}");
    near(&tally("Weight (lb/ft)", "99.5"), 148.07);
    near(&tally("Weight [ppf]", "99.5"), 148.07);
    near(&tally("Wt lbs/ft", "99.5"), 148.07);
    near(&tally("Weight (kg/m)", "148.07"), 148.07);
    near(&tally("Weight (kN/m)", "1.452"), 148.06);
    near(&tally("Total weight (lb)", "2985"), 148.07);
    near(&tally("Weight (klb)", "2.985"), 148.07);
    near(&tally("Weight (lbs)", "2985"), 148.07);
    near(&tally("Weight", "99.5 lb/ft"), 148.07);
    assert_snapshot!(refused(&tally("Weight (lbs)", "99.5")), @"tally.csv, line 3, column 'Weight (lbs)': the weight per length 3.3167 lb/ft of 'DC' is out of range; expected about the 99.5 lb/ft of its body or more (is the column the weight per length, and in the right unit?)");
    assert_snapshot!(refused(&tally("Weight (kg/m)", "500")), @"tally.csv, line 3, column 'Weight (kg/m)': the weight per length 500 kg/m of 'DC' is out of range; expected at most the 168.3 kg/m of a solid bar of 165.1 mm");
    assert_snapshot!(refused(&tally("Weight (furlong)", "500")), @"tally.csv, line 1, column 39: 'furlong' is not a unit of mass per length; expected kg/m, lb/ft, t/m");
    let both = imported(
        "Component,OD (in),ID (in),Length (ft),Weight (lb/ft),Total weight (lb)\nBit,8.5,2,1,,\n\
         DC,6.5,2.25,30,99.5,3300\nDP,5,4.276,TO SURFACE,,\n",
    );
    assert!(notes(&both).contains("THE WEIGHTS of 'DC' DIFFER: 99.5 lb/ft per length against"));
}

#[test]
fn pipe_that_the_catalogue_has_is_named_if_its_diameters_agree() {
    let tally = |name: &str, id: &str| {
        imported(&format!(
            "Component,OD (in),ID (in),Jts,Length (ft),Connection,Grade\nBit,8.5,2,1,1,,\n{name},5,{id},\
             ,TO SURFACE,HT50,S-135\n"
        ))
    };
    let listed = tally("DP 5in 19.50# S-135", "4.28");
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
    read: 'DP 5in 19.50# S-135' is the catalogue's '5 in 19.50 lb/ft S-135': od and id agree, and the case uses the catalogue's
    left out: the connection HT50 of 'DP 5in 19.50# S-135': the case has the catalogue's NC50; where tool joints or their torques matter, give joint_od and make_up_torque
    assumed: 'Bit': no weight; computed from the diameters as steel
    read: header in line 1, columns separated by commas
    read: component from 'Component'
    read: outside diameter from 'OD (in)' in in
    read: length from 'Length (ft)' in ft
    read: inside diameter from 'ID (in)' in in
    read: number of joints from 'Jts'
    read: connection from 'Connection'
    read: grade from 'Grade'
    ");
    let other = tally("DP 5in 19.50# S-135", "4.0");
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
    joint_spacing = "31.5 ft"
    mass_per_length = "22 lb/ft"
    "#);
    assert_snapshot!(notes(&imported), @r"
    assumed: the length (line 3, column 'Length (ft)') is that of all joints: divided by their number it is the length of a joint
    read: the tally is read as listed, from the bit up: the bit, 'Bit', is in line 2
    assumed: 'Pipe above': a tool joint every 31.5 ft, as in range 2
    assumed: 'Bit': no weight; computed from the diameters as steel
    left out: the grade '4145H' of 'Pipe above' (line 4, column 'Grade'): its yield strength is not known; give yield_strength
    read: header in line 1, columns separated by commas
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
    assert_snapshot!(row("DC,6,2,TO SURFACE\nDP,5,4,90"), @"tally.csv, line 3: 'DC' reaches to the surface, and 'DP' is above it; only the topmost component can");
    assert_snapshot!(row("DC,six,2,30"), @"tally.csv, line 3, column 4: 'six' is not a number; the outside diameter was expected");
    assert_snapshot!(row("DC,6 furlongs,2,30"), @"tally.csv, line 3, column 4: 'furlongs' is not a unit of diameter; expected mm, in, m, cm, ft, km, yd, usft");
    assert_snapshot!(refused("Component,ID (in),Length (ft),Weight (lb/ft)\nBit,2,1,\n"), @"tally.csv, line 1, column 1: no column of outside diameter; the header has: 'Component', 'ID (in)', 'Length (ft)', 'Weight (lb/ft)'");
    assert_snapshot!(refused("Component,OD (in),ID (in),Length (ft)\n"), @"tally.csv, line 1, column 1: no component follows the header; the components of a string were expected, under a header such as 'Component, OD (in), ID (in), Length (ft), Weight (lb/ft)'");
}

#[test]
fn stabilisers_have_blades() {
    let tally = |gauge: &str| {
        format!(
            "Component,OD (in),ID (in),Gauge (in),Length (ft)\nBit,6.5,2,8.5,1\nStab,6.75,2.8,{gauge},6\nDP,5,4,,TO SURFACE\n"
        )
    };
    let imported = imported(&tally("8 3/8"));
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
    assert_snapshot!(refused(&tally("6.5")), @"tally.csv, line 3, column 'Gauge (in)': the gauge of 'Stab' 6.5 in is out of range; expected its outside diameter, 6.75 in, or more");
    assert!(!string(&crate::imported(&tally("0"))).contains("blade_od"));
}

/// A weight equal to the one in the pipe's name is its nominal weight, without tool joints. The
/// catalogue's value is used instead, 22.0 lb/ft, and 25.7 lb/ft with the 7-1/2 in joints of S-135
/// (API RP 7G: 24 to 26, depending on the joint). Without an entry the tally's value remains, with
/// a note.
#[test]
fn a_nominal_weight_is_told_from_the_weight() {
    let head =
        "Component,OD (in),ID (in),Length (ft),Weight (lb/ft)\nBit,8.5,,1,\nDC,6.5,2.8125,181,91\n";
    for (row, weights) in [
        ("DP 5in 19.50 S-135,5,4.276,9400,19.5\n", 21.4..22.7),
        ("\"5-1/2\"\" DP 21.90# S-135\",5.5,4.778,9400,21.9\n", 24.0..26.5),
    ] {
        let found = imported(&format!("{head}{row}"));
        let pipe = string(&found);
        let pipe = pipe.rsplit("[[string]]").next().unwrap_or_default();
        assert!(!pipe.contains("mass_per_length"), "{pipe}");
        assert!(notes(&found).contains("NOMINAL WEIGHT"), "{}", notes(&found));
        let mass = components(&found)[2].mass_per_length_kg_per_m / (0.453_592_37 / 0.3048);
        assert!(weights.contains(&mass), "{mass}");
    }
    let bare = imported(&format!("{head}Drill pipe,5,4.276,9400,19.5\n"));
    assert!(string(&bare).contains("mass_per_length = \"19.5 lb/ft\""));
    assert!(notes(&bare).contains("NOMINAL WEIGHT"), "{}", notes(&bare));
    let right = imported(&format!("{head}DP 5in 19.50 S-135,5,4.276,9400,22.4\n"));
    assert!(!notes(&right).contains("NOMINAL"), "{}", notes(&right));
}

/// The largest diameter of a bit is its gauge, that of a stabiliser is over its blades, and that of
/// a pipe is over its tool joints.
#[test]
fn the_widest_diameter_is_the_gauge() {
    for heading in ["Max OD", "Maximum OD", "Blade/Gauge OD", "Gauge OD"] {
        let found = imported(&format!(
            "Element,{heading} (in),OD (in),ID (in),Length (ft)\nPDC Bit,8.5,6.25,2,0.9\nNB Stab,8.375,6.5,\
             2.25,5.1\nMWD Collar,6.75,6.75,3.25,31.2\nIBS,8.25,6.5,2.8,5.4\nDP,6.625,5,4.276,8000\n"
        ));
        let parts = components(&found);
        let inches = |m: f64| (m / 0.0254 * 1e4).round() / 1e4;
        assert_eq!(inches(parts[0].od_m), 8.5, "{heading}");
        let blades = |at: usize| parts[at].blades.map(|blades| inches(blades.od_m));
        assert_eq!([blades(1), blades(2), blades(3)], [Some(8.375), None, Some(8.25)], "{heading}");
        assert_eq!(parts[4].joints.map(|joints| inches(joints.od_m)), Some(6.625), "{heading}");
    }
}

/// Grades of API Spec 5CT; an unknown grade has one note, however many components have it.
#[test]
fn grades_of_casing_are_known() {
    let tally = |grade: &str| {
        imported(&format!(
            "Description,OD (in),ID (in),Weight (ppf),Grade,Length (m),Cum Length (m)\nFloat shoe,9.625,8.681,47,{grade},0.55,0.55\n\
             Csg jt,9.625,8.681,47,{grade},12.37,12.92\nCollar,9.625,8.681,47,{grade},0.42,13.34\nCsg jt,9.625,8.681,47,{grade},12.6,25.94\n"
        ))
    };
    let known = tally("L-80");
    assert!(string(&known).contains("yield_strength = \"80000 psi\""), "{}", string(&known));
    assert!(!notes(&known).contains("is not known"), "{}", notes(&known));
    let unknown = notes(&tally("XQ-77"));
    assert_eq!(unknown.matches("its yield strength is not known").count(), 1, "{unknown}");
    assert!(unknown.contains("'Float shoe' (line 2, column 'Grade') and"), "{unknown}");
}

#[test]
fn a_casing_programme_is_no_string() {
    let head = "Component,OD (in),ID (in),Length (m),Cum Length (m)\n";
    let programme = imported(&format!(
        "{head}Production,9.625,8.681,3000,3000\nIntermediate,13.375,12.347,1500,4500\nSurface,20,18.73,600,5100\n"
    ));
    assert!(notes(&programme).contains("casing programme"), "{}", notes(&programme));
    let string =
        imported(&format!("{head}Shoe joint,9.625,8.681,12,12\nCasing,9.625,8.681,1500,1512\n"));
    assert!(!notes(&string).contains("casing programme"), "{}", notes(&string));
}

/// The weight in the name of a pipe is nominal, whatever its bore.
#[test]
fn a_weight_that_is_in_the_name_is_nominal() {
    let tally = |name: &str, weight: &str| {
        imported(&format!(
            "Item,OD (in),ID (in),Length (m),Wt (ppf)\nPDC bit,8.5,,0.3,\n\
             {name},5.875,5.045,2900,{weight}\n"
        ))
    };
    for name in ["5-7/8 DP 23.40# S-135", "5-7/8 DP 23.4 lb/ft"] {
        let found = tally(name, "23.4");
        assert!(notes(&found).contains("is the one in its name"), "{}", notes(&found));
    }
    let with_joints = tally("5-7/8 DP 23.40# S-135", "27.4");
    assert!(!notes(&with_joints).contains("NOMINAL"), "{}", notes(&with_joints));
}
