//! Speed of small motions about the string at rest, for its developers:
//! `cargo bench -p wholestring-vibration`.

#[path = "../../core/tests/common/mod.rs"]
mod common;
// Written for the tests of the dynamics.
#[allow(dead_code)]
#[path = "../../core/tests/dynamics/wells.rs"]
mod wells;

use std::{hint::black_box, time::Duration};

use criterion::{Criterion, criterion_group, criterion_main};
use wholestring::{dynamics::MeshSettings, statics::stiff::StiffSettings};
use wholestring_vibration::modal::{Family, SmallMotions};

use wells::np13;

/// Ten modes of NP13-X1042, all and of one family.
fn modes(criterion: &mut Criterion) {
    let case = np13(0.3);
    let mut group = criterion.benchmark_group("modes");
    let settings = StiffSettings {
        element_length: MeshSettings::uniform(3.2).element_length,
        ..StiffSettings::default()
    };
    let motions = SmallMotions::new(&case.model, &case.operation, &settings, &case.settings)
        .expect("a string at rest");
    group.bench_function("10 modes of NP13", |bencher| {
        bencher.iter(|| black_box(&motions).modes(0.0, 10));
    });
    for family in [Family::Axial, Family::Torsional] {
        group.bench_function(format!("10 {} modes of NP13", family.name()), |bencher| {
            bencher.iter(|| black_box(&motions).family(family, 10));
        });
    }
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default().measurement_time(Duration::from_secs(3));
    targets = modes
}
criterion_main!(benches);
