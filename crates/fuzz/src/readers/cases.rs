//! Cases, `--set` and `--vary`, studies, tables of bits, and quantities.

use wholestring_case::{InMemory, Override, Report, Variation, parse};
use wholestring_cases::{HORIZONTAL, ISCWSA_04, NP13_X1042, NP13_X1042_ROCK, SLANT, VERTICAL};
use wholestring_study::{self as study, ColumnName, Source};
use wholestring_units::Dimension;

use super::reader::{New, Reader};

/// The readers of this file.
pub(super) const READERS: &[(&str, New)] = &[
    ("case", case),
    ("override", overrides),
    ("vary", vary),
    ("study", study),
    ("bit-table", bit_table),
    ("quantity", quantity),
];

/// Words of cases and studies.
fn words() -> Vec<&'static str> {
    let words = r#"
        [ ] [[ ]] { } = , . " ' """ # true [well] [[well.hole]] [[string]] [operation] [dynamics]
        [rig] [mud] [bit] [rock] [bit.face] [bit_test] [hoist] [records] [[schedule]] "open" "nan"
        "soft" "dynamic" "rock" "table" "regenerative" friction survey_unit stations catalogue
        length joint_od bend eccentricity element_length duration
    "#;
    let others = [
        "\n",
        "\"to surface\"",
        "\"5 in\"",
        "\"9 5/8\\\"\"",
        "\"1e3 m\"",
        "\"-1 ft\"",
        "\"0 kN\"",
        "\"1e-305 N.m\"",
        "\"12 ppg\"",
        "é",
        "\u{feff}",
        "\u{0}",
    ];
    words.split_whitespace().chain(others).collect()
}

fn files() -> InMemory {
    let files = [NP13_X1042, ISCWSA_04].into_iter().flat_map(|case| case.beside);
    InMemory(files.map(|(name, text)| ((*name).to_owned(), text.as_bytes().to_vec())).collect())
}

/// Whether a text is accepted; a report is printed too, which must cut its lines at character
/// boundaries.
fn printed<T>(read: Result<T, Report>) -> bool {
    match read {
        Ok(_) => true,
        Err(report) => {
            assert!(!report.render(false).is_empty());
            assert!(!report.render(true).is_empty());
            false
        }
    }
}

/// Case files.
fn case() -> Reader {
    let files = files();
    let seeds = [VERTICAL, SLANT, HORIZONTAL, NP13_X1042, ISCWSA_04, NP13_X1042_ROCK];
    let seeds = seeds.map(|case| case.text.as_bytes());
    Reader::text("case", seeds, &words(), move |input| {
        printed(parse("case.toml", input, &files, &[]).inspect(|case| {
            case.warnings.render(false);
        }))
    })
}

/// `--set`: one argument per line.
fn overrides() -> Reader {
    let seeds: [&[u8]; 3] = [
        b"well.hole.0.friction=0.1\noperation.bit_depth = 300m\nrpm=120",
        b"friction=0.3\nwob=50kN\nmud.density=\"9.5 ppg\"\ndynamics.seed=7",
        b"operation.kind=[\"drill\", \"slide\"]\nmodel=soft\nmesh.element_length=9.6 \
         m\nrig.top_drive_torque=45 kN.m",
    ];
    Reader::text("override", seeds, &words(), |input| {
        let text = String::from_utf8_lossy(input);
        let changes: Result<Vec<Override>, _> =
            text.lines().filter(|line| !line.trim().is_empty()).map(str::parse).collect();
        match changes {
            Ok(changes) => printed(parse(
                "case.toml",
                VERTICAL.text.as_bytes(),
                &InMemory::default(),
                &changes,
            )),
            Err(error) => error.to_string().is_empty(),
        }
    })
}

/// `--vary`: one argument per line.
fn vary() -> Reader {
    let seeds: [&[u8]; 4] = [
        b"friction=0.1,0.2,0.3\nbit_depth=300m..1500m/300m",
        b"rpm=60..120/20\noperation.rop=10 m/h..20 m/h/5 m/h",
        b"well.path=spline,minimum-curvature\nwob=1tf,2 tf",
        b"operation.kind=[\"drill\"],[\"slide\"]\nname=\"x,y\",z",
    ];
    Reader::text("vary", seeds, &words(), |input| {
        let text = String::from_utf8_lossy(input);
        let arguments: Vec<String> = text.lines().map(str::to_owned).collect();
        let read = Variation::read_all(&arguments);
        if let Ok(variations) = &read {
            let first: Vec<Override> =
                variations.iter().filter_map(|varied| varied.values.first().cloned()).collect();
            printed(parse("case.toml", VERTICAL.text.as_bytes(), &InMemory::default(), &first));
        }
        printed(read)
    })
}

