//! The words and numbers of a designation, however it is written.

/// A word in lower case, or a number with its fraction.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Part {
    /// `9.625`, of `9-5/8`, `9 5/8` and `9.625` alike.
    Number(f64),
    /// `collar`; a sign that separates nothing is a word too.
    Word(String),
}

/// The parts of a text in their order. A number and a word that touch (`S135`, `19.5ppf`) are two.
pub(crate) fn parts(text: &str) -> Vec<Part> {
    let mut parts = Vec::new();
    let mut tokens = tokens(text).into_iter().peekable();
    while let Some(token) = tokens.next() {
        parts.push(match token {
            Token::Whole(whole) => match tokens.peek() {
                Some(Token::Fraction(part)) => {
                    let number = whole + part;
                    tokens.next();
                    Part::Number(number)
                }
                _ => Part::Number(whole),
            },
            Token::Decimal(number) | Token::Fraction(number) => Part::Number(number),
            Token::Word(word) => Part::Word(word),
        });
    }
    parts
}

/// A piece of text between separators.
#[derive(Debug, PartialEq)]
enum Token {
    Whole(f64),
    Decimal(f64),
    Fraction(f64),
    Word(String),
}

/// Words and numbers; hyphens, quotes, slashes between words and `#` separate them.
fn tokens(text: &str) -> Vec<Token> {
    let chars: Vec<char> = text.chars().flat_map(char::to_lowercase).collect();
    let mut tokens = Vec::new();
    let mut at = 0;
    let run = |from: usize, accept: &dyn Fn(char) -> bool| {
        chars[from..].iter().take_while(|&&c| accept(c)).count()
    };
    while at < chars.len() {
        let c = chars[at];
        if c.is_ascii_digit() || (c == '.' && chars.get(at + 1).is_some_and(char::is_ascii_digit)) {
            let length = run(at, &|c| c.is_ascii_digit() || c == '.');
            let number: String = chars[at..at + length].iter().collect();
            at += length;
            let is_fraction =
                chars.get(at) == Some(&'/') && chars.get(at + 1).is_some_and(char::is_ascii_digit);
            let value: Option<f64> = number.parse().ok();
            if is_fraction {
                let length = run(at + 1, &|c| c.is_ascii_digit());
                let below: String = chars[at + 1..at + 1 + length].iter().collect();
                at += 1 + length;
                match (value, below.parse::<f64>()) {
                    (Some(above), Ok(below)) if below > 0.0 => {
                        tokens.push(Token::Fraction(above / below));
                    }
                    _ => tokens.push(Token::Word(number)),
                }
            } else {
                tokens.push(match value {
                    Some(value) if number.contains('.') => Token::Decimal(value),
                    Some(value) => Token::Whole(value),
                    None => Token::Word(number),
                });
            }
        } else if c.is_alphabetic() {
            let length = run(at, &char::is_alphabetic);
            tokens.push(Token::Word(chars[at..at + length].iter().collect()));
            at += length;
        } else {
            match c {
                '×' => tokens.push(Token::Word("x".into())),
                '"' | '″' | '”' | '#' | '-' | '–' | '/' | '.' | ',' | ';' | '(' | ')' => {}
                c if c.is_whitespace() => {}
                other => tokens.push(Token::Word(other.into())),
            }
            at += 1;
        }
    }
    tokens
}
