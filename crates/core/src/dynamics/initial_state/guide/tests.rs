//! The parts of a prepared start that come from the soft string.

use super::*;
use crate::{
    common::{article_hole, operation, path_in_rad},
    dynamics::{
        assemble::basis::Basis,
        boundary::executor::SharedExecutor,
        kernel::step::StepInput,
        tests::bench::{Bench, PIPE_M},
    },
    operation::OperationKind,
    well::{Friction, Interpolation, Well},
};

const LENGTH_M: f64 = 300.0;

/// Plain pipe in a straight hole of 60 deg.
fn model(friction: f64) -> Model {
    let stations = [0.0, LENGTH_M].map(|md_m| [md_m, 60f64.to_radians(), 0.3]);
    Model {
        well: Well {
            path: path_in_rad(&stations, Interpolation::Spline),
            hole: article_hole(0.2159, Friction::uniform(friction), LENGTH_M + 10.0),
        },
        ..Bench::new(&[(PIPE_M, LENGTH_M)], 3.2, 0.0).model
    }
}

/// A pipe that turns clockwise is laid to the right of the low side, looking down the hole, by the
/// angle `atan μ` at which friction carries its weight: the angle to which a rigid cylinder climbs.
/// To rounding.
#[test]
fn a_turning_pipe_is_laid_where_it_climbs_to() {
    let operation = operation(OperationKind::RotateOffBottom, LENGTH_M)
        .rotary_speed_rad_per_s(7.0)
        .trip_speed_m_per_s(0.0);
    let settings = DynamicsSettings::default();
    for friction in [0.0, 0.25, 0.6] {
        let model = model(friction);
        let basis = Basis::<f64>::new(&model, &operation, &settings).expect("sound settings");
        let guide = Guide::new(&Scene {
            model: &model,
            operation: &operation,
            at_rest: false,
            settings: &settings,
            mesh: &basis.mesh,
            borehole: &basis.borehole,
            viscous: None,
            stepper: &basis.stepper,
            border: None,
            input: &StepInput {
                dt: basis.plan.dt_s,
                stiffness_damping: 0.0,
                dissipation: 0.0,
                stribeck_speed: 1.0,
            },
            velocity_m_per_s: 0.0,
            executor: &SharedExecutor::default(),
        })
        .expect("a soft string");
        let path = &model.well.path;
        for (i, node) in basis.mesh.nodes.iter().enumerate() {
            let md = LENGTH_M - node.from_bit_m;
            let high = path.high_side_at(md);
            let right = path.at(md).tangent.cross(&high);
            let climb = guide.lean[i].dot(&right).atan2(-guide.lean[i].dot(&high));
            assert!((climb - friction.atan()).abs() < 1e-9, "{climb} at {md} m");
        }
    }
}
