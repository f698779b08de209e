//! Tables that other libraries use without a copy, by Arrow's capsules.

use std::sync::Arc;

use arrow_array::{
    Array, ArrayRef, Float64Array, RecordBatch, RecordBatchIterator, StringArray,
    ffi::FFI_ArrowSchema, ffi_stream::FFI_ArrowArrayStream,
};
use arrow_buffer::{NullBuffer, ScalarBuffer};
use arrow_schema::{DataType, Field, Schema};
use pyo3::{
    exceptions::PyRuntimeError,
    prelude::*,
    types::{PyBytes, PyCapsule},
};
use wholestring_results::{Column as Stored, Data, Table as StoredTable};

use crate::{column::Column, error};

/// A table: its columns, with the unit and the meaning of each.
#[pyclass(frozen, module = "wholestring._core")]
pub(crate) struct Table {
    batch: RecordBatch,
}

impl Table {
    /// A table in Arrow's layout, in which it is then shared. A missing number is null, and NaN in
    /// the memory itself.
    pub(crate) fn of(table: &StoredTable) -> PyResult<Self> {
        let columns = table.columns().iter().map(column).unzip::<_, _, Vec<_>, Vec<_>>();
        let (fields, arrays) = columns;
        let batch = RecordBatch::try_new(Arc::new(Schema::new(fields)), arrays)
            .map_err(|error| PyRuntimeError::new_err(error.to_string()))?;
        Ok(Self { batch })
    }

    /// The same as a table of the engine.
    pub(crate) fn stored(&self) -> StoredTable {
        let schema = self.batch.schema();
        let columns = schema.fields().iter().zip(self.batch.columns()).map(|(field, array)| {
            let about = |what| field.metadata().get(what).cloned().unwrap_or_default();
            let data = match array.as_any().downcast_ref::<Float64Array>() {
                Some(numbers) => Data::Number(numbers.iter().collect()),
                None => Data::Text(words(array).unwrap_or_default()),
            };
            Stored {
                name: field.name().clone(),
                unit: about("unit"),
                meaning: about("meaning"),
                data,
            }
        });
        StoredTable::new(columns.collect())
    }

    fn place(&self, name: &str) -> PyResult<usize> {
        let schema = self.batch.schema();
        schema.index_of(name).map_err(|_| {
            let names: Vec<&str> =
                schema.fields().iter().map(|field| field.name().as_str()).collect();
            let message = format!("there is no column `{name}`: it has {}", names.join(", "));
            error::not_found(message)
        })
    }

    fn about(&self, name: &str, what: &str) -> PyResult<String> {
        let place = self.place(name)?;
        let about = self.batch.schema().field(place).metadata().get(what).cloned();
        Ok(about.unwrap_or_default())
    }
}

/// The texts of a column; none if it has numbers.
fn words(array: &ArrayRef) -> Option<Vec<String>> {
    let words = array.as_any().downcast_ref::<StringArray>()?;
    Some(words.iter().map(|word| word.unwrap_or_default().to_owned()).collect())
}

/// A pickled column: name, unit, meaning, and either numbers, eight bytes each, little-endian, and
/// one byte each that is one for a missing number, or texts.
type Part<'a> = (String, String, String, Option<[Bound<'a, PyBytes>; 2]>, Option<Vec<String>>);

fn column(stored: &Stored) -> (Field, ArrayRef) {
    let array: ArrayRef = match &stored.data {
        Data::Number(numbers) => {
            let values: Vec<f64> =
                numbers.iter().map(|number| number.unwrap_or(f64::NAN)).collect();
            let has_nulls = numbers.iter().any(Option::is_none);
            let nulls = has_nulls.then(|| numbers.iter().map(Option::is_some).collect());
            let nulls: Option<NullBuffer> = nulls;
            Arc::new(Float64Array::new(ScalarBuffer::from(values), nulls))
        }
        Data::Text(words) => Arc::new(StringArray::from_iter_values(words)),
    };
    let kind = match stored.data {
        Data::Number(_) => DataType::Float64,
        Data::Text(_) => DataType::Utf8,
    };
    let about =
        [("unit".to_owned(), stored.unit.clone()), ("meaning".to_owned(), stored.meaning.clone())];
    (Field::new(&stored.name, kind, true).with_metadata(about), array)
}

