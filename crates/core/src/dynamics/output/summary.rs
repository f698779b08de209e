//! From the record of a run to its answer.

use super::{
    energy::EnergyBalance,
    indicators::{Indicators, Motion},
    outcome::{DynamicOutcome, Numerics},
    record::{Quantity, Record, Spread},
    statistic::{Moments, Statistic, scales, varying_from},
    wear::Wear,
};
use crate::{
    dynamics::{
        boundary::{anchor::Anchor, bit::Bit, mud::FlowPressures},
        simulation::settling::{Settled, Settling},
    },
    model::Model,
    mud::Hydraulics,
    operation::Operation,
    outcome::{
        Column, History, HoleWear, Profile, ScalarHistory, Scalars, TIME_SERIES, TimeSeries,
        hole_depths_m,
        samples::{ends, mean},
        varying_place,
    },
    rod::{contact_length, mesh::Mesh, stability::StepPlan},
    statics::buckling::Place,
};

/// Sources of the results.
pub struct Sources<'a> {
    pub model: &'a Model,
    pub operation: &'a Operation,
    pub mesh: &'a Mesh,
    pub plan: &'a StepPlan,
    pub anchors: &'a [Anchor],
    pub record: &'a Record,
    /// The rows of the record and, where they are needed and kept, those that it handed over.
    pub history: History<'a>,
    /// Row of the history at which the window begins.
    pub from: usize,
    pub wear: &'a Wear,
    pub bit: &'a Bit,
    pub steps: u64,
    pub energy: Option<(EnergyBalance, f64)>,
    pub diverged: bool,
    pub hydraulics: Option<Hydraulics>,
    pub pressures: Option<FlowPressures>,
    /// Mean elongation of each element by the flow's pressures, m.
    pub flow_stretches_m: Option<Vec<f64>>,
    pub instructions: &'static str,
    pub settling: Settling,
    pub settled: Option<Settled>,
}

