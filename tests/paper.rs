//! Holds `src/paper.md` against the code: each of the paper's claims, and each
//! departure from it, is cited where it is implemented and names its tests,
//! and nothing cites one that is not there.

use std::collections::BTreeSet;
use std::fs;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::time::Duration;

use carom::frame::Passes;
use carom::run::{Options, Outcome, run};
use carom::scene::{Disc, Scene};
use carom::simulation::Algorithm::{self, Multiple, Single};

/// A row of a table in `src/paper.md`.
struct Claim {
    id: String,
    here: String,
    tests: String,
}

impl Claim {
    /// Only what the code does can be cited and tested.
    fn is_implemented(&self) -> bool {
        !["explains", "not implemented: "]
            .iter()
            .any(|mark| self.here.starts_with(mark))
    }
}

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn read(path: impl AsRef<Path>) -> String {
    let path = root().join(path);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

fn claims() -> Vec<Claim> {
    let text = read("src/paper.md");
    let rows = text.lines().filter_map(|line| {
        let cells: Vec<_> = line.split('|').map(str::trim).collect();
        let &["", id, _, here, tests, ""] = &cells[..] else {
            return None;
        };
        is_id(id).then(|| Claim {
            id: id.to_owned(),
            here: here.to_owned(),
            tests: tests.to_owned(),
        })
    });
    rows.collect()
}

/// Whether a word looks like `P4.2` or `D7`.
fn is_id(word: &str) -> bool {
    let is_number = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    match word.split_at_checked(1) {
        Some(("P", rest)) => rest
            .split_once('.')
            .is_some_and(|(section, number)| is_number(section) && is_number(number)),
        Some(("D", rest)) => is_number(rest),
        _ => false,
    }
}

/// The ids that a file's comments cite; `P4.1 to P4.6` cites all six.
fn cited_in(source: &str) -> Vec<String> {
    let comments = source.lines().map(str::trim_start);
    let comments = comments.filter(|line| line.starts_with("//"));
    let words: Vec<_> = comments
        .flat_map(|line| line.split(|c: char| !c.is_ascii_alphanumeric() && c != '.'))
        .map(|word| word.trim_matches('.'))
        .filter(|word| !word.is_empty())
        .collect();
    let single = words.iter().filter(|word| is_id(word));
    let mut cited: Vec<_> = single.map(|&word| word.to_owned()).collect();
    for range in words.windows(3) {
        if let &[first, "to", last] = range
            && is_id(first)
            && is_id(last)
        {
            cited.extend(between(first, last));
        }
    }
    cited
}

/// The ids from one to another of the same section.
fn between(first: &str, last: &str) -> impl Iterator<Item = String> {
    let split = |id: &str| {
        let (section, number) = id.rsplit_once('.').unwrap_or(id.split_at(1));
        (section.to_owned(), number.parse::<u32>().unwrap())
    };
    let ((section, first), (other, last)) = (split(first), split(last));
    assert_eq!(section, other, "a range of ids is within one section");
    let dot = if section == "D" { "" } else { "." };
    (first..=last).map(move |number| format!("{section}{dot}{number}"))
}

/// All Rust sources below a folder.
fn sources(folder: PathBuf) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap();
    let paths = entries.map(|entry| entry.unwrap().path());
    paths
        .flat_map(|path| match path.extension() {
            _ if path.is_dir() => sources(path),
            Some(extension) if extension == "rs" => vec![path],
            _ => Vec::new(),
        })
        .collect()
}

fn cited_below(folder: &str) -> BTreeSet<String> {
    let sources = sources(root().join(folder)).into_iter();
    let own = root().join(file!());
    let others = sources.filter(|path| *path != own);
    others.flat_map(|path| cited_in(&read(path))).collect()
}

/// What of a list of tests, `` `file`: `test`, `test`; `file`: … ``, is not
/// to be found.
fn missing_tests(list: &str) -> Vec<String> {
    let (mut file, mut source) = (String::new(), String::new());
    let mut missing = Vec::new();
    for name in list.split('`').skip(1).step_by(2) {
        if name.ends_with(".rs") {
            (file, source) = (name.to_owned(), read(name));
        } else if !has_test(&source, name) {
            missing.push(format!("{file}: {name}"));
        }
    }
    missing
}

/// Whether a source has a function of this name that is marked as a test.
fn has_test(source: &str, name: &str) -> bool {
    let head = format!("fn {name}(");
    let item = source.split("\n\n").find(|item| {
        item.lines()
            .any(|line| line.trim_start().starts_with(&head))
    });
    item.is_some_and(|item| item.contains("#[test]"))
}

#[test]
fn every_claim_has_its_code() {
    let cited = cited_below("src");
    let bare: Vec<_> = claims()
        .into_iter()
        .filter(|claim| claim.is_implemented() && !cited.contains(&claim.id))
        .map(|claim| claim.id)
        .collect();
    assert_eq!(bare, [""; 0], "no file in src cites these");
}

#[test]
fn every_claim_has_its_tests() {
    for claim in claims().iter().filter(|claim| claim.is_implemented()) {
        assert!(claim.tests.contains('`'), "{}: no test", claim.id);
        assert_eq!(missing_tests(&claim.tests), [""; 0], "{}", claim.id);
    }
}

#[test]
fn nothing_cites_what_is_not_there() {
    let claims = claims();
    let known: BTreeSet<_> = claims.iter().map(|claim| claim.id.clone()).collect();
    assert_eq!(known.len(), claims.len(), "an id stands twice");
    assert!(known.contains("P3.1") && known.contains("D1"), "{known:?}");
    let cited = &cited_below("src") | &cited_below("tests");
    let in_text = cited_in(&read("src/paper.md").replace('\n', "\n// "));
    let cited = cited.into_iter().chain(in_text);
    let dangling: Vec<_> = cited.filter(|id| !known.contains(id)).collect();
    assert_eq!(dangling, [""; 0], "src/paper.md lacks these");
}

/// The disc goes to and fro between two walls, four times a frame.
fn shuttle(algorithm: Algorithm) -> Outcome<f64> {
    let scene = Scene::builder("shuttle")
        .disc(Disc::at([0, 0], 1).velocity([8, 0]))
        .wall([-2, -1], [-2, 1])
        .wall([2, -1], [2, 1])
        .build();
    let mut go_on = |_| ControlFlow::Continue(());
    run(&scene.unwrap(), algorithm, &Options::default(), &mut go_on).unwrap()
}

#[test]
fn a_budget_of_time_ends_the_passes() {
    let budget = |duration| shuttle(Multiple(Passes::Budget(duration))).impacts.len();
    assert_eq!(budget(Duration::ZERO), shuttle(Single).impacts.len());
    assert_eq!(budget(Duration::from_secs(3600)), 4);
}
