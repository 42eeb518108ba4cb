//! Filtered arithmetic against its definition, and what follows from that.

#[path = "filtered/falling.rs"]
mod falling;
#[path = "filtered/fraction.rs"]
mod fraction;
#[path = "filtered/predicates.rs"]
mod predicates;
#[path = "filtered/reference.rs"]
mod reference;
#[path = "../src/roots/tests/sturm.rs"]
#[allow(dead_code, reason = "other tests use more of it")]
mod sturm;

use crate::common::strategy::{Masses, boxed, cases, cluster, lossy};
use crate::common::{attempt, name};
use carom::run::{Options, Outcome};
use carom::scalar::Filtered;
use carom::scene::Scene;
use carom::simulation::Algorithm;
use proptest::prelude::*;
use reference::Reference;

fn run(scene: &Scene, impacts: u64) -> Outcome<Filtered> {
    let options = Options {
        max_events: impacts,
        contacts: true,
        ..Options::default()
    };
    attempt(scene, Algorithm::Timeline, &options)
}

/// Asserts that a run is bit for bit that of the reference.
fn assert_as_defined(scene: &Scene, impacts: u64) {
    let outcome = run(scene, impacts);
    let mut reference = Reference::new(scene);
    for (number, impact) in outcome.impacts.iter().enumerate() {
        let expected = reference.next().expect("as many impacts");
        let found = (name(impact), impact.time.get());
        assert_eq!(found, (expected.name, expected.time), "impact {number}");
        let velocity = impact.contact.as_ref().unwrap().velocity;
        let carom::body::BodyId::Disc(disc) = impact.pair.a else {
            panic!("a disc comes first");
        };
        let stored = reference.bodies[disc as usize].speed;
        assert_eq!(
            [velocity.x.get(), velocity.y.get()],
            stored,
            "impact {number}"
        );
    }
    if (outcome.impacts.len() as u64) < impacts {
        assert!(reference.next().is_none(), "no more impacts");
    }
}

proptest! {
    #![proptest_config(cases(24))]

    /// Discs and oblique walls in a box, some of infinite mass.
    #[test]
    fn boxes(scene in boxed(Masses::Any)) {
        assert_as_defined(&scene, 40);
    }

    /// The same with all kinds of restitution.
    #[test]
    fn losses(scene in lossy()) {
        assert_as_defined(&scene, 40);
    }

    /// Discs that are close, overlapping or not.
    #[test]
    fn clusters(scene in cluster()) {
        assert_as_defined(&scene, 40);
    }
}

#[cfg(feature = "cli")]
mod gases {
    use carom::body::Disc;
    use carom::scene::generate::gas;
    use carom::timeline::Timeline;
    use carom::world::World;

    use super::*;

    /// Numbers of which all 53 bits are random.
    #[test]
    fn follow_the_definition() {
        for seed in 0..4 {
            assert_as_defined(&gas(seed, 10, 0.4).unwrap(), 60);
        }
    }

    const LONG: u64 = 10_000;

    fn long() -> Scene {
        let scene = gas(7, 20, 0.4).unwrap().to_builder();
        scene.frame(1_000_000, 1).build().unwrap()
    }

    /// What the reference's run comes to: see below.
    const HASH: u64 = 0xe934_066d_61ee_1ff2;

    /// All times, names and velocities of a run, by the hash of Fowler, Noll and
    /// Vo (FNV-1a).
    #[derive(Debug, PartialEq)]
    struct Hash(u64);

    impl Hash {
        fn new() -> Self {
            Self(0xcbf2_9ce4_8422_2325)
        }

        fn add(&mut self, name: &str, numbers: [f64; 3]) {
            let numbers = numbers
                .iter()
                .flat_map(|number| number.to_bits().to_le_bytes());
            for byte in name.bytes().chain(numbers) {
                self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
            }
        }
    }

    /// Nothing overlaps by more than the bound that `carom::filtered` derives,
    /// with as much again for the places that are looked at, which are rounded
    /// as well; and the energy hardly drifts.
    #[test]
    fn overlap_by_rounding_alone() {
        let scene = gas(1, 100, 0.5).unwrap();
        let world = World::<Filtered>::new(&scene, ());
        let energy = |discs: &[Disc<Filtered>]| -> f64 {
            let squares = discs.iter().map(|disc| disc.velocity.norm_squared().get());
            squares.sum()
        };
        let (before, size) = (energy(&world.discs), world.walls[1].segment.to.x.get());
        let end = Filtered::new(1e6);
        let Ok(mut timeline) = Timeline::new(world, &end);
        for _ in 0..400 {
            for _ in 0..50 {
                let Ok(impact) = timeline.next_impact(&end);
                assert!(impact.is_some());
            }
            let now = *timeline.now();
            let discs = timeline.discs_at(&now);
            assert!((energy(&discs) / before - 1.0).abs() < 1e-12);
            let ulp = |x: f64| x.next_up() - x;
            let speed = discs
                .iter()
                .map(|disc| disc.velocity.norm_squared().get().sqrt());
            let speed = speed.fold(0.0, f64::max);
            let bound = 2.0 * (2.0_f64.sqrt() * ulp(size) + speed * ulp(now.get()));
            for (place, disc) in discs.iter().enumerate() {
                let radius = disc.radius.get();
                for coordinate in [disc.position.x.get(), disc.position.y.get()] {
                    assert!(coordinate >= radius - bound && coordinate <= size - radius + bound);
                }
                for other in &discs[place + 1..] {
                    let offset = other.position.minus(&disc.position);
                    let apart = offset.x.get().hypot(offset.y.get());
                    assert!(apart >= radius + other.radius.get() - bound);
                }
            }
        }
    }

    #[test]
    fn have_the_same_bits_everywhere() {
        let mut hash = Hash::new();
        for impact in run(&long(), LONG).impacts {
            let [x, y] = impact.contact.as_ref().unwrap().velocity.into();
            hash.add(&name(&impact), [impact.time, x, y].map(Filtered::get));
        }
        assert_eq!(hash, Hash(HASH));
    }

    /// `cargo test --release --test suite -- --ignored`: some minutes of
    /// fractions, to find the hash.
    #[test]
    #[ignore = "takes minutes: named above"]
    fn of_the_reference_have_these_bits() {
        let mut reference = Reference::new(&long());
        let mut hash = Hash::new();
        for _ in 0..LONG {
            let hit = reference.next().expect("as many impacts");
            let disc: usize = hit.name[1..].split(' ').next().unwrap().parse().unwrap();
            let [x, y] = reference.bodies[disc].speed;
            hash.add(&hit.name, [hit.time, x, y]);
        }
        assert_eq!(hash, Hash(HASH));
    }
}
