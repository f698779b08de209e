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
#[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
use crate::rod::number::Fused;
use crate::{
    rod::{
        element::{Pose, Stiffness, react},
        lanes::LANES,
        number::Number,
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
        f.debug_struct("Stepper")
            .field("instructions", &self.instructions)
            .finish()
    }
}

macro_rules! compiled_for {
    ($name:ident, $number:ty $(, $features:literal)?) => {
        $(#[target_feature(enable = $features)])?
        fn $name<const HERTZ: bool, const VECTOR: bool, const REST: bool>(
            chain: &mut Chain,
            input: &StepInput,
        ) -> StepLosses {
            sweep::<$number, HERTZ, VECTOR, REST>(chain, input)
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
    /// The fastest code for this processor and these laws: `hertz` or linear contact, `vector` or
    /// independent friction, and `rest` if friction at rest is stronger than sliding anywhere.
    pub fn new(hertz: bool, vector: bool, rest: bool) -> Self {
        macro_rules! choose {
            ($function:ident, $name:literal) => {
                Self {
                    step: match (hertz, vector, rest) {
                        (true, true, false) => $function::<true, true, false>,
                        (true, false, false) => $function::<true, false, false>,
                        (false, true, false) => $function::<false, true, false>,
                        (false, false, false) => $function::<false, false, false>,
                        (true, true, true) => $function::<true, true, true>,
                        (true, false, true) => $function::<true, false, true>,
                        (false, true, true) => $function::<false, true, true>,
                        (false, false, true) => $function::<false, false, true>,
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
fn sweep<N: Number, const HERTZ: bool, const VECTOR: bool, const REST: bool>(
    chain: &mut Chain,
    input: &StepInput,
) -> StepLosses {
    let blocks = chain.node_blocks.len();
    let mut losses = Losses::default();
    let mut pull = Pull::NONE;
    let mut flights = [Flight::NONE; TILE];
    let mut touch = Touch::NONE;
    for first in (0..blocks).step_by(TILE) {
        let tile = TILE.min(blocks - first);
        for k in 0..tile {
            let elements = &mut chain.element_blocks[first + k];
            elements_of_block::<N>(
                elements,
                &chain.state,
                first + k,
                input,
                &mut pull,
                k,
                &mut losses,
            );
        }
        let nodes = &mut chain.node_blocks[first..first + tile];
        for (k, (nodes, flight)) in nodes.iter().zip(&mut flights).enumerate() {
            fly::<N>(
                nodes,
                &chain.state,
                first + k,
                input,
                &pull,
                k,
                flight,
                &mut touch,
            );
        }
        touch.push::<N, HERTZ>(input);
        for (k, (nodes, flight)) in nodes.iter_mut().zip(&flights).enumerate() {
            let push = touch.push[k * LANES..]
                .first_chunk()
                .expect("a tile holds its blocks");
            land::<N, VECTOR, REST>(
                nodes,
                &mut chain.state,
                first + k,
                flight,
                push,
                input,
                &mut losses,
            );
        }
        for (k, nodes) in nodes.iter().enumerate() {
            turn::<N>(nodes, &mut chain.state, first + k, input, &pull, k);
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
    [
        eight(&strips[0], from),
        eight(&strips[1], from),
        eight(&strips[2], from),
    ]
}

/// The nine vectors that the elements of a block see.
#[inline(always)]
fn nine(fields: &[Field; 3], block: usize) -> [&[f64; LANES + 1]; 3] {
    [
        fields[0].nine(block),
        fields[1].nine(block),
        fields[2].nine(block),
    ]
}

#[inline(always)]
fn from<N: Number, const L: usize>(arrays: &[&[f64; L]; 3], lane: usize) -> Vector<N> {
    Vector(
        N::splat(arrays[0][lane]),
        N::splat(arrays[1][lane]),
        N::splat(arrays[2][lane]),
    )
}

/// Writes eight numbers to a strip from `from` on.
#[inline(always)]
fn write_eight(strip: &mut Strip, from: usize, values: &[f64; LANES]) {
    *strip[from..]
        .first_chunk_mut()
        .expect("a strip holds its tile") = *values;
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

/// Eight nodes on their way: what the rod, gravity, mud and damping make of the step before the wall
/// has its say. A tile is flown, then pushed, then landed: short loops over neighbours, so that the
/// processor works on several while it waits for a division.
#[derive(Clone, Copy)]
struct Flight {
    /// Velocity across the hole and along it, and spin, at the step's beginning.
    across0: [[f64; LANES]; 3],
    axial0: [f64; LANES],
    spin0: [f64; LANES],
    /// After the kick by the rod and by gravity.
    across1: [[f64; LANES]; 3],
    axial1: [f64; LANES],
    spin1: [f64; LANES],
    /// After mud drag and mass-proportional damping.
    across2: [[f64; LANES]; 3],
    axial2: [f64; LANES],
    spin2: [f64; LANES],
    /// Direction from the axis where the step would end.
    normal: [[f64; LANES]; 3],
}

impl Flight {
    const NONE: Self = Self {
        across0: [[0.0; LANES]; 3],
        axial0: [0.0; LANES],
        spin0: [0.0; LANES],
        across1: [[0.0; LANES]; 3],
        axial1: [0.0; LANES],
        spin1: [0.0; LANES],
        across2: [[0.0; LANES]; 3],
        axial2: [0.0; LANES],
        spin2: [0.0; LANES],
        normal: [[0.0; LANES]; 3],
    };
}

/// Kicks eight nodes and lets them fly to where the step would end without a wall.
#[inline(always)]
fn fly<N: Number>(
    n: &NodeBlock,
    state: &State,
    block: usize,
    input: &StepInput,
    pull: &Pull,
    k: usize,
    flight: &mut Flight,
    touch: &mut Touch,
) {
    let above = k * LANES;
    let below = above + 1;
    let force_above = eights(&pull.force, above);
    let force_below = eights(&pull.force, below);
    let torque_above = eight(&pull.torque, above);
    let torque_below = eight(&pull.torque, below);
    let (u, v) = (nine(&state.u, block), nine(&state.v, block));
    let spin = state.spin.nine(block);
    let splat = N::splat;
    let (one, half, dt) = (splat(1.0), splat(0.5), splat(input.dt));
    let alpha = splat(input.mass_damping);
    let calm = splat(1.0 / (1.0 + input.dt * input.mass_damping));
    let (rigid_v, rigid_s) = (splat(input.rigid_velocity), splat(input.rigid_spin));
    let (mut penetration, mut inward) = ([0.0; LANES], [0.0; LANES]);
    for lane in 0..LANES {
        // Kick by the rod and by gravity, along the hole and across it.
        let force =
            from::<N, 8>(&force_above, lane) - from(&force_below, lane) + at3(&n.weight, lane);
        let torque = splat(torque_below[lane]) - splat(torque_above[lane]);
        let th = at3::<N>(&n.tangent, lane);
        let per_ml = at::<N>(&n.inv_mass_lateral, lane);
        let per_j = at::<N>(&n.inv_polar, lane);
        let (v0, s0) = (from::<N, 9>(&v, lane), splat(spin[lane]));
        let along = th.dot(force);
        let axial0 = th.dot(v0);
        let across0 = v0.minus(th, axial0);
        let axial1 = (dt * at(&n.inv_mass_axial, lane)).mul_add(along, axial0);
        let across1 = across0.plus(force.minus(th, along), dt * per_ml);
        let s1 = (dt * per_j).mul_add(torque, s0);

        // Mud drag and mass-proportional damping.
        let speed = across0.dot(across0).sqrt();
        let drag = at::<N>(&n.drag_quadratic, lane).mul_add(speed, at(&n.drag_linear, lane));
        // 1/(1 + x) to 1e-8 for the x = 1e-2 that no mud exceeds; still a brake at any speed.
        let x = (per_ml.mul_add(drag, alpha) * dt).min(half);
        let slowed = x.mul_add(x.mul_add(one - x, -one), one);
        let axial2 = (axial1 - rigid_v).mul_add(calm, rigid_v);
        let across2 = across1.scaled(slowed);
        let calm_spin = per_j.if_positive(calm, one);
        let s2 = (s1 - rigid_s).mul_add(calm_spin, rigid_s);

        // Where the step would end, against the curved wall.
        let u0 = from::<N, 9>(&u, lane);
        let z0 = th.dot(u0);
        let z = dt.mul_add(axial2, z0);
        let offset = u0
            .minus(th, z0)
            .plus(across2, dt)
            .minus(at3(&n.curvature, lane), half * (z * z));
        let rho = (offset.dot(offset) + splat(1e-30)).sqrt();
        let normal = offset.scaled(one / rho);

        put(&mut flight.across0, lane, across0);
        flight.axial0[lane] = axial0.get();
        flight.spin0[lane] = s0.get();
        put(&mut flight.across1, lane, across1);
        flight.axial1[lane] = axial1.get();
        flight.spin1[lane] = s1.get();
        put(&mut flight.across2, lane, across2);
        flight.axial2[lane] = axial2.get();
        flight.spin2[lane] = s2.get();
        put(&mut flight.normal, lane, normal);
        penetration[lane] = (rho - at(&n.clearance, lane)).get();
        inward[lane] = across2.dot(normal).get();
    }
    let from = k * LANES;
    let to = from + LANES;
    touch.penetration[from..to].copy_from_slice(&penetration);
    touch.inward[from..to].copy_from_slice(&inward);
    touch.stiffness[from..to].copy_from_slice(&n.stiffness.0);
    touch.damping[from..to].copy_from_slice(&n.damping.0);
    touch.mass[from..to].copy_from_slice(&n.mass_lateral.0);
}

/// What decides the contact forces of a tile, in one piece.
struct Touch {
    /// Penetration where the step would end, m.
    penetration: [f64; TILE * LANES],
    /// Speed towards the wall, m/s.
    inward: [f64; TILE * LANES],
    /// Contact stiffness.
    stiffness: [f64; TILE * LANES],
    /// Damping of the linear law, N·s/m.
    damping: [f64; TILE * LANES],
    /// Lateral mass, kg.
    mass: [f64; TILE * LANES],
    /// Contact force, N.
    push: [f64; TILE * LANES],
}

impl Touch {
    const NONE: Self = Self {
        penetration: [0.0; TILE * LANES],
        inward: [0.0; TILE * LANES],
        stiffness: [0.0; TILE * LANES],
        damping: [0.0; TILE * LANES],
        mass: [1.0; TILE * LANES],
        push: [0.0; TILE * LANES],
    };

    /// Contact forces of the tile.
    #[inline(always)]
    fn push<N: Number, const HERTZ: bool>(&mut self, input: &StepInput) {
        let splat = N::splat;
        let per_dt2 = splat(1.0 / (input.dt * input.dt));
        for i in 0..TILE * LANES {
            let penetration = splat(self.penetration[i]);
            let inward = splat(self.inward[i]);
            let stiffness = splat(self.stiffness[i]);
            let mass = splat(self.mass[i]);
            let force = if HERTZ {
                let inertia = mass * per_dt2;
                contact::hertz(
                    penetration,
                    inward,
                    stiffness,
                    splat(input.dissipation),
                    inertia,
                )
            } else {
                let damping = splat(self.damping[i]);
                let dt = splat(input.dt);
                contact::linear(penetration, inward, stiffness, damping, mass, dt)
            };
            self.push[i] = force.get();
        }
    }
}

/// Lets the wall push and rub, and moves eight nodes to where the step ends.
#[inline(always)]
fn land<N: Number, const VECTOR: bool, const REST: bool>(
    n: &mut NodeBlock,
    state: &mut State,
    block: usize,
    flight: &Flight,
    push: &[f64; LANES],
    input: &StepInput,
    losses: &mut Losses,
) {
    let splat = N::splat;
    let (half, dt) = (splat(0.5), splat(input.dt));
    let old = nine(&state.u, block);
    let (mut u, mut v) = ([[0.0; LANES]; 3], [[0.0; LANES]; 3]);
    let mut spin = [0.0; LANES];
    let (mut rub_axial, mut rub_torque) = ([0.0; LANES], [0.0; LANES]);
    let mut lost = [0.0; LANES];
    for lane in 0..LANES {
        let th = at3::<N>(&n.tangent, lane);
        let per_ma = at::<N>(&n.inv_mass_axial, lane);
        let per_j = at::<N>(&n.inv_polar, lane);
        let mobility = dt * at(&n.inv_mass_lateral, lane);
        let across2 = held::<N>(&flight.across2, lane);
        let (axial2, s2) = (splat(flight.axial2[lane]), splat(flight.spin2[lane]));
        let normal = held::<N>(&flight.normal, lane);
        let force = splat(push[lane]);

        // Friction at the surface that touches.
        let around = th.cross(normal);
        let radius = at::<N>(&n.radius, lane);
        let slip = radius.mul_add(s2, across2.dot(around));
        let mu = if REST {
            let speed2 = slip.mul_add(slip, axial2 * axial2);
            friction::coefficient(at(&n.friction, lane), at(&n.friction_rise, lane), speed2)
        } else {
            at::<N>(&n.friction, lane)
        };
        let limit = force * mu;
        // One newton always takes some speed away: a node that is held everywhere keeps its friction.
        let least = splat(1e-30);
        let g_axial = (dt * per_ma).max(least);
        let g_around = (dt * radius * radius).mul_add(per_j, mobility).max(least);
        let (along, across) = if VECTOR {
            friction::vector(limit, axial2, slip, g_axial, g_around)
        } else {
            friction::independent(limit, axial2, slip, g_axial, g_around)
        };
        let torque = across * radius;
        let axial3 = (dt * per_ma).neg_mul_add(along, axial2);
        let across3 = across2
            .minus(normal, mobility * force)
            .minus(around, mobility * across);
        let v3 = across3.plus(th, axial3);
        let s3 = (dt * per_j).neg_mul_add(torque, s2);

        // Energy that left the string: every impulse but the rod's and gravity's works on the mean of
        // the velocities before and after the step.
        let (across1, axial1) = (held::<N>(&flight.across1, lane), splat(flight.axial1[lane]));
        let (across0, axial0) = (held::<N>(&flight.across0, lane), splat(flight.axial0[lane]));
        let (s0, s1) = (splat(flight.spin0[lane]), splat(flight.spin1[lane]));
        let work = (at::<N>(&n.mass_lateral, lane) * (across1 - across3).dot(across0 + across3))
            + (at::<N>(&n.mass_axial, lane) * (axial1 - axial3)).mul_add(
                axial0 + axial3,
                at::<N>(&n.polar, lane) * (s1 - s3) * (s0 + s3),
            );

        put(&mut u, lane, from::<N, 9>(&old, lane).plus(v3, dt));
        put(&mut v, lane, v3);
        spin[lane] = s3.get();
        rub_axial[lane] = along.get();
        rub_torque[lane] = torque.get();
        lost[lane] = (half * work).get();
    }
    for axis in 0..3 {
        *state.u[axis].eight(block) = u[axis];
        *state.v[axis].eight(block) = v[axis];
    }
    *state.spin.eight(block) = spin;
    add(&mut n.sum_normal.0, push);
    add(&mut n.sum_axial.0, &rub_axial);
    add(&mut n.sum_torque.0, &rub_torque);
    add(&mut losses.outside, &lost);
}

/// Turns the directors of eight nodes.
#[inline(always)]
fn turn<N: Number>(
    n: &NodeBlock,
    state: &mut State,
    block: usize,
    input: &StepInput,
    pull: &Pull,
    k: usize,
) {
    let above = k * LANES;
    let moment_above = eights(&pull.moment2, above);
    let moment_below = eights(&pull.moment1, above + 1);
    let splat = N::splat;
    let (one, half, dt) = (splat(1.0), splat(0.5), splat(input.dt));
    let calm = splat(1.0 / (1.0 + input.dt * input.mass_damping));
    let (old_d, old_w) = (nine(&state.d, block), nine(&state.w, block));
    let spin = state.spin.nine(block);
    let (mut d, mut w) = ([[0.0; LANES]; 3], [[0.0; LANES]; 3]);
    for lane in 0..LANES {
        let (d0, w0) = (from::<N, 9>(&old_d, lane), from::<N, 9>(&old_w, lane));
        let moment = from::<N, 8>(&moment_above, lane) + from(&moment_below, lane);
        let kicked = w0.plus(moment, dt * at(&n.inv_rotary, lane)).scaled(calm);
        let p = half * dt * at(&n.gyroscopic, lane) * splat(spin[lane]);
        // Cayley's rotation by the precession: (1 − p²)/(1 + p²) and 2p/(1 + p²), to rounding, for p,
        // half the precession in a step, is below 1e-2.
        let p2 = p * p;
        let sine = (p + p) * (one - p2);
        let cosine = (p2 + p2).mul_add(p2 - one, one);
        let turning = kicked.scaled(cosine).minus(kicked.cross(d0), sine);
        let q = splat(0.25 * input.dt * input.dt) * turning.dot(turning);
        // 1/(1 + q) to rounding: q is the square of half the turn in a step.
        let q2 = q * q;
        let shrink = (one - q).mul_add(one + q2, q2 * q2);
        let turned = d0
            .scaled((one - q) * shrink)
            .plus(turning.cross(d0), dt * shrink);
        put(&mut d, lane, turned);
        put(&mut w, lane, turning);
    }
    for axis in 0..3 {
        *state.d[axis].eight(block) = d[axis];
        *state.w[axis].eight(block) = w[axis];
    }
}

#[inline(always)]
fn held<N: Number>(arrays: &[[f64; LANES]; 3], lane: usize) -> Vector<N> {
    Vector(
        N::splat(arrays[0][lane]),
        N::splat(arrays[1][lane]),
        N::splat(arrays[2][lane]),
    )
}

#[inline(always)]
fn add(sum: &mut [f64; LANES], values: &[f64; LANES]) {
    for lane in 0..LANES {
        sum[lane] += values[lane];
    }
}
