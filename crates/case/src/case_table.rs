//! The top level of a case file.

use wholestring::outcome::ModelKind;
use wholestring_config::prelude::*;
use wholestring_units::UnitSet;

use crate::{
    bit::BitTable,
    bit_test::BitTestTable,
    buckling::BucklingTable,
    component::ComponentTable,
    dynamics::DynamicsTable,
    ends::EndsTable,
    mesh::MeshTable,
    model_rule::{MODELS, ModelRule},
    modes::ModesTable,
    mud::MudTable,
    operation::OperationTable,
    plan::PlanTable,
    records::RecordsTable,
    rig::{HoistTable, RigTable},
    rock::RockTable,
    steel::SteelTable,
    top_drive::TopDriveTable,
    unit_set::UNIT_SETS,
    well::WellTable,
};

table! {
    /// A drill string in a well, and what is done with it. Quantities are text with a unit
    /// ("5-1/2 in", "1.2 sg"); a bare number is SI, except in `stations` (m, deg, deg) and `rpm`.
    CaseTable in "the case" {
        /// What the case is called in results. Default: the name of the file.
        name: String = optional(Text);
        /// "soft" (statics without bending stiffness), "stiff" (statics with it, contact found),
        /// "dynamic" (the whole string in time), or a list that is solved one by one.
        model: Vec<Spanned<ModelKind>> = default(
            List::or_one(ModelRule, "models", MODELS.len()),
            vec![Spanned { value: ModelKind::Soft, place: Span::default() }],
        );
        /// Units that people are shown: "si" (m, kN, kN.m, mm, kg/m3), "metric" (m, t, kN.m, mm,
        /// sg) or "field" (ft, klbf, ft-lbf, in, ppg). Files for machines are SI always.
        units: UnitSet = default(UNIT_SETS, UnitSet::Si);
        /// Where the hole runs and how wide it is and how it rubs.
        well: WellTable = required(Section::<WellTable>::RULE);
        /// Drilling fluid, the same inside the string and in the annulus.
        mud: MudTable = required(Section::<MudTable>::RULE);
        /// The metal of the string, wherever a component does not say otherwise.
        steel: SteelTable = optional(Section::<SteelTable>::RULE);
        /// File of tubulars of one's own beside the case, TOML or CSV, such as "my-pipes.toml":
        /// their names may stand wherever the string names the catalogue.
        catalogue: String = optional(Text);
        /// The string, component by component from the bit up.
        string: Vec<Spanned<ComponentTable>> = required(List::tables::<ComponentTable>(
            "components ([[string]])", 5000,
        ));
        /// How the ends of the string are held across the hole.
        ends: EndsTable = optional(Section::<EndsTable>::RULE);
        /// The bit on the rock.
        bit: BitTable = optional(Section::<BitTable>::RULE);
        /// Solid rock under the bit.
        rock: RockTable = optional(Section::<RockTable>::RULE);
        /// The bit alone on its rock.
        bit_test: BitTestTable = optional(Section::<BitTestTable>::RULE);
        /// Natural frequencies and what meets them.
        modes: ModesTable = optional(Section::<ModesTable>::RULE);
        /// What `wholestring plan` computes.
        plan: PlanTable = optional(Section::<PlanTable>::RULE);
        /// Limits of the rig.
        rig: RigTable = optional(Section::<RigTable>::RULE);
        /// How the top of the string is moved along the hole in the dynamic model.
        hoist: HoistTable = optional(Section::<HoistTable>::RULE);
        /// What turns the top of the string in the dynamic model.
        top_drive: TopDriveTable = optional(Section::<TopDriveTable>::RULE);
        /// What the driller is doing.
        operation: OperationTable = required(Section::<OperationTable>::RULE);
        /// When a compressed string counts as buckled, and what that does to the soft string.
        buckling: BucklingTable = optional(Section::<BucklingTable>::RULE);
        /// How finely the string is cut.
        mesh: MeshTable = optional(Section::<MeshTable>::RULE);
        /// Settings of the dynamic model.
        dynamics: DynamicsTable = optional(Section::<DynamicsTable>::RULE);
        /// What a dynamic run keeps beside its tables.
        records: RecordsTable = optional(Section::<RecordsTable>::RULE);
    }
}
