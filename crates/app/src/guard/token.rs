//! Random texts that nobody can guess.

/// Letters and digits that are not taken for each other; 32 of them, five bits each.
const LETTERS: &[u8; 32] = b"0123456789abcdefghjkmnpqrstvwxyz";

/// A secret of one start of the server.
#[derive(Clone)]
pub(crate) struct Token(String);

impl Token {
    /// A token of `length` letters, five random bits each.
    ///
    /// # Errors
    /// A system without random numbers.
    pub(crate) fn random(length: usize) -> Result<Self, getrandom::Error> {
        let mut bytes = vec![0; length];
        getrandom::fill(&mut bytes)?;
        let letters = bytes.iter().map(|byte| char::from(LETTERS[usize::from(byte & 31)]));
        Ok(Self(letters.collect()))
    }

    pub(crate) fn text(&self) -> &str {
        &self.0
    }

    /// Whether the offered token is equal. The comparison takes the same time wherever the two
    /// differ.
    pub(crate) fn is(&self, offered: &[u8]) -> bool {
        let own = self.0.as_bytes();
        let pairs = own.iter().zip(offered);
        let difference = pairs.fold(0, |difference, (one, other)| difference | (one ^ other));
        own.len() == offered.len() && std::hint::black_box(difference) == 0
    }
}

impl std::fmt::Debug for Token {
    fn fmt(&self, to: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        to.write_str("Token(..)")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_whole_token_is_it() {
        let token = Token::random(26).unwrap();
        let text = token.text().to_owned();
        assert_eq!(text.len(), 26);
        assert!(token.is(text.as_bytes()));
        assert!(!token.is(&text.as_bytes()[..25]));
        assert!(!token.is(b""));
        assert!(!token.is(format!("{text}0").as_bytes()));
        assert!(!token.is(Token::random(26).unwrap().text().as_bytes()));
        assert!(!format!("{token:?}").contains(&text));
    }
}
