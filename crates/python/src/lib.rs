//! What the Python package `wholestring` is made of: cases, what they come to, and tables that
//! other libraries take without a copy. Thin: it hands over to the runner, and its words are the
//! package's, which is in `python/wholestring`.

mod answers;
mod attended;
mod case;
mod column;
mod commands;
mod conventions;
mod error;
mod event_buffer;
mod existing;
mod folder;
mod import;
mod law;
mod measure;
mod simulation;
mod sweep;
mod table;
mod variations;

use pyo3::prelude::*;

/// The compiled half of `wholestring`: private, as its name says.
#[pymodule]
mod _core {
    use pyo3::prelude::*;

    #[pymodule_export]
    use crate::commands::{
        bha::bha_of,
        bit_test::bit_test_of,
        broomstick::broomstick_of,
        calibrate::{calibrate_by, calibrated, held_dimension},
        modes::modes_of,
        option::values,
        plan::plan_of,
        reach::reach_of,
        study::study_of,
    };
    #[pymodule_export]
    use crate::{
        answers::Answers, case::Case, column::Column, simulation::Simulation, table::Table,
    };
    #[pymodule_export]
    use crate::{sweep::Sweep, variations::Variations};

    #[pymodule_export]
    use crate::import::{Imported, contents, import_files};

    #[pymodule_export]
    use crate::measure::{advance_alone, solve_alone};

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", wholestring_results::ENGINE_VERSION)?;
        // The case that the package shows itself with.
        module.add("EXAMPLE", include_str!("../../../cases/slant.toml"))?;
        module.add("SCALARS", crate::answers::scalars())
    }

    /// Colours, strokes, units and words of pictures, as JSON.
    #[pyfunction]
    fn conventions(py: Python<'_>) -> PyResult<String> {
        crate::conventions::json(py)
    }

    /// The path of a well by the settings of its case, from the surface to the bit.
    #[pyfunction]
    fn well_path(settings_json: &str) -> PyResult<crate::table::Table> {
        crate::conventions::well_path(settings_json)
    }

    /// A quantity of a dimension, such as `"10 s"` of a time, in SI.
    #[pyfunction]
    fn quantity(py: Python<'_>, text: &str, dimension: &str) -> PyResult<f64> {
        use wholestring_units::Dimension;

        let found = Dimension::ALL.iter().find(|of| of.name() == dimension);
        let found = found.ok_or_else(|| crate::error::of_panic(py))?;
        found
            .parse(text)
            .map_err(|error| pyo3::exceptions::PyValueError::new_err(error.to_string()))
    }

    /// SI unit of a dimension, such as `"rotary speed"`.
    #[pyfunction]
    fn si_unit(py: Python<'_>, dimension: &str) -> PyResult<&'static str> {
        let found = wholestring_units::Dimension::ALL.iter().find(|of| of.name() == dimension);
        found.map(|of| of.si_symbol()).ok_or_else(|| crate::error::of_panic(py))
    }

    /// The table of the sweep in a folder, and how many of its columns were varied.
    #[pyfunction]
    fn sweep_table(
        py: Python<'_>,
        folder: std::path::PathBuf,
    ) -> PyResult<(usize, crate::table::Table)> {
        crate::sweep::table(py, &folder)
    }

    /// SI unit of what a dotted or short key of a case measures; nothing of a bare number, a text,
    /// or a key that there is not.
    #[pyfunction]
    fn unit_of(key: &str) -> Option<&'static str> {
        wholestring_case::dimension_at(key).map(wholestring_units::Dimension::si_symbol)
    }
}
