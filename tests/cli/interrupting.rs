//! Ctrl-C: a run that is stopped leaves a valid log.

use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

use carom::log::Ending;

use super::*;

/// A run that takes far longer than anyone waits.
fn endless(events: &str) -> Child {
    Command::new(env!("CARGO_BIN_EXE_carom"))
        .args(["run", &scene("table1-third.json"), "--until", "1e9"])
        .args(["--max-events", "1000000000", "--events", events])
        .stderr(Stdio::piped())
        .spawn()
        .expect("a process")
}

#[test]
fn an_interrupted_run_leaves_a_valid_log() {
    let scratch = Scratch::new();
    let mut process = endless(&scratch.name("log.jsonl"));
    // It opens its files once it listens.
    while !scratch.path("log.jsonl").exists() {
        assert!(process.try_wait().expect("a status").is_none());
        sleep(Duration::from_millis(5));
    }
    sleep(Duration::from_millis(100));
    let id = process.id().to_string();
    let sent = Command::new("kill").args(["-INT", &id]).status();
    assert!(sent.expect("a signal").success());
    let output = process.wait_with_output().expect("its end");
    assert_eq!(output.status.code(), Some(130));
    assert!(String::from_utf8_lossy(&output.stderr).ends_with(": interrupted\n"));
    let log = log(&scratch.read("log.jsonl"));
    let summary = log.summary.expect("a summary");
    assert_eq!(summary.status, Ending::Interrupted);
    assert_eq!(summary.events, log.events.len() as u64);
    assert_eq!(summary.until, 1e9);
    assert!(summary.reached.is_some_and(|time| time < 1e9));
}
