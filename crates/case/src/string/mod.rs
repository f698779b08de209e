//! Components of the string, from their keys.

pub(crate) mod assembly;
mod body;
pub(crate) mod component;
pub(crate) mod fit;
mod joints;
pub(crate) mod named_size;
pub(crate) mod steel;

use wholestring::string::{
    ComponentSpec, Material,
    catalogue::{CatalogueError, nominal_pipe},
};
use wholestring_config::prelude::*;
use wholestring_units::UnitSet;

use crate::{
    catalogue::OwnCatalogue,
    string::{component::ComponentTable, steel::check_moduli},
};

impl ComponentTable {
    pub(crate) fn build(
        &self,
        is_bit: bool,
        place: Span,
        steel: &Material,
        own: &OwnCatalogue,
        reader: &mut Reader,
    ) -> Option<ComponentSpec> {
        let material = self.material(steel, reader)?;
        let mut component = match self.catalogue.optional()? {
            Some(designation) => self.of_catalogue(designation, own, material, reader)?,
            None => self.of_diameters(is_bit, place, material, reader)?,
        };
        component.yield_strength_Pa = match self.yield_strength.optional()? {
            Some(item) => Some(item.value),
            None => component.yield_strength_Pa,
        };
        if let Some(item) = self.make_up_torque.optional()? {
            let yields_N_m = component.connection.torsional_yield_N_m;
            if yields_N_m.is_some_and(|yields_N_m| item.value > yields_N_m) {
                let yields = reader.at_most(Dimension::Torque, yields_N_m.unwrap_or_default());
                return Diagnostic::error("the connection yields before it is made up")
                    .at(item.place, format!("expected less than {yields}"))
                    .refuse(reader);
            }
            component.connection.make_up_torque_N_m = Some(item.value);
        }
        self.joints(&mut component, reader)?;
        self.blades(&mut component, reader)?;
        self.body(&mut component, reader)?;
        if let Some(item) = self.mass_per_length.optional()? {
            self.check_nominal(&component, item, own, reader);
            component.mass_per_length_kg_per_m = item.value;
            check_mass(&component, item.place, reader)?;
        }
        Some(component)
    }

    /// Warns of the nominal weight of drill pipe, which does not include tool joints.
    fn check_nominal(
        &self,
        component: &ComponentSpec,
        item: &Spanned<f64>,
        own: &OwnCatalogue,
        reader: &mut Reader,
    ) {
        let designation = self.catalogue.given();
        let entry = designation.and_then(|at| own.find(&at.value).ok());
        if designation.is_some() && entry.is_none() {
            return;
        }
        let (od_m, id_m) = (component.od_m, component.id_m);
        let Some(pipe) = nominal_pipe(entry.as_ref(), od_m, id_m, item.value) else { return };
        let unit = match reader.units() {
            UnitSet::Si => Dimension::MassPerLength.find_unit("lb/ft"),
            set => Some(Dimension::MassPerLength.unit_in(set)),
        };
        let Some(unit) = unit else { return };
        let shown = |mass: f64| format!("{:.1} {}", unit.from_si(mass), unit.symbol);
        let weight = pipe.mass_per_length_kg_per_m(component.material.density_kg_per_m3);
        let mut diagnostic = Diagnostic::warning(format!(
            "{} is the nominal weight of `{}`, without its tool joints",
            shown(item.value),
            pipe.designation
        ))
        .at(item.place, format!("with tool joints it weighs {}", shown(weight)));
        if let Some(designation) = designation {
            diagnostic = diagnostic.at(designation.place, "the catalogue's entry");
        }
        diagnostic
            .help(match designation {
                Some(_) => "leave `mass_per_length` out: the catalogue gives the weight",
                None => {
                    "give the weight with tool joints, or `catalogue` in place of the diameters"
                }
            })
            .report(reader);
    }

