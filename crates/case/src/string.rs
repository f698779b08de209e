//! `[[string]]`.

use wholestring::string::{Cavity, ComponentLength, ComponentSpec, Material, catalogue};
use wholestring_units::{Dimension, number_text};

use wholestring_config::{
    diagnostic::Diagnostic,
    names::{nearest, short},
    node::{Node, Value},
    quantity::Quantity,
    range::Range,
    reader::Reader,
    rule::{At, Rule, Text},
    source::Place,
    table::{optional, required, table},
};

use crate::{
    body,
    steel::{check_moduli, density, modulus},
};

/// What stands for the length of the component that fills the rest of the string.
const TO_SURFACE: &str = "to surface";

fn diameter(example: &'static str) -> Quantity {
    Quantity::si(
        Dimension::Diameter,
        Range::from_to(0.005, 2.0).usual(0.02, 1.2),
        example,
    )
}

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
                reader.report(
                    Diagnostic::error(format!("`{}` is not a length", short(text)))
                        .at(node.place, "expected a length or \"to surface\"")
                        .help("did you mean \"to surface\"?"),
                );
                return None;
            }
        }
        Self::quantity()
            .read(node, reader)
            .map(ComponentLength::Metres)
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

table! {
    /// A component of the string, from the bit up.
    ComponentTable in "[[string]]" {
        /// What it is called in messages and results: "bit", "motor", "drill pipe". A first component whose last word is "bit"
        /// and which fills its hole is held to the hole's axis in the dynamic model, all of it; of another one two diameters are.
        component: String = required(Text);
        /// Length, m unless a unit is given, or "to surface" for the topmost one, which then fills the
        /// rest of the string.
        length: ComponentLength = required(LengthRule);
        /// Entry of the catalogue of API drill pipe, heavy-weight and collars, such as
        /// "5-1/2 in 21.90 lb/ft S-135": gives diameters, joints, mass and yield strength.
        catalogue: String = optional(Text);
        /// Outside diameter of the body, m unless a unit is given. Needed without `catalogue`.
        od: f64 = optional(diameter("139.7 mm"));
        /// Inside diameter of the body, less than od. Needed without `catalogue`, except for the first of
        /// several components, the bit, which is solid by default.
        id: f64 = optional(Quantity::si(
            Dimension::Diameter,
            Range::from_to(0.0, 2.0).usual(0.005, 0.6),
            "118.6 mm",
        ));
        /// Outside diameter of the tool joints, which then are what touches the wall. Default: the
        /// catalogue's, or no joints.
        joint_od: f64 = optional(diameter("177.8 mm"));
        /// Distance between tool joints. Default: the catalogue's, or no joints.
        joint_spacing: f64 = optional(Quantity::si(
            Dimension::Length,
            Range::from_to(0.5, 100.0).usual(4.0, 16.0),
            "9.6 m",
        ));
        /// Diameter over the blades of a stabiliser or reamer, its gauge: blades then are what touches the
        /// wall, at both edges where they are longer than 0.5 m and than half an element, at their middle
        /// otherwise. Their mass is counted where `mass_per_length` counts it. Default: no blades; a
        /// component of 4 m or less that stands out over its neighbours touches at its middle with `od`.
        blade_od: f64 = optional(diameter("212.7 mm"));
        /// Length of the blades, at the middle of the component. Default: all of the component.
        blade_length: f64 = optional(Quantity::si(
            Dimension::Length,
            Range::from_to(0.01, 20.0).usual(0.05, 5.0),
            "0.6 m",
        ));
        /// Mass per length in air, tool joints included. Default: the catalogue's, or that of the body
        /// between od and id.
        mass_per_length: f64 = optional(Quantity::si(
            Dimension::MassPerLength,
            Range::positive_to(20_000.0).usual(3.0, 1500.0),
            "35.8 kg/m",
        ));
        /// Density of its metal. Default: that of [steel].
        density: f64 = optional(density());
        /// Young's modulus. Default: that of [steel].
        youngs_modulus: f64 = optional(modulus("210 GPa"));
        /// Shear modulus. Default: that of [steel].
        shear_modulus: f64 = optional(modulus("76.923 GPa"));
        /// Minimum yield strength, for strength limits. Default: the catalogue's, or unknown.
        yield_strength: f64 = optional(Quantity::si(
            Dimension::Pressure,
            Range::from_to(1e7, 1e10).usual(1.5e8, 1.5e9),
            "931 MPa",
        ));
        /// Bend fixed in its body, which turns with it: of a motor's bent housing, of a bent sub. The angle between the
        /// axes above and below, deg unless a unit is given. Dynamic model only. Default: none. Raising it presses bit and housing against
        /// opposite sides of the hole.
        bend: f64 = optional(body::bend_angle());
        /// Distance of the bend from the component's lower end; a node stands there. Default: its middle.
        bend_at: f64 = optional(Quantity::si(
            Dimension::Length,
            Range::from_to(0.0, 20_000.0),
            "1.9 m",
        ));
        /// Direction at the start to which the part below the bend is bent: the angle from the high side, clockwise as
        /// one looks down the hole, deg unless a unit is given. Default: 0, the high side.
        bend_toolface: f64 = optional(body::direction("90 deg"));
        /// Distance of its steel's centre of mass from the axis, at most a tenth of od: an imbalance that
        /// throws it outwards with the square of the rotary speed. Dynamic model only. Default: none.
        eccentricity: f64 = optional(Quantity::si(
            Dimension::Diameter,
            Range::from_to(0.0, 0.2).usual(5e-5, 0.02),
            "2 mm",
        ));
        /// Direction of that centre of mass at the start: the angle from the high side, clockwise as one looks down the
        /// hole, deg unless a unit is given. Default: 0, the high side.
        eccentricity_phase: f64 = optional(body::direction("90 deg"));
        /// What is in the place of the steel that it lacks on the other side: "mud" (a bore off the axis, a slot, a worn
        /// side), which makes up for part of it, or "sealed" (an empty pocket). Default: "mud".
        eccentricity_cavity: Cavity = optional(body::cavity());
    }
}

