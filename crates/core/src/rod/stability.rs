//! The longest stable step, and mass scaling of the elements shorter than it.

use super::{element::Stiffness, mesh::Mesh};

/// Used fraction of the stability limit: the rest is a margin for effects not in the elements' own
/// frequencies (tension, large rotation).
pub(crate) const SAFETY: f64 = 0.99;

/// Largest part of the string's axial mass that short elements may be given (mass scaling) in sum.
pub(super) const MAX_ADDED_MASS: f64 = 0.003;

/// Part by which a step must be longer than that found to be distinguished from it by the search.
const STEP_MARGIN: f64 = 1e-6;

/// Lateral rotary inertia of each end of an element as a part of `m L²`: the diagonal of the
/// consistent mass matrix scaled to the element's mass (Hinton, Rock and Zienkiewicz 1976). It
/// vanishes with refinement as the mesh's own error does, and keeps the rotation of slender pipe,
/// a hundred times lighter by nature, off the stability limit.
const LUMPED_ROTARY: f64 = 1.0 / 78.0;

/// Inertia of one element, as it goes to its two ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElementInertia {
    /// Along the hole, kg: steel.
    pub axial_kg: f64,
    /// Across the hole, kg: steel, mud inside, mud carried along outside.
    pub lateral_kg: f64,
    /// About the axis, kg·m².
    pub polar_kg_m2: f64,
    /// Across the axis, of each end, kg·m².
    pub rotary_kg_m2: f64,
}

/// A motion of an element whose frequency bounds the step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Motion {
    /// Along the string.
    Axial,
    /// About its axis.
    Torsion,
    /// Across it.
    Bending,
}

impl Motion {
    /// Name in messages.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Axial => "axial",
            Self::Torsion => "torsional",
            Self::Bending => "bending",
        }
    }
}

/// Part of a step by which a sum of steps may exceed a whole number of them.
const ROUNDING: f64 = 1e-9;

/// The element that keeps the step from being longer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StepHolder {
    /// Its index, from the top.
    pub element: usize,
    /// Its motion with the highest frequency.
    pub motion: Motion,
    /// Whether mass scaling has used up the allowed total: without that limit it would allow a
    /// longer step.
    pub scaled: bool,
}

/// The step, and the inertia with which it is stable.
#[derive(Debug, Clone, PartialEq)]
pub struct StepPlan {
    /// Step, s; that of the upper region, where there are two.
    pub dt_s: f64,
    /// Inertia of each element, the added mass included.
    pub inertia: Vec<ElementInertia>,
    /// Axial mass added by scaling to short elements over that of the string.
    pub added_axial_mass_fraction: f64,
    /// Limit of the step; none for a string without elements.
    pub holder: Option<StepHolder>,
    /// The regions with steps of their own, where there are two.
    pub subcycling: Option<Subcycling>,
}

impl StepPlan {
    /// The shortest step of any region, s.
    pub fn shortest_s(&self) -> f64 {
        self.subcycling.map_or(self.dt_s, |s| self.dt_s / f64::from(s.parts))
    }

    /// The same with a step that is a whole part of `interval_s`, the longest that is no longer than
    /// its own: samples are then as far apart as the settings require. The inertia that was added
    /// for a longer step stays, which leaves a shorter one stable.
    #[must_use]
    pub fn dividing(self, interval_s: f64) -> Self {
        let parts = (interval_s / self.dt_s - ROUNDING).ceil().max(1.0);
        let dt_s = interval_s / parts;
        // The inertia missing at the border is proportional to the square of the step.
        let squared = (dt_s / self.dt_s).powi(2);
        let subcycling = self.subcycling.map(|lower| Subcycling {
            axial_kg: lower.axial_kg * squared,
            polar_kg_m2: lower.polar_kg_m2 * squared,
            ..lower
        });
        Self { dt_s, subcycling, ..self }
    }

    /// Elements times the steps that each takes within one step of the plan: those of the lower
    /// region more, where there are two; the border element is in both.
    pub fn element_steps(&self) -> f64 {
        let elements = self.inertia.len();
        self.subcycling.map_or(elements as f64, |lower| {
            let border = lower.border_node;
            (border + 1) as f64 + f64::from(lower.parts) * (elements - border) as f64
        })
    }
}

