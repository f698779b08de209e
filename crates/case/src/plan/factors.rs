//! `[plan.factors]`: required factors of a plan's limits.

use wholestring_config::prelude::*;
use wholestring_judge::DesignFactors;

/// Declares a key for each kind of limit.
macro_rules! factors {
    ($($(#[doc = $about:literal])+ $name:ident;)+) => {
        table! {
            /// Least capacity over load of each limit of a plan.
            FactorsTable in "[plan.factors]" {
                $($(#[doc = $about])+ $name: f64 = default(factor(), DesignFactors::default().$name);)+
            }
        }

        /// The factors.
        pub(crate) fn build(table: &FactorsTable) -> Option<DesignFactors> {
            Some(DesignFactors { $($name: *table.$name.get()?,)+ })
        }
    };
}

fn factor() -> Number {
    Number { unit: "", range: Range::from_to(0.1, 100.0).usual(1.0, 3.0) }
}

factors! {
    /// Tensile yield over effective tension: 90 % of the yield by default.
    tension;
    /// Torsional yield over torque.
    torsion;
    /// Torsional yield under tension over torque.
    tension_and_torsion;
    /// Yield strength over von Mises stress.
    von_mises;
    /// Burst over the pressure inside beyond that outside.
    burst;
    /// Collapse over the pressure outside beyond that inside.
    collapse;
    /// Make-up torque of the connections over torque.
    make_up;
    /// `side_force_per_joint` over the side force on one joint.
    side_force;
    /// Capacity of the hoist over hook load and block.
    hoist;
    /// Rated torque of the top drive over surface torque.
    top_drive;
    /// Peak torque of the top drive over surface torque.
    top_drive_peak;
    /// Peak torque of the top drive over the torque that starts rotation.
    breakaway;
    /// Pressure limit of the pump over the pump pressure.
    pump_pressure;
    /// Load of the sinusoid over compression.
    sinusoidal_buckling;
    /// Load of the helix over compression.
    helical_buckling;
    /// Driving force over resistance of a string that moves down.
    lock_up;
    /// Available overpull over `overpull`.
    overpull;
}