const COLUMNS: [ColumnName; 6] = {
    const fn column(source: Source, name: &'static str, dimension: Dimension) -> ColumnName {
        ColumnName { source, name, dimension: Some(dimension) }
    }
    [
        column(Source::Summary, "hook_load_N", Dimension::Force),
        column(Source::Summary, "surface_torque_N_m", Dimension::Torque),
        column(Source::Summary, "bit_depth_m", Dimension::Length),
        column(Source::Nodes, "md_m", Dimension::Length),
        column(Source::Nodes, "tension_N", Dimension::Force),
        column(Source::Time, "time_s", Dimension::Time),
    ]
};

/// Study files.
fn study() -> Reader {
    let seeds: [&[u8]; 2] = [
        b"name = \"Friction\"\n[[sweep]]\nname = \"friction\"\ncase = \"slant.toml\"\nvary = { \
         friction = [0.1, 0.2], bit_depth = \"300m..900m/300m\" }\n",
        b"[[sweep]]\nname = \"a\"\ncase = \"slant.toml\"\nset = { model \
         = \"soft\", \"operation.kind\" = \"drill\" }\nvary = { friction = \"0.1..0.4/0.1\" }\n",
    ];
    let mut reader = Reader::text("study", seeds, &words(), |input| {
        printed(study::parse("study.toml", input, &COLUMNS))
    });
    reader.seeds.retain(|seed| study::parse("study.toml", seed, &COLUMNS).is_ok());
    reader
}

/// The file of a bit's table.
fn bit_table() -> Reader {
    let case = VERTICAL.text.replace(
        "[bit]\ntorque = \"2.5 kN.m\"",
        "[bit]\nlaw = \"table\"\n[bit.table]\nfile = \"bit-table.csv\"",
    );
    // Sliding requires a motor.
    let case = case.replace(", \"slide\"]", "]");
    let seeds: [&[u8]; 2] = [
        b"weight_on_bit_N,rotary_speed_rpm,rate_of_penetration_m_per_h,torque_N_m\n20000,60,4,1000\n20000,120,8,1000\n60000,60,12,3000\n60000,120,24,3000\n",
        b"rotary_speed_rpm,weight_on_bit_N,torque_N_m,rate_of_penetration_m_per_h,torque_std_N_m,weight_on_bit_std_N\n90,60000,3000,12,300,2000\n90,20000,1000,4,300,2000\n",
    ];
    Reader::text("bit-table", seeds, &[",", "\n", "\"", ";", "torque_N_m"], move |input| {
        let mut files = InMemory::default();
        files.0.insert("bit-table.csv".to_owned(), input.to_vec());
        printed(parse("case.toml", case.as_bytes(), &files, &[]))
    })
}

/// Numbers with units, and units.
fn quantity() -> Reader {
    let seeds: [&[u8]; 8] = [
        b"5-1/2 in",
        "8½\"".as_bytes(),
        b"1500.5 kN.m",
        b"-1.5e3 ftKB",
        b"9.5 ppg",
        "3 °/30 m".as_bytes(),
        b"120 klbf",
        b"0.3 Pa.s^n",
    ];
    let words = &[
        "m", "ft", "in", "kN", "lbf", "klbf", "psi", "MPa", "deg", "rad", "rpm", "/", "-", ".",
        "·", "²", "½", "\"", "'", " ", "\u{a0}", "e", "MD", "RKB", "K", "per",
    ];
    Reader::text("quantity", seeds, words, |input| {
        let text = String::from_utf8_lossy(input);
        let mut accepted = false;
        for dimension in Dimension::ALL {
            match dimension.parse(&text) {
                Ok(value) => {
                    accepted = true;
                    assert!(!value.is_nan(), "not a number is accepted");
                }
                Err(error) => assert!(!error.to_string().is_empty()),
            }
            dimension.find_unit(&text);
        }
        accepted
    })
}
