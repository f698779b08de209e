//! The tangent stiffness of an element by dual numbers: against differences of its forces, and the
//! textbook.

use nalgebra::{Rotation3, SMatrix, SVector, Vector3};
use wholestring::rod::{
    dual::tangent,
    element::{Pose, Stiffness, react},
};

use crate::{element::pipe, plane::at_rest, random::Random};

type V = Vector3<f64>;
type Matrix = SMatrix<f64, 12, 12>;

const LENGTH_M: f64 = 1.7;

/// Both ends of an element, and its twist.
#[derive(Clone, Copy)]
struct Ends {
    chord: V,
    d: [V; 2],
    twist: f64,
}

impl Ends {
    /// Straight along a direction, longer than at rest by a strain.
    fn straight(along: V, strain: f64) -> Self {
        Self { chord: LENGTH_M * (1.0 + strain) * along, d: [along; 2], twist: 0.0 }
    }

    /// Strained by up to 0.2 %, its directors up to 8° from its chord, twisted.
    fn random(random: &mut Random) -> Self {
        let along = random.vector(1.0).normalize();
        let mut tilted = || Rotation3::new(random.across(along, 0.1)) * along;
        let d = [tilted(), tilted()];
        Self {
            chord: LENGTH_M * (1.0 + random.between(-2e-3, 2e-3)) * along,
            d,
            twist: random.between(-0.05, 0.05),
        }
    }

    fn pose(&self) -> Pose<f64> {
        let anchor = self.chord + V::new(0.011, -0.007, 0.004);
        Pose {
            displacement: (self.chord - anchor).into(),
            twist: self.twist,
            ..at_rest(anchor, LENGTH_M, self.d)
        }
    }

    /// Displaced and turned by so much of a unit motion.
    fn moved(&self, k: &Stiffness<f64>, motion: &SVector<f64, 12>, by: f64) -> Self {
        let part = |i: usize| V::from(motion.fixed_rows::<3>(3 * i));
        let turns = [part(1), part(3)];
        let across = |i: usize| turns[i] - self.d[i] * turns[i].dot(&self.d[i]);
        let rates = Pose {
            w1: across(0).into(),
            w2: across(1).into(),
            spin: turns[1].dot(&self.d[1]) - turns[0].dot(&self.d[0]),
            twist: 0.0,
            ..self.pose()
        };
        let turned = |i: usize| Rotation3::new(by * turns[i]) * self.d[i];
        Self {
            chord: self.chord + by * (part(2) - part(0)),
            d: [turned(0), turned(1)],
            twist: self.twist + by * react(k, &rates, 1.0, 0.0).twist,
        }
    }

    /// Forces and moments that hold both ends.
    fn holds(&self, k: &Stiffness<f64>) -> SVector<f64, 12> {
        let r = react(k, &self.pose(), 0.0, 0.0);
        let (force, couple) = (V::from(r.force), V::from(r.couple));
        let moment1 = V::from(r.bend1).cross(&self.d[0]) + couple;
        let moment2 = V::from(r.bend2).cross(&self.d[1]) - couple;
        let rows = [force, -moment1, -force, -moment2];
        SVector::from_iterator(rows.iter().flat_map(|row| row.iter().copied()))
    }

    /// The tangent by central differences.
    fn differences(&self, k: &Stiffness<f64>, step: f64) -> Matrix {
        Matrix::from_columns(&std::array::from_fn::<_, 12, _>(|column| {
            let motion = SVector::ith(column, 1.0);
            let there = self.moved(k, &motion, step).holds(k);
            let back = self.moved(k, &motion, -step).holds(k);
            (there - back) / (2.0 * step)
        }))
    }
}

/// Rotations in units of the element's length, so that all entries are N/m.
fn in_lengths(k: &Matrix) -> Matrix {
    let scale = |index: usize| if index / 3 % 2 == 1 { LENGTH_M } else { 1.0 };
    Matrix::from_fn(|row, column| k[(row, column)] / scale(row) / scale(column))
}

