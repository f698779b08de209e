//! Pressure losses of circulation, by the stiff string and by the soft one.

use wholestring::{
    mud::{Hydraulics, Rheology},
    prelude::*,
    random::Random,
    statics::soft,
    string::{ComponentLength, ComponentSpec},
};

use crate::{common, settings, solve};

/// Solid bits and collars of random lengths: the mesh has elements with two and three components,
/// and ends that miss those of components by a last digit. The pump's pressure is that of the soft
/// string, which goes from component to component, within 1e-3: the string's stretch shifts the
/// shoe against its annulus by millimetres. All results are plausible for a mud.
#[test]
fn pump_pressure_is_that_of_the_components() {
    let mut random = Random::new(4);
    for round in 0..60 {
        // The first is 0.9 ft long.
        let bit_m = if round == 0 { 0.9 * 0.3048 } else { 0.05 + 1.5 * random.unit() };
        let collar_m = 3.0 + 40.0 * random.unit();
        let part = |od_m: f64, id_m: f64, length: ComponentLength| {
            ComponentSpec::uniform("part", od_m, id_m, length, common::steel())
        };
        let components = vec![
            part(0.2159, 0.0, ComponentLength::Metres(bit_m)),
            part(0.1651, 0.0714, ComponentLength::Metres(collar_m)),
            part(0.127, 0.1086, ComponentLength::ToSurface),
        ];
        let path = common::arcs(&[[0.0, 20.0, 0.0], [150.0, 20.0, 0.0]]);
        let hole = common::open_hole(0.2159, 0.2, 150.0);
        let rheology = Rheology::Bingham { plastic_viscosity_Pa_s: 0.02, yield_point_Pa: 6.0 };
        let mud = common::viscous_mud(1200.0, rheology);
        let model = common::model(path, hole, components, mud, 150.0);
        let operation =
            common::operation(OperationKind::RotateOffBottom, 150.0).flow_rate_m3_per_s(0.03);
        let expected = soft::soft_string(&model, &operation).expect("an answer").hydraulics;
        let found = solve(&model, &operation, &settings(4.0)).hydraulics;
        let [expected, found] = [expected, found].map(|hydraulics| hydraulics.expect("a rheology"));
        assert_eq!(found.implausible(), None, "{bit_m} {collar_m}");
        let losses: [fn(&Hydraulics) -> f64; 3] =
            [|mud| mud.bore_loss_Pa, |mud| mud.annulus_loss_Pa, |mud| mud.pump_pressure_Pa];
        for loss in losses {
            let error = loss(&found) / loss(&expected) - 1.0;
            assert!(error.abs() < 1e-3, "{bit_m} {collar_m}: {found:?} for {expected:?}");
        }
    }
}
