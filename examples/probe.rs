//! probe
use carom::check::{check, construct};
fn main() {
    let mut s = 88172645463325252u64 + std::env::args().nth(1).map_or(0, |a| a.parse().unwrap());
    let n: u32 = std::env::args().nth(2).map_or(1000, |a| a.parse().unwrap());
    let t = std::time::Instant::now();
    let mut kinds = std::collections::BTreeMap::<String, (u32, Vec<u8>, String)>::new();
    for _ in 0..n {
        let bytes: Vec<u8> = (0..64)
            .map(|_| {
                s ^= s << 13;
                s ^= s >> 7;
                s ^= s << 17;
                (s >> 32) as u8
            })
            .collect();
        let scene = construct::scene(&bytes);
        if let Err(f) = check(&scene) {
            let key = format!("{:?}{:?}", f.kind, f.run)
                .chars()
                .filter(|c| !c.is_ascii_digit())
                .collect();
            let e = kinds.entry(key).or_insert((0, bytes, f.to_string()));
            e.0 += 1;
        }
    }
    for (k, (n, b, f)) in &kinds {
        println!("{n} {k}: {f}\n{}", construct::scene(b).to_json());
    }
    println!("{:?} a scene", t.elapsed() / n);
}
