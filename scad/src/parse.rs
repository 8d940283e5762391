//! From text to nodes.

use crate::error::Error;
use crate::token::{Token, Word, tokens};
use std::iter::Peekable;
use std::vec::IntoIter;

/// The deepest nesting of nodes. Real files have up to 190 levels.
const MOST_LEVELS: usize = 2_000;

/// The deepest nesting of lists in an argument.
const MOST_LISTS: usize = 16;

/// A value of an argument.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// `undef`.
    Undefined,
    /// `true` or `false`.
    Bool(bool),
    /// A number.
    Number(f64),
    /// A string.
    Text(String),
    /// A list of values.
    List(Vec<Value>),
}

/// An argument of a node.
#[derive(Debug, Clone, PartialEq)]
pub struct Argument {
    /// Its name. An argument by position has none.
    pub name: Option<String>,
    /// Its value.
    pub value: Value,
}

/// The characters that may stand before a node.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Modifiers {
    /// `%` and `*`: the node is no operand.
    pub is_absent: bool,
    /// `!`: the node is the whole part.
    pub is_root: bool,
}

/// `name(arguments) { children }`
#[derive(Debug, Clone, PartialEq)]
pub struct Node {
    /// What it is.
    pub name: String,
    /// Its arguments.
    pub arguments: Vec<Argument>,
    /// Its children. Those that are no operands are among them.
    pub children: Vec<Node>,
    /// What stands before it.
    pub modifiers: Modifiers,
    /// The line of its name, counted from 1.
    pub line: usize,
}

/// The nodes of a `.csg` file.
///
/// ```
/// let nodes = scancsg_scad::parse("group() {\n\tcube(size = [1, 2, 3], center = false);\n}")?;
/// assert_eq!(nodes[0].children[0].line, 2);
/// # Ok::<(), scancsg_scad::Error>(())
/// ```
///
/// # Errors
/// [`Error`], for text that isn't of that form.
pub fn parse(text: &str) -> Result<Vec<Node>, Error> {
    let mut words = Words { rest: tokens(text)?.into_iter().peekable(), line: 1 };
    // Levels of nodes whose children aren't complete; the first is the file itself.
    let mut open = vec![Vec::new()];
    let mut parents: Vec<Node> = Vec::new();
    while !words.is_at_end() {
        if words.skips('}') {
            let line = words.line;
            let (Some(children), Some(mut node)) = (open.pop(), parents.pop()) else {
                return Err(Error::syntax(line, "a `}` without its `{`"));
            };
            node.children = children;
            place(node, &mut open);
        } else if !words.skips(';') {
            let node = words.head()?;
            if words.skips('{') {
                parents.push(node);
                open.push(Vec::new());
                if open.len() > MOST_LEVELS {
                    return Err(Error::syntax(words.line, "nodes are nested too deeply"));
                }
            } else {
                words.expect(';')?;
                place(node, &mut open);
            }
        }
    }
    match (parents.pop(), open.pop()) {
        (None, Some(nodes)) => Ok(nodes),
        (node, _) => Err(Error::syntax(node.map_or(0, |node| node.line), "a `{` without its `}`")),
    }
}

fn place(node: Node, open: &mut [Vec<Node>]) {
    if let Some(level) = open.last_mut() {
        level.push(node);
    }
}

struct Words {
    rest: Peekable<IntoIter<Token>>,
    /// That of the last word.
    line: usize,
}

impl Words {
    fn is_at_end(&mut self) -> bool {
        self.rest.peek().is_none()
    }

    fn next(&mut self) -> Option<Word> {
        let token = self.rest.next()?;
        self.line = token.line;
        Some(token.word)
    }

    /// Goes past a sign if it is next.
    fn skips(&mut self, sign: char) -> bool {
        let found = self.rest.next_if(|token| token.word == Word::Sign(sign));
        if let Some(token) = &found {
            self.line = token.line;
        }
        found.is_some()
    }

    fn expect(&mut self, sign: char) -> Result<(), Error> {
        if self.skips(sign) {
            return Ok(());
        }
        let line = self.rest.peek().map_or(self.line, |token| token.line);
        let there = match self.next() {
            None => "the file ends".into(),
            Some(Word::Name(name) | Word::Text(name)) => format!("`{name}` is there"),
            Some(Word::Number(number)) => format!("{number} is there"),
            Some(Word::Sign(sign)) => format!("`{sign}` is there"),
        };
        Err(Error::syntax(line, format!("`{sign}` was expected, but {there}")))
    }

