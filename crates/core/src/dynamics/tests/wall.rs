//! One node in its hole: whirl, oscillation on the low side, blows.

use serde_json::Value;
use wholestring_verification::{Row, report_worst, verify};

use crate::{
    common::{number, verification},
    dynamics::kernel::{
        chain::{Chain, node},
        step::{Abilities, Laws, StepInput, Stepper},
    },
    simd::vector::Vector,
    wall::contact::{contact_modulus_Pa, hertz_stiffness},
};

/// Step of a string in elements of 3.2 m, s.
const USUAL_STEP_S: f64 = 5.5e-4;

fn rows(name: &str) -> Vec<Value> {
    verification(name)["rows"].as_array().expect("rows").clone()
}

/// Description of a number in a row of the table, without the number.
#[derive(Clone, Copy)]
struct Claim<'a> {
    case: &'a str,
    quantity: &'a str,
    within: f64,
    reason: &'a str,
}

impl<'a> Claim<'a> {
    fn row(self, expected: f64, computed: f64) -> Row<'a> {
        verify(self.case, self.quantity).relative(self.within, self.reason).row(expected, computed)
    }
}

/// Steps at which a pipe in its hole is moved: that of a string and one that resolves more.
const STEPS_S: [f64; 2] = [USUAL_STEP_S, 1e-4];

/// Penetration of a pipe into the rock, with the results at either step.
const SINKS: &str =
    "it sinks into the rock by up to 6e-4 of its clearance; the source requires 1 %";

/// A node of 50 kg in a straight hole along the third axis, as Hertz's steel on rock.
struct Pipe {
    chain: Chain,
    stepper: Stepper,
    input: StepInput,
    clearance_m: f64,
    steps: u64,
}

const MASS_KG: f64 = 50.0;

impl Pipe {
    fn new(hole_radius_m: f64, radius_m: f64, friction: f64, dt: f64) -> Self {
        let clearance_m = hole_radius_m - radius_m;
        let modulus = contact_modulus_Pa(210e9, 0.3, 51.5e9, 0.33);
        let mut chain = Chain::new(1);
        node!(chain, 0, mass_axial = MASS_KG);
        node!(chain, 0, mass_lateral = MASS_KG);
        node!(chain, 0, inv_mass_lateral = 1.0 / MASS_KG);
        node!(chain, 0, clearance = clearance_m);
        node!(chain, 0, radius = radius_m);
        node!(chain, 0, friction = friction);
        node!(chain, 0, stiffness = hertz_stiffness(modulus, hole_radius_m, radius_m));
        Self {
            chain,
            stepper: Stepper::new(Abilities {
                laws: Laws { hertz: true, vector: true },
                full: false,
            }),
            input: StepInput { dt, stiffness_damping: 0.0, dissipation: 0.5, stribeck_speed: 0.1 },
            clearance_m,
            steps: 0,
        }
    }

    /// Lays it where it is pressed on the wall by `force_N`, at an angle, moving along the wall.
    fn place(&mut self, angle: f64, force_N: f64, speed_m_per_s: f64) {
        let sunk = (force_N / node!(self.chain, 0, stiffness)).powf(2.0 / 3.0);
        let (sin, cos) = angle.sin_cos();
        let offset = self.clearance_m + sunk;
        self.chain.set_displacement(0, Vector(offset * cos, offset * sin, 0.0));
        self.chain.set_velocity(0, Vector(-speed_m_per_s * sin, speed_m_per_s * cos, 0.0));
    }

    fn step(&mut self) {
        self.chain.find_drag(self.input.dt);
        self.stepper.step(&mut self.chain, &self.input);
        self.steps += 1;
    }

    fn angle(&self) -> f64 {
        let u = self.chain.displacement(0);
        u.1.atan2(u.0)
    }

