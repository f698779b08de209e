//! The compiled part of the Python package `wholestring`: cases, their results, and tables that
//! other libraries use without a copy. It is thin: it calls the runner, and its wording is that of
//! the package in `python/wholestring`.

mod answers;
mod attended;
mod broomstick;
mod case;
mod column;
mod conventions;
mod dimension;
mod error;
mod event_buffer;
mod examples;
mod folder;
mod import;
mod job;
mod law;
mod measure;
mod option;
mod simulation;
mod sweep;
mod table;
mod variations;

use pyo3::prelude::*;

/// The compiled half of `wholestring`: private, as its name indicates.
#[pymodule]
mod _core {
    use pyo3::prelude::*;

    #[pymodule_export]
    use crate::{
        answers::Answers, case::Case, column::Column, simulation::Simulation, table::Table,
    };
    #[pymodule_export]
    use crate::{
        broomstick::broomstick_of,
        job::{calibrated, carry_out, held_dimension},
        option::values,
    };
    #[pymodule_export]
    use crate::{sweep::Sweep, variations::Variations};

    #[pymodule_export]
    use crate::import::{Imported, contents, import_files};

    #[pymodule_export]
    use crate::dimension::{dimension_of, long_key, quantity, si_unit, unit_of};

    #[pymodule_export]
    use crate::measure::{advance_alone, solve_alone};

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", wholestring_results::ENGINE_VERSION)?;
        module.add("EXAMPLES", crate::examples::examples(module.py())?)?;
        module.add("SCALARS", crate::answers::scalars())
    }

    /// Colours, strokes, units and labels of plots, as JSON.
    #[pyfunction]
    fn conventions(py: Python<'_>) -> PyResult<String> {
        crate::conventions::json(py)
    }

    /// The path of a well from the settings of its case, from the surface to the bit.
    #[pyfunction]
    fn well_path(settings_json: &str) -> PyResult<crate::table::Table> {
        crate::conventions::well_path(settings_json)
    }

    /// The table of the sweep in a folder, and the number of its varied columns.
    #[pyfunction]
    fn sweep_table(
        py: Python<'_>,
        folder: std::path::PathBuf,
    ) -> PyResult<(usize, crate::table::Table)> {
        crate::sweep::table(py, &folder)
    }
}
