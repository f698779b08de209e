//! The rule by which elements choose their length.

use super::{Accuracy, SizeReason, SizedInterval, Sizing};
use crate::{
    model::Model,
    operation::Operation,
    rod::buckled_element::own_load_N,
    statics::{
        buckling::{Place, Shape},
        soft::{self, SoftError, SoftProfile, SoftSettings},
        span::{BodyContact, JointSpan},
    },
    string::{Component, DrillString},
};

/// Longest element between joints, m: a joint of range 3. Longer spacings are cut.
const MAX_JOINT_M: f64 = 14.0;

/// Shortest spacing of joints that are taken for a pipe's, m; shorter ones share elements.
const MIN_JOINT_M: f64 = 5.0;

/// Elements of pipe without joints, m: a joint of range 2.
const PLAIN_M: f64 = 9.6;

/// Elements of the assembly, m.
const ASSEMBLY_M: f64 = 3.0;

/// Elements next to a bend that turns with the string, m, and their range on either side of it:
/// once a revolution it lifts the bit and the neighbouring blades, over lengths of a metre or two.
const BEND_M: f64 = 1.5;
const AROUND_BEND_M: f64 = 9.0;

/// Elements for a joint whose body touches between its ends: a node at the middle and on either
/// side of it.
const PER_TOUCHING_JOINT: f64 = 4.0;

/// Elements for a half wave of sinusoidal buckling.
const PER_HALF_WAVE: f64 = 4.0;

/// Part of the critical load from which a compressed stretch is resolved. The soft string, which
/// predicts the compression, does not include the effect of buckling on it.
const NEAR_CRITICAL: f64 = 0.5;

/// Part of its own buckling load between its nodes, `π² EI/h²`, from which an element of ordinary
/// length is too long for its compression; an element after division is stable under twice the
/// compression.
const NEAR_OWN: f64 = 0.5;

/// Minimum ratio of the weight per length of a component of the assembly to that of the lightest
/// pipe.
const HEAVY: f64 = 1.5;

/// Length from which a stretch of light pipe ends the assembly, m.
const PIPE_M: f64 = 60.0;

/// Inside diameter of drill pipe, coiled tubing and casing over the outside one, at least: collars
/// and heavy-weight pipe have thicker walls.
const THIN: f64 = 0.7;

/// Length from which a thick-walled component is no part of an assembly, m.
const LONG_M: f64 = 300.0;

/// Side force below which pipe hangs: less than a tenth of its weight is carried by the wall, N/m.
const LIGHT_N_PER_M: f64 = 10.0;

/// Step of the soft string that the rule uses, m.
const STEP_M: f64 = 4.0;

/// An element length required by a stretch of the string.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Demand {
    /// Lower and upper end, measured from the bit, m.
    from_bit_m: [f64; 2],
    /// Longest element, m.
    element_length_m: f64,
    /// Reason for the requirement.
    reason: SizeReason,
}

impl Sizing {
    /// The lengths that a string requires in one operation or several successive ones, by the rule
    /// of `docs/src/theory/mesh.md`. Wall contact and compression are predicted by the soft string.
    ///
    /// # Errors
    /// A soft string without solution.
    pub fn auto(
        model: &Model,
        operations: &[Operation],
        accuracy: Accuracy,
    ) -> Result<Self, SoftError> {
        let ordinary = ordinary(model, accuracy);
        let mut demands = ordinary.clone();
        if operations.iter().any(|operation| operation.kind.rotates()) {
            demands.extend(rotating_bends(model, accuracy));
        }
        for operation in operations {
            let profile = soft::solve(
                model,
                operation,
                &SoftSettings { step_m: STEP_M, ..SoftSettings::default() },
            )?;
            loaded(model, operation, &profile, accuracy, &ordinary, &mut demands);
        }
        Ok(Self::of_demands(&demands))
    }

    /// The shortest required length everywhere.
    fn of_demands(demands: &[Demand]) -> Self {
        let mut places: Vec<f64> = demands.iter().flat_map(|one| one.from_bit_m).collect();
        places.sort_by(f64::total_cmp);
        places.dedup();
        let mut intervals: Vec<SizedInterval> = Vec::new();
        for pair in places.windows(2) {
            let middle_m = 0.5 * (pair[0] + pair[1]);
            let here = demands.iter().filter(|one| {
                let [low_m, high_m] = one.from_bit_m;
                (low_m..high_m).contains(&middle_m)
            });
            let Some(least) = here.min_by(|a, b| a.element_length_m.total_cmp(&b.element_length_m))
            else {
                continue;
            };
            let Demand { element_length_m, reason, .. } = *least;
            let same = |last: &SizedInterval| {
                (last.element_length_m, last.reason) == (element_length_m, reason)
            };
            if !intervals.last().is_some_and(same) {
                intervals.push(SizedInterval { from_bit_m: pair[0], element_length_m, reason });
            }
        }
        Self::of_intervals(intervals)
    }
}

