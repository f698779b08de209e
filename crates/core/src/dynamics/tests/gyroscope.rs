//! A spinning rod whirls faster forwards than backwards.

use super::{
    beams::beam,
    bench::{PIPE_M, Support},
};
use crate::{dynamics::kernel::chain::node, simd::vector::Vector};

/// A pinned pipe that spins at `Ω` and swings in its mode `sin kz` obeys
/// `(m + I k²) ω² ∓ J k² Ω ω − EI k⁴ = 0`, `I` and `J` the moments of inertia per metre across and
/// about the axis: it whirls forwards at `ω₊` and backwards at `ω₋`. Struck in one plane, it does
/// both: it swings at the mean of the two, and the plane turns with the spin at half of their
/// difference, `½ J k² Ω/(m + I k²)`.
///
/// `J = m (D² + d²)/8`; `I` is the inertia that the mesh adds to its nodes. The mesh's error is of
/// fourth order in `kh`, 0.24 for 24 elements: `(kh)⁴/180`, 2e-5 for the swing. That of the plane
/// is five times as large, for the tilt follows the slope less closely. Both fall to an eighth or
/// less for twice as many elements.
#[test]
fn a_spinning_pipe_precesses() {
    let length = 30.0;
    let spin = 300.0;
    let errors = [24usize, 48].map(|parts| {
        let mut rod = beam(length, parts);
        rod.support(0, Support::PINNED);
        rod.support(parts, Support::ROLLER);
        let k = 3.0 * std::f64::consts::PI / length;
        for i in 0..=parts {
            let z = rod.z_m(i);
            node!(rod.chain, i, spin = spin);
            if node!(rod.chain, i, inv_mass_lateral) > 0.0 {
                rod.chain.set_velocity(i, Vector(1e-6 * (k * z).sin(), 0.0, 0.0));
            }
            rod.chain.set_turning(i, Vector(0.0, 1e-6 * k * (k * z).cos(), 0.0));
        }
        let section = rod.mesh.elements[0].section;
        let mass = section.steel_kg_per_m;
        let polar = mass * (PIPE_M[0].powi(2) + PIPE_M[1].powi(2)) / 8.0;
        let added: f64 = (0..=parts).map(|i| rod.rotary_kg_m2(i)).sum::<f64>() / length;
        let inertia = mass + added * k * k;
        let half_split = 0.5 * polar * k * k * spin / inertia;
        let plain = section.bending_stiffness_N_m2 * k.powi(4) / inertia;
        let mean = (plain + half_split * half_split).sqrt();

        let place = |rod: &super::bench::Bench| {
            (0..=parts).fold([0.0, 0.0], |[x, y], i| {
                let shape = (k * rod.z_m(i)).sin();
                let u = rod.chain.displacement(i);
                [x + shape * u.0, y + shape * u.1]
            })
        };
        let frequency = rod.frequency_Hz(10, |rod| place(rod)[0]) * std::f64::consts::TAU;
        // On to the middle of a swing, where the plane shows best: the first zero was after half a
        // period.
        let quarter = (0.25 * std::f64::consts::TAU / mean / rod.input.dt) as usize;
        for _ in 0..quarter {
            rod.step();
        }
        let [x, y] = place(&rod);
        let time = 10.75 * std::f64::consts::TAU / mean;
        let turned = (y / x).atan();
        [frequency / mean - 1.0, turned / (half_split * time) - 1.0]
    });
    let [[swing, turn], [swing_fine, turn_fine]] = errors;
    assert!(swing.abs() < 3e-5 && turn.abs() < 2e-4, "{errors:?}");
    assert!(swing_fine.abs() < swing.abs() / 8.0, "{errors:?}");
    assert!(turn_fine.abs() < turn.abs() / 8.0, "{errors:?}");
}