    /// Continues for `seconds`; the mean rate at which it goes round, rad/s, and the mean contact
    /// force, N.
    fn round(&mut self, seconds: f64, mut push: impl FnMut(&mut Chain, f64)) -> (f64, f64) {
        let steps = (seconds / self.input.dt) as u64;
        self.chain.clear_sums();
        let (mut turned, mut before) = (0.0, self.angle());
        for _ in 0..steps {
            push(&mut self.chain, self.steps as f64 * self.input.dt);
            self.step();
            let now = self.angle();
            let turn = now - before;
            turned += turn - std::f64::consts::TAU * (turn / std::f64::consts::TAU).round();
            before = now;
        }
        let rate = turned / (steps as f64 * self.input.dt);
        (rate, node!(self.chain, 0, sum_normal) / steps as f64)
    }
}

/// E03: a turning pipe that touches the wall lightly is driven backwards along it by friction until
/// it rolls without slip, at `−Ω r/(R − r)`, pressed by `m (R − r) ω²`.
///
/// The file requires 1 % after the transient; 1e-3 is held, and 2e-3 for the force. Found is up to
/// 6e-4 at either step: the pipe sinks into the rock, by 1e-5 m of 0.025 m.
#[test]
fn a_pipe_that_rolls_whirls_backwards() {
    for row in rows("E03_whirl_in_clearance.json") {
        let (hole, radius) = (number(&row["R_hole"]), number(&row["r_pipe"]));
        let omega = number(&row["rpm"]) * std::f64::consts::TAU / 60.0;
        let found = STEPS_S.map(|dt| {
            let mut pipe = Pipe::new(hole, radius, 0.3, dt);
            node!(pipe.chain, 0, spin = omega);
            // A third of its final speed, which v' = μ v²/(R − r) then triples.
            let surface = omega * radius;
            pipe.place(0.0, 0.0, -surface / 3.0);
            let transient = 3.0 * pipe.clearance_m / (0.3 * surface);
            pipe.round(2.0 * transient, |_, _| ());
            let (rate, force) = pipe.round(2.0, |_, _| ());
            [rate, (omega - rate) / std::f64::consts::TAU, force / MASS_KG]
        });
        for (i, (what, key, within)) in [
            ("backward whirl, rad/s", "backward_whirl_rad_s", 1e-3),
            ("bending cycles, 1/s", "bending_cycles_per_s_in_pipe", 1e-3),
            ("force per mass, N/kg", "normal_force_per_kg_N", 2e-3),
        ]
        .into_iter()
        .enumerate()
        {
            let claim = Claim {
                case: "E03",
                quantity: &format!("{}: {what}", named(&row)),
                within,
                reason: SINKS,
            };
            let expected = number(&row["expected"][key]);
            report_worst(found.map(|found| claim.row(expected, found[i])));
        }
    }
}

/// Which of E03's rows it is.
fn named(row: &Value) -> String {
    let geometry = row["geom"].as_str().expect("a name");
    format!("{geometry} at {} rev/min", row["rpm"])
}

/// E03's condition: the whirl lasts where friction can balance the drag, `μ N` or more, and dies
/// where it cannot. A drag `c v` slows it here; `μ m (Ω r)²/(R − r) = c Ω r` is the limit, and 2 %
/// on either side decide: the deficit or excess of a whirl grows e-fold in `(R − r)/(μ Ω r)`, a
/// quarter of a second.
#[test]
fn backward_whirl_needs_its_friction() {
    for row in rows("E03_whirl_in_clearance.json") {
        let (hole, radius) = (number(&row["R_hole"]), number(&row["r_pipe"]));
        let surface = number(&row["rpm"]) * std::f64::consts::TAU / 60.0 * radius;
        for (part, lasts) in [(0.98, true), (1.02, false)] {
            let mut pipe = Pipe::new(hole, radius, 0.3, 1e-4);
            node!(pipe.chain, 0, spin = surface / radius);
            let limit = 0.3 * MASS_KG * surface / pipe.clearance_m;
            node!(pipe.chain, 0, drag_linear = part * limit);
            let pressed = MASS_KG * surface * surface / pipe.clearance_m;
            pipe.place(0.0, pressed, -surface);
            pipe.round(5.0, |_, _| ());
            let (rate, _) = pipe.round(1.0, |_, _| ());
            let rolling = -surface / pipe.clearance_m;
            let (quantity, expected, within, reason) = match lasts {
                true => ("a drag 2 % below the limit", 1.0, 1e-3, SINKS),
                false => (
                    "a drag 2 % above the limit",
                    0.0,
                    0.1,
                    "remainder of a dying whirl after five seconds, twenty e-folds",
                ),
            };
            verify("E03", format!("{}: whirl under {quantity} over the rolling one", named(&row)))
                .absolute(within, reason)
                .report(expected, rate / rolling);
        }
    }
}

