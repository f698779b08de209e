//! Mistakes in `[operation]`.

use wholestring_case::schema;

use crate::{
    common::{changed, read, schema_check::problems},
    each_refused, each_warned, warned,
};

#[test]
fn kind() {
    each_refused(
        r#"
        operation_misspelt: `kind = "drill"` -> `kind = "driling"`
        operation_unknown: `kind = "drill"` -> `kind = "cementing"`
        operation_listed_twice: `kind = "drill"` -> `kind = ["drill", "slide", "drill"]`
        operations_empty: `kind = "drill"` -> `kind = []`
        "#,
    );
}

#[test]
fn set_points() {
    each_refused(
        r#"
        wob_missing: `wob = "6 tf"` -> ``
        rpm_missing: `rpm = 70                              # rev/min\n` -> ``
        rpm_too_large: `rpm = 70 ` -> `rpm = 70000 `
        rpm_zero_while_drilling: `rpm = 70 ` -> `rpm = 0 `
        rop_missing: `rop = "10 m/h"` -> `# rop = "10 m/h"`
        bit_depth_negative: `bit_depth = "4305 m"` -> `bit_depth = "-4305 m"`
        bit_depth_zero: `bit_depth = "4305 m"` -> `bit_depth = 0`
        "#,
    );
    each_warned(
        r#"
        warn_weight_on_bit: `wob = "6 tf"` -> `wob = "200 tf"`
        warn_bit_pull_on_bottom: `wob = "6 tf"` -> `wob = "6 tf"\nbit_pull = "200 kN"`
        "#,
    );
    warned(
        "warn_projection",
        read(
            &changed("bit_depth = \"4305 m\"", "bit_depth = \"4400 m\"")
                .replace("to = \"4305 m\"", "to = \"4500 m\""),
        ),
    );
}

/// Drillers' words, each for its own operation; half a word for none.
#[test]
fn words_of_drillers() {
    let schema = schema();
    for (word, name) in [
        ("pick-up", "trip_out"),
        ("Pick Up", "trip_out"),
        ("pickup", "trip_out"),
        ("tripping out", "trip_out"),
        ("TRIP-OUT", "trip_out"),
        ("POOH", "trip_out"),
        ("pulling out of hole", "trip_out"),
        ("slack-off", "trip_in"),
        ("slack off", "trip_in"),
        ("tripping in", "trip_in"),
        ("RIH", "trip_in"),
        ("running in hole", "trip_in"),
        ("rotating off bottom", "rotate_off_bottom"),
        ("rotate off-bottom", "rotate_off_bottom"),
        ("drilling", "drill"),
        ("rotating on bottom", "drill"),
        ("sliding", "slide"),
        ("slide drilling", "slide"),
        ("reaming", "ream"),
        ("ream in", "ream"),
        ("back-reaming", "back_ream"),
        ("backreaming", "back_ream"),
        ("ream out", "back_ream"),
        ("trIp_in", "trip_in"),
        (" Drill_", "drill"),
        ("Pulling  out_of-hole", "trip_out"),
    ] {
        let text = changed("kind = \"drill\"", &format!("kind = \"{word}\""));
        assert_eq!(problems(&schema, &text), Vec::<String>::new(), "{word}");
        let case = read(&text).unwrap_or_else(|report| panic!("{word}: {report}"));
        assert_eq!(case.operations[0].kind.name(), name, "{word}");
    }
    for word in ["dr ill", "drill.", "POOHS", "tr\u{131}p_in", ""] {
        let text = changed("kind = \"drill\"", &format!("kind = \"{word}\""));
        assert!(!problems(&schema, &text).is_empty(), "the schema accepts {word}");
        assert!(read(&text).is_err(), "the reader accepts {word}");
    }
    each_refused(
        r#"
        operation_triping_out: `kind = "drill"` -> `kind = "triping out"`
        operation_slackof: `kind = "drill"` -> `kind = "slackof"`
        operation_half_a_word: `kind = "drill"` -> `kind = "tripping"`
        operation_rotating: `kind = "drill"` -> `kind = "rotating"`
        operation_circulate: `kind = "drill"` -> `kind = "circulate"`
        operation_twice_by_another_word: `kind = "drill"` -> `kind = ["trip_out", "pick-up"]`
        "#,
    );
}
