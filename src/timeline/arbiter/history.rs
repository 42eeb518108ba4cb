//! What has led to where each disc is, in eight bytes an impact.
//!
//! A *leg* is a disc's motion from one of its impacts to the next. It follows
//! from the impact that it begins with, and that one from the legs it ends:
//! all legs that lead to one are its causal cone.

use crate::body::Feature;

/// A disc's motion between two of its impacts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Leg(u32);

impl Leg {
    /// The first leg of a disc.
    pub(super) fn first_of(disc: u32) -> Self {
        Self(disc)
    }

    pub(super) fn index(self) -> usize {
        self.0 as usize
    }

    /// The leg of the first body, of an impact of whose second body this is.
    pub(super) fn before(self) -> Self {
        Self(self.0 - 1)
    }

    /// The leg of the second body, of an impact of whose first body this is.
    pub(super) fn beside(self) -> Self {
        Self(self.0 + 1)
    }
}

/// What a disc collides with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum Partner {
    /// A disc on one of its legs.
    Disc(Leg),
    /// The interior of a wall.
    Wall(u32),
    /// A point where walls end.
    Corner(u32),
}

/// An impact, by what collides.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Cause {
    pub(super) leg: Leg,
    pub(super) partner: Partner,
    /// Whether the two touched already at the start of the later leg.
    pub(super) at_once: bool,
}

impl Cause {
    /// The legs that collide, one or two.
    pub(super) fn legs(self) -> impl Iterator<Item = Leg> {
        let other = match self.partner {
            Partner::Disc(leg) => Some(leg),
            Partner::Wall(_) | Partner::Corner(_) => None,
        };
        [Some(self.leg), other].into_iter().flatten()
    }

    /// The leg that began later.
    pub(super) fn later(self) -> Leg {
        self.legs().max().unwrap_or(self.leg)
    }
}

/// How a leg begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Origin {
    /// With the scene, for this disc.
    Start(usize),
    /// With an impact, of which the disc is the first body or the second one.
    Impact(Cause, Side),
    /// With impacts that were resolved at once, by their place among such.
    Cluster(usize),
}

/// Impacts that are resolved at once.
#[derive(Clone, Debug)]
pub(super) struct Cluster {
    /// The one that tells the time.
    pub(super) trigger: Cause,
    /// All bodies that touch.
    pub(super) contacts: Vec<Cause>,
    /// The leg of each disc that changes, before and after.
    pub(super) legs: Vec<(Leg, Leg)>,
}

/// The first or the second body of an impact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    First,
    Second,
}

/// All legs, and the one that each disc is on.
#[derive(Clone, Debug)]
pub(super) struct History {
    current: Vec<Leg>,
    impacts: Vec<Record>,
    clusters: Vec<Cluster>,
}

/// A [`Cause`] in eight bytes: a leg with [`AT_ONCE`], and a partner with its
/// [`KIND`].
#[derive(Clone, Copy, Debug)]
struct Record(u32, u32);

const AT_ONCE: u32 = 1 << 31;
const KIND: u32 = 3 << 30;
const WALL: u32 = 1 << 30;
const CORNER: u32 = 2 << 30;
const CLUSTER: u32 = 3 << 30;

impl Record {
    /// What stands for two of the discs of a cluster.
    fn cluster(place: usize) -> Self {
        Self(0, place as u32 | CLUSTER)
    }

    /// The place of a cluster, if this stands for one.
    fn as_cluster(self) -> Option<usize> {
        (self.1 & KIND == CLUSTER).then_some((self.1 & !KIND) as usize)
    }

    fn new(cause: Cause) -> Self {
        let Cause {
            leg,
            partner,
            at_once,
        } = cause;
        let partner = match partner {
            Partner::Disc(leg) => leg.0,
            Partner::Wall(wall) => wall | WALL,
            Partner::Corner(corner) => corner | CORNER,
        };
        Self(leg.0 | if at_once { AT_ONCE } else { 0 }, partner)
    }

    fn cause(self) -> Cause {
        let index = self.1 & !KIND;
        Cause {
            leg: Leg(self.0 & !AT_ONCE),
            partner: match self.1 & KIND {
                WALL => Partner::Wall(index),
                CORNER => Partner::Corner(index),
                _ => Partner::Disc(Leg(index)),
            },
            at_once: self.0 & AT_ONCE != 0,
        }
    }
}

impl History {
    /// Every disc on its first leg.
    pub(super) fn new(discs: usize) -> Self {
        let first = (0..discs as u32).map(Leg);
        Self {
            current: first.collect(),
            impacts: Vec::new(),
            clusters: Vec::new(),
        }
    }

    /// The impact of a disc with a feature, as things stand.
    pub(super) fn cause(&self, disc: usize, feature: Feature, at_once: bool) -> Cause {
        Cause {
            leg: self.current[disc],
            partner: match feature {
                Feature::Disc(other) => Partner::Disc(self.current[other as usize]),
                Feature::Wall(wall) => Partner::Wall(wall),
                Feature::Corner(corner) => Partner::Corner(corner),
            },
            at_once,
        }
    }

    /// The leg that a disc is on.
    pub(super) fn leg(&self, disc: usize) -> Leg {
        self.current[disc]
    }

    /// How many legs there have been.
    pub(super) fn legs(&self) -> usize {
        self.current.len() + 2 * self.impacts.len()
    }

    /// Notes an impact, after which `changed` discs are on new legs. Gives
    /// that of its first body; the next one is that of the second body.
    pub(super) fn note(&mut self, cause: Cause, changed: [Option<usize>; 2]) -> Leg {
        let first = Leg(self.legs() as u32);
        self.impacts.push(Record::new(cause));
        for (disc, leg) in changed.into_iter().zip([first, first.beside()]) {
            if let Some(disc) = disc {
                self.current[disc] = leg;
            }
        }
        first
    }

    /// Notes impacts that are resolved at once, after which `changed` discs are
    /// on new legs.
    pub(super) fn note_cluster(
        &mut self,
        trigger: Cause,
        contacts: Vec<Cause>,
        changed: &[usize],
    ) -> &Cluster {
        let mut legs = Vec::new();
        for (disc, leg) in changed.iter().zip(self.legs() as u32..) {
            legs.push((self.current[*disc], Leg(leg)));
            self.current[*disc] = Leg(leg);
        }
        let record = Record::cluster(self.clusters.len());
        let records = changed.len().div_ceil(2);
        self.impacts.extend(std::iter::repeat_n(record, records));
        let place = self.clusters.len();
        self.clusters.push(Cluster {
            trigger,
            contacts,
            legs,
        });
        &self.clusters[place]
    }

    /// Impacts that were resolved at once.
    pub(super) fn cluster(&self, place: usize) -> &Cluster {
        &self.clusters[place]
    }

    /// How a leg begins.
    pub(super) fn origin(&self, leg: Leg) -> Origin {
        let discs = self.current.len();
        match leg.index().checked_sub(discs) {
            None => Origin::Start(leg.index()),
            Some(place) => {
                let record = self.impacts[place / 2];
                let side = [Side::First, Side::Second][place % 2];
                record
                    .as_cluster()
                    .map_or_else(|| Origin::Impact(record.cause(), side), Origin::Cluster)
            }
        }
    }
}
