//! Typed expressions.

use std::error::Error;
use std::fmt;

/// Most characters of an expression.
pub const LONGEST_EXPRESSION: usize = 1000;
/// Most brackets, functions, signs and powers within each other.
const DEEPEST: usize = 50;

/// An expression in variables, as `1 - exp(-d / 3)`: numbers, `pi`, `e`, `+ - * / ^`, brackets and the functions `sin cos exp ln sqrt abs min max clamp
/// smoothstep`. `^` binds to the right and before a sign: `-2^2` is -4. `clamp(x, lo, hi)`; `smoothstep(lo, hi, x)`.
///
/// Read once, it is evaluated without memory of its own. It has no assignments, conditions or loops, so that it always ends.
#[derive(Debug, Clone, PartialEq)]
pub struct Expression {
    text: String,
    steps: Vec<Step>,
}

/// Why a text is not an expression.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ExpressionError {
    /// Place in the text, in characters from 0.
    pub at: usize,
    /// What is wrong, and what was expected.
    pub message: String,
}

impl fmt::Display for ExpressionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "character {}: {}", self.at + 1, self.message)
    }
}

impl Error for ExpressionError {}

/// What is done with the numbers on the stack.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Step {
    Number(f64),
    Variable(usize),
    Negate,
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Call(Function),
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Function {
    Sin,
    Cos,
    Exp,
    Ln,
    Sqrt,
    Abs,
    Min,
    Max,
    Clamp,
    Smoothstep,
}

/// Functions by their names, with the number of their arguments.
const FUNCTIONS: [(&str, Function, usize); 10] = [
    ("sin", Function::Sin, 1),
    ("cos", Function::Cos, 1),
    ("exp", Function::Exp, 1),
    ("ln", Function::Ln, 1),
    ("sqrt", Function::Sqrt, 1),
    ("abs", Function::Abs, 1),
    ("min", Function::Min, 2),
    ("max", Function::Max, 2),
    ("clamp", Function::Clamp, 3),
    ("smoothstep", Function::Smoothstep, 3),
];

const CONSTANTS: [(&str, f64); 2] = [("pi", std::f64::consts::PI), ("e", std::f64::consts::E)];

impl Expression {
    /// Reads an expression in the variables named, which are given in this order when it is evaluated.
    ///
    /// # Errors
    /// With the place in the text: what cannot be read, unknown names, wrong numbers of arguments, more than [`LONGEST_EXPRESSION`]
    /// characters, or more than 50 brackets within each other.
    pub fn new(text: &str, variables: &[&str]) -> Result<Self, ExpressionError> {
        let characters: Vec<char> = text.chars().take(LONGEST_EXPRESSION + 1).collect();
        let mut reader = Reader { characters, at: 0, variables, steps: Vec::new() };
        if reader.characters.len() > LONGEST_EXPRESSION {
            let message = format!("expected {LONGEST_EXPRESSION} characters at most");
            return Err(ExpressionError { at: LONGEST_EXPRESSION, message });
        }
        reader.sum(0)?;
        match reader.peek() {
            None => Ok(Self { text: text.to_owned(), steps: reader.steps }),
            Some(_) => Err(reader.fault("expected an operator or the end")),
        }
    }

    /// The text it was read from.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The value for values of the variables in their order; not finite where a root, a logarithm or a quotient is not. A variable
    /// without a value is not a number.
    #[must_use]
    pub fn value(&self, variables: &[f64]) -> f64 {
        let mut stack = [0.0; STACK];
        let mut top = 0;
        for step in &self.steps {
            let (count, value) = match *step {
                Step::Number(number) => (0, number),
                Step::Variable(index) => (0, variables.get(index).copied().unwrap_or(f64::NAN)),
                Step::Negate => (1, -stack[top - 1]),
                Step::Add => (2, stack[top - 2] + stack[top - 1]),
                Step::Subtract => (2, stack[top - 2] - stack[top - 1]),
                Step::Multiply => (2, stack[top - 2] * stack[top - 1]),
                Step::Divide => (2, stack[top - 2] / stack[top - 1]),
                Step::Power => (2, stack[top - 2].powf(stack[top - 1])),
                Step::Call(function) => {
                    let count = function.arguments();
                    (count, function.value(&stack[top - count..top]))
                }
            };
            top = top + 1 - count;
            stack[top - 1] = value;
        }
        stack[0]
    }
}

