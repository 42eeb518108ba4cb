//! Impacts that symmetry makes simultaneous, in frames that hide it.

use std::cmp::Ordering::{self, Equal, Less};

use carom::algebra::Expression;
use carom::body::{Disc, Mass};
use carom::detect::meet_circle;
use carom::respond::{Normal, Restitution, collide_discs};
use carom::scalar::{Scalar, Undecided};
use carom::vec2::Vec2;

use super::number;

/// A frame: turned by an angle of rational sine and cosine, mirrored, moved.
#[derive(Clone, Copy)]
struct Frame {
    turn: [&'static str; 2],
    mirror: bool,
    shift: [&'static str; 2],
}

const PLAIN: Frame = Frame {
    turn: ["1", "0"],
    mirror: false,
    shift: ["0", "0"],
};

const MIRRORED: Frame = Frame {
    mirror: true,
    ..PLAIN
};

/// Mirrored, turned by the angle of the triangle 3-4-5, and moved by 10/3.
const HIDDEN: Frame = Frame {
    turn: ["3/5", "4/5"],
    mirror: true,
    shift: ["10/3", "-1/7"],
};

impl Frame {
    fn direction(&self, [x, y]: [&str; 2]) -> Vec2<Expression> {
        let (x, y) = (number(x), number(y));
        let y = if self.mirror { -y } else { y };
        let [cos, sin] = self.turn.map(number);
        Vec2::new(x.clone() * &cos - y.clone() * &sin, x * &sin + y * &cos)
    }

    fn point(&self, at: [&str; 2]) -> Vec2<Expression> {
        self.direction(at).plus(&Vec2::from(self.shift.map(number)))
    }

    fn disc(&self, position: [&str; 2], velocity: [&str; 2]) -> Disc<Expression> {
        Disc {
            position: self.point(position),
            velocity: self.direction(velocity),
            radius: number("1"),
            mass: Mass::Finite(number("1")),
            last: None,
        }
    }
}

/// The time until two discs of radius 1 meet.
fn delay(a: &Disc<Expression>, b: &Disc<Expression>) -> Expression {
    let offset = a.position.minus(&b.position);
    let velocity = a.velocity.minus(&b.velocity);
    let met = meet_circle(&offset, &velocity, &number("2")).unwrap();
    met.expect("they meet").delay
}

/// Moves a disc to what is at rest and meets it after `delay`, and resolves
/// the impact.
fn hit(a: &mut Disc<Expression>, b: &mut Disc<Expression>, delay: &Expression) {
    a.advance(delay);
    let normal = Normal::at_contact(b.position.minus(&a.position), &number("2"));
    collide_discs(a, b, &normal, &Restitution::Elastic).unwrap();
}

/// Posts that a disc at the origin with velocity (1, 0) meets one after the
/// other, each near the line that it takes after the one before. Every impact
/// adds a square root over the roots so far.
const POSTS: [[&str; 2]; 8] = [
    ["4", "1/2"],
    ["-2", "-3/2"],
    ["4", "-3/2"],
    ["-2", "-3"],
    ["2", "3/2"],
    ["-5/2", "-3"],
    ["-1", "5/2"],
    ["-1/2", "-7/2"],
];

/// The times at which a disc meets the first posts.
fn times(frame: Frame, posts: &[[&str; 2]]) -> Vec<Expression> {
    let mut disc = frame.disc(["0", "0"], ["1", "0"]);
    let mut time = number("0");
    let mut times = Vec::new();
    for &post in posts {
        let mut post = frame.disc(post, ["0", "0"]);
        post.mass = Mass::Infinite;
        let delay = delay(&disc, &post);
        hit(&mut disc, &mut post, &delay);
        time = time + delay;
        times.push(time.clone());
    }
    times
}

/// The powers of a point with respect to a circle of radius 2.
fn power(offset: &Vec2<Expression>) -> Expression {
    Expression::power(&offset.x, &offset.y, &number("2"))
}

#[test]
fn mirror_images_are_met_at_the_same_time() {
    let first = &times(PLAIN, &POSTS[..1])[0];
    assert!(first.rational().is_none());
    for frame in [MIRRORED, HIDDEN] {
        assert_eq!(times(frame, &POSTS[..1])[0].compare(first), Ok(Equal));
    }
}

#[test]
fn a_path_takes_as_long_in_every_frame() {
    let plain = times(PLAIN, &POSTS[..4]);
    for frame in [MIRRORED, HIDDEN] {
        for (one, other) in plain.iter().zip(times(frame, &POSTS[..4])) {
            assert_eq!(one.compare(&other), Ok(Equal));
        }
    }
}

/// From the rotated frame's view of the times, they grow.
#[test]
fn later_impacts_are_later() {
    let times = times(HIDDEN, &POSTS);
    for pair in times.windows(2) {
        assert_eq!(pair[0].compare(&pair[1]), Ok(Less));
    }
}

/// A disc meets two others at one irrational time: one of them as computed,
/// the other by symmetry.
#[test]
fn a_second_disc_is_touched_at_the_same_instant() {
    for frame in [PLAIN, MIRRORED, HIDDEN] {
        let mut cue = frame.disc(["-7", "0"], ["1", "0"]);
        let upper = frame.disc(["0", "3/2"], ["0", "0"]);
        let lower = frame.disc(["0", "-3/2"], ["0", "0"]);
        let time = delay(&cue, &upper);
        assert!(time.rational().is_none());
        cue.advance(&time);
        let offset = lower.position.minus(&cue.position);
        assert_eq!(power(&offset).sign(), Ok(Equal));
    }
}

/// Two discs set off by one impact meet one post each, as far from the axis:
/// the meetings are simultaneous, and the discs touch the posts exactly.
#[test]
fn what_parts_in_symmetry_arrives_together() {
    for frame in [PLAIN, HIDDEN] {
        let mut cue = frame.disc(["-7", "0"], ["1", "0"]);
        let mut upper = frame.disc(["0", "3/2"], ["0", "0"]);
        let mut lower = frame.disc(["0", "-3/2"], ["0", "0"]);
        let first = delay(&cue, &upper);
        cue.advance(&first);
        // One after the other, which is what the mirror image does not do.
        let velocity = cue.velocity.clone();
        hit(&mut cue, &mut upper, &number("0"));
        let mut again = Disc {
            velocity,
            ..cue.clone()
        };
        hit(&mut again, &mut lower, &number("0"));
        let posts = [["9", "9"], ["9", "-9"]].map(|at| frame.disc(at, ["0", "0"]));
        let delays = [delay(&upper, &posts[0]), delay(&lower, &posts[1])];
        assert_eq!(delays[0].compare(&delays[1]), Ok(Equal));
        lower.advance(&delays[0]);
        let offset = posts[1].position.minus(&lower.position);
        assert_eq!(power(&offset).sign(), Ok(Equal));
    }
}

/// Whether a disc is seen to touch each of the first posts when it meets it.
fn touches(frame: Frame, count: usize) -> Vec<Result<Ordering, Undecided>> {
    let mut disc = frame.disc(["0", "0"], ["1", "0"]);
    let mut touches = Vec::new();
    for &post in &POSTS[..count] {
        let mut post = frame.disc(post, ["0", "0"]);
        post.mass = Mass::Infinite;
        let delay = delay(&disc, &post);
        hit(&mut disc, &mut post, &delay);
        touches.push(power(&post.position.minus(&disc.position)).sign());
    }
    touches
}

/// The equation of which the time is a root is satisfied, at every impact of
/// a path.
#[test]
fn what_is_met_is_touched() {
    for frame in [PLAIN, HIDDEN] {
        for touch in touches(frame, 5) {
            assert_eq!(touch, Ok(Equal));
        }
    }
}
