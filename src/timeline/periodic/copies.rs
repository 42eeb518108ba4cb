//! Discs of a periodic plane, each of which is there over and over.

use crate::body::{BodyId, Disc, Feature, Pair};
use crate::impact::{Contact, Impact, Place};
use crate::kernel::{Approach, Flight, Kernel, Met, Time};
use crate::timeline::flight::Flights;
use crate::timeline::meeting::check_order;
use crate::timeline::neighbours::Image;
use crate::vec2::Vec2;

/// Two discs, of which the second one is a copy: as the log names them, the lower
/// number first, whichever of the two is looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Couple {
    first: u32,
    second: u32,
    /// Which copy of the second one.
    cell: [i64; 2],
}

impl Couple {
    pub(super) fn new(disc: usize, image: Image) -> Self {
        let back = image.seen_back(disc);
        if (disc as u32) < image.disc {
            Self::of(disc as u32, image)
        } else {
            Self::of(image.disc, back)
        }
    }

    fn of(first: u32, image: Image) -> Self {
        Self {
            first,
            second: image.disc,
            cell: image.cell,
        }
    }

    pub(super) fn discs(self) -> [usize; 2] {
        [self.first, self.second].map(|disc| disc as usize)
    }

    /// The copy of the one that each of the two meets.
    pub(super) fn images(self) -> [Image; 2] {
        let second = Image {
            disc: self.second,
            cell: self.cell,
        };
        [second, second.seen_back(self.first as usize)]
    }

    pub(super) fn pair(self) -> Pair {
        let [first, second] = [self.first, self.second].map(BodyId::Disc);
        Pair::new(first, second)
    }

    pub(super) fn shares_disc(self, other: Self) -> bool {
        self.pair().shares_disc(&other.pair())
    }
}

/// So many sides of the cell that repeats.
fn shift<S: Kernel>(period: &Vec2<S>, cell: [i64; 2]) -> Vec2<S> {
    let [x, y] = cell.map(|cells| whole::<S>(cells));
    Vec2::new(period.x.clone() * &x, period.y.clone() * &y)
}

/// A whole number, in two pieces if it takes them.
fn whole<S: Kernel>(number: i64) -> S {
    match i32::try_from(number) {
        Ok(number) => S::from_integer(number),
        Err(_) => {
            let [high, low] = [number >> 24, number & 0xff_ffff];
            whole::<S>(high) * &S::from_integer(1 << 24) + &whole::<S>(low)
        }
    }
}

/// Where a disc is of which a copy is so many sides further on.
fn shifted<S: Kernel>(place: Vec2<S>, period: &Vec2<S>, cell: [i64; 2]) -> Vec2<S> {
    if cell == [0, 0] {
        place
    } else {
        place.plus(&shift(period, cell))
    }
}

/// When two discs meet, if they do.
///
/// # Errors
///
/// An enclosure does not decide it.
pub(super) fn meet<S: Kernel>(
    flights: &Flights<S>,
    period: &Vec2<S>,
    couple: Couple,
) -> Result<Option<Met<S::Time>>, S::Doubt> {
    let [first, second] = couple.discs();
    let (one, other) = (flights.flight(first), flights.flight(second));
    let copy = Disc {
        position: shifted(other.disc.position.clone(), period, couple.cell),
        ..other.disc.clone()
    };
    let other = Flight {
        disc: &copy,
        ..other
    };
    let (early, late) = if flights.starts[first].turn < flights.starts[second].turn {
        (one, other)
    } else {
        (other, one)
    };
    let approach = Approach {
        early,
        late,
        together: flights.moment_of(first) == flights.moment_of(second),
    };
    check_order(&approach)?;
    S::meet_discs(&approach)
}

/// Lets two discs collide that have been brought to a time.
///
/// # Errors
///
/// An enclosure does not decide what comes of it.
pub(super) fn collide<S: Kernel>(
    flights: &mut Flights<S>,
    period: &Vec2<S>,
    couple: Couple,
    time: &S,
    overlap: bool,
) -> Result<Contact<S>, S::Doubt> {
    let [first, second] = couple.discs();
    let [centre, other] = [first, second].map(|disc| flights.position_brought(disc, time));
    let place = Place {
        centre,
        other: shifted(other, period, couple.cell),
        overlap,
    };
    let feature = Feature::Disc(couple.second);
    flights.world.collide(first, feature, place)
}

/// The impact of two discs.
pub(super) fn impact<S: Kernel>(
    couple: Couple,
    time: &S::Time,
    moment: u64,
    contact: Contact<S>,
) -> Impact<S> {
    Impact {
        moment: Some(moment),
        image: Some(Box::new(couple.cell)),
        ..Impact::new(time.value(), (couple.pair(), None), contact)
    }
}

/// Whether two discs overlap where they are.
///
/// # Errors
///
/// An enclosure does not decide it.
pub(super) fn overlap<S: Kernel>(
    flights: &Flights<S>,
    period: &Vec2<S>,
    couple: Couple,
) -> Result<bool, S::Doubt> {
    let [first, second] = couple.discs().map(|disc| &flights.world.discs[disc]);
    let copy = Disc {
        position: shifted(second.position.clone(), period, couple.cell),
        ..second.clone()
    };
    Ok(S::overlap_discs(first, &copy)?.is_some())
}