    fn material(&self, steel: &Material, reader: &mut Reader) -> Option<Material> {
        let density = self.density.optional()?;
        let youngs_modulus = self.youngs_modulus.optional()?;
        let shear_modulus = self.shear_modulus.optional()?;
        let material = Material {
            density_kg_per_m3: density.map_or(steel.density_kg_per_m3, |at| at.value),
            youngs_modulus_Pa: youngs_modulus.map_or(steel.youngs_modulus_Pa, |at| at.value),
            shear_modulus_Pa: shear_modulus.map_or(steel.shear_modulus_Pa, |at| at.value),
            ..*steel
        };
        if let Some(item) = shear_modulus.or(youngs_modulus) {
            check_moduli(&material, item.place, reader);
        }
        Some(material)
    }

    fn of_catalogue(
        &self,
        designation: &Spanned<String>,
        own: &OwnCatalogue,
        material: Material,
        reader: &mut Reader,
    ) -> Option<ComponentSpec> {
        for (field, name) in [(&self.od, "od"), (&self.id, "id")] {
            if let Some(item) = field.given() {
                return Diagnostic::error(format!("`{name}` is given together with `catalogue`"))
                    .at(item.place, "the catalogue gives it")
                    .at(designation.place, "the catalogue's entry")
                    .help("remove one of the two")
                    .refuse(reader);
            }
        }
        match own.find(&designation.value) {
            Ok(entry) => {
                Some(entry.component(self.component.get()?, *self.length.get()?, material))
            }
            Err(CatalogueError::Unknown { nearest, .. }) => {
                let mut diagnostic = Diagnostic::error(format!(
                    "the catalogue has no `{}`",
                    short(&designation.value)
                ))
                .at(designation.place, "unknown entry");
                if let Some(near) = own.nearest(&designation.value) {
                    diagnostic = diagnostic.help(format!("your own has \"{near}\""));
                }
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
        place: Span,
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
            return Diagnostic::error(format!("`{}` lacks `{name}`", short(called)))
                .at(place, format!("`{name}` is missing"))
                .help(match name {
                    "od" => "give od and id, or an entry of the catalogue",
                    _ => "a solid bar has id = 0",
                })
                .refuse(reader);
        }
        let (od, id_m) = (od?, id.map_or(0.0, |at| at.value));
        if id_m >= od.value {
            let id = id?;
            return Diagnostic::error(
                "the inside diameter is not smaller than the outside diameter",
            )
            .at(
                id.place,
                format!("expected less than {}", reader.shown(Dimension::Diameter, od.value)),
            )
            .at(od.place, "the outside diameter")
            .refuse(reader);
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

/// Warns of a pipe that is heavier than a solid bar of the diameter of its joints, or lighter than
/// its own body.
fn check_mass(component: &ComponentSpec, place: Span, reader: &mut Reader) -> Option<()> {
    let od_m = component.joints.map_or(component.od_m, |joints| joints.od_m);
    let solid = component.material.density_kg_per_m3 * std::f64::consts::FRAC_PI_4 * od_m.powi(2);
    if component.mass_per_length_kg_per_m <= solid * 1.001 {
        let body = component.material.density_kg_per_m3
            * std::f64::consts::FRAC_PI_4
            * (component.od_m.powi(2) - component.id_m.powi(2));
        if component.mass_per_length_kg_per_m < 0.95 * body {
            let mass = number_text(component.mass_per_length_kg_per_m);
            let pounds = Dimension::MassPerLength.parse(&format!("{mass} lb/ft"));
            let meant = pounds.is_ok_and(|meant| (0.95 * body..=solid).contains(&meant));
            let shown = |mass: f64| reader.shown(Dimension::MassPerLength, mass);
            let mut diagnostic = Diagnostic::warning(format!(
                "{} is less than the body alone weighs",
                shown(component.mass_per_length_kg_per_m)
            ))
            .at(place, format!("a body of {}", shown(body)))
            .help("if the metal is lighter than [steel], give its density too");
            if meant {
                diagnostic = diagnostic.help(format!("if lb/ft was meant, write \"{mass} lb/ft\""));
            }
            reader.report(diagnostic);
        }
        return Some(());
    }
    Diagnostic::error(format!(
        "{} is more than a solid bar of {} weighs",
        reader.shown(Dimension::MassPerLength, component.mass_per_length_kg_per_m),
        reader.shown(Dimension::Diameter, od_m)
    ))
    .at(place, format!("expected at most {}", reader.at_most(Dimension::MassPerLength, solid)))
    .refuse(reader)
}