/// E03: an unbalanced pipe that slides round its hole forwards, in step with its rotation. The
/// imbalance `F` runs ahead of the contact by `φ`, `F sin φ = μ N`, `N = m (R − r) Ω² + F cos φ`.
///
/// Rate and force are held to 1e-3 and 2e-3 as above; found is 6e-6 and 4e-4.
#[test]
fn an_unbalanced_pipe_whirls_in_step() {
    for row in rows("E03_whirl_in_clearance.json") {
        let (hole, radius) = (number(&row["R_hole"]), number(&row["r_pipe"]));
        let omega = number(&row["rpm"]) * std::f64::consts::TAU / 60.0;
        let mu = 0.2;
        let mut pipe = Pipe::new(hole, radius, mu, USUAL_STEP_S);
        node!(pipe.chain, 0, spin = omega);
        let inward = MASS_KG * pipe.clearance_m * omega * omega;
        let force = 3.0 * inward;
        // (N − inward)² + (μ N)² = F².
        let square = 1.0 + mu * mu;
        let normal = (inward
            + (inward * inward - square * (inward * inward - force * force)).sqrt())
            / square;
        let ahead = (mu * normal / force).asin();
        pipe.place(0.0, normal, omega * pipe.clearance_m);
        let kick = force / MASS_KG * pipe.input.dt;
        let push = |chain: &mut Chain, time: f64| {
            let (sin, cos) = (omega * time + ahead).sin_cos();
            let v = chain.velocity(0);
            chain.set_velocity(0, v + Vector(kick * cos, kick * sin, 0.0));
        };
        pipe.round(2.0, push);
        let (rate, found) = pipe.round(6.0, push);
        for (what, expected, found, within) in [
            ("whirl in step with its rotation, rad/s", omega, rate, 1e-3),
            ("force of the whirl in step, N", normal, found, 2e-3),
        ] {
            let claim = Claim {
                case: "E03",
                quantity: &format!("{}: {what}", named(&row)),
                within,
                reason: SINKS,
            };
            claim.row(expected, found).report();
        }
    }
}

/// E04: a pipe that swings across the low side of its hole by 2°: it slides where there is no
/// friction, and rolls where there is enough, which its rotary inertia makes slower. In mud the
/// weight is less and the mass more.
///
/// The file requires 1 %; 5e-4 is held. A swing of 2° is 8e-5 slower than a small one, and the pipe
/// has sunk into the rock, which lengthens the pendulum by as much; found is 2e-4 at either step.
#[test]
fn a_pipe_swings_across_the_low_side() {
    for row in rows("E04_pipe_in_trough_small_oscillation.json") {
        let [hole, outer, inner, inclination] =
            ["R_hole", "ro", "ri", "inc"].map(|key| number(&row[key]));
        for (buoyancy, added) in [(1.0, 0.0), (0.85, 0.4)] {
            for (rolls, key) in [(false, "slide_rad_s"), (true, "roll_rad_s")] {
                let lateral = MASS_KG * (1.0 + added);
                let polar = 0.5 * MASS_KG * (outer * outer + inner * inner);
                // The file's own rows are for air; mass and inertia part in mud.
                let inertia = if rolls { polar / (outer * outer) } else { 0.0 };
                let in_air = MASS_KG + inertia;
                let air = number(&row[key]);
                let expected = air * (buoyancy * in_air / (lateral + inertia)).sqrt();
                let found = STEPS_S.map(|dt| {
                    let friction = if rolls { 1.0 } else { 0.0 };
                    let mut pipe = Pipe::new(hole, outer, friction, dt);
                    let chain = &mut pipe.chain;
                    node!(chain, 0, mass_lateral = lateral);
                    node!(chain, 0, inv_mass_lateral = 1.0 / lateral);
                    node!(chain, 0, polar = polar);
                    node!(chain, 0, inv_polar = 1.0 / polar);
                    let weight = MASS_KG * crate::GRAVITY_M_PER_S2 * buoyancy;
                    let across = weight * inclination.to_radians().sin();
                    chain.set_weight(0, Vector(across, 0.0, 0.0));
                    pipe.place(2f64.to_radians(), across, 0.0);
                    std::f64::consts::TAU * swings_Hz(&mut pipe)
                });
                let way = if rolls { "rolling" } else { "sliding" };
                let medium = if added > 0.0 { "mud" } else { "air" };
                let claim = Claim {
                    case: "E04",
                    quantity: &format!(
                        "{way} in {medium}: radius {outer} m in one of {hole} m at {inclination}°, rad/s"
                    ),
                    within: 5e-4,
                    reason: "2° of swing, 8e-5, and sinking into the rock, 2e-4; the source \
                             requires 1 %",
                };
                report_worst(found.map(|found| claim.row(expected, found)));
            }
        }
    }
}

