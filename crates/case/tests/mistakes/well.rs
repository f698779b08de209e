//! Mistakes in `[well]`.

use crate::{
    common::{EXAMPLE, changed, read},
    each_refused, each_warned, refused, texts_refused, warned,
};

#[test]
fn hole() {
    each_refused(
        r#"
        hole_kind_unknown: `kind = "open"` -> `kind = "openhole"`
        diameter_in_metres_meant_millimetres: `"222.96 mm"` -> `222.96`
        diameter_negative: `"222.96 mm"` -> `"-222.96 mm"`
        friction_in_quotes: `friction = 0.3\n[[` -> `friction = "0.3"\n[[`
        friction_above_two: `friction = 0.3\n[[` -> `friction = 30\n[[`
        friction_around_negative: `friction = 0.3\n[[`
            -> `friction = { kinetic = 0.3, around = -0.1 }\n[[`
        friction_around_without_axial: `friction = 0.3\n[[`
            -> `friction = { kinetic = 0, around = 0.2 }\n[[`
        "#,
    );
}

/// Casings that cannot have been run, rock above a casing, and a bit that passes the bore of a casing but
/// not its drift.
#[test]
fn casing_programme() {
    let wide_bit = EXAMPLE
        .replace("diameter = \"222.96 mm\"", "casing = \"9-5/8 in 40 lb/ft\"")
        .replace("od = \"215.9 mm\"", "od = \"8-3/4 in\"")
        .replace("diameter = \"215.9 mm\"", "diameter = \"8-3/4 in\"");
    warned("warn_bit_over_drift", read(&wide_bit));
    let own_drift = wide_bit.replace("od = \"8-3/4 in\"", "od = \"8-1/2 in\"");
    assert!(read(&own_drift).expect("a valid case").warnings.is_empty());
    // A bit of exactly the drift passes, and one of exactly the bore does not: of a drift in the
    // case, and of that of the catalogue, 8.835 in less 5/32 in.
    let is_warned = |drift: &str, od: &str| {
        let casing = format!("40 lb/ft\"{drift}");
        let text = wide_bit.replace("40 lb/ft\"", &casing);
        let text = text.replace("8-3/4 in", od);
        let case = read(&text).unwrap_or_else(|report| panic!("{}", report.render(false)));
        case.warnings.render(false).contains("`bit` is wider than the drift")
    };
    for (drift, od, warned) in [
        ("\ndrift = \"8.525 in\"", "8.525 in", false),
        ("\ndrift = \"8.525 in\"", "8.5252 in", false),
        ("\ndrift = \"8.525 in\"", "8.526 in", true),
        ("", "8.679 in", false),
        ("", "8.68 in", true),
        ("", "8.835 in", true),
    ] {
        assert_eq!(is_warned(drift, od), warned, "{drift} {od}");
    }
    let special = wide_bit.replace("40 lb/ft\"", "40 lb/ft\"\ndrift = \"8.75 in\"");
    assert!(read(&special).expect("a valid case").warnings.is_empty());
    let wider = special.replace("drift = \"8.75 in\"", "drift = \"9 in\"");
    refused("drift_wider_than_its_bore", read(&wider));
    each_warned(
        r#"
        warn_open_hole_above_casing: `[[well.hole]]\nkind = "casing"`
            -> `[[well.hole]]\nkind = "open"\nto = "500 m"\ndiameter = "12-1/4 in"\nfriction = 0.3\n[[well.hole]]\nkind = "casing"`
        "#,
    );
    each_refused(
        r#"
        casing_wider_than_the_one_above: `[[well.hole]]\nkind = "open"`
            -> `[[well.hole]]\nkind = "casing"\nto = "3500 m"\ncasing = "13-3/8 in 72 lb/ft"\nfriction = 0.2\n[[well.hole]]\nkind = "open"`
        "#,
    );
}

