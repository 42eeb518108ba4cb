//! How a scene is laid out in a file: a key a line, a disc or a wall a line.

use std::io::{self, Write};

use serde::Serialize;
use serde_json::ser::{Formatter, Serializer};

/// The value as JSON text. The outermost object has a key a line, an array in
/// it an item a line; all else stays on its line.
pub(super) fn line_an_item(value: &impl Serialize) -> String {
    let mut text = Vec::new();
    let mut serializer = Serializer::with_formatter(&mut text, Layout::default());
    value
        .serialize(&mut serializer)
        .expect("keys are strings, and memory takes every write");
    text.push(b'\n');
    String::from_utf8(text).expect("JSON is written as UTF-8")
}

/// The brackets that are open, from the outermost in: whether each has an
/// item a line.
#[derive(Default)]
struct Layout {
    open: Vec<bool>,
}

impl Layout {
    fn is_spread(&self) -> bool {
        self.open.last() == Some(&true)
    }

    fn open<W: ?Sized + Write>(
        &mut self,
        writer: &mut W,
        bracket: &[u8],
        spread: bool,
    ) -> io::Result<()> {
        self.open.push(spread);
        writer.write_all(bracket)
    }

    fn close<W: ?Sized + Write>(&mut self, writer: &mut W, bracket: &[u8]) -> io::Result<()> {
        if self.open.pop() == Some(true) {
            self.break_line(writer)?;
        }
        writer.write_all(bracket)
    }

    /// Goes to where the next item starts.
    fn next<W: ?Sized + Write>(&self, writer: &mut W, first: bool) -> io::Result<()> {
        match (self.is_spread(), first) {
            (true, true) => self.break_line(writer),
            (true, false) => {
                writer.write_all(b",")?;
                self.break_line(writer)
            }
            (false, true) => Ok(()),
            (false, false) => writer.write_all(b", "),
        }
    }

    fn break_line<W: ?Sized + Write>(&self, writer: &mut W) -> io::Result<()> {
        writer.write_all(b"\n")?;
        self.open.iter().try_for_each(|_| writer.write_all(b"  "))
    }
}

impl Formatter for Layout {
    fn begin_array<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        let spread = self.open.len() == 1;
        self.open(writer, b"[", spread)
    }

    fn end_array<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.close(writer, b"]")
    }

    fn begin_array_value<W: ?Sized + Write>(
        &mut self,
        writer: &mut W,
        first: bool,
    ) -> io::Result<()> {
        self.next(writer, first)
    }

    fn begin_object<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        let spread = self.open.is_empty();
        self.open(writer, b"{", spread)
    }

    fn end_object<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.close(writer, b"}")
    }

    fn begin_object_key<W: ?Sized + Write>(
        &mut self,
        writer: &mut W,
        first: bool,
    ) -> io::Result<()> {
        self.next(writer, first)
    }

    fn begin_object_value<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        writer.write_all(b": ")
    }
}
