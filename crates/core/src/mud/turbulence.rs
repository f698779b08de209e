//! How much more than in laminar flow a mud drags once vortices mix it.
//!
//! Each is the ratio of two friction laws, never below one: laminar forces are multiplied by it.

use std::f64::consts::PI;

/// Fanning friction of turbulent flow over that of laminar flow, `laminar/Re`: 16 in a pipe, 24 in a
/// slot.
///
/// `f = a/Re^b` with `a = (lg n + 3.93)/50` and `b = (1.75 − lg n)/7`: the explicit form of Dodge and
/// Metzner (1959) in API RP 13D, with Metzner and Reed's Reynolds number; for `n = 1` nearly Blasius'.
pub(super) fn through_flow(reynolds: f64, flow_index: f64, laminar: f64) -> f64 {
    let lg = flow_index.log10();
    let (a, b) = ((lg + 3.93) / 50.0, (1.75 - lg) / 7.0);
    (a * reynolds.powf(1.0 - b) / laminar).max(1.0)
}

/// Torque on a cylinder that rotates in a hole at rest over that of laminar Couette flow; `eta` the ratio of the
/// radii, `reynolds = ρ Ω r h/μ` with the gap `h`.
///
/// Wendt (1933), `T/(ρ ν² L) = 1.45 η^(3/2) (1 − η)^(−7/4) Re^1.5` to `Re = 1e4` and `0.23 … Re^1.7` above, as
/// Lathrop, Fineberg and Swinney (1992) give him. It meets the laminar law within 40 % of the
/// Reynolds number where Taylor's vortices set in.
pub(super) fn rotation(reynolds: f64, eta: f64) -> f64 {
    let shape = eta.sqrt() * (1.0 + eta) * (1.0 - eta).powf(0.25) / (4.0 * PI);
    (shape * (1.45 * reynolds.sqrt()).max(0.23 * reynolds.powf(0.7))).max(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Blasius' `0.0791/Re^0.25` within 1 %; laminar below the crossing.
    #[test]
    fn through_flow_is_blasius_for_a_newtonian_fluid() {
        for re in [5e3, 2e4, 1e5] {
            let friction: f64 = 16.0 / re * through_flow(re, 1.0, 16.0);
            let blasius = 0.0791 / re.powf(0.25);
            assert!(
                (friction / blasius - 1.0).abs() < 0.01,
                "{friction} {blasius}"
            );
        }
        assert_eq!(through_flow(1000.0, 1.0, 24.0), 1.0);
    }

    /// Taylor's vortices set in at Re 68.2 for η = 0.5 and 85.8 for η = 0.75 (DiPrima and Swinney 1981): the
    /// correlation leaves the laminar line within 40 % of that. Its two branches meet at 1e4.
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
