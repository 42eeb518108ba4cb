//! Makes the seeds: `cargo run --example seeds` writes them to `seeds/<target>/`.
//!
//! The same ones every time: scenes of each kind of part, for the targets that
//! construct scenes; the scenes of the gallery and what is wrong with them, for
//! the parser; numbers of each form.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

fn main() -> io::Result<()> {
    constructed("spurious")?;
    constructed("overlap")?;
    scenes()?;
    for (index, bytes) in numbers().iter().enumerate() {
        write("exact", &format!("{index}"), bytes)?;
    }
    for step in 1..9_u8 {
        let bytes: Vec<u8> = (0..180)
            .map(|place: u8| place.wrapping_mul(29 * step))
            .collect();
        write("predicates", &format!("{step}"), &bytes)?;
    }
    Ok(())
}

fn write(target: &str, name: &str, content: &[u8]) -> io::Result<()> {
    let directory = root().join("seeds").join(target);
    fs::create_dir_all(&directory)?;
    fs::write(directory.join(name), content)
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).to_path_buf()
}

/// One scene for each kind of part and a few choices within it.
fn constructed(target: &str) -> io::Result<()> {
    for part in 0..7_u8 {
        for variant in 0..3_u8 {
            let place = [variant, 0, 0, 1, 0, part];
            let choices = (0..40).map(|step: u8| step.wrapping_mul(37 * variant + 11) ^ part);
            let bytes: Vec<u8> = place.into_iter().chain(choices).collect();
            write(target, &format!("part{part}-{variant}"), &bytes)?;
        }
    }
    Ok(())
}

/// The smaller scenes that come with the library, whole and cut off.
fn scenes() -> io::Result<()> {
    for entry in fs::read_dir(root().join("../scenes"))? {
        let path = entry?.path();
        if path.extension().is_none_or(|kind| kind != "json") {
            continue;
        }
        let text = fs::read(&path)?;
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        if text.len() < 2000 {
            write("scene", &name, &text)?;
        }
    }
    let odd = [
        r#"{"schema":"carom/scene/1","discs":[{"position":["1e-30","-0x1.8p+1"],"radius":"1/3","mass":"infinite"}],"effects":{"restitution":{"newton":"9/10","walls":0.5,"elastic_below":1e-9},"gravity":[0,"-981/100"],"drag":{"linear":"1/10"}}}"#,
        r#"{"schema":"carom/scene/1","discs":[],"periodic":{"from":[0,0],"to":[10,1e1]},"effects":{"restitution":{"paper":"1/2"}}}"#,
        r#"{"schema":"carom/scene/1","discs":[{"position":[0,null],"radius":-1}]"#,
    ];
    for (index, text) in odd.iter().enumerate() {
        write("scene", &format!("odd-{index}"), text.as_bytes())?;
    }
    Ok(())
}

/// Programs of the number target: any bytes do.
fn numbers() -> Vec<Vec<u8>> {
    let program = |factor: u8| (0..96).map(|step: u8| step.wrapping_mul(factor)).collect();
    [29, 73, 151, 211].map(program).to_vec()
}