    /// A node's modifiers, name and arguments.
    fn head(&mut self) -> Result<Node, Error> {
        let mut modifiers = Modifiers::default();
        loop {
            match self.next() {
                Some(Word::Sign('%' | '*')) => modifiers.is_absent = true,
                Some(Word::Sign('!')) => modifiers.is_root = true,
                Some(Word::Sign('#')) => {}
                Some(Word::Name(name)) => {
                    let line = self.line;
                    let arguments = self.arguments()?;
                    return Ok(Node { name, arguments, children: Vec::new(), modifiers, line });
                }
                _ => return Err(Error::syntax(self.line, "the name of a node was expected")),
            }
        }
    }

    fn arguments(&mut self) -> Result<Vec<Argument>, Error> {
        self.expect('(')?;
        let mut arguments = Vec::new();
        while !self.skips(')') {
            let value = self.value(0)?;
            let argument = match value {
                (Value::Text(name), true) if self.skips('=') => {
                    Argument { name: Some(name), value: self.value(0)?.0 }
                }
                (value, _) => Argument { name: None, value },
            };
            arguments.push(argument);
            if !self.skips(',') {
                self.expect(')')?;
                break;
            }
        }
        Ok(arguments)
    }

    /// A value, and whether it is a bare name.
    fn value(&mut self, depth: usize) -> Result<(Value, bool), Error> {
        match self.next() {
            Some(Word::Number(number)) => Ok((Value::Number(number), false)),
            Some(Word::Text(text)) => Ok((Value::Text(text), false)),
            Some(Word::Name(name)) => Ok(match name.as_str() {
                "undef" => (Value::Undefined, false),
                "true" => (Value::Bool(true), false),
                "false" => (Value::Bool(false), false),
                "inf" => (Value::Number(f64::INFINITY), false),
                "nan" => (Value::Number(f64::NAN), false),
                _ => (Value::Text(name), true),
            }),
            Some(Word::Sign('[')) if depth < MOST_LISTS => {
                let mut list = Vec::new();
                while !self.skips(']') {
                    list.push(self.value(depth + 1)?.0);
                    // A range is written `[first : step : last]`. No node that is modelled has one.
                    if !self.skips(',') && !self.skips(':') {
                        self.expect(']')?;
                        break;
                    }
                }
                Ok((Value::List(list), false))
            }
            _ => Err(Error::syntax(self.line, "a value was expected")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Value, parse};

    #[test]
    fn arguments_and_children_and_modifiers() -> Result<(), crate::Error> {
        let nodes = parse(
            "%a(1, k = [[1], undef, true], t = \"x\");\n#b() {\n !c(-inf);\n *d() {\n }\n;}\n",
        )?;
        assert_eq!(nodes.len(), 2);
        assert!(nodes[0].modifiers.is_absent);
        assert_eq!(nodes[0].arguments[0].value, Value::Number(1.0));
        let list = vec![Value::List(vec![Value::Number(1.0)]), Value::Undefined, Value::Bool(true)];
        assert_eq!(nodes[0].arguments[1].name.as_deref(), Some("k"));
        assert_eq!(nodes[0].arguments[1].value, Value::List(list));
        let [c, d] = &nodes[1].children[..] else {
            return Err(crate::Error::limit("two children"));
        };
        assert!(c.modifiers.is_root && !c.modifiers.is_absent && d.modifiers.is_absent);
        assert_eq!((c.line, d.line), (3, 4));
        Ok(())
    }

    #[test]
    fn errors_name_the_line() {
        for (text, line) in [
            ("a(", 1),
            ("a()\n{", 1),
            ("\n}", 2),
            ("a();\nb() 3;", 2),
            ("a(1 2);", 1),
            ("a();\n\n=", 3),
            ("a([1 2]);", 1),
        ] {
            assert_eq!(parse(text).map_err(|error| error.line), Err(line), "{text}");
        }
    }

    /// Without recursion: neither does a deep file need a large stack, nor its tree.
    #[test]
    fn deep_nesting_is_an_error() {
        assert!(parse(&"a() {".repeat(100_000)).is_err());
        assert!(parse(&format!("a({});", "[".repeat(100_000))).is_err());
    }
}
