//! Momentum, energy and angular momentum.

use approx::assert_abs_diff_eq;
use carom::body::{Disc, Mass};
use carom::scalar::{Exact, Number, Scalar};
use carom::scene::{Restitution, Scene};
use num_rational::BigRational;
use proptest::prelude::*;

use crate::common::agree::{contains_zero, rational};
use crate::common::strategy::{Chain, Masses, boxed, cases, chain, cluster};
use crate::common::{exactly, in_binary64, numbers, tolerance};

/// Momentum, angular momentum and twice the energy of discs of finite mass;
/// those of infinite mass must be at rest.
fn conserved<S: Scalar>(discs: &[Disc<S>]) -> [S; 4] {
    let mut sums = [0; 4].map(S::from_integer);
    for disc in discs {
        let Mass::Finite(mass) = &disc.mass else {
            continue;
        };
        let [x, y, vx, vy] = numbers(disc);
        let spin = x * &vy - y * &vx;
        let energy = vx.square() + vy.square();
        for (sum, part) in sums.iter_mut().zip([vx, vy, spin, energy]) {
            *sum = sum.clone() + part * mass;
        }
    }
    sums
}

/// With walls so far out that nothing gets there.
fn open(chain: Chain) -> Chain {
    let walls = [-1000, 1000].map(|x| BigRational::from_integer(x.into()));
    Chain { walls, ..chain }
}

fn four() -> BigRational {
    BigRational::from_integer(4.into())
}

fn with_loss(scene: &Scene, coefficient: &str) -> Scene {
    let restitution = Restitution::newton(coefficient.parse::<Number>().unwrap());
    scene.to_builder().restitution(restitution).build().unwrap()
}

proptest! {
    #![proptest_config(cases(100))]

    /// Of a rational run all is equal, ties or not.
    #[test]
    fn of_chains(chain in prop_oneof![chain(1), chain(97)]) {
        let outcome = exactly(&open(chain.clone()).scene(&four()));
        let [before, after] = [&outcome.start, &outcome.end]
            .map(|discs| conserved(discs).map(|sum| rational(&sum)));
        prop_assert_eq!(before, after);
        let outcome = exactly(&chain.scene(&four()));
        let [before, after] = [&outcome.start, &outcome.end]
            .map(|discs| rational(&conserved(discs)[3]));
        prop_assert_eq!(before, after);
    }

    /// A loss costs energy, if there is an impact at all, but no momentum.
    #[test]
    fn of_lossy_chains(chain in chain(97)) {
        let outcome = exactly(&with_loss(&open(chain).scene(&four()), "1/2"));
        let [before, after] = [&outcome.start, &outcome.end]
            .map(|discs| conserved(discs).map(|sum| rational(&sum)));
        prop_assert_eq!(&before[..3], &after[..3]);
        prop_assert_eq!(after[3] < before[3], !outcome.impacts.is_empty());
    }
}

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn of_clusters(scene in cluster()) {
        let outcome = exactly(&scene);
        let sums = conserved(&outcome.start).into_iter().zip(conserved(&outcome.end));
        for (before, after) in sums {
            prop_assert!(contains_zero(&(before - &after)), "{after:?}");
        }
    }

    #[test]
    fn of_lossy_clusters(scene in cluster()) {
        let outcome = exactly(&with_loss(&scene, "3/4"));
        let [before, after] = [&outcome.start, &outcome.end].map(|discs| conserved(discs));
        for index in 0..3 {
            let change = before[index].clone() - &after[index];
            prop_assert!(contains_zero(&change), "{change:?}");
        }
        let lost = before[3].to_f64() - after[3].to_f64();
        prop_assert_eq!(lost > tolerance::CONSERVATION, !outcome.impacts.is_empty());
    }

    /// Walls and bodies of infinite mass take up momentum, but no energy.
    #[test]
    fn of_energy_in_a_box(scene in boxed(Masses::Any)) {
        let outcome = exactly(&scene);
        let [before, after]: [Exact; 2] = [&outcome.start, &outcome.end]
            .map(|discs| conserved(discs)[3].clone());
        prop_assert!(contains_zero(&(before - &after)));
    }

    #[test]
    fn nearly_in_binary64(scene in cluster()) {
        let outcome = in_binary64(&scene);
        let [before, after] = [&outcome.start, &outcome.end].map(|discs| conserved(discs));
        // Momenta may cancel; their parts are of the size of the energy.
        let allowed = tolerance::CONSERVATION * (1.0 + before[3]);
        for (before, after) in before.into_iter().zip(after) {
            assert_abs_diff_eq!(before, after, epsilon = allowed);
        }
    }
}
