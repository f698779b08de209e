//! `[mud]`.

use serde_json::json;
use wholestring::mud::{
    CYLINDER_DRAG_COEFFICIENT, DIAL_PA, DialFit, DialReading, Mud, Rheology, fit_dial_readings,
};
use wholestring_config::prelude::*;

/// Deviation of dial readings from their law above which a warning is given, as a part of the
/// largest reading.
const POOR_FIT: f64 = 0.05;

/// The rheologies, without their numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Flow {
    Newtonian,
    Bingham,
    PowerLaw,
    HerschelBulkley,
}

const NEWTONIAN: &str = "newtonian";
const BINGHAM: &str = "bingham";
const POWER_LAW: &str = "power-law";
const HERSCHEL_BULKLEY: &str = "herschel-bulkley";

impl Flow {
    const WORDS: &'static [(&'static str, Self)] = &[
        (NEWTONIAN, Self::Newtonian),
        (BINGHAM, Self::Bingham),
        (POWER_LAW, Self::PowerLaw),
        (HERSCHEL_BULKLEY, Self::HerschelBulkley),
    ];

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
        /// Linear lateral drag: force per length of pipe per lateral speed, Pa.s. With zero, only
        /// the mass-proportional part of the Rayleigh damping remains. Raising it damps lateral
        /// vibration. Only the dynamic model uses it.
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
        /// Flow law of the mud: "newtonian", "bingham", "power-law" or "herschel-bulkley" (the
        /// yield-power law). With it the mud drags on the moving string axially and in rotation,
        /// lifts it by its flow and by the bit's jets, and loses pressure along its path. Without
        /// it these effects are absent.
        rheology: Flow = optional(Choice { noun: "a rheology", words: Flow::WORDS });
        /// Viscosity of a Newtonian mud. Raising it raises torque, drag and pressure losses in
        /// proportion, as long as the flow is laminar.
        viscosity: f64 = optional(Quantity::si(
            Dimension::Viscosity,
            Range::from_to(1e-6, 1e3).usual(5e-4, 1.0),
            "20 cP",
        )).used_with(&[NEWTONIAN]);
        /// Plastic viscosity of a Bingham mud: increase of the shear stress per shear rate.
        plastic_viscosity: f64 = optional(Quantity::si(
            Dimension::Viscosity,
            Range::from_to(1e-6, 1e3).usual(5e-4, 1.0),
            "25 cP",
        )).used_with(&[BINGHAM]);
        /// Yield point of a Bingham or Herschel-Bulkley mud: the stress below which it does not
        /// flow. Raising it raises torque, drag and losses at any speed.
        yield_point: f64 = optional(Quantity::si(
            Dimension::ShearStress,
            Range::from_to(0.0, 1000.0).usual(0.1, 60.0),
            "15 lbf/100ft2",
        )).used_with(&[BINGHAM, HERSCHEL_BULKLEY]);
        /// Consistency index of a power-law or Herschel-Bulkley mud: its shear stress above the
        /// yield point at a shear rate of 1 1/s.
        consistency_index: f64 = optional(Quantity::si(
            Dimension::Consistency,
            Range::from_to(1e-6, 1e3).usual(1e-3, 50.0),
            "0.6 Pa.s^n",
        )).used_with(&[POWER_LAW, HERSCHEL_BULKLEY]);
        /// Flow behaviour index of a power-law or Herschel-Bulkley mud: at 1 it does not thin; the
        /// lower, the more it thins under shear.
        flow_behaviour_index: f64 = optional(Number {
            unit: "",
            range: Range::from_to(0.1, 1.0),
        }).used_with(&[POWER_LAW, HERSCHEL_BULKLEY]);
        /// Readings of a rotational rheometer in place of the three numbers of a Herschel-Bulkley
        /// mud: a list of [rev/min, degrees of the dial], such as [[600, 65], [300, 40], [200, 31],
        /// [100, 21], [6, 7], [3, 6]]. The law is fitted to them by least squares; `wholestring
        /// check` shows it next to the readings.
        dial_readings: Vec<Spanned<[f64; 2]>> = optional(List::of(DialRule, "dial readings", 30))
            .used_with(&[HERSCHEL_BULKLEY]);
        /// Gel strength after the rest before circulation is broken, such as the one after ten
        /// minutes. A plan's "break_circulation" gives the pump pressure that breaks it; runs do
        /// not use it.
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
        if let Some(density) = self.density.at().filter(|density| density.value == 0.0) {
            let shown = |density| reader.shown(Dimension::Density, density);
            let usual = format!("usual are {} to {}", shown(600.0), shown(2600.0));
            Diagnostic::warning("the mud has a density of 0, and no mud is without density")
                .at(density.place, usual)
                .help("the string then has its weight in a vacuum: is the density missing?")
                .report(reader);
        }
        Some(Mud {
            density_kg_per_m3: *self.density.get()?,
            linear_drag_Pa_s: *self.linear_drag.get()?,
            drag_coefficient: *self.drag_coefficient.get()?,
            rheology: rheology?,
        })
    }

    /// Returns the gel strength, Pa, if it is given; the outer `None` follows a mistake.
    pub(crate) fn gel_strength_Pa(&self) -> Option<Option<f64>> {
        Some(self.gel_strength.optional()?.map(|at| at.value))
    }

    /// Returns the rheology with its numbers; the outer `None` follows a mistake.
    fn rheology(&self, reader: &mut Reader) -> Option<Option<Rheology>> {
        let chosen = self.rheology.optional()?;
        for key in self.written() {
            // Density and drag apply to every mud.
            let Some(owner) = key.used_with.first() else { continue };
            let owners: Vec<String> =
                key.used_with.iter().map(|owner| format!("\"{owner}\"")).collect();
            let why = format!("used with rheology = {}", owners.join(" or "));
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
            Flow::HerschelBulkley if self.dial_readings.given().is_some() => {
                self.dial_fit(reader)?.rheology
            }
            Flow::HerschelBulkley => {
                let yields = needed(&self.yield_point, "yield_point", "\"5 Pa\", or dial_readings");
                let consistency =
                    needed(&self.consistency_index, "consistency_index", "\"0.6 Pa.s^n\"");
                let index = needed(&self.flow_behaviour_index, "flow_behaviour_index", "0.65");
                Rheology::HerschelBulkley {
                    yield_point_Pa: yields?,
                    consistency_Pa_s_n: consistency?,
                    flow_index: index?,
                }
            }
        }))
    }

    /// Returns the law through the dial readings; `None` after a mistake.
    fn dial_fit(&self, reader: &mut Reader) -> Option<DialFit> {
        let listed = self.dial_readings.optional()??;
        let numbers = [&self.yield_point, &self.consistency_index, &self.flow_behaviour_index];
        if let Some(number) = numbers.into_iter().find_map(|field| field.given()) {
            return Diagnostic::error("the rheology is given twice")
                .at(listed.place, "readings that it is fitted to")
                .at(number.place, "a number of the law")
                .help("keep one of the two")
                .refuse(reader);
        }
        let Some(fit) = fit_of(&listed.value) else {
            return Diagnostic::error("no yield-power law fits these dial readings")
                .at(
                    listed.place,
                    "expected readings at three speeds or more that grow with the speed",
                )
                .help(
                    "of two readings: rheology = \"bingham\", plastic_viscosity the difference of \
                       600 and 300 rev/min in cP, yield_point the rest at 300 in lbf/100ft2",
                )
                .refuse(reader);
        };
        let largest = listed.value.iter().map(|at| at.value[1] * DIAL_PA).fold(0.0, f64::max);
        if fit.largest_Pa > POOR_FIT * largest {
            Diagnostic::warning("the dial readings do not follow a yield-power law")
                .at(
                    listed.place,
                    format!(
                        "{} from the law at {} rev/min",
                        reader.shown(Dimension::ShearStress, fit.largest_Pa),
                        number_text(fit.largest_at_rpm)
                    ),
                )
                .help("is a reading wrong, or not in degrees of the dial?")
                .report(reader);
        }
        Some(fit)
    }

    /// The law that was fitted to dial readings, in a sentence; `None` without readings.
    pub(crate) fn note(&self, reader: &Reader) -> Option<String> {
        let chosen = self.rheology.given().map(|at| at.value);
        let listed =
            self.dial_readings.given().filter(|_| chosen == Some(Flow::HerschelBulkley))?;
        let fit = fit_of(&listed.value)?;
        let Rheology::HerschelBulkley { yield_point_Pa, consistency_Pa_s_n, flow_index } =
            fit.rheology
        else {
            return None;
        };
        Some(format!(
            "yield-power law through {} dial readings: yield point {}, consistency index {}, flow \
             behaviour index {}; residual {} (root mean square), {} at most, at {} rev/min",
            listed.value.len(),
            reader.shown(Dimension::ShearStress, yield_point_Pa),
            reader.shown(Dimension::Consistency, consistency_Pa_s_n),
            number_text((flow_index * 1e4).round() / 1e4),
            Dimension::ShearStress.format(fit.residual_Pa, reader.units()),
            Dimension::ShearStress.format(fit.largest_Pa, reader.units()),
            number_text(fit.largest_at_rpm),
        ))
    }
}

