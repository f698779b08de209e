//! Eccentric masses in the step against the same one by one, around the step.

use super::*;
use crate::{
    dynamics::{
        body::{Body, loads::Loads},
        kernel::{
            chain::NodeImbalance,
            step::{StepInput, StepLosses},
        },
    },
    rod::bent::{carried, transported},
    simd::vector::Vector,
    string::{Cavity, ComponentSpec, Eccentricity, StringSpec},
};

/// The string of [`model`] with a collar whose offset is large, under pipe that has some or none.
fn eccentric_model(pipe_m: Option<f64>) -> Model {
    let mut model = model(0.3);
    let off = |offset_m| Eccentricity { offset_m, phase_rad: 0.3, cavity: Cavity::Mud };
    let collar = tool("collar", ComponentLength::Metres(27.0), 0.165, 0.0714);
    let pipe = tool("pipe", ComponentLength::ToSurface, 0.1397, 0.1186);
    let components = vec![
        ComponentSpec { eccentricity: Some(off(5e-3)), ..collar },
        ComponentSpec { eccentricity: pipe_m.map(off), ..pipe },
    ];
    model.string = StringSpec { components }.assemble(DEPTH_M).unwrap();
    model
}

/// A second after its start: it rotates, and much of it is on the wall.
fn turning(pipe_m: Option<f64>) -> Run<f64> {
    // More than eighty nodes that have a mass each.
    let settings =
        DynamicsSettings { mesh: MeshSettings::uniform(3.2), ..DynamicsSettings::default() };
    let mut run = new_run(&eccentric_model(pipe_m), &REAM, &settings);
    run.advance(1.0).unwrap();
    run.chain.clear_sums();
    run
}

fn unit(v: Vector<f64>) -> Vector<f64> {
    v.scaled(1.0 / v.dot(v).sqrt())
}

/// The simplest model of an eccentric mass: forces before the step and their consequences after it,
/// in passes until momentum and moment of momentum agree.
struct Plain {
    /// Not quite as the step has it: thrown by the change of `ω × q` from middle to middle, and the
    /// moment that a change of velocity leads to taken before the director turned.
    otherwise: bool,
    index: usize,
    imbalance: NodeImbalance,
    /// Before the step: director and velocity.
    before: [Vector<f64>; 2],
    led: Vector<f64>,
}

impl Plain {
    fn push(&mut self, chain: &Chain, dt: f64, loads: &mut Loads) {
        let (i, q) = (self.index, self.imbalance.toward);
        let omega = chain.turning(i).plus(chain.director(i), node!(chain, i, spin));
        self.before = [chain.director(i), chain.velocity(i)];
        let half = omega.cross(self.imbalance.half);
        self.led = if self.otherwise {
            omega.cross(unit(q.plus(omega.cross(q), 0.5 * dt)))
        } else {
            half.plus(omega.cross(omega.cross(q)), dt)
        };
        let change = self.led - half;
        let outwards = change.scaled(-self.imbalance.moment_kg_m / dt);
        let moment = q.cross(Vector(0.0, 0.0, self.imbalance.weight_moment_N_m));
        loads.add(chain, i, outwards, moment);
    }

    fn follow(&mut self, chain: &mut Chain, dt: f64) {
        let i = self.index;
        let NodeImbalance { moment_kg_m: size, toward: q, .. } = self.imbalance;
        let [director, v_before] = self.before;
        let (v_step, spin_step) = (chain.velocity(i), node!(chain, i, spin));
        let (d, w_step) = (chain.director(i), chain.turning(i));
        let half = unit(q + carried(q, director, d, spin_step * dt));
        let tangent = chain.tangent(i);
        let (lateral, axial) = (node!(chain, i, inv_mass_lateral), node!(chain, i, inv_mass_axial));
        let moved = |impulse: Vector<f64>| {
            let along = impulse.dot(tangent);
            impulse.minus(tangent, along).scaled(lateral).plus(tangent, along * axial)
        };
        let lever = if self.otherwise { q } else { transported(q, director, d) };
        let (mut dv, mut dw, mut ds) = (Vector::zero(), Vector::zero(), 0.0);
        for _ in 0..20 {
            let omega = (w_step + dw).plus(d, spin_step + ds);
            dv = moved((omega.cross(half) - self.led).scaled(-size));
            let moment = lever.cross(v_step + dv - v_before).scaled(-size);
            let about = moment.dot(d);
            ds = about * node!(chain, i, inv_polar);
            dw = moment.minus(d, about).scaled(node!(chain, i, inv_rotary));
        }
        let d_moved = unit(d.plus(dw.cross(d), dt));
        let w = w_step + dw;
        chain.set_velocity(i, v_step + dv);
        chain.set_displacement(i, chain.displacement(i).plus(dv, dt));
        chain.set_director(i, d_moved);
        chain.set_turning(i, w.minus(d_moved, w.dot(d_moved)));
        node!(chain, i, spin += ds);
        self.imbalance.half = half;
        self.imbalance.toward = carried(q, director, d_moved, (spin_step + ds) * dt);
    }
}

/// A chain and the losses of its steps.
struct Steps {
    chain: Chain,
    body: Body,
    plain: Vec<Plain>,
    losses: StepLosses,
}

impl Steps {
    fn of(run: &Run<f64>) -> Self {
        let (chain, body) = (run.chain.clone(), run.state.body.clone());
        Self { chain, body, plain: Vec::new(), losses: StepLosses::default() }
    }

