use std::{env, fs, path::PathBuf, process};

use super::in_words;

/// The circles in a repository of one crate with these files.
fn circles_of(name: &str, files: &[(&str, &str)]) -> String {
    let root: PathBuf = env::temp_dir().join(format!("cycles-{}-{name}", process::id()));
    for (file, text) in files {
        let file = root.join("crates/one/src").join(file);
        fs::create_dir_all(file.parent().unwrap()).unwrap();
        fs::write(file, text).unwrap();
    }
    let found = in_words(&root).unwrap();
    fs::remove_dir_all(&root).unwrap();
    found
}

#[test]
fn a_circle_is_named_with_what_ties_it() {
    let found = circles_of(
        "circle",
        &[
            ("lib.rs", "mod rod; mod wall; mod well;"),
            ("rod.rs", "use crate::wall::{Wall, LIMIT as L}; pub struct Rod(Wall);"),
            ("wall.rs", "pub struct Wall; pub const LIMIT: u8 = 1; fn f() { super::well::g() }"),
            ("well.rs", "pub fn g() { let _ = crate::rod::Rod::new(); }"),
        ],
    );
    assert_eq!(
        found,
        "crates/one/src/lib.rs: 3 files in circles\n    rod.rs -[LIMIT, Wall]-> wall.rs -[g]-> \
         well.rs -[Rod]-> rod.rs\n"
    );
}

#[test]
fn no_circle_where_arrows_point_one_way() {
    let found = circles_of(
        "one-way",
        &[
            ("lib.rs", "mod rod; mod wall { pub mod contact; }"),
            ("rod.rs", "use crate::wall::contact; fn f() { contact::g() }"),
            (
                "wall/contact.rs",
                "//! crate::rod::f\n/* use crate::rod::f; */ pub fn g() { \"crate::rod::f\"; '\"'; }
                 pub fn h<'a>(x: &'a str) { r#\"crate::rod::f\"#; }
                 #[cfg(test)] mod tests { use crate::rod::f; fn t() { f() } }
                 #[cfg(test)] use crate::rod::f;",
            ),
        ],
    );
    assert_eq!(found, "");
}

/// An item that a folder's `mod.rs` re-exports belongs to its child; one that it declares belongs
/// to itself.
#[test]
fn re_exports_lead_to_the_file_that_declares() {
    let child = ("rod/b.rs", "use super::A; use crate::rod::C; pub struct B(A, C);");
    let (a, c) = (("rod/a.rs", "pub struct A;"), ("rod/c.rs", "pub struct C;"));
    let root = ("lib.rs", "pub mod rod; pub use rod::B;");
    let only = "mod a; mod b; mod c; pub use a::A; pub use b::*; pub use self::c::{C, C as D};";
    let found = circles_of("handed-on", &[root, ("rod/mod.rs", only), a, child, c]);
    assert_eq!(found, "");

    let also = "mod a; mod b; mod c; pub use a::A; pub use b::B; pub struct C; fn f(_: B) {}";
    let found = circles_of("its-own", &[root, ("rod/mod.rs", also), a, child, c]);
    assert_eq!(
        found,
        "crates/one/src/lib.rs: 2 files in circles\n    rod/mod.rs -[B]-> rod/b.rs -[C]-> \
         rod/mod.rs\n"
    );

    let through = ("rod/a.rs", "use crate::B; pub struct A(B);");
    let found = circles_of("through", &[root, ("rod/mod.rs", only), through, child, c]);
    assert_eq!(
        found,
        "crates/one/src/lib.rs: 2 files in circles\n    rod/a.rs -[B]-> rod/b.rs -[A]-> rod/a.rs\n"
    );
}

#[test]
fn globs_and_macros_are_followed() {
    let found = circles_of(
        "globs",
        &[
            ("main.rs", "#[macro_use] mod m; mod a; mod b; mod c;"),
            ("m.rs", "macro_rules! made { () => { $crate::a::A } } pub(crate) use made;"),
            ("a.rs", "use crate::b::*; pub struct A; fn f() { g() }"),
            ("b.rs", "pub fn g() { made!() }"),
            ("c.rs", "use crate::m::made; use crate::b::*;"),
        ],
    );
    assert_eq!(
        found,
        "crates/one/src/main.rs: 3 files in circles\n    m.rs -[A]-> a.rs -[g]-> b.rs -[made]-> \
         m.rs\n"
    );
}
