//! Circles of files that import each other, found by reading the source.
//!
//! File A is tied to file B where a path in A leads to an item that B defines. Re-exports are followed to the
//! definition, so `pub use` in a `mod.rs` ties nobody; nor does `mod child;`. Test modules are left out.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use quote::ToTokens;
use syn::{Item, ItemMod, ItemUse, UseTree, Visibility};

use crate::paths::paths_in;

/// Names of a module path, from the root of the crate on.
type Names = Vec<String>;

/// What a module holds.
#[derive(Default)]
struct Module {
    /// Which file it stands in.
    file: usize,
    children: BTreeSet<String>,
    items: BTreeSet<String>,
    /// Names that `use` binds, with the path as it is written.
    imports: BTreeMap<String, Names>,
    /// Paths of `use path::*`.
    globs: Vec<Names>,
    /// Paths that the code follows.
    paths: Vec<Names>,
}

impl Module {
    /// Takes up the names of a `use`; those passed on by `pub use` go to `reexports`.
    fn import(&mut self, item: &ItemUse, reexports: &mut Vec<(String, Names)>) {
        let mut leaves = vec![];
        leaves_of(&item.tree, &[], &mut leaves);
        let is_public = !matches!(item.vis, Visibility::Inherited);
        for (name, path) in leaves {
            match name.as_str() {
                "*" if is_public => self.globs.push(path),
                "*" => {
                    self.globs.push(path.clone());
                    self.paths.push(path);
                }
                _ if is_public => reexports.push((name, path)),
                _ => {
                    self.imports.insert(name, path.clone());
                    self.paths.push(path);
                }
            }
        }
    }
}

/// The modules of a crate.
pub struct Crate {
    /// Its name in its own paths.
    name: String,
    files: Vec<PathBuf>,
    modules: BTreeMap<Names, Module>,
}

impl Crate {
    /// Reads the crate `name` whose root is the file `root`.
    ///
    /// # Errors
    /// Where a file cannot be read or is not Rust.
    pub fn read(name: &str, root: &Path) -> Result<Self, String> {
        let mut all = Self {
            name: name.to_string(),
            files: vec![],
            modules: BTreeMap::new(),
        };
        let folder = root.parent().unwrap_or(Path::new("")).to_path_buf();
        all.read_file(vec![], root, &folder)?;
        Ok(all)
    }

    /// Reads a module and its children; `folder` is where the files of children stand.
    fn read_file(&mut self, names: Names, path: &Path, folder: &Path) -> Result<(), String> {
        let at = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
        let text = std::fs::read_to_string(path).map_err(|error| at(&error))?;
        let parsed = syn::parse_file(&text).map_err(|error| at(&error))?;
        self.files.push(path.to_path_buf());
        let file = self.files.len() - 1;
        self.add(names, file, parsed.items, folder)
    }

    fn add(
        &mut self,
        names: Names,
        file: usize,
        items: Vec<Item>,
        folder: &Path,
    ) -> Result<(), String> {
        let mut module = Module {
            file,
            ..Module::default()
        };
        let (mut code, mut reexports) = (vec![], vec![]);
        for item in items {
            match item {
                Item::Use(item) => module.import(&item, &mut reexports),
                Item::Mod(item) if is_test(&item.attrs) => {}
                Item::Mod(item) => {
                    module.children.insert(item.ident.to_string());
                    self.add_child(&names, file, item, folder)?;
                }
                other => {
                    module.items.extend(name_of(&other));
                    code.push(other.to_token_stream());
                }
            }
        }
        let mut used = BTreeSet::new();
        for tokens in code {
            paths_in(tokens, &mut module.paths, &mut used);
        }
        // a name that is passed on ties only where the module uses it itself
        for (name, path) in reexports {
            if used.contains(&name) {
                module.paths.push(path.clone());
            }
            module.imports.insert(name, path);
        }
        self.modules.insert(names, module);
        Ok(())
    }

    /// Adds the module that an item of the module `names` declares, from the same file or from its own.
    fn add_child(
        &mut self,
        names: &[String],
        file: usize,
        item: ItemMod,
        folder: &Path,
    ) -> Result<(), String> {
        let name = item.ident.to_string();
        let child = [names, std::slice::from_ref(&name)].concat();
        let folder = folder.join(&name);
        let Some((_, items)) = item.content else {
            let own = folder.with_extension("rs");
            let path = if own.exists() {
                own
            } else {
                folder.join("mod.rs")
            };
            return self.read_file(child, &path, &folder);
        };
        self.add(child, file, items, &folder)
    }

    /// The file that defines what a path in the module `from` leads to; `None` outside the crate.
    fn file_of(&self, from: &[String], path: &[String], depth: usize) -> Option<usize> {
        let (first, rest) = path.split_first()?;
        let module = self.modules.get(from)?;
        if depth == 0 {
            return None;
        }
        match first.as_str() {
            "crate" => return self.file_of_absolute(&[], rest, depth),
            name if name == self.name => return self.file_of_absolute(&[], rest, depth),
            "self" => return self.file_of_absolute(from, rest, depth),
            "super" => {
                let (_, parent) = from.split_last()?;
                let rest = if rest.is_empty() {
                    return self.modules.get(parent).map(|m| m.file);
                } else {
                    rest
                };
                return match rest[0].as_str() {
                    "super" => self.file_of(parent, rest, depth - 1),
                    _ => self.file_of_absolute(parent, rest, depth),
                };
            }
            _ => {}
        }
        if module.children.contains(first) || module.imports.contains_key(first) && path.len() > 1 {
            return self.file_of_absolute(from, path, depth);
        }
        None
    }

