//! Circles between files: one uses an item of another, which uses the first, directly or through
//! others.
//!
//! Paths of imports and of the code are followed through re-exports to the module that has the
//! item, macros by their names. Methods of values are not, because this requires a compiler. A
//! module that only re-exports items does not use them. Code for tests does not count.

use std::{
    collections::{BTreeMap, BTreeSet, HashMap, VecDeque},
    path::Path,
    slice,
};

use proc_macro2::{Delimiter, TokenStream, TokenTree};

use crate::{
    command::{files, root},
    outcome::{Failure, Finding},
};

/// A module with its own file.
#[derive(Default)]
struct Module {
    /// Its file, from the folder of the sources.
    file: String,
    /// Its path in the crate.
    path: Vec<String>,
    /// Paths that it uses.
    used: Vec<Vec<String>>,
    /// Paths of imported and re-exported names.
    imports: HashMap<String, Vec<String>>,
    macros: Vec<String>,
}

/// No file uses another that, through others, uses it.
pub(crate) fn check() -> Result<Finding, Failure> {
    let mut found = Vec::new();
    let packages = root().join("crates").read_dir().map_err(Failure::at(&root()))?;
    for package in packages.flatten().map(|entry| entry.path()).chain([root().join("xtask")]) {
        let circles = circles(&package.join("src"))?;
        found.extend(circles.iter().map(|circle| format!("{}: {circle}", package.display())));
    }
    if found.is_empty() {
        return Ok(Finding::Done);
    }
    found.push("files use each other in circles: move the shared items to a separate file".into());
    Err(Failure::new(found.join("\n")))
}

/// The shortest circle through each file that is in one: `file -[items]-> file -[items]-> ...`.
fn circles(source: &Path) -> Result<BTreeSet<String>, Failure> {
    let mut modules = Vec::new();
    for (file, text) in files(source, "rs")? {
        let stream = text.parse::<TokenStream>();
        let stream =
            stream.map_err(|error| Failure::new(format!("{}: {error}", file.display())))?;
        let inside = file.strip_prefix(source).unwrap_or(&file).to_string_lossy();
        let path = inside.trim_end_matches(".rs").split(['/', '\\']).map(str::to_owned);
        let mut path: Vec<String> = path.collect();
        if path.iter().all(|part| part != "tests") {
            path.pop_if(|last| ["lib", "main", "mod"].contains(&last.as_str()));
            let mut module = Module { file: inside.into(), path, ..Module::default() };
            let mut words = Vec::new();
            flatten(stream, &mut words);
            module.read(&words);
            modules.push(module);
        }
    }
    let arrows = arrows(&modules);
    let in_words = |mut circle: Vec<usize>| {
        // Each circle once, from its first file on.
        let first = (0..circle.len()).min_by_key(|at| circle[*at]).unwrap_or(0);
        circle.rotate_left(first);
        circle.push(circle[0]);
        let arrow = |pair: &[usize]| {
            let names = arrows[&pair[0]][&pair[1]].iter().copied().collect::<Vec<_>>().join(", ");
            format!(" -[{names}]-> {}", modules[pair[1]].file)
        };
        modules[circle[0]].file.clone() + &circle.windows(2).map(arrow).collect::<String>()
    };
    Ok((0..modules.len()).filter_map(|file| circle(&arrows, file)).map(in_words).collect())
}

/// The shortest way from a file back to itself.
fn circle(arrows: &Arrows<'_>, start: usize) -> Option<Vec<usize>> {
    let mut ways = VecDeque::from([vec![start]]);
    let mut reached = BTreeSet::new();
    while let Some(way) = ways.pop_front() {
        for other in arrows.get(&way[way.len() - 1]).into_iter().flat_map(BTreeMap::keys) {
            if *other == start {
                return Some(way);
            }
            if reached.insert(*other) {
                ways.push_back([&way, slice::from_ref(other)].concat());
            }
        }
    }
    None
}

/// Names, `::` and single signs, without items for tests. Comments and literals are left out.
fn flatten(stream: TokenStream, words: &mut Vec<String>) {
    let mut trees = stream.into_iter().peekable();
    while let Some(tree) = trees.next() {
        match tree {
            TokenTree::Group(group) => {
                let [open, close] = match group.delimiter() {
                    Delimiter::Brace => ["{", "}"],
                    Delimiter::Bracket => ["[", "]"],
                    _ => ["(", ")"],
                };
                words.push(open.to_owned());
                flatten(group.stream(), words);
                words.push(close.to_owned());
            }
            TokenTree::Punct(sign) if sign.as_char() == '\'' => drop(trees.next()),
            TokenTree::Punct(sign) if sign.as_char() == ':' => {
                let twice = trees.next_if(|next| next.to_string() == ":").is_some();
                words.push(if twice { "::" } else { ":" }.to_owned());
            }
            TokenTree::Punct(sign) if sign.as_char() == '#' => {
                let attribute = trees.peek().map(ToString::to_string).unwrap_or_default();
                let attribute = attribute.replace(' ', "");
                let for_tests = ["[cfg(test", "[cfg(all(test", "[test]"];
                if for_tests.iter().any(|begin| attribute.starts_with(begin)) {
                    let ends = |tree: &TokenTree| match tree {
                        TokenTree::Group(group) => group.delimiter() == Delimiter::Brace,
                        sign => sign.to_string() == ";",
                    };
                    trees.by_ref().find(ends);
                }
            }
            TokenTree::Literal(_) => {}
            other => words.push(other.to_string()),
        }
    }
}

