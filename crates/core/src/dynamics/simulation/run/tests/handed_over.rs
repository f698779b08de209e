//! A run whose samples are kept by somebody else.

use super::*;
use crate::outcome::{EarlierRows, TIME_SERIES};

/// Rows that were handed over, in the stretches in which they were: columns by their names.
#[derive(Debug, Default)]
struct Kept(Vec<Vec<(&'static str, Vec<f64>)>>);

impl Kept {
    /// Takes so many rows of a run as often as it can spare them.
    fn take(&mut self, run: &mut Run<f64>, rows: usize) {
        while run.spare_rows() >= rows {
            let columns = TIME_SERIES.iter().map(|column| {
                let values = (column.of)(run.series());
                (column.quantity.name, values.numbers()[..rows].to_vec())
            });
            self.0.push(columns.collect());
            run.hand_over(rows);
        }
    }
}

impl EarlierRows for Kept {
    fn rows(&self) -> usize {
        self.0.iter().map(|columns| columns[0].1.len()).sum()
    }

    fn each(&self, columns: &[&'static str], from: usize, take: &mut dyn FnMut(&[&[f64]])) {
        let mut first = 0;
        for block in &self.0 {
            let rows = block[0].1.len();
            let skipped = from.saturating_sub(first).min(rows);
            let values = columns.iter().map(|name| {
                let column = block.iter().find(|(known, _)| known == name);
                &column.expect("it is a column of the series").1[skipped..]
            });
            take(&values.collect::<Vec<_>>());
            first += rows;
        }
    }
}

/// The answer of a run that hands its samples over has the bits of one that keeps them, settles at
/// the same sample, and holds no more of them than it needs; also where it is resumed.
#[test]
fn who_keeps_the_samples_makes_no_difference() {
    for (settings, waits) in [
        (DynamicsSettings { settle_s: 1.0, ..DynamicsSettings::default() }, false),
        (
            DynamicsSettings { steady: Some(Default::default()), ..DynamicsSettings::default() },
            true,
        ),
    ] {
        let mut plain = new_run(&model(0.25), &REAM, &settings);
        let mut hands_over = plain.clone();
        let mut storage = Kept::default();
        let mut turns = 0;
        while turns < 5 || waits && plain.is_settling() {
            assert!(turns < 200, "it settles");
            plain.advance(0.7).unwrap();
            hands_over.advance(0.7).unwrap();
            storage.take(&mut hands_over, 16);
            turns += 1;
        }
        for run in [&mut plain, &mut hands_over] {
            run.advance(2.0).unwrap();
        }
        storage.take(&mut hands_over, 16);
        assert_eq!(plain.frame(), hands_over.frame());
        let all = plain.series().time_s.len();
        let left = hands_over.series().time_s.len();
        assert_eq!((left + storage.rows(), hands_over.handed_over()), (all, storage.rows()));
        assert!(left <= 17, "{left} of {all}");
        let [expected, mut found] = [plain.outcome(), hands_over.outcome_with(&storage)];
        assert_eq!(expected.series.hook_load_N[all - left..], found.series.hook_load_N);
        found.series = expected.series.clone();
        assert!(expected.indicators.stick_slip.is_some());
        assert_eq!(format!("{expected:?}"), format!("{found:?}"));

        let bytes = postcard::to_stdvec(&hands_over.checkpoint()).unwrap();
        let read = postcard::from_bytes(&bytes).unwrap();
        let mut resumed = Run::resume(&plain.model, &REAM, &settings, read).unwrap();
        for run in [&mut plain, &mut resumed] {
            run.advance(0.5).unwrap();
        }
        storage.take(&mut resumed, 16);
        let [expected, found] = [plain.outcome(), resumed.outcome_with(&storage)];
        assert_eq!(format!("{:?}", expected.statistics), format!("{:?}", found.statistics));
        // Forgotten are those that were handed over, too.
        resumed.forget(resumed.time_s());
        plain.forget(plain.time_s());
        assert_eq!((resumed.handed_over(), resumed.series()), (0, plain.series()));
        let [expected, found] = [plain.outcome(), resumed.outcome()];
        assert_eq!(format!("{:?}", expected.statistics), format!("{:?}", found.statistics));
    }
}
