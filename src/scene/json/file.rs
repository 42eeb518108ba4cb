//! Scenes in files and on standard input.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use super::Parts;
use crate::scene::{Scene, SceneError, SceneErrorKind};

/// No scene is larger; a device without an end is.
const MAX_BYTES: u64 = 1 << 28;

impl Scene {
    /// Reads a scene from a JSON file, or from standard input if the path is
    /// `-`. A scene without a name is given that of the file.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, SceneError> {
        let path = path.as_ref();
        let name = match is_standard_input(path) {
            true => "standard input".to_owned(),
            false => path.display().to_string(),
        };
        read(path).map_err(|error| error.in_file(&name))
    }
}

fn read(path: &Path) -> Result<Scene, SceneError> {
    let mut parts = Parts::parse(&read_text(path)?)?;
    if parts.id.is_none() && !is_standard_input(path) {
        parts.id = path
            .file_stem()
            .map(|stem| stem.to_string_lossy().into_owned());
    }
    Scene::try_from(parts)
}

fn is_standard_input(path: &Path) -> bool {
    path == Path::new("-")
}

fn read_text(path: &Path) -> Result<String, SceneError> {
    let bytes = read_bytes(path).map_err(SceneErrorKind::Unreadable)?;
    String::from_utf8(bytes).map_err(|error| not_utf8(error.as_bytes(), &error.utf8_error()))
}

fn read_bytes(path: &Path) -> io::Result<Vec<u8>> {
    if is_standard_input(path) {
        read_limited(io::stdin().lock())
    } else {
        read_limited(File::open(path)?)
    }
}

fn read_limited(source: impl Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    source.take(MAX_BYTES + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > MAX_BYTES {
        let reason = format!("expected at most {} MiB", MAX_BYTES >> 20);
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, reason));
    }
    Ok(bytes)
}

fn not_utf8(bytes: &[u8], error: &std::str::Utf8Error) -> SceneError {
    let valid = &bytes[..error.valid_up_to()];
    let last = valid.rsplit(|&byte| byte == b'\n').next();
    SceneError::from(SceneErrorKind::Syntax {
        line: valid.split(|&byte| byte == b'\n').count(),
        column: last.map_or(0, <[u8]>::len) + 1,
        reason: "expected UTF-8 text".to_owned(),
    })
}
