//! Options of a program, `--name value` each.

use std::str::FromStr;

/// What stands on the command line.
#[derive(Debug)]
pub struct Options(Vec<(String, String)>);

impl Options {
    /// Reads the command line. What is not understood, and `--help`, ends the program with
    /// a text.
    pub fn of_program(usage: &str, names: &[&str]) -> Self {
        Self::read(std::env::args().skip(1), names).unwrap_or_else(|problem| {
            eprintln!("{problem}\n{usage}");
            std::process::exit(2)
        })
    }

    fn read(mut words: impl Iterator<Item = String>, names: &[&str]) -> Result<Self, String> {
        let mut found = Vec::new();
        while let Some(word) = words.next() {
            let name = word.strip_prefix("--").unwrap_or_default();
            if !names.contains(&name) {
                return Err(format!("no such option: {word}"));
            }
            let value = words.next().ok_or(format!("{word} needs a value"))?;
            found.push((name.to_owned(), value));
        }
        Ok(Self(found))
    }

    /// The value of an option, if it is there. One that is no value of the type ends the
    /// program.
    pub fn get<T: FromStr>(&self, name: &str) -> Option<T> {
        let (_, value) = self.0.iter().rev().find(|(given, _)| given == name)?;
        Some(value.parse().unwrap_or_else(|_| {
            eprintln!("--{name}: not understood: {value}");
            std::process::exit(2)
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(words: &[&str]) -> Result<Options, String> {
        Options::read(words.iter().map(|word| (*word).to_owned()), &["steps"])
    }

    #[test]
    fn the_last_value_counts() {
        let options = read(&["--steps", "3", "--steps", "4"]).expect("options");
        assert_eq!(options.get::<u64>("steps"), Some(4));
        assert_eq!(options.get::<u64>("other"), None);
    }

    #[test]
    fn what_is_no_option() {
        for words in [&["--other", "3"][..], &["steps", "3"], &["--steps"]] {
            assert!(read(words).is_err(), "{words:?}");
        }
    }
}
