//! Two impacts at almost, or truly, the same time.

use num_rational::BigRational;

use super::parts::{Written, at, disc, point, ratio, told, whole};
use super::place::placed;
use crate::scene::generate::random::Random;
use crate::scene::{Scene, SceneBuilder, SceneError};

pub(super) fn draw(random: &mut Random) -> Result<SceneBuilder, SceneError> {
    let tie = Tie {
        later: random.tiny(20, 60),
        time: random.whole(2, 6),
    };
    let (scene, kind) = match random.whole(0, 3) {
        0 => (tie.two_discs(random), "a disc meets two discs"),
        1 => (tie.disc_and_wall(random), "a disc meets a wall and a disc"),
        2 => (tie.two_walls(random), "two discs meet a wall each"),
        _ => (tie.two_pairs(random), "two pairs of discs meet"),
    };
    let notes = format!("At one time, but for {}, {kind}.", told(&tie.later));
    let scene = scene.notes(notes).frame(Written(ratio(tie.time, 2)), 6);
    placed(scene, random)
}

/// When two things happen: at whole times, or almost.
struct Tie {
    /// How much later the second one is.
    later: BigRational,
    time: i64,
}

impl Tie {
    fn second(&self) -> BigRational {
        whole(self.time) + &self.later
    }

    /// Between two discs on both sides of its path. With the distance R of the centres
    /// and the height y it meets them √(R² - y²) before it is there.
    fn two_discs(&self, random: &mut Random) -> SceneBuilder {
        let [reach, height] = random.one_of(&[
            [ratio(5, 1), ratio(3, 1)],
            [ratio(5, 1), ratio(4, 1)],
            [ratio(4, 1), ratio(7, 2)],
            [ratio(3, 1), ratio(2, 1)],
            [ratio(13, 4), ratio(5, 4)],
        ]);
        let speed = whole(random.one_of(&[1, 2, 4]));
        let radius = &height / whole(2);
        let start = -&speed * whole(self.time) - &reach;
        let own = disc(
            [start, whole(0)],
            [speed.clone(), whole(0)],
            reach - &radius,
        );
        let other = |x: BigRational, y: BigRational| disc([x, y], at(0, 0), radius.clone());
        let mass = random.one_of(&[1, 1, 2]);
        let far = other(&self.later * speed, -&height).mass(mass);
        let near = other(whole(0), height).mass(mass);
        Scene::builder("").disc(own).disc(near).disc(far)
    }

    /// Down to the axis, with a smaller one at its side that comes nearer.
    fn disc_and_wall(&self, random: &mut Random) -> SceneBuilder {
        let fall = whole(random.whole(1, 3));
        let along = whole(random.whole(-2, 2));
        let closing = whole(random.one_of(&[1, 2, 4]));
        let height = &fall * whole(self.time) + whole(1);
        let gap = ratio(3, 2) + &closing * self.second();
        let velocity = [along.clone(), -&fall];
        let own = disc([whole(0), height.clone()], velocity, whole(1));
        let other = disc([gap, height], [along - closing, -fall], ratio(1, 2));
        Scene::builder("")
            .disc(own)
            .disc(other)
            .wall([-90, 0], [90, 0])
    }

    /// To both sides; then they come back and meet.
    fn two_walls(&self, random: &mut Random) -> SceneBuilder {
        let [left, right] = [0, 1].map(|_| whole(random.whole(1, 3)));
        let own = disc(at(-3, 0), [-&left, whole(0)], whole(1));
        let other = disc([whole(3), ratio(1, 2)], [right.clone(), whole(0)], whole(1));
        let walls = [
            -left * whole(self.time) - whole(4),
            right * self.second() + whole(4),
        ];
        let scene = Scene::builder("").disc(own).disc(other);
        walls.into_iter().fold(scene, |scene, x| {
            let [from, to] = [-40, 40].map(|y| point([x.clone(), whole(y)]));
            scene.wall(from, to)
        })
    }

    /// Far from each other, with the same offset: the times may be irrational.
    fn two_pairs(&self, random: &mut Random) -> SceneBuilder {
        let speed = whole(random.one_of(&[1, 2, 4]));
        let offset = random.one_of(&[ratio(0, 1), ratio(1, 1), ratio(6, 5), ratio(3, 2)]);
        let way = &speed * whole(self.time) + whole(2);
        // Both discs of the second pair start a little further out.
        let pair = |middle: i64, more: BigRational| {
            let (high, x) = (whole(middle) + &offset, &way + more * &speed);
            let left = [[-&x, whole(middle)], [speed.clone(), whole(0)]];
            let right = [[x, high], [-&speed, whole(0)]];
            [left, right].map(|[place, velocity]| disc(place, velocity, whole(1)))
        };
        let discs = [pair(0, whole(0)), pair(9, self.later.clone())];
        Scene::builder("").discs(discs.into_iter().flatten())
    }
}
