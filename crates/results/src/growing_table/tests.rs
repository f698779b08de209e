use super::*;
use crate::{CONTACT, TIME};

fn append(table: &mut GrowingTable, operation: &str, from: f64) {
    let numbers = [from, from + 1.0, f64::NAN];
    let words: [(&str, &[&str]); 1] = [("operation", &[operation])];
    table.waiting.append(&words, &[("time_s", &numbers), ("md_m", &numbers)]);
    table.written = false;
}

fn all(folder: &ResultsFolder) -> (Vec<u8>, Vec<u8>, Table) {
    let read = |name: &str| std::fs::read(folder.path().join(name)).unwrap();
    let table = Table::read_parquet(&folder.path().join("contact.parquet")).unwrap();
    (read("contact.parquet"), read("contact.csv"), table)
}

fn folder() -> (tempfile::TempDir, ResultsFolder) {
    let place = tempfile::tempdir().unwrap();
    let folder = ResultsFolder::create(place.path()).unwrap();
    (place, folder)
}

/// Rows in parts equal one table that is held as a whole.
#[test]
fn rows_that_came_in_parts_are_those_of_one_table() {
    let (_place, folder) = folder();
    // A file of an earlier run is not part of it.
    let mut table = GrowingTable::begin("contact", CONTACT);
    append(&mut table, "earlier", 100.0);
    table.write(&folder, true).unwrap();
    let mut table = GrowingTable::begin("contact", CONTACT);
    table.write(&folder, true).unwrap();
    assert_eq!(all(&folder).2.rows(), 0);
    let mut whole = Table::with_columns(CONTACT);
    for (operation, from) in [("trip_in", 1.0), ("drill", 5.0), ("slide", 9.0)] {
        append(&mut table, operation, from);
        let numbers = [from, from + 1.0, f64::NAN];
        whole.append(&[("operation", &[operation])], &[("time_s", &numbers), ("md_m", &numbers)]);
        table.write(&folder, true).unwrap();
        assert_eq!(table.waiting.rows(), 0);
    }
    let (_, csv, read) = all(&folder);
    assert_eq!(read, whole);
    whole.write_csv(&folder.path().join("whole.csv")).unwrap();
    assert_eq!(csv, std::fs::read(folder.path().join("whole.csv")).unwrap());
    table.write(&folder, false).unwrap();
    assert!(!folder.path().join("contact.csv").exists());
}

/// A run that was killed after it had written more than its checkpoint contains writes the same
/// again.
#[test]
fn a_resumed_table_has_the_same_bytes() {
    let (_place, folder) = folder();
    let mut table = GrowingTable::begin("contact", CONTACT);
    append(&mut table, "trip_in", 1.0);
    table.write(&folder, true).unwrap();
    append(&mut table, "drill", 5.0);
    let checkpoint = postcard::to_stdvec(&table.so_far()).unwrap();
    table.write(&folder, true).unwrap();
    append(&mut table, "slide", 9.0);
    table.write(&folder, true).unwrap();
    let whole = all(&folder);
    let so_far: TableSoFar = postcard::from_bytes(&checkpoint).unwrap();
    let mut resumed = GrowingTable::begin("contact", CONTACT);
    resumed.resume(&folder, so_far).unwrap();
    resumed.write(&folder, true).unwrap();
    assert_eq!(all(&folder).2.rows(), 6);
    append(&mut resumed, "slide", 9.0);
    resumed.write(&folder, true).unwrap();
    assert!(all(&folder) == whole);
    // A file that lost rows is reported.
    let path = folder.path().join("contact.parquet");
    let refused = |checkpoint: &[u8], reason: &str| {
        let so_far = postcard::from_bytes(checkpoint).unwrap();
        let mut table = GrowingTable::begin("contact", CONTACT);
        let error = table.resume(&folder, so_far).unwrap_err().to_string();
        assert!(error.contains(reason), "{error}");
    };
    GrowingTable::begin("contact", CONTACT).write(&folder, false).unwrap();
    refused(&checkpoint, "contact.parquet is not a file of results");
    Table::with_columns(TIME).write_parquet(&path).unwrap();
    refused(&checkpoint, "contact.parquet is not a file of results");
    std::fs::write(&path, "PAR1").unwrap();
    refused(&checkpoint, "contact.parquet is not a file of results");
    std::fs::remove_file(&path).unwrap();
    refused(&checkpoint, "contact.parquet");
    let other = GrowingTable::begin("contact", TIME);
    let other = postcard::to_stdvec(&other.so_far()).unwrap();
    refused(&other, "its table `contact`");
}