fn is_name(word: &str) -> bool {
    word.starts_with(|sign: char| sign.is_alphabetic() || sign == '_')
}

impl Module {
    /// Adds the paths of its file.
    fn read(&mut self, words: &[String]) {
        let word = |at: usize| words.get(at).map_or("", String::as_str);
        // Depth of the braces, and those of the modules within the file that are open.
        let (mut at, mut depth, mut inner) = (0, 0, Vec::new());
        while at < words.len() {
            let begin = at;
            match word(at) {
                "{" => depth += 1,
                "}" => {
                    inner.pop_if(|module| *module == depth);
                    depth -= 1;
                }
                "mod" if word(at + 2) == "{" || word(at + 1) == "$" => inner.push(depth + 1),
                "use" if word(at + 1) != "<" => {
                    at += words[at..].iter().position(|word| word == ";").unwrap_or(0);
                    let public = begin > 0 && ["pub", ")"].contains(&word(begin - 1));
                    self.import(&words[begin + 1..at], &[], public, inner.len());
                }
                "macro_rules" => self.macros.push(format!("{}!", word(at + 2))),
                name if is_name(name) => {
                    while word(at + 1) == "::" && is_name(word(at + 2)) {
                        at += 2;
                    }
                    let before = begin.checked_sub(1).map_or("", word);
                    let is_other = [".", "fn", "let", "mod"].contains(&before)
                        || before == "in" && word(begin - 2) == "(";
                    let is_type = name.starts_with(char::is_uppercase);
                    if word(at + 1) == "!" {
                        self.used.push(vec![format!("{}!", word(at))]);
                    } else if !is_other && (is_type || at > begin || word(at + 1) == "(") {
                        let path = words[begin..=at].iter().step_by(2).cloned().collect();
                        self.used.push(from_file(path, inner.len()));
                    }
                }
                _ => {}
            }
            at += 1;
        }
    }

    /// Adds `use prefix::{tree}`.
    fn import(&mut self, tree: &[String], prefix: &[String], public: bool, inner: usize) {
        let mut path = prefix.to_vec();
        let mut name = None;
        for (at, word) in tree.iter().enumerate() {
            match word.as_str() {
                "{" => {
                    let mut depth = 0;
                    let parts = tree[at + 1..tree.len() - 1].split(|word| {
                        depth += i32::from(word == "{") - i32::from(word == "}");
                        word == "," && depth == 0
                    });
                    return parts.for_each(|part| self.import(part, &path, public, inner));
                }
                "as" => name = tree.get(at + 1),
                "self" if !path.is_empty() => {}
                _ if name.is_none() && word != "::" => path.push(word.clone()),
                _ => {}
            }
        }
        if let Some(name) = name.or(path.last()).filter(|_| !tree.is_empty()) {
            if inner == 0 {
                self.imports.insert(name.clone(), path.clone());
            }
            self.used.extend(Some(from_file(path, inner)).filter(|_| !public));
        }
    }
}

/// A path in a module within the file, from the file on.
fn from_file(mut path: Vec<String>, inner: usize) -> Vec<String> {
    let within = path.iter().take(inner).take_while(|name| *name == "super").count();
    if within > 0 {
        path.splice(..within, ["self".to_owned()]);
    }
    path
}

/// For each file, the files that it uses, and the names of the items.
type Arrows<'a> = BTreeMap<usize, BTreeMap<usize, BTreeSet<&'a str>>>;

fn arrows(modules: &[Module]) -> Arrows<'_> {
    let mut arrows = Arrows::new();
    for (from, module) in modules.iter().enumerate() {
        for path in &module.used {
            let Some(last) = path.last() else { continue };
            let file = match find(modules, from, path, 0) {
                Some((file, is_item)) => Some(file).filter(|_| is_item),
                None if module.macros.contains(last) => None,
                None => modules.iter().position(|other| other.macros.contains(last)),
            };
            if let Some(file) = file.filter(|file| *file != from) {
                let item = path.iter().find(|name| name.starts_with(char::is_uppercase));
                let names = arrows.entry(from).or_default().entry(file).or_default();
                names.insert(item.unwrap_or(last));
            }
        }
    }
    arrows
}

