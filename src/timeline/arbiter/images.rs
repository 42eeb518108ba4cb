//! Times that are equal because the scene is symmetric.
//!
//! If an isometry maps the scene onto itself, it maps what happens onto what
//! happens. So a leg whose causal cone is mapped onto that of another leg is
//! mapped onto that leg, however deep the cones are, and impacts that are mapped
//! onto each other are simultaneous. This holds for as long as the cones do:
//! where one of two simultaneous impacts was resolved before the other, and
//! changed it, they differ from there on.

use std::collections::HashMap;

use super::history::{Cause, Cluster, Leg, Partner};
use crate::symmetry::Symmetry;

/// What each leg is mapped onto.
#[derive(Clone, Debug)]
pub(super) struct Images {
    symmetries: Vec<Symmetry>,
    /// The place of the inverse of each symmetry, where that is one too.
    inverses: Vec<Option<usize>>,
    /// The images of all legs under each symmetry.
    legs: Vec<Vec<Option<Leg>>>,
    /// The legs that an impact in order begins: those of its two bodies.
    impacts: HashMap<Cause, [Leg; 2]>,
    /// For impacts that were resolved at once, by all their contacts in order,
    /// the legs before and after.
    clusters: HashMap<Vec<Cause>, Vec<(Leg, Leg)>>,
}

impl Images {
    /// Those of a scene's start.
    pub(super) fn new(symmetries: Vec<Symmetry>) -> Self {
        let first_legs = |symmetry: &Symmetry| {
            let images = symmetry.discs.iter();
            images.map(|&disc| Some(Leg::first_of(disc))).collect()
        };
        Self {
            legs: symmetries.iter().map(first_legs).collect(),
            inverses: inverses(&symmetries),
            symmetries,
            impacts: HashMap::new(),
            clusters: HashMap::new(),
        }
    }

    /// Notes an impact, of whose first body `leg` is the new leg.
    pub(super) fn note(&mut self, cause: Cause, leg: Leg) {
        if self.symmetries.is_empty() {
            return;
        }
        let legs = [leg, leg.beside()];
        let own = Ordered::from(cause);
        let own_legs = own.arranged(legs);
        self.impacts.insert(own.cause, own_legs);
        self.make_room(legs[1]);
        for place in 0..self.symmetries.len() {
            let Some(image) = self.image(place, own.cause).map(Ordered::from) else {
                continue;
            };
            if let Some(onto) = self.impacts.get(&image.cause) {
                self.map(place, own_legs, image.arranged(*onto));
            }
        }
    }

    /// Notes impacts that are resolved at once.
    pub(super) fn note_cluster(&mut self, cluster: &Cluster) {
        if self.symmetries.is_empty() {
            return;
        }
        let Some(&(_, last)) = cluster.legs.last() else {
            return;
        };
        self.make_room(last.beside());
        let contacts = ordered(cluster.contacts.iter().copied());
        self.clusters.insert(contacts.clone(), cluster.legs.clone());
        for place in 0..self.symmetries.len() {
            let images = contacts.iter().map(|&contact| self.image(place, contact));
            let images: Option<Vec<_>> = images.collect();
            let onto = images.and_then(|images| self.clusters.get(&ordered(images)));
            if let Some(onto) = onto.cloned() {
                self.map_cluster(place, &cluster.legs, &onto);
            }
        }
    }

    /// Maps the legs after impacts that were resolved at once onto those after
    /// others, each to that of the disc that its own is mapped onto.
    fn map_cluster(&mut self, place: usize, legs: &[(Leg, Leg)], onto: &[(Leg, Leg)]) {
        for &(before, after) in legs {
            let image = self.legs[place][before.index()];
            let image = image.and_then(|image| onto.iter().find(|(before, _)| *before == image));
            if let Some(&(_, image)) = image {
                self.map(place, [after], [image]);
            }
        }
    }

    /// Makes room for the images of all legs up to one.
    fn make_room(&mut self, last: Leg) {
        for images in &mut self.legs {
            images.resize(last.index() + 1, None);
        }
    }

    /// Maps legs onto others, and back.
    fn map<const N: usize>(&mut self, place: usize, legs: [Leg; N], images: [Leg; N]) {
        for (leg, image) in legs.into_iter().zip(images) {
            self.legs[place][leg.index()] = Some(image);
            if let Some(inverse) = self.inverses[place] {
                self.legs[inverse][image.index()] = Some(leg);
            }
        }
    }

    /// Whether a symmetry maps one impact onto the other, or they are the same.
    pub(super) fn are_simultaneous(&self, one: Cause, other: Cause) -> bool {
        let [one, other] = [one, other].map(|cause| Ordered::from(cause).cause);
        let maps = |place| {
            let image = self.image(place, one).map(Ordered::from);
            image.is_some_and(|image| image.cause == other)
        };
        one == other || (0..self.symmetries.len()).any(maps)
    }

    /// The impact that another is mapped onto. That of a corner is not known:
    /// a symmetry tells walls, and not which end is which.
    fn image(&self, place: usize, cause: Cause) -> Option<Cause> {
        let leg_of = |leg: Leg| self.legs[place][leg.index()];
        Some(Cause {
            leg: leg_of(cause.leg)?,
            partner: match cause.partner {
                Partner::Disc(leg) => Partner::Disc(leg_of(leg)?),
                Partner::Wall(wall) => Partner::Wall(self.symmetries[place].walls[wall as usize]),
                Partner::Corner(_) => return None,
            },
            at_once: cause.at_once,
        })
    }
}

/// Impacts that are resolved at once, whatever order they are told in.
fn ordered(contacts: impl IntoIterator<Item = Cause>) -> Vec<Cause> {
    let contacts = contacts.into_iter();
    let mut contacts: Vec<_> = contacts.map(|cause| Ordered::from(cause).cause).collect();
    contacts.sort_unstable();
    contacts
}

/// An impact with the lower leg first.
struct Ordered {
    cause: Cause,
    is_swapped: bool,
}

impl Ordered {
    /// What belongs to the two bodies, in the other of the two orders.
    fn arranged<T>(&self, [first, second]: [T; 2]) -> [T; 2] {
        if self.is_swapped {
            [second, first]
        } else {
            [first, second]
        }
    }
}

impl From<Cause> for Ordered {
    fn from(cause: Cause) -> Self {
        match cause.partner {
            Partner::Disc(leg) if leg < cause.leg => Self {
                cause: Cause {
                    leg,
                    partner: Partner::Disc(cause.leg),
                    ..cause
                },
                is_swapped: true,
            },
            _ => Self {
                cause,
                is_swapped: false,
            },
        }
    }
}

/// The place of the inverse of each symmetry. Together with the identity they
/// are a group, but where identical discs coincide, any of which may stand for
/// the other.
fn inverses(symmetries: &[Symmetry]) -> Vec<Option<usize>> {
    let returns = |there: &[u32], back: &[u32]| {
        let mut images = (0..).zip(there);
        images.all(|(place, &image)| back[image as usize] == place)
    };
    let undoes = |one: &Symmetry, other: &Symmetry| {
        returns(&one.discs, &other.discs) && returns(&one.walls, &other.walls)
    };
    let inverse = |one| symmetries.iter().position(|other| undoes(one, other));
    symmetries.iter().map(inverse).collect()
}
