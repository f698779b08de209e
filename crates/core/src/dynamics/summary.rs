//! From the record of a run to its answer.

use super::{
    assembly::Anchor,
    energy::EnergyBalance,
    outcome::{DynamicOutcome, NodeProfile, Numerics, Statistic, TimeSeries},
    record::Record,
};
use crate::{
    model::Model,
    mud::Hydraulics,
    outcome::Scalars,
    rod::{mesh::Mesh, stability::StepPlan},
};

/// What the answer is made from.
pub struct Sources<'a> {
    pub model: &'a Model,
    pub mesh: &'a Mesh,
    pub plan: &'a StepPlan,
    pub anchors: &'a [Anchor],
    pub record: &'a Record,
    pub steps: u64,
    pub energy: Option<(EnergyBalance, f64)>,
    pub diverged: bool,
    pub hydraulics: Option<Hydraulics>,
    pub instructions: &'static str,
}

/// Longest stretch of string that one contact is taken to carry on either side of it, m.
const LONGEST_REACH_M: f64 = 10.0;

/// The answer.
pub fn outcome(s: &Sources<'_>) -> DynamicOutcome {
    let series = &s.record.series;
    let from = s.record.window_row;
    let statistics: Vec<(&'static str, Statistic)> = varying(series)
        .into_iter()
        .filter_map(|(name, values)| Some((name, Statistic::of(&values[from..])?)))
        .collect();
    let mean = |name: &str| {
        statistics
            .iter()
            .find(|(n, _)| *n == name)
            .map_or(0.0, |(_, s)| s.mean)
    };
    let nodes = profile(s, from);
    let bit_depths_m = &series.bit_depth_m[from..];
    let mean_bit_depth_m = bit_depths_m.iter().sum::<f64>() / bit_depths_m.len().max(1) as f64;
    let scalars = Scalars {
        hook_load_N: mean("hook_load_N"),
        surface_torque_N_m: mean("surface_torque_N_m"),
        friction_torque_N_m: mean("friction_torque_N_m"),
        axial_friction_N: mean("axial_friction_N"),
        side_force_total_N: mean("side_force_total_N"),
        weight_on_bit_N: mean("weight_on_bit_N"),
        bit_torque_N_m: mean("bit_torque_N_m"),
        twist_rad: mean("twist_rad"),
        stretch_m: mean("stretch_m"),
        neutral_point_m: crate::outcome::neutral_point_m(&nodes.md_m, &nodes.tension_N),
        cutoff_depth_m: crate::outcome::cutoff_in_build_m(
            &s.model.well.path,
            mean_bit_depth_m,
            &nodes.md_m,
            &nodes.side_force_N_per_m,
        ),
    };
    DynamicOutcome {
        scalars,
        statistics,
        hydraulics: s.hydraulics,
        numerics: Numerics {
            elements: s.mesh.elements.len(),
            time_step_s: s.plan.dt_s,
            steps: s.steps,
            added_axial_mass_fraction: s.plan.added_axial_mass_fraction,
            max_penetration_m: s.record.max_penetration_m,
            energy_residual: match s.energy {
                Some((_, residual)) => residual,
                None => f64::from(u8::from(s.diverged)),
            },
            energy: s.energy.map(|(parts, _)| parts),
            instructions: s.instructions,
        },
        nodes,
        series: series.clone(),
    }
}

fn varying(series: &TimeSeries) -> [(&'static str, &Vec<f64>); 10] {
    [
        ("hook_load_N", &series.hook_load_N),
        ("surface_torque_N_m", &series.surface_torque_N_m),
        ("friction_torque_N_m", &series.friction_torque_N_m),
        ("axial_friction_N", &series.axial_friction_N),
        ("side_force_total_N", &series.side_force_total_N),
        ("weight_on_bit_N", &series.weight_on_bit_N),
        ("bit_torque_N_m", &series.bit_torque_N_m),
        ("twist_rad", &series.twist_rad),
        ("stretch_m", &series.stretch_m),
        (
            "bit_rotary_speed_rad_per_s",
            &series.bit_rotary_speed_rad_per_s,
        ),
    ]
}

/// The profile over the samples from row `from` of the series on.
fn profile(s: &Sources<'_>, from: usize) -> NodeProfile {
    let n = s.mesh.nodes.len();
    // The anchors stand where the run ended; the string was there, on average, where its bit was.
    let bit_depths_m = &s.record.series.bit_depth_m[from..];
    let back_m = bit_depths_m.last().map_or(0.0, |last| {
        last - bit_depths_m.iter().sum::<f64>() / bit_depths_m.len() as f64
    });
    let record = s.record;
    // Tension and torque live in elements, everything else at nodes.
    let at_node = |i: usize, of: &dyn Fn(usize) -> super::record::Spread| {
        let below = of(i.min(n - 2));
        let above = of(i.saturating_sub(1));
        (
            0.5 * (above.mean + below.mean),
            0.5 * (above.std + below.std),
        )
    };
    let mut p = NodeProfile::default();
    for i in 0..n {
        let (tension, tension_std) = at_node(i, &|e| record.tension(e));
        let (torque, torque_std) = at_node(i, &|e| record.torque(e));
        let normal = record.normal(i);
        p.md_m.push(s.anchors[i].md_m - back_m);
        p.tension_N.push(tension);
        p.tension_std_N.push(tension_std);
        p.torque_N_m.push(-torque);
        p.torque_std_N_m.push(torque_std);
        p.contact_force_N.push(normal.mean);
        p.contact_force_std_N.push(normal.std);
        p.contact_force_max_N.push(record.normal_max(i));
        p.contact_fraction.push(record.touched(i));
        p.climb_rad.push(record.climb_rad(i));
        p.lateral_offset_m.push(record.offset(i));
    }
    // At the ends the neighbours are half an element off; hoist and bit are there.
    let end =
        |values: &[f64]| Statistic::of(&values[from..]).map_or((0.0, 0.0), |e| (e.mean, e.std));
    let (hook, hook_std) = end(&s.record.series.hook_load_N);
    let (weight, weight_std) = end(&s.record.series.weight_on_bit_N);
    (p.tension_N[0], p.tension_std_N[0]) = (hook, hook_std);
    let jet = s.hydraulics.map_or(0.0, |mud| mud.jet_thrust_N);
    (p.tension_N[n - 1], p.tension_std_N[n - 1]) = (-weight - jet, weight_std);
    let carries = carried_lengths(s);
    p.side_force_N_per_m = spread(&carries, n, |i| record.signed(i));
    p.axial_friction_N_per_m = spread(&carries, n, |i| -record.axial(i));
    p.friction_torque_N_m_per_m = spread(&carries, n, |i| record.rub(i));
    p
}

/// A contact and the stretch of string that it carries: the nodes `first..=last` over `length_m`.
struct Carries {
    contact: usize,
    first: usize,
    last: usize,
    length_m: f64,
}

/// Shares the string out among the nodes that touch: each carries half the way to the next contact on
/// either side, at most [`LONGEST_REACH_M`].
fn carried_lengths(s: &Sources<'_>) -> Vec<Carries> {
    let at = |i: usize| -s.mesh.nodes[i].from_bit_m;
    let touching: Vec<usize> = (0..s.mesh.nodes.len())
        .filter(|i| s.record.normal(*i).mean > 0.0)
        .collect();
    touching
        .iter()
        .enumerate()
        .map(|(k, &contact)| {
            let half = |other: Option<&usize>| {
                other.map_or(LONGEST_REACH_M, |o| {
                    (0.5 * (at(*o) - at(contact)).abs()).min(LONGEST_REACH_M)
                })
            };
            let above = half(k.checked_sub(1).and_then(|k| touching.get(k)));
            let below = half(touching.get(k + 1));
            let low = at(contact) - above - 1e-9;
            let high = at(contact) + below + 1e-9;
            let mut first = contact;
            while first > 0 && at(first - 1) >= low {
                first -= 1;
            }
            let mut last = contact;
            while last + 1 < s.mesh.nodes.len() && at(last + 1) <= high {
                last += 1;
            }
            Carries {
                contact,
                first,
                last,
                length_m: above + below,
            }
        })
        .collect()
}

/// Spreads what contacts carry over the stretches that they carry it for, per metre; a node on the
/// border between two takes their mean.
fn spread(carries: &[Carries], nodes: usize, force: impl Fn(usize) -> f64) -> Vec<f64> {
    let mut sum = vec![0.0; nodes];
    let mut count = vec![0u32; nodes];
    for c in carries {
        for i in c.first..=c.last {
            sum[i] += force(c.contact) / c.length_m;
            count[i] += 1;
        }
    }
    sum.iter()
        .zip(&count)
        .map(|(s, c)| if *c > 1 { s / f64::from(*c) } else { *s })
        .collect()
}
