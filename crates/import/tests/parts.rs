//! Cases of several files.

use wholestring_import::{Choices, Imported, Input, import};

const PLAN: &[u8] = b"MD (m),Inc (deg),Azi (deg)\n0,0,0\n500,0,0\n600,5,10\n";
const GYRO: &[u8] = b"MD (m),Inc (deg),Azi (deg)\n0,0,0\n500,0,0\n610,6,20\n";
const TALLY: &[u8] =
    b"Component,OD (in),ID (in),Length (m)\nBit,8.5,2,0.3\nDC,6.5,2.25,90\nDP,5,4.276,to surface\n";

fn of(files: &[(&str, &[u8])], choices: &Choices) -> Result<Imported, String> {
    let files = files.iter().map(|(name, bytes)| Input::of_bytes(*name, bytes)).collect();
    import(files, choices).map_err(|error| error.to_string())
}

#[test]
fn a_part_that_two_files_hold_is_picked() {
    let files = [("plan.csv", PLAN), ("runs/gyro.csv", GYRO), ("bha.csv", TALLY)];
    assert_eq!(
        of(&files, &Choices::default()).unwrap_err(),
        "runs/gyro.csv: it holds the survey, and so does plan.csv; pick one: --pick survey=plan.csv"
    );
    // By its full path, or by the last component of it.
    for (picked, depth, other) in [
        ("plan.csv", "[600, 5, 10]", "runs/gyro.csv"),
        ("runs/gyro.csv", "[610, 6, 20]", "plan.csv"),
        ("gyro.csv", "[610, 6, 20]", "plan.csv"),
    ] {
        let imported = of(&files, &Choices::default().pick("survey", picked)).unwrap();
        assert!(imported.text.contains(depth), "{picked}: {}", imported.text);
        let left_out = format!("the survey, because that of {picked} was picked");
        let note = imported.notes.iter().find(|(_, note)| note.text() == left_out);
        let (file, note) = note.unwrap_or_else(|| panic!("{:?}", imported.notes));
        assert_eq!((file.as_deref(), note.kind()), (Some(other), "left out"));
        // A part that only one file contains needs no choice.
        assert!(imported.text.contains("[[string]]"));
    }
    assert_eq!(
        of(&files, &Choices::default().pick("survey", "bha.csv")).unwrap_err(),
        "plan.csv, runs/gyro.csv: there is no survey 'bha.csv'; it holds: 'plan.csv', \
         'runs/gyro.csv'"
    );
}
