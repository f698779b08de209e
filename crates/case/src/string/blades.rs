//! Blades of a stabiliser or reamer.

use wholestring::string::{Blades, ComponentLength, ComponentSpec};

use wholestring_units::Dimension;

use wholestring_config::{diagnostic::Diagnostic, reader::Reader};

use crate::string::component::ComponentTable;

/// Length above which blades on a component without a length need a length of their own, m.
const LONGEST_BLADE_M: f64 = 20.0;

impl ComponentTable {
    /// Adds the blades, which must fit their component.
    pub(crate) fn blades(&self, component: &mut ComponentSpec, reader: &mut Reader) -> Option<()> {
        let od = self.blade_od.optional()?;
        let length = self.blade_length.optional()?;
        let Some(od) = od else {
            if let Some(length) = length {
                return Diagnostic::error("`blade_length` needs `blade_od`")
                    .at(length.place, "`blade_od` is missing")
                    .help("blades have a gauge; without it the body touches the wall")
                    .refuse(reader);
            }
            return Some(());
        };
        if component.joints.is_some() {
            let mut diagnostic = Diagnostic::error("blades are given together with tool joints")
                .at(od.place, "either of the two touches the wall");
            if let Some(joint) = self.joint_od.given().or(self.joint_spacing.given()) {
                diagnostic = diagnostic.at(joint.place, "the tool joints");
            } else if let Some(catalogue) = self.catalogue.given() {
                diagnostic = diagnostic.at(catalogue.place, "the catalogue gives tool joints");
            }
            reader.report(diagnostic.help("make the stabiliser a component of its own"));
            return None;
        }
        if od.value < component.od_m {
            let mut diagnostic = Diagnostic::error("the blades are thinner than their body").at(
                od.place,
                format!("expected {} or more", reader.shown(Dimension::Diameter, component.od_m)),
            );
            if let Some(body) = self.od.given() {
                diagnostic = diagnostic.at(body.place, "the body's outside diameter");
            }
            return diagnostic.refuse(reader);
        }
        let component_m = match component.length {
            ComponentLength::Metres(length_m) => length_m,
            ComponentLength::ToSurface => LONGEST_BLADE_M,
        };
        if let Some(length) = length
            && length.value > component_m
        {
            return Diagnostic::error("the blades are longer than their component")
                .at(
                    length.place,
                    format!("expected {} or less", reader.shown(Dimension::Length, component_m)),
                )
                .refuse(reader);
        }
        component.blades =
            Some(Blades { od_m: od.value, length_m: length.map_or(component_m, |at| at.value) });
        Some(())
    }
}