fn apart(a: &Matrix, b: &Matrix) -> f64 {
    let (a, b) = (in_lengths(a), in_lengths(b));
    (a - b).amax() / a.amax()
}

/// Found are 4.5e-5 at a step of 1e-2 (m, rad), a hundredth of it at a tenth of the step, and 5e-11
/// at 1e-5: less than 1e-9 is held there. Differences come the nearer to the tangent the smaller
/// their step, with its square, until rounding ends it: of 50 elements anywhere the largest
/// difference over the largest entry.
#[test]
fn differences_converge_to_the_tangent() {
    let k = Stiffness::new(&pipe(), LENGTH_M);
    let mut random = Random(7);
    let elements: Vec<Ends> = (0..50).map(|_| Ends::random(&mut random)).collect();
    let error = |step: f64| {
        let apart = |ends: &Ends| apart(&tangent(&k, &ends.pose()), &ends.differences(&k, step));
        elements.iter().map(apart).fold(0.0, f64::max)
    };
    let errors = [1e-2, 1e-3, 1e-4, 1e-5].map(error);
    for pair in errors[..3].windows(2) {
        assert!((90.0..110.0).contains(&(pair[0] / pair[1])), "{errors:?}");
    }
    assert!(errors[3] < 1e-9, "{errors:?}");
}

/// Nothing acts on the ends of a straight element but its tension: the tangent is symmetric, and a
/// motion of the whole strains nothing.
#[test]
fn a_straight_element_has_a_symmetric_tangent() {
    let k = Stiffness::new(&pipe(), LENGTH_M);
    let mut random = Random(3);
    for strain in [0.0, 1e-3, -5e-4] {
        let ends = Ends::straight(random.vector(1.0).normalize(), strain);
        let tangent = tangent(&k, &ends.pose());
        // Rounding: entries are sums of a few products.
        assert!(apart(&tangent, &tangent.transpose()) < 1e-12, "{strain}");
        let shift = random.vector(1.0);
        let zero = V::zeros();
        let whole = |parts: [V; 4]| {
            SVector::<f64, 12>::from_iterator(parts.iter().flat_map(|part| part.iter().copied()))
        };
        let held = tangent * whole([shift, zero, shift, zero]);
        assert!(held.amax() < 1e-6, "{held}");
        if strain == 0.0 {
            let turn = shift;
            let swing = turn.cross(&ends.chord) / 2.0;
            let held = tangent * whole([-swing, turn, swing, turn]);
            assert!(held.amax() < 1e-6 * tangent.amax(), "{held}");
        }
    }
}

/// At rest it is the stiffness matrix of a Timoshenko beam: J. S. Przemieniecki, *Theory of Matrix
/// Structural Analysis* (1968), eq. 5.116.
#[test]
fn at_rest_it_is_the_textbooks_beam() {
    let section = pipe();
    let k = Stiffness::new(&section, LENGTH_M);
    let ends = Ends::straight(V::x(), 0.0);
    let found = tangent(&k, &ends.pose());
    let ei = section.bending_stiffness_N_m2;
    let l = LENGTH_M;
    let phi = 12.0 * ei / (section.shear_stiffness_N * l * l);
    let over = ei / (1.0 + phi);
    for (row, column, expected) in [
        (0, 0, section.axial_stiffness_N / l),
        (0, 6, -section.axial_stiffness_N / l),
        (1, 1, 12.0 * over / l.powi(3)),
        (1, 7, -12.0 * over / l.powi(3)),
        (1, 5, 6.0 * over / l.powi(2)),
        (2, 4, -6.0 * over / l.powi(2)),
        (5, 5, (4.0 + phi) * over / l),
        (5, 11, (2.0 - phi) * over / l),
        (3, 3, section.torsional_stiffness_N_m2 / l),
        (3, 9, -section.torsional_stiffness_N_m2 / l),
        (0, 1, 0.0),
        (3, 4, 0.0),
    ] {
        let error = (found[(row, column)] - expected).abs() / section.axial_stiffness_N;
        assert!(error < 1e-12, "{row}, {column}: {}", found[(row, column)]);
    }
}