fn fit_of(listed: &[Spanned<[f64; 2]>]) -> Option<DialFit> {
    let reading = |at: &Spanned<[f64; 2]>| {
        let [speed_rpm, dial_deg] = at.value;
        DialReading { speed_rpm, dial_deg }
    };
    fit_dial_readings(&listed.iter().map(reading).collect::<Vec<_>>())
}

/// A reading of a rheometer: `[rev/min, degrees]`.
pub(crate) struct DialRule;

impl DialRule {
    const CELLS: [Number; 2] = [
        Number { unit: "rev/min", range: Range::from_to(0.1, 2000.0) },
        Number { unit: "deg", range: Range::from_to(0.0, 1000.0) },
    ];
}

impl Rule for DialRule {
    type Value = [f64; 2];

    fn read(&self, node: &Node, reader: &mut Reader) -> Option<[f64; 2]> {
        let items = match &node.value {
            Value::List(items) if items.len() == 2 => items,
            _ => {
                return Diagnostic::error("a dial reading is two numbers")
                    .at(node.place, "expected [rev/min, degrees], such as [600, 65]")
                    .refuse(reader);
            }
        };
        let mut values = [None; 2];
        for ((cell, item), value) in Self::CELLS.iter().zip(items).zip(&mut values) {
            *value = cell.read(item, reader);
        }
        let [Some(speed_rpm), Some(dial_deg)] = values else { return None };
        Some([speed_rpm, dial_deg])
    }

    fn schema(&self) -> serde_json::Value {
        let cells: Vec<_> = Self::CELLS.iter().map(Rule::schema).collect();
        json!({ "type": "array", "prefixItems": cells, "minItems": 2, "maxItems": 2 })
    }

    fn json(&self, value: &[f64; 2]) -> serde_json::Value {
        json!(value)
    }
}

/// Returns a number that the rheology requires; `None` after a mistake.
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