/// A string whose lower region takes several steps in one of the upper one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Subcycling {
    /// The border node: the lowest of the upper region.
    pub border_node: usize,
    /// Steps of the lower region in one of the upper one.
    pub parts: u32,
    /// Inertia that the linear motion of the border node within a step lacks, added to the node
    /// below it: along the hole, kg.
    pub axial_kg: f64,
    /// The same about the axis, kg·m².
    pub polar_kg_m2: f64,
    /// Limit of the lower region's step, apart from the requirement that `parts` is a whole number.
    pub holder: Option<StepHolder>,
}

/// An element with the inertia that it has by itself.
pub type BareElement = (Stiffness<f64>, ElementInertia);

/// The elements of `mesh` with their own inertia; `lateral_kg_per_m` as for [`plan`].
pub fn bare_elements(mesh: &Mesh, lateral_kg_per_m: &[f64]) -> Vec<BareElement> {
    mesh.elements
        .iter()
        .zip(lateral_kg_per_m)
        .map(|(e, lateral)| {
            let length = e.length_m;
            let lateral_kg = lateral * length;
            let polar = e.section.polar_inertia_kg_m * length;
            let inertia = ElementInertia {
                axial_kg: e.section.steel_kg_per_m * length,
                lateral_kg,
                polar_kg_m2: polar,
                rotary_kg_m2: lateral_kg * length * length * LUMPED_ROTARY + 0.25 * polar,
            };
            (Stiffness::new(&e.section, length), inertia)
        })
        .collect()
}

/// Axial mass of elements, kg.
pub(super) fn axial_kg<'a>(inertia: impl IntoIterator<Item = &'a ElementInertia>) -> f64 {
    inertia.into_iter().map(|i| i.axial_kg).sum()
}

/// The inertia with which a step is stable for all elements; none where one of them is unstable
/// with any mass.
pub(super) fn scaled_all(
    elements: &[BareElement],
    dt: f64,
    beta: f64,
) -> Option<Vec<ElementInertia>> {
    let limit = frequency_limit(dt, beta);
    elements.iter().map(|(k, i)| scaled_inertia(k, i, limit).ok()).collect()
}

/// Axial mass, kg, with which a step is stable for all elements; none where it is not for one of
/// them.
fn scaled_kg(elements: &[BareElement], dt: f64, beta: f64) -> Option<f64> {
    let limit = frequency_limit(dt, beta);
    elements.iter().map(|(k, i)| Some(scaled_inertia(k, i, limit).ok()?.axial_kg)).sum()
}

/// A longest step.
pub(super) struct Longest {
    /// It, s.
    pub(super) dt_s: f64,
    /// Limit of the step.
    pub(super) holder: Option<StepHolder>,
}