/// Rows that were written to the disk in parts are those of one table, also where a run was killed
/// after it had written more parts than its checkpoint contains, or had joined them.
#[test]
fn parts_are_rows_of_the_table_wherever_it_is_resumed() {
    let (_place, folder) = folder();
    let rows = |from: f64| {
        let numbers = [from, from + 1.0, f64::NAN];
        move |table: &mut Table| {
            table.append(&[("operation", &["drill"])], &[("time_s", &numbers), ("md_m", &numbers)]);
        }
    };
    let mut table = GrowingTable::begin("contact", CONTACT);
    append(&mut table, "trip_in", 1.0);
    table.write(&folder, true).unwrap();
    table.append_part(&folder, rows(5.0)).unwrap();
    let checkpoint = postcard::to_stdvec(&table.so_far()).unwrap();
    table.append_part(&folder, rows(9.0)).unwrap();
    append(&mut table, "drill", 13.0);
    assert_eq!((table.last_part(), table.rows().rows()), ((2, 2), 3));
    table.write(&folder, true).unwrap();
    append(&mut table, "slide", 17.0);
    table.write(&folder, true).unwrap();
    let whole = all(&folder);
    let first = |row: usize| whole.2.numbers("time_s").unwrap()[3 * row].unwrap();
    assert_eq!([0, 1, 2, 3, 4].map(first), [1.0, 5.0, 9.0, 13.0, 17.0]);
    assert_eq!(whole.2.rows(), 15);

    let mut resumed = GrowingTable::begin("contact", CONTACT);
    resumed.resume(&folder, postcard::from_bytes(&checkpoint).unwrap()).unwrap();
    assert!(!resumed.part_path(&folder, 2).exists());
    resumed.append_part(&folder, rows(9.0)).unwrap();
    append(&mut resumed, "drill", 13.0);
    resumed.write(&folder, true).unwrap();
    let joined = postcard::to_stdvec(&resumed.so_far()).unwrap();
    append(&mut resumed, "slide", 17.0);
    resumed.write(&folder, true).unwrap();
    assert!(all(&folder) == whole);
    let mut resumed = GrowingTable::begin("contact", CONTACT);
    resumed.resume(&folder, postcard::from_bytes(&joined).unwrap()).unwrap();
    append(&mut resumed, "slide", 17.0);
    resumed.write(&folder, true).unwrap();
    assert!(all(&folder) == whole);
    // A part that is missing is reported.
    std::fs::remove_file(resumed.part_path(&folder, 1)).unwrap();
    let mut table = GrowingTable::begin("contact", CONTACT);
    let error = table.resume(&folder, postcard::from_bytes(&checkpoint).unwrap()).unwrap_err();
    assert!(error.to_string().contains("000001.parquet"), "{error}");
}

/// A run without table output keeps its rows in memory, except those in the file that the
/// checkpoint of a run with output requires.
#[test]
fn a_table_that_is_left_out_can_still_be_resumed() {
    let (_place, folder) = folder();
    let there = || folder.path().join("contact.parquet").exists();
    let mut table = GrowingTable::begin("contact", CONTACT);
    append(&mut table, "trip_in", 1.0);
    table.write(&folder, true).unwrap();
    let checkpoint = postcard::to_stdvec(&table.so_far()).unwrap();
    let mut resumed = GrowingTable::begin("contact", CONTACT);
    resumed.resume(&folder, postcard::from_bytes(&checkpoint).unwrap()).unwrap();
    append(&mut resumed, "drill", 5.0);
    resumed.leave_out(&folder).unwrap();
    assert!(there() && !folder.path().join("contact.csv").exists());
    append(&mut table, "drill", 5.0);
    table.write(&folder, true).unwrap();
    let whole = all(&folder);
    resumed.write(&folder, true).unwrap();
    assert!(all(&folder) == whole);
    // A run that starts again needs none of the existing files.
    let mut table = GrowingTable::begin("contact", CONTACT);
    append(&mut table, "drill", 5.0);
    table.leave_out(&folder).unwrap();
    assert!(!there());
    assert_eq!(table.waiting.rows(), 3);
}
