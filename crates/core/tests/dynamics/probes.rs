//! Signals of single nodes against time.

use wholestring::{
    dynamics::{NodeSignal, Probe, Simulation},
    operation::OperationKind,
};

use crate::{
    common::{operation, rpm},
    wells::{Case, go, straight},
};

const LENGTH_M: f64 = 300.0;

fn turning(probes: Vec<Probe>) -> Case {
    let turn = operation(OperationKind::RotateOffBottom, LENGTH_M);
    let mut case = Case::new(straight(LENGTH_M, 0.25), turn);
    case.operation.rotary_speed_rad_per_s = rpm(90.0);
    case.lasts(0.2, 0.3);
    case.settings.probes = probes;
    case
}

/// Every signal at the top, in the middle and at the bit is that of the frame of the same moment,
/// at the node there, to the bit; a run written to a checkpoint and resumed continues with them.
#[test]
fn probes_see_what_frames_see() {
    let depths_m = [0.0, 151.0, LENGTH_M];
    let probes = depths_m
        .iter()
        .flat_map(|&md_m| NodeSignal::ALL.iter().map(move |&signal| Probe { md_m, signal }));
    let case = turning(probes.collect());
    let mut simulation = case.start();
    let nodes = simulation.mesh().nodes.clone();
    let mut frames = Vec::new();
    for sample in 0..40 {
        let sample_s = simulation.sample_interval_s();
        go(&mut simulation, sample_s);
        frames.push(simulation.frame());
        if sample == 20 {
            simulation = Simulation::resume(
                &case.model,
                &case.operation,
                &case.settings,
                simulation.checkpoint(),
            )
            .expect("the same run");
        }
    }
    let series = simulation.outcome().series;
    assert_eq!(series.probes.len(), depths_m.len() * NodeSignal::ALL.len());
    for (probe, recorded) in case.settings.probes.iter().zip(&series.probes) {
        let off = |node: usize| (LENGTH_M - nodes[node].from_bit_m - probe.md_m).abs();
        let nearest = (0..nodes.len()).map(off).fold(f64::INFINITY, f64::min);
        assert_eq!(off(recorded.node), nearest, "{probe:?}");
        assert_eq!(recorded.signal, probe.signal);
        assert_eq!(recorded.samples.len(), frames.len());
        for (frame, value) in frames.iter().zip(&recorded.samples) {
            let of_frame = match probe.signal {
                NodeSignal::Tension => &frame.tension_N,
                NodeSignal::Torque => &frame.torque_N_m,
                NodeSignal::BendingMoment => &frame.bending_moment_N_m,
                NodeSignal::VonMisesStress => &frame.von_mises_stress_Pa,
                NodeSignal::ContactForce => &frame.contact_force_N,
                NodeSignal::OffsetHigh => &frame.offset_high_m,
                NodeSignal::OffsetRight => &frame.offset_right_m,
                NodeSignal::VelocityHigh => &frame.velocity_high_m_per_s,
                NodeSignal::VelocityRight => &frame.velocity_right_m_per_s,
                NodeSignal::AxialVelocity => &frame.axial_velocity_m_per_s,
                NodeSignal::RotarySpeed => &frame.rotary_speed_rad_per_s,
            };
            assert_eq!(*value, of_frame[recorded.node], "{probe:?}");
        }
    }
    let turns = series.probes.iter().find(|recorded| {
        recorded.signal == NodeSignal::RotarySpeed && recorded.node == nodes.len() - 1
    });
    let bit = &turns.expect("a probe at the bit").samples;
    assert_eq!(*bit, series.bit_rotary_speed_rad_per_s);
}
