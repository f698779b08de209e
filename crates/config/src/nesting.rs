//! Depth of nested brackets.

use std::ops::Range;

use toml_parser::{Source, lexer::TokenKind};

/// Maximum nesting, which no valid case exceeds.
pub(crate) const MAX_DEPTH: usize = 80;

/// The bracket at which a text is nested deeper than [`MAX_DEPTH`], in bytes; none if there is no
/// such bracket.
///
/// The parser has the same limit, but after some mistakes it loses count and takes a stack frame
/// for each open bracket, so that deeper texts must never reach it. A bracket of the other kind
/// closes none.
pub(crate) fn too_deep(text: &str) -> Option<Range<usize>> {
    let mut open = Vec::new();
    for token in Source::new(text).lex() {
        let opens = match token.kind() {
            kind @ (TokenKind::LeftCurlyBracket | TokenKind::LeftSquareBracket) => {
                open.push(kind);
                if open.len() > MAX_DEPTH {
                    return Some(token.span().start()..token.span().end());
                }
                continue;
            }
            TokenKind::RightCurlyBracket => TokenKind::LeftCurlyBracket,
            TokenKind::RightSquareBracket => TokenKind::LeftSquareBracket,
            _ => continue,
        };
        open.pop_if(|last| *last == opens);
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn brackets_that_are_open_are_counted() {
        assert_eq!(too_deep("a = [[1, 2], [3, 4]]\n[b]\n[[c]]\nd = { e = '{' }"), None);
        // Any number in sequence, in texts and comments.
        assert_eq!(too_deep(&"[a]\nb = { c = \"[\" } # {{[\n".repeat(1000)), None);
        let deepest = format!("a = {}{}", "[".repeat(MAX_DEPTH), "]".repeat(MAX_DEPTH));
        assert_eq!(too_deep(&deepest), None);
        assert_eq!(too_deep(&format!("a = [{}", &deepest[4..])), Some(84..85));
    }

    /// Closed by the wrong kind, they are still open.
    #[test]
    fn the_wrong_bracket_closes_nothing() {
        assert!(too_deep(&"{ [ } ]".repeat(MAX_DEPTH + 1)).is_some());
        assert!(too_deep(&"a = { f\" = \"d\" [b]\n".repeat(MAX_DEPTH + 1)).is_some());
    }
}
