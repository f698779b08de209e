//! The profile along the string: one type for every method, its columns declared once.

use super::{
    column::{columns, unlike_declared},
    method::{IN_ELEMENTS, IN_TIME, ModelKind},
};
use crate::sizing::SizeReason;

columns! {
    /// The profile along the string, from the surface to the bit: a row per node.
    ///
    /// All columns that the method provides have the same length, the others are empty; `md_m`
    /// grows strictly. Values of dynamics are means over the window unless stated otherwise, and
    /// tension and torque those of the two elements at the node.
    #[derive(Debug, Clone, PartialEq, Default)]
    pub struct Profile, "Columns of a profile along the string, in the order of `nodes.parquet`."
    PROFILE {
        md_m: Vec<f64> => Depth, "Measured depth of the node";
        tension_N: Vec<f64> => Force, "Effective tension; negative in compression",
            label "Effective tension";
        torque_N_m: Vec<f64> => Torque, "Torque that the string carries";
        side_force_N_per_m: Vec<f64> => ForcePerLength,
            "Side force of the wall on the string per length; positive where the string lies on \
             the high side";
        contact_fraction: Vec<f64> => Ratio, "Share of the time in contact with the wall";
        tension_std_N: Vec<f64> => Force, "Standard deviation of `tension_N`", known_by IN_TIME;
        torque_std_N_m: Vec<f64> => Torque,
            "Standard deviation of `torque_N_m`", known_by IN_TIME;
        contact_force_N: Vec<f64> => Force, "Contact force of the node itself",
            label "Contact force of the node", known_by IN_ELEMENTS;
        contact_force_std_N: Vec<f64> => Force,
            "Standard deviation of `contact_force_N`", known_by IN_TIME;
        contact_force_max_N: Vec<f64> => Force,
            "Largest contact force of any sample", known_by IN_TIME;
        climb_rad: Vec<Option<f64>> => Angle,
            "Angle of the mean contact force from the low side, from −π to π; positive to the \
             right looking down the hole, `null` where nothing touched",
            null_where "nothing touched";
        lateral_offset_m: Vec<f64> => Length,
            "Distance between the string's axis and the hole's; a soft string lies on the wall";
        axial_friction_N_per_m: Vec<f64> => ForcePerLength,
            "Axial friction of the wall per length; positive adds to hook load";
        friction_torque_N_m_per_m: Vec<f64> => TorquePerLength,
            "Torque of wall friction per length";
        wear_work_J_per_m: Vec<f64> => WorkPerLength,
            "Work of friction over the window per metre of string: force times sliding distance",
            known_by IN_TIME;
        wear_power_W_per_m: Vec<f64> => PowerPerLength,
            "Mean rate of the work of friction, for a soft string the rate: friction force times \
             sliding speed per metre of string";
        twist_rad: Vec<f64> => Angle, "Turn of the node against the bit; positive where it leads";
        stretch_m: Vec<f64> => Length, "Elongation of the string between the node and the bit";
        contact_class = contact_classes => Ratio,
            "`none`, `intermittent` or `continuous`: in contact for less than 1 %, up to 99 % or \
             more of the time";
        contact_side = contact_sides => Ratio,
            "`high` or `low`, by the sign of the mean side force; `none` where it is zero";
        side_force_per_joint_N: Vec<Option<f64>> => Force,
            "Side force on a tool joint, `side_force_N_per_m` over the spacing of the \
             joints; `null` where the string has none",
            null_where "the string has no joints";
        tension_p05_N: Vec<f64> => Force, "5th percentile of `tension_N`", known_by IN_TIME;
        tension_p50_N: Vec<f64> => Force, "Median of `tension_N`", known_by IN_TIME;
        tension_p95_N: Vec<f64> => Force, "95th percentile of `tension_N`", known_by IN_TIME;
        torque_p05_N_m: Vec<f64> => Torque, "5th percentile of `torque_N_m`", known_by IN_TIME;
        torque_p50_N_m: Vec<f64> => Torque, "Median of `torque_N_m`", known_by IN_TIME;
        torque_p95_N_m: Vec<f64> => Torque, "95th percentile of `torque_N_m`", known_by IN_TIME;
        side_force_p05_N_per_m: Vec<f64> => ForcePerLength,
            "5th percentile of `side_force_N_per_m`", known_by IN_TIME;
        side_force_p50_N_per_m: Vec<f64> => ForcePerLength,
            "Median of `side_force_N_per_m`", known_by IN_TIME;
        side_force_p95_N_per_m: Vec<f64> => ForcePerLength,
            "95th percentile of `side_force_N_per_m`", known_by IN_TIME;
        contact_force_p05_N: Vec<f64> => Force,
            "5th percentile of `contact_force_N`", known_by IN_TIME;
        contact_force_p50_N: Vec<f64> => Force, "Median of `contact_force_N`", known_by IN_TIME;
        contact_force_p95_N: Vec<f64> => Force,
            "95th percentile of `contact_force_N`", known_by IN_TIME;
        true_tension_N: Vec<f64> => Force,
            "Force in the metal, `T + p_i A_i − p_o A_o + ρ Q²/A_i`: effective tension plus \
             the terms of the mud's pressures and flow";
        outside_pressure_Pa: Vec<f64> => Pressure,
            "Pressure of the mud in the annulus, hydrostatic and from its flow";
        inside_pressure_Pa: Vec<f64> => Pressure, "Pressure of the mud in the bore";
        bending_moment_N_m: Vec<f64> => Torque,
            "Magnitude of the bending moment at the node; for a soft string, at tool joints";
        bending_moment_max_N_m: Vec<f64> => Torque,
            "Largest bending moment of any sample", known_by IN_TIME;
        bending_moment_p05_N_m: Vec<f64> => Torque,
            "5th percentile of `bending_moment_N_m`", known_by IN_TIME;
        bending_moment_p50_N_m: Vec<f64> => Torque,
            "Median of `bending_moment_N_m`", known_by IN_TIME;
        bending_moment_p95_N_m: Vec<f64> => Torque,
            "95th percentile of `bending_moment_N_m`", known_by IN_TIME;
        bending_moment_between_N_m: Vec<f64> => Torque,
            "Bending moment of the body half-way to the next node down; for a soft string, \
             half-way between tool joints", label "Bending moment between the nodes";
        bending_moment_between_max_N_m: Vec<f64> => Torque,
            "Largest `bending_moment_between_N_m` of any sample", known_by IN_TIME;
        sag_m: Vec<f64> => Length,
            "Sag of the body half-way to the next node down (for a soft string, half-way between \
             tool joints), measured from the arc through its ends";
        body_contact_fraction: Vec<f64> => Ratio,
            "Share of the time in which the body touches the wall half-way to the next node down; \
             for a soft string, half-way between tool joints";
        bending_stress_Pa: Vec<f64> => Stress,
            "Alternating bending stress at the surface of the rotating body, `M D/2I`, from the \
             larger of the moments at the node and half-way to the next";
        von_mises_stress_Pa: Vec<f64> => Stress,
            "Von Mises stress at the most stressed point of the body's surface";
        von_mises_stress_max_Pa: Vec<f64> => Stress,
            "Largest von Mises stress of any sample", label "Largest von Mises stress", known_by IN_TIME;
        yield_use: Vec<Option<f64>> => Ratio,
            "Largest von Mises stress, for a soft string `von_mises_stress_Pa`, over the minimum \
             yield strength; `null` where the yield strength is not known",
            null_where "the yield strength is not known";
        sinusoidal_load_N: Vec<Option<f64>> => Force,
            "Compression at which the straight pipe there buckles into a sinusoid: of several such \
             loads, the one that the compression in `tension_N` exceeds, or else the next above; \
             `null` where the pipe fills its hole",
            label "Sinusoidal buckling load", null_where "the pipe fills its hole";
        helical_load_N: Vec<Option<f64>> => Force,
            "The same for a helix; `null` where the pipe fills its hole",
            label "Helical buckling load", null_where "the pipe fills its hole";
        buckling = bucklings => Ratio,
            "`none`, `sinusoidal` or `helical`, by the compression in `tension_N` and those loads";
        whirl_rate_rad_per_s: Vec<f64> => RotarySpeed,
            "Mean angular velocity of the string's axis about the hole's; positive with the \
             rotation", known_by IN_TIME;
        whirl_coherence: Vec<f64> => Ratio,
            "Part of the lateral motion that is this whirl, from 0 to 1", known_by IN_TIME;
        lateral_speed_rms_m_per_s: Vec<f64> => Speed,
            "Root mean square of the lateral speed", known_by IN_TIME;
        element_length_m: Vec<f64> => Length,
            "Length of the element below the node; at the bit, of the one above", known_by IN_ELEMENTS;
        element_size = size_reasons => Ratio,
            "Reason for that length: `given`, or, where the mesh determines it, `joint to joint`, \
             `plain pipe`, `assembly`, `rotating bend`, `body contact` or `compression`", known_by IN_ELEMENTS;
    }
    beside {
        /// Reason for the length of each node's element.
        element_size: Vec<SizeReason>;
    }
}

