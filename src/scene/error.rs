//! What is wrong with a scene, and where.

use std::fmt;
use std::io;

/// Why there is no scene.
#[derive(Debug)]
pub struct SceneError {
    file: Option<String>,
    kind: Box<SceneErrorKind>,
}

/// What is wrong with a scene.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SceneErrorKind {
    /// The file cannot be read.
    #[error("cannot be read: {0}")]
    Unreadable(#[source] io::Error),

    /// The text is not JSON at all.
    #[error("line {line}, column {column}: {reason}")]
    Syntax {
        /// The line, counted from 1.
        line: usize,
        /// The column, counted from 1.
        column: usize,
        /// What the parser has to say.
        reason: String,
    },

    /// A key is unknown or missing, or a value is not of its type: the text
    /// is not a scene.
    #[error("{place}: {reason}")]
    Format {
        /// Where, as a JSON path such as `discs[3].radius`.
        place: String,
        /// What was expected and what was found.
        reason: String,
    },

    /// The scene is well-formed but cannot be simulated.
    #[error("{place}: expected {expected}, found {found}")]
    Physical {
        /// Where, as a JSON path such as `discs[3].radius`.
        place: String,
        /// What makes sense there.
        expected: String,
        /// What is there.
        found: String,
    },
}

impl SceneError {
    /// What is wrong.
    pub fn kind(&self) -> &SceneErrorKind {
        &self.kind
    }

    /// Where it is, as a JSON path such as `discs[3].radius`.
    pub fn place(&self) -> Option<&str> {
        match self.kind() {
            SceneErrorKind::Format { place, .. } | SceneErrorKind::Physical { place, .. } => {
                Some(place)
            }
            SceneErrorKind::Unreadable(_) | SceneErrorKind::Syntax { .. } => None,
        }
    }

    /// The file that the scene was read from.
    pub fn file(&self) -> Option<&str> {
        self.file.as_deref()
    }

    pub(super) fn format(place: impl Into<String>, reason: impl fmt::Display) -> Self {
        Self::from(SceneErrorKind::Format {
            place: place.into(),
            reason: reason.to_string(),
        })
    }

    pub(super) fn physical(
        place: impl Into<String>,
        expected: impl Into<String>,
        found: impl fmt::Display,
    ) -> Self {
        Self::from(SceneErrorKind::Physical {
            place: place.into(),
            expected: expected.into(),
            found: found.to_string(),
        })
    }

    #[cfg(feature = "json")]
    pub(super) fn in_file(self, file: &str) -> Self {
        Self {
            file: Some(file.to_owned()),
            ..self
        }
    }
}

impl From<SceneErrorKind> for SceneError {
    fn from(kind: SceneErrorKind) -> Self {
        Self {
            file: None,
            kind: Box::new(kind),
        }
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.file {
            Some(file) => write!(f, "{file}: {}", self.kind),
            None => self.kind.fmt(f),
        }
    }
}

impl std::error::Error for SceneError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        self.kind.source()
    }
}
