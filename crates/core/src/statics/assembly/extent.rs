//! Extent of the solved part of the string, and its elements.

use crate::{
    model::Model,
    operation::Operation,
    rod::mesh::Mesh,
    sizing::{Accuracy, SizeReason, Sizing, assembly_top_m},
    statics::{soft::SoftError, stiff::StiffSettings},
    string::Component,
};

/// Elements of a joint of pipe.
const PER_JOINT: f64 = 8.0;

/// Elements of pipe without joints over those of the assembly.
const PLAIN: f64 = 4.0;

/// Blades no longer than this are a point, m; longer ones touch at both edges.
const POINT_M: f64 = 0.1;

/// Number of elements on either side of the end of a contact that are made shorter, and by how
/// much.
const AROUND: f64 = 3.0;
const SHORTER: f64 = 3.0;

/// Extent of the assembly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Reach {
    /// Its upper end from the bit, m: where ordinary pipe begins.
    pub(super) assembly_m: f64,
    /// Length of the solved part, from the bit, m.
    pub(super) solved_m: f64,
}

impl Reach {
    pub(super) fn of(model: &Model, settings: &AssemblySettings) -> Self {
        let whole_m = model.string.length_m();
        let top_m = assembly_top_m(&model.string);
        let solved_m = match settings.extent {
            Extent::Whole => whole_m,
            Extent::PipeAbove(pipe_m) => (top_m + pipe_m).min(whole_m),
        };
        // In a string that is uniform from end to end the upper half is affected by the constraint
        // of its top.
        let assembly_m = if top_m > 0.0 { top_m.min(solved_m) } else { 0.5 * solved_m };
        Self { assembly_m, solved_m }
    }
}

/// The elements of the solved part: shorter where contacts end, at places from the bit, m, and
/// every length divided by `refinement`.
pub(super) fn mesh(
    model: &Model,
    operation: &Operation,
    settings: &AssemblySettings,
    ends_m: &[f64],
    refinement: u32,
) -> Result<Mesh, SoftError> {
    let reach = Reach::of(model, settings);
    let element_m = settings.element_length_m;
    let length_m = |component: &Component| match component.joints {
        Some(joints) => (joints.spacing_m / PER_JOINT).max(element_m),
        None => element_m,
    };
    let mut stretches: Vec<([f64; 2], f64)> = Vec::new();
    let above = match settings.extent {
        Extent::PipeAbove(_) => None,
        Extent::Whole => Some(Sizing::auto(model, &[*operation], Accuracy::Standard)?),
    };
    for span in model.string.spans() {
        let lower = [span.from_bit_m, span.to_bit_m.min(reach.assembly_m)];
        if lower[0] < lower[1] {
            stretches.push((lower, length_m(span.component)));
        }
        let upper = [span.from_bit_m.max(reach.assembly_m), span.to_bit_m];
        if upper[0] < upper[1] {
            let pipe_m = match span.component.joints {
                Some(_) => length_m(span.component),
                None => PLAIN * element_m,
            };
            // Just above the assembly, where its bending dies away, and as the whole string has it.
            let near_m = upper[1].min(reach.assembly_m + 100.0);
            let all_m = if above.is_some() { near_m } else { upper[1] };
            if upper[0] < all_m {
                stretches.push(([upper[0], all_m], pipe_m));
            }
        }
    }
    if let Some(above) = &above {
        for (index, one) in above.intervals().iter().enumerate() {
            let next = above.intervals().get(index + 1);
            let to_m = next.map_or(f64::INFINITY, |next| next.from_bit_m);
            stretches.push(([one.from_bit_m, to_m], one.element_length_m));
        }
    }
    for span in model.string.spans().take_while(|span| span.from_bit_m < reach.assembly_m) {
        let Some(blades) = span.component.blades.filter(|blades| blades.length_m > POINT_M) else {
            continue;
        };
        let middle_m = 0.5 * (span.from_bit_m + span.to_bit_m);
        let half_m = 0.5 * blades.length_m + element_m;
        let ends_m = [(middle_m - half_m).max(0.0), middle_m + half_m];
        stretches.push((ends_m, element_m.min(blades.length_m)));
    }
    for at_m in ends_m {
        let around_m = AROUND * element_m;
        stretches.push(([(at_m - around_m).max(0.0), at_m + around_m], element_m / SHORTER));
    }
    let sizing = Sizing::shortest(&stretches, SizeReason::Assembly).refined(refinement);
    Ok(Mesh::new(&model.string, &sizing).lower_end(reach.solved_m))
}

// Settings of the assembly's solution.

/// Part of the string that is solved with the assembly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Extent {
    /// All of it.
    Whole,
    /// The assembly and so much of the pipe above it, m; the top of that is on the hole's axis.
    PipeAbove(f64),
}

/// Settings of the assembly's solution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AssemblySettings {
    /// Wall, bit and upper end. Its element lengths are not used.
    pub stiff: StiffSettings,
    /// Part of the string that is solved.
    pub extent: Extent,
    /// Length of the elements of the assembly, m. Those of jointed pipe are an eighth of a joint.
    pub element_length_m: f64,
}

impl Default for AssemblySettings {
    /// 100 m of pipe above the assembly, elements of 0.3 m.
    fn default() -> Self {
        Self {
            stiff: StiffSettings::default(),
            extent: Extent::PipeAbove(100.0),
            element_length_m: 0.3,
        }
    }
}