    /// The same where the path begins in the module `from`.
    fn file_of_absolute(&self, from: &[String], path: &[String], depth: usize) -> Option<usize> {
        let module = self.modules.get(from)?;
        let Some((first, rest)) = path.split_first() else {
            return Some(module.file);
        };
        if depth == 0 {
            return None;
        }
        let is_last = rest.is_empty();
        if module.items.contains(first) && (is_last || !module.children.contains(first)) {
            return Some(module.file);
        }
        if module.children.contains(first) {
            let mut child = from.to_vec();
            child.push(first.clone());
            return self.file_of_absolute(&child, rest, depth);
        }
        if let Some(import) = module.imports.get(first) {
            let mut whole = import.clone();
            whole.extend_from_slice(rest);
            return self.file_of(from, &whole, depth - 1);
        }
        let behind = module.globs.iter().find_map(|glob| {
            let mut whole = glob.clone();
            whole.extend_from_slice(path);
            let file = self.file_of(from, &whole, depth - 1);
            file.filter(|_| self.defines(from, glob, first))
        });
        // what a macro defines stands in the module itself
        behind.or(Some(module.file))
    }

    /// Whether the module behind a glob has the name.
    fn defines(&self, from: &[String], glob: &[String], name: &str) -> bool {
        let start = match glob.first().map(String::as_str) {
            Some("crate") => Some((vec![], 1)),
            Some("self") => Some((from.to_vec(), 1)),
            Some("super") => from.split_last().map(|(_, parent)| (parent.to_vec(), 1)),
            _ => Some((from.to_vec(), 0)),
        };
        let Some((mut names, taken)) = start else {
            return false;
        };
        names.extend_from_slice(&glob[taken..]);
        let module = self.modules.get(&names);
        module.is_some_and(|module| {
            module.items.contains(name)
                || module.children.contains(name)
                || module.imports.contains_key(name)
        })
    }

    /// Which files each file is tied to.
    fn ties(&self) -> Vec<BTreeSet<usize>> {
        let mut ties = vec![BTreeSet::new(); self.files.len()];
        for (names, module) in &self.modules {
            for path in &module.paths {
                if let Some(file) = self.file_of(names, path, MOST_STEPS)
                    && file != module.file
                {
                    ties[module.file].insert(file);
                }
            }
        }
        ties
    }

    /// Groups of files each of which leads to all others, largest first.
    pub fn circles(&self) -> Vec<Vec<PathBuf>> {
        let ties = self.ties();
        let reached: Vec<_> = (0..ties.len()).map(|file| reached(&ties, file)).collect();
        let mut circles = vec![];
        let mut done = BTreeSet::new();
        for file in 0..ties.len() {
            let circle: Vec<usize> = (0..ties.len())
                .filter(|&other| reached[file].contains(&other) && reached[other].contains(&file))
                .collect();
            if circle.len() > 1 && done.insert(circle.clone()) {
                circles.push(
                    circle
                        .iter()
                        .map(|&file| self.files[file].clone())
                        .collect(),
                );
            }
        }
        circles.sort_by_key(|circle: &Vec<PathBuf>| std::cmp::Reverse(circle.len()));
        circles
    }

    /// Number of files.
    pub fn files(&self) -> usize {
        self.files.len()
    }
}

/// Most re-exports that a path may lead through.
const MOST_STEPS: usize = 16;

/// All files that one leads to.
fn reached(ties: &[BTreeSet<usize>], from: usize) -> BTreeSet<usize> {
    let (mut all, mut next) = (BTreeSet::new(), vec![from]);
    while let Some(file) = next.pop() {
        next.extend(ties[file].iter().filter(|&&to| all.insert(to)));
    }
    all
}

fn is_test(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        attribute.path().is_ident("cfg")
            && attribute
                .meta
                .to_token_stream()
                .to_string()
                .contains("test")
    })
}

/// Names that a `use` binds, with their paths; `*` for a glob.
fn leaves_of(tree: &UseTree, before: &[String], leaves: &mut Vec<(String, Names)>) {
    let with = |name: &syn::Ident| [before, &[name.to_string()]].concat();
    match tree {
        UseTree::Path(path) => leaves_of(&path.tree, &with(&path.ident), leaves),
        UseTree::Name(name) if name.ident == "self" => {
            let own = before.last().cloned().unwrap_or_default();
            leaves.push((own, before.to_vec()));
        }
        UseTree::Name(name) => leaves.push((name.ident.to_string(), with(&name.ident))),
        UseTree::Rename(name) => leaves.push((name.rename.to_string(), with(&name.ident))),
        UseTree::Glob(_) => leaves.push(("*".to_string(), before.to_vec())),
        UseTree::Group(group) => {
            for tree in &group.items {
                leaves_of(tree, before, leaves);
            }
        }
    }
}

fn name_of(item: &Item) -> Option<String> {
    let name = match item {
        Item::Const(item) => &item.ident,
        Item::Enum(item) => &item.ident,
        Item::Fn(item) => &item.sig.ident,
        Item::Macro(item) => item.ident.as_ref()?,
        Item::Static(item) => &item.ident,
        Item::Struct(item) => &item.ident,
        Item::Trait(item) => &item.ident,
        Item::Type(item) => &item.ident,
        Item::Union(item) => &item.ident,
        _ => return None,
    };
    Some(name.to_string())
}
