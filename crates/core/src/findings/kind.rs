//! The kinds of findings.

use crate::outcome::QuantityKind;

macro_rules! kinds {
    ($($(#[$doc:meta])* $kind:ident, $word:literal, $quantity:ident;)+) => {
        /// What a finding reports.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum Kind {
            $($(#[$doc])* $kind,)+
        }

        impl Kind {
            /// Every kind.
            pub const ALL: &[Self] = &[$(Self::$kind),+];

            /// Its word for programs.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$kind => $word,)+
                }
            }

            /// What its value and its limit are.
            pub const fn quantity(self) -> QuantityKind {
                match self {
                    $(Self::$kind => QuantityKind::$quantity,)+
                }
            }

            /// SI unit of its value and limit; empty for a ratio.
            pub const fn unit(self) -> &'static str {
                self.quantity().unit()
            }

            /// The kind of that [`Kind::name`].
            pub fn named(name: &str) -> Option<Self> {
                Self::ALL.iter().copied().find(|of| of.name() == name)
            }
        }
    };
}

kinds! {
    /// The hook load is at or below zero: the string does not go down by its weight. Against zero,
    /// or what a rig that pushes gives.
    HookLoadNegative, "hook_load_negative", Force;
    /// A string that slides down does not bring the weight to the bit: the weight that was
    /// requested , against what arrives with the whole string slacked off and the block, where its
    /// weight is known, and a rig that pushes, pushing.
    LockUp, "lock_up", Force;
    /// The mean weight on bit is below its target.
    WeightOnBitNotReached, "weight_on_bit_not_reached", Force;
    /// The mean weight on bit is above its target.
    WeightOnBitExceeded, "weight_on_bit_exceeded", Force;
    /// The standard deviation of the weight on bit, against the part of its mean that is reported.
    WeightOnBitUnsteady, "weight_on_bit_unsteady", Force;
    /// The share of the window in which a bit that is to drill was off the rock.
    BitBounce, "bit_bounce", Ratio;
    /// Compression beyond the load of the sinusoid, where it is most beyond it.
    SinusoidalBuckling, "sinusoidal_buckling", Force;
    /// Compression beyond the load of the helix, where it is most beyond it.
    HelicalBuckling, "helical_buckling", Force;
    /// The load on the hoist, block included where its weight is known, against its capacity.
    HoistOverloaded, "hoist_overloaded", Force;
    /// The surface torque against the top drive's rated torque, or its peak torque where that is
    /// exceeded.
    TopDriveOverloaded, "top_drive_overloaded", Torque;
    /// The pressure that the pump delivers at against the limit of pumps and standpipe.
    PumpPressure, "pump_pressure", Pressure;
    /// The top drive gives all of the torque that it is allowed, and still turns.
    TopDriveAtLimit, "top_drive_at_limit", Torque;
    /// The top drive gives all of the torque that it is allowed, and does not turn.
    TopDriveStalled, "top_drive_stalled", Torque;
    /// The largest von Mises stress over the yield strength.
    YieldUse, "yield_use", Ratio;
    /// Severity of stick-slip, `(max − min)/(2 mean)` of the bit's rotary speed; no value where the
    /// bit hardly turns.
    StickSlip, "stick_slip", Ratio;
    /// The fastest whirl against the rotation, against the rotary speed.
    BackwardWhirl, "backward_whirl", RotarySpeed;
    /// The fastest whirl with the rotation, against the rotary speed.
    ForwardWhirl, "forward_whirl", RotarySpeed;
    /// The deepest penetration of the wall, against the part of the string's clearance that the law
    /// of the wall may be trusted to.
    WallPenetration, "wall_penetration", Length;
    /// What the integration gained or lost of the run's energy.
    EnergyResidual, "energy_residual", Ratio;
    /// The share of the time on the rock in which the bit was where its table is not.
    BitTableLeft, "bit_table_left", Ratio;
    /// Standard deviation of the tension of a node, against what its neighbours let expect.
    NodeUnsettled, "node_unsettled", Force;
    /// Compression on an element beyond its own buckling load: it gives way between its nodes, where
    /// no wall holds it.
    ElementBuckles, "element_buckles", Force;
    /// Standard deviation of the friction torque of a string that the bit shakes, where elements
    /// from joint to joint leave out how the pipe vibrates between its contacts.
    BendingWavesLeftOut, "bending_waves_left_out", Torque;
    /// Lateral forces on components, in sum, that the soft string leaves out.
    LateralForceLeftOut, "lateral_force_left_out", Force;
    /// An equilibrium that a small disturbance would leave.
    UnstableEquilibrium, "unstable_equilibrium", Ratio;
    /// No state of rest was found: the largest force out of balance, where it is known.
    NoEquilibrium, "no_equilibrium", Force;
    /// Means of the window drift: what they are depends on when it began.
    WindowDrifts, "window_drifts", Ratio;
    /// The string was not steady when settling ended, after this time.
    NeverSteady, "never_steady", Time;
    /// The mean measured depth of the bit over the window, against what was requested.
    BitElsewhere, "bit_elsewhere", Depth;
}
