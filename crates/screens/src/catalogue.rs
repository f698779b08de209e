//! What a case can name, and what rigs commonly have.

use serde::{Deserialize, Serialize};
use utoipa::{IntoParams, ToSchema};
use wholestring::{
    rig::catalogue as rigs,
    string::catalogue::{CatalogueEntry, TubularKind},
    well::casing::Casing,
};
use wholestring_case::STEEL_DENSITY_KG_PER_M3;
use wholestring_runner::Found;

/// What is looked for.
#[derive(Debug, Deserialize, IntoParams)]
#[serde(deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub struct Wanted {
    /// Words, sizes, weights, grades, classes or kinds; without any, everything.
    #[serde(default)]
    word: String,
}

/// What the catalogue has.
#[derive(Debug, Serialize, ToSchema)]
pub struct Catalogue {
    /// Tubulars of a string: `catalogue = "NAME"` under `[[string]]`.
    string: Vec<Tubular>,
    /// Those of a hole: `casing = "NAME"` under `[[well.hole]]`.
    casings: Vec<CasingEntry>,
    /// What turns a string, typically.
    top_drives: Vec<TopDrive>,
    /// What carries it, typically.
    hoists: Vec<Hoist>,
    /// Where all of it comes from.
    sources: Vec<String>,
}

/// A tubular of a string.
#[derive(Debug, Serialize, ToSchema)]
pub struct Tubular {
    /// What a case names it by.
    name: String,
    /// `drill_pipe`, `heavy_weight`, `collar` or `coiled_tubing`.
    kind: &'static str,
    od_m: f64,
    id_m: f64,
    /// Outside diameter of its tool joints.
    joint_od_m: Option<f64>,
    /// In air, tool joints included.
    mass_per_length_kg_per_m: f64,
    yield_strength_Pa: f64,
    /// The connections at its ends.
    connection: Option<String>,
}

/// A casing.
#[derive(Debug, Serialize, ToSchema)]
pub struct CasingEntry {
    /// What a case names it by.
    name: String,
    od_m: f64,
    id_m: f64,
    drift_m: f64,
    mass_per_length_kg_per_m: f64,
    /// Where a grade was asked for.
    yield_strength_Pa: Option<f64>,
}

/// From the least to the most that is common.
#[derive(Debug, Serialize, ToSchema)]
pub struct Span {
    least: f64,
    most: f64,
}

/// Top drives of a class.
#[derive(Debug, Serialize, ToSchema)]
pub struct TopDrive {
    name: String,
    capacity_N: f64,
    torque_N_m: Span,
    peak_torque_N_m: Span,
    highest_speed_rad_per_s: Span,
}

/// Hoists of a class.
#[derive(Debug, Serialize, ToSchema)]
pub struct Hoist {
    name: String,
    capacity_N: Span,
    snubbing_force_N: Option<Span>,
    block_weight_N: Option<Span>,
}

/// What `wholestring catalogue WORD` finds.
pub fn catalogue(wanted: &Wanted) -> Catalogue {
    let found = Found::described(&wanted.word, &[], &[]);
    let sources = found.sources();
    let string = found.string.iter().flat_map(|(_, entries)| entries);
    Catalogue {
        string: string.map(Tubular::from).collect(),
        casings: found.casings.iter().map(CasingEntry::from).collect(),
        top_drives: found.top_drives.into_iter().map(TopDrive::from).collect(),
        hoists: found.hoists.into_iter().map(Hoist::from).collect(),
        sources,
    }
}

impl From<&CatalogueEntry> for Tubular {
    fn from(of: &CatalogueEntry) -> Self {
        Self {
            name: of.designation.clone(),
            kind: match of.kind {
                TubularKind::DrillPipe => "drill_pipe",
                TubularKind::HeavyWeight => "heavy_weight",
                TubularKind::Collar => "collar",
                TubularKind::CoiledTubing => "coiled_tubing",
            },
            od_m: of.od_m,
            id_m: of.id_m,
            joint_od_m: of.joints.map(|joints| joints.od_m),
            mass_per_length_kg_per_m: of.mass_per_length_kg_per_m(STEEL_DENSITY_KG_PER_M3),
            yield_strength_Pa: of.yield_strength_Pa,
            connection: of.connection.as_ref().map(|of| of.name.to_string()),
        }
    }
}

impl From<&Casing> for CasingEntry {
    fn from(of: &Casing) -> Self {
        let name = match of.grade {
            Some(grade) => format!("{} {}", of.designation, grade.name),
            None => of.designation.clone(),
        };
        Self {
            name,
            od_m: of.od_m,
            id_m: of.id_m,
            drift_m: of.drift_m,
            mass_per_length_kg_per_m: of.mass_per_length_kg_per_m,
            yield_strength_Pa: of.grade.map(|grade| grade.yield_strength_Pa),
        }
    }
}

impl From<rigs::Span> for Span {
    fn from(of: rigs::Span) -> Self {
        Self { least: of.least, most: of.most }
    }
}

impl From<rigs::TopDriveClass> for TopDrive {
    fn from(of: rigs::TopDriveClass) -> Self {
        Self {
            name: of.designation,
            capacity_N: of.capacity_N,
            torque_N_m: of.torque_N_m.into(),
            peak_torque_N_m: of.peak_torque_N_m.into(),
            highest_speed_rad_per_s: of.highest_speed_rad_per_s.into(),
        }
    }
}

impl From<rigs::HoistClass> for Hoist {
    fn from(of: rigs::HoistClass) -> Self {
        Self {
            name: of.designation,
            capacity_N: of.capacity_N.into(),
            snubbing_force_N: of.snubbing_force_N.map(Span::from),
            block_weight_N: of.block_weight_N.map(Span::from),
        }
    }
}
