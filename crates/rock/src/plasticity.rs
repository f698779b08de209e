//! Return mapping: from a strain increment to the stress.
//!
//! The stress is Kirchhoff's, Cauchy's times the change of volume. The order of the six components
//! is xx, yy, zz, xy, yz, zx; shear strains are those of the tensor, half of the engineer's. With
//! the intact part `s` of cohesion and tensile strength, 1 at first and 0 after failure,
//!
//! ```text
//! √J₂ + α I₁ <= k s        the cone (Drucker and Prager 1952)
//! I₁ <= t s                its tip cut off by the tensile strength (the apex itself where t = k/α)
//! ```
//!
//! Theory: `docs/src/theory/rock.md`.

use serde::{Deserialize, Serialize};

use super::material::{Cone, Rock, RockError};
use wholestring_numbers::simd::number::Number;

/// Constants of the return mapping, for a rock in elements of one size.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub struct Law {
    /// Lamé's constant and twice the shear modulus, Pa.
    lame: f64,
    twice_shear: f64,
    shear: f64,
    alpha: f64,
    k: f64,
    tension: f64,
    /// Fall of the intact part per plastic multiplier of the cone.
    softening_rate: f64,
    /// Fall of the intact part per first invariant that the tip takes, 1/Pa: at most, its part from
    /// swelling, and that from shear by the square of √J₂/I₁.
    tensile_softening: f64,
    tensile_softening_bulk: f64,
    tensile_softening_shear: f64,
    /// First invariant's fall per multiplier of the cone, Pa.
    swelling: f64,
    /// Multiplier per overstress while the rock softens, and after it.
    softening: f64,
    softened: f64,
    /// Radius of the edge between cone and tip, Pa, and the same at the edge.
    edge: f64,
    edge_softening: f64,
    edge_softened: f64,
    /// One over four shear moduli and eighteen bulk moduli, 1/Pa.
    shear_compliance: f64,
    bulk_compliance: f64,
}

/// Result of a strain increment.
pub struct StressUpdate<N> {
    /// Stress, Pa.
    pub stress: [N; 6],
    /// Intact part of cohesion and tensile strength.
    pub intact: N,
    /// Energy that plastic flow took, J/m³.
    pub plastic: N,
}

impl Law {
    /// For elements of a size, the cube root of their volume.
    ///
    /// # Errors
    /// Numbers that no rock has, or elements that would snap instead of soften.
    pub fn new(rock: &Rock, size_m: f64) -> Result<Self, RockError> {
        rock.check()?;
        let Cone { alpha, k_Pa: k } = rock.cone();
        let dilation = rock.dilation_slope();
        let (shear, bulk) = (rock.shear_modulus_Pa(), rock.bulk_modulus_Pa());
        let tension = rock.largest_tension_Pa();
        let third = 1.0 / 3.0_f64.sqrt();
        // Of the work in uniaxial compression, only the part that is not done against friction
        // counts.
        let share = (third - dilation) / (third - alpha);
        let [tensile, compressive] = rock.failure_J_per_m2(size_m);
        let per_size = 0.5 * k * share / compressive;
        let softening_rate = per_size * size_m;
        // The work of a stress that shrinks is twice its elastic energy; above that of uniaxial
        // tension it is shear's.
        let tensile_softening = 0.5 * tension * size_m / tensile;
        let hard = shear + 9.0 * bulk * alpha * dilation;
        let edge = k - alpha * tension;
        let largest_m = [
            hard / (k * per_size),
            shear / (edge * per_size).max(f64::MIN_POSITIVE),
            // A band in a bar of its own length.
            2.0 * rock.youngs_modulus_Pa * compressive / rock.ucs_Pa().powi(2),
            2.0 * rock.youngs_modulus_Pa * tensile / tension.powi(2),
        ]
        .into_iter()
        .fold(f64::INFINITY, f64::min);
        if size_m >= largest_m {
            return Err(RockError::TooLarge { size_m, largest_m });
        }
        Ok(Self {
            lame: rock.lame_Pa(),
            twice_shear: 2.0 * shear,
            shear,
            alpha,
            k,
            tension,
            softening_rate,
            tensile_softening: tensile_softening / rock.youngs_modulus_Pa,
            tensile_softening_bulk: tensile_softening / (9.0 * bulk),
            tensile_softening_shear: tensile_softening / shear,
            swelling: 9.0 * bulk * dilation,
            softening: 1.0 / (hard - k * softening_rate),
            softened: 1.0 / hard,
            edge,
            edge_softening: 1.0 / (shear - edge * softening_rate),
            edge_softened: 1.0 / shear,
            shear_compliance: 0.25 / shear,
            bulk_compliance: 1.0 / (18.0 * bulk),
        })
    }