/// Fraction of the time in which a node touches the wall.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ContactClass {
    /// In less than a hundredth of the samples.
    None,
    /// Now and then.
    Intermittent,
    /// In more than ninety-nine hundredths of the samples.
    Continuous,
}

impl ContactClass {
    /// The class of a part of the samples.
    pub fn of(contact_fraction: f64) -> Self {
        if contact_fraction < 0.01 {
            Self::None
        } else if contact_fraction <= 0.99 {
            Self::Intermittent
        } else {
            Self::Continuous
        }
    }

    /// Name in results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Intermittent => "intermittent",
            Self::Continuous => "continuous",
        }
    }
}

/// Buckling state of a pipe under compression.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Buckling {
    /// It is straight on the wall.
    None,
    /// Beyond the load of the sinusoid.
    Sinusoidal,
    /// Beyond the load of the helix.
    Helical,
}

impl Buckling {
    /// Under a compression, N, where these are the loads of the sinusoid and of the helix, N.
    pub fn of(compression_N: f64, [sinusoidal_N, helical_N]: [Option<f64>; 2]) -> Self {
        let beyond = |load_N: Option<f64>| load_N.is_some_and(|load_N| compression_N > load_N);
        match () {
            () if compression_N <= 0.0 => Self::None,
            () if beyond(helical_N) => Self::Helical,
            () if beyond(sinusoidal_N) => Self::Sinusoidal,
            () => Self::None,
        }
    }

