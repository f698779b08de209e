//! The scalars that vary over a run, and the scales on which their drifts are measured.

use crate::outcome::TimeSeries;

/// On what a drift of a scalar is measured.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Gauge {
    /// The largest force along the string: hook load, axial friction or weight on bit.
    Force,
    /// The largest torque.
    Torque,
    /// Its own magnitude, but at least so much, in its unit.
    Own(f64),
}

/// A scalar that varies.
pub struct Varying<'a> {
    pub name: &'static str,
    pub samples: &'a [f64],
    pub gauge: Gauge,
}

/// The scalars that vary, with their samples.
pub fn varying(series: &TimeSeries) -> [Varying<'_>; 11] {
    let of = |name, samples, gauge| Varying { name, samples, gauge };
    let s = series;
    [
        of("hook_load_N", &s.hook_load_N, Gauge::Force),
        of("surface_torque_N_m", &s.surface_torque_N_m, Gauge::Torque),
        of("friction_torque_N_m", &s.friction_torque_N_m, Gauge::Torque),
        of("axial_friction_N", &s.axial_friction_N, Gauge::Force),
        of("side_force_total_N", &s.side_force_total_N, Gauge::Own(1e4)),
        of("weight_on_bit_N", &s.weight_on_bit_N, Gauge::Force),
        of("bit_torque_N_m", &s.bit_torque_N_m, Gauge::Torque),
        of("rate_of_penetration_m_per_s", &s.rate_of_penetration_m_per_s, Gauge::Own(1.0 / 3600.0)),
        of("twist_rad", &s.twist_rad, Gauge::Own(1.0)),
        of("stretch_m", &s.stretch_m, Gauge::Own(0.1)),
        of("bit_rotary_speed_rad_per_s", &s.bit_rotary_speed_rad_per_s, Gauge::Own(1.0)),
    ]
}

/// The scales on which drifts are measured, of scalars with these means. Forces along the string go
/// by the largest of them and by 10 kN at least, torques by the largest and by 1 kN·m: half a
/// percent of less than that is nothing that a rig shows.
pub fn scales<const N: usize>(means: [(Gauge, f64); N]) -> [f64; N] {
    let largest = |of: Gauge, least: f64| {
        let alike = means.iter().filter(|(gauge, _)| *gauge == of);
        alike.fold(least, |most, (_, mean)| most.max(mean.abs()))
    };
    let (force_N, torque_N_m) = (largest(Gauge::Force, 1e4), largest(Gauge::Torque, 1e3));
    means.map(|(gauge, mean)| match gauge {
        Gauge::Force => force_N,
        Gauge::Torque => torque_N_m,
        Gauge::Own(least) => mean.abs().max(least),
    })
}
