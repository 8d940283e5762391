//! The arguments of a node, by name.

use crate::error::Error;
use crate::parse::{Node, Value};

impl Node {
    /// The value of an argument that isn't `undef`.
    pub(crate) fn value(&self, name: &str) -> Option<&Value> {
        let mut named =
            self.arguments.iter().filter(|argument| argument.name.as_deref() == Some(name));
        named.next().map(|argument| &argument.value).filter(|value| **value != Value::Undefined)
    }

    /// A number, if it is there.
    pub(crate) fn number(&self, name: &str) -> Result<Option<f64>, Error> {
        match self.value(name) {
            None => Ok(None),
            Some(Value::Number(number)) if is_tame(*number) => Ok(Some(*number)),
            Some(_) => Err(self.wrong(name)),
        }
    }

    /// A number that must be there.
    pub(crate) fn finite(&self, name: &str) -> Result<f64, Error> {
        self.number(name)?.ok_or_else(|| self.wrong(name))
    }

    /// Whether it is there and true.
    pub(crate) fn is_set(&self, name: &str) -> bool {
        self.value(name) == Some(&Value::Bool(true))
    }

    /// A string, if it is there.
    pub(crate) fn text(&self, name: &str) -> Option<&str> {
        match self.value(name) {
            Some(Value::Text(text)) => Some(text),
            _ => None,
        }
    }

    /// A list of so many finite numbers.
    pub(crate) fn vector<const N: usize>(&self, name: &str) -> Result<[f64; N], Error> {
        self.value(name).and_then(Value::vector).ok_or_else(|| self.wrong(name))
    }

    /// How many facets a circle has, if it is meant to have facets: `$fn` from 3 to 8.
    pub(crate) fn facets(&self) -> Result<Option<usize>, Error> {
        let facets = self.number("$fn")?.unwrap_or(0.0);
        Ok((1.0..=8.0).contains(&facets).then_some((facets as usize).max(3)))
    }

    pub(crate) fn wrong(&self, name: &str) -> Error {
        Error::argument(
            self.line,
            format!("`{name}` of `{}` is missing or isn't what it should be", self.name),
        )
    }
}

/// Whether a number is one that lengths and coordinates may be: no part is larger than 10¹².
pub(crate) fn is_tame(number: f64) -> bool {
    number.abs() <= 1e12
}

impl Value {
    /// A finite number.
    pub(crate) fn finite(&self) -> Option<f64> {
        match self {
            Self::Number(number) if is_tame(*number) => Some(*number),
            _ => None,
        }
    }

    /// The values of a list.
    pub(crate) fn list(&self) -> Option<&[Value]> {
        match self {
            Self::List(values) => Some(values),
            _ => None,
        }
    }

    /// A list of so many finite numbers.
    pub(crate) fn vector<const N: usize>(&self) -> Option<[f64; N]> {
        let numbers: Option<Vec<f64>> = self.list()?.iter().map(Self::finite).collect();
        numbers?.try_into().ok()
    }
}
