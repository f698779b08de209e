//! Bending of a pipe, in excess of the hole's, between two tool joints on the wall.
//!
//! With the side force per length `q`, half the spacing `l`, the bending stiffness `EI`, the tension
//! `F`, `z = (l/2) √(F/EI)` and `J = (z coth z − 1)/z²`, the curvature beyond the hole's is
//!
#![doc = include_str!("../../equations/joint-span.html")]
//!
//! (Lubinski 1961; Paslay and Cernocky 1991.) Theory, limits and sources:
//! `docs/src/theory/soft-string.md`.

use crate::string::Component;

/// One span of pipe from tool joint to tool joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointSpan {
    /// Bending stiffness of the body, N·m².
    pub bending_stiffness_N_m2: f64,
    /// Half of the distance between joints, m.
    pub half_spacing_m: f64,
    /// Standoff of the joints from the body, `(D_j − D)/2`, m.
    pub standoff_m: f64,
}

/// Part of a span that touches the wall between its joints.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BodyContact {
    /// Nothing.
    None,
    /// The middle.
    Middle,
    /// A stretch about the middle.
    Line,
}

/// Bending of a span against the hole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpanBending {
    /// Curvature at the joints beyond the hole's, 1/m, in the direction of the load.
    pub at_joint_per_m: f64,
    /// Curvature half-way beyond the hole's, 1/m, in the direction of the load.
    pub at_middle_per_m: f64,
    /// Sag of the body half-way beyond the hole's curve, m.
    pub sag_m: f64,
    /// Contact of the body.
    pub contact: BodyContact,
}

impl SpanBending {
    /// Nothing loads it.
    const STRAIGHT: Self =
        Self { at_joint_per_m: 0.0, at_middle_per_m: 0.0, sag_m: 0.0, contact: BodyContact::None };
}

impl JointSpan {
    /// The spans of a component; none where it has no joints or no standoff.
    pub fn of(component: &Component) -> Option<Self> {
        let joints = component.joints?;
        let standoff_m = 0.5 * (joints.od_m - component.od_m);
        (standoff_m > 0.0).then(|| Self {
            bending_stiffness_N_m2: component.bending_stiffness_N_m2(),
            half_spacing_m: 0.5 * joints.spacing_m,
            standoff_m,
        })
    }

    /// Bending of a span under an effective tension, N, by the magnitude of its load on the wall,
    /// N/m.
    pub fn bending(&self, tension_N: f64, load_N_per_m: f64) -> SpanBending {
        if load_N_per_m <= 0.0 {
            return SpanBending::STRAIGHT;
        }
        let length_square = self.half_spacing_m * self.half_spacing_m;
        // `z²`: negative in compression.
        let square = 0.25 * tension_N * length_square / self.bending_stiffness_N_m2;
        // `q l²/EI`, the curvature that the load requires.
        let required_per_m = load_N_per_m * length_square / self.bending_stiffness_N_m2;
        // Beyond it no shape holds the whole span off the wall, whatever the load.
        let bows = square <= -std::f64::consts::PI.powi(2);
        let shape = shape(square);
        let mean_per_m = 0.25 * required_per_m * shape;
        let held_per_m = 2.0 * self.standoff_m / (length_square * shape);
        if bows || mean_per_m >= held_per_m {
            let wrapped = 2.0 * load_N_per_m * self.standoff_m / self.bending_stiffness_N_m2;
            return SpanBending {
                at_joint_per_m: wrapped.sqrt(),
                at_middle_per_m: 0.0,
                sag_m: self.standoff_m,
                contact: BodyContact::Line,
            };
        }
        let hanging = 1.0 + square * shape;
        let sag_m = 0.125 * required_per_m * length_square * shape / hanging;
        let touches = hanging <= 0.0 || sag_m > self.standoff_m;
        let half_swing_per_m = if touches { held_per_m } else { 0.25 * required_per_m / hanging };
        SpanBending {
            at_joint_per_m: mean_per_m + half_swing_per_m,
            at_middle_per_m: mean_per_m - half_swing_per_m,
            sag_m: if touches { self.standoff_m } else { sag_m },
            contact: if touches { BodyContact::Middle } else { BodyContact::None },
        }
    }
}

/// `(z coth z − 1)/z²` of `z²`; of a negative one `(1 − y cot y)/y²` with `y² = −z²`, up to
/// `y = π`.
fn shape(square: f64) -> f64 {
    // The series' next term, 2/93555 z⁸, is then below rounding.
    const SMALL: f64 = 5e-3;
    if square.abs() < SMALL {
        return 1.0 / 3.0 + square * (-1.0 / 45.0 + square * (2.0 / 945.0 - square / 4725.0));
    }
    let root = square.abs().sqrt();
    let product = if square > 0.0 { root / libm::tanh(root) } else { root / libm::tan(root) };
    (product - 1.0) / square
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The series meets the closed form on both sides of zero: their arguments are 1e-11 apart, at
    /// a slope of 1/45, and rounding in the closed form is 1e-16 over the argument.
    #[test]
    fn the_shape_is_continuous() {
        for square in [5e-3_f64, -5e-3] {
            let (inside, outside) = (shape(square * 0.999_999_999), shape(square * 1.000_000_001));
            assert!((inside - outside).abs() < 1e-12, "{inside} {outside}");
        }
        assert_eq!(shape(0.0), 1.0 / 3.0);
    }

    /// The curvature goes over from one kind of contact to the next without a jump, in tension and
    /// compression.
    #[test]
    fn contacts_follow_each_other_without_a_jump() {
        let span =
            JointSpan { bending_stiffness_N_m2: 1.25e6, half_spacing_m: 4.8, standoff_m: 0.02 };
        for tension_N in [-6e5, -2e5, -1e3, 0.0, 1e3, 3e5, 2e6] {
            let mut last: Option<SpanBending> = None;
            let mut met = Vec::new();
            for step in 0..40_000 {
                let now = span.bending(tension_N, 1.0 + f64::from(step));
                if let Some(before) = last
                    && before.contact != now.contact
                {
                    met.push(now.contact);
                    // A step of 1 N/m changes the curvature by less than 1e-5 1/m.
                    let jump = (now.at_joint_per_m - before.at_joint_per_m).abs();
                    assert!(jump < 1e-5, "{tension_N}: {jump}");
                    let jump = (now.at_middle_per_m - before.at_middle_per_m).abs();
                    assert!(jump < 1e-5, "{tension_N}: {jump}");
                }
                last = Some(now);
            }
            assert_eq!(met.last(), Some(&BodyContact::Line), "{tension_N}");
        }
    }
}
