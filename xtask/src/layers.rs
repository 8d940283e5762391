//! The order of the crate's layers, and whether its files keep to it: a file imports from its own
//! layer and from lower ones, and no two files import from each other, in however many steps.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// The folders of `src/`, the lowest first. What isn't here (`error.rs`, say) is beside them: all may
/// import it, and it imports none of them.
const LAYERS: [&str; 15] = [
    "numeric",
    "scalar",
    "span",
    "geom",
    "quadric",
    "spline",
    "scan",
    "query",
    "primitive",
    "solid",
    "program",
    "inspect",
    "render",
    "stream",
    "interop",
];

/// A module's path within the crate, and paths of what is in it.
type Module = Vec<String>;

#[derive(Default)]
struct File {
    /// What the file uses. What it only hands on with `pub use` isn't here.
    imports: Vec<Module>,
    /// Names that stand for something in another module.
    names: BTreeMap<String, Module>,
}

type Files = BTreeMap<Module, File>;

/// Every import that goes up, and every circle, in words.
pub fn problems(src: &Path) -> Result<Vec<String>, String> {
    let mut files = Files::new();
    read(src, &[], &mut files)?;
    let targets = |(module, file): (&Module, &File)| {
        let targets = file.imports.iter().map(|path| resolve(&files, path, 8));
        // The crate's root has macros only.
        let targets = targets.filter(|target| target != module && !target.is_empty()).collect();
        (module.clone(), targets)
    };
    let edges: BTreeMap<Module, BTreeSet<Module>> = files.iter().map(targets).collect();
    let reached: BTreeMap<&Module, BTreeSet<&Module>> =
        edges.keys().map(|module| (module, reachable(&edges, module))).collect();
    let (mut problems, mut circles) = (Vec::new(), BTreeSet::new());
    for (module, far) in reached.iter().filter(|(module, _)| !module.is_empty()) {
        for target in edges.get(*module).into_iter().flatten() {
            if layer(target) > layer(module) {
                let [from, to] = [module, target].map(|module| module.join("::"));
                problems.push(format!("{from} imports from above: {to}"));
            }
        }
        let comes_back =
            |other: &&&Module| reached.get(**other).is_some_and(|far| far.contains(module));
        let circle: Vec<String> =
            far.iter().filter(comes_back).map(|module| module.join("::")).collect();
        if !circle.is_empty() {
            circles.insert(circle);
        }
    }
    problems.extend(circles.iter().map(|circle| format!("a circle: {}", circle.join(", "))));
    Ok(problems)
}

fn layer(module: &Module) -> Option<usize> {
    LAYERS.iter().position(|name| module.first().is_some_and(|first| first == name))
}

fn reachable<'a>(
    edges: &'a BTreeMap<Module, BTreeSet<Module>>,
    from: &'a Module,
) -> BTreeSet<&'a Module> {
    let (mut found, mut open) = (BTreeSet::new(), vec![from]);
    while let Some(module) = open.pop() {
        open.extend(edges.get(module).into_iter().flatten().filter(|next| found.insert(*next)));
    }
    found
}

/// The module whose file has what a path leads to. Names that other modules hand on are followed.
fn resolve(files: &Files, path: &[String], most: u32) -> Module {
    let is_file = |length: &usize| path.get(..*length).is_some_and(|path| files.contains_key(path));
    let length = (0..=path.len()).rev().find(is_file).unwrap_or(0);
    let (module, rest) = path.split_at(length);
    let name = rest.split_first().and_then(|(name, rest)| {
        let target = files.get(module)?.names.get(name)?;
        Some([target.as_slice(), rest].concat())
    });
    match name {
        Some(path) if most > 0 => resolve(files, &path, most - 1),
        _ => module.to_vec(),
    }
}

fn read(folder: &Path, module: &[String], files: &mut Files) -> Result<(), String> {
    let text = |error: std::io::Error| format!("{}: {error}", folder.display());
    for entry in fs::read_dir(folder).map_err(text)? {
        let path = entry.map_err(text)?.path();
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let child = [module, std::slice::from_ref(&stem)].concat();
        if path.is_dir() {
            read(&path, &child, files)?;
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let module = if stem == "lib" || stem == "mod" { module.to_vec() } else { child };
            let file = parse(&fs::read_to_string(&path).map_err(text)?, &module);
            files.insert(module, file);
        }
    }
    Ok(())
}

