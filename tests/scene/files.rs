//! Files, good and bad.

use super::*;

/// What is said about a file with that content, after the file's name.
fn refusal(content: &[u8]) -> String {
    let directory = tempfile::tempdir().expect("a directory");
    let path = directory.path().join("break.json");
    fs::write(&path, content).expect("a file");
    message(&path)
}

fn message(path: &Path) -> String {
    let message = Scene::read(path).expect_err("a fault").to_string();
    let name = format!("{}: ", path.display());
    message.strip_prefix(&name).expect("the file").to_owned()
}

#[test]
fn a_fault_names_the_file() {
    let text = EXAMPLE.replacen(r#""radius": 1"#, r#""radius": 0"#, 1);
    assert_eq!(
        refusal(text.as_bytes()),
        "discs[0].radius: expected a positive number, found 0"
    );
}

#[test]
fn no_content_makes_it_panic() {
    assert_eq!(
        refusal(b""),
        "line 1, column 1: expected a scene, found nothing"
    );
    assert_eq!(
        refusal(b"{}\n\xff"),
        "line 2, column 1: expected UTF-8 text"
    );
    for content in [
        vec![0; 100 << 20],
        vec![b'0'; 100 << 20],
        vec![b'9'; 10 << 20],
        vec![b'['; 1 << 20],
        b"{\"a\":".repeat(1 << 20),
        b"\xef\xbb\xbf{}".to_vec(),
        EXAMPLE.as_bytes()[..EXAMPLE.len() - 1].to_vec(),
        [EXAMPLE, EXAMPLE].concat().into_bytes(),
    ] {
        assert!(!refusal(&content).is_empty());
    }
}

#[test]
fn numbers_of_a_million_digits_are_settled_quickly() {
    let nines = "9".repeat(1 << 20);
    assert!(with_radius(&nines).is_err());
    assert!(with_radius(&format!("\"{nines}\"")).is_err());
    let tiny = format!("0.{}1", "0".repeat(1 << 20));
    assert!(with_radius(&tiny).is_err(), "it rounds to zero");
    assert!(with_radius(&format!("\"{tiny}\"")).is_err());
}

#[test]
fn what_cannot_be_read_is_told() {
    let nowhere = Path::new("no-such-directory/break.json");
    assert!(message(nowhere).starts_with("cannot be read: "));
    assert!(message(repository()).starts_with("cannot be read: "));
}

#[test]
fn a_nameless_scene_takes_the_name_of_its_file() {
    let directory = tempfile::tempdir().expect("a directory");
    let path = directory.path().join("corner.json");
    fs::write(&path, r#"{"schema": "carom/scene/1", "discs": []}"#).expect("a file");
    assert_eq!(Scene::read(&path).expect("a scene").id(), "corner");
}
