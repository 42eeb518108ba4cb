//! Scenes at the edge of what binary64 tells apart: every decision of a run
//! must be right for its own state, within margins that are derived.

use carom::check::{check, construct};
use carom::scene::{Disc, Restitution, Scene};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// So many cases, the same ones in every run.
fn cases(count: u32) -> ProptestConfig {
    ProptestConfig {
        cases: count,
        rng_seed: RngSeed::Fixed(2009),
        failure_persistence: None,
        ..ProptestConfig::default()
    }
}

proptest! {
    #![proptest_config(cases(600))]

    #[test]
    fn constructed_scenes(bytes in prop::collection::vec(any::<u8>(), 0..80)) {
        let scene = construct::scene(&bytes);
        prop_assert_eq!(check(&scene), Ok(()));
    }

    /// A disc passes another at a distance of the radii but for 2⁻ᵏ, anywhere.
    #[test]
    fn near_tangency(
        exponent in 0..70_i32,
        sign in prop::sample::select(vec![-1.0, 0.0, 1.0]),
        offset in prop::sample::select(vec![0.0, 1e3, 1e8]),
        speed in 1..64_i32,
    ) {
        let beside = 2.0 + sign * f64::from(-exponent).exp2();
        let velocity = [f64::from(speed) / 8.0, 0.0];
        let scene = Scene::builder("graze")
            .disc(Disc::at([offset, offset], 1))
            .disc(Disc::at([offset - 7.0, offset + beside], 1).velocity(velocity))
            .frame(8, 8);
        prop_assert_eq!(check(&scene.build().unwrap()), Ok(()));
    }

    /// Two discs meet a third at times that differ by 2⁻ᵏ, with masses in any
    /// ratio.
    #[test]
    fn near_ties(exponent in 0..60_i32, ratio in -100..100_i32, loss in 0..5_i32) {
        let hair = f64::from(-exponent).exp2();
        let kept = carom::scalar::Number::try_from(f64::from(4 - loss) / 4.0).unwrap();
        let scene = Scene::builder("tie")
            .disc(Disc::at([0, 0], 1))
            .disc(Disc::at([-4.0 - hair, 0.0], 1.0).velocity([1, 0]).mass(f64::from(ratio).exp2()))
            .disc(Disc::at([2.4, 3.2], 1).velocity([-0.6, -0.8]))
            .walls_around([-9, -9], [9, 9])
            .restitution(Restitution::newton(kept))
            .frame(8, 4);
        prop_assert_eq!(check(&scene.build().unwrap()), Ok(()));
    }
}