/// Lengths that the components require under any load.
fn ordinary(model: &Model, accuracy: Accuracy) -> Vec<Demand> {
    let assembly_top_m = meshed_as_assembly_m(&model.string);
    let halved = if accuracy == Accuracy::Fine { 0.5 } else { 1.0 };
    let spans = model.string.spans();
    spans
        .map(|span| {
            let whirls = span.component.eccentricity.is_some();
            let assembly =
                (span.to_bit_m <= assembly_top_m || whirls) && accuracy != Accuracy::Coarse;
            let (element_length_m, reason) = match joint_m(span.component) {
                _ if assembly => (ASSEMBLY_M, SizeReason::Assembly),
                Some(joint_m) => (joint_m, SizeReason::JointToJoint),
                None => (PLAIN_M, SizeReason::PlainPipe),
            };
            Demand {
                from_bit_m: [span.from_bit_m, span.to_bit_m],
                element_length_m: halved * element_length_m,
                reason,
            }
        })
        .collect()
}

/// Lengths that bends which turn with the string require.
fn rotating_bends(model: &Model, accuracy: Accuracy) -> Vec<Demand> {
    let element_length_m = match accuracy {
        Accuracy::Coarse => return Vec::new(),
        Accuracy::Standard => BEND_M,
        Accuracy::Fine => 0.5 * BEND_M,
    };
    let bends = model
        .string
        .spans()
        .filter_map(|span| span.component.bend.map(|bend| span.from_bit_m + bend.from_lower_end_m));
    bends
        .map(|at_m| Demand {
            from_bit_m: [(at_m - AROUND_BEND_M).max(0.0), at_m + AROUND_BEND_M],
            element_length_m,
            reason: SizeReason::RotatingBend,
        })
        .collect()
}

/// Element from joint to joint of a component, m; none where it has no joints of a pipe.
fn joint_m(component: &Component) -> Option<f64> {
    let spacing_m = component.joints?.spacing_m;
    (spacing_m >= MIN_JOINT_M).then(|| spacing_m / (spacing_m / MAX_JOINT_M).ceil())
}

/// The tool joint nearest to a place, both measured from the bit, m; the place itself where the
/// component there has no joints of a pipe.
fn nearest_joint_m(string: &DrillString, from_bit_m: f64) -> f64 {
    let (index, component) = string.component_at(from_bit_m);
    let (Some(joints), Some(_), Some(span)) =
        (component.joints, joint_m(component), string.spans().nth(index))
    else {
        return from_bit_m;
    };
    let number = ((from_bit_m - span.from_bit_m) / joints.spacing_m).round();
    (span.from_bit_m + number * joints.spacing_m).min(span.to_bit_m)
}

/// Upper end of the bottom-hole assembly, from the bit, m: where ordinary drill pipe begins, which
/// has joints unless nothing in the string has; zero where there is none.
pub fn assembly_top_m(string: &DrillString) -> f64 {
    pipe_from_m(string, |one| one.length_m >= PIPE_M).unwrap_or(0.0)
}

/// Upper end of the part that is meshed as an assembly, from the bit, m: the beginning of pipe that
/// has walls thinner than a collar's, or joints, or is longer than any assembly. A string without
/// such pipe is meshed so throughout, unless it is uniform from end to end.
fn meshed_as_assembly_m(string: &DrillString) -> f64 {
    let is_pipe = |one: &Component| {
        one.length_m >= PIPE_M && (one.id_m >= THIN * one.od_m || one.length_m >= LONG_M)
    };
    match pipe_from_m(string, is_pipe) {
        Some(from_bit_m) => from_bit_m,
        None if is_uniform(string) => 0.0,
        None => string.length_m(),
    }
}