    /// The same, every mass by itself.
    fn one_by_one(run: &Run<f64>, otherwise: bool) -> Self {
        let zero = Vector::zero();
        let plain = |(index, imbalance)| Plain {
            otherwise,
            index,
            imbalance,
            before: [zero; 2],
            led: zero,
        };
        let plain = run.state.body.imbalances(&run.chain).map(plain).collect();
        Self { plain, ..Self::without(run) }
    }

    /// The same without any.
    fn without(run: &Run<f64>) -> Self {
        let mut steps = Self { body: Body::default(), ..Self::of(run) };
        steps.chain.imbalance_blocks.clear();
        steps
    }

    fn take(&mut self, stepper: &mut Stepper, input: &StepInput, steps: usize) {
        let Self { chain, body, plain, losses } = self;
        let mut loads = Loads::default();
        for _ in 0..steps {
            for one in plain.iter_mut() {
                one.push(chain, input.dt, &mut loads);
            }
            let before = body.push(chain, input, 1.0);
            let excess = loads.apply(chain, input);
            let step = stepper.step(chain, input);
            let mud = loads.finish(chain, input);
            let after = body.follow(chain, input);
            for one in plain.iter_mut() {
                one.follow(chain, input.dt);
            }
            losses.contact += step.contact;
            losses.damping += step.damping + before.damping_loss_J - excess;
            losses.mud += step.mud + after.mud_loss_J - mud;
        }
    }

    fn toward(&self, index: usize) -> Vector<f64> {
        let mut imbalances = self.body.imbalances(&self.chain);
        match self.plain.iter().find(|one| one.index == index) {
            Some(one) => one.imbalance.toward,
            None => imbalances.find(|(i, _)| *i == index).map_or(Vector::zero(), |(_, x)| x.toward),
        }
    }

    /// Index of the loss in contact in [`Self::apart`].
    const CONTACT: usize = 6;

    /// Largest difference of each that a node has from its motion in `other`, and those of the
    /// losses, J.
    fn apart(&self, other: &Self) -> [f64; 10] {
        let nodes = |value: fn(&Self, usize) -> Vector<f64>| {
            let apart = |i| value(self, i) - value(other, i);
            (0..self.chain.nodes()).map(|i| apart(i).dot(apart(i)).sqrt()).fold(0.0, f64::max)
        };
        let sums = |sum: fn(&Self) -> f64| (sum(self) - sum(other)).abs();
        [
            nodes(|s, i| s.chain.displacement(i)),
            nodes(|s, i| s.chain.velocity(i)),
            nodes(|s, i| s.chain.director(i)),
            nodes(|s, i| s.chain.turning(i)),
            nodes(|s, i| Vector(0.0, 0.0, node!(s.chain, i, spin))),
            nodes(Self::toward),
            sums(|s| s.losses.contact),
            sums(|s| s.losses.mud),
            sums(|s| s.losses.damping),
            sums(|s| s.chain.take_up_wear(&mut vec![0.0; s.chain.nodes()])),
        ]
    }
}

/// Compared with the effect of the offsets on the string, losses included, in 200 steps of much
/// contact: within 1e-7 of it where each mass is computed by itself in the same way (a step's
/// rounding of 1e-15 grows to 2e-8 at the wall), within 2e-5 where its force and its moment are
/// computed otherwise: a director turns by 1e-6 in a step, and the square of the pipe's own turn in
/// it is 4e-6. The loss in contact then, 52 J, is within 1e-6 of itself: 2e-3 of the 0.04 J by
/// which the offsets change it.
#[test]
fn the_step_does_what_each_mass_would_do_by_itself() {
    let run = turning(Some(2e-3));
    let input = run.step_input();
    let mut stepper = run.stepper.clone();
    let mut after = |mut steps: Steps| {
        steps.take(&mut stepper, &input, 200);
        steps
    };
    let together = after(Steps::of(&run));
    assert!(together.chain.imbalances().count() > 80);
    let effect = together.apart(&after(Steps::without(&run)));
    for (otherwise, within, contact_within) in [(false, 1e-7, 1e-7), (true, 2e-5, 2e-3)] {
        let apart = together.apart(&after(Steps::one_by_one(&run, otherwise)));
        for (index, (apart, effect)) in apart.into_iter().zip(effect).enumerate() {
            let within = if index == Steps::CONTACT { contact_within } else { within };
            assert!(effect > 0.0 && apart < within * effect, "{otherwise}: {apart:e} {effect:e}");
        }
    }
}

/// Which nodes share a row with eccentric ones makes no difference to any of them: see
/// [`no_node_knows_who_shares_its_row`]. Here most nodes that share a row with the collar have
/// nothing eccentric.
#[test]
fn no_node_knows_whether_its_row_is_eccentric() {
    let run = turning(None);
    let (input, rows) = (run.step_input(), run.chain.node_blocks.len());
    let mut stepper = run.stepper.clone();
    let mut stepped = |mut chain: Chain| {
        for _ in 0..1000 {
            stepper.step(&mut chain, &input);
        }
        chain
    };
    let whole = stepped(run.chain.clone());
    assert!((4..12).contains(&whole.imbalances().count()));
    for longer in [1, 2, 5] {
        let other = stepped(run.chain.in_rows(rows + longer));
        for i in 0..whole.nodes() {
            let bits = |chain: &Chain| {
                let toward = chain.imbalance(i).map_or(Vector::zero(), |x| x.toward);
                let (v, d, w) = (chain.velocity(i), chain.director(i), chain.turning(i));
                let spin = node!(chain, i, spin);
                [v.0, v.1, v.2, d.0, d.1, w.0, w.1, toward.0, toward.1, spin].map(f64::to_bits)
            };
            assert_eq!(bits(&whole), bits(&other), "node {i}, {longer} rows more");
        }
    }
}