impl ComponentTable {
    /// Where its outside diameter comes from; `place` is that of the table.
    pub(crate) fn od_place(&self, place: Place) -> Place {
        let given = self.od.given().map(|at| at.place);
        let listed = self.catalogue.given().map(|at| at.place);
        given.or(listed).unwrap_or(place)
    }

    pub(crate) fn build(
        &self,
        is_bit: bool,
        place: Place,
        steel: &Material,
        reader: &mut Reader,
    ) -> Option<ComponentSpec> {
        let material = self.material(steel, reader)?;
        let mut component = match self.catalogue.optional()? {
            Some(designation) => self.of_catalogue(designation, material, reader)?,
            None => self.of_diameters(is_bit, place, material, reader)?,
        };
        component.yield_strength_Pa = match self.yield_strength.optional()? {
            Some(given) => Some(given.value),
            None => component.yield_strength_Pa,
        };
        self.joints(&mut component, reader)?;
        self.blades(&mut component, reader)?;
        self.body(&mut component, reader)?;
        if let Some(given) = self.mass_per_length.optional()? {
            component.mass_per_length_kg_per_m = given.value;
            check_mass(&component, given.place, reader)?;
        }
        Some(component)
    }

    fn material(&self, steel: &Material, reader: &mut Reader) -> Option<Material> {
        let density = self.density.optional()?;
        let youngs_modulus = self.youngs_modulus.optional()?;
        let shear_modulus = self.shear_modulus.optional()?;
        let material = Material {
            density_kg_per_m3: density.map_or(steel.density_kg_per_m3, |at| at.value),
            youngs_modulus_Pa: youngs_modulus.map_or(steel.youngs_modulus_Pa, |at| at.value),
            shear_modulus_Pa: shear_modulus.map_or(steel.shear_modulus_Pa, |at| at.value),
        };
        if let Some(given) = shear_modulus.or(youngs_modulus) {
            check_moduli(&material, given.place, reader);
        }
        Some(material)
    }

