//! Mistakes in `[top_drive]`, `[hoist]`, `[rig]` and `[ends]`.

use crate::{
    common::{changed, read},
    each_refused, each_warned, refused, texts_refused, warned,
};

#[test]
fn top_drive_and_hoist() {
    let drive = |keys: &str| changed("[mesh]", &format!("[top_drive]\n{keys}\n[mesh]"));
    let cases = [
        ("top_drive_control_misspelt", "control = \"soft_torque\""),
        ("top_drive_without_inertia", "control = \"pi\"\ninertia = 0"),
        ("top_drive_inertia_in_kg", "control = \"pi\"\ninertia = \"2900 kg\""),
        ("top_drive_gain_negative", "control = \"pi\"\nproportional = -1"),
        ("top_drive_frequency_zero", "control = \"soft-torque\"\nfrequency = 0"),
    ];
    for (name, keys) in cases {
        refused(name, read(&drive(keys)));
    }
    let hoist = |keys: &str| changed("[mesh]", &format!("[hoist]\n{keys}\n[mesh]"));
    refused(
        "hoist_speeds_reversed",
        read(&hoist("control = \"autodriller\"\nmin_speed = \"60 m/h\"\nmax_speed = \"10 m/h\"")),
    );
    refused("hoist_pushes", read(&hoist("control = \"hook-load\"\nhook_load = \"-20 kN\"")));
    let pushes = "[hoist]\ncontrol = \"hook-load\"\nhook_load = \"-20 kN\"\n[rig]\n";
    let snubs =
        |force: &str| changed("[rig] ", &format!("{pushes}snubbing_force = \"{force}\"\n#"));
    refused("hoist_pushes_too_hard", read(&snubs("10 kN")));
    read(&snubs("30 kN")).expect("a rig that pushes");
    refused("hoist_mass_negative", read(&hoist("mass = \"-20 t\"")));
    let block = |mass: &str| {
        let hoist = format!("[hoist]\nmass = \"{mass}\"\n[rig]\nblock_weight = \"20 tf\"\n#");
        changed("[rig] ", &hoist)
    };
    warned("warn_two_blocks", read(&block("35 t")));
    let same = read(&block("20.5 t")).expect("a valid case");
    assert!(same.warnings.is_empty(), "{}", same.warnings);
    warned("warn_top_drive_constant", read(&drive("inertia = \"2900 kg.m2\"")));
    warned(
        "warn_top_drive_tuned",
        read(&drive("control = \"soft-torque\"\nproportional = \"38 kN.m.s\"")),
    );
    each_warned(
        r#"
        warn_stiffness_of_a_pinned_bit: `[bit]`
            -> `[ends]\nbit = "pinned"\n[bit]\nlateral_stiffness = "1e7 N/m"`
        warn_hoist_key: `[mesh]` -> `[hoist]\ngain = 1e-7\n[mesh]`
        "#,
    );
}

#[test]
fn limit_of_the_pump() {
    each_refused(
        r#"
        pump_limit_of_zero: `top_drive_torque = "45 kN.m"` -> `pump_pressure_limit = "0 bar"`
        pump_limit_as_force: `top_drive_torque = "45 kN.m"` -> `pump_pressure_limit = "345 kN"`
        pump_limit_without_unit: `top_drive_torque = "45 kN.m"` -> `pump_pressure_limit = "345"`
        pump_limit_too_large: `top_drive_torque = "45 kN.m"` -> `pump_pressure_limit = "3 GPa"`
        "#,
    );
}

#[test]
fn tuned_lifts() {
    let tuned = "[hoist]\ncontrol = \"tuned-lift\"\n[mesh]";
    let with_kind = |kind: &str| {
        let text = changed("[mesh]", tuned);
        let from =
            text.lines().find(|line| line.starts_with("kind = \"drill\"")).expect("operations");
        text.replace(from, kind)
    };
    texts_refused([
        ("lift_of_a_trip", with_kind("kind = [\"drill\", \"trip_out\"]")),
        ("lift_of_no_weight", with_kind("kind = \"drill\"").replace("wob = \"6 tf\"", "wob = 0")),
        (
            "lift_of_a_moving_block",
            with_kind("kind = \"drill\"\nschedule = [{ at = 10, block_velocity = 0 }]"),
        ),
    ]);
    let valid = read(&with_kind("kind = \"drill\"")).unwrap_or_else(|report| panic!("{report}"));
    assert!(valid.tunes_hook_load && valid.dynamics.hoist_control.is_none());
    assert_eq!(valid.settings["hoist"]["control"], "tuned-lift");
    texts_refused([(
        "lift_tolerance_in_per_cent",
        with_kind("kind = \"drill\"").replace("tuned-lift\"", "tuned-lift\"\ntolerance = 2"),
    )]);
    each_warned(
        r#"
        warn_tolerance_without_lift: `[mesh]` -> `[hoist]\ntolerance = 0.02\n[mesh]`
        "#,
    );
    warned(
        "warn_lift_with_gain",
        read(&with_kind("kind = \"drill\"").replace("tuned-lift\"", "tuned-lift\"\ngain = 1e-7")),
    );
}

#[test]
fn loads() {
    each_refused(
        r#"
        block_heavier_than_hoist: `[rig] `
            -> `[rig]\nblock_weight = "50 tf"\nhoist_capacity = "40 tf"\n#`
        peak_below_rated_torque: `top_drive_torque = "45 kN.m"`
            -> `top_drive_torque = "45 kN.m"\ntop_drive_peak_torque = "40 kN.m"`
        hook_load_control_without_load: `[mesh]` -> `[hoist]\ncontrol = "hook-load"\n[mesh]`
        "#,
    );
}
