//! One tubular of the catalogue.

use std::{borrow::Cow, f64::consts::PI};

use super::PipeClass;
use crate::string::{
    ComponentLength, ComponentSpec, ConnectionStrength, Material, ToolJoints,
    component::ring_area_m2,
};

/// Kind of a catalogue entry.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TubularKind {
    /// Drill pipe with welded tool joints.
    DrillPipe,
    /// Heavy-weight drill pipe.
    HeavyWeight,
    /// Drill collar.
    Collar,
    /// Coiled tubing.
    CoiledTubing,
}

/// The connections of a catalogue entry.
#[derive(Debug, Clone, PartialEq)]
pub struct EntryConnection {
    /// Their name: `NC50`.
    pub name: Cow<'static, str>,
    /// Their strength.
    pub strength: ConnectionStrength,
}

/// The tool joints of a catalogue entry: everything that their mass needs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointDimensions {
    /// Outside diameter, m.
    pub od_m: f64,
    /// Inside diameter, m.
    pub id_m: f64,
    /// Length of the cylindrical parts (tong spaces) of pin and box together, m.
    pub length_m: f64,
    /// Outside diameter of the pipe's upset where the joint's tapers end, m; `None` where the
    /// length of the joint includes its tapers.
    pub upset_od_m: Option<f64>,
    /// Distance between joints along the string, m.
    pub spacing_m: f64,
    /// Outside diameter and length of the wear pad in the middle of a heavy-weight pipe, m.
    pub pad_m: Option<(f64, f64)>,
}

/// One tubular of the catalogue.
#[derive(Debug, Clone, PartialEq)]
pub struct CatalogueEntry {
    /// Name: `5-1/2 in 21.90 lb/ft S-135`, `HWDP 5 in 49.3 lb/ft`, `8 in x 2-13/16 in collar`.
    pub designation: String,
    /// Kind of the tubular.
    pub kind: TubularKind,
    /// Outside diameter of the body, m.
    pub od_m: f64,
    /// Inside diameter of the body, m.
    pub id_m: f64,
    /// Wear class.
    pub class: PipeClass,
    /// Tool joints; `None` for collars and coiled tubing.
    pub joints: Option<JointDimensions>,
    /// Connections at its ends; `None` where it has none, or may have many.
    pub connection: Option<EntryConnection>,
    /// Mass per length in air, kg/m, where a maker's is known; else it is computed.
    pub given_mass_kg_per_m: Option<f64>,
    /// Minimum yield strength of the body, Pa.
    pub yield_strength_Pa: f64,
    /// Source of the dimensions.
    pub source: Cow<'static, str>,
}

/// Volume of metal of a joint's two tapers, 18° on the box's elevator shoulder and 35° on the
/// pin's, and the length of pipe that they replace, m³ and m.
fn tapers(joint: &JointDimensions) -> (f64, f64) {
    let Some(upset_od_m) = joint.upset_od_m else {
        return (0.0, 0.0);
    };
    let step_m = (joint.od_m - upset_od_m).max(0.0);
    let length_m = step_m / 2.0
        * (1.0 / libm::tan(18.0_f64.to_radians()) + 1.0 / libm::tan(35.0_f64.to_radians()));
    let cone_m3 =
        PI / 12.0 * length_m * (joint.od_m.powi(2) + joint.od_m * upset_od_m + upset_od_m.powi(2));
    let bore_m3 = length_m * ring_area_m2(joint.id_m, 0.0);
    (cone_m3 - bore_m3, length_m)
}

impl CatalogueEntry {
    /// Mass per length in air, kg/m, tool joints included:
    ///
    /// `m = ρ [A_body (S - L_joint - L_taper) + A_joint L_joint + V_taper + (A_pad - A_body) L_pad] / S`
    ///
    /// with `S` the spacing of the joints and `L_taper`, `V_taper` those of an 18° and a 35° cone
    /// from the joint's diameter down to the upset's (the cones of API RP 7G's formula for the
    /// weight of a tool joint). The pipe's upsets are left out; they add 1 to 2 %. A mass that was
    /// given is the answer.
    pub fn mass_per_length_kg_per_m(&self, density_kg_per_m3: f64) -> f64 {
        if let Some(given) = self.given_mass_kg_per_m {
            return given;
        }
        let body_m2 = ring_area_m2(self.od_m, self.id_m);
        let Some(joint) = &self.joints else {
            return density_kg_per_m3 * body_m2;
        };
        let joint_m2 = ring_area_m2(joint.od_m, joint.id_m);
        let (taper_m3, taper_m) = tapers(joint);
        let pad_m3 =
            joint.pad_m.map_or(0.0, |(od_m, length_m)| ring_area_m2(od_m, self.od_m) * length_m);
        let volume_m3 = body_m2 * (joint.spacing_m - joint.length_m - taper_m)
            + joint_m2 * joint.length_m
            + taper_m3
            + pad_m3;
        density_kg_per_m3 * volume_m3 / joint.spacing_m
    }

    /// The same worn evenly from outside to the limit of its class, its joints as new.
    #[must_use]
    pub fn worn(&self, class: PipeClass) -> Self {
        let wall_m = class.wall_left() * (self.od_m - self.id_m) / 2.0;
        Self {
            designation: format!("{}{}", self.designation, class.suffix()),
            class,
            od_m: self.id_m + 2.0 * wall_m,
            ..self.clone()
        }
    }

    /// A component of this tubular, for a string of the given length and metal.
    pub fn component(
        &self,
        name: impl Into<String>,
        length: ComponentLength,
        material: Material,
    ) -> ComponentSpec {
        ComponentSpec {
            name: name.into(),
            length,
            od_m: self.od_m,
            id_m: self.id_m,
            mass_per_length_kg_per_m: self.mass_per_length_kg_per_m(material.density_kg_per_m3),
            blades: None,
            joints: self
                .joints
                .map(|joint| ToolJoints { od_m: joint.od_m, spacing_m: joint.spacing_m }),
            material,
            bend: None,
            eccentricity: None,
            survey_sensor_m: None,
            lateral_force: None,
            yield_strength_Pa: Some(self.yield_strength_Pa),
            class: self.class,
            connection: self
                .connection
                .as_ref()
                .map_or_else(Default::default, |connection| connection.strength),
        }
    }
}

// The units that the standards print in.

/// An inch, m.
pub(super) const INCH_M: f64 = 0.0254;
/// A pound per square inch, Pa.
pub(super) const PSI_PA: f64 = 6894.757293168361;

/// Pound per foot, kg/m.
pub(super) const POUND_PER_FOOT_KG_PER_M: f64 = 0.453_592_37 / 0.3048;
