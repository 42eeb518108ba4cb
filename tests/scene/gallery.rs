//! The scenes that come with the library.

use super::*;

#[test]
fn every_committed_scene_loads_and_is_named_like_its_file() {
    for path in committed_scenes() {
        let scene = Scene::read(&path).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(path.file_stem(), Some(scene.id().as_ref()));
        assert!(scene.notes().is_some(), "{}", scene.id());
    }
}

#[test]
fn only_the_resting_discs_of_figure_6_overlap() {
    let overlapping = Scene::read(committed("figure-6-still-still.json")).expect("a scene");
    // The centres are 3/2 apart: 36/25 + 81/100 = 9/4.
    let [a, b] = overlapping.discs() else {
        panic!("two discs")
    };
    assert_eq!(exact(&a.position), point("0", "0"));
    assert_eq!(exact(&b.position), point("6/5", "9/10"));
}