/// Swings in a second, over five, between interpolated zeros.
fn swings_Hz(pipe: &mut Pipe) -> f64 {
    let mut zeros = Vec::new();
    let mut before = pipe.angle();
    while zeros.len() < 11 {
        pipe.step();
        assert!(pipe.steps < 1_000_000, "it does not swing");
        let now = pipe.angle();
        if before * now < 0.0 {
            zeros.push((pipe.steps as f64 - now / (now - before)) * pipe.input.dt);
        }
        before = now;
    }
    5.0 / (zeros[10] - zeros[0])
}

/// A blow against the wall: deepest penetration, duration, largest force and the part of the speed
/// that is given back. `phase` is the part of a step at which it meets the wall.
fn impulse(
    mass_kg: f64,
    speed: f64,
    stiffness: f64,
    dt: f64,
    dissipation: f64,
    phase: f64,
) -> [f64; 4] {
    let mut pipe = Pipe::new(0.10795, 0.06985, 0.0, dt);
    pipe.input.dissipation = dissipation;
    let chain = &mut pipe.chain;
    node!(chain, 0, mass_lateral = mass_kg);
    node!(chain, 0, inv_mass_lateral = 1.0 / mass_kg);
    node!(chain, 0, stiffness = stiffness);
    let clearance = pipe.clearance_m;
    pipe.chain.set_displacement(0, Vector(clearance - phase * speed * dt, 0.0, 0.0));
    pipe.chain.set_velocity(0, Vector(speed, 0.0, 0.0));
    let (mut deepest, mut touched, mut strongest) = (0.0f64, 0.0, 0.0f64);
    loop {
        pipe.chain.clear_sums();
        pipe.step();
        let force = node!(pipe.chain, 0, sum_normal);
        let alpha = pipe.chain.displacement(0).0 - clearance;
        deepest = deepest.max(alpha);
        strongest = strongest.max(force);
        if force > 0.0 {
            touched += dt;
        }
        let back = -pipe.chain.velocity(0).0;
        if alpha < 0.0 && back >= 0.0 {
            return [deepest, touched, strongest, back / speed];
        }
    }
}

