//! The keys of `[[string]]`.

use wholestring::string::{Cavity, ComponentLength};
use wholestring_config::prelude::*;

use crate::string::steel::{density, modulus};

/// The word for the length of the component that fills the rest of the string.
const TO_SURFACE: &str = "to surface";

/// A length, or "to surface".
pub(crate) struct LengthRule;

impl LengthRule {
    fn quantity() -> Quantity {
        Quantity::si(
            Dimension::Length,
            Range::from_to(0.01, 20_000.0).usual(0.05, 13_000.0),
            "9.6 m",
        )
    }
}

impl Rule for LengthRule {
    type Value = ComponentLength;

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<ComponentLength> {
        if let Value::Text { text, .. } = &node.value {
            if text == TO_SURFACE {
                return Some(ComponentLength::ToSurface);
            }
            if nearest(text, [TO_SURFACE]).is_some() || text.contains("surface") {
                return Diagnostic::error(format!("`{}` is not a length", short(text)))
                    .at(node.place, "expected a length or \"to surface\"")
                    .help("did you mean \"to surface\"?")
                    .refuse(reader);
            }
        }
        Self::quantity().read(node, reader).map(ComponentLength::Metres)
    }

    fn schema(&self) -> serde_json::Value {
        let mut schema = Self::quantity().schema();
        if let Some(either) = schema["anyOf"].as_array_mut() {
            either.push(serde_json::json!({
                "const": TO_SURFACE,
                "description": "Fills the rest of the string; for the topmost component."
            }));
        }
        schema
    }
}

const DEGREE: f64 = std::f64::consts::PI / 180.0;

fn bend_angle() -> Quantity {
    Quantity::si(
        Dimension::Angle,
        Range::from_to(0.0, 10.0 * DEGREE).usual(0.05 * DEGREE, 4.0 * DEGREE),
        "1.5 deg",
    )
    .bare("deg", DEGREE)
}

fn direction(example: &'static str) -> Quantity {
    Quantity::si(Dimension::Angle, Range::from_to(-360.0 * DEGREE, 360.0 * DEGREE), example)
        .bare("deg", DEGREE)
}

fn cavity() -> Choice<Cavity> {
    Choice {
        noun: "a filling of the missing steel's place",
        words: &[("mud", Cavity::Mud), ("sealed", Cavity::Sealed)],
    }
}