/// Numbers that wait at the same time: a sum, a product and a power for each level, and the arguments of its function.
const STACK: usize = 6 * (DEEPEST + 2);

impl Function {
    fn arguments(self) -> usize {
        FUNCTIONS.iter().find(|(_, function, _)| *function == self).map_or(1, |(.., count)| *count)
    }

    fn value(self, arguments: &[f64]) -> f64 {
        match (self, arguments) {
            (Self::Sin, [x]) => x.sin(),
            (Self::Cos, [x]) => x.cos(),
            (Self::Exp, [x]) => x.exp(),
            (Self::Ln, [x]) => x.ln(),
            (Self::Sqrt, [x]) => x.sqrt(),
            (Self::Abs, [x]) => x.abs(),
            (Self::Min, [x, y]) => x.min(*y),
            (Self::Max, [x, y]) => x.max(*y),
            (Self::Clamp, [x, lo, hi]) => x.max(*lo).min(*hi),
            (Self::Smoothstep, [lo, hi, x]) => smoothstep((x - lo) / (hi - lo)),
            _ => f64::NAN,
        }
    }
}

/// 3 t^2 - 2 t^3 between 0 and 1, and constant beyond.
pub(super) fn smoothstep(t: f64) -> f64 {
    let t = t.clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

struct Reader<'a> {
    characters: Vec<char>,
    at: usize,
    variables: &'a [&'a str],
    steps: Vec<Step>,
}

