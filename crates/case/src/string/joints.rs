//! Tool joints of a component, and blades of a stabiliser or reamer.

use wholestring::string::{Blades, ComponentLength, ComponentSpec, ToolJoints};
use wholestring_config::{diagnostic::Diagnostic, reader::Reader, rule::Spanned};
use wholestring_units::Dimension;

use crate::string::component::ComponentTable;

impl ComponentTable {
    /// Sets joints given in the case, in part or wholly, in place of the catalogue's.
    pub(crate) fn joints(&self, component: &mut ComponentSpec, reader: &mut Reader) -> Option<()> {
        let od = self.joint_od.optional()?;
        let spacing = self.joint_spacing.optional()?;
        let known = component.joints;
        let joints = ToolJoints {
            od_m: match (od, known) {
                (Some(entry), _) => entry.value,
                (None, Some(known)) => known.od_m,
                (None, None) => {
                    return lacks_partner(spacing, "joint_spacing", "joint_od", reader);
                }
            },
            spacing_m: match (spacing, known) {
                (Some(entry), _) => entry.value,
                (None, Some(known)) => known.spacing_m,
                (None, None) => return lacks_partner(od, "joint_od", "joint_spacing", reader),
            },
        };
        if let Some(od) = od {
            if od.value < component.od_m {
                let mut diagnostic = Diagnostic::error("the tool joint is thinner than its pipe")
                    .at(
                        od.place,
                        format!(
                            "expected {} or more",
                            reader.shown(Dimension::Diameter, component.od_m)
                        ),
                    );
                if let Some(body) = self.od.given() {
                    diagnostic = diagnostic.at(body.place, "the pipe's outside diameter");
                }
                return diagnostic.refuse(reader);
            }
            if known.is_none() && self.mass_per_length.given().is_none() {
                Diagnostic::warning("mass and stiffness of the tool joints are not counted")
                    .at(od.place, "joints of unknown length")
                    .help(
                        "give mass_per_length, tool joints included; stiffness stays the \
                               body's",
                    )
                    .report(reader);
            }
        }
        component.joints = Some(joints);
        Some(())
    }
}

/// Whether one of the two keys for tool joints is missing. Having neither is valid.
fn lacks_partner(
    entry: Option<&Spanned<f64>>,
    name: &str,
    partner: &str,
    reader: &mut Reader,
) -> Option<()> {
    let Some(entry) = entry else { return Some(()) };
    Diagnostic::error(format!("`{name}` needs `{partner}`"))
        .at(entry.place, format!("`{partner}` is missing"))
        .help("tool joints have a diameter and a spacing; plain pipe has neither")
        .refuse(reader)
}

// Blades of a stabiliser or reamer.

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
