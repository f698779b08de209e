//! The kinds of limits, and the factors that each must keep.

use wholestring::outcome::QuantityKind;

/// Declares kinds and factors at once: name, what people call it, kind of load and capacity, whether the
/// pipe breaks or the operation stops where it is passed, and the factor where nothing else is said.
macro_rules! kinds {
    ($($(#[$about:meta])* $kind:ident = $name:ident, $label:literal: $quantity:ident,
        breaks $breaks:literal, $default:expr;)+) => {
        /// What a limit is of.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum LimitKind {
            $($(#[$about])* $kind,)+
        }

        impl LimitKind {
            /// Every kind, in the order of tables.
            pub const ALL: &[Self] = &[$(Self::$kind,)+];

            /// Name in case files and results.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$kind => stringify!($name),)+
                }
            }

            /// What people call it.
            pub const fn label(self) -> &'static str {
                match self {
                    $(Self::$kind => $label,)+
                }
            }

            /// What its load and its capacity are.
            pub const fn quantity(self) -> QuantityKind {
                match self {
                    $(Self::$kind => QuantityKind::$quantity,)+
                }
            }

            /// Whether something breaks or stops where it is passed: not where the string only buckles,
            /// nor where a reserve is less than was asked.
            pub const fn breaks(self) -> bool {
                match self {
                    $(Self::$kind => $breaks,)+
                }
            }
        }

        /// The least capacity over load that each kind is to keep.
        #[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
        pub struct DesignFactors {
            $($(#[$about])* pub $name: f64,)+
        }

        impl Default for DesignFactors {
            fn default() -> Self {
                Self { $($name: $default,)+ }
            }
        }

        impl DesignFactors {
            /// The factor of a kind.
            pub const fn of(&self, kind: LimitKind) -> f64 {
                match kind {
                    $(LimitKind::$kind => self.$name,)+
                }
            }

            /// The first kind whose factor is not a positive number, and that.
            pub fn bad_factor(&self) -> Option<(LimitKind, f64)> {
                let factors = LimitKind::ALL.iter().map(|kind| (*kind, self.of(*kind)));
                let good = |factor: f64| factor.is_finite() && factor > 0.0;
                factors.into_iter().find(|(_, factor)| !good(*factor))
            }
        }
    };
}

kinds! {
    /// Effective tension against the tensile yield of body or connection, whichever is less. Default
    /// 1/0.9: API RP 7G's customary 90 % of the yield.
    Tension = tension, "Tension": Force, breaks true, 1.0 / 0.9;
    /// Torque against the torsional yield of body or connection, whichever is less. Default 1.25: 80 % of
    /// the yield, as commonly planned.
    Torsion = torsion, "Torsion": Torque, breaks true, 1.25;
    /// Torque against the torsional yield of the body under the tension that is there (API RP 7G).
    /// Default 1/0.9, as tension.
    TensionAndTorsion = tension_and_torsion, "Tension and torsion": Torque, breaks true, 1.0 / 0.9;
    /// Von Mises stress of the body, bending at and between tool joints included, against its minimum
    /// yield strength. Default 1.25, common for drill pipe.
    VonMises = von_mises, "Von Mises stress": Pressure, breaks true,
        1.0 / wholestring::findings::YIELD_USE_WARNING;
    /// Pressure inside over that outside against the burst of the body. Default 1.1, as commonly
    /// planned.
    Burst = burst, "Burst": Pressure, breaks true, 1.1;
    /// Pressure outside over that inside against the collapse of the body under its tension. Default
    /// 1.1, as commonly planned.
    Collapse = collapse, "Collapse": Pressure, breaks true, 1.1;
    /// Torque against the make-up torque of the connections: beyond it they make up further down the
    /// hole. Default 1.
    MakeUp = make_up, "Make-up torque": Torque, breaks true, 1.0;
    /// Hook load and block against the capacity of the hoist. Default 1/0.9: 90 % of it.
    Hoist = hoist, "Hoist": Force, breaks true, 1.0 / 0.9;
    /// Surface torque against the rated (continuous) torque of the top drive. Default 1: the rating is a
    /// limit of use.
    TopDrive = top_drive, "Top drive, continuous": Torque, breaks true, 1.0;
    /// Surface torque against the largest torque of the top drive. Default 1.
    TopDrivePeak = top_drive_peak, "Top drive, peak": Torque, breaks true, 1.0;
    /// Pressure that the pump delivers at against its limit. Default 1/0.9: relief valves are commonly
    /// set there.
    PumpPressure = pump_pressure, "Pump pressure": Pressure, breaks true, 1.0 / 0.9;
    /// Compression against the load of the sinusoid. Default 1.
    SinusoidalBuckling = sinusoidal_buckling, "Sinusoidal buckling": Force, breaks false, 1.0;
    /// Compression against the load of the helix. Default 1.
    HelicalBuckling = helical_buckling, "Helical buckling": Force, breaks false, 1.0;
    /// Of a string that slides down: friction and the weight on bit that is asked for, against what drives
    /// it down, its own weight and a rig that pushes. Default 1.
    LockUp = lock_up, "Lock-up": Force, breaks true, 1.0;
    /// Overpull that is asked for against what the string and the hoist have left of what they are
    /// allowed. Default 1.
    Overpull = overpull, "Overpull margin": Force, breaks false, 1.0;
}
