//! What may stop a string from going deeper.

use wholestring::{operation::Operation, rig::Rig, string::DrillString};

/// Declares the limits, each once: what it is, its name in results, its words and what its load and
/// bound are.
macro_rules! limits {
    ($(
        $(#[$meaning:meta])*
        $limit:ident = $name:ident ($title:literal, $unit:literal)
    ;)+) => {
        /// What may stop a string from going deeper, or what it meets on its way.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum Limit {
            $($(#[$meaning])* $limit,)+
        }

        impl Limit {
            /// Every limit, in the order in which reports list them.
            pub const ALL: [Self; [$(stringify!($name)),+].len()] = [$(Self::$limit),+];

            /// Name in results.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$limit => stringify!($name),)+ }
            }

            /// What people read.
            pub const fn title(self) -> &'static str {
                match self { $(Self::$limit => $title,)+ }
            }

            /// SI unit of its load and its bound; empty of a plain number.
            pub const fn unit(self) -> &'static str {
                match self { $(Self::$limit => $unit,)+ }
            }
        }
    };
}

limits! {
    /// The surface torque is the rated torque of the top drive.
    TopDrive = top_drive ("top drive", "N·m");
    /// The hook load and the block are what the hoist carries.
    Hoist = hoist ("hoist", "N");
    /// Nothing hangs on the hook any more: the block begins to push.
    HookLoadZero = hook_load_zero ("hook load zero", "N");
    /// Block and rig push with all they have.
    PushSpent = push_spent ("push of block and rig spent", "N");
    /// A string whose helix rubs takes any push, however great: nothing of it arrives at the bit.
    LockUp = lock_up ("lock-up", "");
    /// The largest von Mises stress is the yield strength.
    Yield = yield_strength ("yield", "");
    /// Somewhere the compression is that of the helix, where the wall holds a straight pipe.
    Helix = helix ("helical buckling begins", "N");
    /// Somewhere the compression is that of the sinusoid, where the wall holds a straight pipe.
    Sinusoid = sinusoid ("sinusoidal buckling begins", "N");
    /// Somewhere the compression is that of the helix, where only its weight holds a pipe straight:
    /// in a vertical or nearly vertical hole.
    VerticalHelix = vertical_helix ("helical buckling begins in vertical hole", "N");
}

impl Limit {
    /// Whether the string stops there if nothing else is asked for. It goes on buckled.
    pub const fn stops(self) -> bool {
        !matches!(self, Self::Helix | Self::Sinusoid | Self::VerticalHelix)
    }

    /// Whether it is a limit of an operation of that string on that rig.
    pub(super) fn concerns(self, operation: &Operation, rig: &Rig, string: &DrillString) -> bool {
        let goes_down = operation.axial_velocity_m_per_s() > 0.0 || operation.slides_down();
        match self {
            Self::TopDrive => operation.kind.rotates() && rig.top_drive_torque_N_m.is_some(),
            Self::Hoist => !goes_down && rig.hoist_capacity_N.is_some(),
            Self::HookLoadZero | Self::Helix | Self::Sinusoid | Self::VerticalHelix => goes_down,
            Self::PushSpent => goes_down && rig.push_with_block_N() > 0.0,
            Self::LockUp => operation.slides_down(),
            Self::Yield => {
                let mut components = string.components().iter();
                components.any(|component| component.yield_strength_Pa.is_some())
            }
        }
    }
}
