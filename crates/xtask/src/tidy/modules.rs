//! The modules of a crate as its files declare them, and the names and paths in each. Read token by token: no macro is expanded, no type is known, and what is compiled for tests alone is left out.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use std::str::FromStr;

use anyhow::{Context, Result, anyhow};
use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// The texts of a crate's files by their paths from the folder of `lib.rs`, with forward slashes.
pub(super) struct Sources(BTreeMap<String, String>);

impl Sources {
    /// All below a folder.
    pub(super) fn read(folder: &Path) -> Result<Sources> {
        let mut texts = BTreeMap::new();
        for file in super::files_below(folder, "rs")? {
            let text = fs::read_to_string(&file).with_context(|| format!("cannot read {}", file.display()))?;
            texts.insert(super::relative(folder, &file), text);
        }
        Ok(Sources(texts))
    }

    #[cfg(test)]
    pub(super) fn of(texts: &[(&str, &str)]) -> Sources {
        Sources(texts.iter().map(|(file, text)| ((*file).to_owned(), (*text).to_owned())).collect())
    }
}

/// One module.
#[derive(Default)]
pub(super) struct Module {
    /// Its names from the root down; none for the root.
    pub(super) path: Vec<String>,
    /// The file that it is in.
    pub(super) file: String,
    pub(super) parent: Option<usize>,
    pub(super) children: BTreeMap<String, usize>,
    /// What it defines itself.
    pub(super) items: BTreeSet<String>,
    /// What it brings in from elsewhere under a name.
    pub(super) uses: Vec<Use>,
    /// What it brings in all names of.
    pub(super) globs: Vec<Mention>,
    /// Paths of two names and more in its code.
    pub(super) mentions: Vec<Mention>,
    /// Every single name in its code, outside of `use`.
    pub(super) words: BTreeSet<String>,
    /// Whether it does more than to declare modules and to bring in names.
    pub(super) has_code: bool,
}

/// A name that stands for a path.
pub(super) struct Use {
    pub(super) name: String,
    pub(super) path: Vec<String>,
    pub(super) line: usize,
    /// Whether others can have it from here.
    pub(super) is_public: bool,
}

/// A path and where it stands.
pub(super) struct Mention {
    pub(super) path: Vec<String>,
    pub(super) line: usize,
}

/// All modules of a crate, the root first.
pub(super) fn modules(sources: &Sources) -> Result<Vec<Module>> {
    let mut modules = vec![Module { file: "lib.rs".to_owned(), ..Module::default() }];
    read_file(sources, &mut modules, 0)?;
    Ok(modules)
}

fn read_file(sources: &Sources, modules: &mut Vec<Module>, at: usize) -> Result<()> {
    let file = modules[at].file.clone();
    let text = sources.0.get(&file).ok_or_else(|| anyhow!("no file {file}, though it is declared"))?;
    let tokens = TokenStream::from_str(text).map_err(|error| anyhow!("cannot read {file}: {error}"))?;
    let mut reader = Reader { sources, modules, at, is_outermost: true };
    reader.read(&tokens.into_iter().collect::<Vec<_>>())
}

struct Reader<'a> {
    sources: &'a Sources,
    modules: &'a mut Vec<Module>,
    at: usize,
    /// Not within a function, a type or a macro.
    is_outermost: bool,
}

