//! The command line: results on standard output, messages and progress on
//! standard error.
//!
//! Exit status: 0 all as expected, 1 a judged difference, 2 bad usage or
//! input, 3 the budget ran out; 130 after an interruption.

mod campaign;
mod check;
mod choice;
mod compare;
mod draw;
mod error;
mod exit;
mod figures;
mod fuzz_check;
mod generate;
mod html;
mod interrupt;
mod motion;
mod oracle;
mod output;
mod progress;
mod replay;
mod run;
mod schema;
mod time;
mod trace;
mod validate;
mod vectors;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

use error::Error;
use exit::Exit;

/// What truly happens when discs and walls collide: every impact, in its
/// proven order.
#[derive(Debug, Parser)]
#[command(
    version,
    after_help = "Exit status: 0 all as expected, 1 a judged difference, \
    2 bad usage or input, 3 the budget ran out, 130 interrupted."
)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    Run(run::Arguments),
    Compare(compare::Arguments),
    Check(check::Arguments),
    Oracle(oracle::Arguments),
    Campaign(campaign::Arguments),
    Table1(compare::table1::Arguments),
    Figures(figures::Arguments),
    Validate(validate::Arguments),
    Generate(generate::Arguments),
    FuzzCheck(fuzz_check::Arguments),
    Vectors(vectors::Arguments),
    Schema(schema::Arguments),
}

pub(crate) fn main() -> ExitCode {
    let arguments = Arguments::parse();
    match arguments.command.execute() {
        Ok(exit) => exit.into(),
        Err(error) if error.is_broken_pipe() => Exit::Success.into(),
        Err(error) => {
            error::report(&error);
            Exit::BadInput.into()
        }
    }
}

impl Command {
    fn execute(&self) -> Result<Exit, Error> {
        match self {
            Self::Run(arguments) => run::execute(arguments),
            Self::Compare(arguments) => compare::execute(arguments),
            Self::Check(arguments) => check::execute(arguments),
            Self::Oracle(arguments) => oracle::execute(arguments),
            Self::Campaign(arguments) => campaign::execute(arguments),
            Self::Table1(arguments) => compare::table1::execute(arguments),
            Self::Figures(arguments) => figures::execute(arguments),
            Self::Validate(arguments) => Ok(validate::execute(arguments)),
            Self::Generate(arguments) => generate::execute(arguments),
            Self::FuzzCheck(arguments) => fuzz_check::execute(arguments),
            Self::Vectors(arguments) => vectors::execute(arguments),
            Self::Schema(arguments) => schema::execute(arguments),
        }
    }
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        super::Arguments::command().debug_assert();
    }
}
