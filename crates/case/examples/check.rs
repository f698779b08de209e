//! Checks case files: what `wholestring check` does, without the rest.
fn main() {
    for path in std::env::args().skip(1) {
        match wholestring_case::load(path.as_ref(), &[]) {
            Ok(case) => print!("{path}: sound\n{}", case.warnings.render(false)),
            Err(report) => print!("{}", report.render(false)),
        }
    }
}