impl Reader<'_> {
    fn read(&mut self, tokens: &[TokenTree]) -> Result<()> {
        let mut i = 0;
        let mut is_public = false;
        while i < tokens.len() {
            match &tokens[i] {
                TokenTree::Punct(punct) if punct.as_char() == '#' => {
                    let is_inner = is_punct(tokens.get(i + 1), '!');
                    let group = i + 1 + usize::from(is_inner);
                    let is_for_tests = !is_inner && tokens.get(group).is_some_and(is_test_attribute);
                    i = group + 1;
                    if is_for_tests {
                        i = after_item(tokens, i);
                    }
                    continue;
                }
                TokenTree::Ident(word) => {
                    let word = word.to_string();
                    let next = match word.as_str() {
                        "pub" => {
                            is_public = true;
                            // What is in `pub(in path)` is nothing imported.
                            i += 1 + usize::from(is_group(tokens.get(i + 1), Delimiter::Parenthesis));
                            continue;
                        }
                        "use" => self.read_use(tokens, i + 1, is_public),
                        "mod" if self.is_outermost => self.read_mod(tokens, i + 1)?,
                        _ => self.read_word(tokens, i, &word)?,
                    };
                    is_public = false;
                    i = next;
                    continue;
                }
                TokenTree::Group(group) => self.within(&group.stream())?,
                _ => {}
            }
            i += 1;
        }
        Ok(())
    }

    fn module(&mut self) -> &mut Module {
        &mut self.modules[self.at]
    }

    /// Reads what is between brackets of any kind.
    fn within(&mut self, tokens: &TokenStream) -> Result<()> {
        let was_outermost = std::mem::replace(&mut self.is_outermost, false);
        let read = self.read(&tokens.clone().into_iter().collect::<Vec<_>>());
        self.is_outermost = was_outermost;
        read
    }

    /// `mod name;` and `mod name { .. }`.
    fn read_mod(&mut self, tokens: &[TokenTree], i: usize) -> Result<usize> {
        let Some(TokenTree::Ident(name)) = tokens.get(i) else { return Ok(i) };
        let name = name.to_string();
        let (parent, child) = (self.at, self.modules.len());
        let path = [self.module().path.as_slice(), std::slice::from_ref(&name)].concat();
        self.module().children.insert(name, child);
        let module = Module { path: path.clone(), parent: Some(parent), ..Module::default() };
        match tokens.get(i + 1) {
            Some(TokenTree::Group(group)) => {
                let file = self.module().file.clone();
                self.modules.push(Module { file, ..module });
                let body: Vec<TokenTree> = group.stream().into_iter().collect();
                Reader { sources: self.sources, modules: self.modules, at: child, is_outermost: true }.read(&body)?;
            }
            _ => {
                let [alone, folder] = [format!("{}.rs", path.join("/")), format!("{}/mod.rs", path.join("/"))];
                let file = if self.sources.0.contains_key(&alone) { alone } else { folder };
                self.modules.push(Module { file, ..module });
                read_file(self.sources, self.modules, child)?;
            }
        }
        Ok(i + 2)
    }

    /// A definition, a path or a name.
    fn read_word(&mut self, tokens: &[TokenTree], i: usize, word: &str) -> Result<usize> {
        self.module().has_code = true;
        if self.is_outermost
            && let Some(name) = defined(tokens, i, word)
        {
            self.module().items.insert(name);
        }
        let line = tokens[i].span().start().line;
        let (path, next) = read_path(tokens, i);
        let follows_colons = i > 0 && is_punct(tokens.get(i - 1), ':') && i > 1 && is_punct(tokens.get(i - 2), ':');
        if !follows_colons {
            self.module().words.insert(word.to_owned());
            if path.len() > 1 {
                self.module().mentions.push(Mention { path, line });
            }
        }
        Ok(next)
    }

    /// The tree of a `use` up to its semicolon.
    fn read_use(&mut self, tokens: &[TokenTree], i: usize, is_public: bool) -> usize {
        let end = (i..tokens.len()).find(|&k| is_punct(tokens.get(k), ';')).unwrap_or(tokens.len());
        self.read_tree(&tokens[i..end], &[], is_public);
        end + 1
    }

    fn read_tree(&mut self, tokens: &[TokenTree], before: &[String], is_public: bool) {
        let Some(first) = tokens.first() else { return };
        let line = first.span().start().line;
        let (path, next) = match first {
            TokenTree::Ident(_) => read_path(tokens, 0),
            _ => (Vec::new(), 0),
        };
        let path: Vec<String> = before.iter().cloned().chain(path).collect();
        let rest = &tokens[next..];
        let rest = if is_punct(rest.first(), ':') && is_punct(rest.get(1), ':') { &rest[2..] } else { rest };
        match rest {
            [TokenTree::Punct(star)] if star.as_char() == '*' => self.module().globs.push(Mention { path, line }),
            [TokenTree::Group(group)] => {
                let inner: Vec<TokenTree> = group.stream().into_iter().collect();
                for branch in inner.split(|token| is_punct(Some(token), ',')) {
                    self.read_tree(branch, &path, is_public);
                }
            }
            rest => {
                let mut path = path;
                // `use path::{self}` names the path itself.
                if path.len() > 1 && path.last().is_some_and(|last| last == "self") {
                    path.pop();
                }
                let alias = match rest {
                    [TokenTree::Ident(word), TokenTree::Ident(alias)] if *word == "as" => Some(alias.to_string()),
                    _ => None,
                };
                if let Some(name) = alias.or_else(|| path.last().cloned()) {
                    self.module().uses.push(Use { name, path, line, is_public });
                }
            }
        }
    }
}

/// The names of `a::b::c` from a place on, and the place after them.
fn read_path(tokens: &[TokenTree], i: usize) -> (Vec<String>, usize) {
    let mut path = vec![tokens[i].to_string()];
    let mut next = i + 1;
    while is_punct(tokens.get(next), ':') && is_punct(tokens.get(next + 1), ':') {
        let Some(TokenTree::Ident(name)) = tokens.get(next + 2) else { break };
        path.push(name.to_string());
        next += 3;
    }
    (path, next)
}

