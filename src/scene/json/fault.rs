//! The parser's errors as errors of a scene.

use serde_json::error::Category;
use serde_path_to_error::Path;

use crate::scene::{SceneError, SceneErrorKind};

/// What is wrong where a key should be.
const MISSING: &str = "this key is missing";

/// An error of the parser while it was at that path.
pub(super) fn at_path(path: &Path, error: &serde_json::Error) -> SceneError {
    let reason = reason(error);
    match error.classify() {
        Category::Data => misfit(path, &reason),
        _ if reason == "number out of range" => misfit(path, "expected a finite binary64"),
        _ if reason == "trailing characters" => misfit(path, "expected the array to end here"),
        Category::Io | Category::Syntax | Category::Eof => syntax(error),
    }
}

/// A text with nothing in it.
pub(super) fn empty() -> SceneError {
    SceneError::from(SceneErrorKind::Syntax {
        line: 1,
        column: 1,
        reason: "expected a scene, found nothing".to_owned(),
    })
}

/// A text that is not JSON.
pub(super) fn syntax(error: &serde_json::Error) -> SceneError {
    SceneError::from(SceneErrorKind::Syntax {
        line: error.line(),
        column: error.column(),
        reason: reason(error),
    })
}

/// A key or value that has no place in a scene.
fn misfit(path: &Path, reason: &str) -> SceneError {
    let path = path.to_string();
    let is_root = path == ".";
    match missing_key(reason) {
        Some(key) if is_root => SceneError::format(key, MISSING),
        Some(key) => SceneError::format(format!("{path}.{key}"), MISSING),
        None if is_root => SceneError::format("the scene", reason),
        None => SceneError::format(path, reason),
    }
}

/// The key that the parser misses. It speaks of the object that lacks it; the
/// place of the error is that of the key.
fn missing_key(reason: &str) -> Option<&str> {
    reason.strip_prefix("missing field `")?.strip_suffix('`')
}

/// The parser's message without the position that it ends with.
fn reason(error: &serde_json::Error) -> String {
    let position = format!(" at line {} column {}", error.line(), error.column());
    let message = error.to_string();
    match message.strip_suffix(&position) {
        Some(reason) => reason.to_owned(),
        None => message,
    }
}
