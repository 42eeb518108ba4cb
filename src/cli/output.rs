//! Where results go: files, or standard output.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use super::error::Error;

/// A file, or standard output if its path is `-`.
pub(super) struct Output {
    name: String,
    writer: Box<dyn Write>,
}

impl Output {
    /// Opens it for writing.
    pub(super) fn open(path: &Path) -> Result<Self, Error> {
        if is_standard(path) {
            return Ok(Self {
                name: String::from("standard output"),
                writer: Box::new(BufWriter::new(io::stdout().lock())),
            });
        }
        let name = path.display().to_string();
        match File::create(path) {
            Ok(file) => Ok(Self {
                name,
                writer: Box::new(BufWriter::new(file)),
            }),
            Err(reason) => Err(Error::Unwritable { file: name, reason }),
        }
    }

    /// Writes all of a result.
    pub(super) fn write(
        mut self,
        write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> Result<(), Error> {
        let writer = &mut self.writer;
        let written = write(writer).and_then(|()| writer.flush());
        written.map_err(|reason| Error::Unwritable {
            file: self.name,
            reason,
        })
    }

    /// Writes a text.
    pub(super) fn write_text(self, text: &str) -> Result<(), Error> {
        self.write(|writer| writer.write_all(text.as_bytes()))
    }
}

/// Makes a directory for results, unless it is there.
pub(super) fn make_directory(path: &Path) -> Result<(), Error> {
    fs::create_dir_all(path).map_err(|reason| Error::Unwritable {
        file: path.display().to_string(),
        reason,
    })
}

/// Whether all results go to places of their own: a file holds one, and so does standard
/// output. Each is told by its option.
pub(super) fn check_distinct(outputs: &[(&str, &Option<PathBuf>)]) -> Result<(), Error> {
    for (place, (option, path)) in outputs.iter().enumerate() {
        let others = &outputs[..place];
        let same = others.iter().find(|(_, other)| other == path);
        if let (Some((other, _)), Some(path)) = (same, path) {
            return Err(Error::Usage(format!(
                "{}: expected only one of {other} and {option}",
                path.display()
            )));
        }
    }
    Ok(())
}

/// Whether a path means standard input or output.
pub(super) fn is_standard(path: &Path) -> bool {
    path == Path::new("-")
}

/// The path that means standard input or output.
pub(super) fn standard() -> PathBuf {
    PathBuf::from("-")
}
