//! The tables of an export that are read, and their columns.

/// A table of Landmark's Engineer's Data Model.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Table {
    Well,
    Wellbore,
    Scenario,
    Case,
    Datum,
    SurveyHeader,
    SurveyStation,
    HoleSection,
    Assembly,
    Component,
    Stabiliser,
    Bit,
    Fluid,
    FluidTest,
    DragParameters,
    DragOptions,
    DragChart,
}

/// A table: its name in a file, the columns that are kept, and its maximum number of rows.
pub(super) struct Declared {
    table: Table,
    pub(super) name: &'static str,
    pub(super) columns: &'static [&'static str],
    pub(super) most: usize,
}

/// Maximum number of rows of tables from which one is chosen. A whole company's database has fewer
/// wells.
const FEW: usize = 10_000;
/// Maximum number of rows of tables with many rows per case.
const MANY: usize = 2_000_000;

const fn declared(
    table: Table,
    name: &'static str,
    most: usize,
    columns: &'static [&'static str],
) -> Declared {
    Declared { table, name, columns, most }
}

/// Every table, in the order of [`Table`].
pub(super) const TABLES: [Declared; 17] = [
    declared(Table::Well, "CD_WELL", FEW, &["well_id", "well_common_name", "well_legal_name"]),
    declared(Table::Wellbore, "CD_WELLBORE", FEW, &["well_id", "wellbore_id", "wellbore_name"]),
    declared(
        Table::Scenario,
        "CD_SCENARIO",
        FEW,
        &["well_id", "wellbore_id", "scenario_id", "name", "def_survey_header_id", "datum_id"],
    ),
    declared(
        Table::Case,
        "CD_CASE",
        FEW,
        &[
            "well_id",
            "wellbore_id",
            "scenario_id",
            "case_id",
            "case_name",
            "phase",
            "assembly_id",
            "hole_sect_group_id",
            "fluid_id",
            "datum_id",
        ],
    ),
    declared(
        Table::Datum,
        "CD_DATUM",
        FEW,
        &["well_id", "datum_id", "datum_name", "datum_elevation", "is_default"],
    ),
    declared(
        Table::SurveyHeader,
        "CD_DEFINITIVE_SURVEY_HEADER",
        FEW,
        &["well_id", "wellbore_id", "def_survey_header_id", "name", "phase"],
    ),
    declared(
        Table::SurveyStation,
        "CD_DEFINITIVE_SURVEY_STATION",
        MANY,
        &[
            "well_id",
            "wellbore_id",
            "def_survey_header_id",
            "md",
            "inclination",
            "azimuth",
            "sequence_no",
            "tvd",
            "offset_north",
            "offset_east",
        ],
    ),
    declared(
        Table::HoleSection,
        "CD_HOLE_SECT",
        MANY,
        &[
            "well_id",
            "wellbore_id",
            "hole_sect_group_id",
            "hole_sect_id",
            "sequence_no",
            "sect_type_code",
            "od_casing",
            "id_casing",
            "hole_size",
            "effective_diameter",
            "length",
            "md_shoe",
            "cof",
            "catalog_key_desc",
        ],
    ),
    declared(
        Table::Assembly,
        "CD_ASSEMBLY",
        MANY,
        &[
            "well_id",
            "wellbore_id",
            "assembly_id",
            "assembly_name",
            "string_type",
            "hole_size",
            "md_assembly_base",
        ],
    ),
    declared(
        Table::Component,
        "CD_ASSEMBLY_COMP",
        MANY,
        &[
            "well_id",
            "wellbore_id",
            "assembly_id",
            "assembly_comp_id",
            "sequence_no",
            "sect_type_code",
            "catalog_key_desc",
            "comp_name",
            "description",
            "od_body",
            "id_body",
            "length",
            "approximate_weight",
            "od_connection",
            "average_joint_length",
            "od_max",
            "blade_length",
            "min_yield_stress",
            "makeup_torque",
        ],
    ),
    declared(
        Table::Stabiliser,
        "CD_BHA_COMP_STAB",
        MANY,
        &[
            "well_id",
            "wellbore_id",
            "assembly_id",
            "assembly_comp_id",
            "stab_blade_od",
            "stab_blade_length",
        ],
    ),
    declared(
        Table::Bit,
        "CD_BHA_COMP_BIT",
        MANY,
        &["well_id", "wellbore_id", "assembly_id", "assembly_comp_id", "bit_size"],
    ),
    declared(
        Table::Fluid,
        "CD_FLUID",
        MANY,
        &[
            "well_id",
            "fluid_id",
            "fluid_name",
            "density",
            "plastic_viscosity",
            "yield_point",
            "gels_10_min",
        ],
    ),
    declared(
        Table::FluidTest,
        "WP_FLUID_TEMP",
        MANY,
        &["well_id", "fluid_id", "base_density", "density", "plastic_viscosity", "yield_point"],
    ),
    declared(
        Table::DragParameters,
        "WP_TDA_PARAMS",
        MANY,
        &[
            "well_id",
            "wellbore_id",
            "scenario_id",
            "case_id",
            "cof_casing_trip_out",
            "cof_oh_trip_out",
            "cof_casing_trip_in",
            "cof_oh_trip_in",
        ],
    ),
    declared(
        Table::DragOptions,
        "WP_TDA_OPTIONS",
        MANY,
        &["well_id", "wellbore_id", "scenario_id", "case_id", "hoist_equip_weight"],
    ),
    declared(
        Table::DragChart,
        "WP_TDA_DRAGCHART",
        MANY,
        &[
            "well_id",
            "wellbore_id",
            "scenario_id",
            "case_id",
            "run_depth",
            "to_hookload",
            "ti_hookload",
            "ob_hookload",
            "ob_torque",
            "rd_torque",
        ],
    ),
];

impl Table {
    /// Its declaration.
    pub(super) fn declared(self) -> &'static Declared {
        &TABLES[self as usize]
    }

    /// The table of an element.
    pub(super) fn of(name: &str) -> Option<Self> {
        TABLES.iter().find(|own| own.name.eq_ignore_ascii_case(name)).map(|own| own.table)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_stand_in_their_order() {
        for (place, declared) in TABLES.iter().enumerate() {
            assert_eq!(declared.table as usize, place, "{}", declared.name);
        }
    }
}
