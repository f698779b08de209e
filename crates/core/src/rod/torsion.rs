//! The string as a torsional waveguide.

use super::{mesh::Mesh, section::Section};

/// Characteristic torsional impedance `√(GJ · ρJ)`, N·m·s: torque over speed of a wave that runs
/// one way.
pub fn impedance_N_m_s(section: &Section) -> f64 {
    (section.torsional_stiffness_N_m2 * section.polar_inertia_kg_m).sqrt()
}

/// Lowest torsional frequency of a string that is held at the top and free at the bit, Hz.
///
/// Turn `θ` and torque `T` of a motion `e^{iωt}` go through each element exactly, from its lower end
/// to its upper one (primed), with the impedance `Z` (transfer matrices),
///
#[doc = include_str!("../../equations/torsional-transfer.html")]
///
/// and the lowest `ω` at which nothing turns at the top is found by steps and bisection.
pub fn lowest_frequency_Hz(mesh: &Mesh) -> f64 {
    let turn_at_top = |omega: f64| {
        let (mut turn, mut torque) = (1.0, 0.0);
        for element in mesh.elements.iter().rev() {
            let section = &element.section;
            let z = omega * impedance_N_m_s(section);
            let slowness = (section.polar_inertia_kg_m / section.torsional_stiffness_N_m2).sqrt();
            let (sin, cos) = libm::sincos(omega * slowness * element.length_m);
            (turn, torque) = (turn * cos - torque * sin / z, torque * cos + turn * z * sin);
        }
        turn
    };
    let travel_s: f64 = mesh
        .elements
        .iter()
        .map(|e| {
            let section = &e.section;
            e.length_m * (section.polar_inertia_kg_m / section.torsional_stiffness_N_m2).sqrt()
        })
        .sum();
    // A heavy lower end lowers the quarter wave's frequency, and steps so short miss no root.
    let step = 0.05 * std::f64::consts::FRAC_PI_2 / travel_s;
    let mut low = 0.0;
    while turn_at_top(low + step) > 0.0 {
        low += step;
    }
    let mut high = low + step;
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if turn_at_top(middle) > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high) / std::f64::consts::TAU
}
