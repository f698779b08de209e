//! Broomsticks, and the mud against depth.

use wholestring::well::FrictionLevel;

use super::{names, plan, plan_html, plan_plots, plan_with, rules};
use crate::{figure::Mark, plan::levels::Level};

/// Each operation has a line for each friction, with the friction at its end, which is at the last
/// answer; lines that coincide have none. Limits are drawn where they are near, and written
/// otherwise.
#[test]
fn lines_end_with_their_friction() {
    let plots = plan_plots(&plan(), "si");
    let known: Vec<&str> = plots.iter().map(|plot| plot.name.as_str()).collect();
    assert_eq!(known, ["hook_load", "torque", "buckling_weight", "hydraulics"]);
    let [off, on] = &plots[0].figure.panels[..] else { panic!("two panels") };
    assert_eq!(off.axis.label, "Hook load, off bottom, kN");
    let found = names(off);
    assert_eq!(found.len(), 6, "{found:?}");
    assert_eq!(found[2], ((2000.0, 560.0), "0.3"));
    assert_eq!(found[5], ((1000.0, 120.0), "0.3"));
    let borne = [(600.0, "hoist".to_owned()), (580.0, "pipe, tension".to_owned())];
    assert_eq!(rules(off), borne);
    // Farther than 1.35 times 400 kN.
    assert!(rules(on).is_empty() && names(on).is_empty());
    let shoes = plots[0].figure.hole.iter().filter(|hole| hole.shoe);
    assert_eq!(shoes.map(|shoe| shoe.to).collect::<Vec<_>>(), [900.0]);
    // Every torque limit that is near is drawn; only the far one is written.
    let torque = &plots[1].figure;
    let drilling = torque.panels.last().expect("drilling");
    assert_eq!(rules(drilling), [(12.0, "top drive".to_owned()), (12.5, "make-up".to_owned())]);
    let limit = "limit beyond the picture: top drive, peak 1000 kN·m";
    assert!(torque.subtitle.contains(limit), "{}", torque.subtitle);
    assert!(!plots[0].figure.subtitle.contains("beyond"), "{}", plots[0].figure.subtitle);
    // In the reader's units.
    let field = plan_plots(&plan(), "field");
    assert_eq!(field[0].figure.panels[0].axis.label, "Hook load, off bottom, klbf");
}

/// A plan of one depth has marks where it would have lines.
#[test]
fn a_plan_of_one_depth_is_seen() {
    let whole = plan();
    let plan = plan_with(|summary| summary.points.retain(|point| point.bit_depth_m == 2000.0));
    let finite = plan.summary.points.iter().filter(|point| point.scalars.is_some()).count();
    let plots = plan_plots(&plan, "si");
    let is_seen = |mark: &&Mark| matches!(mark, Mark::Points { points, .. } if points.len() == 1);
    let panels = plots[0].figure.panels.iter();
    let seen = panels.flat_map(|panel| panel.marks.iter().filter(is_seen)).count();
    assert_eq!(seen, finite);
    assert!(finite > 3);
    // A point with neighbours needs no mark.
    let plots = plan_plots(&whole, "si");
    assert!(!plots[0].figure.panels[1].marks.iter().any(|mark| is_seen(&mark)));
}

/// Pressure and the densities at bit and shoe, five states each and the mud at rest; a limit that
/// is far beyond is written. Without a rheology there is no picture.
#[test]
fn the_mud_beside_it() {
    let plan = plan();
    let plots = plan_plots(&plan, "field");
    let figure = &plots[3].figure;
    let labels: Vec<&str> = figure.panels.iter().map(|panel| panel.axis.label.as_str()).collect();
    assert_eq!(
        labels,
        [
            "Standpipe pressure, drill, psi",
            "Equivalent density at the bit, ppg",
            "Equivalent density at the shoe, ppg"
        ]
    );
    assert_eq!(figure.panels[1].marks.len(), 6);
    assert!(figure.subtitle.contains("limit of the pump"), "{}", figure.subtitle);
    assert!(plan_html(&plan).contains("plan_hydraulics.parquet"));
    let plan = plan_with(|summary| summary.hydraulics.clear());
    assert_eq!(plan_plots(&plan, "field").len(), 3);
    assert!(!plan_html(&plan).contains("plan_hydraulics"));
}

/// Sections of equal friction share a coefficient; rotational friction is given where it differs.
#[test]
fn labels_of_levels() {
    let mut summary = plan().summary;
    let level = Level::new(&summary, FrictionLevel::High);
    assert_eq!(level.label, "0.3");
    assert_eq!(level.sections, ["casing 0.3", "open hole 0.3"]);
    for section in &mut summary.frictions {
        let casing = section.kind == "casing";
        (section.along, section.around) = if casing { (0.1334, 0.1334) } else { (0.25, 0.2) };
    }
    let level = Level::new(&summary, FrictionLevel::Expected);
    assert_eq!(level.label, "0.133 / 0.25");
    assert_eq!(level.sections, ["casing 0.133", "open hole 0.25, rotational 0.2"]);
}
