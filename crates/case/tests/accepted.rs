//! Cases that are accepted, and what is made of them.

mod common;

use common::{EXAMPLE, changed, read, read_with};
use wholestring::{
    dynamics::{ContactLaw, DynamicsSettings, HoistControl},
    operation::OperationKind,
    well::Interpolation,
};
use wholestring_case::ModelKind;

#[test]
fn the_documented_example_loads() {
    let case = read(EXAMPLE).unwrap_or_else(|report| panic!("{report}"));
    assert_eq!(case.name, "NP13-X1042 at total depth");
    assert_eq!(case.models, [ModelKind::Dynamic]);
    assert!(case.warnings.is_empty(), "{}", case.warnings);
    assert_eq!(case.model.well.path.stations().len(), 7);
    assert_eq!(case.model.well.path.interpolation(), Interpolation::Spline);
    assert_eq!(case.model.well.hole.sections().len(), 2);
    assert_eq!(case.model.well.hole.sections()[1].from_md_m, 2986.53);
    assert_eq!(case.model.mud.density_kg_per_m3, 1200.0);
    assert!((case.model.string.length_m() - 4305.0).abs() < 1e-9);
    let [bit, pipe] = case.model.string.components() else {
        panic!("two components")
    };
    assert_eq!((bit.id_m, bit.joints), (0.0, None));
    assert!((pipe.od_m - 0.1397).abs() < 1e-9 && pipe.joints.is_some());
    let [drill] = case.operations.as_slice() else {
        panic!("one operation")
    };
    assert_eq!(drill.kind, OperationKind::Drill);
    assert!((drill.rotary_speed_rad_per_s - 70.0 * std::f64::consts::PI / 30.0).abs() < 1e-12);
    assert!((drill.weight_on_bit_N - 6000.0 * 9.80665).abs() < 1e-6);
    assert!((drill.rate_of_penetration_m_per_s - 10.0 / 3600.0).abs() < 1e-12);
    assert_eq!(drill.bit_torque_N_m, 3100.0);
    assert_eq!(case.dynamics, DynamicsSettings::default());
    insta::assert_snapshot!(serde_json::to_string_pretty(&case.settings).expect("JSON"));
}
