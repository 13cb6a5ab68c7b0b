//! A value of a document that knows its path.

use super::{Code, DocumentError, Json};
use crate::geom::Full;
use std::fmt::Write;
use std::ops::RangeInclusive;

/// A value in a document. Reading from it fails with the path of the field, what was found and what was expected.
#[derive(Clone, Copy)]
pub(crate) struct Node<'a> {
    value: &'a Json,
    place: Place<'a>,
}

/// How a value is reached; the path is spelt out only for an error.
#[derive(Clone, Copy)]
enum Place<'a> {
    Root(&'a str),
    Field(&'a Node<'a>, &'a str),
    Index(&'a Node<'a>, usize),
}

impl<'a> Node<'a> {
    /// A whole document (named with an empty text) or another whole value with its name.
    pub(crate) fn root(value: &'a Json, name: &'a str) -> Self {
        Self { value, place: Place::Root(name) }
    }

    /// Refuses a value that is no object, or has a field that is not among `known`.
    pub(crate) fn only(&self, known: &[&str]) -> Result<(), DocumentError> {
        let unknown = self.fields()?.iter().find(|(name, _)| !known.contains(&name.as_str()));
        unknown.map_or(Ok(()), |(name, value)| {
            let node = Node { value, place: Place::Field(self, name) };
            Err(node.error(Code::UnknownField, format!("there is no such field; expected {}", one_of(known))))
        })
    }

    /// A field that may be left out.
    pub(crate) fn get(&'a self, name: &'a str) -> Result<Option<Node<'a>>, DocumentError> {
        let value = self.fields()?.iter().rev().find(|(key, _)| key == name);
        Ok(value.map(|(_, value)| Node { value, place: Place::Field(self, name) }))
    }

    /// A field that must be there.
    pub(crate) fn need(&'a self, name: &'a str) -> Result<Node<'a>, DocumentError> {
        self.get(name)?.ok_or_else(|| {
            let node = Node { value: &Json::Null, place: Place::Field(self, name) };
            node.error(Code::Missing, "this field is required".to_owned())
        })
    }

    /// The fields of an object with their names.
    #[cfg(feature = "part")]
    pub(crate) fn entries(&'a self) -> Result<Vec<(&'a str, Node<'a>)>, DocumentError> {
        let entry = |(name, value): &'a (String, Json)| {
            (name.as_str(), Node { value, place: Place::Field(self, name) })
        };
        Ok(self.fields()?.iter().map(entry).collect())
    }

    /// The items of a list.
    pub(crate) fn items(&'a self) -> Result<Vec<Node<'a>>, DocumentError> {
        let Json::List(values) = self.value else { return Err(self.expected("a list")) };
        let node = |(index, value)| Node { value, place: Place::Index(self, index) };
        Ok(values.iter().enumerate().map(node).collect())
    }

    /// Two numbers.
    pub(crate) fn pair(&self) -> Result<[f64; 2], DocumentError> {
        match self.value {
            Json::List(values) if values.len() == 2 => {
                let number =
                    |index: usize| Node { value: &values[index], place: Place::Index(self, index) }.number();
                Ok([number(0)?, number(1)?])
            }
            _ => Err(self.expected("two numbers")),
        }
    }

    /// Tells whether the value is a list of so many items.
    pub(crate) fn has_length(&self, length: usize) -> bool {
        matches!(self.value, Json::List(values) if values.len() == length)
    }

    /// Three numbers in a range.
    #[cfg(feature = "solid")]
    pub(crate) fn triple(&self, range: RangeInclusive<f64>) -> Result<[f64; 3], DocumentError> {
        match self.value {
            Json::List(values) if values.len() == 3 => {
                let number = |index: usize| {
                    let node = Node { value: &values[index], place: Place::Index(self, index) };
                    node.within(range.clone())
                };
                Ok([number(0)?, number(1)?, number(2)?])
            }
            _ => Err(self.expected("three numbers")),
        }
    }

    /// A finite number.
    pub(crate) fn number(&self) -> Result<f64, DocumentError> {
        let Json::Number(number) = *self.value else { return Err(self.expected("a number")) };
        if number.is_finite() {
            return Ok(number);
        }
        Err(self.error(Code::NonFinite, format!("{number} was found; expected a finite number")))
    }

    /// A number in a range.
    pub(crate) fn within(&self, range: RangeInclusive<f64>) -> Result<f64, DocumentError> {
        let number = self.number()?;
        if range.contains(&number) {
            return Ok(number);
        }
        let (start, end) = range.into_inner();
        let (number, start, end) = (Full(number), Full(start), Full(end));
        Err(self.error(Code::Range, format!("{number} was found; expected a number from {start} to {end}")))
    }

    /// A whole number, at least 0.
    pub(crate) fn count(&self) -> Result<usize, DocumentError> {
        match *self.value {
            Json::Number(x) if x.fract() == 0.0 && (0.0..=9e15).contains(&x) => Ok(x as usize),
            _ => Err(self.expected("a whole number from 0 on")),
        }
    }

    /// A whole number in a range; more than the greatest passes a limit.
    pub(crate) fn count_within(&self, range: RangeInclusive<usize>) -> Result<usize, DocumentError> {
        let count = self.count()?;
        self.check_count(count, "", range)?;
        Ok(count)
    }

    /// The index of one of `count` things.
    pub(crate) fn index(&self, count: usize, thing: &str) -> Result<usize, DocumentError> {
        let index = self.count()?;
        if index < count {
            return Ok(index);
        }
        let last = count.saturating_sub(1);
        Err(self
            .error(Code::Range, format!("{index} was found; expected the index of a {thing}, 0 to {last}")))
    }

    /// Refuses a number of things out of range; more than the greatest passes a limit.
    pub(crate) fn check_count(
        &self,
        count: usize,
        things: &str,
        range: RangeInclusive<usize>,
    ) -> Result<(), DocumentError> {
        if range.contains(&count) {
            return Ok(());
        }
        let (start, end) = range.into_inner();
        let code = if count > end { Code::Limit } else { Code::Range };
        let expected = if start == end { format!("{start}") } else { format!("{start} to {end}") };
        Err(self.error(code, format!("{count}{things} were found; expected {expected}")))
    }

    /// True or false.
    pub(crate) fn flag(&self) -> Result<bool, DocumentError> {
        match *self.value {
            Json::Flag(flag) => Ok(flag),
            _ => Err(self.expected("true or false")),
        }
    }

    /// A text of at most `most` characters.
    pub(crate) fn text(&self, most: usize) -> Result<String, DocumentError> {
        let Json::Text(text) = self.value else { return Err(self.expected("a text")) };
        self.check_count(text.chars().count(), " characters", 0..=most)?;
        Ok(text.clone())
    }

    /// The place of a text in a list of names.
    pub(crate) fn choice(&self, names: &[&str]) -> Result<usize, DocumentError> {
        let Json::Text(text) = self.value else { return Err(self.expected(&one_of(names))) };
        names.iter().position(|name| name == text).ok_or_else(|| {
            let quote = shortened(text);
            self.error(Code::Range, format!("\"{quote}\" was found; expected {}", one_of(names)))
        })
    }

    /// Tells whether the value is a text.
    pub(crate) fn is_text(&self) -> bool {
        matches!(self.value, Json::Text(_))
    }

    /// Tells whether the value is null.
    pub(crate) fn is_null(&self) -> bool {
        *self.value == Json::Null
    }

    /// Tells whether the value is a list.
    #[cfg(feature = "import")]
    pub(crate) fn is_list(&self) -> bool {
        matches!(self.value, Json::List(_))
    }

    /// Tells whether the value is an object.
    #[cfg(any(feature = "import", feature = "part", feature = "solid"))]
    pub(crate) fn is_object(&self) -> bool {
        matches!(self.value, Json::Object(_))
    }

    /// An error at this value.
    pub(crate) fn error(&self, code: Code, message: String) -> DocumentError {
        let mut path = String::new();
        self.write_path(&mut path);
        DocumentError::new(code, path, message)
    }

    /// Refuses a value of the format that a later release computes.
    #[cfg(feature = "solid")]
    pub(crate) fn not_yet(&self, what: &str) -> DocumentError {
        self.error(Code::NotYet, format!("{what} belong to the format but come with a later release"))
    }

    fn fields(&self) -> Result<&'a [(String, Json)], DocumentError> {
        match self.value {
            Json::Object(fields) => Ok(fields),
            _ => Err(self.expected("an object")),
        }
    }

    fn expected(&self, what: &str) -> DocumentError {
        let found = match self.value {
            Json::Null => "null".to_owned(),
            Json::Flag(flag) => flag.to_string(),
            Json::Number(number) => Full(*number).to_string(),
            Json::Text(text) => format!("the text \"{}\"", shortened(text)),
            Json::List(values) => format!("a list of {}", values.len()),
            Json::Object(_) => "an object".to_owned(),
        };
        self.error(Code::Type, format!("{found} was found; expected {what}"))
    }

    fn write_path(&self, path: &mut String) {
        // Writing to a string cannot fail.
        let _ = match self.place {
            Place::Root(name) => write!(path, "{name}"),
            Place::Field(parent, name) => {
                parent.write_path(path);
                let dot = if path.is_empty() { "" } else { "." };
                write!(path, "{dot}{name}")
            }
            Place::Index(parent, index) => {
                parent.write_path(path);
                write!(path, "[{index}]")
            }
        };
    }
}

/// Longest part of a text that a message repeats.
const LONGEST_QUOTE: usize = 40;

fn shortened(text: &str) -> String {
    let mut quote: String = text.chars().take(LONGEST_QUOTE).collect();
    if quote.len() < text.len() {
        quote.push('…');
    }
    quote
}

fn one_of(names: &[&str]) -> String {
    let mut list = String::new();
    for (k, name) in names.iter().enumerate() {
        let _ = write!(list, "{}`{name}`", if k == 0 { "" } else { ", " });
    }
    list
}
