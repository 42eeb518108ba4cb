//! Scenes that once were findings: none of them may be one again.
#![cfg(feature = "json")]

use std::fs;
use std::path::Path;

use carom::check::check;
use carom::scene::Scene;

#[test]
fn no_finding_comes_back() {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/regressions");
    let paths = fs::read_dir(directory).expect("scenes");
    let paths = paths.map(|entry| entry.expect("an entry").path());
    let scenes = paths.filter(|path| path.extension().is_some_and(|kind| kind == "json"));
    let mut count = 0;
    for path in scenes {
        let scene = Scene::read(&path).expect("a scene");
        assert_eq!(check(&scene), Ok(()), "{}", path.display());
        count += 1;
    }
    assert!(count > 0);
}
