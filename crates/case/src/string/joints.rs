//! Tool joints of a component.

use wholestring::string::{ComponentSpec, ToolJoints};

use wholestring_units::Dimension;

use wholestring_config::{diagnostic::Diagnostic, reader::Reader, rule::Spanned};

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
