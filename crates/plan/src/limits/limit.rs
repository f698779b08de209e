//! One limit, and all of an operation.

use super::{DesignFactors, LimitKind};
use crate::strength::SurfaceStress;

/// A factor that is less than this above the required one is near to it.
const NEAR: f64 = 1.1;

/// How an operation stands to a limit. Worse ones are greater.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Standing {
    /// The factor is kept.
    Kept,
    /// It is kept by less than a tenth.
    Near,
    /// It is not kept: the load is less than the capacity, but not by what is required; or a string
    /// buckles, or a reserve is less than was asked.
    Short,
    /// The load is beyond the capacity.
    Passed,
}

impl Standing {
    /// Name in results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Kept => "kept",
            Self::Near => "near",
            Self::Short => "short",
            Self::Passed => "passed",
        }
    }
}

/// A load against what bears it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadCheck {
    /// What it is of.
    pub kind: LimitKind,
    /// The component, counted from the bit; none of the rig.
    pub component: Option<usize>,
    /// Where, measured depth in m; none of the rig.
    pub md_m: Option<f64>,
    /// The load, in the unit of [`LimitKind::quantity`]; more than zero.
    pub load: f64,
    /// What is borne, in the same unit.
    pub capacity: f64,
    /// Capacity over load.
    pub factor: f64,
    /// The least factor that is to be kept.
    pub required: f64,
    /// How it stands.
    pub level: Standing,
    /// Of a von Mises stress, the point of the body and its stresses.
    pub stress: Option<SurfaceStress>,
}

impl LoadCheck {
    /// None where nothing loads it.
    pub(super) fn new(
        kind: LimitKind,
        load: f64,
        capacity: f64,
        factors: &DesignFactors,
    ) -> Option<Self> {
        if load.is_nan() || load <= 0.0 || !capacity.is_finite() {
            return None;
        }
        let (factor, required) = (capacity / load, factors.of(kind));
        let level = match () {
            () if factor < 1.0 && kind.breaks() => Standing::Passed,
            () if factor < required => Standing::Short,
            () if factor < NEAR * required => Standing::Near,
            () => Standing::Kept,
        };
        Some(Self {
            kind,
            component: None,
            md_m: None,
            load,
            capacity,
            factor,
            required,
            level,
            stress: None,
        })
    }

    /// The same of a component at a measured depth, m.
    pub(super) fn at(self, component: Option<usize>, md_m: f64) -> Self {
        Self { component, md_m: Some(md_m), ..self }
    }

    /// Factor over the required one: what the load may grow by, and less than one where the factor is not
    /// kept.
    pub fn reserve(&self) -> f64 {
        self.factor / self.required
    }
}

/// What a limit would have needed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Missing {
    /// Of the component.
    YieldStrength,
    /// Of its connections.
    MakeUpTorque,
    /// Of the hoist.
    HoistCapacity,
    /// Rated, of the top drive.
    TopDriveTorque,
    /// Largest, of the top drive.
    TopDrivePeakTorque,
    /// Of the pump.
    PumpPressureLimit,
    /// Of the mud: without it the pump's pressure is not known.
    Rheology,
}

impl Missing {
    /// What is missing, in words.
    pub const fn words(self) -> &'static str {
        match self {
            Self::YieldStrength => "no yield strength",
            Self::MakeUpTorque => "no make-up torque",
            Self::HoistCapacity => "no capacity of the hoist",
            Self::TopDriveTorque => "no rated torque of the top drive",
            Self::TopDrivePeakTorque => "no peak torque of the top drive",
            Self::PumpPressureLimit => "no limit of the pump's pressure",
            Self::Rheology => "no rheology of the mud",
        }
    }
}

/// A limit that could not be checked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Unchecked {
    /// Which.
    pub kind: LimitKind,
    /// Of which component, counted from the bit; none of the rig.
    pub component: Option<usize>,
    /// What it would have needed.
    pub missing: Missing,
}

/// The limits of an operation.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Limits {
    /// Of each kind one for each component that it concerns, and those of the rig.
    pub limits: Vec<LoadCheck>,
    /// What could not be checked.
    pub unchecked: Vec<Unchecked>,
}

impl Limits {
    /// The limit of a kind that has the least reserve.
    pub fn worst(&self, kind: LimitKind) -> Option<&LoadCheck> {
        self.least(|of| of.kind == kind)
    }

    /// What would break, or stop the operation, first.
    pub fn first(&self) -> Option<&LoadCheck> {
        self.least(|of| of.kind.breaks())
    }

    fn least(&self, which: impl Fn(&LoadCheck) -> bool) -> Option<&LoadCheck> {
        let of = self.limits.iter().filter(|of| which(of));
        of.min_by(|a, b| a.reserve().total_cmp(&b.reserve()))
    }

    pub(super) fn lacks(&mut self, kind: LimitKind, component: Option<usize>, missing: Missing) {
        self.unchecked.push(Unchecked { kind, component, missing });
    }
}