impl<'a> Sources<'a> {
    /// A scalar over the window.
    fn window(&self, column: &'static Column<TimeSeries>) -> ScalarHistory<'a> {
        self.history.scalar(column, self.from)
    }
}

const BIT_DEPTH: &Column<TimeSeries> = Column::named(TIME_SERIES, "bit_depth_m");
const HOOK_LOAD: &Column<TimeSeries> = Column::named(TIME_SERIES, "hook_load_N");
const WEIGHT_ON_BIT: &Column<TimeSeries> = Column::named(TIME_SERIES, "weight_on_bit_N");

/// The mean of a scalar whose statistics are taken; zero before the first sample.
macro_rules! window_mean {
    ($statistics:ident, $scalar:ident) => {{
        const PLACE: usize = varying_place(stringify!($scalar));
        $statistics.get(PLACE).map_or(0.0, |(_, statistic)| statistic.mean)
    }};
}

/// The answer.
pub fn outcome(s: &Sources<'_>) -> DynamicOutcome {
    let series = &s.record.series;
    let scalars = varying_from(s.history, s.from);
    let scales = scales(scalars.each_ref().map(|scalar| (scalar.scale, mean(&scalar.samples))));
    let statistics: Vec<(&'static str, Statistic)> = scalars
        .iter()
        .zip(scales)
        .filter_map(|(scalar, scale)| {
            Some((scalar.name, Statistic::on_scale(&scalar.samples, scale)?))
        })
        .collect();
    let nodes = profile(s);
    let bit_depths_m = s.window(BIT_DEPTH);
    let mean_bit_depth_m = mean(&bit_depths_m);
    let bit_travel_m = ends(&bit_depths_m).map_or(0.0, |[first, last]| last - first);
    let scalars = Scalars {
        hook_load_N: window_mean!(statistics, hook_load_N),
        surface_torque_N_m: window_mean!(statistics, surface_torque_N_m),
        friction_torque_N_m: window_mean!(statistics, friction_torque_N_m),
        axial_friction_N: window_mean!(statistics, axial_friction_N),
        side_force_total_N: window_mean!(statistics, side_force_total_N),
        weight_on_bit_N: window_mean!(statistics, weight_on_bit_N),
        bit_torque_N_m: window_mean!(statistics, bit_torque_N_m),
        twist_rad: window_mean!(statistics, twist_rad),
        stretch_m: window_mean!(statistics, stretch_m),
        neutral_point_m: crate::outcome::neutral_point_m(&nodes.md_m, &nodes.tension_N),
        cutoff_depth_m: crate::outcome::cutoff_in_build_m(
            &s.model.well.path,
            mean_bit_depth_m,
            &nodes.md_m,
            &nodes.side_force_N_per_m,
        ),
    };
    let indicators = indicators_of(s, &nodes);
    let back_m = back_m(s);
    DynamicOutcome {
        scalars,
        statistics,
        hydraulics: s.hydraulics,
        numerics: Numerics {
            elements: s.mesh.elements.len(),
            time_step_s: s.plan.dt_s,
            assembly_steps: s.plan.subcycling.as_ref().map(|lower| lower.parts),
            steps: s.steps,
            added_axial_mass_fraction: s.plan.added_axial_mass_fraction,
            max_penetration_m: s.record.max_penetration_m,
            deepest_contact: s.record.deepest_contact,
            energy_residual: match s.energy {
                Some((_, residual)) => residual,
                None => f64::from(u8::from(s.diverged)),
            },
            energy: s.energy.map(|(parts, _)| parts),
            instructions: s.instructions.into(),
            settle_s: match (s.settled, s.settling) {
                (Some(settled), _) => settled.settle_s,
                (None, Settling::Fixed(settle_s)) => settle_s,
                (None, Settling::UntilSteady { .. }) => {
                    series.time_s.last().copied().unwrap_or(0.0)
                }
            },
            settled: match s.settling {
                Settling::Fixed(_) => None,
                Settling::UntilSteady { .. } => s.settled.map(|settled| settled.steady),
            },
            mean_bit_depth_m,
            bit_travel_m,
            buckled_element: s.record.buckled_element(s.mesh, |i| s.anchors[i].md_m - back_m),
        },
        indicators,
        bit_table: s.bit.table_use(),
        nodes,
        wear: hole_wear(s),
        contact: s.record.contact_map().clone(),
        series: series.clone(),
    }
}

/// The indicators alone, at a hundredth of the time that the whole answer takes.
pub fn indicators(s: &Sources<'_>) -> Indicators {
    let mut nodes = Profile::default();
    let back_m = back_m(s);
    for (i, anchor) in s.anchors.iter().enumerate() {
        nodes.md_m.push(anchor.md_m - back_m);
        push_circling(&mut nodes, s.record, i);
    }
    indicators_of(s, &nodes)
}

fn indicators_of(s: &Sources<'_>, nodes: &Profile) -> Indicators {
    Indicators::of(&Motion {
        mesh: s.mesh,
        nodes,
        history: s.history,
        from: s.from,
        rotates: s.operation.kind.rotates(),
        rated_torque_N_m: s.model.rig.top_drive_torque_N_m,
    })
}

/// Adds the circulation of a node round the hole.
fn push_circling(p: &mut Profile, record: &Record, i: usize) {
    let circling = record.circling(i);
    p.lateral_offset_m.push(record.offset(i));
    p.whirl_rate_rad_per_s.push(circling.rate_rad_per_s);
    p.whirl_coherence.push(circling.coherence);
}

/// Mean height of the string above its anchors over the window, m: the anchors are those at the end
/// of the run, the string was at the position of its bit.
fn back_m(s: &Sources<'_>) -> f64 {
    let bit_depths_m = s.window(BIT_DEPTH);
    ends(&bit_depths_m).map_or(0.0, |[_, last]| last - mean(&bit_depths_m))
}

/// The profile over the window.
fn profile(s: &Sources<'_>) -> Profile {
    let n = s.mesh.nodes.len();
    let back_m = back_m(s);
    let record = s.record;
    // Tension and torque live in elements, everything else at nodes.
    let ends = |i: usize| [i.saturating_sub(1), i.min(n - 2)];
    let at_node = |i: usize, spread: &dyn Fn(usize) -> Spread| {
        let [above, below] = ends(i).map(spread);
        (0.5 * (above.mean + below.mean), 0.5 * (above.std + below.std))
    };
    let percentiles = |of_elements: &[[f64; 3]], i: usize| {
        let [above, below] = ends(i).map(|e| of_elements[e]);
        [0, 1, 2].map(|k| 0.5 * (above[k] + below[k]))
    };
    let tensions = record.percentiles(Quantity::Tension);
    let torques = record.percentiles(Quantity::Torque);
    let contacts = record.percentiles(Quantity::Contact);
    let mut p = Profile::default();
    for (i, contact) in contacts.into_iter().enumerate() {
        let (tension, tension_std) = at_node(i, &|e| record.tension(e));
        let (torque, torque_std) = at_node(i, &|e| record.torque(e));
        let normal = record.normal(i);
        p.md_m.push(s.anchors[i].md_m - back_m);
        let element = &s.mesh.elements[i.min(n - 2)];
        p.element_length_m.push(element.length_m);
        p.element_size.push(element.reason);
        p.tension_N.push(tension);
        p.tension_std_N.push(tension_std);
        let [low, middle, high] = percentiles(&tensions, i);
        p.tension_p05_N.push(low);
        p.tension_p50_N.push(middle);
        p.tension_p95_N.push(high);
        p.torque_N_m.push(-torque);
        p.torque_std_N_m.push(torque_std);
        // The chain's torque has the other sign: its low percentile is the high one here.
        let [low, middle, high] = percentiles(&torques, i);
        p.torque_p05_N_m.push(-high);
        p.torque_p50_N_m.push(-middle);
        p.torque_p95_N_m.push(-low);
        p.contact_force_N.push(normal.mean);
        p.contact_force_std_N.push(normal.std);
        p.contact_force_max_N.push(record.normal_max(i));
        let [low, middle, high] = contact;
        p.contact_force_p05_N.push(low);
        p.contact_force_p50_N.push(middle);
        p.contact_force_p95_N.push(high);
        p.contact_fraction.push(record.touched(i));
        p.climb_rad.push(record.climb_rad(i));
        p.lateral_speed_rms_m_per_s.push(record.lateral_speed(i));
        push_circling(&mut p, record, i);
    }
    // At the ends the neighbours are half an element off; hoist and bit are there.
    let end = |column| Moments::of(&s.window(column)).map_or((0.0, 0.0), |end| (end.mean, end.std));
    let (hook, hook_std) = end(HOOK_LOAD);
    let (weight, weight_std) = end(WEIGHT_ON_BIT);
    (p.tension_N[0], p.tension_std_N[0]) = (hook, hook_std);
    let jet = s.hydraulics.map_or(0.0, |mud| mud.jet_thrust_N);
    let pull = s.operation.bit_pull_now_N();
    (p.tension_N[n - 1], p.tension_std_N[n - 1]) = (pull - weight - jet, weight_std);
    let contact_spans = contact_length::contact_spans(s.mesh, |i| record.normal(i).mean > 0.0);
    p.side_force_N_per_m = contact_length::spread(&contact_spans, n, |i| record.signed(i));
    let sides = record.percentiles(Quantity::Side);
    [p.side_force_p05_N_per_m, p.side_force_p50_N_per_m, p.side_force_p95_N_per_m] =
        [0, 1, 2].map(|k| contact_length::spread(&contact_spans, n, |i| sides[i][k]));
    p.axial_friction_N_per_m = contact_length::spread(&contact_spans, n, |i| -record.axial(i));
    p.friction_torque_N_m_per_m =
        contact_length::spread(&contact_spans, n, |i| record.friction_torque(i));
    p.wear_work_J_per_m = contact_length::spread(&contact_spans, n, |i| s.wear.string_J(i));
    p.wear_power_W_per_m = rates(&p.wear_work_J_per_m, window_s(s));
    (p.twist_rad, p.stretch_m) = deformed(s);
    load(s, &mut p);
    for i in 0..n {
        let place = Place::above(s.model, s.operation.bit_depth_m, p.md_m[i]);
        p.push_buckling_loads(place.loads_N(s.model.buckling, -p.tension_N[i]));
    }
    p
}

/// Work of friction on the hole over the window.
fn hole_wear(s: &Sources<'_>) -> HoleWear {
    let work = s.wear.hole_J_per_m(|i| s.anchors[i].md_m);
    HoleWear {
        md_m: hole_depths_m(work.len()),
        wear_power_W_per_m: rates(&work, window_s(s)),
        wear_work_J_per_m: work,
    }
}

/// Time that the window takes until the last sample, s: its first sample holds the steps before it,
/// too.
fn window_s(s: &Sources<'_>) -> f64 {
    let end_s = s.record.series.time_s.last();
    end_s.map_or(0.0, |end_s| end_s - s.record.window_from_s)
}

/// Mean rates of the work over a time.
fn rates(work: &[f64], seconds: f64) -> Vec<f64> {
    let rate = |w: &f64| if seconds > 0.0 { w / seconds } else { 0.0 };
    work.iter().map(rate).collect()
}

/// Mean turn of each node against the bit and mean elongation between them, summed from the bit up.
fn deformed(s: &Sources<'_>) -> (Vec<f64>, Vec<f64>) {
    let nodes = s.mesh.nodes.len();
    let (mut twist_rad, mut stretch_m) = (vec![0.0; nodes], vec![0.0; nodes]);
    for element in (0..nodes - 1).rev() {
        // The chain's twist has the other sign.
        twist_rad[element] = twist_rad[element + 1] - s.record.twist(element);
        let by_flow_m =
            s.flow_stretches_m.as_ref().map_or(0.0, |flow_stretches_m| flow_stretches_m[element]);
        stretch_m[element] = stretch_m[element + 1] + s.record.longer_m(element) + by_flow_m;
    }
    (twist_rad, stretch_m)
}

/// Loads of the metal and the joints.
fn load(s: &Sources<'_>, p: &mut Profile) {
    let record = s.record;
    let strength = record.strength();
    let mud = s.model.mud_column();
    let last = s.mesh.nodes.len() - 1;
    let bendings = s.record.percentiles(Quantity::Bending);
    let densest_kg_per_m3 = mud.inside.densest();
    for (i, node) in s.mesh.nodes.iter().enumerate() {
        let (_, component) = s.model.string.component_at(node.from_bit_m);
        let tvd_m = s.model.well.path.at(p.md_m[i]).position_m.z;
        let layers = mud.layers_at(p.md_m[i]);
        let [mut outside_Pa, mut inside_Pa] =
            [&layers.annulus, &layers.inside].map(|layer| layer.pressure_Pa(tvd_m));
        let mut stream_N_m2 = 0.0;
        if let Some(flow) = &s.pressures {
            outside_Pa += flow.outside_Pa[i];
            inside_Pa += flow.inside_Pa[i];
            stream_N_m2 = flow.stream_N_m2 * layers.densities().inside_over(densest_kg_per_m3);
        }
        p.outside_pressure_Pa.push(outside_Pa);
        p.inside_pressure_Pa.push(inside_Pa);
        p.true_tension_N.push(component.true_tension_N(
            p.tension_N[i],
            outside_Pa,
            inside_Pa,
            stream_N_m2,
        ));
        p.side_force_per_joint_N
            .push(component.joints.map(|joints| p.side_force_N_per_m[i] * joints.spacing_m));
        let bending = record.bending(i);
        p.bending_moment_N_m.push(bending);
        p.bending_moment_max_N_m.push(record.bending_max(i));
        let [low, middle, high] = bendings[i];
        p.bending_moment_p05_N_m.push(low);
        p.bending_moment_p50_N_m.push(middle);
        p.bending_moment_p95_N_m.push(high);
        let between = record.between(i);
        p.bending_moment_between_N_m.push(between);
        p.bending_moment_between_max_N_m.push(record.between_max(i));
        p.sag_m.push(record.shapes().sag_m(i));
        p.body_contact_fraction.push(record.shapes().touched(i));
        p.bending_stress_Pa.push(bending.max(between) * strength.per_modulus_m3(i));
        // Below the bit there is no element: it has the loads of the node above it.
        let bearing = i.min(last - 1);
        let stress_max = record.stress_max(bearing);
        p.von_mises_stress_Pa.push(record.stress(bearing));
        p.von_mises_stress_max_Pa.push(stress_max);
        p.yield_use.push(strength.yield_Pa(bearing).map(|yields| stress_max / yields));
    }
}
