//! The words of a `.csg` file.

use crate::error::Error;
use winnow::ascii::float;
use winnow::combinator::{alt, cut_err, delimited, dispatch, fail, opt, peek, preceded, repeat};
use winnow::prelude::*;
use winnow::stream::{LocatingSlice, Location};
use winnow::token::{any, none_of, one_of, take_until, take_while};

/// A word of the file.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Word {
    /// A name, such as `cube`, `$fn` or `true`.
    Name(String),
    /// A number.
    Number(f64),
    /// A string, without its quotes and escapes.
    Text(String),
    /// One of `( ) { } [ ] , ; = % # * !`.
    Sign(char),
}

/// A word and the line it is on.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Token {
    pub(crate) word: Word,
    pub(crate) line: usize,
}

/// All words of a text.
pub(crate) fn tokens(text: &str) -> Result<Vec<Token>, Error> {
    let mut input = LocatingSlice::new(text);
    let (mut tokens, mut line, mut counted) = (Vec::new(), 1, 0);
    loop {
        let gap = blank.parse_next(&mut input);
        let at = input.current_token_start();
        line += text.as_bytes().get(counted..at).map_or(0, count_lines);
        counted = at;
        if gap.is_err() {
            return Err(Error::syntax(line, "a comment has no end"));
        }
        if input.is_empty() {
            return Ok(tokens);
        }
        match word.parse_next(&mut input) {
            Ok(word) => tokens.push(Token { word, line }),
            Err(_) => {
                let there: String = text[at..].chars().take(12).collect();
                return Err(Error::syntax(line, format!("no word begins with {there:?}")));
            }
        }
    }
}

fn count_lines(bytes: &[u8]) -> usize {
    bytes.iter().filter(|byte| **byte == b'\n').count()
}

type Input<'a> = LocatingSlice<&'a str>;

/// Spaces and comments.
fn blank(input: &mut Input<'_>) -> ModalResult<()> {
    let space = take_while(1.., |c: char| c.is_whitespace() || c == '\u{feff}').void();
    let rest_of_line = preceded("//", take_while(0.., |c| c != '\n')).void();
    let block = delimited("/*", cut_err(take_until(0.., "*/")), "*/").void();
    repeat(0.., alt((space, rest_of_line, block))).parse_next(input)
}

fn word(input: &mut Input<'_>) -> ModalResult<Word> {
    dispatch! { peek(any);
        '0'..='9' | '-' | '+' | '.' => number.map(Word::Number),
        '"' => text.map(Word::Text),
        'a'..='z' | 'A'..='Z' | '_' | '$' => name.map(Word::Name),
        '(' | ')' | '{' | '}' | '[' | ']' | ',' | ';' | '=' | '%' | '#' | '*' | '!' | ':' => any.map(Word::Sign),
        _ => fail,
    }
    .parse_next(input)
}

fn number(input: &mut Input<'_>) -> ModalResult<f64> {
    // `-inf` and `nan` are what OpenSCAD writes for numbers that aren't finite.
    float.parse_next(input)
}

fn name(input: &mut Input<'_>) -> ModalResult<String> {
    let rest = take_while(0.., |c: char| c.is_ascii_alphanumeric() || c == '_');
    (opt('$'), rest).take().map(String::from).parse_next(input)
}

fn text(input: &mut Input<'_>) -> ModalResult<String> {
    let escaped = preceded('\\', any).map(|c| match c {
        'n' => '\n',
        't' => '\t',
        'r' => '\r',
        other => other,
    });
    let letters = repeat(0.., alt((escaped, none_of(['"', '\\']))));
    delimited('"', letters, one_of('"')).parse_next(input)
}

#[cfg(test)]
mod tests {
    use super::{Word, tokens};

    #[test]
    fn words_have_lines() {
        let words = tokens("a /* x\n */ -1.5e3 // c\n\"q\\\"\" $fn;").unwrap_or_default();
        let got: Vec<_> = words.into_iter().map(|token| (token.word, token.line)).collect();
        let want = [
            (Word::Name("a".into()), 1),
            (Word::Number(-1500.0), 2),
            (Word::Text("q\"".into()), 3),
            (Word::Name("$fn".into()), 3),
            (Word::Sign(';'), 3),
        ];
        assert_eq!(got, want);
    }

    #[test]
    fn what_is_no_word_is_an_error_on_its_line() {
        for text in ["a\n@", "\n\"open", "\n/* open"] {
            assert_eq!(tokens(text).map_err(|error| error.line), Err(2), "{text}");
        }
    }
}
