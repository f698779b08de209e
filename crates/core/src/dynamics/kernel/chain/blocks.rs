//! Blocks: all rows of a row of nodes or elements.

use serde::{Deserialize, Serialize};

use super::rows::{CopyLane, Row, Rows};
use crate::simd::number::Real;

/// A block of rows.
macro_rules! block {
    (
        $(#[$meta:meta])*
        pub struct $name:ident<R> {
            $($(#[$doc:meta])* pub $field:ident: $rows:ty,)*
        }
    ) => {
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, Serialize, Deserialize)]
        #[repr(C, align(64))]
        #[serde(bound = "")]
        pub struct $name<R: Real> {
            $($(#[$doc])* pub $field: $rows,)*
        }

        impl<R: Real, S: Real> CopyLane<$name<S>> for $name<R> {
            fn copy_lane(&mut self, lane: usize, from: &$name<S>, from_lane: usize) {
                $(self.$field.copy_lane(lane, &from.$field, from_lane);)*
            }
        }
    };
}

/// Clearance of a node that no wall is near, m.
pub const NO_WALL_M: f64 = 1e3;

block! {
    /// A row of nodes: how they move.
    pub struct StateBlock<R> {
        /// Displacement from the anchor, m.
        pub u: Rows<R>,
        /// Velocity, m/s, half a step behind the displacement.
        pub v: Rows<R>,
        /// Director.
        pub d: Rows<R>,
        /// Angular velocity across the director, rad/s.
        pub w: Rows<R>,
        /// Spin about the director, rad/s.
        pub spin: Row<R>,
    }
}

impl<R: Real> StateBlock<R> {
    pub(super) fn at_rest() -> Self {
        let (zero, one) = (Row::filled(0.0), Row::filled(1.0));
        Self { u: [zero; 3], v: [zero; 3], d: [zero, zero, one], w: [zero; 3], spin: zero }
    }

    /// Takes the states of `first` one lane lower, and the last of `last`.
    #[inline(always)]
    pub(super) fn lead_in_lanes(&mut self, first: &Self, last: &Self) {
        let Self { u, v, d, w, spin } = self;
        for axis in 0..3 {
            u[axis].lead_in_lanes(&first.u[axis], &last.u[axis]);
            v[axis].lead_in_lanes(&first.v[axis], &last.v[axis]);
            d[axis].lead_in_lanes(&first.d[axis], &last.d[axis]);
            w[axis].lead_in_lanes(&first.w[axis], &last.w[axis]);
        }
        spin.lead_in_lanes(&first.spin, &last.spin);
    }
}

block! {
    /// A row of nodes: their properties, the sums between samples, and last the data that a plain
    /// step does not need.
    pub struct NodeBlock<R> {
        /// Tangent of the hole's axis at the anchor.
        pub tangent: Rows<R>,
        /// Curvature vector of the hole's axis at the anchor, 1/m.
        pub curvature: Rows<R>,
        /// Buoyed weight, N.
        pub weight: Rows<R>,
        /// Inertia across the hole, kg: steel, mud inside and mud carried along outside.
        pub mass_lateral: Row<R>,
        /// Inverse of `mass_axial`; zero where the motion is prescribed.
        pub inv_mass_axial: Row<R>,
        /// Inverse of `mass_lateral`; zero where the motion is prescribed.
        pub inv_mass_lateral: Row<R>,
        /// Inverse of `polar`; zero where the spin is prescribed.
        pub inv_polar: Row<R>,
        /// Inverse of the moment of inertia across the director; zero where it may not turn.
        pub inv_rotary: Row<R>,
        /// `polar` over the moment of inertia across the director.
        pub gyroscopic: Row<R>,
        /// Clearance `R − r` between pipe and hole at the anchor, m.
        pub clearance: Row<R>,
        /// Contact radius `r`, m.
        pub radius: Row<R>,
        /// Kinetic friction coefficient.
        pub friction: Row<R>,
        /// Contact stiffness, N/m or N/m^1.5.
        pub stiffness: Row<R>,
        /// Part of the velocity across the hole that the mud's drag takes in a step.
        pub slowed: Row<R>,
        /// Sum over steps of the contact force, N.
        pub sum_normal: Row<R>,
        /// Sum over steps of the axial friction on the wall, N, along the hole.
        pub sum_axial: Row<R>,
        /// Sum over steps of the friction torque, N·m.
        pub sum_torque: Row<R>,
        /// Work that friction has done, J: force times sliding distance.
        pub sum_wear: Row<R>,
        /// Linear lateral drag, N·s/m.
        pub drag_linear: Row<R>,
        /// Quadratic lateral drag, N·s²/m².
        pub drag_quadratic: Row<R>,
        /// Inertia along the hole, kg: steel.
        pub mass_axial: Row<R>,
        /// Moment of inertia about the director, kg·m².
        pub polar: Row<R>,
        /// Increase of the clearance per metre below the anchor.
        pub clearance_slope: Row<R>,
        /// Increase of the friction coefficient at rest.
        pub friction_rise: Row<R>,
        /// Friction around the hole over friction along it.
        pub friction_around: Row<R>,
        /// Viscous drag of the mud along the hole, N·s/m.
        pub mud_axial: Row<R>,
        /// Viscous drag of the mud about the axis, N·m·s.
        pub mud_spin: Row<R>,
        /// Contact damping of the linear law, N·s/m.
        pub damping: Row<R>,
    }
}

block! {
    /// A row of elements; element `i` is between nodes `i` and `i + 1`.
    pub struct ElementBlock<R> {
        /// Twist, rad.
        pub twist: Row<R>,
        /// Chord between the anchors of the two ends, m.
        pub chord: Rows<R>,
        /// Square of that chord less the square of the rest length, m².
        pub excess: Row<R>,
        /// Stiffness, in the order of [`Stiffness`].
        pub length: Row<R>,
        /// `EA/L`.
        pub axial: Row<R>,
        /// `B₀ EI/L`.
        pub bending_far: Row<R>,
        /// `a L/2`.
        pub half_bow_near: Row<R>,
        /// `b L`.
        pub bow_far: Row<R>,
        /// `GJ/L`.
        pub torsion: Row<R>,
        /// `EI/L`.
        pub bending: Row<R>,
        /// Effective tension at the last step, N.
        pub tension: Row<R>,
        /// Torque `M` at the last step, N·m: negative while the top leads the bit.
        pub torque: Row<R>,
    }
}

block! {
    /// A row of nodes: their eccentric masses, if there are any.
    pub struct ImbalanceBlock<R> {
        /// Imbalance `U = Σ m e`, kg·m; zero of a node that has none.
        pub moment: Row<R>,
        /// `U g`, N·m.
        pub weight_moment: Row<R>,
        /// Its direction, across the director.
        pub toward: Rows<R>,
        /// That direction half a step before, where the velocities are.
        pub half: Rows<R>,
        /// Rounding error of the direction in single precision.
        pub rest: Rows<R>,
    }
}

impl<R: Real> ImbalanceBlock<R> {
    pub(super) fn none() -> Self {
        let (zero, one) = (Row::filled(0.0), Row::filled(1.0));
        let north = [one, zero, zero];
        Self { moment: zero, weight_moment: zero, toward: north, half: north, rest: [zero; 3] }
    }
}

impl<R: Real> NodeBlock<R> {
    /// Clears the sums between samples.
    pub fn clear_sums(&mut self) {
        let zero = Row::filled(0.0);
        (self.sum_normal, self.sum_axial) = (zero, zero);
        (self.sum_torque, self.sum_wear) = (zero, zero);
    }

    /// Nodes that fill the last lane: no force moves them, they move nothing and have no energy.
    /// Real nodes begin as these.
    pub(super) fn idle() -> Self {
        let row = Row::filled;
        let (zero, one) = (row(0.0), row(1.0));
        Self {
            tangent: [zero, zero, one],
            curvature: [zero; 3],
            weight: [zero; 3],
            mass_axial: zero,
            mass_lateral: zero,
            polar: zero,
            inv_mass_axial: zero,
            inv_mass_lateral: zero,
            inv_polar: zero,
            inv_rotary: zero,
            gyroscopic: zero,
            clearance: row(NO_WALL_M),
            clearance_slope: zero,
            radius: zero,
            friction: zero,
            friction_rise: zero,
            friction_around: one,
            stiffness: zero,
            damping: zero,
            slowed: zero,
            drag_linear: zero,
            drag_quadratic: zero,
            mud_axial: zero,
            mud_spin: zero,
            sum_normal: zero,
            sum_axial: zero,
            sum_torque: zero,
            sum_wear: zero,
        }
    }
}

impl<R: Real> ElementBlock<R> {
    pub(super) fn idle() -> Self {
        let row = Row::filled;
        let (zero, one) = (row(0.0), row(1.0));
        Self {
            twist: zero,
            chord: [zero, zero, one],
            excess: zero,
            length: one,
            axial: zero,
            bending_far: zero,
            half_bow_near: zero,
            bow_far: zero,
            torsion: zero,
            bending: zero,
            tension: zero,
            torque: zero,
        }
    }
}
