//! Parts of a component's body: a bend, steel off the axis, a survey sensor, and a lateral force.

use wholestring::string::{
    BodyBend, Cavity, ComponentLength, ComponentSpec, Eccentricity, LateralForce, MAX_ECCENTRIC,
};
use wholestring_units::Dimension;

use wholestring_config::{diagnostic::Diagnostic, reader::Reader, rule::Spanned, source::Span};

use crate::string::component::ComponentTable;

impl ComponentTable {
    /// Sets bend, eccentricity, sensor and lateral force of `component`.
    pub(crate) fn body(&self, component: &mut ComponentSpec, reader: &mut Reader) -> Option<()> {
        component.bend = self.bend(component, reader)?;
        component.eccentricity = self.eccentricity(component, reader)?;
        component.survey_sensor_m = self.survey_sensor(component, reader)?;
        component.lateral_force = self.lateral(component, reader)?;
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
                .at(
                    at.place,
                    format!("expected {} at most", reader.shown(Dimension::Length, length_m)),
                )
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
        let from_lower_end_m =
            self.place_of(["bend", "bend_at"], bend.place, at, component, reader)?;
        Some(Some(BodyBend {
            angle_rad: bend.value,
            from_lower_end_m,
            toolface_rad: toolface.map_or(0.0, |at| at.value),
        }))
    }

    fn lateral(
        &self,
        component: &ComponentSpec,
        reader: &mut Reader,
    ) -> Option<Option<LateralForce>> {
        let names = ["lateral_force", "lateral_force_at"];
        let at = self.lateral_force_at.optional()?;
        let toolface = self.lateral_force_toolface.optional()?;
        let Some(force) = self.lateral_force.optional()? else {
            alone(at, "lateral_force_at", "lateral_force", reader);
            alone(toolface, "lateral_force_toolface", "lateral_force", reader);
            return Some(None);
        };
        Some(Some(LateralForce {
            force_N: force.value,
            from_lower_end_m: self.place_of(names, force.place, at, component, reader)?,
            toolface_rad: toolface.map_or(0.0, |at| at.value),
        }))
    }

    /// Returns a position on the component, m from its lower end: the given one, or the middle.
    fn place_of(
        &self,
        [name, name_at]: [&str; 2],
        place: Span,
        at: Option<&Spanned<f64>>,
        component: &ComponentSpec,
        reader: &mut Reader,
    ) -> Option<f64> {
        match (at, component.length) {
            (Some(at), ComponentLength::Metres(length_m)) if at.value > length_m => {
                let length = self.length.at()?;
                Diagnostic::error(format!("`{name}` is not on its component"))
                    .at(
                        at.place,
                        format!("expected {} at most", reader.shown(Dimension::Length, length_m)),
                    )
                    .at(length.place, "the component's length")
                    .refuse(reader)
            }
            (Some(at), _) => Some(at.value),
            (None, ComponentLength::Metres(length_m)) => Some(0.5 * length_m),
            (None, ComponentLength::ToSurface) => {
                Diagnostic::error(format!("`{name}` needs `{name_at}`"))
                    .at(place, format!("`{name_at}` is missing"))
                    .help("the middle of a component that runs to the surface moves with the bit")
                    .refuse(reader)
            }
        }
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
                reader.shown(Dimension::Diameter, offset.value)
            ))
            .at(
                offset.place,
                format!(
                    "expected {} at most, a tenth of od",
                    reader.at_most(Dimension::Diameter, most)
                ),
            );
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

/// Refuses a key that has no meaning without another one.
fn alone<T>(entry: Option<&Spanned<T>>, name: &str, partner: &str, reader: &mut Reader) {
    if let Some(entry) = entry {
        let why = format!("used with `{partner}`, which is not given");
        reader.report(Diagnostic::idle(name, entry.place, why));
    }
}
