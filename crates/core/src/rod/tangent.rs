//! The tangent stiffness of an element in closed form, its tension an unknown of its own.
//!
//! With the tension `T` as a variable in addition to the shape, the energy of
//! [`element`](super::element) is linear in it:
//!
//! ```text
//! U = T g − T² L/(2 EA) + (EI/L){A₀[(1 − c1²) + (1 − c2²)]/2 + B₀(c12 − c1 c2)}
//! g = (l − L) + (a L/2)[(1 − c1²) + (1 − c2²)] − b L(c12 − c1 c2)
//! ```
//!
//! Newton's method on such a mixed form takes far longer steps than on displacements alone: the
//! tension of a step does not follow the bowing of its shape (D. Magisano, L. Leonetti and G.
//! Garcea, *Advantages of the mixed format in geometrically nonlinear analysis of beams and shells
//! using solid finite elements*, Int. J. Numer. Meth. Eng. 109 (2017)).

use nalgebra::{Matrix3, Vector3};

use super::{
    element::{self, Pose, Stiffness},
    vector::Vector,
};

/// Positions and directors of the ends of an element.
#[derive(Debug, Clone, Copy)]
pub struct Ends {
    /// From end 1 to end 2, m.
    pub chord_m: Vector3<f64>,
    /// Directors of both ends.
    pub directors: [Vector3<f64>; 2],
}

/// First derivatives of a function of [`Ends`]: by the chord, and by the two directors. The
/// component along a director has no meaning.
#[derive(Debug, Clone, Copy)]
pub struct Gradient {
    /// By the chord.
    pub chord: Vector3<f64>,
    /// By the directors.
    pub directors: [Vector3<f64>; 2],
}

/// An element under a tension: the forces on its ends, and their derivatives.
#[derive(Debug, Clone, Copy)]
pub struct Tangent {
    /// `∂U/∂`: N, N·m.
    pub gradient: Gradient,
    /// `g`, m: its elongation, its bowing included.
    pub longer_m: f64,
    /// `∂g/∂`: 1, m.
    pub lengthening: Gradient,
    /// `∂²U/∂r²`, N/m.
    pub chord_chord: Matrix3<f64>,
    /// `∂²U/∂r∂d`, N.
    pub chord_director: [Matrix3<f64>; 2],
    /// `∂²U/∂d²` of each director, as if its length were free, N·m.
    pub director: [Matrix3<f64>; 2],
    /// `∂U/∂d·d` of each director, N·m: the contribution of its rotation on the sphere to
    /// `∂²U/∂d²`.
    pub pull_N_m: [f64; 2],
    /// `∂²U/∂d1∂d2`, N·m.
    pub director_director: Matrix3<f64>,
}

fn vector(v: Vector3<f64>) -> Vector<f64> {
    v.into()
}

impl Ends {
    fn pose(&self) -> Pose<f64> {
        let [d1, d2] = self.directors.map(vector);
        Pose {
            anchor_chord: vector(self.chord_m),
            anchor_excess: 0.0,
            displacement: Vector::zero(),
            velocity: Vector::zero(),
            d1,
            d2,
            w1: Vector::zero(),
            w2: Vector::zero(),
            spin: 0.0,
            twist: 0.0,
        }
    }

    /// `g` of an element, m: its tension is `EA/L` of it.
    pub fn longer_m(&self, k: &Stiffness<f64>) -> f64 {
        let pose = self.pose();
        let chord = element::chord(k, &pose);
        element::longer(k, &chord, &pose)
    }
}

impl Tangent {
    /// An element under a tension, N.
    pub fn of(k: &Stiffness<f64>, ends: &Ends, tension_N: f64) -> Self {
        let pose = ends.pose();
        let chord = element::chord(k, &pose);
        let longer_m = element::longer(k, &chord, &pose);
        let strain = element::strain_under(k, &chord, &pose, tension_N);
        let bent = element::bend(&chord, &pose, &strain);
        let gradient = Gradient {
            chord: -Vector3::from(bent.force),
            directors: [bent.bend1.into(), bent.bend2.into()],
        };
        let t = Vector3::from(chord.direction);
        let over = chord.inverse_length;
        let [d1, d2] = ends.directors;
        let (c1, c2) = (t.dot(&d1), t.dot(&d2));
        let c12 = d1.dot(&d2);
        // ∂g/∂T of the gradients: `A` and `B` of the bowing alone.
        let (near, far) = (2.0 * k.half_bow_near, -k.bow_far);
        let (l1, l2) = (near * c1 + far * c2, near * c2 + far * c1);
        let across = |v: Vector3<f64>| v - t * t.dot(&v);
        let lengthening = Gradient {
            chord: t - across(d1 * l1 + d2 * l2) * over,
            directors: [d2 * far - t * l1, d1 * far - t * l2],
        };
        // A = A₀ EI/L + a L T, B = B₀ EI/L − b L T.
        let a = k.bending_near() + near * tension_N;
        let b = strain.shared;
        let (s1, s2) = (a * c1 + b * c2, a * c2 + b * c1);
        let tt = t * t.transpose();
        let p = Matrix3::identity() - tt;
        // By the chord's direction: gt = −(s1 d1 + s2 d2), and its derivative.
        let gt = -(d1 * s1 + d2 * s2);
        let symmetric = d1 * d2.transpose() + d2 * d1.transpose();
        let htt = -(d1 * d1.transpose() + d2 * d2.transpose()) * a - symmetric * b;
        let across_gt = across(gt);
        let mixed = across_gt * t.transpose();
        let chord_chord = p * (tension_N * over)
            + (p * htt * p - p * gt.dot(&t) - mixed - mixed.transpose()) * (over * over);
        // ∂gt/∂d1 = −s1 I − (A d1 + B d2) tᵀ.
        let by = |s: f64, own: Vector3<f64>| -p * (s * over) - across(own) * (t * over).transpose();
        Self {
            gradient,
            longer_m,
            lengthening,
            chord_chord,
            chord_director: [by(s1, d1 * a + d2 * b), by(s2, d2 * a + d1 * b)],
            director: [tt * -a; 2],
            pull_N_m: [b * c12 - s1 * c1, b * c12 - s2 * c2],
            director_director: p * b,
        }
    }
}
