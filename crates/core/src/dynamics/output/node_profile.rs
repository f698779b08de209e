//! The profile of the string over the window.

/// 5th, 50th and 95th percentile at every node, from samples spread evenly over the window.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Percentiles {
    /// 5th percentile.
    pub p05: Vec<f64>,
    /// Median.
    pub p50: Vec<f64>,
    /// 95th percentile.
    pub p95: Vec<f64>,
}

impl Percentiles {
    pub(in crate::dynamics) fn push(&mut self, [p05, p50, p95]: [f64; 3]) {
        self.p05.push(p05);
        self.p50.push(p50);
        self.p95.push(p95);
    }
}

/// The string's profile over the window, by measured depth from the surface down. All of the same
/// length, one row per node; tension and torque are means of the two elements at the node.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct NodeProfile {
    /// Measured depth at the middle of the window, m.
    pub md_m: Vec<f64>,
    /// Mean effective tension, N.
    pub tension_N: Vec<f64>,
    /// Standard deviation of tension, N.
    pub tension_std_N: Vec<f64>,
    /// Mean torque, N·m.
    pub torque_N_m: Vec<f64>,
    /// Standard deviation of torque, N·m.
    pub torque_std_N_m: Vec<f64>,
    /// Mean signed side force per metre, positive on the high side, N/m: the contact forces of the
    /// nodes around, over the length of string that they carry.
    pub side_force_N_per_m: Vec<f64>,
    /// Its percentiles, N/m: those of the contact force of the nodes around, over the same length.
    pub side_force_percentiles_N_per_m: Percentiles,
    /// Mean contact force of the node itself, N.
    pub contact_force_N: Vec<f64>,
    /// Standard deviation of the contact force, N.
    pub contact_force_std_N: Vec<f64>,
    /// Largest contact force of any sample, N.
    pub contact_force_max_N: Vec<f64>,
    /// Part of the samples in which the node touched the wall.
    pub contact_fraction: Vec<f64>,
    /// Angle of the node's mean contact force from the low side, rad, from −π to π, positive to the right
    /// looking down the hole; none where it never touched. A pipe that turns clockwise climbs to the
    /// right.
    pub climb_rad: Vec<Option<f64>>,
    /// Mean axial friction per metre, N/m; positive adds to hook load.
    pub axial_friction_N_per_m: Vec<f64>,
    /// Mean friction torque per metre, N.
    pub friction_torque_N_m_per_m: Vec<f64>,
    /// Mean distance of the pipe's axis from the hole's, m.
    pub lateral_offset_m: Vec<f64>,
    /// Work of friction over the window per metre of string, J/m.
    pub wear_work_J_per_m: Vec<f64>,
    /// Its mean rate, W/m.
    pub wear_power_W_per_m: Vec<f64>,
    /// Mean turn of the node against the bit, rad, positive where it leads; at the top the scalar's.
    pub twist_rad: Vec<f64>,
    /// Mean elongation of the string between the node and the bit, m, against the unloaded string; at the top the
    /// scalar's.
    pub stretch_m: Vec<f64>,
    /// Percentiles of tension, N.
    pub tension_percentiles_N: Percentiles,
    /// Percentiles of torque, N·m.
    pub torque_percentiles_N_m: Percentiles,
    /// Percentiles of the contact force of the node itself, N.
    pub contact_force_percentiles_N: Percentiles,
    /// Mean pressure of the mud outside, Pa: its weight and what its flow adds.
    pub outside_pressure_Pa: Vec<f64>,
    /// Mean pressure of the mud inside, Pa.
    pub inside_pressure_Pa: Vec<f64>,
    /// Mean force in the metal, N: effective tension, what the mud's pressures pull and press the metal with, and the
    /// momentum of its stream in the bore, `T + p_i A_i − p_o A_o + ρ Q²/A_i`.
    pub true_tension_N: Vec<f64>,
    /// Mean bending moment, N·m, whatever its direction.
    pub bending_moment_N_m: Vec<f64>,
    /// Largest bending moment of any sample, N·m.
    pub bending_moment_max_N_m: Vec<f64>,
    /// Percentiles of the bending moment, N·m.
    pub bending_moment_percentiles_N_m: Percentiles,
    /// Stress that alternates at the surface of the body as it turns, Pa: the mean bending moment over
    /// the section modulus, `M D/2I`.
    pub bending_stress_Pa: Vec<f64>,
    /// Mean von Mises stress where the body's surface bears most, Pa.
    pub von_mises_stress_Pa: Vec<f64>,
    /// Largest von Mises stress of any sample, Pa.
    pub von_mises_stress_max_Pa: Vec<f64>,
    /// That stress over the minimum yield strength, where it is known.
    pub yield_use: Vec<Option<f64>>,
    /// Force that a tool joint carries, N: the side force per metre over the spacing of the joints;
    /// positive on the high side, none where the string has no joints.
    pub side_force_per_joint_N: Vec<Option<f64>>,
    /// Mean angular velocity of the pipe's axis about the hole's, rad/s; clockwise looking down the
    /// hole, as the string turns, is positive.
    pub whirl_rate_rad_per_s: Vec<f64>,
    /// How much of the lateral motion that is, from zero to one.
    pub whirl_coherence: Vec<f64>,
    /// Root mean square of the lateral speed, m/s.
    pub lateral_speed_rms_m_per_s: Vec<f64>,
}
