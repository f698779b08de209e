//! Mistakes in `[records]`.

use crate::{
    common::{change::rows, changed, read},
    refused, warned,
};

/// `[records]` with these keys.
fn records(keys: &str) -> String {
    changed("[mesh]", &format!("[records]\n{keys}\n\n[mesh]"))
}

#[test]
fn frames_and_spectra() {
    for (name, keys) in rows(
        r#"
        frames_as_a_time: `frames = "0.1 s"`
        frames_never: `frames = 0`
        frames_faster_than_samples: `frames = "1 kHz"`
        channel_unknown: `frames = "10 Hz"\nchannels = ["position", "velocities"]`
        channel_twice: `frames = "10 Hz"\nchannels = ["force", "force"]`
        channels_empty: `frames = "10 Hz"\nchannels = []`
        signal_with_its_unit: `spectra = "surface_torque_N_m"`
        spectrum_segment_longer_than_the_window: `spectra = "twist"\nspectrum_segment = "10 min"`
        spectrum_segment_of_few_samples: `spectra = "twist"\nspectrum_segment = "0.1 s"`
        node_spectra_without_depth: `node_spectra = "bending_moment"`
        node_signal_misspelt: `node_spectra = "bending_momment"\nnode_spectra_at = "4290 m"`
        node_spectra_below_the_bit: `node_spectra = "tension"\nnode_spectra_at = ["100 m", "9 km"]`
        node_spectra_twice_at_a_depth: `node_spectra = "tension"\nnode_spectra_at = ["100 m", 100]`
        "#,
    ) {
        refused(name, read(&records(&keys)));
    }
    for (name, keys) in rows(
        r#"
        node_spectra_at_without_signal: `node_spectra_at = "4290 m"`
        channels_without_frames: `channels = "force"`
        spectrum_segment_without_spectra: `spectrum_segment = "5 s"`
        "#,
    ) {
        warned(name, read(&records(&keys)));
    }
}
