//! A disc on a torsion spring: E01's.

use std::f64::consts::TAU;

use wholestring_verification::verify;
use wholestring_vibration::torsional_stability::{LinearDrive, LumpedChain};

use crate::{
    band,
    common::{number, verification},
    in_torsion, turning, worst,
};

/// `J s² + (c + T′) s + k = 0`: growth `−(c + T′)/2J` and frequency, and on which side of zero the
/// sum of drag and slope is counts the roots that grow. Rounding only.
#[test]
fn a_disc_on_a_spring_grows_by_the_slope_of_its_torque() {
    let data = verification("E01_stick_slip_1dof.json");
    let case = &data["cases"][0];
    let [inertia, stiffness] = ["J", "k"].map(|key| number(&case["inputs"][key]));
    let natural = number(&case["expected"]["omega_n"]);
    for (drag, slope) in [(20.0, 0.0), (20.0, -15.0), (20.0, -25.0), (0.0, -60.0), (5.0, 30.0)] {
        let chain = LumpedChain {
            inertia: vec![0.0, inertia],
            stiffness: vec![stiffness],
            drag: vec![0.0, drag],
            stiffness_damping_s: 0.0,
        };
        let disc = in_torsion(chain, LinearDrive::Constant, turning(slope));
        let found = disc.stability(band(0.05, 20.0));
        let net: f64 = drag + slope;
        assert_eq!(found.unstable_roots, if net < 0.0 { 2 } else { 0 });
        let growth = -0.5 * net / inertia;
        let frequency = (natural * natural - growth * growth).sqrt() / TAU;
        let root = worst(&found);
        let reason = "rounding: the root is followed to 1e-9";
        let what = format!("with a drag of {drag} and a slope of {slope} N·m·s");
        verify("E01", format!("growth of a small swing {what}, 1/s"))
            .absolute(1e-9, reason)
            .report(growth, root.growth_per_s);
        verify("E01", format!("frequency of a small swing {what}, Hz"))
            .relative(1e-9, reason)
            .report(frequency, root.frequency_Hz);
    }
}
