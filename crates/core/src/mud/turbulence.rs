//! Ratio of a mud's drag with vortices to that in laminar flow.
//!
//! Each is the ratio of two friction laws, never below one: laminar forces are multiplied by it.

use std::f64::consts::PI;

/// Fanning friction over that of laminar flow, `laminar/Re`: 16 in a pipe, 24 in a slot.
///
/// API RP 13D with Metzner and Reed's Reynolds number and the flow index `n`: laminar to
/// `Re₁ = 3470 − 1370 n`, turbulent from `Re₂ = 4270 − 1370 n` on, `f = a/Re^b` (Dodge and Metzner
/// 1959), and a straight line in `Re` between the two. A mud that thickens has the bounds of a
/// Newtonian one. Theory: `docs/src/theory/mud.md`.
pub(super) fn through_flow(reynolds: f64, flow_index: f64, laminar: f64) -> f64 {
    let laminar_to = 3470.0 - 1370.0 * flow_index.min(1.0);
    if reynolds <= laminar_to {
        return 1.0;
    }
    let turbulent_from = laminar_to + 800.0;
    let lg = libm::log10(flow_index);
    let (a, b) = ((lg + 3.93) / 50.0, (1.75 - lg) / 7.0);
    let friction = if reynolds < turbulent_from {
        let (first, last) = (laminar / laminar_to, a / libm::pow(turbulent_from, b));
        first + (last - first) * (reynolds - laminar_to) / (turbulent_from - laminar_to)
    } else {
        a / libm::pow(reynolds, b)
    };
    (friction * reynolds / laminar).max(1.0)
}

/// Torque on a cylinder that rotates in a hole at rest over that of laminar Couette flow; `eta` the
/// ratio of the radii, `reynolds = ρ Ω r h/μ` with the gap `h`.
///
/// Wendt (1933), `T/(ρ ν² L) = 1.45 η^(3/2) (1 − η)^(−7/4) Re^1.5` to `Re = 1e4` and
/// `0.23 … Re^1.7` above, as Lathrop, Fineberg and Swinney (1992) give him. It meets the laminar
/// law within 40 % of the Reynolds number where Taylor's vortices set in.
pub(super) fn rotation(reynolds: f64, eta: f64) -> f64 {
    let shape = eta.sqrt() * (1.0 + eta) * libm::pow(1.0 - eta, 0.25) / (4.0 * PI);
    (shape * (1.45 * reynolds.sqrt()).max(0.23 * libm::pow(reynolds, 0.7))).max(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Blasius' `0.0791/Re^0.25` within 1 % where the flow is turbulent.
    #[test]
    fn through_flow_is_blasius_for_a_newtonian_fluid() {
        for re in [3e3, 5e3, 2e4, 1e5] {
            let friction: f64 = 16.0 / re * through_flow(re, 1.0, 16.0);
            let blasius = 0.0791 / re.powf(0.25);
            assert!((friction / blasius - 1.0).abs() < 0.01, "{friction} {blasius}");
        }
    }

    /// API RP 13D's friction, worked out by hand from its formulas to the digits given: 16/Re and
    /// 24/Re below 3470 − 1370 n, `a/Re^b` above 4270 − 1370 n, and halfway between the two the
    /// mean of the frictions at them.
    #[test]
    fn friction_is_that_of_api_rp_13d() {
        // Pipe and slot; flow index, Reynolds number, Fanning friction.
        for (laminar, n, re, friction) in [
            // lg 1 = 0: a = 0.0786, b = 0.25; 0.0786/2900^0.25 = 0.010711.
            (16.0, 1.0, 1195.0, 0.013389),
            (16.0, 1.0, 2000.0, 0.008),
            (16.0, 1.0, 2100.0, 0.0076190),
            (16.0, 1.0, 2500.0, 0.0091650),
            (16.0, 1.0, 2900.0, 0.010711),
            (16.0, 1.0, 3000.0, 0.010620),
            (16.0, 1.0, 5000.0, 0.0093472),
            (24.0, 1.0, 2000.0, 0.012),
            (24.0, 1.0, 2500.0, 0.011070),
            (24.0, 1.0, 3000.0, 0.010620),
            (24.0, 1.0, 5000.0, 0.0093472),
            // lg 0.5 = −0.30103: a = 0.072579, b = 0.29300; 0.072579/3585^0.293 = 0.0065964.
            (16.0, 0.5, 2785.0, 0.0057451),
            (16.0, 0.5, 3185.0, 0.0061707),
            (16.0, 0.5, 3585.0, 0.0065964),
            (16.0, 0.5, 5000.0, 0.0059841),
        ] {
            let found = laminar / re * through_flow(re, n, laminar);
            assert!(
                (found / friction - 1.0).abs() < 1e-4,
                "{laminar} {n} {re}: {found}, {friction}"
            );
        }
    }

    /// Nothing jumps, whatever the index: the factor goes as `Re²` or so where the transition is
    /// steepest, by 2e-4 in a step of 1e-4 of the Reynolds number; a jump from one law to the other
    /// would be 0.1 to 0.4.
    #[test]
    fn friction_is_continuous() {
        for n in [0.15, 0.3, 0.5, 0.7, 1.0, 1.4] {
            for laminar in [16.0, 24.0] {
                let mut before = 1.0;
                let mut re = 1000.0;
                while re < 2e4 {
                    let now = through_flow(re, n, laminar);
                    assert!((now / before - 1.0f64).abs() < 5e-4, "{n} {laminar} {re}");
                    assert!(now >= 1.0);
                    (before, re) = (now, 1.0001 * re);
                }
            }
        }
    }

    /// Taylor's vortices set in at Re 68.2 for η = 0.5 and 85.8 for η = 0.75 (DiPrima and Swinney
    /// 1981): the correlation leaves the laminar line within 40 % of that. Its two branches meet at
    /// 1e4.
    #[test]
    fn rotation_leaves_the_laminar_line_where_vortices_set_in() {
        for (eta, critical) in [(0.5, 68.2), (0.75, 85.8)] {
            assert_eq!(rotation(0.6 * critical, eta), 1.0);
            assert!(rotation(1.4 * critical, eta) > 1.0);
        }
        let (below, above) = (1.45 * 1e4f64.sqrt(), 0.23 * 1e4f64.powf(0.7));
        assert!((below / above - 1.0).abs() < 0.01);
    }
}
