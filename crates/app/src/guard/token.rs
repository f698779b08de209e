//! The secret of one start of the server.

/// 256 random bits, known only to readers of the printed address.
pub(super) struct Token(String);

impl Token {
    pub(super) fn random() -> Result<Self, getrandom::Error> {
        let mut bytes = [0; 32];
        getrandom::fill(&mut bytes)?;
        Ok(Self(bytes.iter().map(|byte| format!("{byte:02x}")).collect()))
    }

    /// As hexadecimal digits.
    pub(super) fn text(&self) -> &str {
        &self.0
    }

    /// Whether the offered token is equal. The comparison takes the same time wherever the two
    /// differ.
    pub(super) fn is(&self, offered: &[u8]) -> bool {
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
        let token = Token::random().unwrap();
        let text = token.text().to_owned();
        assert_eq!(text.len(), 64);
        assert!(token.is(text.as_bytes()));
        assert!(!token.is(&text.as_bytes()[..63]));
        assert!(!token.is(b""));
        assert!(!token.is(format!("{text}0").as_bytes()));
        assert!(!token.is(Token::random().unwrap().text().as_bytes()));
        assert!(!format!("{token:?}").contains(&text));
    }
}