/// The module of a path that a file names, and whether the path is that of an item in it.
fn find(modules: &[Module], from: usize, path: &[String], depth: usize) -> Option<(usize, bool)> {
    let named = |path: &[String]| modules.iter().position(|module| module.path == path);
    let mut at = from;
    for (place, name) in path.iter().enumerate() {
        let own = &modules[at].path;
        let child = named(&[own, slice::from_ref(name)].concat());
        at = match (name.as_str(), modules[at].imports.get(name)) {
            ("crate", _) => named(&[])?,
            ("self", _) => at,
            ("super", _) => named(own.split_last()?.1)?,
            // At the end of a path, an item takes precedence over a module of the same name.
            (_, import) if child.is_some() && (import.is_none() || place + 1 < path.len()) => {
                child?
            }
            (_, Some(import)) if depth < 8 => {
                let rest = [import, &path[place + 1..]].concat();
                return find(modules, at, &rest, depth + 1).or((place > 0).then_some((at, true)));
            }
            // Another crate, or an item of the language itself.
            _ if place == 0 => return None,
            _ => return Some((at, true)),
        };
    }
    Some((at, false))
}

#[cfg(test)]
mod tests {
    use std::{env, fs, process};

    use super::*;

    /// The circles in a crate with these files.
    fn circles_of(name: &str, files: &[(&str, &str)]) -> Vec<String> {
        let folder = env::temp_dir().join(format!("cycles-{}-{name}", process::id()));
        for (file, text) in files {
            let file = folder.join(file);
            fs::create_dir_all(file.parent().unwrap()).unwrap();
            fs::write(file, text).unwrap();
        }
        let found = circles(&folder).unwrap();
        fs::remove_dir_all(&folder).unwrap();
        found.into_iter().collect()
    }

    #[test]
    fn a_circle_is_named_with_its_items() {
        let found = circles_of(
            "circle",
            &[
                ("lib.rs", "mod rod; mod wall; mod well;"),
                ("rod.rs", "use crate::wall::{Wall, LIMIT as L}; pub struct Rod(Wall);"),
                (
                    "wall.rs",
                    "pub struct Wall; pub const LIMIT: u8 = 1; fn f() { super::well::g() }",
                ),
                ("well.rs", "pub fn g() { let _ = crate::rod::Rod::new(); }"),
            ],
        );
        assert_eq!(found, ["rod.rs -[LIMIT, Wall]-> wall.rs -[g]-> well.rs -[Rod]-> rod.rs"]);
    }

    #[test]
    fn no_circle_where_arrows_point_one_way() {
        let found = circles_of(
            "one-way",
            &[
                ("lib.rs", "mod rod; mod wall { pub mod contact; } mod well;"),
                ("well/mod.rs", "mod end; pub use end::g; fn f() { g() }"),
                ("well/end.rs", "use std::X; mod a { use super::X; pub fn g(_: super::X) {} }"),
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
        assert!(found.is_empty(), "{found:?}");
    }

    /// An item that a folder's `mod.rs` re-exports belongs to its child; one that it declares
    /// belongs to itself.
    #[test]
    fn re_exports_lead_to_the_file_that_declares() {
        let child = ("rod/b.rs", "use super::A; use crate::rod::C; pub struct B(A, C);");
        let (a, c) = (("rod/a.rs", "pub struct A;"), ("rod/c.rs", "pub struct C;"));
        let root = ("lib.rs", "pub mod rod; pub use rod::B;");
        let only = "mod a; mod b; mod c; pub use a::A; pub use b::B; pub use self::c::{C, C as D};";
        let found = circles_of("only", &[root, ("rod/mod.rs", only), a, child, c]);
        assert!(found.is_empty(), "{found:?}");

        let also = "mod a; mod b; pub use a::A; pub use b::B; pub struct C; fn f(_: B) {}";
        let found = circles_of("also", &[root, ("rod/mod.rs", also), a, child]);
        assert_eq!(found, ["rod/b.rs -[C]-> rod/mod.rs -[B]-> rod/b.rs"]);

        let through = ("rod/a.rs", "use crate::B; pub struct A(B);");
        let found = circles_of("through", &[root, ("rod/mod.rs", only), through, child, c]);
        assert_eq!(found, ["rod/a.rs -[B]-> rod/b.rs -[A]-> rod/a.rs"]);
    }

    #[test]
    fn globs_and_macros_are_followed() {
        let found = circles_of(
            "globs",
            &[
                ("main.rs", "#[macro_use] mod m; mod a; mod b;"),
                ("m.rs", "macro_rules! made { () => { $crate::a::A } } pub(crate) use made;"),
                ("a.rs", "use crate::b::*; pub struct A; fn f() { g() }"),
                ("b.rs", "pub fn g() { made!() }"),
            ],
        );
        assert_eq!(found, ["a.rs -[*]-> b.rs -[made!]-> m.rs -[A]-> a.rs"]);
    }
}
