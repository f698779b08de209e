//! Mistakes in the tables of `[plan]` for limits, fatigue and wear.

use wholestring_judge::{DesignFactors, LimitSettings, strength::PSI_PA};
use wholestring_plan::{CampaignSettings, fatigue::SnCurve};

use crate::{
    common::{change::rows, read},
    each_warned,
    plan::{accepted, planned},
    refused,
};

#[test]
fn limits_fatigue_and_wear() {
    let cases = rows(
        r#"
        plan_factor_of_zero: `factors = { burst = 0 }`
        plan_factor_as_text: `factors = { tension = "10 %" }`
        plan_factor_unknown: `factors = { tensile = 1.1 }`
        plan_overpull_without_unit: `overpull = "445"`
        plan_drilled_from_below_the_bit: `campaign = { drilled_from = "4400 m" }`
        plan_wear_factor_with_unit: `campaign = { wear_factor = "5e-10 1/psi" }`
        plan_wear_factors_too_many: `campaign = { wear_factor = [2, 5, 8] }`
        plan_round_trips_negative: `campaign = { round_trips = -1 }`
        plan_curve_without_stress: `fatigue = { cycles = 2e6, exponent = 5 }`
        plan_curve_without_unit: `fatigue = { cycles = 2e6, stress = "138", exponent = 5 }`
        plan_exponent_below_one: `fatigue = { cycles = 2e6, stress = "138 MPa", exponent = 0.5 }`
        plan_off_bottom_negative: `campaign = { off_bottom = "-1 h" }`
        plan_off_bottom_as_length: `campaign = { off_bottom = "10 m" }`
        plan_cycles_below_one: `fatigue = { cycles = 0, stress = "138 MPa", exponent = 5 }`
        plan_cycles_with_unit: `fatigue = { cycles = "2e6 rev", stress = "138 MPa", exponent = 5 }`
        plan_endurance_limit_without_unit: `fatigue = { endurance_limit = "60" }`
        plan_endurance_limit_negative: `fatigue = { endurance_limit = "-60 MPa" }`
        plan_tensile_strength_as_force: `fatigue = { tensile_strength = "1000 kN" }`
        plan_tensile_strength_too_large: `fatigue = { tensile_strength = "100 GPa" }`
        plan_endurance_limit_beyond_strength: `fatigue = { endurance_limit = "1100 MPa", tensile_strength = "1000 MPa" }`
        plan_stress_beyond_strength: `fatigue = { cycles = 2e6, stress = "1000 MPa", exponent = 5, tensile_strength = "1000 MPa" }`
        plan_strength_below_yield: `fatigue = { tensile_strength = "900 MPa" }`
        "#,
    );
    for (name, keys) in cases {
        refused(name, read(&planned(&keys)));
    }
    each_warned(
        r#"
        warn_plan_factor_below_one: `[mesh]` -> `[plan]\nfactors = { tension = 0.9 }\n[mesh]`
        warn_plan_exponent_below_is_less: `[mesh]` -> `[plan]\nfatigue = { cycles = 2e6, stress = "138 MPa", exponent = 5, exponent_below = 3 }\n[mesh]`
        warn_plan_overpull_beyond_the_hoist: `top_drive_torque = "45 kN.m"` -> `hoist_capacity = "600 kN"\nblock_weight = "200 kN"\n[plan]\noverpull = "500 kN"`
        warn_plan_exponent_below_alone: `[mesh]` -> `[plan]\nfatigue = { exponent_below = 6 }\n[mesh]`
        "#,
    );
}

#[test]
fn what_is_not_given_is_usual() {
    let plan = accepted("").plan;
    assert_eq!(plan.limits, LimitSettings::default());
    let CampaignSettings { wear_factors, .. } = plan.campaign.clone();
    assert_eq!(plan.campaign, CampaignSettings::default());
    assert!((wear_factors.of_per_Pa(0) * PSI_PA * 1e10 - 5.0).abs() < 1e-9);
    // An empty table equals the default.
    let plan = accepted("campaign = {}\nfatigue = {}\nfactors = {}").plan;
    assert_eq!(plan.limits, LimitSettings::default());
    assert_eq!(plan.campaign, CampaignSettings::default());
}

#[test]
fn what_is_given_is_meant() {
    let case = accepted(
        "overpull = \"200 kN\"\nfactors = { tension = 1.3, von_mises = 1.5 }\n\
         campaign = { drilled_from = \"3000 m\", round_trips = 3, off_bottom = \"7200 s\", wear_factor = [2] }\n\
         fatigue = { cycles = 2e6, stress = \"138 MPa\", exponent = 5, endurance_limit = \"50 MPa\", tensile_strength = \"1000 MPa\" }",
    );
    let plan = &case.plan;
    let factors = DesignFactors { tension: 1.3, von_mises: 1.5, ..DesignFactors::default() };
    assert_eq!(
        plan.limits,
        LimitSettings { factors, overpull_N: 200e3, side_force_per_joint_N: None }
    );
    let CampaignSettings {
        drilled_from_m,
        round_trips,
        off_bottom_s,
        operations,
        fatigue,
        wear_factors,
    } = plan.campaign.clone();
    // The plan lists all that the campaign needs.
    assert!(operations.is_empty());
    assert_eq!((drilled_from_m, round_trips, off_bottom_s), (Some(3000.0), 3.0, 7200.0));
    let curve = SnCurve::of_one_slope(2e6, 138e6, 5.0);
    assert_eq!(fatigue.sn_curve, SnCurve { endurance_limit_Pa: Some(50e6), ..curve });
    assert_eq!(fatigue.tensile_strength_Pa, Some(1e9));
    assert!((wear_factors.of_per_Pa(0) * PSI_PA * 1e10 - 2.0).abs() < 1e-9);
    assert!(case.broomstick().is_ok());
}

/// A plan that lists one operation leaves the others to its campaign, with a rotary speed for
/// operations that rotate off bottom.
#[test]
fn a_campaign_has_the_operations_that_the_plan_does_not_list() {
    let plan = accepted("operations = \"drill\"").plan;
    let others: Vec<&str> =
        plan.campaign.operations.iter().map(|operation| operation.kind.name()).collect();
    assert_eq!(others, ["trip_out", "trip_in", "rotate_off_bottom"]);
    assert!(plan.campaign.operations[2].rotary_speed_rad_per_s > 0.0);
}
