//! Both directions of sliding at once.

use wholestring::{dynamics::FrictionLaw, operation::OperationKind};

use crate::{
    common::{assert_close, operation},
    wells::{Case, each, straight},
};

/// A plain pipe that reams slides along and around at every contact. By the article's law the sum
/// of its contact forces `Σ N` drags with all of `μ Σ N` along the hole and rubs with all of
/// `μ r Σ N` around it; by Coulomb's cone with the parts `V/s` and `Ω r/s` of it,
/// `s = √(V² + Ω²r²)`.
///
/// `Σ N` is the run's own; the laws are exact for every node at steady motion, under any contact
/// force. Within 0.1 %, because the remaining rolling of the pipe after twenty seconds changes the
/// sliding speed.
#[test]
fn reaming_slides_both_ways() {
    let (length, mu, radius) = (300.0, 0.25, 0.06985);
    let laws = [FrictionLaw::Independent, FrictionLaw::Vector];
    let found = each(&laws, |law| {
        let mut operation = operation(OperationKind::Ream, length);
        operation.trip_speed_m_per_s = 0.4;
        let mut case = Case::new(straight(length, mu), operation);
        case.settings.friction_law = *law;
        (operation, case.run().scalars)
    });
    for (law, (operation, found)) in laws.iter().zip(found) {
        let around = operation.rotary_speed_rad_per_s * radius;
        let sliding = around.hypot(operation.trip_speed_m_per_s);
        let parts = match law {
            FrictionLaw::Independent => [1.0, 1.0],
            FrictionLaw::Vector => [operation.trip_speed_m_per_s / sliding, around / sliding],
        };
        let limit = mu * found.side_force_total_N;
        let name = format!("{law:?}");
        assert_close(&name, -found.axial_friction_N, limit * parts[0], 1e-3);
        assert_close(&name, found.friction_torque_N_m, limit * radius * parts[1], 1e-3);
    }
}
