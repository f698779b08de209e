//! The plan of a string in two regions, whose lower one takes several steps in one of the upper
//! one.
//!
//! Multirate time stepping (subcycling) serves strings whose bottom-hole assembly is meshed finer
//! than their pipe: the pipe need not go by the steps of the assembly. Theory:
//! `docs/src/theory/time-stepping.md`.

use super::{
    element::Stiffness,
    mesh::Mesh,
    stability::{
        self, BareElement, ElementInertia, Longest, MAX_ADDED_MASS, Motion, StepHolder, StepPlan,
        Subcycling, axial_kg, frequency_limit, half_carries_s, longest, own_step, scaled_all,
        scaled_inertia,
    },
};
use crate::simd::lanes::SINGLES;

/// Elements of the upper region's length that the lower region begins with. They let nothing
/// through to the border that its longer step cannot carry: without them the coupling gains energy.
const BUFFER: usize = 3;

/// Tolerance of the ratio of two steps.
const ROUNDING: f64 = 1e-9;

/// Most steps in one.
const MAX_PARTS: u32 = 20;

/// Least elements of the upper region.
const MIN_UPPER: usize = 8;

/// Ratio of the cost of an element in a chain of a few rows to that in a long chain.
const SHORT_CHAIN: f64 = 1.12;

/// Cost of bit and boundaries in a step, in elements: 0.4 µs.
const PER_STEP: f64 = 45.0;

/// Two regions must be so much cheaper than one.
const WORTH_IT: f64 = 0.95;

/// Steps of the upper region that are tried, as fractions of the stable step for its mass.
const TRIED: [f64; 8] = [1.0, 0.95, 0.9, 0.85, 0.8, 0.7, 0.6, 0.5];

/// The cheapest plan for `mesh`: in two regions where that pays, else [`stability::plan`]'s.
///
/// The border element is above the node `highest_lower`, and not at it: the loads on that node and
/// on the elements at it belong to the lower region. `lateral_kg_per_m` and `stiffness_damping_s`
/// as there.
pub fn plan(
    mesh: &Mesh,
    lateral_kg_per_m: &[f64],
    stiffness_damping_s: f64,
    highest_lower: usize,
) -> StepPlan {
    let one = stability::plan(mesh, lateral_kg_per_m, stiffness_damping_s);
    let cost_of_one = (mesh.elements.len() as f64 + PER_STEP) / one.dt_s;
    divided(mesh, lateral_kg_per_m, stiffness_damping_s, highest_lower)
        .filter(|two| cost(two) < WORTH_IT * cost_of_one)
        .unwrap_or(one)
}

/// The cheapest plan in two regions, if there is one, whatever one region costs.
pub(crate) fn divided(
    mesh: &Mesh,
    lateral_kg_per_m: &[f64],
    stiffness_damping_s: f64,
    highest_lower: usize,
) -> Option<StepPlan> {
    let string = BareString {
        elements: stability::bare_elements(mesh, lateral_kg_per_m),
        beta: stiffness_damping_s,
        highest_lower,
    };
    let carried_s = half_carries_s(&string.elements, string.beta);
    let tried = TRIED.iter().filter_map(|part| string.divided(part * carried_s));
    tried.min_by(|a, b| cost(a).total_cmp(&cost(b)))
}

/// Cost of a plan in two regions per second, in elements of a long chain.
fn cost(plan: &StepPlan) -> f64 {
    let Some(Subcycling { border_node, parts, .. }) = plan.subcycling else {
        return f64::INFINITY;
    };
    let (upper, lower) = (border_node + 1, plan.inertia.len() - border_node);
    // A row takes as long whether all of its lanes are full or not; with a ghost.
    let rows = (lower + 1).next_multiple_of(SINGLES);
    let within = f64::from(parts) * (SHORT_CHAIN * rows as f64 + PER_STEP);
    (upper as f64 + within) / plan.dt_s
}

/// A string before any mass is added to it.
struct BareString {
    elements: Vec<BareElement>,
    beta: f64,
    highest_lower: usize,
}

