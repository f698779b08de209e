//! Hydraulics in a plan.

use wholestring::operation::{Operation, OperationKind};
use wholestring_case::Case;
use wholestring_plan::hydraulics::{EquivalentDensity, HydraulicsError, HydraulicsRow, hydraulics};
use wholestring_results::{PlanDensity, PlanHydraulics};

/// A row for each depth of the plan.
///
/// # Errors
/// The reason why there is none: no circulation, no flow rate, or a mud without a rheology.
pub(super) fn rows(case: &Case) -> Result<Vec<PlanHydraulics>, String> {
    let plan = &case.plan;
    let drills = plan.operations.iter().find(|operation| operation.kind == OperationKind::Drill);
    let circulates = || plan.operations.iter().find(|operation| operation.kind.circulates());
    let operation = drills.or_else(circulates).ok_or("no operation circulates, for hydraulics")?;
    if operation.flow_now_m3_per_s() == 0.0 {
        return Err("no flow_rate, for hydraulics".to_owned());
    }
    let found = hydraulics(&case.setup(), operation, &plan.bit_depths_m);
    let found = found.map_err(|error| match error {
        HydraulicsError::NoRheology => "no rheology of the mud, for hydraulics".to_owned(),
        HydraulicsError::Assembly(error) => error.to_string(),
    })?;
    Ok(found.iter().map(|hydraulics_row| row(operation, hydraulics_row)).collect())
}

fn row(operation: &Operation, row: &HydraulicsRow) -> PlanHydraulics {
    let density = |density: EquivalentDensity| PlanDensity {
        shoe_kg_per_m3: density.shoe_kg_per_m3,
        bit_kg_per_m3: density.bit_kg_per_m3,
    };
    let [[surge_closed, surge_open], [swab_closed, swab_open]] =
        [row.surge, row.swab].map(|ends| ends.map(density));
    PlanHydraulics {
        operation: operation.kind,
        bit_depth_m: row.bit_depth_m,
        standpipe_pressure_Pa: row.standpipe_Pa,
        bore_loss_Pa: row.bore_loss_Pa,
        bit_loss_Pa: row.bit_loss_Pa,
        annulus_loss_Pa: row.annulus_loss_Pa,
        circulating: density(row.circulating),
        surge_closed,
        surge_open,
        swab_closed,
        swab_open,
    }
}