/// The longest step that is stable for all elements with an axial mass, kg, that `affords` accepts,
/// but no longer than that for half of their own mass, because mass is added to only a few
/// elements.
pub(super) fn longest(
    elements: &[BareElement],
    beta: f64,
    affords: impl Fn(f64) -> bool,
) -> Longest {
    let fits = |dt: f64| scaled_kg(elements, dt, beta).is_some_and(&affords);
    let cap = half_carries_s(elements, beta);
    let (mut low, mut high) = if fits(cap) { (cap, cap) } else { (0.0, cap) };
    while high - low > f64::EPSILON * high {
        let middle = 0.5 * (low + high);
        if fits(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    let beyond = high * (1.0 + STEP_MARGIN);
    let holder = if fits(beyond) {
        // Only the step that is stable for ordinary pipe with its own mass.
        let element = elements.iter().position(|(k, i)| own_step(k, i, beta) >= cap);
        element.map(|element| StepHolder { element, motion: Motion::Axial, scaled: false })
    } else {
        holder(elements, beyond, beta)
    };
    Longest { dt_s: low, holder }
}

/// The longest step that half of the elements' mass carries by itself, s.
pub(super) fn half_carries_s(elements: &[BareElement], beta: f64) -> f64 {
    let total = axial_kg(elements.iter().map(|(_, i)| i));
    let mut own: Vec<(f64, f64)> =
        elements.iter().map(|(k, i)| (own_step(k, i, beta), i.axial_kg)).collect();
    own.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut carried = 0.0;
    let most = own.iter().find(|(_, kg)| {
        carried += kg;
        carried >= 0.5 * total
    });
    most.map_or(0.0, |(dt, _)| *dt)
}

/// Chooses the longest step at which the string is stable with no more than 0.3 % of its mass added
/// by scaling, and that to less than half of it: ordinary pipe keeps its mass and its wave speed.
///
/// The highest frequency of a chain with lumped masses is below the highest of its elements taken
/// alone (Irons and Treharne 1971). `lateral_kg_per_m` is the lateral mass per length of each
/// element, `stiffness_damping_s` the time constant `β` of the damping, which shortens the limit.
/// Theory: `docs/src/theory/time-stepping.md`.
pub fn plan(mesh: &Mesh, lateral_kg_per_m: &[f64], stiffness_damping_s: f64) -> StepPlan {
    let bare = bare_elements(mesh, lateral_kg_per_m);
    let total = axial_kg(bare.iter().map(|(_, i)| i));
    let affords = |kg: f64| kg / total - 1.0 <= MAX_ADDED_MASS;
    let Longest { dt_s, holder } = longest(&bare, stiffness_damping_s, affords);
    let inertia = scaled_all(&bare, dt_s, stiffness_damping_s)
        .unwrap_or_else(|| bare.iter().map(|(_, i)| *i).collect());
    let added_axial_mass_fraction = (axial_kg(&inertia) / total - 1.0).max(0.0);
    StepPlan { dt_s, inertia, added_axial_mass_fraction, holder, subcycling: None }
}

/// Limit that excludes the step `dt`: the element that no added mass makes stable, or that with the
/// most added mass.
fn holder(bare: &[BareElement], dt: f64, beta: f64) -> Option<StepHolder> {
    let limit = frequency_limit(dt, beta);
    let mut most: Option<(f64, StepHolder)> = None;
    for (element, (k, inertia)) in bare.iter().enumerate() {
        let (added, holder) = match scaled_inertia(k, inertia, limit) {
            Err(motion) => return Some(StepHolder { element, motion, scaled: false }),
            Ok(scaled) => {
                let added = scaled.axial_kg - inertia.axial_kg;
                (added, StepHolder { element, motion: Motion::Axial, scaled: added > 0.0 })
            }
        };
        if most.is_none_or(|(before, _)| added > before) {
            most = Some((added, holder));
        }
    }
    most.map(|(_, holder)| holder)
}

/// Longest step of an element that gets no added mass, by its axial frequency, s.
pub(super) fn own_step(k: &Stiffness<f64>, bare: &ElementInertia, beta: f64) -> f64 {
    step_of((4.0 * k.axial / bare.axial_kg).sqrt(), beta)
}

/// Longest step that carries an angular frequency, s.
pub(super) fn step_of(omega: f64, beta: f64) -> f64 {
    let xi = 0.5 * beta * omega;
    2.0 * SAFETY / omega * ((1.0 + xi * xi).sqrt() - xi)
}

/// Highest angular frequency that a step carries, rad/s.
pub(super) fn frequency_limit(dt: f64, beta: f64) -> f64 {
    // dt ω/2 = S(√(1 + ξ²) − ξ) with ξ = βω/2 solves to ω = 2S/dt / √(1 + 2Sβ/dt).
    let bare = 2.0 * SAFETY / dt;
    bare / (1.0 + bare * beta).sqrt()
}

/// The inertia with which an element stays below `limit`, rad/s; where only a shorter step helps,
/// the motion that requires it.
pub(super) fn scaled_inertia(
    k: &Stiffness<f64>,
    bare: &ElementInertia,
    limit: f64,
) -> Result<ElementInertia, Motion> {
    let square = limit * limit;
    let over_length = 1.0 / k.length;
    if 4.0 * k.twist > square * bare.polar_kg_m2 {
        return Err(Motion::Torsion);
    }
    let axial_kg = bare.axial_kg.max(4.0 * k.axial / square);
    let lateral_kg = bare.lateral_kg.max(axial_kg);
    // Both ends turned alike against a turning chord, and against one another.
    let shear = 2.0 * (k.bending_near() + k.bending_far);
    let budget = square / shear - 4.0 * over_length * over_length / lateral_kg;
    if budget <= 0.0 {
        return Err(Motion::Bending);
    }
    let rotary_kg_m2 =
        bare.rotary_kg_m2.max(0.5 / budget).max((k.bending_near() - k.bending_far) / square);
    Ok(ElementInertia { axial_kg, lateral_kg, polar_kg_m2: bare.polar_kg_m2, rotary_kg_m2 })
}
