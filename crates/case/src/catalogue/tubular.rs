//! `[[tubular]]` of a user's own catalogue.

use wholestring::string::{
    ConnectionStrength,
    catalogue::{
        CatalogueEntry, EntryConnection, JointDimensions, PipeClass, TubularKind, tool_joint,
    },
};
use wholestring_config::prelude::*;

use crate::string::component::{
    diameter, joint_spacing, make_up_torque, mass_per_length, yield_strength,
};

const KINDS: &[(&str, TubularKind)] = &[
    ("drill-pipe", TubularKind::DrillPipe),
    ("heavy-weight", TubularKind::HeavyWeight),
    ("collar", TubularKind::Collar),
    ("coiled-tubing", TubularKind::CoiledTubing),
];

/// Default source of an entry.
const SOURCE: &str = "a catalogue of one's own";

table! {
    /// A tubular of the user's own.
    TubularTable in "[[tubular]]" {
        /// Name that `catalogue` under [[string]] refers to.
        name: String = required(Text);
        /// "drill-pipe", "heavy-weight", "collar" or "coiled-tubing": the list that contains it.
        kind: TubularKind = default(
            Choice { noun: "a kind of tubular", words: KINDS },
            TubularKind::DrillPipe,
        );
        /// Outside diameter of the body.
        od: f64 = required(diameter("127 mm"));
        /// Inside diameter of the body, less than od.
        id: f64 = required(diameter("108.6 mm"));
        /// Minimum yield strength of the body.
        yield_strength: f64 = required(yield_strength());
        /// Mass per length in air, tool joints included. Default: computed from the dimensions.
        mass_per_length: f64 = optional(mass_per_length());
        /// Outside diameter of the tool joints. Default: no joints.
        joint_od: f64 = optional(diameter("168.3 mm"));
        /// Inside diameter of the tool joints. Default: the body's.
        joint_id: f64 = optional(diameter("69.9 mm"));
        /// Length of pin and box together. Needed with `joint_od` where `mass_per_length` is not
        /// given.
        joint_length: f64 = optional(Quantity::si(
            Dimension::Length,
            Range::from_to(0.05, 5.0).usual(0.2, 1.5),
            "0.43 m",
        ));
        /// Distance between tool joints. Needed with `joint_od`.
        joint_spacing: f64 = optional(joint_spacing());
        /// Type of its connections, such as "NC50". For an API connection of a tool joint the
        /// torques are computed where they are not given.
        connection: String = optional(Text);
        /// Torque to which the connections are made up.
        make_up_torque: f64 = optional(make_up_torque());
        /// Torque at which the connections yield.
        torsional_yield: f64 = optional(make_up_torque());
        /// Source of the numbers.
        source: String = optional(Text);
    }
}

impl TubularTable {
    pub(super) fn build(&self, place: Span, reader: &mut Reader) -> Option<CatalogueEntry> {
        let (od, id) = (self.od.at()?, self.id.at()?);
        if id.value >= od.value {
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
        let joints = self.joints(place, reader)?;
        let connection = self.connection(joints.as_ref(), reader)?;
        Some(CatalogueEntry {
            designation: self.name.get()?.clone(),
            kind: *self.kind.get()?,
            class: PipeClass::New,
            od_m: od.value,
            id_m: id.value,
            joints,
            connection,
            given_mass_kg_per_m: self.mass_per_length.optional()?.map(|at| at.value),
            yield_strength_Pa: *self.yield_strength.get()?,
            source: match self.source.optional()? {
                Some(item) => item.value.clone().into(),
                None => SOURCE.into(),
            },
        })
    }

    /// Returns the joints, if it has any; the outer `None` follows a mistake.
    fn joints(&self, place: Span, reader: &mut Reader) -> Option<Option<JointDimensions>> {
        let (inside, length) = (self.joint_id.optional()?, self.joint_length.optional()?);
        let spacing = self.joint_spacing.optional()?;
        let Some(outside) = self.joint_od.optional()? else {
            let rest = [("joint_id", inside), ("joint_length", length), ("joint_spacing", spacing)];
            for (name, item) in rest {
                let Some(item) = item else { continue };
                return Diagnostic::error(format!("`{name}` needs `joint_od`"))
                    .at(item.place, "`joint_od` is missing")
                    .refuse(reader);
            }
            return Some(None);
        };
        let lacks = |name: &str| {
            Diagnostic::error(format!("the tool joints lack `{name}`"))
                .at(outside.place, "tool joints")
                .at(place, format!("`{name}` is missing"))
        };
        let Some(spacing) = spacing else {
            return lacks("joint_spacing").refuse(reader);
        };
        if length.is_none() && self.mass_per_length.given().is_none() {
            return lacks("joint_length").help("or give mass_per_length").refuse(reader);
        }
        if outside.value < *self.od.get()? {
            return Diagnostic::error("the tool joint is thinner than its pipe")
                .at(
                    outside.place,
                    format!(
                        "expected {} or more",
                        reader.shown(Dimension::Diameter, *self.od.get()?)
                    ),
                )
                .refuse(reader);
        }
        if let Some(inside) = inside
            && inside.value >= outside.value
        {
            return Diagnostic::error("the tool joint has no wall")
                .at(
                    inside.place,
                    format!(
                        "expected less than {}",
                        reader.shown(Dimension::Diameter, outside.value)
                    ),
                )
                .refuse(reader);
        }
        if let Some(length) = length
            && length.value >= spacing.value
        {
            return Diagnostic::error("the tool joints are longer than their spacing")
                .at(length.place, "length of pin and box")
                .at(spacing.place, "from joint to joint")
                .refuse(reader);
        }
        Some(Some(JointDimensions {
            od_m: outside.value,
            id_m: inside.map_or(*self.id.get()?, |at| at.value),
            length_m: length.map_or(0.0, |at| at.value),
            upset_od_m: None,
            spacing_m: spacing.value,
            pad_m: None,
        }))
    }

    /// Returns the connections, if anything is known of them; the outer `None` follows a mistake.
    fn connection(
        &self,
        joints: Option<&JointDimensions>,
        reader: &mut Reader,
    ) -> Option<Option<EntryConnection>> {
        let name = self.connection.optional()?;
        let make_up = self.make_up_torque.optional()?;
        let yields = self.torsional_yield.optional()?;
        if let (Some(make_up), Some(yields)) = (make_up, yields)
            && make_up.value > yields.value
        {
            return Diagnostic::error("the connection yields before it is made up")
                .at(make_up.place, "made up")
                .at(yields.place, "yields")
                .refuse(reader);
        }
        if name.is_none() && make_up.is_none() && yields.is_none() {
            return Some(None);
        }
        let computed =
            name.zip(joints).map_or_else(ConnectionStrength::default, |(name, joint)| {
                tool_joint(&name.value, joint.od_m, joint.id_m)
            });
        Some(Some(EntryConnection {
            name: name.map_or("–".into(), |name| name.value.clone().into()),
            strength: ConnectionStrength {
                make_up_torque_N_m: make_up.map(|at| at.value).or(computed.make_up_torque_N_m),
                torsional_yield_N_m: yields.map(|at| at.value).or(computed.torsional_yield_N_m),
                ..computed
            },
        }))
    }
}
