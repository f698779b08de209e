//! Mistakes in `[operation]`.

use crate::{
    common::{changed, read},
    each_refused, each_warned, warned,
};

#[test]
fn kind() {
    each_refused(&[
        (
            "operation_misspelt",
            "kind = \"drill\"",
            "kind = \"driling\"",
        ),
        (
            "operation_with_hyphen",
            "kind = \"drill\"",
            "kind = [\"drill\", \"trip-out\"]",
        ),
        (
            "operation_unknown",
            "kind = \"drill\"",
            "kind = \"cementing\"",
        ),
        (
            "operation_listed_twice",
            "kind = \"drill\"",
            "kind = [\"drill\", \"slide\", \"drill\"]",
        ),
        ("operations_empty", "kind = \"drill\"", "kind = []"),
    ]);
}

#[test]
fn set_points() {
    each_refused(&[
        ("wob_missing", "wob = \"6 tf\"", ""),
        (
            "rpm_missing",
            "rpm = 70                              # rev/min\n",
            "",
        ),
        ("rpm_too_large", "rpm = 70 ", "rpm = 70000 "),
        ("rpm_zero_while_drilling", "rpm = 70 ", "rpm = 0 "),
        ("rop_missing", "rop = \"10 m/h\"", "# rop = \"10 m/h\""),
        (
            "bit_depth_negative",
            "bit_depth = \"4305 m\"",
            "bit_depth = \"-4305 m\"",
        ),
        ("bit_depth_zero", "bit_depth = \"4305 m\"", "bit_depth = 0"),
    ]);
    each_warned(&[("warn_weight_on_bit", "wob = \"6 tf\"", "wob = \"200 tf\"")]);
    warned(
        "warn_projection",
        read(
            &changed("bit_depth = \"4305 m\"", "bit_depth = \"4400 m\"")
                .replace("to = \"4305 m\"", "to = \"4500 m\""),
        ),
    );
}