/// A casing that is narrower than the one above it is taken as a liner, with a note; none on a
/// casing of other walls, on one whose upper end is given, and on open hole.
#[test]
fn liners() {
    let notes = |text: &str| {
        let case = read(text).expect("a valid case");
        assert!(case.warnings.is_empty(), "{}", case.warnings.render(false));
        case.hole_notes
    };
    let liner = "[[well.hole]]\nkind = \"casing\"\nto = \"3500 m\"\ncasing = \"9-5/8 in 40 lb/ft\"\nfriction = 0.2\n[[well.hole]]\nkind = \"open\"";
    let named = EXAMPLE
        .replace("diameter = \"222.96 mm\"", "casing = \"13-3/8 in 72 lb/ft\"")
        .replace("[[well.hole]]\nkind = \"open\"", liner);
    assert_eq!(
        notes(&named),
        ["9-5/8 in casing is taken from 2986.53 m down, as a liner is; where it reaches the \
             surface, leave out the sections above it; where it is a liner, from = \"2986.53 m\" in \
             its section confirms it"]
    );
    let bores = named
        .replace("casing = \"13-3/8 in 72 lb/ft\"", "diameter = \"313.6 mm\"")
        .replace("casing = \"9-5/8 in 40 lb/ft\"", "diameter = \"224.4 mm\"");
    let [note] = &notes(&bores)[..] else { panic!("one note") };
    assert!(note.starts_with("casing with a bore of 224.4 mm is taken from 2986.53 m"), "{note}");
    for silent in [
        EXAMPLE.to_owned(),
        named.replace("to = \"3500 m\"", "from = \"2986.53 m\"\nto = \"3500 m\""),
        named.replace("13-3/8 in 72 lb/ft", "9-5/8 in 47 lb/ft"),
    ] {
        assert_eq!(notes(&silent), [""; 0], "{silent}");
    }
}

#[test]
fn roughness() {
    each_refused(
        r#"
        roughness_in_metres_meant_millimetres: `[mud]` -> `[well.roughness]\nrms = 2\n[mud]`
        roughness_too_steep: `[mud]` -> `[well.roughness]\ntortuosity = "20 cm"\n[mud]`
        roughness_band_upside_down: `[mud]`
            -> `[well.roughness]\nrms = "1 mm"\nshortest_wavelength = "20 m"\nlongest_wavelength = "2 m"\n[mud]`
        roughness_key_misspelt: `[mud]`
            -> `[well.roughness]\nrms = "1 mm"\nwavelength = "20 m"\n[mud]`
        "#,
    );
    each_warned(
        r#"
        warn_section_roughness: `friction = 0.3\n[[` -> `friction = 0.3\nroughness = 0\n[[`
        warn_roughness_without_amplitude: `[mud]` -> `[well.roughness]\nseed = 4\n[mud]`
        warn_roughness_closes_in: `[mud]` -> `[well.roughness]\nrms = "9 mm"\n[mud]`
        "#,
    );
}

#[test]
fn tortuosity() {
    each_refused(
        r#"
        tortuosity_kind_unknown: `[mud]`
            -> `[well.tortuosity]\nkind = "cosine"\namplitude = 0.5\n[mud]`
        tortuosity_of_a_length: `[mud]` -> `[well.tortuosity]\namplitude = "5 mm"\n[mud]`
        tortuosity_too_sharp: `[mud]`
            -> `[well.tortuosity]\namplitude = "9 deg"\nperiod = "2 m"\n[mud]`
        tortuosity_upside_down: `[mud]`
            -> `[well.tortuosity]\namplitude = 0.5\nfrom = "2000 m"\nto = "1000 m"\n[mud]`
        tortuosity_beyond_the_survey: `[mud]`
            -> `[well.tortuosity]\namplitude = 0.5\nfrom = "5000 m"\n[mud]`
        tortuosity_of_many_stations: `[mud]`
            -> `[well.tortuosity]\nkind = "helical"\namplitude = 0.1\nperiod = "1 m"\n[mud]`
        tortuosity_key_misspelt: `[mud]`
            -> `[well.tortuosity]\namplitude = 0.5\nwavelength = "20 m"\n[mud]`
        "#,
    );
    each_warned(
        r#"
        warn_tortuosity_without_amplitude: `[mud]` -> `[well.tortuosity]\nperiod = "100 m"\n[mud]`
        warn_tortuosity_seed: `[mud]`
            -> `[well.tortuosity]\nkind = "helical"\namplitude = 0.5\nperiod = "40 m"\nseed = 4\n[mud]`
        warn_tortuosity_of_a_survey: `[mud]`
            -> `[well.tortuosity]\namplitude = 0.5\nperiod = "800 m"\n[mud]`
        "#,
    );
}

