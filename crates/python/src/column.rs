//! A column of numbers with NumPy's array interface.

use arrow_buffer::ScalarBuffer;
use pyo3::{prelude::*, types::PyDict};

/// Numbers in shared memory: NumPy and others view them by `__array_interface__`.
#[pyclass(frozen, module = "wholestring._core")]
pub(crate) struct Column {
    pub(crate) values: ScalarBuffer<f64>,
}

#[pymethods]
impl Column {
    /// The array interface, version 3: read-only.
    #[getter]
    fn __array_interface__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let about = PyDict::new(py);
        about.set_item("version", 3)?;
        about.set_item("shape", (self.values.len(),))?;
        let order = if cfg!(target_endian = "little") { "<f8" } else { ">f8" };
        about.set_item("typestr", order)?;
        let is_readonly = true;
        about.set_item("data", (self.values.as_ptr() as usize, is_readonly))?;
        Ok(about)
    }

    fn __len__(&self) -> usize {
        self.values.len()
    }
}
