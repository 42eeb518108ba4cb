//! Scenes: what is read, what is refused and with which words, and what is
//! written.
#![cfg(feature = "json")]

use std::fs;
use std::path::{Path, PathBuf};

use carom::scalar::Number;
use carom::scene::{Disc, IntoNumber, Mass, Restitution, Scene, SceneError, SceneErrorKind};
use num_rational::BigRational;

/// The example of the interface, to the letter.
const EXAMPLE: &str = r#"{
  "schema": "carom/scene/1",
  "id": "example",
  "notes": "free text",
  "discs": [
    {"position": [0, 1], "velocity": ["3/2", 0], "radius": 1, "mass": 1},
    {"position": [5, "1/3"], "velocity": [0, 0], "radius": 1, "mass": "infinite"}
  ],
  "walls": [{"from": [-1, -1], "to": [10, -1]}],
  "frame": {"duration": "1/60", "count": 600},
  "effects": {
    "restitution": {"newton": "9/10"},
    "gravity": [0, "-981/100"],
    "drag": {"linear": "1/10"}
  }
}"#;

fn ratio(numerator: i64, denominator: i64) -> BigRational {
    BigRational::new(numerator.into(), denominator.into())
}

fn number(value: impl IntoNumber) -> Number {
    value.into_number().expect("a number")
}

fn point(x: &str, y: &str) -> [BigRational; 2] {
    exact(&[number(x), number(y)])
}

fn exact(point: &[Number; 2]) -> [BigRational; 2] {
    [point[0].to_rational(), point[1].to_rational()]
}

/// A scene of one disc whose radius is written like that.
fn with_radius(radius: &str) -> Result<Scene, SceneError> {
    with_disc(&format!(r#""position": [0, 0], "radius": {radius}"#))
}

fn with_disc(keys: &str) -> Result<Scene, SceneError> {
    Scene::from_json(&format!(
        r#"{{"schema": "carom/scene/1", "discs": [{{{keys}}}]}}"#
    ))
}

fn radius(scene: &Scene) -> &Number {
    &scene.discs()[0].radius
}

fn repository() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn committed(name: &str) -> PathBuf {
    repository().join("scenes").join(name)
}

/// The scene files that come with the library, but for the hard cases, which
/// hold more than a scene.
fn committed_scenes() -> impl Iterator<Item = PathBuf> {
    let entries = fs::read_dir(committed("")).expect("scenes");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    paths.filter(|path| path.is_file())
}

/// Splitmix64: numbers that need no library.
struct Bits(u64);

impl Bits {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn positive(&mut self) -> f64 {
        let number = f64::from_bits(self.next()).abs();
        match number.is_finite() && number > 0.0 {
            true => number,
            false => self.positive(),
        }
    }
}

#[path = "scene/reading.rs"]
mod reading;

#[path = "scene/refusing.rs"]
mod refusing;

#[path = "scene/files.rs"]
mod files;

#[path = "scene/writing.rs"]
mod writing;

#[path = "scene/gallery.rs"]
mod gallery;

#[cfg(feature = "cli")]
#[path = "scene/generated.rs"]
mod generated;

#[cfg(feature = "cli")]
#[path = "scene/families.rs"]
mod families;

#[cfg(feature = "cli")]
#[test]
fn the_committed_schema_is_fresh() {
    let file = repository().join("schema/scene.schema.json");
    let committed = fs::read_to_string(file).expect("the schema");
    assert!(
        committed == carom::scene::scene_schema(),
        "stale: carom schema scene > schema/scene.schema.json"
    );
}