/// What a file imports, tests and comments left out.
fn parse(text: &str, module: &[String]) -> File {
    let code = text.split("#[cfg(test)]\nmod ").next().unwrap_or_default();
    let lines = code.lines().map(|line| line.split("//").next().unwrap_or_default());
    let code = lines.collect::<Vec<_>>().join("\n").replace("::", "\u{1}");
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    let mut tokens: Vec<String> = Vec::new();
    let mut was_name = false;
    for c in code.chars() {
        match tokens.last_mut() {
            Some(last) if was_name && is_name(c) => last.push(c),
            _ if !c.is_whitespace() => tokens.push(c.to_string()),
            _ => {}
        }
        was_name = is_name(c);
    }
    let (mut file, mut rest, mut before) = (File::default(), tokens.as_slice(), "");
    while let Some((token, behind)) = rest.split_first() {
        rest = behind;
        let is_path = ["crate", "super"].contains(&&**token)
            && behind.first().is_some_and(|next| next == "\u{1}");
        if token == "use" {
            let mut found = Vec::new();
            rest = tree(behind, &[], &mut found);
            for (name, path) in found {
                let path = absolute(&path, module);
                if !["pub", ")"].contains(&before) {
                    file.imports.push(path.clone());
                }
                file.names.insert(name, path);
            }
        } else if is_path && !["in", "\u{1}"].contains(&before) {
            let names =
                behind.iter().take_while(|next| *next == "\u{1}" || next.starts_with(is_name));
            let path = std::iter::once(token).chain(names.filter(|next| *next != "\u{1}"));
            file.imports.push(absolute(&path.cloned().collect::<Vec<_>>(), module));
        }
        before = token;
    }
    file
}

/// The tree of a `use` as names and their paths; returns what is behind it.
fn tree<'a>(
    tokens: &'a [String],
    stem: &[String],
    found: &mut Vec<(String, Module)>,
) -> &'a [String] {
    let (mut path, mut alias, mut rest) = (stem.to_vec(), None, tokens);
    while let Some((token, behind)) = rest.split_first() {
        match token.as_str() {
            "," | "}" | ";" => break,
            "\u{1}" => {}
            "as" => alias = behind.first(),
            "{" => {
                rest = behind;
                while rest.first().is_some_and(|next| next != "}") {
                    rest = tree(rest, &path, found);
                    rest = rest.strip_prefix(&[",".to_owned()]).unwrap_or(rest);
                }
                return rest.get(1..).unwrap_or_default();
            }
            _ if alias.is_none() && token != "self" || path.is_empty() => path.push(token.clone()),
            _ => {}
        }
        rest = behind;
    }
    found.extend(alias.or(path.last()).cloned().map(|name| (name, path)));
    rest
}

/// From the crate's root; a name of another crate becomes one of nothing in this module.
fn absolute(path: &[String], module: &[String]) -> Module {
    match path.split_first() {
        Some((first, rest)) if first == "crate" => rest.to_vec(),
        Some((first, rest)) if first == "self" => [module, rest].concat(),
        Some((first, rest)) if first == "super" => {
            let parent = module.split_last().map_or(module, |(_, parent)| parent);
            match rest.first() {
                Some(next) if next == "super" => absolute(rest, parent),
                _ => [parent, rest].concat(),
            }
        }
        _ => [module, path].concat(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn strings(names: &[&str]) -> Module {
        names.iter().map(|name| (*name).to_owned()).collect()
    }

    #[test]
    fn imports_are_found_in_trees_and_in_code() {
        let text = "pub use leaf::Leaf;\nuse super::{a::{B, self}, c as d};\nuse crate::span::*;\n\
                    fn f() { crate::geom::vec3(1) } // crate::no\n#[cfg(test)]\nmod tests { use crate::no; }";
        let file = parse(text, &strings(&["solid", "mine"]));
        let paths = ["solid::a::B", "solid::a", "solid::c", "span::*", "geom::vec3"];
        assert_eq!(file.imports.iter().map(|path| path.join("::")).collect::<Vec<_>>(), paths);
        assert_eq!(file.names.get("d"), Some(&strings(&["solid", "c"])));
        assert_eq!(file.names.get("Leaf"), Some(&strings(&["solid", "mine", "leaf", "Leaf"])));
    }

    #[test]
    fn names_that_are_handed_on_are_followed() {
        let mut files = Files::new();
        let text = "pub use leaf::Leaf;";
        files.insert(strings(&["solid"]), parse(text, &strings(&["solid"])));
        files.insert(strings(&["solid", "leaf"]), File::default());
        assert_eq!(resolve(&files, &strings(&["solid", "Leaf", "NEW"]), 8), ["solid", "leaf"]);
        assert_eq!(resolve(&files, &strings(&["solid", "Other"]), 8), ["solid"]);
    }
}
