//! `[mud]`.

use wholestring::mud::{CYLINDER_DRAG_COEFFICIENT, Mud, Rheology};
use wholestring_config::prelude::*;

/// The rheologies, without their numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Flow {
    Newtonian,
    Bingham,
    PowerLaw,
}

const NEWTONIAN: &str = "newtonian";
const BINGHAM: &str = "bingham";
const POWER_LAW: &str = "power-law";

impl Flow {
    const WORDS: &'static [(&'static str, Self)] =
        &[(NEWTONIAN, Self::Newtonian), (BINGHAM, Self::Bingham), (POWER_LAW, Self::PowerLaw)];

    fn word(self) -> &'static str {
        word_of(Self::WORDS, &self)
    }
}

table! {
    /// Drilling fluid, the same inside the string and in the annulus.
    MudTable in "[mud]" {
        /// Density, kg/m3 unless a unit is given; 0 is air. Raising it makes the string lighter and
        /// its lateral inertia larger.
        density: f64 = required(Quantity::si(
            Dimension::Density,
            Range::from_to(0.0, 3000.0).usual(600.0, 2600.0),
            "1.2 sg",
        ));
        /// Linear lateral drag: force per length of pipe per lateral speed, Pa.s. Zero leaves it to
        /// the mass-proportional part of the Rayleigh damping. Raising it damps lateral vibration.
        /// Only the dynamic model uses it.
        linear_drag: f64 = default(
            Quantity::si(Dimension::Viscosity, Range::from_to(0.0, 1e4).usual(1e-3, 1e3), "5 Pa.s"),
            0.0,
        );
        /// Quadratic lateral drag coefficient of the pipe as a cylinder on its outside diameter. A
        /// smooth cylinder across a stream has 1 at Reynolds numbers from 1e3 to 1e5. Only the
        /// dynamic model uses it.
        drag_coefficient: f64 = default(
            Number { unit: "", range: Range::from_to(0.0, 100.0) },
            CYLINDER_DRAG_COEFFICIENT,
        );
        /// How the mud flows: "newtonian", "bingham" or "power-law". With it the mud drags along
        /// the string and about it as the string moves and the pumps run, lifts it with its stream
        /// and with the bit's jets, and loses pressure on its way. Without it the mud does none of
        /// that.
        rheology: Flow = optional(Choice { noun: "a rheology", words: Flow::WORDS });
        /// Viscosity of a Newtonian mud. Raising it raises torque, drag and pressure losses in
        /// proportion, as long as the flow is laminar.
        viscosity: f64 = optional(Quantity::si(
            Dimension::Viscosity,
            Range::from_to(1e-6, 1e3).usual(5e-4, 1.0),
            "20 cP",
        )).used_with(&[NEWTONIAN]);
        /// Plastic viscosity of a Bingham mud: what the shear stress gains per shear rate.
        plastic_viscosity: f64 = optional(Quantity::si(
            Dimension::Viscosity,
            Range::from_to(1e-6, 1e3).usual(5e-4, 1.0),
            "25 cP",
        )).used_with(&[BINGHAM]);
        /// Yield point of a Bingham mud: the stress below which it does not flow. Raising it raises
        /// torque, drag and losses at any speed.
        yield_point: f64 = optional(Quantity::si(
            Dimension::ShearStress,
            Range::from_to(0.0, 1000.0).usual(0.1, 60.0),
            "15 lbf/100ft2",
        )).used_with(&[BINGHAM]);
        /// Consistency index of a power-law mud: its shear stress at a shear rate of 1 1/s.
        consistency_index: f64 = optional(Quantity::si(
            Dimension::Consistency,
            Range::from_to(1e-6, 1e3).usual(1e-3, 50.0),
            "0.6 Pa.s^n",
        )).used_with(&[POWER_LAW]);
        /// Flow behaviour index of a power-law mud: 1 is Newtonian; the lower, the more it thins as
        /// it is sheared.
        flow_behaviour_index: f64 = optional(Number {
            unit: "",
            range: Range::from_to(0.1, 1.0),
        }).used_with(&[POWER_LAW]);
        /// Gel strength after the rest before circulation is broken, such as the one after ten minutes. A
        /// plan's "break_circulation" says what pump pressure breaks it; runs do not use it.
        gel_strength: f64 = optional(Quantity::si(
            Dimension::ShearStress,
            Range::from_to(0.0, 1000.0).usual(0.1, 100.0),
            "15 lbf/100ft2",
        ));
    }
}

impl MudTable {
    pub(crate) fn build(&self, reader: &mut Reader) -> Option<Mud> {
        let rheology = self.rheology(reader);
        Some(Mud {
            density_kg_per_m3: *self.density.get()?,
            linear_drag_Pa_s: *self.linear_drag.get()?,
            drag_coefficient: *self.drag_coefficient.get()?,
            rheology: rheology?,
        })
    }

    /// The gel strength, Pa, if it is given; `None` after a mistake.
    pub(crate) fn gel_strength_Pa(&self) -> Option<Option<f64>> {
        Some(self.gel_strength.optional()?.map(|at| at.value))
    }

    /// The rheology with its numbers; `None` after a mistake.
    fn rheology(&self, reader: &mut Reader) -> Option<Option<Rheology>> {
        let chosen = self.rheology.optional()?;
        for key in self.written() {
            // Density and drag belong to every mud.
            let [owner] = key.used_with[..] else { continue };
            let why = format!("used with rheology = \"{owner}\"");
            let diagnostic = Diagnostic::idle(key.name, key.place, why);
            match chosen {
                Some(flow) if key.is_used_with(flow.value.word()) => {}
                Some(flow) => reader.report(diagnostic.at(flow.place, "the rheology")),
                None => reader.report(diagnostic.help(format!("give rheology = \"{owner}\""))),
            }
        }
        let Some(flow) = chosen else {
            return Some(None);
        };
        let mut needed = |field: &Field<f64>, name: &str, example: &str| {
            needed_by(flow, field, name, example, reader)
        };
        Some(Some(match flow.value {
            Flow::Newtonian => Rheology::Newtonian {
                viscosity_Pa_s: needed(&self.viscosity, "viscosity", "\"20 cP\"")?,
            },
            Flow::Bingham => {
                let viscosity = needed(&self.plastic_viscosity, "plastic_viscosity", "\"25 cP\"");
                let yields = needed(&self.yield_point, "yield_point", "\"15 lbf/100ft2\"");
                Rheology::Bingham { plastic_viscosity_Pa_s: viscosity?, yield_point_Pa: yields? }
            }
            Flow::PowerLaw => {
                let consistency =
                    needed(&self.consistency_index, "consistency_index", "\"0.6 Pa.s^n\"");
                let index = needed(&self.flow_behaviour_index, "flow_behaviour_index", "0.65");
                Rheology::PowerLaw { consistency_Pa_s_n: consistency?, flow_index: index? }
            }
        }))
    }
}

/// A number that the rheology cannot do without; `None` after a mistake.
fn needed_by(
    flow: &Spanned<Flow>,
    field: &Field<f64>,
    name: &str,
    example: &str,
    reader: &mut Reader,
) -> Option<f64> {
    let value = field.optional()?;
    if value.is_none() {
        Diagnostic::error(format!("`{}` needs `{name}`", flow.value.word()))
            .at(flow.place, format!("`{name}` is missing in [mud]"))
            .help(format!("such as {name} = {example}"))
            .report(reader);
    }
    value.map(|at| at.value)
}
