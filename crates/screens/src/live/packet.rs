//! Samples and frames as bytes, little-endian.
//!
//! A head of 24 bytes: kind (u32: 1 samples, 2 a frame), count of rows or nodes (u32), epoch (u32),
//! a reserved field (u32), and the number of the first sample or the time of the frame in seconds
//! (f64). Then the numbers (f32): of samples by rows, of a frame by columns.

use super::{
    channels::{FRAME_COLUMNS, SAMPLE_COLUMNS},
    ring::Samples,
};

const SAMPLES: u32 = 1;
const FRAME: u32 = 2;
const HEAD_BYTES: usize = 24;

fn packet(kind: u32, count: usize, epoch: u32, place: f64, values: &[f32]) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(HEAD_BYTES + 4 * values.len());
    for word in [kind, count as u32, epoch, 0] {
        bytes.extend(word.to_le_bytes());
    }
    bytes.extend(place.to_le_bytes());
    bytes.extend(values.iter().flat_map(|value| value.to_le_bytes()));
    bytes
}

/// Samples as bytes.
pub fn samples_packet(samples: &Samples) -> Vec<u8> {
    let rows = samples.values.len() / SAMPLE_COLUMNS;
    packet(SAMPLES, rows, samples.epoch, samples.first as f64, &samples.values)
}

/// A frame as bytes.
pub fn frame_packet(epoch: u32, time_s: f64, columns: &[f32]) -> Vec<u8> {
    packet(FRAME, columns.len() / FRAME_COLUMNS, epoch, time_s, columns)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_head_says_what_follows() {
        let values = vec![1.5; 2 * SAMPLE_COLUMNS];
        let bytes = samples_packet(&Samples { epoch: 3, first: 7, values });
        assert_eq!(bytes.len(), HEAD_BYTES + 8 * SAMPLE_COLUMNS);
        assert_eq!(&bytes[..12], &[1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0]);
        assert_eq!(&bytes[16..24], &7.0_f64.to_le_bytes());
        assert_eq!(&bytes[24..28], &1.5_f32.to_le_bytes());
        let frame = frame_packet(0, 2.5, &[0.0; 5 * FRAME_COLUMNS]);
        assert_eq!(&frame[..8], &[2, 0, 0, 0, 5, 0, 0, 0]);
    }
}
