//! The words of a Rust source, in a row.

use std::str::FromStr;

use proc_macro2::{Delimiter, LexError, Spacing, TokenStream, TokenTree};

/// Identifiers, `::`, string literals (with their quotes) and single signs. Comments, numbers,
/// characters and lifetimes are left out.
///
/// # Errors
///
/// A source that is not Rust.
pub fn tokens(source: &str) -> Result<Vec<String>, LexError> {
    let mut words = Vec::new();
    flatten(TokenStream::from_str(source)?, &mut words);
    Ok(words)
}

fn flatten(stream: TokenStream, words: &mut Vec<String>) {
    let mut trees = stream.into_iter().peekable();
    while let Some(tree) = trees.next() {
        match tree {
            TokenTree::Group(group) => {
                let [open, close] = match group.delimiter() {
                    Delimiter::Brace => ["{", "}"],
                    Delimiter::Bracket => ["[", "]"],
                    Delimiter::Parenthesis => ["(", ")"],
                    Delimiter::None => ["", ""],
                };
                words.push(open.to_owned());
                flatten(group.stream(), words);
                words.push(close.to_owned());
            }
            TokenTree::Punct(sign) if sign.as_char() == '\'' => {
                trees.next();
            }
            TokenTree::Punct(sign) if sign.as_char() == ':' && sign.spacing() == Spacing::Joint => {
                // `:&` is joint too.
                let twice = trees.next_if(|next| next.to_string() == ":").is_some();
                words.push(if twice { "::" } else { ":" }.to_owned());
            }
            TokenTree::Literal(literal) => {
                let text = literal.to_string();
                words.extend(text.starts_with('"').then_some(text));
            }
            other => words.push(other.to_string()),
        }
    }
}
