//! Exact derivatives of expressions over a [`Number`], and the tangent stiffness of an element from
//! them.
//!
//! A dual number `a + b ε` with `ε² = 0` carries a derivative through every operation: `f(a + b ε)
//! = f(a) + f'(a) b ε`. J. A. Fike and J. J. Alonso, *The Development of Hyper-Dual Numbers for
//! Exact Second-Derivative Calculations*, AIAA 2011-886, shows why this beats differences: it has
//! no step, and loses no digits.

use std::ops::{Add, Div, Mul, Neg, Sub};

use nalgebra::{SMatrix, Vector3};

use super::{
    element::{Pose, Stiffness, react, twist},
    number::Number,
    vector::Vector,
};

/// A number and its derivative in one direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dual {
    /// The number.
    pub value: f64,
    /// Its derivative.
    pub slope: f64,
}

impl Dual {
    /// A number that changes at this rate.
    pub const fn new(value: f64, slope: f64) -> Self {
        Self { value, slope }
    }
}

impl Add for Dual {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.value + other.value, self.slope + other.slope)
    }
}

impl Sub for Dual {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::new(self.value - other.value, self.slope - other.slope)
    }
}

impl Mul for Dual {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let slope = self.slope * other.value + self.value * other.slope;
        Self::new(self.value * other.value, slope)
    }
}

impl Div for Dual {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self::new(value, (self.slope - value * other.slope) / other.value)
    }
}

impl Neg for Dual {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.value, -self.slope)
    }
}

impl Number for Dual {
    type Real = f64;
    const TINY: f64 = <f64 as Number>::TINY;
    const WIDTH: usize = 1;
    fn splat(value: f64) -> Self {
        Self::new(value, 0.0)
    }
    /// A constant.
    unsafe fn load(from: *const f64) -> Self {
        // SAFETY: the caller's `from` points to a number.
        Self::splat(unsafe { *from })
    }
    /// The number without its derivative.
    unsafe fn store(self, to: *mut f64) {
        // SAFETY: the caller's `to` points to a number.
        unsafe { *to = self.value }
    }
    /// Its derivative is not finite at zero.
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        Self::new(root, 0.5 * self.slope / root)
    }
    fn mul_add(self, factor: Self, term: Self) -> Self {
        self * factor + term
    }
    fn max(self, other: Self) -> Self {
        if self.value > other.value { self } else { other }
    }
    fn min(self, other: Self) -> Self {
        if self.value < other.value { self } else { other }
    }
    fn if_positive(self, then: Self, otherwise: Self) -> Self {
        if self.value > 0.0 { then } else { otherwise }
    }
    fn any_positive(self) -> bool {
        self.value > 0.0
    }
}

/// Tangent stiffness of an element in `pose`: derivatives of the forces and moments that hold it
/// with respect to displacement and rotation of end 1, then of end 2 (N/m, N, N·m), damping apart.
///
/// A row of three is a force, the next the moment, in the axes of the pose. Rotations are small
/// ones upon the pose, as vectors in the same axes; the moment of an end is the whole one, that
/// about its director included. The matrix is symmetric where no moment acts on an end; elsewhere
/// the moments turn with their frame of reference, which is not symmetric (J. C. Simo, *The
/// (symmetric) Hessian for geometrically nonlinear models in solid mechanics*, Comput. Methods
/// Appl. Mech. Eng. 96 (1992)).
pub fn tangent(k: &Stiffness<f64>, pose: &Pose<f64>) -> SMatrix<f64, 12, 12> {
    let constant = Dual::splat;
    let stiffness = Stiffness {
        length: constant(k.length),
        axial: constant(k.axial),
        bending_far: constant(k.bending_far),
        half_bow_near: constant(k.half_bow_near),
        bow_far: constant(k.bow_far),
        twist: constant(k.twist),
        bending: constant(k.bending),
    };
    SMatrix::from_columns(&std::array::from_fn::<_, 12, _>(|column| {
        let mut motion = [Vector3::zeros(); 4];
        motion[column / 3][column % 3] = 1.0;
        let moved = moved(k, pose, motion);
        let r = react(&stiffness, &moved, Dual::zero(), Dual::zero());
        let moment1 = r.bend1.cross(moved.d1) + r.couple;
        let moment2 = r.bend2.cross(moved.d2) - r.couple;
        // The element's action on its ends; the forces that hold it are the opposite.
        let acts = [-r.force, moment1, r.force, moment2];
        let slopes = acts.map(|action| [action.0.slope, action.1.slope, action.2.slope]);
        -nalgebra::SVector::<f64, 12>::from_iterator(slopes.into_iter().flatten())
    }))
}

/// A pose that changes with displacement and rotation of end 1, then of end 2.
fn moved(k: &Stiffness<f64>, pose: &Pose<f64>, motion: [Vector3<f64>; 4]) -> Pose<Dual> {
    let [u1, turn1, u2, turn2] = motion;
    let (d1, d2) = (vector(pose.d1), vector(pose.d2));
    let across = |turn: Vector3<f64>, d: Vector3<f64>| Vector::from(turn - d * turn.dot(&d));
    // The twist changes as in the element, at rates that are this motion in one second.
    let rates = Pose {
        w1: across(turn1, d1),
        w2: across(turn2, d2),
        spin: turn2.dot(&d2) - turn1.dot(&d1),
        twist: 0.0,
        ..*pose
    };
    let twist_rate = twist(k, &rates, 1.0, 0.0).twist;
    let changing = |value: Vector<f64>, slope: Vector3<f64>| {
        Vector(
            Dual::new(value.0, slope.x),
            Dual::new(value.1, slope.y),
            Dual::new(value.2, slope.z),
        )
    };
    let constant = |value: Vector<f64>| changing(value, Vector3::zeros());
    Pose {
        anchor_chord: constant(pose.anchor_chord),
        anchor_excess: Dual::splat(pose.anchor_excess),
        displacement: changing(pose.displacement, u2 - u1),
        velocity: Vector::zero(),
        d1: changing(pose.d1, turn1.cross(&d1)),
        d2: changing(pose.d2, turn2.cross(&d2)),
        w1: Vector::zero(),
        w2: Vector::zero(),
        spin: Dual::zero(),
        twist: Dual::new(pose.twist, twist_rate),
    }
}

fn vector(v: Vector<f64>) -> Vector3<f64> {
    Vector3::new(v.0, v.1, v.2)
}
