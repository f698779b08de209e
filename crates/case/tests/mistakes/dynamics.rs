//! Mistakes in `[dynamics]` and `[mesh]`.

use crate::{
    common::{changed, read},
    each_refused, each_warned, refused, texts_refused,
};

#[test]
fn values() {
    each_refused(
        r#"
        seed_negative: `seed = 1` -> `seed = -1`
        seed_fractional: `seed = 1` -> `seed = 1.5`
        start_is_a_number: `start = "prepared"` -> `start = 0`
        start_without_tension: `start = "prepared"` -> `start = "centred"\nstart_tension = "none"`
        start_ramp_negative: `start = "prepared"` -> `start = "centred"\nstart_ramp = -1`
        settle_misspelt: `settle = "20 s"` -> `settle = "auot"`
        elements_too_short: `"auto"` -> `"3.2 mm"`
        rows_without_end: `"60 s"` -> `"86400 s"`
        window_without_samples: `"60 s"` -> `"1 ms"`
        checkpoints_all_the_time: `duration = "60 s"`
            -> `duration = "60 s"\ncheckpoint_interval = 0`
        checkpoints_by_depth: `duration = "60 s"`
            -> `duration = "60 s"\ncheckpoint_interval = "5 m"`
        stribeck_speed_zero: `seed = 1` -> `seed = 1\nstribeck_speed = 0`
        "#,
    );
    texts_refused([
        (
            "step_of_nanoseconds",
            changed("duration = \"60 s\"", "damping.stiffness = \"10 ms\"\nduration = \"60 s\"")
                .replace("\"auto\"", "\"0.2 m\""),
        ),
        (
            "run_of_weeks",
            changed("duration = \"60 s\"", "sample_interval = 1\nduration = \"86400 s\"")
                .replace("\"auto\"", "\"0.2 m\"")
                .replace("bit_depth = \"4305 m\"", "bit_depth = \"19999 m\"")
                .replace("to = \"4305 m\"", "to = \"20000 m\""),
        ),
    ]);
    each_warned(
        r#"
        warn_stribeck_speed: `seed = 1` -> `seed = 1\nstribeck_speed = "0.2 m/s"`
        warn_centred_keys: `start = "prepared"`
            -> `start = "prepared"\nstart_tension = "cold"\nstart_ramp = "2 s"`
        warn_contact_key: `contact_law = "hertz" `
            -> `contact_law = "hertz"\ncontact_stiffness = 1e8 `
        warn_hertz_key: `contact_law = "hertz" `
            -> `contact_law = "linear"\nhertz_dissipation = 0.1 `
        "#,
    );
}

#[test]
fn precision() {
    each_refused(
        r#"
        precision_unknown: `seed = 1` -> `seed = 1\nprecision = "half"`
        precision_of_short_elements: `element_length = "auto"\n\n[dynamics]`
            -> `element_length = "0.5 m"\n\n[dynamics]\nprecision = "single"`
        "#,
    );
    let single = changed("seed = 1", "seed = 1\nprecision = \"single\"");
    let sliding = single.replace("kind = \"drill\"", "kind = \"slide\"");
    refused("precision_of_a_sliding_string", read(&sliding));
}