impl BareString {
    /// The string in two regions, the upper one with a step of `dt_s` or a little longer; none
    /// where that leaves no upper region.
    fn divided(&self, dt_s: f64) -> Option<StepPlan> {
        let total_kg = axial_kg(self.elements.iter().map(|(_, i)| i));
        let budget_kg = MAX_ADDED_MASS * total_kg;
        let border = self.border(dt_s, 0.5 * budget_kg)?;
        let (upper, lower) = (&self.elements[..=border], &self.elements[border..]);
        let bare_kg = |elements: &[BareElement]| axial_kg(elements.iter().map(|(_, i)| i));
        let upper_kg = bare_kg(upper);
        let affords = |kg: f64| kg - upper_kg <= 0.5 * budget_kg;
        let mut held = longest(upper, self.beta, affords);
        for (index, element) in lower[..=BUFFER].iter().enumerate() {
            let (dt_s, motion) = self.bears(element);
            if dt_s < held.dt_s {
                let holder = StepHolder { element: border + index, motion, scaled: false };
                held = Longest { dt_s, holder: Some(holder) };
            }
        }
        let Longest { dt_s, holder } = held;
        let upper_inertia = scaled_all(upper, dt_s, self.beta)?;
        let left_kg = budget_kg - (axial_kg(&upper_inertia) - upper_kg);
        let lower_kg = bare_kg(lower);
        let below = longest(lower, self.beta, |kg| kg - lower_kg <= left_kg);
        let parts = (dt_s / below.dt_s - ROUNDING).ceil();
        if !(2.0..=f64::from(MAX_PARTS)).contains(&parts) {
            return None;
        }
        let lower_inertia = scaled_all(lower, dt_s / parts, self.beta)?;
        let inertia: Vec<_> = upper_inertia.iter().chain(&lower_inertia[1..]).copied().collect();
        let k = &self.elements[border].0;
        // The chord of a path that is curved by an acceleration deviates from the path, on average
        // over the step, by `DT²/12 (1 − 1/M²)` times the acceleration.
        let beside_s2 = dt_s * dt_s / 12.0 * (1.0 - 1.0 / (parts * parts));
        Some(StepPlan {
            dt_s,
            added_axial_mass_fraction: (axial_kg(&inertia) / total_kg - 1.0).max(0.0),
            inertia,
            holder,
            subcycling: Some(Subcycling {
                border_node: border,
                parts: parts as u32,
                axial_kg: k.axial * beside_s2,
                polar_kg_m2: k.twist * beside_s2,
                holder: below
                    .holder
                    .map(|holder| StepHolder { element: border + holder.element, ..holder }),
            }),
        })
    }

    /// The border node of an upper region with a step of `dt_s` and no more than `budget_kg` of
    /// added mass: above the first element that does not allow that, and its buffer.
    fn border(&self, dt_s: f64, mut budget_kg: f64) -> Option<usize> {
        let limit = frequency_limit(dt_s, self.beta);
        let first_fine = self.elements.iter().position(|(k, bare)| {
            let Ok(scaled) = scaled_inertia(k, bare, limit) else {
                return true;
            };
            budget_kg -= scaled.axial_kg - bare.axial_kg;
            budget_kg < 0.0
        })?;
        let bears = |e: &BareElement| self.bears(e).0 >= dt_s;
        // The border element, and those of the buffer below it.
        let highest = first_fine.saturating_sub(BUFFER + 1);
        let highest = highest.min(self.highest_lower.saturating_sub(2));
        (MIN_UPPER..=highest)
            .rev()
            .find(|border| self.elements[*border..=border + BUFFER].iter().all(bears))
    }

    /// The longest step that is stable for an element with its own mass along and about the axis,
    /// s, and the motion that bounds it.
    fn bears(&self, (k, bare): &BareElement) -> (f64, Motion) {
        let stretching_s = own_step(k, bare, self.beta);
        let twisting_s = twisting_step(k, bare, self.beta);
        if twisting_s < stretching_s {
            (twisting_s, Motion::Torsion)
        } else {
            (stretching_s, Motion::Axial)
        }
    }
}

/// Longest step of an element by its torsional frequency, s: polar inertia is never added.
fn twisting_step(k: &Stiffness<f64>, bare: &ElementInertia, beta: f64) -> f64 {
    stability::step_of((4.0 * k.twist / bare.polar_kg_m2).sqrt(), beta)
}