    /// Stress that a strain adds elastically, Pa.
    #[inline(always)]
    pub fn predict<N: Number>(&self, stress: [N; 6], strain: [N; 6]) -> [N; 6] {
        let [xx, yy, zz, xy, yz, zx] = strain;
        let twice = N::splat(self.twice_shear);
        let swelling = N::splat(self.lame) * (xx + yy + zz);
        [
            xx.mul_add(twice, stress[0] + swelling),
            yy.mul_add(twice, stress[1] + swelling),
            zz.mul_add(twice, stress[2] + swelling),
            xy.mul_add(twice, stress[3]),
            yz.mul_add(twice, stress[4]),
            zx.mul_add(twice, stress[5]),
        ]
    }

    /// Recoverable energy of a stress, J/m³.
    pub fn elastic_J_per_m3(&self, stress: [f64; 6]) -> f64 {
        let first = stress[0] + stress[1] + stress[2];
        let square: f64 = (0..3).map(|i| stress[i] * stress[i]).sum::<f64>()
            + 2.0 * (3..6).map(|i| stress[i] * stress[i]).sum::<f64>();
        self.shear_compliance * (square - first * first / 3.0)
            + self.bulk_compliance * first * first
    }

    /// Computes the stress and the intact part after a strain increment.
    #[inline(always)]
    pub fn return_map<N: Number>(
        &self,
        stress: [N; 6],
        strain: [N; 6],
        intact: N,
    ) -> StressUpdate<N> {
        let (zero, one) = (N::zero(), N::splat(1.0));
        let trial = self.predict(stress, strain);
        // I₁, the deviator and √J₂ of the elastic trial.
        let first = trial[0] + trial[1] + trial[2];
        let mean = first * N::splat(1.0 / 3.0);
        let s = [trial[0] - mean, trial[1] - mean, trial[2] - mean, trial[3], trial[4], trial[5]];
        let normal = s[0].mul_add(s[0], s[1].mul_add(s[1], s[2] * s[2]));
        let shear = s[3].mul_add(s[3], s[4].mul_add(s[4], s[5] * s[5]));
        let second = normal.mul_add(N::splat(0.5), shear);
        let root = (second + N::splat(1e-30)).sqrt();

        // The cone. The smaller multiplier is that of a rock that has no cohesion left at the end.
        let load = first.mul_add(N::splat(self.alpha), root);
        let over = intact.neg_mul_add(N::splat(self.k), load);
        let flow = (over * N::splat(self.softening)).min(load * N::splat(self.softened)).max(zero);
        let cone_root = flow.neg_mul_add(N::splat(self.shear), root);
        let cone_first = flow.neg_mul_add(N::splat(self.swelling), first);
        let cone_intact = flow.neg_mul_add(N::splat(self.softening_rate), intact).max(zero);

        // Where nothing yields, the code below would give the same to the last bit. Removed
        // elements, whose intact part is −1, do not count.
        let beyond = cone_intact.neg_mul_add(N::splat(self.tension), cone_first);
        let yields = (intact + one).if_positive(flow.max(beyond), zero);
        if !yields.any_positive() {
            return StressUpdate {
                stress: [s[0] + mean, s[1] + mean, s[2] + mean, s[3], s[4], s[5]],
                intact: cone_intact,
                plastic: zero,
            };
        }

        // The tip, and its edge with the cone. Values not beyond it are NaN here, and are not used.
        let inverse = one / first;
        let slope = second * inverse * inverse;
        let tensile_softening = slope
            .mul_add(N::splat(self.tensile_softening_shear), N::splat(self.tensile_softening_bulk))
            .min(N::splat(self.tensile_softening));
        let left = (tensile_softening.neg_mul_add(first, intact)
            / tensile_softening.neg_mul_add(N::splat(self.tension), one))
        .min(intact)
        .max(zero);
        let shrunk = root * (left * N::splat(self.tension) * inverse).min(one);
        let over = left.neg_mul_add(N::splat(self.edge), shrunk);
        let flow = (over * N::splat(self.edge_softening))
            .min(shrunk * N::splat(self.edge_softened))
            .max(zero);
        let tip_root = flow.neg_mul_add(N::splat(self.shear), shrunk);
        let tip_intact = flow.neg_mul_add(N::splat(self.softening_rate), left).max(zero);
        let tip_first = tip_intact * N::splat(self.tension);

        let new_root = beyond.if_positive(tip_root, cone_root).max(zero);
        let new_first = beyond.if_positive(tip_first, cone_first);
        let new_intact = beyond.if_positive(tip_intact, cone_intact);

        // The deviator keeps its direction: its size is scaled back, its mean replaced.
        let ratio = new_root / root;
        let mean = new_first * N::splat(1.0 / 3.0);
        // The mean of the stresses before and after, times the plastic strain.
        let before = stress[0].mul_add(s[0], stress[1].mul_add(s[1], stress[2] * s[2]));
        let sheared = stress[3].mul_add(s[3], stress[4].mul_add(s[4], stress[5] * s[5]));
        let along = sheared.mul_add(N::splat(2.0), before) + N::splat(2.0) * ratio * second;
        let sum = stress[0] + stress[1] + stress[2] + new_first;
        let swollen = sum * (first - new_first) * N::splat(self.bulk_compliance);
        let plastic = ((one - ratio) * along).mul_add(N::splat(self.shear_compliance), swollen);
        StressUpdate {
            stress: [
                s[0].mul_add(ratio, mean),
                s[1].mul_add(ratio, mean),
                s[2].mul_add(ratio, mean),
                s[3] * ratio,
                s[4] * ratio,
                s[5] * ratio,
            ],
            intact: new_intact,
            plastic,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use wholestring_numbers::simd::wide::Pair;

    fn pair([a, b]: [f64; 2]) -> Pair<f64> {
        // SAFETY: two numbers.
        unsafe { Pair::load([a, b].as_ptr()) }
    }

    fn parts(pair: Pair<f64>) -> [f64; 2] {
        let mut parts = [0.0; 2];
        // SAFETY: two numbers.
        unsafe { pair.store(parts.as_mut_ptr()) };
        parts
    }

    /// An elastic element gets the same bits alone, where its return is left out, and next to one
    /// that yields.
    #[test]
    fn a_return_that_is_left_out_would_have_changed_nothing() {
        let law = Law::new(&Rock::of_strength(30e6), 1e-3).expect("an intact rock");
        let mut state = 7_u64;
        let mut random = || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        for round in 0..1000 {
            let stress = [0; 6].map(|_| 0.5e6 * random());
            let strain = [0; 6].map(|_| 1e-5 * random());
            let intact = 0.75 + 0.5 * random();
            // Crushed at the cone, or torn at the tip.
            let beside = if round % 2 == 0 {
                [0.005, 0.005, -0.01, 0.0, 0.0, 0.0]
            } else {
                [0.0, 0.0, 0.01, 0.0, 0.0, 0.0]
            };
            let alone = law.return_map(stress, strain, intact);
            let both = law.return_map(
                stress.map(|x| pair([x, 0.0])),
                [0, 1, 2, 3, 4, 5].map(|i| pair([strain[i], beside[i]])),
                pair([intact, 1.0]),
            );
            let [kept, softened] = parts(both.intact);
            assert!(softened < 1.0, "the other one yields: {softened}");
            assert_eq!(alone.intact.to_bits(), intact.to_bits());
            assert_eq!(kept.to_bits(), intact.to_bits());
            assert_eq!(alone.stress, both.stress.map(|component| parts(component)[0]));
            assert_eq!([alone.plastic, parts(both.plastic)[0]], [0.0; 2]);
        }
    }
}
