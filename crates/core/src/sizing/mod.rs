//! Mesh sizing: lengths of the elements along the string, and the reasons for them.
//!
//! Theory, and the convergence study that the rule comes from: `docs/src/theory/mesh.md`.

mod rule;

pub use rule::assembly_top_m;

use serde::{Deserialize, Serialize};

// Length of the elements of a run.

/// Length of the elements of a run.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum ElementLength {
    /// About so long everywhere, m.
    Uniform(f64),
    /// As long as the required accuracy allows: from joint to joint, finer where needed.
    Auto(Accuracy),
}

/// Accuracy of a mesh with automatic lengths.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Accuracy {
    /// From joint to joint, the assembly too: for sweeps and for runs at many times real time.
    Coarse,
    /// From joint to joint where pipe hangs or rests on its joints, the assembly in elements of 3
    /// m.
    #[default]
    Standard,
    /// Half of the standard elements, everywhere.
    Fine,
}

impl Default for ElementLength {
    /// Automatic length, standard accuracy.
    fn default() -> Self {
        Self::Auto(Accuracy::default())
    }
}

// Why elements are as long as they are.

/// Why elements are as long as they are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum SizeReason {
    /// The length is given.
    Given,
    /// Pipe that hangs or rests on its tool joints.
    JointToJoint,
    /// Pipe without tool joints.
    PlainPipe,
    /// The bottom-hole assembly.
    Assembly,
    /// Next to a bend that turns with the string.
    RotatingBend,
    /// The body touches the wall between the joints.
    BodyContact,
    /// Compression near or beyond the critical load of sinusoidal buckling.
    Compression,
    /// An equilibrium shows that the bending turns there: a contact of the body begins or ends, or
    /// the hole bends otherwise.
    Refined,
}

impl SizeReason {
    /// Every reason.
    pub const ALL: [Self; 8] = [
        Self::Given,
        Self::JointToJoint,
        Self::PlainPipe,
        Self::Assembly,
        Self::RotatingBend,
        Self::BodyContact,
        Self::Compression,
        Self::Refined,
    ];

    /// Name in results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Given => "given",
            Self::JointToJoint => "joint to joint",
            Self::PlainPipe => "plain pipe",
            Self::Assembly => "assembly",
            Self::RotatingBend => "rotating bend",
            Self::BodyContact => "body contact",
            Self::Compression => "compression",
            Self::Refined => "refined",
        }
    }
}

// The length of elements along the string.

/// A stretch of the string whose elements are to be of one length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SizedInterval {
    /// Lower end, measured from the bit, m.
    pub from_bit_m: f64,
    /// Length of its elements, m.
    pub element_length_m: f64,
    /// Reason for the length.
    pub reason: SizeReason,
}

/// The length of elements along the string: intervals from the bit up, each up to the next, the
/// last without end.
#[derive(Debug, Clone, PartialEq)]
pub struct Sizing {
    intervals: Vec<SizedInterval>,
}

impl Sizing {
    /// Elements of about `element_length_m` everywhere.
    pub fn uniform(element_length_m: f64) -> Self {
        let reason = SizeReason::Given;
        Self { intervals: vec![SizedInterval { from_bit_m: 0.0, element_length_m, reason }] }
    }

    /// Intervals from the bit up, at least one.
    fn of_intervals(intervals: Vec<SizedInterval>) -> Self {
        Self { intervals }
    }

    /// The shortest of the lengths required by stretches of the string, each with its lower and its
    /// upper end from the bit, m, and its length, m. Together they cover the whole string.
    pub fn shortest(stretches: &[([f64; 2], f64)], reason: SizeReason) -> Self {
        let mut places: Vec<f64> = stretches.iter().flat_map(|(ends_m, _)| *ends_m).collect();
        places.retain(|place_m| place_m.is_finite());
        places.sort_by(f64::total_cmp);
        places.dedup();
        let mut intervals: Vec<SizedInterval> = Vec::new();
        for (index, from_bit_m) in places.iter().enumerate() {
            let to_m = places.get(index + 1).copied().unwrap_or(from_bit_m + 1.0);
            let middle_m = 0.5 * (from_bit_m + to_m);
            let here = stretches
                .iter()
                .filter(|([low_m, high_m], _)| (*low_m..*high_m).contains(&middle_m));
            let lengths = here.map(|(_, length_m)| *length_m);
            let element_length_m = lengths.fold(f64::INFINITY, f64::min);
            if !element_length_m.is_finite() {
                continue;
            }
            if intervals.last().is_none_or(|last| last.element_length_m != element_length_m) {
                let from_bit_m = *from_bit_m;
                intervals.push(SizedInterval { from_bit_m, element_length_m, reason });
            }
        }
        Self { intervals }
    }

    /// The same with every length divided by `refinement`: for convergence studies.
    #[must_use]
    pub fn refined(mut self, refinement: u32) -> Self {
        for one in &mut self.intervals {
            one.element_length_m /= f64::from(refinement);
        }
        self
    }

    /// The intervals, from the bit up.
    pub fn intervals(&self) -> &[SizedInterval] {
        &self.intervals
    }

    /// The interval at a distance from the bit, m.
    pub fn at(&self, from_bit_m: f64) -> &SizedInterval {
        let above = self.intervals.partition_point(|one| one.from_bit_m <= from_bit_m);
        &self.intervals[above.saturating_sub(1)]
    }

    /// Number of elements of the intervals' lengths that fit between two distances from the bit, m.
    pub fn lengths_between(&self, low_m: f64, high_m: f64) -> f64 {
        let mut lengths = 0.0;
        for (index, one) in self.intervals.iter().enumerate() {
            let end_m = self.intervals.get(index + 1).map_or(f64::INFINITY, |next| next.from_bit_m);
            let covered_m = high_m.min(end_m) - low_m.max(one.from_bit_m);
            lengths += covered_m.max(0.0) / one.element_length_m;
        }
        lengths
    }

    /// The distance from the bit, m, up to which so many `lengths` of elements fit above `low_m`.
    pub fn place_above(&self, low_m: f64, mut lengths: f64) -> f64 {
        let mut place_m = low_m;
        for (index, one) in self.intervals.iter().enumerate() {
            let end_m = self.intervals.get(index + 1).map_or(f64::INFINITY, |next| next.from_bit_m);
            if end_m <= place_m {
                continue;
            }
            let fit = (end_m - place_m) / one.element_length_m;
            if lengths <= fit {
                return place_m + lengths * one.element_length_m;
            }
            lengths -= fit;
            place_m = end_m;
        }
        place_m
    }
}
