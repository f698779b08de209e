//! A case for fewer operations equals the one read from its text.

use std::path::Path;

use wholestring::{operation::OperationKind, outcome::ModelKind};
use wholestring_case::{Case, Override, Template};

const STATICS: [&[ModelKind]; 4] = [
    &[ModelKind::Soft],
    &[ModelKind::Stiff],
    &[ModelKind::Soft, ModelKind::Stiff],
    &[ModelKind::Stiff, ModelKind::Soft],
];

fn change(text: &str) -> Override {
    text.parse().expect("KEY=VALUE")
}

/// The same from the text.
fn read(template: &Template, models: &[ModelKind], only: Option<OperationKind>) -> Case {
    let names: Vec<String> = models.iter().map(|model| format!("{:?}", model.name())).collect();
    let mut changes = vec![change(&format!("model=[{}]", names.join(", ")))];
    changes.extend(only.map(|only| change(&format!("operation.kind={:?}", only.name()))));
    // A plan of operations that the case no longer has would be invalid.
    if let Some(only) = only {
        changes.push(change(&format!("plan.operations=[{:?}]", only.name())));
    }
    template.case(&changes).expect("a valid case")
}

#[test]
fn every_case_that_ships_is_narrowed_as_its_text_would_be() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let mut compared = 0;
    for shipped in wholestring_cases::ALL {
        let path = folder.join(shipped.file_name);
        let template = Template::read(&path).unwrap();
        let case = template.case(&[]).unwrap();
        let kinds = case.operations.iter().map(|operation| Some(operation.kind));
        for only in kinds.chain([None]) {
            for models in STATICS {
                let Some(ours) = case.narrowed(models, only) else { continue };
                let theirs = read(&template, models, only);
                let what = format!("{}, {only:?}, {models:?}", path.display());
                assert_eq!(ours.settings, theirs.settings, "{what}");
                assert_eq!(ours.identity(), theirs.identity(), "{what}");
                assert_eq!(ours.name, theirs.name);
                compared += 1;
            }
        }
    }
    assert!(compared > 40, "{compared}");
}

#[test]
fn what_only_the_text_can_tell_is_left_to_it() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases");
    let template = Template::read(&folder.join("slant.toml")).unwrap();
    let case = template.case(&[]).unwrap();
    let soft: &[ModelKind] = &[ModelKind::Soft];
    assert!(case.narrowed(soft, Some(OperationKind::Drill)).is_some());
    assert!(case.narrowed(&[], None).is_none());
    assert!(case.narrowed(&[ModelKind::Soft, ModelKind::Soft], None).is_none());
    assert!(case.narrowed(&[ModelKind::Dynamic], None).is_none());
    assert!(case.narrowed(&[ModelKind::Soft, ModelKind::Dynamic], None).is_none());
    assert!(case.narrowed(soft, Some(OperationKind::BackReam)).is_none());
    let scheduled = Template::read(&folder.join("well-b-1714.toml")).unwrap().case(&[]).unwrap();
    assert!(scheduled.narrowed(soft, None).is_none());
    let rock = Template::read(&folder.join("rock-300.toml")).unwrap().case(&[]).unwrap();
    assert!(rock.bit_test.is_some() && rock.narrowed(soft, None).is_none());
}
