//! The pressure and the collision rate of gases of hard discs, against theory.
//!
//! ```text
//! cargo run --release --example gas_laws -- [DISCS] [IMPACTS]
//! ```
//!
//! In equilibrium at packing η two discs touch χ times as often as by chance. Then
//! Z = P A / (N k T) is 1 + 2 η χ, and by Enskog's theory there are N σ n χ √(π k T / m)
//! impacts in a unit of time, of N discs of diameter σ and density n. χ is known as
//!
//! - a series in 2 η, by the virial coefficients up to the tenth (N. Clisby, B. M. McCoy:
//!   Ninth and tenth order virial coefficients for hard spheres in D dimensions, 2006),
//!   here gone on with the ratio of the last two;
//! - about (1 - 7 η / 16) / (1 - η)² (D. Henderson: A simple equation of state for hard
//!   discs, 1975).
//!
//! What is measured is the virial: with the closing speed w of each impact,
//! Z - 1 = Σ m σ w / (2 N k T t).

use std::f64::consts::PI;

use carom::playback::Playback;
use carom::scalar::Number;
use carom::scene::Scene;
use carom::scene::generate::periodic_gas;

/// Discs have radius 1/2 and mass 1.
const DIAMETER: f64 = 1.0;

fn main() {
    let argument = |place, default| {
        let text = std::env::args().nth(place);
        text.map_or(default, |text| text.parse().expect("a whole number"))
    };
    let (discs, impacts) = (argument(1, 4000), argument(2, 4_000_000));
    println!("{discs} discs in a square that repeats, {impacts} impacts after a quarter as many");
    println!("         Z - 1     series          Henderson           impacts a time   Enskog");
    for packing in [0.1, 0.2, 0.3, 0.4, 0.5, 0.6] {
        let scene = periodic_gas(42, discs, packing).expect("a valid scene");
        let measured = measure(&scene, impacts as usize);
        let series = Expected::of(&scene, packing, measured.temperature, series(packing));
        let henderson = 2.0 * packing * henderson(packing);
        println!(
            "{packing:4} {:9.4} {:9.4} {:6.2} % {henderson:9.4} {:6.2} % {:9.1} {:9.1} {:6.2} %",
            measured.virial,
            series.virial,
            off(measured.virial, series.virial),
            off(measured.virial, henderson),
            measured.rate,
            series.rate,
            off(measured.rate, series.rate),
        );
    }
}

/// By how much a number is greater than another, in percent.
fn off(number: f64, than: f64) -> f64 {
    100.0 * (number / than - 1.0)
}

/// What a run comes to.
struct Measured {
    temperature: f64,
    /// Z - 1.
    virial: f64,
    /// Impacts in a unit of time.
    rate: f64,
}

fn measure(scene: &Scene, count: usize) -> Measured {
    let end = Number::from(20_000);
    let mut playback = Playback::<f64>::until(scene, &end, ()).expect("a scene that runs");
    // From the lattice to equilibrium.
    playback.impacts().take(count / 4).for_each(drop);
    let begun = *playback.time();
    let mut closing = 0.0;
    for impact in playback.impacts().take(count) {
        let Ok(impact) = impact;
        let contact = impact.contact.expect("the circumstances");
        let other = contact.other_velocity.expect("of a disc");
        let relative = other.minus(&contact.velocity);
        let length = contact.normal.norm_squared().sqrt();
        closing += relative.dot(&contact.normal).abs() / length;
    }
    let (time, discs) = (playback.time() - begun, scene.discs().len() as f64);
    let temperature = temperature(scene);
    Measured {
        temperature,
        virial: DIAMETER * closing / (2.0 * discs * temperature * time),
        rate: count as f64 / time,
    }
}

/// k T: what remains of the energy beside the motion of the whole, over N - 1.
fn temperature(scene: &Scene) -> f64 {
    let velocities = scene.discs().iter().map(|disc| disc.velocity_f64());
    let count = scene.discs().len() as f64;
    let mean = velocities.clone().sum::<glam::DVec2>() / count;
    let energy: f64 = velocities
        .map(|velocity| (velocity - mean).length_squared() / 2.0)
        .sum();
    energy / (count - 1.0)
}

/// What theory says.
struct Expected {
    /// Z - 1.
    virial: f64,
    /// Impacts in a unit of time.
    rate: f64,
}

impl Expected {
    /// With a χ.
    fn of(scene: &Scene, packing: f64, temperature: f64, contact: f64) -> Self {
        let density = packing / (PI * DIAMETER * DIAMETER / 4.0);
        let discs = scene.discs().len() as f64;
        Self {
            virial: 2.0 * packing * contact,
            rate: discs * DIAMETER * density * contact * (PI * temperature).sqrt(),
        }
    }
}

/// The third to tenth virial coefficients of hard discs, in powers of the second.
const COEFFICIENTS: [f64; 8] = [
    0.782_004_4,
    0.532_231_80,
    0.333_556_04,
    0.198_842_5,
    0.114_872_8,
    0.064_993_0,
    0.036_219_3,
    0.019_953_7,
];

/// χ by the virial series.
fn series(packing: f64) -> f64 {
    let power = 2.0 * packing;
    let [.., before, last] = COEFFICIENTS;
    let rest = last * (last / before) / (1.0 - power * last / before);
    let start = COEFFICIENTS
        .iter()
        .rev()
        .fold(rest, |sum, coefficient| coefficient + power * sum);
    1.0 + power * start
}

/// χ by Henderson's formula.
fn henderson(packing: f64) -> f64 {
    (1.0 - 7.0 * packing / 16.0) / (1.0 - packing).powi(2)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A thousand discs differ by a part of a thousand from very many; 10^5 impacts by
    /// three more.
    #[test]
    fn pressure_and_rate() {
        for packing in [0.2, 0.5] {
            let scene = periodic_gas(7, 1000, packing).expect("a valid scene");
            let measured = measure(&scene, 100_000);
            let contact = series(packing);
            let expected = Expected::of(&scene, packing, measured.temperature, contact);
            for off in [
                off(measured.virial, expected.virial),
                off(measured.rate, expected.rate),
            ] {
                assert!(off.abs() < 1.0, "{packing}: {off} percent");
            }
        }
    }

    /// Z - 1 is 3.125 at 1/2 by Henderson; the sum of the coefficients is 3.0827, and
    /// what is left of it about 0.0245.
    #[test]
    fn at_half_packing() {
        assert!((henderson(0.5) - 3.125).abs() < 1e-12);
        assert!((series(0.5) - 3.1072).abs() < 1e-3);
    }
}