#[pymethods]
impl Table {
    /// Arrow's stream; the memory is shared.
    #[pyo3(signature = (requested_schema = None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyCapsule>> {
        // A request that need not be granted, according to Arrow's own rules.
        let _ = requested_schema;
        let batches = [Ok(self.batch.clone())];
        let reader = RecordBatchIterator::new(batches, self.batch.schema());
        let stream = FFI_ArrowArrayStream::new(Box::new(reader));
        PyCapsule::new_with_value(py, stream, c"arrow_array_stream")
    }

    /// Arrow's schema.
    fn __arrow_c_schema__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyCapsule>> {
        let schema = FFI_ArrowSchema::try_from(self.batch.schema().as_ref())
            .map_err(|error| PyRuntimeError::new_err(error.to_string()))?;
        PyCapsule::new_with_value(py, schema, c"arrow_schema")
    }

    /// Names of the columns.
    #[getter]
    fn names(&self) -> Vec<String> {
        self.batch.schema().fields().iter().map(|field| field.name().clone()).collect()
    }

    /// Some of the columns, which share their memory.
    fn select(&self, names: Vec<String>) -> PyResult<Self> {
        let places = names.iter().map(|name| self.place(name)).collect::<PyResult<Vec<_>>>()?;
        let batch = self.batch.project(&places);
        let batch = batch.map_err(|error| PyRuntimeError::new_err(error.to_string()))?;
        Ok(Self { batch })
    }

    /// Number of rows.
    #[getter]
    fn rows(&self) -> usize {
        self.batch.num_rows()
    }

    /// SI unit of a column, empty if it has none.
    fn unit(&self, name: &str) -> PyResult<String> {
        self.about(name, "unit")
    }

    /// Meaning of a column, in a sentence.
    fn meaning(&self, name: &str) -> PyResult<String> {
        self.about(name, "meaning")
    }

    /// The numbers of a column, as a view; none if it has text.
    fn numbers(&self, name: &str) -> PyResult<Option<Column>> {
        let array = self.batch.column(self.place(name)?);
        let numbers = array.as_any().downcast_ref::<Float64Array>();
        Ok(numbers.map(|numbers| Column { values: numbers.values().clone() }))
    }

    /// The texts of a column; none if it has numbers.
    fn words(&self, name: &str) -> PyResult<Option<Vec<String>>> {
        Ok(words(self.batch.column(self.place(name)?)))
    }

    /// Its columns, each in pickled form.
    fn parts<'py>(&self, py: Python<'py>) -> Vec<Part<'py>> {
        let stored = self.stored();
        let part = |stored: &Stored| {
            let (name, unit, meaning) =
                (stored.name.clone(), stored.unit.clone(), stored.meaning.clone());
            match &stored.data {
                Data::Number(numbers) => {
                    let value = |number: &Option<f64>| number.unwrap_or(f64::NAN).to_le_bytes();
                    let values: Vec<u8> = numbers.iter().flat_map(value).collect();
                    let nulls: Vec<u8> =
                        numbers.iter().map(|number| number.is_none().into()).collect();
                    let bytes = [PyBytes::new(py, &values), PyBytes::new(py, &nulls)];
                    (name, unit, meaning, Some(bytes), None)
                }
                Data::Text(words) => (name, unit, meaning, None, Some(words.clone())),
            }
        };
        stored.columns().iter().map(part).collect()
    }

    /// The table with these [`Table::parts`].
    #[staticmethod]
    fn restore(parts: Vec<Part<'_>>) -> PyResult<Self> {
        let column = |(name, unit, meaning, numbers, words): Part<'_>| {
            let data = match (numbers, words) {
                (Some([values, nulls]), None) => {
                    let (values, rest) = values.as_bytes().as_chunks::<8>();
                    let nulls = nulls.as_bytes();
                    if !rest.is_empty() || values.len() != nulls.len() {
                        return None;
                    }
                    let number = |(value, is_null): (&[u8; 8], &u8)| {
                        (*is_null == 0).then(|| f64::from_le_bytes(*value))
                    };
                    Data::Number(values.iter().zip(nulls).map(number).collect())
                }
                (None, Some(words)) => Data::Text(words),
                _ => return None,
            };
            Some(Stored { name, unit, meaning, data })
        };
        let columns: Option<Vec<Stored>> = parts.into_iter().map(column).collect();
        let columns =
            columns.filter(|all| all.windows(2).all(|two| two[0].data.len() == two[1].data.len()));
        let columns = columns.ok_or_else(|| error::bad_input("no columns of a table"))?;
        Self::of(&StoredTable::new(columns))
    }
}
