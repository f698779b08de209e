//! Limits of the depth of a string, each declared once.

use crate::{CheckKind, torque_capacity_N_m};
use wholestring::{
    model::Model,
    operation::{Operation, OperationKind},
};

/// Declares the limits, each once, with name in results, words, load and bound.
macro_rules! limits {
    ($(
        $(#[$meaning:meta])*
        $limit:ident = $name:ident ($title:literal, $unit:literal)
    ;)+) => {
        /// A limit that stops a string from going deeper, or that it passes on its way.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum DepthLimit {
            $($(#[$meaning])* $limit,)+
        }

        impl DepthLimit {
            /// Every limit, in the order in which reports list them.
            pub const ALL: [Self; [$(stringify!($name)),+].len()] = [$(Self::$limit),+];

            /// Returns the name in results.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$limit => stringify!($name),)+ }
            }

            /// Returns the name for display.
            pub const fn title(self) -> &'static str {
                match self { $(Self::$limit => $title,)+ }
            }

            /// Returns the SI unit of its load and its bound; empty for a plain number.
            pub const fn unit(self) -> &'static str {
                match self { $(Self::$limit => $unit,)+ }
            }
        }
    };
}

limits! {
    /// The surface torque equals the rated or the peak torque of the top drive.
    TopDrive = top_drive ("top drive", "N·m");
    /// The torque that starts the string turning equals that of the top drive.
    Breakaway = breakaway ("breakaway torque", "N·m");
    /// Hook load and block equal the capacity of the hoist.
    Hoist = hoist ("hoist", "N");
    /// The pressure of the pump equals its limit.
    PumpPressure = pump_pressure ("pump pressure", "");
    /// The hook load is zero: the block begins to push.
    HookLoadZero = hook_load_zero ("hook load zero", "N");
    /// Block and rig push with their full force.
    PushSpent = push_spent ("push of block and rig spent", "N");
    /// A string whose helix has friction absorbs any push, however great: none of it reaches the
    /// bit. A lock-up limits the push of block and rig, this one no push does: [`Self::PushSpent`]
    /// is met before.
    PushAbsorbed = push_absorbed ("any push absorbed", "");
    /// The torque of a connection equals that with which it was made up.
    MakeUp = make_up ("make-up torque", "N·m");
    /// The torque equals the torsional yield of a pipe or its connection.
    Torsion = torsion ("torsional yield", "N·m");
    /// The largest von Mises stress equals the yield strength.
    Yield = yield_strength ("yield", "");
    /// Tension, torque under tension or a difference of pressure equals the strength of pipe or
    /// connection.
    Strength = strength ("tension, burst or collapse", "");
    /// Somewhere the compression equals the load of the helix, where the wall holds a straight
    /// pipe.
    Helix = helix ("helical buckling begins in inclined hole", "N");
    /// Somewhere the compression equals the load of the sinusoid, where the wall holds a straight
    /// pipe.
    Sinusoid = sinusoid ("sinusoidal buckling begins in inclined hole", "N");
    /// Somewhere the compression equals the load of the helix, where only its weight holds a pipe
    /// straight: in a vertical or nearly vertical hole.
    VerticalHelix = vertical_helix ("helical buckling begins in vertical hole", "N");
    /// The same of the sinusoid: the first bow of collars that press on the bit.
    VerticalSinusoid = vertical_sinusoid ("sinusoidal buckling begins in vertical hole", "N");
}

/// Names that earlier versions wrote, and the limits that replace them.
const FORMER_NAMES: [(&str, DepthLimit); 1] = [("lock_up", DepthLimit::PushAbsorbed)];

impl DepthLimit {
    /// The limit with this name, names of earlier versions included.
    pub fn named(name: &str) -> Option<Self> {
        let now = Self::ALL.into_iter().find(|limit| limit.name() == name);
        let former = || FORMER_NAMES.iter().find(|(former, _)| *former == name);
        now.or_else(|| former().map(|(_, limit)| *limit))
    }

    /// Whether the string stops there by default. A buckled string continues.
    pub const fn stops(self) -> bool {
        !matches!(self, Self::Helix | Self::Sinusoid | Self::VerticalHelix | Self::VerticalSinusoid)
    }

