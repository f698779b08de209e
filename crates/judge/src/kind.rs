//! The kinds of checks, each declared once.

use wholestring::outcome::QuantityKind;

/// Consequence of a load that is larger than its capacity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Consequence {
    /// Something breaks, or the operation stops.
    Stops,
    /// The string buckles, or a requested reserve is missing; the operation continues.
    Continues,
}

/// Declares limits and findings: a name for programs, a label for people and the kind of quantity;
/// for limits also the consequence, the required factor by default and its meaning.
macro_rules! kinds {
    (
        limits {
            $($(#[$about:meta])* $limit:ident = $limit_name:ident, $limit_label:literal:
                $limit_quantity:ident, $consequence:ident, $default:expr;)+
        }
        findings {
            $($(#[$meaning:meta])* $finding:ident = $name:ident, $label:literal: $quantity:ident;)+
        }
    ) => {
        /// Quantity that a check compares, or state that it reports.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum CheckKind {
            $($(#[$about])* $limit,)+
            $($(#[$meaning])* $finding,)+
        }

        impl CheckKind {
            /// Every kind; limits first, in the order of tables.
            pub const ALL: &[Self] = &[$(Self::$limit,)+ $(Self::$finding,)+];

            /// The kinds that compare a load with a capacity.
            pub const LIMITS: &[Self] = &[$(Self::$limit,)+];

            /// Name in case files and results.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$limit => stringify!($limit_name),)+
                    $(Self::$finding => stringify!($name),)+
                }
            }

            /// Label for people.
            pub const fn label(self) -> &'static str {
                match self {
                    $(Self::$limit => $limit_label,)+
                    $(Self::$finding => $label,)+
                }
            }

            /// Kind of quantity of value and limit.
            pub const fn quantity(self) -> QuantityKind {
                match self {
                    $(Self::$limit => QuantityKind::$limit_quantity,)+
                    $(Self::$finding => QuantityKind::$quantity,)+
                }
            }

            /// Consequence of an exceeded limit; `None` for a kind that is not a limit.
            pub const fn consequence(self) -> Option<Consequence> {
                match self {
                    $(Self::$limit => Some(Consequence::$consequence),)+
                    $(Self::$finding => None,)+
                }
            }
        }

        /// Required factors, capacity over load, of each kind of limit.
        #[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
        pub struct DesignFactors {
            $($(#[$about])* pub $limit_name: f64,)+
        }

        impl Default for DesignFactors {
            fn default() -> Self {
                Self { $($limit_name: $default,)+ }
            }
        }

        impl DesignFactors {
            /// The required factor of a kind; one for a kind that is not a limit.
            pub const fn required(&self, kind: CheckKind) -> f64 {
                match kind {
                    $(CheckKind::$limit => self.$limit_name,)+
                    $(CheckKind::$finding => 1.0,)+
                }
            }
        }
    };
}

kinds! {
    limits {
        /// Effective tension against the tensile yield of body or connection, whichever is less.
        /// Default 1/0.9: API RP 7G's customary 90 % of the yield.
        Tension = tension, "Tension": Force, Stops, 1.0 / 0.9;
        /// Torque against the torsional yield of body or connection, whichever is less. Default
        /// 1.25: 80 % of the yield, as commonly planned.
        Torsion = torsion, "Torsion": Torque, Stops, 1.25;
        /// Torque against the torsional yield of the body under its tension (API RP 7G). Default
        /// 1/0.9, as tension.
        TensionAndTorsion = tension_and_torsion, "Tension and torsion": Torque, Stops, 1.0 / 0.9;
        /// Von Mises stress of the body, bending at and between tool joints included, against its
        /// minimum yield strength. Default 1.25, common for drill pipe.
        VonMises = von_mises, "Von Mises stress": Stress, Stops, 1.25;
        /// Pressure inside over that outside against the burst of the body. Default 1.1, as
        /// commonly planned.
        Burst = burst, "Burst": Pressure, Stops, 1.1;
        /// Pressure outside over that inside against the collapse of the body under its tension.
        /// Default 1.1, as commonly planned.
        Collapse = collapse, "Collapse": Pressure, Stops, 1.1;
        /// Torque against the make-up torque of the connections: beyond it they make up further
        /// down the hole. Default 1.
        MakeUp = make_up, "Make-up torque": Torque, Stops, 1.0;
        /// Side force of the wall on one joint of pipe against the limit of the case. Default 1.
        SideForce = side_force, "Side force per joint": Force, Continues, 1.0;
        /// Hook load and block against the capacity of the hoist. Default 1/0.9: 90 % of it.
        Hoist = hoist, "Hoist": Force, Stops, 1.0 / 0.9;
        /// Surface torque against the rated (continuous) torque of the top drive. Default 1: the
        /// rating is a limit of use.
        TopDrive = top_drive, "Top drive, continuous": Torque, Stops, 1.0;
        /// Surface torque against the largest torque of the top drive. Default 1.
        TopDrivePeak = top_drive_peak, "Top drive, peak": Torque, Stops, 1.0;
        /// Torque that starts the string turning, by the static friction of the case, against the
        /// peak torque of the top drive, or its rated torque where no peak is given. Default 1.
        Breakaway = breakaway, "Breakaway torque": Torque, Stops, 1.0;
        /// Pump pressure against the limit of pumps and standpipe. Default 1/0.9: relief valves are
        /// commonly set there.
        PumpPressure = pump_pressure, "Pump pressure": Pressure, Stops, 1.0 / 0.9;
        /// Compression against the critical load of sinusoidal buckling. Default 1.
        SinusoidalBuckling = sinusoidal_buckling, "Sinusoidal buckling": Force, Continues, 1.0;
        /// Compression against the critical load of helical buckling. Default 1.
        HelicalBuckling = helical_buckling, "Helical buckling": Force, Continues, 1.0;
        /// Friction and requested weight on bit of a string that slides down, against its drive:
        /// its own weight, the block and a rig that pushes. Default 1.
        LockUp = lock_up, "Lock-up": Force, Stops, 1.0;
        /// Requested overpull against the allowable that string and hoist have left. Default 1.
        Overpull = overpull, "Overpull margin": Force, Continues, 1.0;
    }
    findings {
        /// Whether the string goes down by its weight: hook load without the block, against zero or
        /// the force of a rig that pushes.
        GoesDown = goes_down, "Descent by own weight": Force;
        /// Requested weight on bit that the string does not have even without friction, block and
        /// rig pushing, against the weight that is available.
        WeightNotAvailable = weight_not_available, "Weight on bit not available": Force;
        /// No static equilibrium, or none that was found: the largest force out of balance, where
        /// it is known.
        NoEquilibrium = no_equilibrium, "No static equilibrium": Force;
        /// Mean weight on bit below its set point.
        WeightOnBitNotReached = weight_on_bit_not_reached, "Weight on bit not reached": Force;
        /// Mean weight on bit above its set point.
        WeightOnBitExceeded = weight_on_bit_exceeded, "Weight on bit exceeded": Force;
        /// Standard deviation of the weight on bit, against the part of its mean that is reported.
        WeightOnBitUnsteady = weight_on_bit_unsteady, "Weight on bit unsteady": Force;
        /// Share of the window in which a drilling bit was off the rock.
        BitBounce = bit_bounce, "Bit bounce": Ratio;
        /// The top drive works at its torque limit and still turns.
        TopDriveAtLimit = top_drive_at_limit, "Top drive at its limit": Torque;
        /// The top drive works at its torque limit and does not turn.
        TopDriveStalled = top_drive_stalled, "Top drive stalled": Torque;
        /// Severity of stick-slip, `(max − min)/(2 mean)` of the bit's rotary speed; no value where
        /// the bit hardly turns.
        StickSlip = stick_slip, "Stick-slip": Ratio;
        /// Fastest whirl against the rotation, against the rotary speed.
        BackwardWhirl = backward_whirl, "Backward whirl": RotarySpeed;
        /// Fastest whirl with the rotation, against the rotary speed.
        ForwardWhirl = forward_whirl, "Forward whirl": RotarySpeed;
        /// Deepest penetration of the wall, against the part of the string's clearance for which
        /// the law of the wall is valid.
        WallPenetration = wall_penetration, "Wall penetration": Length;
        /// Energy that the integration gained or lost.
        EnergyResidual = energy_residual, "Energy residual": Ratio;
        /// Share of the time on the rock in which the bit was outside its table.
        BitTableLeft = bit_table_left, "Bit outside its table": Ratio;
        /// Standard deviation of the tension of a node, against that of its neighbours.
        NodeUnsettled = node_unsettled, "Node not settled": Force;
        /// Compression of an element beyond its own buckling load: it gives way between its nodes,
        /// where no wall holds it.
        ElementBuckles = element_buckles, "Element buckles between its nodes": Force;
        /// Standard deviation of the friction torque of a string that the bit shakes, where
        /// elements from joint to joint leave out how the pipe vibrates between its contacts.
        BendingWavesLeftOut = bending_waves_left_out, "Bending waves left out": Torque;
        /// Sum of lateral forces on components that the soft string leaves out.
        LateralForceLeftOut = lateral_force_left_out, "Lateral force left out": Force;
        /// Hook load of a string that is pushed down as a helix, against that on a finer mesh; no
        /// limit where the finer mesh has no equilibrium.
        HelixNotResolved = helix_not_resolved, "Helix not resolved": Force;
        /// An equilibrium that a small disturbance would leave.
        UnstableEquilibrium = unstable_equilibrium, "Unstable equilibrium": Ratio;
        /// A physically implausible number of the hydraulics, such as the pressure of a sliver of
        /// bore; a value where it is a pressure.
        ImplausibleHydraulics = implausible_hydraulics, "Implausible hydraulics": Pressure;
        /// Means of the window drift: they depend on when it began.
        WindowDrifts = window_drifts, "Window drifts": Ratio;
        /// The string was not steady when settling ended, after this time.
        NeverSteady = never_steady, "Never steady": Time;
        /// Standard deviation of the hook load of a string that trips without rotation, where it
        /// does not decay: friction feeds a vibration.
        HookLoadSwings = hook_load_swings, "Hook load swings": Force;
        /// Depth of the bit that an operation reaches, against the last depth that was tried.
        Reach = reach, "Reach": Depth;
        /// Readings of zero, which count as not measured.
        ReadingsZero = zero, "Zero readings": Ratio;
        /// Negative weights or torques.
        ReadingsNegative = negative, "Negative readings": Ratio;
        /// Pick-up below slack-off in most rows.
        ReadingsSwapped = swapped, "Columns swapped": Ratio;
        /// Rows in which pick-up, rotating and slack-off weight do not fall in this order.
        OrderOfLoads = order_of_loads, "Order of loads": Ratio;
        /// A column without a reading that counts.
        NoReadings = no_readings, "No readings": Ratio;
        /// Readings that another unit would bring in line.
        ReadingsUnit = unit, "Unit of readings": Ratio;
        /// Hook loads below the block's weight.
        BelowBlock = below_block, "Below the block": Ratio;
        /// Weights that do not hold the block of the case.
        BlockNotInReadings = block_not_in_readings, "Block not in readings": Ratio;
        /// A block that weighs nothing or less.
        NoBlock = no_block, "No block": Ratio;
        /// A hole in which friction changes none of the readings.
        NoFriction = no_friction, "No friction": Ratio;
        /// A reading far from its prediction.
        Outlier = outlier, "Outlier": Ratio;
        /// Outliers that a robust loss detects, and the result without them.
        Outliers = outliers, "Outliers": Ratio;
        /// Two parameters that the readings hardly distinguish.
        NotToldApart = not_told_apart, "Parameters not distinguished": Ratio;
        /// A fragment that the case would refuse.
        CaseFragment = fragment, "Case fragment": Ratio;
        /// Readings compared with the dynamic run.
        CheckByDynamics = dynamics, "Check by the dynamics": Ratio;
        /// Work that was interrupted.
        Interrupted = interrupted, "Interrupted": Ratio;
        /// More outliers than a robust loss can distinguish from readings.
        TooManyOutliers = too_many_outliers, "Too many outliers": Ratio;
        /// An estimated error that no instrument has.
        EstimatedError = estimated_error, "Estimated error": Ratio;
        /// Readings that scatter more than their errors.
        Scatter = scatter, "Scatter": Ratio;
        /// Readings outside their band.
        Band = band, "Band": Ratio;
        /// An interval without an end.
        OpenInterval = open_interval, "Open interval": Ratio;
        /// A block that the readings give and the case does not.
        BlockWeight = block_weight, "Block weight": Ratio;
        /// A bit depth that is rounded beyond the end of hole and survey.
        RoundedDepth = rounded_depth, "Rounded depth": Ratio;
        /// A point of a bit test, or of an assembly's sweep, without a result.
        PointFailed = point_failed, "Point without an answer": Ratio;
        /// A bit that breaks no rock.
        BitDoesNotDrill = bit_does_not_drill, "Bit does not drill": Ratio;
        /// Kinetic energy of the rock, over the work of its deformation.
        RockKineticEnergy = rock_kinetic_energy, "Kinetic energy of the rock": Ratio;
        /// Another state of a calibration.
        Calibration = calibration, "Calibration": Ratio;
        /// Mean measured depth of the bit over the window, against the requested one.
        BitElsewhere = bit_elsewhere, "Bit elsewhere": Depth;
    }
}

/// Names that earlier versions wrote, and the kinds that replace them.
const FORMER_NAMES: [(&str, CheckKind); 4] = [
    ("hook_load_negative", CheckKind::GoesDown),
    ("hoist_overloaded", CheckKind::Hoist),
    ("top_drive_overloaded", CheckKind::TopDrive),
    ("yield_use", CheckKind::VonMises),
];

impl CheckKind {
    /// Whether exceeding it breaks something or stops the operation.
    pub const fn stops(self) -> bool {
        matches!(self.consequence(), Some(Consequence::Stops))
    }

    /// Whether it compares a load with a capacity.
    pub const fn is_limit(self) -> bool {
        self.consequence().is_some()
    }

    /// Whether a reported state is the worse the lower its value is; the others are the worse the
    /// higher.
    pub(crate) const fn is_worse_below(self) -> bool {
        matches!(self, Self::GoesDown)
    }

    /// SI unit of value and limit; empty for a ratio.
    pub const fn unit(self) -> &'static str {
        self.quantity().unit()
    }

    /// The kind with this name, names of earlier versions included.
    pub fn named(name: &str) -> Option<Self> {
        let now = Self::ALL.iter().copied().find(|kind| kind.name() == name);
        let former = || FORMER_NAMES.iter().find(|(former, _)| *former == name);
        now.or_else(|| former().map(|(_, kind)| *kind))
    }
}

#[cfg(feature = "openapi")]
impl utoipa::PartialSchema for CheckKind {
    fn schema() -> utoipa::openapi::RefOr<utoipa::openapi::Schema> {
        let names = utoipa::openapi::ObjectBuilder::new()
            .schema_type(utoipa::openapi::Type::String)
            .enum_values(Some(Self::ALL.iter().map(|kind| kind.name())));
        names.description(Some("Kind of a check, an identifier for programs.")).into()
    }
}

#[cfg(feature = "openapi")]
impl utoipa::ToSchema for CheckKind {}

impl serde::Serialize for CheckKind {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

impl<'de> serde::Deserialize<'de> for CheckKind {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = <std::borrow::Cow<'de, str>>::deserialize(deserializer)?;
        Self::named(&name)
            .ok_or_else(|| serde::de::Error::custom(format!("`{name}` is no kind of check")))
    }
}
