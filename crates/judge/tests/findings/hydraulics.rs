//! Checks of the pressures that the mud makes.

use wholestring::{
    mud::Rheology, operation::OperationKind::*, prelude::*, random::Random, statics::soft,
    string::ComponentLength,
};
use wholestring_judge::{CheckKind, Judge, LimitSettings, Severity};
use wholestring_units::UnitSet;

use crate::{
    common::*,
    judged::{five_inch, none, only, soft_checks},
};

/// Strings of random lengths, in which lengths of bit and collar end within elements: no number of
/// their hydraulics is implausible, at rest or tripping.
#[test]
fn strings_of_random_lengths_have_plausible_pressures() {
    let mut random = Random::new(11);
    for round in 0..60 {
        let bit_m = if round == 0 { 0.9 * 0.3048 } else { 0.05 + 1.5 * random.unit() };
        let collar_m = 3.0 + 40.0 * random.unit();
        let part = |od_m: f64, id_m: f64, length: ComponentLength| {
            ComponentSpec::uniform("part", od_m, id_m, length, steel())
        };
        let components = vec![
            part(0.2159, 0.0, ComponentLength::Metres(bit_m)),
            part(0.1651, 0.0714, ComponentLength::Metres(collar_m)),
            part(0.127, 0.1086, ComponentLength::ToSurface),
        ];
        let path = arcs(&[[0.0, 20.0, 0.0], [150.0, 20.0, 0.0]]);
        let rheology = Rheology::Bingham { plastic_viscosity_Pa_s: 0.02, yield_point_Pa: 6.0 };
        let hole = open_hole(0.2159, 0.2, 150.0);
        let mud = viscous_mud(1200.0, rheology);
        let model = model(path, hole, components, mud, 150.0);
        for (kind, flow_m3_per_s) in [(RotateOffBottom, 0.03), (TripOut, 0.0), (TripIn, 0.02)] {
            let operation = operation(kind, 150.0).flow_rate_m3_per_s(flow_m3_per_s);
            none(&soft_checks(&model, &operation), CheckKind::ImplausibleHydraulics);
        }
    }
}

/// The pressure of a sliver of bore is an error, in the units of the user.
#[test]
fn an_implausible_pressure_is_an_error() {
    let mut model = five_inch(&[[0.0, 60.0, 0.0], [1000.0, 60.0, 0.0]], 0.2159, 0.3, 260.0);
    model.mud.rheology = Some(Rheology::Newtonian { viscosity_Pa_s: 0.02 });
    let turning = operation(RotateOffBottom, 1000.0).flow_rate_m3_per_s(0.03);
    let string = soft::SoftString::new(&model, 1000.0, &soft::SoftSettings::default());
    let mut loads = string.expect("a sound string").loads(&turning).expect("an answer");
    let judge = Judge::new(LimitSettings::default(), UnitSet::Field);
    let checks = |loads: &soft::SoftLoads| judge.soft_limits(&model, &turning, loads).checks;
    none(&checks(&loads), CheckKind::ImplausibleHydraulics);
    let mud = loads.hydraulics.as_mut().expect("a mud that flows");
    mud.bore_loss_Pa = 3.4e38;
    let check = only(&checks(&loads), CheckKind::ImplausibleHydraulics).expect("a check");
    assert_eq!(
        (check.severity, check.value, check.limit),
        (Severity::Error, Some(3.4e38), Some(1e9))
    );
    assert!(
        check.sentence.starts_with("Implausible pressure: the bore loss is 4.9313e34 psi, outside"),
        "{}",
        check.sentence
    );
    let mud = loads.hydraulics.as_mut().expect("a mud that flows");
    (mud.bore_loss_Pa, mud.mud_torque_N_m) = (1e6, f64::NAN);
    let check = only(&checks(&loads), CheckKind::ImplausibleHydraulics).expect("a check");
    assert!(
        check.value.is_none() && check.sentence.starts_with("Implausible torque: the mud torque")
    );
}

#[test]
fn pump_limit() {
    let mut model = five_inch(&[[0.0, 60.0, 0.0], [1000.0, 60.0, 0.0]], 0.2159, 0.3, 260.0);
    model.mud.rheology = Some(wholestring::mud::Rheology::Newtonian { viscosity_Pa_s: 0.02 });
    let mut turning = operation(RotateOffBottom, 1000.0);
    turning.flow_rate_m3_per_s = 0.03;
    let profile = soft::solve(&model, &turning, &soft::SoftSettings::default()).unwrap();
    let pressure_Pa = profile.hydraulics.expect("a mud that flows").pump_pressure_Pa;
    let mut level = |part: f64| {
        model.rig.pump_pressure_limit_Pa = Some(pressure_Pa / part);
        only(&soft_checks(&model, &turning), CheckKind::PumpPressure).map(|check| check.severity)
    };
    assert_eq!(
        [1.01, 0.95, 0.89].map(&mut level),
        [Some(Severity::Error), Some(Severity::Warning), None]
    );
}
