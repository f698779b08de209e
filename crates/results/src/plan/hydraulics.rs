//! The mud of a plan: pressures and equivalent densities against the depth of the bit.

use serde::{Deserialize, Serialize};
use wholestring::operation::OperationKind;

use crate::row::{parts, rows};

rows! {
    /// The mud with the bit at one depth.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    pub struct PlanHydraulics {
        operation: OperationKind => Words,
            "Operation whose pumps run: `drill` where there is one";
        bit_depth_m: f64 => Depth, "Measured depth of the bit";
        standpipe_pressure_Pa: f64 => Pressure,
            "Pressure at the standpipe: bore, bit, motor and annulus";
        bore_loss_Pa: f64 => Pressure, "Friction in the bore";
        bit_loss_Pa: f64 => Pressure, "Pressure drop of bit and motor";
        annulus_loss_Pa: f64 => Pressure, "Friction in the annulus";
        circulating: PlanDensity, "During the operation", columns {
            circulating_shoe_kg_per_m3 = |mud| mud.shoe_kg_per_m3 => Density,
                "Equivalent density at the deepest casing shoe during the operation; this and the \
                 others at the shoe are `null` without casing",
                null_where "there is no casing";
            circulating_bit_kg_per_m3 = |mud| mud.bit_kg_per_m3 => Density, "The same at the bit";
        };
        surge_closed: PlanDensity, "Running in at the trip speed, no mud in the string", columns {
            surge_closed_shoe_kg_per_m3 = |mud| mud.shoe_kg_per_m3 => Density,
                "At the shoe, running in at the trip speed, no mud in the string, or `null`",
                null_where "there is no casing";
            surge_closed_bit_kg_per_m3 = |mud| mud.bit_kg_per_m3 => Density, "The same at the bit";
        };
        surge_open: PlanDensity, "The same with mud that flows up the string", columns {
            surge_open_shoe_kg_per_m3 = |mud| mud.shoe_kg_per_m3 => Density,
                "At the shoe, running in, with mud that flows up the string, or `null`",
                null_where "there is no casing";
            surge_open_bit_kg_per_m3 = |mud| mud.bit_kg_per_m3 => Density, "The same at the bit";
        };
        swab_closed: PlanDensity, "Pulling out at the trip speed, no mud in the string", columns {
            swab_closed_shoe_kg_per_m3 = |mud| mud.shoe_kg_per_m3 => Density,
                "At the shoe, pulling out at the trip speed, no mud in the string, or `null`",
                null_where "there is no casing";
            swab_closed_bit_kg_per_m3 = |mud| mud.bit_kg_per_m3 => Density, "The same at the bit";
        };
        swab_open: PlanDensity, "The same with mud that flows down the string", columns {
            swab_open_shoe_kg_per_m3 = |mud| mud.shoe_kg_per_m3 => Density,
                "At the shoe, pulling out, with mud that flows down the string, or `null`",
                null_where "there is no casing";
            swab_open_bit_kg_per_m3 = |mud| mud.bit_kg_per_m3 => Density, "The same at the bit";
        };
    }

    /// Columns of `plan_hydraulics.parquet`: a row for each depth of the bit. Equivalent densities
    /// give the pressure of the mud plus or minus its friction.
    pub const PLAN_HYDRAULICS;
}

/// Equivalent densities.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PlanDensity {
    /// At the deepest casing shoe, kg/m³; none without casing.
    pub shoe_kg_per_m3: Option<f64>,
    /// At the bit, kg/m³.
    pub bit_kg_per_m3: f64,
}

parts![PlanDensity];

impl PlanHydraulics {
    /// Returns each state of the mud by the prefix of its column names.
    pub fn densities(&self) -> [(&'static str, PlanDensity); 5] {
        [
            ("circulating", self.circulating),
            ("surge_closed", self.surge_closed),
            ("surge_open", self.surge_open),
            ("swab_closed", self.swab_closed),
            ("swab_open", self.swab_open),
        ]
    }
}