table! {
    /// A component of the string, from the bit up.
    ComponentTable in "[[string]]" {
        /// Name of the component in messages and results: "bit", "motor", "drill pipe". If the
        /// first component's last word is "bit" and it fills its hole, the dynamic model holds all
        /// of it to the hole's axis; of another first component it holds two diameters.
        component: String = required(Text);
        /// Length, m unless a unit is given, or "to surface" for the topmost one, which then fills
        /// the rest of the string.
        length: ComponentLength = required(LengthRule);
        /// Entry of the catalogue of API drill pipe, heavy-weight, collars and coiled tubing, such
        /// as "5-1/2 in 21.90 lb/ft S-135": gives diameters, joints, mass, yield strength and the
        /// capacity of the connections. The designation of worn drill pipe ends with its class,
        /// "premium" or "class 2". Or the name of a tubular of the case's own `catalogue`.
        catalogue: String = optional(Text);
        /// Outside diameter of the body, m unless a unit is given. Needed without `catalogue`.
        od: f64 = optional(diameter("139.7 mm"));
        /// Inside diameter of the body, less than od. Needed without `catalogue`, except for the
        /// first of several components, the bit, which is solid by default.
        id: f64 = optional(Quantity::si(
            Dimension::Diameter,
            Range::from_to(0.0, 2.0).usual(0.005, 0.6),
            "118.6 mm",
        ));
        /// Outside diameter of the tool joints, which then touch the wall. Default: the
        /// catalogue's, or no joints.
        joint_od: f64 = optional(diameter("177.8 mm"));
        /// Distance between tool joints. Default: the catalogue's, or no joints.
        joint_spacing: f64 = optional(joint_spacing());
        /// Diameter over the blades of a stabiliser or reamer, its gauge. The blades then touch the
        /// wall: at both edges where they are longer than 0.5 m and than half an element, at their
        /// middle otherwise. Their mass is counted where `mass_per_length` includes it. Default: no
        /// blades; a component of 4 m or less that is larger than its neighbours touches at its
        /// middle with `od`.
        blade_od: f64 = optional(diameter("212.7 mm"));
        /// Length of the blades, at the middle of the component. Default: all of the component.
        blade_length: f64 = optional(Quantity::si(
            Dimension::Length,
            Range::from_to(0.01, 20.0).usual(0.05, 5.0),
            "0.6 m",
        ));
        /// Mass per length in air, tool joints included. Default: the catalogue's, or that of the
        /// body between od and id.
        mass_per_length: f64 = optional(mass_per_length());
        /// Density of its metal. Default: that of [steel].
        density: f64 = optional(density());
        /// Young's modulus. Default: that of [steel].
        youngs_modulus: f64 = optional(modulus("210 GPa"));
        /// Shear modulus. Default: that of [steel].
        shear_modulus: f64 = optional(modulus("76.923 GPa"));
        /// Minimum yield strength, for strength limits. Default: the catalogue's, or unknown.
        yield_strength: f64 = optional(yield_strength());
        /// Torque to which its connections are made up, for limits: a string that turns with more
        /// torque makes them up further. Default: the catalogue's, or unknown.
        make_up_torque: f64 = optional(make_up_torque());
        /// Bend fixed in its body, which turns with it: of a motor's bent housing or a bent sub.
        /// The angle between the axes above and below, deg unless a unit is given. Stiff and
        /// dynamic models. Default: none. Raising it presses bit and housing against opposite sides
        /// of the hole.
        bend: f64 = optional(bend_angle());
        /// Distance of the bend from the component's lower end; the mesh has a node there. Default:
        /// its middle.
        bend_at: f64 = optional(Quantity::si(
            Dimension::Length,
            Range::from_to(0.0, 20_000.0),
            "1.9 m",
        ));
        /// Direction at the start to which the part below the bend is bent: the angle from the high
        /// side, clockwise looking down the hole, deg unless a unit is given. Default: 0, the high
        /// side.
        bend_toolface: f64 = optional(direction("90 deg"));
        /// Lateral force, fixed in space while the string turns: of a rotary steerable whose pads
        /// press the opposite wall with the same force. Stiff and dynamic models; the soft string
        /// ignores it, with a warning. Default: none. Raising it presses the bit to that side, or,
        /// from beyond a stabiliser, to the other.
        lateral_force: f64 = optional(Quantity::si(
            Dimension::Force,
            Range::from_to(0.0, 1e6).usual(100.0, 1e5),
            "15 kN",
        ));
        /// Distance of that force from the component's lower end; the mesh has a node there.
        /// Default: its middle.
        lateral_force_at: f64 = optional(Quantity::si(
            Dimension::Length,
            Range::from_to(0.0, 20_000.0),
            "0.8 m",
        ));
        /// Direction to which the tool is pushed: the angle from the high side at the bit,
        /// clockwise looking down the hole, deg unless a unit is given. Default: 0, the high side.
        lateral_force_toolface: f64 = optional(direction("90 deg"));
        /// Distance of its steel's centre of mass from the axis, at most a tenth of od: an
        /// imbalance whose centrifugal force grows with the square of the rotary speed. Dynamic
        /// model only. Default: none.
        eccentricity: f64 = optional(Quantity::si(
            Dimension::Diameter,
            Range::from_to(0.0, 0.2).usual(5e-5, 0.02),
            "2 mm",
        ));
        /// Direction of that centre of mass at the start: the angle from the high side, clockwise
        /// looking down the hole, deg unless a unit is given. Default: 0, the high side.
        eccentricity_phase: f64 = optional(direction("90 deg"));
        /// Filling of the space where steel is missing on the other side: "mud" (a bore off the
        /// axis, a slot, a worn side), which compensates part of it, or "sealed" (an empty pocket).
        /// Default: "mud".
        eccentricity_cavity: Cavity = optional(cavity());
        /// Distance of its survey sensor (the directional sensor of an MWD) from the component's
        /// lower end: `wholestring bha` gives the sag correction there. Default: no sensor.
        survey_sensor: f64 = optional(Quantity::si(
            Dimension::Length,
            Range::from_to(0.0, 20_000.0).usual(0.05, 40.0),
            "4.2 m",
        ));
    }
}

impl ComponentTable {
    /// Place of the key that gives its outside diameter; `place` is that of the table.
    pub(crate) fn od_place(&self, place: Span) -> Span {
        let own_place = self.od.given().map(|at| at.place);
        let listed = self.catalogue.given().map(|at| at.place);
        own_place.or(listed).unwrap_or(place)
    }
}

// The rules of keys that are common to `[[string]]` and the `[[tubular]]` of a catalogue.

pub(crate) fn diameter(example: &'static str) -> Quantity {
    Quantity::si(Dimension::Diameter, Range::from_to(0.005, 2.0).usual(0.02, 1.2), example)
}

pub(crate) fn joint_spacing() -> Quantity {
    Quantity::si(Dimension::Length, Range::from_to(0.5, 100.0).usual(4.0, 16.0), "9.6 m")
}

pub(crate) fn mass_per_length() -> Quantity {
    Quantity::si(
        Dimension::MassPerLength,
        Range::positive_to(20_000.0).usual(3.0, 1500.0),
        "35.8 kg/m",
    )
}

pub(crate) fn yield_strength() -> Quantity {
    Quantity::si(Dimension::Stress, Range::from_to(1e7, 1e10).usual(1.5e8, 1.5e9), "931 MPa")
}

pub(crate) fn make_up_torque() -> Quantity {
    Quantity::si(Dimension::Torque, Range::positive_to(1e6).usual(1e3, 2e5), "36.7 kN.m")
}
