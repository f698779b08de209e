//! Mistakes in `[[operation.schedule]]`.

use crate::{
    common::{changed, read},
    refused, warned,
};

/// The example with lines of a schedule, and one more change.
fn scheduled(lines: &str) -> String {
    changed("[mesh]", &format!("{lines}\n[mesh]"))
}

const LINE: &str = "[[operation.schedule]]\n";

#[test]
fn lines_of_a_schedule() {
    let cases = [
        ("schedule_backwards", "at = \"30 s\"\nrpm = 60\n", "at = \"20 s\"\nrpm = 70"),
        (
            "schedule_over_a_ramp",
            "at = \"30 s\"\nramp = \"10 s\"\nrpm = 60\n",
            "at = \"35 s\"\nrpm = 70",
        ),
        (
            "schedule_two_at_once",
            "at = \"30 s\"\nwob = \"50 kN\"\n",
            "at = \"30 s\"\nblock_velocity = 0",
        ),
        (
            "schedule_weight_and_speed",
            "at = 0\nrpm = 0\n",
            "at = \"30 s\"\nwob = \"50 kN\"\nblock_velocity = \"0.3 m/s\"",
        ),
        ("schedule_of_nothing", "at = 0\nrpm = 0\n", "at = \"30 s\"\nramp = \"10 s\""),
        ("schedule_without_time", "at = 0\nrpm = 0\n", "rpm = 60"),
        ("schedule_key_misspelt", "at = 0\nrpm = 0\n", "at = \"30 s\"\nrmp = 60"),
        ("schedule_before_time_zero", "at = \"-5 s\"\nrpm = 0\n", "at = \"30 s\"\nrpm = 60"),
    ];
    for (name, first, second) in cases {
        refused(name, read(&scheduled(&format!("{LINE}{first}{LINE}{second}"))));
    }
    let plan = format!("{LINE}at = \"30 s\"\nrpm = 60");
    refused("schedule_single_brackets", read(&scheduled("[operation.schedule]\nat = 0\nrpm = 0")));
    let several = "kind = [\"drill\", \"ream\"]";
    refused(
        "schedule_of_two_operations",
        read(&scheduled(&plan).replace("kind = \"drill\" ", several)),
    );
    refused(
        "schedule_turns_what_does_not",
        read(&scheduled(&plan).replace("kind = \"drill\" ", "kind = \"trip_in\"")),
    );
    let held = format!("{LINE}at = \"30 s\"\nwob = \"50 kN\"");
    refused(
        "schedule_weight_off_bottom",
        read(&scheduled(&held).replace("kind = \"drill\" ", "kind = \"ream\"")),
    );
    let late = format!("{LINE}at = \"80 s\"\nrpm = 60");
    warned("warn_schedule_too_late", read(&scheduled(&late)));
    let soft = scheduled(&plan).replace("model = \"dynamic\" ", "model = \"soft\"");
    warned("warn_schedule_soft", read(&soft));
    let both = scheduled(&plan).replace("model = \"dynamic\" ", "model = [\"soft\", \"dynamic\"]");
    warned("warn_schedule_soft_too", read(&both));
    let pumps = format!("{LINE}at = \"30 s\"\nflow_rate = 0");
    warned("warn_schedule_flow_without_rheology", read(&scheduled(&pumps)));
    // Where a schedule sets a weight, the autodriller's keys have their effect.
    let tuned = format!("{held}\n[hoist]\ngain = 1e-7\nintegral_time = \"60 s\"");
    let case = read(&scheduled(&tuned)).expect("a valid case");
    assert!(case.warnings.is_empty());
    assert_eq!(case.dynamics.autodriller.integral_time_s, 60.0);
}