/// Beginning of ordinary drill pipe, from the bit, m: the first 60 m or more with joints or, where
/// nothing in the string has joints, of components that may be pipe without joints.
fn pipe_from_m(string: &DrillString, is_plain_pipe: impl Fn(&Component) -> bool) -> Option<f64> {
    let components = string.components();
    let any_jointed = components.iter().any(|one| joint_m(one).is_some());
    let may_be =
        |one: &Component| if any_jointed { joint_m(one).is_some() } else { is_plain_pipe(one) };
    let lightest = components.iter().filter(|one| may_be(one));
    let lightest = lightest.map(|one| one.mass_per_length_kg_per_m).fold(f64::INFINITY, f64::min);
    let is_pipe = |one: &Component| {
        one.length_m >= PIPE_M && may_be(one) && one.mass_per_length_kg_per_m < HEAVY * lightest
    };
    string.spans().find(|span| is_pipe(span.component)).map(|pipe| pipe.from_bit_m)
}

/// Whether a string has the same body from end to end: none of it is an assembly.
fn is_uniform(string: &DrillString) -> bool {
    let body = |one: &Component| [one.od_m, one.id_m, one.mass_per_length_kg_per_m];
    string.components().windows(2).all(|pair| body(&pair[0]) == body(&pair[1]))
}

/// Lengths that the loads require: joints whose body touches, and stretches that buckle.
fn loaded(
    model: &Model,
    operation: &Operation,
    profile: &SoftProfile,
    accuracy: Accuracy,
    ordinary: &[Demand],
    demands: &mut Vec<Demand>,
) {
    let coarser = match accuracy {
        Accuracy::Coarse => 2.0,
        Accuracy::Standard => 1.0,
        Accuracy::Fine => 0.5,
    };
    let bit_depth_m = operation.bit_depth_m;
    for (row, &md_m) in profile.md_m.iter().enumerate() {
        let from_bit_m = bit_depth_m - md_m;
        let (_, component) = model.string.component_at(from_bit_m);
        let (tension_N, load_N_per_m) =
            (profile.tension_N[row], profile.side_force_N_per_m[row].abs());
        let joint = joint_m(component);
        let mut ask = |element_length_m: f64, reason: SizeReason| {
            // Whole parts of a joint, and a joint to either side. From joint to joint: a joint that
            // has elements of two lengths next to it would give way to nodes at equal distances.
            let joint_m = joint.unwrap_or(PLAIN_M);
            let element_length_m = joint_m / (joint_m / (coarser * element_length_m)).ceil();
            let stretch_m = [(from_bit_m - joint_m).max(0.0), from_bit_m + joint_m]
                .map(|end_m| nearest_joint_m(&model.string, end_m));
            match demands.last_mut() {
                Some(last)
                    if (last.reason, last.element_length_m) == (reason, element_length_m)
                        && last.from_bit_m[0] <= stretch_m[1] =>
                {
                    last.from_bit_m[0] = stretch_m[0];
                }
                _ => demands.push(Demand { from_bit_m: stretch_m, element_length_m, reason }),
            }
        };
        if let (Some(joint_m), Some(span)) = (joint, JointSpan::of(component))
            && load_N_per_m > LIGHT_N_PER_M
            && span.bending(tension_N, load_N_per_m).contact != BodyContact::None
        {
            ask(joint_m / PER_TOUCHING_JOINT, SizeReason::BodyContact);
        }
        if tension_N < 0.0 {
            let place = Place::of(model, bit_depth_m, md_m);
            let wall_load = place.wall_load_N_per_m(-tension_N);
            let critical_N = place.threshold_N(Shape::Sinusoidal, wall_load);
            let part = ordinary.partition_point(|one| one.from_bit_m[1] <= from_bit_m);
            let own_N = ordinary.get(part).map_or(f64::INFINITY, |one| {
                own_load_N(place.bending_stiffness_N_m2, one.element_length_m)
            });
            let half_wave_m = half_wave_m(&place, -tension_N);
            if -tension_N > NEAR_CRITICAL * critical_N {
                ask(half_wave_m / PER_HALF_WAVE, SizeReason::Compression);
            } else if -tension_N > NEAR_OWN * own_N {
                // Elements that are stable under twice the compression, for any accuracy.
                ask(half_wave_m / (2.0 * coarser.max(1.0)), SizeReason::Compression);
            }
        }
    }
}

/// Half a wave of the sinusoid at the critical load, and half a pitch of the helix beyond it,
/// `π √(2 EI/F)`, m (Lubinski, Althouse and Logan 1962).
fn half_wave_m(place: &Place, compression_N: f64) -> f64 {
    std::f64::consts::PI * (2.0 * place.bending_stiffness_N_m2 / compression_N).sqrt()
}
