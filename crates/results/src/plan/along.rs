//! The string of a plan along the hole: the standard table.

use wholestring::{operation::OperationKind, outcome::Buckling};

use crate::row::rows;

rows! {
    /// The string at a measured depth, with the bit at the deepest depth and the expected friction.
    #[derive(Debug, Clone, PartialEq)]
    pub struct PlanStation {
        operation: OperationKind => Words, "The operation";
        md_m: f64 => Depth, "Measured depth";
        tvd_m: f64 => Depth, "True vertical depth";
        inclination_rad: f64 => Angle, "Inclination of the hole";
        dogleg_severity_rad_per_m: f64 => Curvature, "Dogleg severity of the hole";
        component: String => Words, "The component";
        tension_N: f64 => Force, "Effective tension; negative in compression";
        torque_N_m: f64 => Torque, "Torque that the string carries";
        side_force_N_per_m: f64 => ForcePerLength,
            "Side force of the wall on the string per length; positive where the string lies on \
             the high side";
        von_mises_stress_Pa: f64 => Stress,
            "Von Mises stress at the most stressed point of the body's surface";
        yield_use: Option<f64> => Ratio,
            "That stress over the minimum yield strength; `null` where it is not known",
            null_where "the yield strength is not known";
        buckling: Buckling => Words,
            "`none`, `sinusoidal` or `helical`, by the compression there";
    }

    /// Columns of `plan_along.parquet`: a row for each 30 m of the hole, 100 ft in field units, of
    /// each operation, by the soft string, with the bit at the deepest depth of the plan and the
    /// expected friction.
    pub const PLAN_ALONG, read;
}
