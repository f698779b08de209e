//! Parts of the case that a plan leaves out or takes otherwise, in phrases.

use wholestring::outcome::ModelKind;
use wholestring_case::Case;

/// Models and operations of the case that the plan does not compute, and an assumed rotary speed.
pub(super) fn left_out(case: &Case) -> Vec<String> {
    let plan = &case.plan;
    let computed = |model: &ModelKind| plan.models.iter().any(|own| own.name() == model.name());
    let models = case.models.iter().filter(|model| !model.in_time() && !computed(model));
    let models = models.map(|model| {
        let long_name = model.method().long_name;
        format!("torque and drag by the {long_name} (`plan.models` does not list it)")
    });
    let planned = |kind| plan.operations.iter().any(|operation| operation.kind == kind);
    let operations = case.operations.iter().filter(|own| !planned(own.kind));
    let operations = operations.map(|own| {
        let (words, name) = (own.kind.words(), own.kind.name());
        format!("{words} (`plan.operations` does not list `{name}`)")
    });
    let turned = case.operations.iter().any(|own| own.rotary_speed_rad_per_s > 0.0);
    let assumed = plan.operations.iter().filter(|operation| operation.kind.rotates() && !turned);
    let assumed = assumed.map(|operation| {
        let rpm = operation.rotary_speed_rad_per_s * 30.0 / std::f64::consts::PI;
        let words = operation.kind.words();
        format!("rotary speed of {words} (the case has no `rpm`: {rpm:.0} rpm is used)")
    });
    models.chain(operations).chain(assumed).collect()
}