/// E06: a node that strikes the wall is Hertz's impact where the step resolves it: depth, duration
/// and force within the file's 1 % at a two-thousandth of the blow (the loss is first-order in the
/// step). At the usual step nothing is resolved: the restitution is stated, and agrees with the
/// reference.
#[test]
fn a_node_strikes_the_wall_as_hertz_says() {
    const STIFFNESS: f64 = 27_415_000_000.0;
    for row in rows("E06_hertz_impact.json") {
        let (mass, speed) = (number(&row["m"]), number(&row["v"]));
        let time = number(&row["contact_time_s"]);
        let [depth, duration, force, back] =
            impulse(mass, speed, STIFFNESS, time / 2000.0, 0.0, 0.4);
        for (what, unit, expected, found) in [
            ("depth", ", m", number(&row["alpha_max_m"]), depth),
            ("time of contact", ", s", time, duration),
            ("force", ", N", number(&row["F_max_N"]), force),
            ("restitution", "", 1.0, back),
        ] {
            let claim = Claim {
                case: "E06",
                quantity: &format!("a node's {what} of {mass} kg at {speed} m/s{unit}"),
                within: 0.01,
                reason: "the source's, met by two thousand steps in the contact; first order in the step",
            };
            claim.row(expected, found).report();
        }
    }
    for (speed, expected) in [(0.01, 0.47), (0.1, 0.33), (0.5, 0.22), (2.0, 0.125)] {
        let phases = 20;
        let back = (0..phases)
            .map(|i| {
                let phase = (f64::from(i) + 0.5) / f64::from(phases);
                impulse(120.0, speed, STIFFNESS, USUAL_STEP_S, 0.5, phase)[3]
            })
            .sum::<f64>()
            / f64::from(phases);
        // The book's digits.
        assert!((back - expected).abs() < 0.005, "{speed}: {back}");
    }
}

/// A heavy node pressed on the wall that slides at a speed which friction does not change in a
/// step: the friction that it meets, along and around, over the contact force.
fn friction_of(
    vector: bool,
    coefficients: [f64; 3],
    stribeck_speed: f64,
    along: f64,
    around: f64,
) -> [f64; 2] {
    let mut pipe = Pipe::new(0.10795, 0.07, coefficients[0], 2e-6);
    let chain = &mut pipe.chain;
    node!(chain, 0, inv_mass_axial = 1e-9);
    node!(chain, 0, inv_polar = 1e-9);
    node!(chain, 0, friction_rise = coefficients[1]);
    node!(chain, 0, friction_around = coefficients[2]);
    chain.set_weight(0, Vector(2000.0, 0.0, 0.0));
    pipe.input.stribeck_speed = stribeck_speed;
    pipe.stepper = Stepper::new(Abilities { laws: Laws { hertz: true, vector }, full: true });
    pipe.place(0.0, 2000.0, 0.0);
    // Of the spin alone: a node that slides sideways would climb.
    node!(pipe.chain, 0, spin = around / 0.07);
    pipe.chain.set_velocity(0, Vector(0.0, 0.0, along));
    pipe.step();
    let normal = node!(pipe.chain, 0, sum_normal);
    [node!(pipe.chain, 0, sum_axial) / normal, node!(pipe.chain, 0, sum_torque) / 0.07 / normal]
}

/// Friction by direction and by speed: on the cone `f = N (μ_a u_a, μ_t u_t)/|u|`, or each in full,
/// with the coefficient `μ_k + (μ_s − μ_k)/(1 + (|u|/v_s)²)`, `μ_t` in its ratio to `μ_a`.
///
/// Within 1e-3: in the step of 2 µs friction moves the node around by 2e-4 of these speeds.
#[test]
fn friction_knows_direction_and_speed() {
    for ratio in [1.0f64, 0.5, 1.4, 0.0] {
        for (along, around) in [(0.3f64, 0.4f64), (-0.05, 0.12), (0.6, -0.2)] {
            for stribeck in [0.02, 0.1, 1.0] {
                let speed = along.hypot(around);
                let mu = 0.25 + 0.1 / (1.0 + (speed / stribeck).powi(2));
                let [a, t] = friction_of(true, [0.25, 0.1, ratio], stribeck, along, around);
                let expected = [mu * along / speed, ratio * mu * around / speed];
                assert!((a - expected[0]).abs() < 1e-3 * mu, "{a} {expected:?}");
                assert!((t - expected[1]).abs() < 1e-3 * mu, "{t} {expected:?}");
                let [a, t] = friction_of(false, [0.25, 0.1, ratio], stribeck, along, around);
                let expected = [mu.copysign(along), (ratio * mu).copysign(around)];
                assert!((a - expected[0]).abs() < 1e-3 * mu, "{a} {expected:?}");
                assert!((t - expected[1]).abs() < 1e-3 * mu, "{t} {expected:?}");
            }
        }
    }
}
