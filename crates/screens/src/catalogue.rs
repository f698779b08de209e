//! Catalogue of tubulars, and common rig equipment.

use serde::{Deserialize, Serialize};
use utoipa::{IntoParams, ToSchema};
use wholestring::{
    rig::catalogue as rigs,
    string::catalogue::{CatalogueEntry, TubularKind},
    well::casing::Casing,
};
use wholestring_case::STEEL_DENSITY_KG_PER_M3;
use wholestring_runner::Found;

/// Search words.
#[derive(Debug, Deserialize, IntoParams)]
#[serde(deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub struct Wanted {
    /// Words, sizes, weights, grades, classes or kinds; all entries if empty.
    #[serde(default)]
    word: String,
}

/// Entries of the catalogue.
#[derive(Debug, Serialize, ToSchema)]
pub struct Catalogue {
    /// Tubulars of a string: `catalogue = "NAME"` under `[[string]]`.
    string: Vec<Tubular>,
    /// Those of a hole: `casing = "NAME"` under `[[well.hole]]`.
    casings: Vec<CasingEntry>,
    /// Typical top drives.
    top_drives: Vec<TopDrive>,
    /// Typical hoists.
    hoists: Vec<Hoist>,
    /// Sources of the entries.
    sources: Vec<String>,
}

/// A tubular of a string.
#[derive(Debug, Serialize, ToSchema)]
pub struct Tubular {
    /// Its name in a case.
    name: String,
    /// `drill_pipe`, `heavy_weight`, `collar` or `coiled_tubing`.
    kind: &'static str,
    od_m: f64,
    id_m: f64,
    /// Outside diameter of its tool joints.
    joint_od_m: Option<f64>,
    /// In air, including tool joints.
    mass_per_length_kg_per_m: f64,
    yield_strength_Pa: f64,
    /// The connections at its ends.
    connection: Option<String>,
}

/// A casing.
#[derive(Debug, Serialize, ToSchema)]
pub struct CasingEntry {
    /// Its name in a case.
    name: String,
    od_m: f64,
    id_m: f64,
    drift_m: f64,
    mass_per_length_kg_per_m: f64,
    /// Present if a grade was given.
    yield_strength_Pa: Option<f64>,
}

/// Range of common values.
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

/// Entries that `wholestring catalogue WORD` finds.
pub fn catalogue(query: &Wanted) -> Catalogue {
    let found = Found::described(&query.word, &[], &[]);
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
    fn from(entry: &CatalogueEntry) -> Self {
        Self {
            name: entry.designation.clone(),
            kind: match entry.kind {
                TubularKind::DrillPipe => "drill_pipe",
                TubularKind::HeavyWeight => "heavy_weight",
                TubularKind::Collar => "collar",
                TubularKind::CoiledTubing => "coiled_tubing",
            },
            od_m: entry.od_m,
            id_m: entry.id_m,
            joint_od_m: entry.joints.map(|joints| joints.od_m),
            mass_per_length_kg_per_m: entry.mass_per_length_kg_per_m(STEEL_DENSITY_KG_PER_M3),
            yield_strength_Pa: entry.yield_strength_Pa,
            connection: entry.connection.as_ref().map(|connection| connection.name.to_string()),
        }
    }
}

impl From<&Casing> for CasingEntry {
    fn from(casing: &Casing) -> Self {
        let name = match casing.grade {
            Some(grade) => format!("{} {}", casing.designation, grade.name),
            None => casing.designation.clone(),
        };
        Self {
            name,
            od_m: casing.od_m,
            id_m: casing.id_m,
            drift_m: casing.drift_m,
            mass_per_length_kg_per_m: casing.mass_per_length_kg_per_m,
            yield_strength_Pa: casing.grade.map(|grade| grade.yield_strength_Pa),
        }
    }
}

impl From<rigs::Span> for Span {
    fn from(span: rigs::Span) -> Self {
        Self { least: span.least, most: span.most }
    }
}

impl From<rigs::TopDriveClass> for TopDrive {
    fn from(class: rigs::TopDriveClass) -> Self {
        Self {
            name: class.designation,
            capacity_N: class.capacity_N,
            torque_N_m: class.torque_N_m.into(),
            peak_torque_N_m: class.peak_torque_N_m.into(),
            highest_speed_rad_per_s: class.highest_speed_rad_per_s.into(),
        }
    }
}

impl From<rigs::HoistClass> for Hoist {
    fn from(class: rigs::HoistClass) -> Self {
        Self {
            name: class.designation,
            capacity_N: class.capacity_N.into(),
            snubbing_force_N: class.snubbing_force_N.map(Span::from),
            block_weight_N: class.block_weight_N.map(Span::from),
        }
    }
}
