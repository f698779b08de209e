//! Cases shipped with the package.

use pyo3::{
    prelude::*,
    types::{PyBytes, PyDict},
};
use wholestring_cases::ALL;

/// The sections of the well of the published campaign, and their path.
const CAMPAIGN: [(&str, &str); 3] = [
    ("np13-444", include_str!("../../../studies/np13-444.toml")),
    ("np13-311", include_str!("../../../studies/np13-311.toml")),
    ("np13-216", include_str!("../../../studies/np13-216.toml")),
];
const CAMPAIGN_PATH: (&str, &str) =
    ("np13-path.csv", include_str!("../../../studies/np13-path.csv"));

/// Each by name: its text, and its files.
pub(crate) fn examples(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    let examples = PyDict::new(py);
    let shipped = ALL.iter().map(|case| (case.name, case.text, case.beside));
    let campaign = CAMPAIGN.iter().map(|(name, text)| (*name, *text, &[CAMPAIGN_PATH][..]));
    for (name, text, beside) in shipped.chain(campaign) {
        let files = PyDict::new(py);
        for (file, content) in beside {
            files.set_item(file, PyBytes::new(py, content.as_bytes()))?;
        }
        examples.set_item(name, (text, files))?;
    }
    Ok(examples)
}
