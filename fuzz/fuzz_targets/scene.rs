//! Any text as a scene: it is refused with a place and a reason, or valid, and
//! then written and read back the same.
#![no_main]

use carom::scene::Scene;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let Ok(text) = std::str::from_utf8(bytes) else {
        return;
    };
    match Scene::from_json(text) {
        Ok(scene) => read_back(&scene),
        Err(error) => assert!(!error.to_string().is_empty()),
    }
});

fn read_back(scene: &Scene) {
    let written = scene.to_json();
    let read = Scene::from_json(&written).expect("what is written is read");
    assert_eq!(read, *scene);
    assert_eq!(read.to_json(), written);
    assert_eq!(scene.to_builder().build().expect("it is valid"), *scene);
}