    /// The judge's checks with which it is the same: none for a limit of descent or buckling.
    pub const fn checks(self) -> &'static [CheckKind] {
        match self {
            Self::TopDrive => &[CheckKind::TopDrive, CheckKind::TopDrivePeak],
            Self::Breakaway => &[CheckKind::Breakaway],
            Self::Hoist => &[CheckKind::Hoist],
            Self::PumpPressure => &[CheckKind::PumpPressure],
            Self::MakeUp => &[CheckKind::MakeUp],
            Self::Torsion => &[CheckKind::Torsion],
            Self::Yield => &[CheckKind::VonMises],
            Self::Strength => &[
                CheckKind::Tension,
                CheckKind::TensionAndTorsion,
                CheckKind::Burst,
                CheckKind::Collapse,
            ],
            Self::HookLoadZero
            | Self::PushSpent
            | Self::PushAbsorbed
            | Self::Helix
            | Self::Sinusoid
            | Self::VerticalHelix
            | Self::VerticalSinusoid => &[],
        }
    }

    /// Whether it is a limit of an operation of that string on that rig.
    pub fn concerns(self, operation: &Operation, model: &Model) -> bool {
        let (rig, kind) = (&model.rig, operation.kind);
        let goes_down = operation.axial_velocity_m_per_s() > 0.0 || operation.slides_down();
        let top_drive_N_m = rig.top_drive_peak_torque_N_m.or(rig.top_drive_torque_N_m);
        let mut components = model.string.components().iter();
        match self {
            Self::TopDrive => kind.rotates() && top_drive_N_m.is_some(),
            Self::Breakaway => {
                let mut sections = model.well.hole.sections().iter();
                kind == OperationKind::RotateOffBottom
                    && top_drive_N_m.is_some()
                    && sections.any(|section| section.friction.at_rest > section.friction.kinetic)
            }
            Self::Hoist => rig.hoist_capacity_N.is_some(),
            Self::PumpPressure => {
                let is_known = rig.pump_pressure_limit_Pa.is_some() && model.mud.rheology.is_some();
                kind.circulates() && is_known
            }
            Self::HookLoadZero
            | Self::Helix
            | Self::Sinusoid
            | Self::VerticalHelix
            | Self::VerticalSinusoid => goes_down,
            Self::PushSpent => goes_down && rig.push_with_block_N() > 0.0,
            Self::PushAbsorbed => operation.slides_down(),
            Self::MakeUp | Self::Torsion => {
                let is_known = |component| {
                    let kinds = self.checks().iter();
                    kinds.filter_map(|kind| torque_capacity_N_m(component, *kind)).next().is_some()
                };
                kind.rotates() && components.any(is_known)
            }
            Self::Yield => components.any(|component| component.yield_strength_Pa.is_some()),
            Self::Strength => components.any(|component| {
                let of_connection_N = component.connection.tensile_yield_N;
                component.yield_strength_Pa.is_some() || of_connection_N.is_some()
            }),
        }
    }
}

impl serde::Serialize for DepthLimit {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

impl<'de> serde::Deserialize<'de> for DepthLimit {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = <std::borrow::Cow<'de, str>>::deserialize(deserializer)?;
        Self::named(&name)
            .ok_or_else(|| serde::de::Error::custom(format!("`{name}` is no limit of a reach")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read_back_and_others_are_refused() {
        for limit in DepthLimit::ALL {
            let json = serde_json::to_string(&limit).expect("a name");
            assert_eq!(json, format!("\"{}\"", limit.name()));
            assert_eq!(serde_json::from_str::<DepthLimit>(&json).expect("a limit"), limit);
        }
        let former: DepthLimit = serde_json::from_str("\"lock_up\"").expect("a former name");
        assert_eq!(former, DepthLimit::PushAbsorbed);
        let error = serde_json::from_str::<DepthLimit>("\"patience\"").expect_err("no limit");
        assert!(error.to_string().contains("`patience` is no limit of a reach"), "{error}");
    }
}
