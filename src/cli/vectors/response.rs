//! Velocities after an impact, exactly.

use carom::body::{Disc, Mass};
use carom::respond::{Normal, Restitution, collide_discs, collide_wall};
use carom::scalar::{Exact, Number, Scalar};
use carom::scene::generate::Random;
use carom::vec2::Vec2;
use num_rational::BigRational;
use schemars::JsonSchema;
use serde::Serialize;

use super::text::Text;

/// More bits than any of these numbers has: they stay rational.
const BITS: u32 = 1024;

/// Bodies that touch and approach, and their velocities after the impact.
#[derive(Serialize, JsonSchema)]
pub(super) struct Response {
    id: String,
    a: Moving,
    /// The other disc; absent where it is a wall.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Moving")]
    b: Option<Moving>,
    /// From the first centre towards the other body, of any length.
    normal: [Text; 2],
    /// Newton's coefficient.
    restitution: Text,
}

/// A disc's mass, and its velocity before and after.
#[derive(Serialize, JsonSchema)]
struct Moving {
    mass: Text,
    before: [Text; 2],
    after: [Text; 2],
}

/// What is drawn.
struct Impact {
    discs: Vec<(Option<Number>, [Number; 2])>,
    normal: [Number; 2],
    restitution: Number,
}

const NORMALS: [[i64; 2]; 7] = [[1, 0], [0, -2], [3, 4], [-5, 12], [1, 1], [-2, 3], [7, -1]];

/// Impacts of two discs, and then of discs on walls.
pub(super) fn responses() -> impl Iterator<Item = Response> {
    let between = (0..48).map(|index| response("discs", 2, index));
    between.chain((0..16).map(|index| response("wall", 1, index)))
}

fn response(name: &str, discs: usize, index: u8) -> Response {
    let mut key = [0; 32];
    key[0] = index;
    key[1..]
        .iter_mut()
        .zip(name.bytes())
        .for_each(|(to, from)| *to = from);
    let impact = Impact::drawn(&mut Random::keyed(key), discs);
    impact.resolved(format!("response-{name}-{index}"))
}

impl Impact {
    /// Bodies that approach: others are drawn anew.
    fn drawn(random: &mut Random, discs: usize) -> Self {
        loop {
            let impact = Self {
                normal: random.one_of(&NORMALS).map(Number::from),
                restitution: text(random.one_of(&["1", "1", "1/2", "9/10", "0"])),
                discs: (0..discs).map(|place| moving(random, place)).collect(),
            };
            if impact.approaches() {
                return impact;
            }
        }
    }

    fn approaches(&self) -> bool {
        let along = |velocity: &[Number; 2]| -> BigRational {
            let parts = velocity.iter().zip(&self.normal);
            parts.map(|(v, n)| v.to_rational() * n.to_rational()).sum()
        };
        let speeds: Vec<_> = self
            .discs
            .iter()
            .map(|(_, velocity)| along(velocity))
            .collect();
        speeds[0] > speeds.get(1).cloned().unwrap_or_default()
    }

    fn resolved(&self, id: String) -> Response {
        let exact = |number: &Number| Exact::from_number(number, BITS);
        let [x, y] = self.normal.each_ref().map(exact);
        let normal = Normal::at_overlap(Vec2::new(x, y));
        let e = exact(&self.restitution);
        let restitution = Restitution::Newton {
            discs: e.clone(),
            walls: e,
            elastic_below: None,
        };
        let mut discs: Vec<_> = self
            .discs
            .iter()
            .map(|(mass, velocity)| disc(mass, velocity))
            .collect();
        let resolved = match &mut discs[..] {
            [one, other] => collide_discs(one, other, &normal, &restitution),
            [one, ..] => collide_wall(one, &normal, &restitution),
            [] => Ok(()),
        };
        resolved.expect("only elastic_below asks for a decision");
        let told = self.discs.iter().zip(&discs);
        let mut told = told.map(|((mass, before), disc)| Moving {
            mass: mass
                .as_ref()
                .map_or_else(|| Text::new("infinite"), Text::from),
            before: before.each_ref().map(Text::from),
            after: [&disc.velocity.x, &disc.velocity.y].map(rational),
        });
        let (a, b) = (told.next(), told.next());
        Response {
            id,
            a: a.expect("one disc or two"),
            b,
            normal: self.normal.each_ref().map(Text::from),
            restitution: Text::from(&self.restitution),
        }
    }
}

/// A mass, of two at most one of them infinite, and a velocity.
fn moving(random: &mut Random, place: usize) -> (Option<Number>, [Number; 2]) {
    let mass = random.one_of(&["1", "1", "3", "1/7", "1e12", "infinite"]);
    let mass = match (mass, place) {
        ("infinite", 0) => Some(text("2")),
        ("infinite", _) => None,
        (mass, _) => Some(text(mass)),
    };
    let mut part = || text(&format!("{}/3", random.whole(-9, 9)));
    let velocity = [part(), part()];
    (mass, velocity)
}

fn text(text: &str) -> Number {
    text.parse().expect("a number")
}

fn disc(mass: &Option<Number>, velocity: &[Number; 2]) -> Disc<Exact> {
    let [x, y] = velocity
        .each_ref()
        .map(|part| Exact::from_number(part, BITS));
    let zero = || Exact::from_integer(0);
    Disc {
        position: Vec2::new(zero(), zero()),
        velocity: Vec2::new(x, y),
        radius: Exact::from_integer(1),
        mass: match mass {
            Some(mass) => Mass::Finite(Exact::from_number(mass, BITS)),
            None => Mass::Infinite,
        },
        last: None,
    }
}

/// A number that is held as a rational.
fn rational(number: &Exact) -> Text {
    let (value, _) = number.enclosure().expect("it is rational");
    Text::new(value.to_string())
}
