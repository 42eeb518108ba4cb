//! Test vectors: those that are committed, and that each flag is explained.

use std::collections::BTreeSet;

use super::*;

const FILES: [&str; 5] = ["disc-disc", "disc-wall", "disc-end", "response", "scenes"];

fn committed(name: &str) -> String {
    let file = repository().join("vectors").join(name);
    fs::read_to_string(file).expect(name)
}

#[test]
fn the_committed_vectors_are_fresh() {
    let scratch = Scratch::new();
    assert_eq!(results(&["vectors", &scratch.name("made")]), "");
    for name in FILES {
        let fresh = scratch.read(&format!("made/{name}.json"));
        let is_fresh = committed(&format!("{name}.json")) == fresh;
        assert!(is_fresh, "{name} is stale: carom vectors vectors");
    }
}

/// A question and its answer stand on a line of their own; no two have the same name.
#[test]
fn an_item_has_a_line_and_a_name() {
    for name in FILES {
        let text = committed(&format!("{name}.json"));
        let whole: Value = serde_json::from_str(&text).expect("JSON");
        let items = whole["vectors"].as_array().expect("an array");
        let lines: Vec<_> = text.lines().collect();
        let [_, lines @ .., "]}"] = &lines[..] else {
            panic!("a first and a last line")
        };
        let read = lines.iter().map(|line| line.trim_end_matches(','));
        let read: Vec<Value> = read
            .map(|line| serde_json::from_str(line).expect("an item"))
            .collect();
        assert_eq!(read, *items);
        let ids: BTreeSet<_> = items.iter().map(|item| item["id"].as_str()).collect();
        assert_eq!(ids.len(), items.len());
        let row = format!("| `{name}.json` |");
        let readme = committed("README.md");
        let row = readme.lines().find(|line| line.starts_with(&row));
        let count = format!("| {} |", items.len());
        assert!(row.expect(name).ends_with(&count), "{row:?}");
    }
}

/// Each flag is there, and told of.
#[test]
fn every_flag_has_items_and_a_sentence() {
    let mut given = BTreeSet::new();
    for name in FILES {
        let whole: Value = serde_json::from_str(&committed(&format!("{name}.json"))).expect("JSON");
        for item in whole["vectors"].as_array().expect("an array") {
            let flags = item["flags"].as_array().into_iter().flatten();
            given.extend(flags.map(|flag| flag.as_str().expect("a flag").to_owned()));
        }
    }
    let told: BTreeSet<_> = committed("README.md")
        .lines()
        .filter_map(|line| line.strip_prefix("| `")?.split_once("` | "))
        .map(|(name, _)| name.to_owned())
        .filter(|name| name.starts_with(char::is_uppercase))
        .collect();
    assert_eq!(given, told);
    assert_eq!(told.len(), 11);
}

#[test]
fn the_example_of_the_readme_is_a_question() {
    let readme = committed("README.md");
    let example = readme.lines().find(|line| line.starts_with("{\"id\""));
    assert!(committed("disc-disc.json").contains(example.expect("an example")));
}

#[test]
fn where_vectors_cannot_go_is_told() {
    let scratch = Scratch::new();
    let file = scratch.write("file", "");
    let (status, message) = ending(&["vectors", &file]);
    assert_eq!(status, 2);
    assert!(
        message.starts_with(&format!("carom: {file}: cannot be written")),
        "{message}"
    );
}
