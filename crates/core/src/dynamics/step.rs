//! One step of the whole chain: the inner loop of everything.
//!
//! Leapfrog (central differences): forces at the present positions kick the velocities across the
//! step, the velocities carry the positions on. Contact and friction act within the step, implicitly
//! at each node, so that they never limit it. One pass does both: a tile of elements is evaluated from
//! positions that no node has left yet, then the nodes above them are moved, while all of it is
//! still in the first-level cache.
//!
//! Directors move on the sphere by Cayley's rotation, which keeps their length and the right angle
//! to their angular velocity to rounding.

use super::chain::{Chain, ElementBlock, Field, NodeBlock, Row, Rows, State};
use crate::{
    rod::{
        element::{Pose, Stiffness, react},
        lanes::LANES,
        number::{Fused, Number},
        vector::Vector,
    },
    wall::{contact, friction},
};

/// What is the same for all nodes in a step.
#[derive(Debug, Clone, Copy)]
pub struct StepInput {
    /// Step, s.
    pub dt: f64,
    /// Stiffness-proportional damping, s.
    pub stiffness_damping: f64,
    /// Mass-proportional damping, 1/s.
    pub mass_damping: f64,
    /// Axial velocity of the rigid motion that mass-proportional damping leaves alone, m/s.
    pub rigid_velocity: f64,
    /// Spin of that motion, rad/s.
    pub rigid_spin: f64,
    /// Hunt-Crossley dissipation of the Hertz law, s/m.
    pub dissipation: f64,
}

/// Energies that left the string in a step, J.
#[derive(Debug, Clone, Copy, Default)]
pub struct StepLosses {
    /// To the wall (contact and friction), to the mud and to mass-proportional damping.
    pub outside: f64,
    /// To stiffness-proportional damping.
    pub damping: f64,
}

/// Which code does the step: the processor's best instructions, and the two laws.
#[derive(Clone, Copy)]
pub struct Stepper {
    step: unsafe fn(&mut Chain, &StepInput) -> StepLosses,
    /// Name of the instruction set in use.
    pub instructions: &'static str,
}

impl std::fmt::Debug for Stepper {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Stepper").field("instructions", &self.instructions).finish()
    }
}

