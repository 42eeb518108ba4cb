//! A foreign program that answers questions, a line each.

use std::io::{self, BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::thread;
use std::time::Duration;

/// A longer line is no answer.
const MAX_LINE: u64 = 1 << 26;

/// Why there is no answer.
#[derive(Debug)]
pub(super) enum Failure {
    /// It did not come in time.
    Timeout,
    /// The program has ended, or cannot be started.
    Crash(String),
    /// It is no line of text, or has no end.
    Garbage(String),
}

/// A program. It is started when there is a question, and after a failure again.
pub(super) struct Foreign<'a> {
    command: &'a [String],
    timeout: Duration,
    process: Option<Process>,
}

impl<'a> Foreign<'a> {
    /// A program with its arguments, and the time that an answer may take.
    pub(super) fn new(command: &'a [String], timeout: Duration) -> Self {
        Self {
            command,
            timeout,
            process: None,
        }
    }

    /// The answer to a line.
    pub(super) fn ask(&mut self, question: String) -> Result<Vec<u8>, Failure> {
        let mut process = match self.process.take() {
            Some(process) => process,
            None => Process::start(self.command)?,
        };
        let answer = process.ask(question, self.timeout)?;
        self.process = Some(process);
        Ok(answer)
    }

    /// Ends the program: what follows is not its answer to what came before.
    pub(super) fn stop(&mut self) {
        self.process = None;
    }
}

/// A running program. Threads of their own write to it and read from it, so that it
/// cannot block whoever asks; they end when it does.
struct Process {
    child: Child,
    questions: Sender<String>,
    answers: Receiver<io::Result<Vec<u8>>>,
}

impl Process {
    fn start(command: &[String]) -> Result<Self, Failure> {
        let name = command.join(" ");
        let failed = |reason: &dyn std::fmt::Display| Failure::Crash(format!("{name}: {reason}"));
        let Some((program, arguments)) = command.split_first() else {
            return Err(failed(&"expected a command"));
        };
        let mut start = Command::new(program);
        start.args(arguments);
        start.stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut child = start.spawn().map_err(|reason| failed(&reason))?;
        let (Some(input), Some(output)) = (child.stdin.take(), child.stdout.take()) else {
            return Err(failed(&"it has no input or no output"));
        };
        Ok(Self {
            child,
            questions: writer(input),
            answers: reader(output),
        })
    }

    fn ask(&mut self, mut question: String, timeout: Duration) -> Result<Vec<u8>, Failure> {
        question.push('\n');
        // Of a program that has ended the answer tells.
        let _ = self.questions.send(question);
        let line = match self.answers.recv_timeout(timeout) {
            Ok(line) => line.map_err(|reason| Failure::Garbage(reason.to_string()))?,
            Err(RecvTimeoutError::Timeout) => return Err(Failure::Timeout),
            Err(RecvTimeoutError::Disconnected) => return Err(Failure::Crash(self.ending())),
        };
        match line.last() {
            Some(b'\n') => Ok(line),
            _ => Err(Failure::Garbage(format!(
                "{} bytes without the end of a line",
                line.len()
            ))),
        }
    }

    /// How it has ended, which has closed its output at least.
    fn ending(&mut self) -> String {
        thread::sleep(Duration::from_millis(10));
        match self.child.try_wait() {
            Ok(Some(status)) => status.to_string(),
            _ => String::from("it has closed its output"),
        }
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        // One that has ended already cannot be killed.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// A thread that writes lines.
fn writer(mut input: ChildStdin) -> Sender<String> {
    let (sender, lines) = mpsc::channel::<String>();
    thread::spawn(move || {
        for line in lines {
            if input.write_all(line.as_bytes()).is_err() || input.flush().is_err() {
                return;
            }
        }
    });
    sender
}

/// A thread that reads lines.
fn reader(output: ChildStdout) -> Receiver<io::Result<Vec<u8>>> {
    let (sender, lines) = mpsc::channel();
    thread::spawn(move || {
        let mut output = BufReader::new(output);
        loop {
            let mut line = Vec::new();
            let read = output.by_ref().take(MAX_LINE).read_until(b'\n', &mut line);
            let is_over = !matches!(read, Ok(1..));
            let line = read.map(|_| line);
            // The end of the program's output is the end of this channel.
            let is_told = match line {
                Ok(line) if line.is_empty() => true,
                line => sender.send(line).is_ok(),
            };
            if is_over || !is_told {
                return;
            }
        }
    });
    lines
}
