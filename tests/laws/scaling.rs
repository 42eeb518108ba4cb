//! Units of length, time and mass that differ by powers of two change nothing
//! but exponents: in binary64 every bit of every mantissa stays.

use carom::scalar::Number;
use carom::scene::{Disc, Mass, Restitution, Scene};
use proptest::prelude::*;

use crate::common::strategy::{cases, lossy, within};
use crate::common::{in_binary64, names, numbers};

/// How many of the new units an old one is.
#[derive(Clone, Copy, Debug)]
struct Units {
    length: f64,
    time: f64,
    mass: f64,
}

impl Units {
    fn speed(self) -> f64 {
        self.length / self.time
    }

    fn of(self, scene: &Scene) -> Scene {
        let place = |at: &[Number; 2]| at.clone().map(|number| times(&number, self.length));
        let discs = scene.discs().iter().map(|disc| Disc {
            position: place(&disc.position),
            velocity: disc
                .velocity
                .clone()
                .map(|number| times(&number, self.speed())),
            radius: times(&disc.radius, self.length),
            mass: match &disc.mass {
                Mass::Finite(mass) => Mass::Finite(times(mass, self.mass)),
                Mass::Infinite => Mass::Infinite,
            },
        });
        let frame = scene.frame();
        let scaled = Scene::builder(scene.id())
            .frame(times(&frame.duration, self.time), frame.count)
            .restitution(self.of_restitution(&scene.effects().restitution))
            .discs(discs);
        let walls = scene.walls().iter();
        let scaled = walls.fold(scaled, |scaled, wall| {
            scaled.wall(place(&wall.from), place(&wall.to))
        });
        scaled.build().expect("a valid scene")
    }

    fn of_restitution(self, restitution: &Restitution) -> Restitution {
        let mut scaled = restitution.clone();
        if let Restitution::Newton {
            elastic_below: Some(speed),
            ..
        } = &mut scaled
        {
            *speed = times(speed, self.speed());
        }
        scaled
    }
}

fn times(number: &Number, factor: f64) -> Number {
    Number::try_from(number.to_f64() * factor).expect("a finite number")
}

fn power() -> impl Strategy<Value = f64> {
    (-20..=20).prop_map(|exponent| 2_f64.powi(exponent))
}

fn units() -> impl Strategy<Value = Units> {
    [power(), power(), power()].prop_map(|[length, time, mass]| Units { length, time, mass })
}

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn units_do_not_matter(scene in slowly_elastic(), units in units()) {
        let (before, after) = (in_binary64(&scene), in_binary64(&units.of(&scene)));
        prop_assert_eq!(names(&before.impacts), names(&after.impacts));
        for (one, other) in before.impacts.iter().zip(&after.impacts) {
            prop_assert_eq!(one.time * units.time, other.time);
        }
        let scales = [units.length, units.length, units.speed(), units.speed()];
        for (one, other) in before.end.iter().zip(&after.end) {
            let numbers = numbers(one).into_iter().zip(numbers(other));
            for ((one, other), scale) in numbers.zip(scales) {
                prop_assert_eq!(one * scale, other);
            }
        }
    }
}

/// Lossy scenes, in which slow impacts may lose nothing.
fn slowly_elastic() -> impl Strategy<Value = Scene> {
    (lossy(), within(0.5, 2.0)).prop_map(|(scene, speed)| {
        let mut restitution = scene.effects().restitution.clone();
        if let Restitution::Newton { elastic_below, .. } = &mut restitution {
            *elastic_below = Some(Number::try_from(speed).expect("a finite number"));
        }
        let scene = scene.to_builder().restitution(restitution);
        scene.build().expect("a valid scene")
    })
}
