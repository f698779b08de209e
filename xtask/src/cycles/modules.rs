//! The modules of a crate, and which file declares the item that a path names.

use std::{
    collections::{BTreeMap, BTreeSet, HashMap, HashSet},
    fs, io,
    path::{Path, PathBuf},
};

use super::tokens::tokens;

/// For each pair of files, one using items of the other: the names used.
pub type Arrows = BTreeMap<(usize, usize), BTreeSet<String>>;

#[derive(Default)]
struct Module {
    file: usize,
    parent: usize,
    children: HashMap<String, usize>,
    declared: HashSet<String>,
    imported: HashMap<String, Vec<String>>,
    globs: Vec<Vec<String>>,
    used: Vec<Vec<String>>,
}

enum Found {
    Module(usize),
    /// An item, by the file that declares it.
    Item(usize),
}

/// A crate, from its root file on; code compiled only for tests is left out.
#[derive(Default)]
pub struct Modules {
    pub files: Vec<PathBuf>,
    modules: Vec<Module>,
    macros: HashMap<String, usize>,
}

impl Modules {
    /// Reads the crate whose root is `file`.
    pub fn read(file: &Path) -> io::Result<Self> {
        let mut all = Self::default();
        let folder = file.parent().unwrap_or(Path::new("")).to_owned();
        all.read_file(file.to_owned(), folder, 0)?;
        Ok(all)
    }

    fn read_file(&mut self, file: PathBuf, folder: PathBuf, parent: usize) -> io::Result<usize> {
        let words = tokens(&fs::read_to_string(&file)?)
            .map_err(|error| io::Error::other(format!("{}: {error}", file.display())))?;
        let beside = file.parent().unwrap_or(Path::new("")).to_owned();
        self.files.push(file);
        let module = self.module(self.files.len() - 1, parent);
        self.scan(&words, module, &folder, &beside)?;
        Ok(module)
    }

    fn module(&mut self, file: usize, parent: usize) -> usize {
        let module = Module { file, parent, ..Module::default() };
        self.modules.push(module);
        self.modules.len() - 1
    }

    /// Adds the items and paths of a module. `folder` contains the files of its children.
    fn scan(
        &mut self,
        words: &[String],
        at: usize,
        folder: &Path,
        beside: &Path,
    ) -> io::Result<()> {
        let word = |index: usize| words.get(index).map_or("", String::as_str);
        let (mut i, mut depth, mut path) = (0, 0_usize, None);
        while i < words.len() {
            let next = word(i + 1);
            match word(i) {
                "#" if next == "[" || (next == "!" && word(i + 2) == "[") => {
                    let end = block_end(words, i);
                    let attribute = words[i..end].concat();
                    if let Some((_, value)) = attribute.split_once("[path=\"") {
                        path = Some(beside.join(value.trim_end_matches("\"]")));
                    }
                    let for_tests = ["#[cfg(test)", "#[cfg(all(test,", "#[test]"];
                    let for_tests = for_tests.iter().any(|start| attribute.starts_with(start));
                    i = if for_tests { item_end(words, end) } else { end };
                    continue;
                }
                "mod" if word(i + 2) == ";" => {
                    let file = path.take().unwrap_or_else(|| child_file(folder, next));
                    let own = match file.file_stem() {
                        Some(stem) if stem != "mod" => file.with_file_name(stem),
                        _ => file.with_file_name(""),
                    };
                    let child = self.read_file(file, own, at)?;
                    self.modules[at].children.insert(next.to_owned(), child);
                    i += 2;
                }
                "mod" if word(i + 2) == "{" => {
                    let end = block_end(words, i + 2);
                    let child = self.module(self.modules[at].file, at);
                    self.modules[at].children.insert(next.to_owned(), child);
                    self.scan(&words[i + 3..end - 1], child, &folder.join(next), beside)?;
                    i = end - 1;
                }
                "use" if next != "<" => {
                    let end = i + words[i..].iter().take_while(|&sign| sign != ";").count();
                    let public = i > 0 && (word(i - 1) == "pub" || word(i - 1) == ")");
                    self.import(&words[i + 1..end], &[], at, public);
                    i = end;
                }
                "macro_rules" => {
                    self.macros.insert(word(i + 2).to_owned(), self.modules[at].file);
                    i += 2;
                }
                "fn" | "struct" | "enum" | "trait" | "type" | "const" | "static" if depth == 0 => {
                    self.modules[at].declared.insert(next.to_owned());
                    i += usize::from(next != "fn");
                }
                "{" => depth += 1,
                "}" => depth = depth.saturating_sub(1),
                first if is_name(first) => {
                    let begin = i;
                    while word(i + 1) == "::" && is_name(word(i + 2)) {
                        i += 2;
                    }
                    let of_value = begin > 0 && matches!(word(begin - 1), "." | "fn" | "let");
                    let named = first.starts_with(char::is_uppercase)
                        || i > begin
                        || matches!(word(i + 1), "(" | "!" | "::");
                    if named && !of_value {
                        let path = words[begin..=i].iter().step_by(2).cloned().collect();
                        self.modules[at].used.push(path);
                    }
                }
                _ => {}
            }
            i += 1;
        }
        Ok(())
    }

