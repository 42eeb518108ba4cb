//! Where and how a page was made.

use std::fs;
use std::thread;

/// What times depend on.
pub(super) struct Machine {
    processor: String,
    threads: usize,
}

impl Machine {
    pub(super) fn find() -> Self {
        Self {
            processor: processor().unwrap_or_else(|| String::from("unknown")),
            threads: thread::available_parallelism().map_or(1, usize::from),
        }
    }

    pub(super) fn facts(&self) -> [(&'static str, String); 3] {
        let os = format!("{} {}", std::env::consts::OS, std::env::consts::ARCH);
        let build = match cfg!(debug_assertions) {
            true => " (a debug build: times mean nothing)",
            false => "",
        };
        [
            (
                "processor",
                format!("{}, {} threads", self.processor, self.threads),
            ),
            ("system", os),
            ("carom", format!("{}{build}", env!("CARGO_PKG_VERSION"))),
        ]
    }
}

/// The processor's name, where the system tells it.
fn processor() -> Option<String> {
    let text = fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = text.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}

/// The command that makes the page again.
pub(super) fn command() -> String {
    let arguments = std::env::args().skip(1);
    let quoted = arguments.map(|argument| match argument.contains([' ', '\'', '"', '*']) {
        true => format!("'{}'", argument.replace('\'', "'\\''")),
        false => argument,
    });
    let words: Vec<_> = std::iter::once(String::from("carom"))
        .chain(quoted)
        .collect();
    words.join(" ")
}
