//! Events of the dynamics against time.

use std::path::Path;

use wholestring::{operation::Event, well::FrictionLevel};
use wholestring_results::{
    PlanGel, PlanHistory, PlanPeak, PlanPeakOf, PlanPeakSample, PlanSummary, ReadRow,
    plan_peaks_time_table,
};

use super::{Plan, plan, plan_html, plan_plots, rules, summary};
use crate::figure::Mark;

/// An event whose hook load and pump pressure have these peaks, N and Pa, and its samples.
fn event(
    event: Event,
    bit_depth_m: f64,
    hook_load_N: Option<f64>,
    pump_pressure_Pa: Option<f64>,
) -> (PlanPeak, PlanHistory) {
    let response = |peak: f64| PlanPeakOf {
        at_rest: 0.5 * peak,
        peak,
        time_s: 2.0,
        steady: 0.8 * peak,
        drift: 0.0,
        ratio: Some(1.25),
        overshoot: Some(2.0 / 3.0),
    };
    let gel = PlanGel { bore_Pa: 4e6, annulus_Pa: 2e6, lift_N: 2e4 };
    let peak = PlanPeak {
        event: event.name().into(),
        friction: FrictionLevel::Expected,
        bit_depth_m,
        hook_load_N: hook_load_N.map(response),
        surface_torque_N_m: None,
        pump_pressure_Pa: pump_pressure_Pa.map(response),
        gel: (event == Event::BreakCirculation).then_some(gel),
        message: None,
    };
    let time_s: Vec<f64> = (0..2000).map(|i| 0.01 * f64::from(i)).collect();
    let series = |peak: Option<f64>| {
        let peak = peak.unwrap_or(f64::NAN);
        let value = |time_s: &f64| if (time_s - 2.0).abs() < 0.005 { peak } else { 0.8 * peak };
        time_s.iter().map(value).collect::<Vec<f64>>()
    };
    let history = PlanHistory {
        hook_load_N: series(hook_load_N),
        surface_torque_N_m: series(None),
        pump_pressure_Pa: series(pump_pressure_Pa),
        block_velocity_m_per_s: series(None),
        rotary_speed_rad_per_s: series(None),
        flow_rate_m3_per_s: series(None),
        time_s,
    };
    (peak, history)
}

/// An event has a panel for each quantity that changes, with a curve and a ring for each depth, in
/// the colour of its depth; a single high sample keeps its height although the curve has fewer
/// points. The pressure that breaks the gel and a limit that is near are lines; the table gives the
/// reason for a missing answer.
#[test]
fn events_stand_against_time() {
    let (lost, no_samples) = event(Event::PickUpFromSlips, 500.0, None, None);
    let lost = PlanPeak { message: Some("it <diverged>".into()), ..lost };
    let events = [
        event(Event::PickUpFromSlips, 1000.0, Some(5e5), None),
        event(Event::PickUpFromSlips, 2000.0, Some(9e5), None),
        event(Event::BreakCirculation, 2000.0, Some(4e5), Some(5e6)),
        (lost, no_samples),
    ];
    let samples = plan_peaks_time_table(&events.each_ref().map(|(peak, history)| (peak, history)));
    let samples = PlanPeakSample::read(&samples, Path::new("samples")).expect("samples");
    let peaks = events.map(|(peak, _)| peak).into();
    let moved = Plan::new(PlanSummary { peaks, ..summary() }, Vec::new(), &samples, None);
    let plots = plan_plots(&moved, "si");
    let figure = &plots.last().expect("pictures").figure;
    let labels: Vec<&str> = figure.panels.iter().map(|panel| panel.axis.label.as_str()).collect();
    assert_eq!(
        labels,
        [
            "Pick-up from slips: hook load, kN",
            "Breaking circulation: hook load, kN",
            "Breaking circulation: pump pressure, MPa"
        ]
    );
    let [lifted, _, pumped] = &figure.panels[..] else { panic!("three panels") };
    let curves = lifted.marks.iter().filter_map(|mark| match mark {
        Mark::Curve { points, .. } => Some(points),
        _ => None,
    });
    let peaks = curves.map(|points| points.iter().map(|point| point.1).fold(0.0, f64::max));
    assert_eq!(peaks.collect::<Vec<_>>(), [500.0, 900.0]);
    // Hoist and pipe carry less.
    let borne = [(600.0, "hoist".to_owned()), (580.0, "pipe, tension".to_owned())];
    assert_eq!(rules(lifted), borne);
    assert_eq!(rules(pumped), [(6.0, "gel, 2000 m".to_owned())]);
    let page = plan_html(&moved);
    for text in [
        "Setting in motion",
        "to break the gel",
        "1.250",
        "66.7 %",
        "it &lt;diverged&gt;",
        "plan_peaks.csv",
    ] {
        assert!(page.contains(text), "{text}");
    }
    assert!(!plan_html(&plan()).contains("plan_peaks"));
}
