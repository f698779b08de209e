//! The top level of a case file.

use std::sync::LazyLock;

use serde_json::{Value as Json, json};
use wholestring::outcome::ModelKind;
use wholestring_config::{prelude::*, rule::Table};
use wholestring_units::UnitSet;

use crate::{
    bit::BitTable,
    bit_test::BitTestTable,
    buckling::BucklingTable,
    dynamics::{DynamicsTable, mesh::MeshTable, records::RecordsTable},
    ends::EndsTable,
    modes::ModesTable,
    mud::MudTable,
    operation::OperationTable,
    plan::PlanTable,
    rig::{HoistTable, RigTable, top_drive::TopDriveTable},
    rock::RockTable,
    string::{component::ComponentTable, steel::SteelTable},
    values::{MODELS, ModelRule, UNIT_SETS},
    well::WellTable,
};

table! {
    /// A drill string in a well, and its operation. Quantities are text with a unit ("5-1/2 in",
    /// "1.2 sg"); a bare number is SI, except in `stations` (m, deg, deg) and `rpm`.
    CaseTable in "the case" {
        /// Name of the case in results. Default: the name of the file.
        name: String = optional(Text);
        /// "soft" (statics without bending stiffness), "stiff" (statics with it, contact found),
        /// "dynamic" (the whole string in time), or a list that is solved one by one.
        model: Vec<Spanned<ModelKind>> = default(
            List::or_one(ModelRule, "models", MODELS.len()),
            vec![Spanned { value: ModelKind::Soft, place: Span::default() }],
        );
        /// Units of displayed results: "si" (m, kN, kN.m, mm, kg/m3), "metric" (m, t, kN.m, mm, sg)
        /// or "field" (ft, klbf, ft-lbf, in, ppg). Files for machines are always in SI.
        units: UnitSet = default(UNIT_SETS, UnitSet::Si);
        /// Path, diameter and friction of the hole.
        well: WellTable = required(Section::<WellTable>::RULE);
        /// Drilling fluid, the same inside the string and in the annulus.
        mud: MudTable = required(Section::<MudTable>::RULE);
        /// The metal of the string, for components that do not give their own.
        steel: SteelTable = optional(Section::<SteelTable>::RULE);
        /// File of the user's own tubulars, relative to the case, TOML or CSV, such as
        /// "my-pipes.toml": the string may use their names wherever it names an entry of the
        /// catalogue.
        catalogue: String = optional(Text);
        /// The string, component by component from the bit up.
        string: Vec<Spanned<ComponentTable>> = required(List::tables::<ComponentTable>(
            "components ([[string]])", 5000,
        ));
        /// Lateral supports of the ends of the string.
        ends: EndsTable = optional(Section::<EndsTable>::RULE);
        /// The bit on the rock.
        bit: BitTable = optional(Section::<BitTable>::RULE);
        /// Solid rock under the bit.
        rock: RockTable = optional(Section::<RockTable>::RULE);
        /// Test of bit and rock without the string.
        bit_test: BitTestTable = optional(Section::<BitTestTable>::RULE);
        /// Natural frequencies and their excitation.
        modes: ModesTable = optional(Section::<ModesTable>::RULE);
        /// Inputs of `wholestring plan`.
        plan: PlanTable = optional(Section::<PlanTable>::RULE);
        /// Limits of the rig.
        rig: RigTable = optional(Section::<RigTable>::RULE);
        /// Axial motion of the top of the string in the dynamic model.
        hoist: HoistTable = optional(Section::<HoistTable>::RULE);
        /// Rotation of the top of the string in the dynamic model.
        top_drive: TopDriveTable = optional(Section::<TopDriveTable>::RULE);
        /// The driller's operation.
        operation: OperationTable = required(Section::<OperationTable>::RULE);
        /// Buckling criterion of a compressed string, and the effect of buckling on the soft
        /// string.
        buckling: BucklingTable = optional(Section::<BucklingTable>::RULE);
        /// Mesh of the string.
        mesh: MeshTable = optional(Section::<MeshTable>::RULE);
        /// Settings of the dynamic model.
        dynamics: DynamicsTable = optional(Section::<DynamicsTable>::RULE);
        /// Further outputs of a dynamic run, in addition to its tables.
        records: RecordsTable = optional(Section::<RecordsTable>::RULE);
    }
}

// The JSON schema of the case file, from the same declarations that read it.

/// JSON schema (draft 2020-12) of the case file: every key with its meaning, units, range and
/// default.
///
/// It is generated from the declarations that read the file, so that the two cannot disagree. Rules
/// that a schema cannot express (relations between keys, the content of the survey) are checked by
/// [`crate::parse`].
pub fn schema() -> Json {
    let mut schema = TABLES.clone();
    schema["$schema"] = json!("https://json-schema.org/draft/2020-12/schema");
    schema["title"] = json!("wholestring case");
    schema
}

pub(crate) static TABLES: LazyLock<Json> = LazyLock::new(CaseTable::schema);