/// The name that an item defines, if a word begins one.
fn defined(tokens: &[TokenTree], i: usize, word: &str) -> Option<String> {
    let at = match word {
        "fn" | "struct" | "enum" | "union" | "trait" | "type" | "const" | "static" => i + 1,
        "macro_rules" if is_punct(tokens.get(i + 1), '!') => i + 2,
        _ => return None,
    };
    match tokens.get(at) {
        // `const fn` comes by again as `fn`.
        Some(TokenTree::Ident(name)) if *name != "fn" && *name != "unsafe" => Some(name.to_string()),
        _ => None,
    }
}

/// `[cfg(test)]`, and `[cfg(all(test, ..))]`.
fn is_test_attribute(token: &TokenTree) -> bool {
    let text: String = token.to_string().split_whitespace().collect();
    text == "[cfg(test)]" || text.starts_with("[cfg(all(test,")
}

/// The place after an item, whose attributes may go on: its semicolon or its body in braces.
fn after_item(tokens: &[TokenTree], from: usize) -> usize {
    (from..tokens.len())
        .find(|&i| is_punct(tokens.get(i), ';') || is_group(tokens.get(i), Delimiter::Brace))
        .map_or(tokens.len(), |end| end + 1)
}

fn is_punct(token: Option<&TokenTree>, c: char) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if punct.as_char() == c)
}

fn is_group(token: Option<&TokenTree>, delimiter: Delimiter) -> bool {
    matches!(token, Some(TokenTree::Group(group)) if group.delimiter() == delimiter)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lib(text: &str) -> Module {
        modules(&Sources::of(&[("lib.rs", text)])).unwrap().swap_remove(0)
    }

    fn uses(text: &str) -> Vec<String> {
        lib(text).uses.iter().map(|found| format!("{} = {}", found.name, found.path.join("::"))).collect()
    }

    #[test]
    fn trees_of_use() {
        assert_eq!(uses("use a::b;"), ["b = a::b"]);
        assert_eq!(uses("use a::{self, b::{c, d as e}, f};"), ["a = a", "c = a::b::c", "e = a::b::d", "f = a::f"]);
        assert_eq!(uses("fn f() { use a::B; }"), ["B = a::B"]);
        assert!(lib("pub(crate) use a::b;").uses[0].is_public && !lib("pub fn f() {} use a::b;").uses[0].is_public);
        assert_eq!(lib("use super::*;").globs[0].path, ["super"]);
    }

    #[test]
    fn definitions_and_paths() {
        let module = lib(
            "pub(in crate::x) const fn a() -> b::C { d!(crate::e::F::g()) } struct H<T>(T); macro_rules! i { () => { $crate::j::k } }",
        );
        assert_eq!(Vec::from_iter(&module.items), ["H", "a", "i"]);
        let paths: Vec<String> = module.mentions.iter().map(|mention| mention.path.join("::")).collect();
        assert_eq!(paths, ["b::C", "crate::e::F::g", "crate::j::k"]);
    }

    #[test]
    fn comments_strings_and_tests_are_no_code() {
        let text = "/// See [`crate::a::B`].\n// crate::c::D\nconst E: &str = \"crate::f::G\";\n#[cfg(test)]\n#[allow(x)]\nmod tests { use super::h::I; }\n#[cfg(test)] use j::K;";
        let module = lib(text);
        assert!(module.mentions.is_empty() && module.uses.is_empty() && module.children.is_empty());
        assert_eq!(uses("#[cfg(not(test))] use a::b;"), ["b = a::b"]);
    }

    #[test]
    fn files_are_found_as_rust_finds_them() {
        let sources = [
            ("lib.rs", "mod a; mod b { mod c; pub struct D; }"),
            ("a/mod.rs", "mod e;"),
            ("a/e.rs", ""),
            ("b/c.rs", ""),
        ];
        let modules = modules(&Sources::of(&sources)).unwrap();
        let files: Vec<(String, &str)> =
            modules.iter().map(|module| (module.path.join("::"), module.file.as_str())).collect();
        let expected = [("", "lib.rs"), ("a", "a/mod.rs"), ("a::e", "a/e.rs"), ("b", "lib.rs"), ("b::c", "b/c.rs")];
        assert_eq!(files, expected.map(|(path, file)| (path.to_owned(), file)));
        assert!(super::modules(&Sources::of(&[("lib.rs", "mod a;")])).is_err());
    }
}
