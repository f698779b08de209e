//! What a component has in its body: a bend, steel off the axis, a survey sensor.

use wholestring::string::{
    BodyBend, Cavity, ComponentLength, ComponentSpec, Eccentricity, MAX_ECCENTRIC,
};
use wholestring_units::number_text;

use wholestring_config::{diagnostic::Diagnostic, reader::Reader, rule::Spanned};

use crate::component::{ComponentTable, mm};

impl ComponentTable {
    /// Gives `component` its bend, its eccentricity and its sensor.
    pub(crate) fn body(&self, component: &mut ComponentSpec, reader: &mut Reader) -> Option<()> {
        component.bend = self.bend(component, reader)?;
        component.eccentricity = self.eccentricity(component, reader)?;
        component.survey_sensor_m = self.survey_sensor(component, reader)?;
        Some(())
    }

    fn survey_sensor(&self, component: &ComponentSpec, reader: &mut Reader) -> Option<Option<f64>> {
        let Some(at) = self.survey_sensor.optional()? else {
            return Some(None);
        };
        if let ComponentLength::Metres(length_m) = component.length
            && at.value > length_m
        {
            let length = self.length.at()?;
            return Diagnostic::error("the survey sensor is not on its component")
                .at(at.place, format!("expected {} m at most", number_text(length_m)))
                .at(length.place, "the component's length")
                .refuse(reader);
        }
        Some(Some(at.value))
    }

    fn bend(&self, component: &ComponentSpec, reader: &mut Reader) -> Option<Option<BodyBend>> {
        let (at, toolface) = (self.bend_at.optional()?, self.bend_toolface.optional()?);
        let Some(bend) = self.bend.optional()? else {
            alone(at, "bend_at", "bend", reader);
            alone(toolface, "bend_toolface", "bend", reader);
            return Some(None);
        };
        let from_lower_end_m = match (at, component.length) {
            (Some(at), ComponentLength::Metres(length_m)) if at.value > length_m => {
                let length = self.length.at()?;
                return Diagnostic::error("the bend is not on its component")
                    .at(at.place, format!("expected {} m at most", number_text(length_m)))
                    .at(length.place, "the component's length")
                    .refuse(reader);
            }
            (Some(at), _) => at.value,
            (None, ComponentLength::Metres(length_m)) => 0.5 * length_m,
            (None, ComponentLength::ToSurface) => {
                return Diagnostic::error("`bend` needs `bend_at`")
                    .at(bend.place, "`bend_at` is missing")
                    .help("the middle of a component that runs to the surface moves with the bit")
                    .refuse(reader);
            }
        };
        Some(Some(BodyBend {
            angle_rad: bend.value,
            from_lower_end_m,
            toolface_rad: toolface.map_or(0.0, |at| at.value),
        }))
    }

    fn eccentricity(
        &self,
        component: &ComponentSpec,
        reader: &mut Reader,
    ) -> Option<Option<Eccentricity>> {
        let phase = self.eccentricity_phase.optional()?;
        let cavity = self.eccentricity_cavity.optional()?;
        let Some(offset) = self.eccentricity.optional()? else {
            alone(phase, "eccentricity_phase", "eccentricity", reader);
            alone(cavity, "eccentricity_cavity", "eccentricity", reader);
            return Some(None);
        };
        let most = MAX_ECCENTRIC * component.od_m;
        if offset.value > most {
            let mut diagnostic = Diagnostic::error(format!(
                "the steel's centre of mass is {} off the axis",
                mm(offset.value)
            ))
            .at(offset.place, format!("expected {} at most, a tenth of od", mm(most)));
            if let Some(od) = self.od.given() {
                diagnostic = diagnostic.at(od.place, "the outside diameter");
            }
            return diagnostic.refuse(reader);
        }
        Some(Some(Eccentricity {
            offset_m: offset.value,
            phase_rad: phase.map_or(0.0, |at| at.value),
            cavity: cavity.map_or_else(Cavity::default, |at| at.value),
        }))
    }
}

/// A key that means nothing without another one.
fn alone<T>(given: Option<&Spanned<T>>, name: &str, partner: &str, reader: &mut Reader) {
    if let Some(given) = given {
        let why = format!("used with `{partner}`, which is not given");
        reader.report(Diagnostic::idle(name, given.place, why));
    }
}
