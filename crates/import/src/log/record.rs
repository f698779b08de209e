//! A row of a log.

use crate::{error::ImportError, fragment::Note};

/// Values of the sensors of a rig at one time; NaN where a sensor has none.
///
/// Readers of logs return these one after the other, whatever the length of the log.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Record {
    /// Time since the log's first row, s. NaN in a log against depth.
    pub time_s: f64,
    /// Measured depth of the bit, m.
    pub bit_depth_m: f64,
    /// Measured depth of the hole, m.
    pub hole_depth_m: f64,
    /// Height of the travelling block, m.
    pub block_position_m: f64,
    /// Hook load as it was logged, including the block's weight where the block hangs on the
    /// sensor, N.
    pub hook_load_N: f64,
    /// Weight on bit as the rig computes it, N.
    pub weight_on_bit_N: f64,
    /// Torque at the surface, N·m.
    pub torque_N_m: f64,
    /// Rotary speed at the surface, rad/s.
    pub rotary_speed_rad_per_s: f64,
    /// Flow rate of the pumps, m³/s.
    pub flow_rate_m3_per_s: f64,
    /// Pressure at the standpipe, Pa.
    pub standpipe_pressure_Pa: f64,
}

impl Record {
    /// A row without values.
    pub const NONE: Record = Record {
        time_s: f64::NAN,
        bit_depth_m: f64::NAN,
        hole_depth_m: f64::NAN,
        block_position_m: f64::NAN,
        hook_load_N: f64::NAN,
        weight_on_bit_N: f64::NAN,
        torque_N_m: f64::NAN,
        rotary_speed_rad_per_s: f64::NAN,
        flow_rate_m3_per_s: f64::NAN,
        standpipe_pressure_Pa: f64::NAN,
    };
}

// A row of cells.

/// Maximum number of columns of a row. A rig has hundreds of channels.
pub(crate) const COLUMNS: usize = 4096;

/// Cells of a row: one text, and the range of each cell in it.
#[derive(Debug, Clone, Default)]
pub(crate) struct Row {
    pub(crate) bytes: Vec<u8>,
    pub(crate) cells: Vec<(u32, u32)>,
    /// Number of the line on which it begins, from 1.
    pub(crate) line: u64,
}

impl Row {
    /// Clears it for the next row.
    pub(crate) fn clear(&mut self) {
        self.bytes.clear();
        self.cells.clear();
    }

    /// A cell without surrounding blanks; empty if the row is shorter.
    pub(crate) fn cell(&self, column: usize) -> &[u8] {
        let range = self.cells.get(column);
        range.map_or(&[][..], |&(from, to)| &self.bytes[from as usize..to as usize])
    }

    /// Adds the cell in this range, without surrounding blanks and quotation marks.
    pub(crate) fn push(&mut self, mut from: usize, mut to: usize) {
        let blank = |b: u8| b.is_ascii_whitespace();
        while from < to && blank(self.bytes[from]) {
            from += 1;
        }
        while from < to && blank(self.bytes[to - 1]) {
            to -= 1;
        }
        if to - from >= 2 && self.bytes[from] == b'"' && self.bytes[to - 1] == b'"' {
            return self.push(from + 1, to - 1);
        }
        self.cells.push((from as u32, to as u32));
    }

    /// Splits the text from `from` on at a separator; false if a quotation is not closed.
    ///
    /// A quotation starts at the beginning of a cell: the inch mark of `9 5/8"` does not start one.
    pub(crate) fn part_at(&mut self, sign: u8, from: usize) -> bool {
        let mut start = from;
        let mut open = false;
        let mut blank = true;
        for at in from..self.bytes.len() {
            let byte = self.bytes[at];
            if byte == sign && !open {
                self.push(start, at);
                start = at + 1;
                blank = true;
                continue;
            }
            if byte == b'"' && (open || blank) {
                open = !open;
            }
            blank &= byte.is_ascii_whitespace();
        }
        self.push(start, self.bytes.len());
        !open
    }

    /// Splits the text from `from` on at blanks; quotation marks join words.
    pub(crate) fn part_at_blanks(&mut self, from: usize) {
        let end = self.bytes.len();
        let mut at = from;
        loop {
            while at < end && self.bytes[at].is_ascii_whitespace() {
                at += 1;
            }
            if at == end {
                return;
            }
            let start = at;
            let mut open = self.bytes[at] == b'"';
            at += 1;
            while at < end && (open || !self.bytes[at].is_ascii_whitespace()) {
                open &= self.bytes[at] != b'"';
                at += 1;
            }
            self.push(start, at);
        }
    }
}

/// A source of the rows of a log, one after the other.
pub(crate) trait Rows {
    /// Reads the next row; false at the end. Remarks on the rows are added to `notes`.
    fn next(&mut self, row: &mut Row, notes: &mut Vec<Note>) -> Result<bool, ImportError>;
}