    /// Name in results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Sinusoidal => "sinusoidal",
            Self::Helical => "helical",
        }
    }
}

fn bucklings(profile: &Profile) -> Vec<&'static str> {
    (0..profile.helical_load_N.len()).map(|row| profile.buckling(row).name()).collect()
}

fn contact_classes(profile: &Profile) -> Vec<&'static str> {
    let class = |fraction: &f64| ContactClass::of(*fraction).name();
    profile.contact_fraction.iter().map(class).collect()
}

fn size_reasons(profile: &Profile) -> Vec<&'static str> {
    profile.element_size.iter().map(|reason| reason.name()).collect()
}

fn contact_sides(profile: &Profile) -> Vec<&'static str> {
    let side = |force: &f64| match *force {
        force if force > 0.0 => "high",
        force if force < 0.0 => "low",
        _ => "none",
    };
    profile.side_force_N_per_m.iter().map(side).collect()
}

impl Profile {
    /// Buckling state of the pipe in a row.
    pub fn buckling(&self, row: usize) -> Buckling {
        let loads_N = [self.sinusoidal_load_N[row], self.helical_load_N[row]];
        Buckling::of(-self.tension_N[row], loads_N)
    }

    /// Adds a row's critical loads, N.
    pub(crate) fn push_buckling_loads(&mut self, loads_N: Option<[f64; 2]>) {
        self.sinusoidal_load_N.push(loads_N.map(|loads_N| loads_N[0]));
        self.helical_load_N.push(loads_N.map(|loads_N| loads_N[1]));
    }

    /// The columns that contradict their declaration for this method: missing though it provides
    /// them, present though it does not, or of another length than the others. Empty for a valid
    /// profile.
    pub fn unlike_declared(&self, model: ModelKind) -> Vec<&'static str> {
        unlike_declared(PROFILE, self, model)
    }
}