#[test]
fn sections() {
    each_refused(
        r#"
        hole_short_of_bit: `to = "4305 m"` -> `to = "4300 m"`
        hole_sections_not_downwards: `to = "4305 m"` -> `to = "2900 m"`
        hole_sections_overlap: `to = "4305 m"` -> `from = "2900 m"\nto = "4305 m"`
        hole_sections_with_gap: `to = "4305 m"` -> `from = "3000 m"\nto = "4305 m"`
        static_friction_below_kinetic: `friction = 0.3\n[[`
            -> `friction = { kinetic = 0.3, static = 0.2 }\n[[`
        "#,
    );
}

#[test]
fn stations() {
    let stations = |rows: &str| {
        changed(
            "survey = \"np13-x1042-survey.csv\"      # md, inc, azi; unit row or units in the header; CSV or Excel",
            &format!("stations = {rows}"),
        )
    };
    texts_refused([
        (
            "survey_twice",
            changed("path = \"spline\"", "stations = [[0, 0, 0], [5000, 0, 0]]\npath = \"spline\""),
        ),
        (
            "stations_run_backwards",
            stations("[[0, 0, 0], [900, 10, 0], [600, 20, 0], [4305, 20, 0]]"),
        ),
        ("station_with_two_numbers", stations("[[0, 0, 0], [900, 10], [4305, 20, 0]]")),
        ("station_with_one_number", stations("[[0, 0, 0], [900], [4305, 20, 0]]")),
        ("station_without_azimuth", stations("[[0, 0, 0], [900, 10, nan], [4305, 20, 0]]")),
        ("station_alone", stations("[[4305, 0, 0]]")),
        ("station_inclination", stations("[[0, 0, 0], [900, 190, 0], [4305, 20, 0]]")),
        ("station_bend", stations("[[0, 0, 0], [900, 0, 0], [900.5, 30, 0], [4305, 30, 0]]")),
    ]);
}

#[test]
fn one_section_in_single_brackets() {
    let (before, after) = EXAMPLE.split_once("[[well.hole]]").expect("a section");
    let (_, after) = after.split_once("[[well.hole]]").expect("a second section");
    let one = format!("{before}[well.hole]{after}");
    refused("one_hole_in_single_brackets", read(&one));
}

/// A vertical station needs no azimuth: left out, `nan`, or a null of databases.
#[test]
fn vertical_stations_need_no_azimuth() {
    let stations = |rows: &str| {
        changed(
            "survey = \"np13-x1042-survey.csv\"      # md, inc, azi; unit row or units in the header; CSV or Excel",
            &format!("stations = {rows}"),
        )
    };
    let azimuths = |case: &wholestring_case::Case| case.settings["well"]["stations"].clone();
    let full = read(&stations("[[0, 0, 0], [900, 0, 0], [4305, 20, 30]]")).expect("a valid case");
    for rows in [
        "[[0, 0], [900, 0], [4305, 20, 30]]",
        "[[0, 0, nan], [900, 0, nan], [4305, 20, 30]]",
        "[[0, 0, -999.25], [900, 0, -9999], [4305, 20, 30]]",
    ] {
        let case =
            read(&stations(rows)).unwrap_or_else(|report| panic!("{}", report.render(false)));
        assert_eq!(azimuths(&case), azimuths(&full), "{rows}");
        let note = "the azimuth of 2 stations, vertical and without one, is taken as 0";
        assert!(
            case.survey_notes.iter().any(|found| found.contains(note)),
            "{:?}",
            case.survey_notes
        );
    }
}
