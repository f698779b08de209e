//! `[plan.factors]`: what a plan's limits must keep.

use wholestring_config::prelude::*;
use wholestring_plan::limits::DesignFactors;

/// Declares a key for each kind of limit.
macro_rules! factors {
    ($($(#[doc = $about:literal])+ $name:ident;)+) => {
        table! {
            /// Safety factors: the least that capacity over load is to be.
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
    Number { unit: "", range: Range::from_to(0.1, 10.0).usual(0.9, 3.0) }
}

factors! {
    /// Effective tension against the tensile yield of pipe or connection.
    tension;
    /// Torque against the torsional yield of pipe or connection.
    torsion;
    /// Torque against the torsional yield under the tension that is there.
    tension_and_torsion;
    /// Von Mises stress against the yield strength.
    von_mises;
    /// Pressure from inside against burst.
    burst;
    /// Pressure from outside against collapse.
    collapse;
    /// Torque against the make-up torque of the connections.
    make_up;
    /// Hook load and block against the hoist.
    hoist;
    /// Surface torque against the rated torque of the top drive.
    top_drive;
    /// Surface torque against the largest torque of the top drive.
    top_drive_peak;
    /// Standpipe pressure against the limit of the pump.
    pump_pressure;
    /// Compression against the load of the sinusoid.
    sinusoidal_buckling;
    /// Compression against the load of the helix.
    helical_buckling;
    /// What drives a sliding string down against what holds it.
    lock_up;
    /// What is left for overpull against `overpull_margin`.
    overpull;
}
