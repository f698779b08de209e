//! One step of the whole chain: the inner loop of everything.
//!
//! Leapfrog (central differences): forces at the present positions kick the velocities across the
//! step, the velocities carry the positions on. Contact and friction act within the step, implicitly
//! at each node, so that they never limit it. One pass does both: a block of eight elements is
//! evaluated from positions that no node update has touched yet, then the block of nodes above it is
//! moved; only eight numbers are carried from block to block.
//!
//! Directors move on the sphere by Cayley's rotation, which keeps their length and the right angle
//! to their angular velocity to rounding.

use super::chain::{Chain, ElementBlock, NodeBlock, Row, Rows};
use crate::{
    rod::{
        element::{Pose, Stiffness, react},
        lanes::{LANES, Lanes},
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
    /// Into friction on the wall.
    pub friction: f64,
    /// Into wall contact, mud drag and mass-proportional damping.
    pub drag: f64,
    /// Into stiffness-proportional damping.
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
    ($name:ident, $fused:literal $(, $features:literal)?) => {
        $(#[target_feature(enable = $features)])?
        fn $name<const HERTZ: bool, const VECTOR: bool>(
            chain: &mut Chain,
            input: &StepInput,
        ) -> StepLosses {
            sweep::<$fused, HERTZ, VECTOR>(chain, input)
        }
    };
}

#[cfg(target_arch = "x86_64")]
compiled_for!(avx512, true, "avx512f,avx512dq,avx512vl,avx2,fma");
#[cfg(target_arch = "x86_64")]
compiled_for!(avx2, true, "avx2,fma");
#[cfg(target_arch = "aarch64")]
compiled_for!(baseline, true);
#[cfg(not(target_arch = "aarch64"))]
compiled_for!(baseline, false);

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

#[inline(always)]
fn load<const F: bool>(row: &Row) -> Lanes<F> {
    Lanes::load(&row.0)
}

#[inline(always)]
fn load3<const F: bool>(rows: &Rows) -> Vector<Lanes<F>> {
    Vector(load(&rows[0]), load(&rows[1]), load(&rows[2]))
}

#[inline(always)]
fn store3<const F: bool>(rows: &mut Rows, v: Vector<Lanes<F>>) {
    rows[0].0 = v.0.0;
    rows[1].0 = v.1.0;
    rows[2].0 = v.2.0;
}

#[inline(always)]
fn down<const F: bool>(here: Vector<Lanes<F>>, next: &Rows) -> Vector<Lanes<F>> {
    Vector(
        here.0.shifted_down(next[0].0[0]),
        here.1.shifted_down(next[1].0[0]),
        here.2.shifted_down(next[2].0[0]),
    )
}

#[inline(always)]
fn up<const F: bool>(here: Vector<Lanes<F>>, carried: Vector<f64>) -> Vector<Lanes<F>> {
    Vector(
        here.0.shifted_up(carried.0),
        here.1.shifted_up(carried.1),
        here.2.shifted_up(carried.2),
    )
}

#[inline(always)]
fn last<const F: bool>(v: Vector<Lanes<F>>) -> Vector<f64> {
    Vector(v.0.0[LANES - 1], v.1.0[LANES - 1], v.2.0[LANES - 1])
}

/// What the last element of a block does to the first node of the next.
struct Carried {
    force: Vector<f64>,
    moment: Vector<f64>,
    torque: f64,
}

/// What the elements do to a block of nodes.
struct Load<const F: bool> {
    force: Vector<Lanes<F>>,
    moment: Vector<Lanes<F>>,
    torque: Lanes<F>,
}

struct Losses<const F: bool> {
    friction: Lanes<F>,
    drag: Lanes<F>,
    damping: Lanes<F>,
}

#[inline(always)]
fn sweep<const F: bool, const HERTZ: bool, const VECTOR: bool>(
    chain: &mut Chain,
    input: &StepInput,
) -> StepLosses {
    let blocks = chain.node_blocks.len();
    let zero = Lanes::<F>::splat(0.0);
    let mut losses = Losses { friction: zero, drag: zero, damping: zero };
    let mut carried =
        Carried { force: Vector::zero(), moment: Vector::zero(), torque: 0.0 };
    for block in 0..blocks {
        let (here, below) = chain.node_blocks[block..].split_at_mut(1);
        let here = &mut here[0];
        // The last block has no elements past its last node: any neighbour serves the idle ones.
        let below = below.first().unwrap_or(&IDLE_NEIGHBOUR);
        let elements = &mut chain.element_blocks[block];
        let load = elements_of_block::<F>(elements, here, below, input, &mut carried, &mut losses);
        nodes_of_block::<F, HERTZ, VECTOR>(here, &load, input, &mut losses);
    }
    StepLosses {
        friction: losses.friction.sum(),
        drag: losses.drag.sum(),
        damping: losses.damping.sum() * input.dt,
    }
}

static IDLE_NEIGHBOUR: NodeBlock = NodeBlock::IDLE;

#[inline(always)]
fn elements_of_block<const F: bool>(
    e: &mut ElementBlock,
    here: &NodeBlock,
    below: &NodeBlock,
    input: &StepInput,
    carried: &mut Carried,
    losses: &mut Losses<F>,
) -> Load<F> {
    let u1 = load3(&here.u);
    let v1 = load3(&here.v);
    let d1 = load3(&here.d);
    let w1 = load3(&here.w);
    let s1 = load::<F>(&here.spin);
    let pose = Pose {
        anchor_chord: load3(&e.chord),
        anchor_excess: load(&e.excess),
        displacement: down(u1, &below.u) - u1,
        velocity: down(v1, &below.v) - v1,
        d1,
        d2: down(d1, &below.d),
        w1,
        w2: down(w1, &below.w),
        spin: s1.shifted_down(below.spin.0[0]) - s1,
        twist: load(&e.twist),
    };
    let stiffness = Stiffness {
        length: load(&e.length),
        inverse_length: load(&e.inverse_length),
        axial: load(&e.axial),
        bending_near: load(&e.bending_near),
        bending_far: load(&e.bending_far),
        bow_near: load(&e.bow_near),
        bow_far: load(&e.bow_far),
        twist: load(&e.torsion),
        bending: load(&e.bending),
    };
    let r = react(
        &stiffness,
        &pose,
        Lanes::<F>::splat(input.dt),
        Lanes::splat(input.stiffness_damping),
    );
    e.twist.0 = r.twist.0;
    e.tension.0 = r.tension.0;
    e.torque.0 = r.torque.0;
    losses.damping = losses.damping + r.damping_power;
    let load = Load {
        force: up(r.force, carried.force) - r.force,
        moment: up(r.moment2, carried.moment) + r.moment1,
        torque: r.torque - r.torque.shifted_up(carried.torque),
    };
    *carried = Carried {
        force: last(r.force),
        moment: last(r.moment2),
        torque: r.torque.0[LANES - 1],
    };
    load
}

#[inline(always)]
fn nodes_of_block<const F: bool, const HERTZ: bool, const VECTOR: bool>(
    n: &mut NodeBlock,
    elastic: &Load<F>,
    input: &StepInput,
    losses: &mut Losses<F>,
) {
    let splat = Lanes::<F>::splat;
    let (one, half) = (splat(1.0), splat(0.5));
    let dt = splat(input.dt);
    let alpha = splat(input.mass_damping);
    let calm = splat(1.0 / (1.0 + input.dt * input.mass_damping));
    let (rigid_v, rigid_s) = (splat(input.rigid_velocity), splat(input.rigid_spin));

    // Kick by the rod and by gravity.
    let th = load3::<F>(&n.tangent);
    let (per_ml, per_ma) = (load::<F>(&n.inv_mass_lateral), load::<F>(&n.inv_mass_axial));
    let per_j = load::<F>(&n.inv_polar);
    let (ml, ma, j) = (load::<F>(&n.mass_lateral), load::<F>(&n.mass_axial), load::<F>(&n.polar));
    let v0 = load3::<F>(&n.v);
    let s0 = load::<F>(&n.spin);
    let force = elastic.force + load3(&n.weight);
    let along = th.dot(force);
    let v1 = v0.plus(force, dt * per_ml).plus(th, dt * along * (per_ma - per_ml));
    let s1 = (dt * per_j).mul_add(elastic.torque, s0);

    // Mud drag and mass-proportional damping.
    let axial1 = th.dot(v1);
    let across1 = v1.minus(th, axial1);
    let speed = across1.dot(across1).sqrt();
    let drag = load::<F>(&n.drag_quadratic).mul_add(speed, load(&n.drag_linear));
    let rate = per_ml.mul_add(drag, alpha);
    let slowed = one / rate.mul_add(dt, one);
    let axial2 = (dt * alpha).mul_add(rigid_v, axial1) * calm;
    let across2 = across1.scaled(slowed);
    let v2 = across2.plus(th, axial2);
    let free = per_j.if_positive(one, splat(0.0));
    let s2 = (free * (dt * alpha)).mul_add(rigid_s, s1) * (free * (calm - one) + one);

    // Contact where the step would end, against the curved wall.
    let u0 = load3::<F>(&n.u);
    let end = u0.plus(v2, dt);
    let z = th.dot(end);
    let offset = end.minus(th, z).minus(load3(&n.curvature), half * (z * z));
    let rho = (offset.dot(offset) + splat(1e-30)).sqrt();
    let normal = offset.scaled(one / rho);
    let penetration = rho - load(&n.clearance);
    let inward = v2.dot(normal);
    let mobility = dt * per_ml;
    let stiffness = load::<F>(&n.stiffness);
    let push = if HERTZ {
        contact::hertz(penetration, inward, stiffness, splat(input.dissipation), dt * mobility)
    } else {
        let damping = load(&n.damping);
        contact::linear(penetration, inward, stiffness, damping, dt * mobility, mobility)
    };

    // Friction at the surface that touches.
    let around = th.cross(normal);
    let radius = load::<F>(&n.radius);
    let slip_around = radius.mul_add(s2, v2.dot(around));
    let slip_axial = axial2;
    let speed2 = slip_around.mul_add(slip_around, slip_axial * slip_axial);
    let limit =
        push * friction::coefficient(load(&n.friction), load(&n.friction_rise), speed2);
    // One newton always takes some speed away: a node that is held everywhere keeps its friction.
    let least = splat(1e-30);
    let g_axial = (dt * per_ma).max(least);
    let g_around = (dt * radius * radius).mul_add(per_j, mobility).max(least);
    let (rub_axial, rub_around) = if VECTOR {
        friction::vector(limit, slip_axial, slip_around, g_axial, g_around)
    } else {
        friction::independent(limit, slip_axial, slip_around, g_axial, g_around)
    };
    let rub_torque = rub_around * radius;
    let v3 = v2
        .minus(normal, mobility * push)
        .minus(around, mobility * rub_around)
        .minus(th, dt * per_ma * rub_axial);
    let s3 = (dt * per_j).neg_mul_add(rub_torque, s2);

    // Energy that left: every impulse works on the mean of the velocities before and after it.
    let v_mean = (v0 + v3).scaled(half);
    let s_mean = (s0 + s3) * half;
    let axial_mean = th.dot(v_mean);
    let rubbed = rub_around
        .mul_add(radius.mul_add(s_mean, around.dot(v_mean)), rub_axial * axial_mean);
    let dragged = (ml * rate).mul_add(across2.dot(v_mean), push * normal.dot(v_mean))
        + alpha
            * (ma * (axial2 - rigid_v)).mul_add(axial_mean, free * j * (s2 - rigid_s) * s_mean);
    losses.friction = dt.mul_add(rubbed, losses.friction);
    losses.drag = dt.mul_add(dragged, losses.drag);

    // Directors.
    let d0 = load3::<F>(&n.d);
    let w0 = load3::<F>(&n.w);
    let kicked = w0.plus(elastic.moment, dt * load(&n.inv_rotary)).scaled(calm);
    let p = half * dt * load::<F>(&n.gyroscopic) * s0;
    let p2 = p * p;
    // 1/(1 + p²) to rounding: p, half the precession in a step, is below 1e-2.
    let inverse = p2.mul_add(p2, one - p2);
    let turned = kicked
        .scaled((one - p2) * inverse)
        .minus(kicked.cross(d0), (p + p) * inverse);
    let w = turned.minus(d0, turned.dot(d0));
    let q = splat(0.25) * (dt * dt) * w.dot(w);
    let shrink = one / (one + q);
    let d = d0.scaled((one - q) * shrink).plus(w.cross(d0), dt * shrink);

    store3(&mut n.u, u0.plus(v3, dt));
    store3(&mut n.v, v3);
    store3(&mut n.d, d);
    store3(&mut n.w, w);
    n.spin.0 = s3.0;
    n.sum_normal.0 = (load::<F>(&n.sum_normal) + push).0;
    n.sum_axial.0 = (load::<F>(&n.sum_axial) + rub_axial).0;
    n.sum_torque.0 = (load::<F>(&n.sum_torque) + rub_torque).0;
}