impl Reader<'_> {
    /// The next character that is not a space.
    fn peek(&mut self) -> Option<char> {
        while self.characters.get(self.at).is_some_and(|c| c.is_whitespace()) {
            self.at += 1;
        }
        self.characters.get(self.at).copied()
    }

    fn take(&mut self, wanted: char) -> bool {
        let is_there = self.peek() == Some(wanted);
        self.at += usize::from(is_there);
        is_there
    }

    /// What is wrong with what comes next.
    fn fault(&mut self, expected: &str) -> ExpressionError {
        let found = self.peek().map_or("the end was found".to_owned(), |c| format!("`{c}` was found"));
        ExpressionError { at: self.at, message: format!("{found}; {expected}") }
    }

    fn sum(&mut self, depth: usize) -> Result<(), ExpressionError> {
        if depth > DEEPEST {
            let message = format!("expected {DEEPEST} brackets, signs and powers within each other at most");
            return Err(ExpressionError { at: self.at, message });
        }
        self.product(depth)?;
        loop {
            let step = if self.take('+') {
                Step::Add
            } else if self.take('-') {
                Step::Subtract
            } else {
                return Ok(());
            };
            self.product(depth)?;
            self.steps.push(step);
        }
    }

    fn product(&mut self, depth: usize) -> Result<(), ExpressionError> {
        self.signed(depth)?;
        loop {
            let step = if self.take('*') {
                Step::Multiply
            } else if self.take('/') {
                Step::Divide
            } else {
                return Ok(());
            };
            self.signed(depth)?;
            self.steps.push(step);
        }
    }

    fn signed(&mut self, depth: usize) -> Result<(), ExpressionError> {
        if depth > DEEPEST {
            return self.sum(depth);
        }
        if self.take('-') {
            self.signed(depth + 1)?;
            self.steps.push(Step::Negate);
            return Ok(());
        }
        self.atom(depth)?;
        if self.take('^') {
            self.signed(depth + 1)?;
            self.steps.push(Step::Power);
        }
        Ok(())
    }

    fn atom(&mut self, depth: usize) -> Result<(), ExpressionError> {
        match self.peek() {
            Some('(') => {
                self.at += 1;
                self.sum(depth + 1)?;
                if self.take(')') { Ok(()) } else { Err(self.fault("expected an operator or `)`")) }
            }
            Some(c) if c.is_ascii_digit() || c == '.' => self.number(),
            Some(c) if c.is_alphabetic() || c == '_' => self.name(depth),
            _ => Err(self.fault("expected a number, a name or `(`")),
        }
    }

    fn number(&mut self) -> Result<(), ExpressionError> {
        let start = self.at;
        let digits = |reader: &mut Self| {
            while reader.characters.get(reader.at).is_some_and(|c| c.is_ascii_digit() || *c == '.') {
                reader.at += 1;
            }
        };
        digits(self);
        let is_power = |c: Option<&char>| c.is_some_and(|c| c.is_ascii_digit() || *c == '-' || *c == '+');
        let next = self.characters.get(self.at);
        if next.is_some_and(|c| *c == 'e' || *c == 'E') && is_power(self.characters.get(self.at + 1)) {
            self.at += 2;
            digits(self);
        }
        let text: String = self.characters[start..self.at].iter().collect();
        match text.parse::<f64>() {
            Ok(number) if number.is_finite() => {
                self.steps.push(Step::Number(number));
                Ok(())
            }
            _ => Err(ExpressionError { at: start, message: format!("`{text}` is not a number") }),
        }
    }

    fn name(&mut self, depth: usize) -> Result<(), ExpressionError> {
        let start = self.at;
        while self.characters.get(self.at).is_some_and(|c| c.is_alphanumeric() || *c == '_') {
            self.at += 1;
        }
        let name: String = self.characters[start..self.at].iter().collect();
        if let Some((_, function, count)) = FUNCTIONS.iter().find(|(known, ..)| *known == name) {
            return self.call(&name, *function, *count, depth);
        }
        let step = match self.variables.iter().position(|known| *known == name) {
            Some(index) => Step::Variable(index),
            None => match CONSTANTS.iter().find(|(known, _)| *known == name) {
                Some((_, value)) => Step::Number(*value),
                None => {
                    let known: Vec<&str> =
                        self.variables.iter().copied().chain(CONSTANTS.map(|(name, _)| name)).collect();
                    let message = format!("`{name}` is not known; there are {}", known.join(", "));
                    return Err(ExpressionError { at: start, message });
                }
            },
        };
        self.steps.push(step);
        Ok(())
    }

    fn call(
        &mut self,
        name: &str,
        function: Function,
        count: usize,
        depth: usize,
    ) -> Result<(), ExpressionError> {
        if !self.take('(') {
            return Err(self.fault(&format!("expected `(` after `{name}`")));
        }
        for argument in 0..count {
            if argument > 0 && !self.take(',') {
                return Err(self.fault(&format!("expected `,`: `{name}` takes {count} numbers")));
            }
            self.sum(depth + 1)?;
        }
        if !self.take(')') {
            return Err(self.fault(&format!("expected `)`: `{name}` takes {count} numbers")));
        }
        self.steps.push(Step::Call(function));
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str, d: f64) -> f64 {
        Expression::new(text, &["d", "t"]).unwrap_or_else(|e| panic!("{text}: {e}")).value(&[d, 0.25])
    }

    #[test]
    fn values_are_those_of_arithmetic() {
        assert_eq!(value("1 + 2 * 3 - 4 / 8", 0.0), 6.5);
        assert_eq!(value("2 ^ 3 ^ 2", 0.0), 512.0);
        assert_eq!(value("-2^2", 0.0), -4.0);
        assert_eq!(value("2^-1", 0.0), 0.5);
        assert_eq!(value("--3", 0.0), 3.0);
        assert_eq!(value("(1+2)*(3-5)", 0.0), -6.0);
        assert_eq!(value("10 - 3 - 2", 0.0), 5.0);
        assert_eq!(value("1e3 + 2.5E-1 + .5", 0.0), 1000.75);
        assert_eq!(value("d * d + t", 3.0), 9.25);
        assert_eq!(value("min(d, 2) + max(d, 2)", 5.0), 7.0);
        assert_eq!(value("clamp(d, 0, 1) + clamp(-d, 0, 1)", 5.0), 1.0);
        assert_eq!(value("smoothstep(2, 4, d)", 3.0), 0.5);
        assert!((value("exp(-d / 3)", 3.0) - (-1.0_f64).exp()).abs() < 1e-15);
        assert!((value("sin(pi / 2) + cos(0) + ln(e) + sqrt(4) + abs(-1)", 0.0) - 6.0).abs() < 1e-15);
    }

    #[test]
    fn what_is_undefined_is_not_finite() {
        assert!(value("1 / d", 0.0).is_infinite());
        assert!(value("sqrt(d)", -1.0).is_nan());
        assert!(Expression::new("d + t", &["d", "t"]).unwrap().value(&[1.0]).is_nan());
    }

    #[test]
    fn errors_name_the_place_and_what_was_expected() {
        let error = |text: &str| {
            let ExpressionError { at, message } = Expression::new(text, &["d"]).expect_err(text);
            (at, message)
        };
        assert_eq!(error(""), (0, "the end was found; expected a number, a name or `(`".into()));
        assert_eq!(error("1 +"), (3, "the end was found; expected a number, a name or `(`".into()));
        assert_eq!(error("2 d"), (2, "`d` was found; expected an operator or the end".into()));
        assert_eq!(error("(d"), (2, "the end was found; expected an operator or `)`".into()));
        assert_eq!(error("1.2.3"), (0, "`1.2.3` is not a number".into()));
        assert_eq!(error("1e999"), (0, "`1e999` is not a number".into()));
        assert_eq!(error("3 * r"), (4, "`r` is not known; there are d, pi, e".into()));
        assert_eq!(error("sin d"), (4, "`d` was found; expected `(` after `sin`".into()));
        assert_eq!(error("min(d)"), (5, "`)` was found; expected `,`: `min` takes 2 numbers".into()));
        assert_eq!(error("sin(d, 1)"), (5, "`,` was found; expected `)`: `sin` takes 1 numbers".into()));
        assert_eq!(error("d & 1").0, 2);
        assert_eq!(
            Expression::new("r", &["d"]).unwrap_err().to_string(),
            "character 1: `r` is not known; there are d, pi, e"
        );
    }

    #[test]
    fn long_and_deep_texts_are_refused_and_deep_ones_within_the_limit_are_evaluated() {
        assert_eq!(
            Expression::new(&"1".repeat(LONGEST_EXPRESSION + 1), &[]).unwrap_err().at,
            LONGEST_EXPRESSION
        );
        let nested = |depth: usize| format!("{}d{}", "(1 + 2 * d ^ ".repeat(depth), ")".repeat(depth));
        for depth in 1..60 {
            let found = Expression::new(&nested(depth), &["d"]);
            match depth {
                ..=25 => {
                    assert_eq!(found.unwrap().value(&[0.0]), if depth == 1 { 3.0 } else { 1.0 }, "{depth}")
                }
                51.. => assert!(found.is_err(), "{depth}"),
                _ => drop(found.map(|each| each.value(&[1.0]))),
            }
        }
        assert!(Expression::new(&"-".repeat(500), &[]).is_err());
        assert!(Expression::new(&format!("{}d", "2^".repeat(400)), &["d"]).is_err());
        assert!(Expression::new(&format!("{}d", "min(d,max(d,".repeat(30)), &["d"]).is_err());
    }

    /// Whatever is typed is read or refused, and what is read has a value.
    #[test]
    fn random_texts_never_panic() {
        let pieces = [
            "d", "(", ")", "+", "-", "*", "/", "^", "1", ".5", "e", "sin", "min", "clamp", ",", " ", "pi",
            "é", "_",
        ];
        let mut state = 20_261_126_u64;
        let mut read = 0;
        for _ in 0..20_000 {
            let mut text = String::new();
            for _ in 0..state % 12 {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                text.push_str(pieces[(state >> 33) as usize % pieces.len()]);
            }
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            state ^= state >> 29;
            if let Ok(found) = Expression::new(&text, &["d"]) {
                let _ = found.value(&[0.7]);
                read += 1;
            }
        }
        assert!(read > 100, "{read} of them are expressions");
    }
}