    /// Adds `use prefix::{tree}`. A re-export is not a use.
    fn import(&mut self, tree: &[String], prefix: &[String], at: usize, public: bool) {
        let mut path = prefix.to_vec();
        let mut name = None;
        for (i, word) in tree.iter().enumerate() {
            match word.as_str() {
                "{" => {
                    let inner = &tree[i + 1..tree.len() - 1];
                    let (mut begin, mut depth) = (0, 0);
                    for (j, word) in inner.iter().enumerate() {
                        depth += i32::from(word == "{") - i32::from(word == "}");
                        if word == "," && depth == 0 {
                            self.import(&inner[begin..j], &path, at, public);
                            begin = j + 1;
                        }
                    }
                    return self.import(&inner[begin..], &path, at, public);
                }
                "*" => return self.modules[at].globs.push(path),
                "as" => name = tree.get(i + 1).cloned(),
                "self" if !path.is_empty() => {}
                word if name.is_none() && is_name(word) => path.push(word.to_owned()),
                _ => {}
            }
        }
        if path.len() == prefix.len() && tree.is_empty() {
            return;
        }
        if !public {
            self.modules[at].used.push(path.clone());
        }
        if let Some(name) = name.or_else(|| path.last().cloned()) {
            self.modules[at].imported.insert(name, path);
        }
    }

    /// Items of each file used by each other file.
    pub fn arrows(&self) -> Arrows {
        let mut arrows = Arrows::new();
        for (at, module) in self.modules.iter().enumerate() {
            for path in &module.used {
                let found = self.find(at, path, &mut HashSet::new());
                let file = match (found, path.last()) {
                    (Some(Found::Item(file)), _) => file,
                    (None, Some(name)) if self.macros.contains_key(name) => self.macros[name],
                    _ => continue,
                };
                if file != module.file {
                    let names = arrows.entry((module.file, file)).or_default();
                    // Of `Type::function`, the type.
                    let named = path.iter().find(|name| name.starts_with(char::is_uppercase));
                    names.insert(named.or(path.last()).cloned().unwrap_or_default());
                }
            }
        }
        arrows
    }

    fn find(&self, from: usize, path: &[String], seen: &mut Seen) -> Option<Found> {
        let mut at = from;
        for (i, name) in path.iter().enumerate() {
            at = match name.as_str() {
                "crate" => 0,
                "self" => at,
                "super" => self.modules[at].parent,
                _ => match self.look(at, name, i + 1 == path.len(), seen) {
                    Some(Found::Module(module)) => module,
                    Some(item) => return Some(item),
                    // Another crate, or an item of the language itself.
                    None if i == 0 => return None,
                    // An item generated by a macro.
                    None => return Some(Found::Item(self.modules[at].file)),
                },
            }
        }
        Some(Found::Module(at))
    }

    /// Meaning of a name in a module: an item takes precedence over a module of that name at the
    /// end of a path.
    fn look(&self, at: usize, name: &str, last: bool, seen: &mut Seen) -> Option<Found> {
        let module = &self.modules[at];
        let child = module.children.get(name).map(|&child| Found::Module(child));
        if child.is_some() && !last {
            return child;
        }
        if module.declared.contains(name) {
            return Some(Found::Item(module.file));
        }
        if !seen.insert((at, name.to_owned())) {
            return child;
        }
        if let Some(path) = module.imported.get(name) {
            let found = if path.len() == 1 && path[0] == name {
                self.macros.get(name).map(|&file| Found::Item(file))
            } else {
                self.find(at, path, seen)
            };
            return found.or(child);
        }
        child.or_else(|| {
            module.globs.iter().find_map(|glob| {
                let Some(Found::Module(other)) = self.find(at, glob, seen) else {
                    return None;
                };
                self.look(other, name, last, seen)
            })
        })
    }
}

type Seen = HashSet<(usize, String)>;

fn is_name(word: &str) -> bool {
    word.starts_with(|sign: char| sign.is_alphabetic() || sign == '_')
}

fn child_file(folder: &Path, name: &str) -> PathBuf {
    let flat = folder.join(format!("{name}.rs"));
    if flat.is_file() {
        return flat;
    }
    folder.join(name).join("mod.rs")
}

/// Index after the bracket that closes the first one from here on.
fn block_end(words: &[String], from: usize) -> usize {
    let mut depth = 0;
    for (i, word) in words.iter().enumerate().skip(from) {
        match word.as_str() {
            "{" | "[" | "(" => depth += 1,
            "}" | "]" | ")" => depth -= 1,
            _ => continue,
        }
        if depth == 0 {
            return i + 1;
        }
    }
    words.len()
}

/// Index after the item that begins here: after its semicolon, or its body in braces.
fn item_end(words: &[String], from: usize) -> usize {
    let mut i = from;
    while i < words.len() {
        match words[i].as_str() {
            ";" => return i + 1,
            "{" => return block_end(words, i),
            "(" | "[" => i = block_end(words, i),
            _ => i += 1,
        }
    }
    words.len()
}
