//! What the fuzz targets share: a scene from bytes, and how a finding is told.

use carom::check::{Effort, Finding, check_with, construct, minimise};
use carom::scene::Scene;

/// Checks the scene that bytes stand for. What is found ends the campaign, with
/// a scene that is ready to be kept as a regression.
///
/// # Panics
///
/// There is a finding.
pub fn check_bytes(bytes: &[u8], effort: &Effort) {
    let scene = construct::scene(bytes);
    if let Err(finding) = check_with(&scene, effort) {
        panic!("{}", report(&scene, &finding));
    }
}

fn report(scene: &Scene, finding: &Finding) -> String {
    let smaller = minimise(scene, finding).to_json();
    format!("{finding}\n{smaller}\nto replay it: carom fuzz-check FILE, with this scene in FILE")
}