    fn of_catalogue(
        &self,
        designation: &At<String>,
        material: Material,
        reader: &mut Reader,
    ) -> Option<ComponentSpec> {
        for (field, name) in [(&self.od, "od"), (&self.id, "id")] {
            if let Some(given) = field.given() {
                reader.report(
                    Diagnostic::error(format!("`{name}` is given beside `catalogue`"))
                        .at(given.place, "the catalogue gives it")
                        .at(designation.place, "the catalogue's entry")
                        .help("leave one of the two out"),
                );
                return None;
            }
        }
        match catalogue::find(&designation.value) {
            Ok(entry) => {
                Some(entry.component(self.component.get()?, *self.length.get()?, material))
            }
            Err(catalogue::CatalogueError::Unknown { nearest, .. }) => {
                let mut diagnostic = Diagnostic::error(format!(
                    "the catalogue has no `{}`",
                    short(&designation.value)
                ))
                .at(designation.place, "unknown entry");
                if !nearest.is_empty() {
                    let nearest: Vec<String> =
                        nearest.iter().map(|name| format!("\"{name}\"")).collect();
                    diagnostic = diagnostic.help(format!("the nearest: {}", nearest.join(", ")));
                }
                reader.report(diagnostic.help("or give od and id instead of catalogue"));
                None
            }
        }
    }

    fn of_diameters(
        &self,
        is_bit: bool,
        place: Place,
        material: Material,
        reader: &mut Reader,
    ) -> Option<ComponentSpec> {
        let od = self.od.optional()?;
        let id = self.id.optional()?;
        let lacking = match (od, id) {
            (None, _) => Some("od"),
            (_, None) if !is_bit => Some("id"),
            _ => None,
        };
        if let Some(name) = lacking {
            let called = self.component.get().map_or("this component", |name| name);
            reader.report(
                Diagnostic::error(format!("`{}` lacks `{name}`", short(called)))
                    .at(place, format!("`{name}` is missing"))
                    .help(match name {
                        "od" => "give od and id, or an entry of the catalogue",
                        _ => "a solid bar has id = 0",
                    }),
            );
            return None;
        }
        let (od, id_m) = (od?, id.map_or(0.0, |at| at.value));
        if id_m >= od.value {
            let id = id?;
            reader.report(
                Diagnostic::error("the inside diameter is not smaller than the outside diameter")
                    .at(id.place, format!("expected less than {}", mm(od.value)))
                    .at(od.place, "the outside diameter"),
            );
            return None;
        }
        Some(ComponentSpec::uniform(
            self.component.get()?,
            od.value,
            id_m,
            *self.length.get()?,
            material,
        ))
    }
}

/// A pipe is not heavier than a solid bar as thick as its joints, nor lighter than its own body.
fn check_mass(component: &ComponentSpec, place: Place, reader: &mut Reader) -> Option<()> {
    let od_m = component
        .joints
        .map_or(component.od_m, |joints| joints.od_m);
    let solid = component.material.density_kg_per_m3 * std::f64::consts::FRAC_PI_4 * od_m.powi(2);
    if component.mass_per_length_kg_per_m <= solid * 1.001 {
        let body = component.material.density_kg_per_m3
            * std::f64::consts::FRAC_PI_4
            * (component.od_m.powi(2) - component.id_m.powi(2));
        if component.mass_per_length_kg_per_m < 0.95 * body {
            let mass = number_text(component.mass_per_length_kg_per_m);
            let pounds = Dimension::MassPerLength.parse(&format!("{mass} lb/ft"));
            let meant = pounds.is_ok_and(|meant| (0.95 * body..=solid).contains(&meant));
            let mut diagnostic = Diagnostic::warning(format!(
                "{} kg/m is less than the body alone weighs",
                number_text(component.mass_per_length_kg_per_m)
            ))
            .at(
                place,
                format!(
                    "a body of {} kg/m",
                    number_text((body * 10.0).round() / 10.0)
                ),
            )
            .help("if the metal is lighter than [steel], give its density too");
            if meant {
                diagnostic = diagnostic.help(format!("if lb/ft was meant, write \"{mass} lb/ft\""));
            }
            reader.report(diagnostic);
        }
        return Some(());
    }
    reader.report(
        Diagnostic::error(format!(
            "{} kg/m is more than a solid bar of {} weighs",
            number_text(component.mass_per_length_kg_per_m),
            mm(od_m)
        ))
        .at(
            place,
            format!("expected at most {} kg/m", number_text(solid.round())),
        ),
    );
    None
}

/// A diameter in messages.
pub(crate) fn mm(diameter_m: f64) -> String {
    format!("{} mm", number_text(diameter_m * 1e3))
}
