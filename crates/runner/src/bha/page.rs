//! `report.html` and the pictures of a static BHA analysis, made from the files in its folder.

use std::path::Path;

use wholestring_report::{
    Bha, BhaContact, BhaPart, BhaSweep, BhaSweepPoint, Cell, Fact, PageHead, Plot, bha_html,
    bha_plots, in_sets,
};
use wholestring_results::{BhaSummary, BhaVaried, ResultsError, Table};
use wholestring_units::UnitSet;

use super::{nodes::NODES, page_tables::page_tables, tendency::tendency};
use crate::{
    column::numbers,
    page::{inputs, table},
    results_kind::Results,
};

/// The picture that is drawn by default.
const VIEWS: &str = "views";

impl Results for Bha {
    const NOUN: &'static str = "a static BHA analysis";
    const TABLE: &'static str = NODES;
    const PICTURES: &'static [&'static str] = &[VIEWS];

    fn gather(folder: &Path, units: Option<UnitSet>) -> Result<Self, ResultsError> {
        let summary = BhaSummary::read(&folder.join("summary.json"))?;
        let nodes = table(folder, NODES)?;
        let settings = &summary.settings;
        let title = format!("{}: static BHA analysis", summary.case);
        let state = &summary.state;
        let warnings = summary.warnings();
        let mut tables = page_tables(&summary);
        tables.extend(inputs::page_tables(settings));
        Ok(Self {
            head: PageHead::new(title, units, Some(settings), facts(&summary)),
            tendency: in_sets(|units| {
                let sentences = tendency(&summary, units).into_iter();
                sentences
                    .map(|sentence| sentence.replace(" deg", " °").replace(" -", " \u{2212}"))
                    .collect()
            }),
            message: (!warnings.is_empty()).then(|| warnings.join("; ")),
            parts: summary.parts.iter().map(part).collect(),
            length_m: state.length_m,
            from_bit_m: column(&nodes, "from_bit_m"),
            hole_radius_m: column(&nodes, "hole_radius_m"),
            offset_m: pair(&nodes, "offset_high_m", "offset_right_m"),
            moment_N_m: pair(&nodes, "bending_moment_high_N_m", "bending_moment_right_N_m"),
            bending_stress_Pa: column(&nodes, "bending_stress_Pa"),
            von_mises_stress_Pa: column(&nodes, "von_mises_stress_Pa"),
            contacts: state
                .contacts
                .iter()
                .map(|contact| BhaContact {
                    at_m: 0.5 * (contact.from_bit_m[0] + contact.from_bit_m[1]),
                    force_N: contact.force_N,
                })
                .collect(),
            sensors_m: state.sag.iter().map(|sag| sag.from_bit_m).collect(),
            sweeps: BhaVaried::ALL.iter().filter_map(|varied| sweep(&summary, *varied)).collect(),
            page_tables: tables,
        })
    }

    fn html(&self) -> Option<String> {
        Some(bha_html(self))
    }

    fn plots(&self) -> Vec<Plot> {
        bha_plots(self, &self.head.units)
    }
}

fn column(table: &Table, name: &str) -> Vec<f64> {
    let numbers = numbers(table, name).iter().map(|value| value.unwrap_or(f64::NAN));
    let mut column: Vec<f64> = numbers.collect();
    // Results without this column have no numbers for it.
    column.resize(table.rows(), f64::NAN);
    column
}

fn pair(table: &Table, high: &str, right: &str) -> [Vec<f64>; 2] {
    [column(table, high), column(table, right)]
}

fn part(part: &wholestring_results::BhaPart) -> BhaPart {
    BhaPart {
        name: part.name.clone(),
        from_bit_m: part.from_bit_m,
        to_bit_m: part.to_bit_m,
        od_m: part.od_m,
        blades_m: part.blades_m,
        is_jointed: part.joint_od_m.is_some(),
        bend_m: part.bend_m,
    }
}

/// Results of a variation; `None` if nothing was varied.
fn sweep(summary: &BhaSummary, varied: BhaVaried) -> Option<BhaSweep> {
    let (title, dimension, now, zeros) = match varied {
        BhaVaried::Toolface => ("Tool face", "angle", summary.toolface_rad, Vec::new()),
        BhaVaried::Weight => (
            "Weight on bit",
            "force",
            Some(summary.weight_on_bit_N),
            summary.holding_weights_N.clone(),
        ),
        BhaVaried::Inclination => (
            "Inclination of a straight hole",
            "angle",
            None,
            summary.holding_inclinations_rad.clone(),
        ),
    };
    let points = summary.sweep.iter().filter(|point| point.varied == varied);
    let points: Vec<BhaSweepPoint> = points
        .filter_map(|point| {
            let found = point.found?;
            Some(BhaSweepPoint {
                value: point.value(),
                side_force_N: found.side_force_N,
                tilt_rad: found.tilt_rad,
            })
        })
        .collect();
    let title = match summary.build_rate_rad_per_m {
        rate if varied == BhaVaried::Inclination && rate != 0.0 => {
            "Inclination at the bit of a hole that builds evenly"
        }
        _ => title,
    };
    (!points.is_empty()).then(|| BhaSweep {
        name: varied.name().into(),
        title: title.into(),
        dimension: dimension.into(),
        points,
        now,
        zeros,
    })
}

/// Key facts of the assembly.
fn facts(summary: &BhaSummary) -> Vec<Fact> {
    let fact = |label: &str, value: Cell| Fact { label: label.into(), value };
    let state = &summary.state;
    let [high_N, right_N] = state.side_force_N;
    let [up_rad, aside_rad] = state.tilt_rad;
    let mut facts = vec![
        fact("Operation", Cell::Text(summary.operation.words().to_owned())),
        fact("Bit depth", Cell::quantity(summary.bit_depth_m, "length")),
        fact("Inclination", Cell::quantity(summary.inclination_rad, "angle")),
        fact("Weight on bit", Cell::quantity(summary.weight_on_bit_N, "force")),
    ];
    if let Some(toolface_rad) = summary.toolface_rad {
        facts.push(fact("Tool face", Cell::quantity(toolface_rad, "angle")));
    }
    facts.extend([
        fact("Side force, high side positive", Cell::quantity(high_N, "force")),
        fact("Side force to the right", Cell::quantity(right_N, "force")),
        fact("Tilt of the bit, high side positive", Cell::quantity(up_rad, "angle")),
        fact("Tilt of the bit to the right", Cell::quantity(aside_rad, "angle")),
    ]);
    if let Some(sag) = state.sag.first() {
        let correction = Cell::quantity(sag.inclination_rad, "angle");
        facts.push(fact("Sag correction of the inclination", correction));
    }
    facts
}
