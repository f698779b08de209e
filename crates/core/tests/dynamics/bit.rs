//! The bit's laws under a whole string.

use wholestring::{
    dynamics::{BitLaw, BitSettings, DynamicOutcome, RegenerativeLaw},
    operation::{Operation, OperationKind},
    string::ComponentLength,
    well::{HoleKind, Interpolation},
};

use crate::{
    common::{operation, path, rpm},
    wells::{Case, model, section, tool},
};

const DEPTH_M: f64 = 1000.0;

/// The bit of Richard, Germay and Detournay's examples.
const LAW: RegenerativeLaw = RegenerativeLaw {
    radius_m: 0.107_95,
    blades: 4,
    intrinsic_specific_energy_Pa: 60e6,
    cutter_inclination: 0.6,
    wear_flat_m: 5e-3,
    contact_strength_Pa: 60e6,
    bit_geometry: 1.0,
    friction: 0.6,
};

/// Collars and pipe in a vertical well, drilling with a drag bit at a rotary speed.
fn vertical(revolutions_per_minute: f64) -> Case {
    let vertical = model(
        path(
            &[[0.0, 0.0, 0.0], [DEPTH_M + 20.0, 0.0, 0.0]],
            Interpolation::Spline,
        ),
        vec![section(HoleKind::Open, 0.0, DEPTH_M + 20.0, 0.2159, 0.2)],
        vec![
            tool("bit", ComponentLength::Metres(0.3), 0.2159, 0.0),
            tool("collars", ComponentLength::Metres(100.0), 0.1651, 0.0714),
            tool("pipe", ComponentLength::ToSurface, 0.127, 0.1086),
        ],
        DEPTH_M,
    );
    let bit = BitSettings {
        law: BitLaw::Regenerative(LAW),
        ..BitSettings::default()
    };
    let drill = Operation {
        rotary_speed_rad_per_s: rpm(revolutions_per_minute),
        weight_on_bit_N: 60e3,
        ..operation(OperationKind::Drill, DEPTH_M)
    };
    let mut case = Case::new(vertical, bit.drilling_steadily(drill));
    case.settings.bit = bit;
    case.settings.settle_s = 60.0;
    case.settings.duration_s = 30.0;
    case
}

fn statistic(outcome: &DynamicOutcome, name: &str) -> wholestring::dynamics::Statistic {
    let found = outcome.statistics.iter().find(|(n, _)| *n == name);
    found.expect("a statistic").1
}

#[test]
fn probe() {
    let t0 = std::time::Instant::now();
    for speed in [90.0, 95.0, 100.0, 105.0, 120.0, 140.0, 190.0, 200.0, 210.0] {
        let case = vertical(speed);
        let outcome = case.run();
        let spin = statistic(&outcome, "bit_rotary_speed_rad_per_s");
        let w = statistic(&outcome, "weight_on_bit_N");
        let t = statistic(&outcome, "bit_torque_N_m");
        println!(
            "{speed} spin {:.2} {:.2} [{:.2} {:.2}] wob {:.0} {:.0} [{:.0} {:.0}] T {:.0} {:.0} steady {:.0} rop {:.2} of {:.2} m/h residual {:.1e} dt {:.2e} {:?}",
            spin.mean,
            spin.std,
            spin.min,
            spin.max,
            w.mean,
            w.std,
            w.min,
            w.max,
            t.mean,
            t.std,
            case.operation.bit_torque_N_m,
            (outcome.series.bit_depth_m.last().unwrap() - outcome.series.bit_depth_m[6000]) / 30.0
                * 3600.0,
            case.operation.rate_of_penetration_m_per_s * 3600.0,
            outcome.numerics.energy_residual,
            outcome.numerics.time_step_s,
            t0.elapsed()
        );
    }
}