macro_rules! compiled_for {
    ($name:ident, $number:ty $(, $features:literal)?) => {
        $(#[target_feature(enable = $features)])?
        fn $name<const HERTZ: bool, const VECTOR: bool>(
            chain: &mut Chain,
            input: &StepInput,
        ) -> StepLosses {
            sweep::<$number, HERTZ, VECTOR>(chain, input)
        }
    };
}

#[cfg(target_arch = "x86_64")]
compiled_for!(avx512, Fused, "avx512f,avx512dq,avx512vl,avx2,fma");
#[cfg(target_arch = "x86_64")]
compiled_for!(avx2, Fused, "avx2,fma");
#[cfg(target_arch = "aarch64")]
compiled_for!(baseline, Fused);
#[cfg(not(target_arch = "aarch64"))]
compiled_for!(baseline, f64);

impl Stepper {
    /// The fastest code for this processor and these laws.
    pub fn new(hertz: bool, vector: bool) -> Self {
        macro_rules! choose {
            ($function:ident, $name:literal) => {
                Self {
                    step: match (hertz, vector) {
                        (true, true) => $function::<true, true>,
                        (true, false) => $function::<true, false>,
                        (false, true) => $function::<false, true>,
                        (false, false) => $function::<false, false>,
                    },
                    instructions: $name,
                }
            };
        }
        #[cfg(target_arch = "x86_64")]
        {
            let fma = is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma");
            if fma
                && is_x86_feature_detected!("avx512f")
                && is_x86_feature_detected!("avx512dq")
                && is_x86_feature_detected!("avx512vl")
            {
                return choose!(avx512, "AVX-512");
            }
            if fma {
                return choose!(avx2, "AVX2");
            }
        }
        choose!(baseline, "baseline")
    }

    /// Advances the chain by one step.
    pub fn step(&self, chain: &mut Chain, input: &StepInput) -> StepLosses {
        // SAFETY: `new` picks only code whose instructions the processor was found to have.
        unsafe { (self.step)(chain, input) }
    }
}

/// Blocks of eight elements in a tile.
const TILE: usize = 8;

/// One number for each element of a tile, after that of the last element of the tile above.
type Strip = [f64; TILE * LANES + 1];

/// What the elements of a tile do to their ends.
struct Pull {
    force: [Strip; 3],
    moment1: [Strip; 3],
    moment2: [Strip; 3],
    torque: Strip,
}

impl Pull {
    const NONE: Self = Self {
        force: [[0.0; TILE * LANES + 1]; 3],
        moment1: [[0.0; TILE * LANES + 1]; 3],
        moment2: [[0.0; TILE * LANES + 1]; 3],
        torque: [0.0; TILE * LANES + 1],
    };

    /// Carries what the last element of a tile of `elements` does to the first node of the next.
    fn carry(&mut self, elements: usize) {
        for strip in self.force.iter_mut().chain(&mut self.moment2) {
            strip[0] = strip[elements];
        }
        self.torque[0] = self.torque[elements];
    }
}

/// Energy lost by each lane.
#[derive(Default)]
struct Losses {
    outside: [f64; LANES],
    damping: [f64; LANES],
}

#[inline(always)]
fn sweep<N: Number, const HERTZ: bool, const VECTOR: bool>(
    chain: &mut Chain,
    input: &StepInput,
) -> StepLosses {
    let blocks = chain.node_blocks.len();
    let mut losses = Losses::default();
    let mut pull = Pull::NONE;
    for first in (0..blocks).step_by(TILE) {
        let tile = TILE.min(blocks - first);
        for k in 0..tile {
            let elements = &mut chain.element_blocks[first + k];
            elements_of_block::<N>(elements, &chain.state, first + k, input, &mut pull, k, &mut losses);
        }
        for k in 0..tile {
            let nodes = &mut chain.node_blocks[first + k];
            nodes_of_block::<N, HERTZ, VECTOR>(
                nodes,
                &mut chain.state,
                first + k,
                input,
                &pull,
                k,
                &mut losses,
            );
        }
        pull.carry(tile * LANES);
    }
    StepLosses {
        outside: losses.outside.iter().sum(),
        damping: losses.damping.iter().sum::<f64>() * input.dt,
    }
}

#[inline(always)]
fn at<N: Number>(row: &Row, lane: usize) -> N {
    N::splat(row.0[lane])
}

#[inline(always)]
fn at3<N: Number>(rows: &Rows, lane: usize) -> Vector<N> {
    Vector(at(&rows[0], lane), at(&rows[1], lane), at(&rows[2], lane))
}

#[inline(always)]
fn put<N: Number>(arrays: &mut [[f64; LANES]; 3], lane: usize, v: Vector<N>) {
    arrays[0][lane] = v.0.get();
    arrays[1][lane] = v.1.get();
    arrays[2][lane] = v.2.get();
}

/// Eight numbers of a strip from `from` on.
#[inline(always)]
fn eight(strip: &Strip, from: usize) -> &[f64; LANES] {
    strip[from..].first_chunk().expect("a strip holds its tile")
}

/// Eight vectors of three strips from `from` on.
#[inline(always)]
fn eights(strips: &[Strip; 3], from: usize) -> [&[f64; LANES]; 3] {
    [eight(&strips[0], from), eight(&strips[1], from), eight(&strips[2], from)]
}

/// The nine vectors that the elements of a block see.
#[inline(always)]
fn nine(fields: &[Field; 3], block: usize) -> [&[f64; LANES + 1]; 3] {
    [fields[0].nine(block), fields[1].nine(block), fields[2].nine(block)]
}

#[inline(always)]
fn from<N: Number, const L: usize>(arrays: &[&[f64; L]; 3], lane: usize) -> Vector<N> {
    Vector(N::splat(arrays[0][lane]), N::splat(arrays[1][lane]), N::splat(arrays[2][lane]))
}

/// Writes eight numbers to a strip from `from` on.
#[inline(always)]
fn write_eight(strip: &mut Strip, from: usize, values: &[f64; LANES]) {
    *strip[from..].first_chunk_mut().expect("a strip holds its tile") = *values;
}

#[inline(always)]
fn elements_of_block<N: Number>(
    e: &mut ElementBlock,
    state: &State,
    block: usize,
    input: &StepInput,
    pull: &mut Pull,
    k: usize,
    losses: &mut Losses,
) {
    let u = nine(&state.u, block);
    let v = nine(&state.v, block);
    let d = nine(&state.d, block);
    let w = nine(&state.w, block);
    let spin = state.spin.nine(block);
    let (dt, beta) = (N::splat(input.dt), N::splat(input.stiffness_damping));
    let mut force = [[0.0; LANES]; 3];
    let mut moment1 = [[0.0; LANES]; 3];
    let mut moment2 = [[0.0; LANES]; 3];
    let (mut twist, mut tension, mut torque, mut damped) =
        ([0.0; LANES], [0.0; LANES], [0.0; LANES], [0.0; LANES]);
    for lane in 0..LANES {
        let next = lane + 1;
        let pose = Pose {
            anchor_chord: at3(&e.chord, lane),
            anchor_excess: at(&e.excess, lane),
            displacement: from::<N, 9>(&u, next) - from(&u, lane),
            velocity: from::<N, 9>(&v, next) - from(&v, lane),
            d1: from(&d, lane),
            d2: from(&d, next),
            w1: from(&w, lane),
            w2: from(&w, next),
            spin: N::splat(spin[next]) - N::splat(spin[lane]),
            twist: at(&e.twist, lane),
        };
        let stiffness = Stiffness {
            length: at(&e.length, lane),
            inverse_length: at(&e.inverse_length, lane),
            axial: at(&e.axial, lane),
            bending_near: at(&e.bending_near, lane),
            bending_far: at(&e.bending_far, lane),
            bow_near: at(&e.bow_near, lane),
            bow_far: at(&e.bow_far, lane),
            twist: at(&e.torsion, lane),
            bending: at(&e.bending, lane),
        };
        let r = react::<N>(&stiffness, &pose, dt, beta);
        twist[lane] = r.twist.get();
        tension[lane] = r.tension.get();
        torque[lane] = r.torque.get();
        put(&mut force, lane, r.force);
        put(&mut moment1, lane, r.moment1);
        put(&mut moment2, lane, r.moment2);
        damped[lane] = r.damping_power.get();
    }
    (e.twist.0, e.tension.0, e.torque.0) = (twist, tension, torque);
    add(&mut losses.damping, &damped);
    // Strips are one element late: place `i + 1` holds element `i`.
    let from = k * LANES + 1;
    for axis in 0..3 {
        write_eight(&mut pull.force[axis], from, &force[axis]);
        write_eight(&mut pull.moment1[axis], from, &moment1[axis]);
        write_eight(&mut pull.moment2[axis], from, &moment2[axis]);
    }
    write_eight(&mut pull.torque, from, &e.torque.0);
}

#[inline(always)]
fn nodes_of_block<N: Number, const HERTZ: bool, const VECTOR: bool>(
    n: &mut NodeBlock,
    state: &mut State,
    block: usize,
    input: &StepInput,
    pull: &Pull,
    k: usize,
    losses: &mut Losses,
) {
    let above = k * LANES;
    let below = above + 1;
    let force_above = eights(&pull.force, above);
    let force_below = eights(&pull.force, below);
    let moment_above = eights(&pull.moment2, above);
    let moment_below = eights(&pull.moment1, below);
    let torque_above = eight(&pull.torque, above);
    let torque_below = eight(&pull.torque, below);
    let (u0, v0) = (nine(&state.u, block), nine(&state.v, block));
    let (d0, w0) = (nine(&state.d, block), nine(&state.w, block));
    let spin0 = state.spin.nine(block);
    // Results are kept apart until all lanes are read, so that the compiler sees no overlap.
    let (mut u, mut v) = ([[0.0; LANES]; 3], [[0.0; LANES]; 3]);
    let (mut d, mut w) = ([[0.0; LANES]; 3], [[0.0; LANES]; 3]);
    let mut spin = [0.0; LANES];
    let (mut push, mut rub_axial, mut rub_torque) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
    let mut lost = [0.0; LANES];
    for lane in 0..LANES {
        let node = Node {
            force: from::<N, 8>(&force_above, lane) - from(&force_below, lane)
                + at3(&n.weight, lane),
            moment: from::<N, 8>(&moment_above, lane) + from(&moment_below, lane),
            torque: N::splat(torque_below[lane]) - N::splat(torque_above[lane]),
            u: from(&u0, lane),
            v: from(&v0, lane),
            d: from(&d0, lane),
            w: from(&w0, lane),
            spin: N::splat(spin0[lane]),
        };
        let moved = move_node::<N, HERTZ, VECTOR>(n, lane, &node, input);
        put(&mut u, lane, moved.u);
        put(&mut v, lane, moved.v);
        put(&mut d, lane, moved.d);
        put(&mut w, lane, moved.w);
        spin[lane] = moved.spin.get();
        push[lane] = moved.push.get();
        rub_axial[lane] = moved.rub_axial.get();
        rub_torque[lane] = moved.rub_torque.get();
        lost[lane] = moved.lost.get();
    }
    for axis in 0..3 {
        *state.u[axis].eight(block) = u[axis];
        *state.v[axis].eight(block) = v[axis];
        *state.d[axis].eight(block) = d[axis];
        *state.w[axis].eight(block) = w[axis];
    }
    *state.spin.eight(block) = spin;
    add(&mut n.sum_normal.0, &push);
    add(&mut n.sum_axial.0, &rub_axial);
    add(&mut n.sum_torque.0, &rub_torque);
    add(&mut losses.outside, &lost);
}

#[inline(always)]
fn add(sum: &mut [f64; LANES], values: &[f64; LANES]) {
    for lane in 0..LANES {
        sum[lane] += values[lane];
    }
}

/// A node, and what the rod and gravity do to it.
struct Node<N> {
    force: Vector<N>,
    moment: Vector<N>,
    torque: N,
    u: Vector<N>,
    v: Vector<N>,
    d: Vector<N>,
    w: Vector<N>,
    spin: N,
}

/// The node a step later, what it did to the wall, and the energy that it lost, J.
struct Moved<N> {
    u: Vector<N>,
    v: Vector<N>,
    d: Vector<N>,
    w: Vector<N>,
    spin: N,
    push: N,
    rub_axial: N,
    rub_torque: N,
    lost: N,
}

#[inline(always)]
fn move_node<N: Number, const HERTZ: bool, const VECTOR: bool>(
    n: &NodeBlock,
    lane: usize,
    node: &Node<N>,
    input: &StepInput,
) -> Moved<N> {
    let splat = N::splat;
    let (one, half) = (splat(1.0), splat(0.5));
    let dt = splat(input.dt);
    let alpha = splat(input.mass_damping);
    let calm = splat(1.0 / (1.0 + input.dt * input.mass_damping));
    let (rigid_v, rigid_s) = (splat(input.rigid_velocity), splat(input.rigid_spin));

    // Kick by the rod and by gravity, along the hole and across it.
    let th = at3::<N>(&n.tangent, lane);
    let (per_ml, per_ma) =
        (at::<N>(&n.inv_mass_lateral, lane), at::<N>(&n.inv_mass_axial, lane));
    let per_j = at::<N>(&n.inv_polar, lane);
    let (ml, ma, j) =
        (at::<N>(&n.mass_lateral, lane), at::<N>(&n.mass_axial, lane), at::<N>(&n.polar, lane));
    let mobility = dt * per_ml;
    let (v0, s0) = (node.v, node.spin);
    let along = th.dot(node.force);
    let axial0 = th.dot(v0);
    let across0 = v0.minus(th, axial0);
    let axial1 = (dt * per_ma).mul_add(along, axial0);
    let across1 = across0.plus(node.force.minus(th, along), mobility);
    let s1 = (dt * per_j).mul_add(node.torque, s0);

    // Mud drag and mass-proportional damping.
    let speed = across0.dot(across0).sqrt();
    let drag = at::<N>(&n.drag_quadratic, lane).mul_add(speed, at(&n.drag_linear, lane));
    let slowed = one / per_ml.mul_add(drag, alpha).mul_add(dt, one);
    let axial2 = (axial1 - rigid_v).mul_add(calm, rigid_v);
    let across2 = across1.scaled(slowed);
    let calm_spin = per_j.if_positive(calm, one);
    let s2 = (s1 - rigid_s).mul_add(calm_spin, rigid_s);

    // Contact where the step would end, against the curved wall.
    let u0 = node.u;
    let z0 = th.dot(u0);
    let z = dt.mul_add(axial2, z0);
    let offset = u0
        .minus(th, z0)
        .plus(across2, dt)
        .minus(at3(&n.curvature, lane), half * (z * z));
    let rho = (offset.dot(offset) + splat(1e-30)).sqrt();
    let normal = offset.scaled(one / rho);
    let penetration = rho - at(&n.clearance, lane);
    let inward = across2.dot(normal);
    let stiffness = at::<N>(&n.stiffness, lane);
    let push = if HERTZ {
        let inertia = ml * splat(1.0 / (input.dt * input.dt));
        contact::hertz(penetration, inward, stiffness, splat(input.dissipation), inertia)
    } else {
        let damping = at(&n.damping, lane);
        contact::linear(penetration, inward, stiffness, damping, dt * mobility, mobility)
    };

    // Friction at the surface that touches.
    let around = th.cross(normal);
    let radius = at::<N>(&n.radius, lane);
    let slip_around = radius.mul_add(s2, across2.dot(around));
    let speed2 = slip_around.mul_add(slip_around, axial2 * axial2);
    let limit = push
        * friction::coefficient(at(&n.friction, lane), at(&n.friction_rise, lane), speed2);
    // One newton always takes some speed away: a node that is held everywhere keeps its friction.
    let least = splat(1e-30);
    let g_axial = (dt * per_ma).max(least);
    let g_around = (dt * radius * radius).mul_add(per_j, mobility).max(least);
    let (rub_axial, rub_around) = if VECTOR {
        friction::vector(limit, axial2, slip_around, g_axial, g_around)
    } else {
        friction::independent(limit, axial2, slip_around, g_axial, g_around)
    };
    let rub_torque = rub_around * radius;
    let axial3 = (dt * per_ma).neg_mul_add(rub_axial, axial2);
    let across3 =
        across2.minus(normal, mobility * push).minus(around, mobility * rub_around);
    let v3 = across3.plus(th, axial3);
    let s3 = (dt * per_j).neg_mul_add(rub_torque, s2);

    // Energy that left the string: every impulse but the rod's and gravity's works on the mean of the
    // velocities before and after the step.
    let lost = (ml * (across1 - across3).dot(across0 + across3))
        + (ma * (axial1 - axial3)).mul_add(axial0 + axial3, j * (s1 - s3) * (s0 + s3));

    // Directors.
    let (d0, w0) = (node.d, node.w);
    let kicked = w0.plus(node.moment, dt * at(&n.inv_rotary, lane)).scaled(calm);
    let p = half * dt * at(&n.gyroscopic, lane) * s0;
    // Cayley's rotation by the precession: (1 − p²)/(1 + p²) and 2p/(1 + p²), to rounding, for p, half
    // the precession in a step, is below 1e-2.
    let p2 = p * p;
    let sine = (p + p) * (one - p2);
    let cosine = (p2 + p2).mul_add(p2 - one, one);
    let w = kicked.scaled(cosine).minus(kicked.cross(d0), sine);
    let q = splat(0.25 * input.dt * input.dt) * w.dot(w);
    // 1/(1 + q) to rounding: q is the square of half the turn in a step.
    let q2 = q * q;
    let shrink = (one - q).mul_add(one + q2, q2 * q2);
    let d = d0.scaled((one - q) * shrink).plus(w.cross(d0), dt * shrink);

    Moved {
        u: u0.plus(v3, dt),
        v: v3,
        d,
        w,
        spin: s3,
        push,
        rub_axial,
        rub_torque,
        lost: half * lost,
    }
}
