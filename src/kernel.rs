//! How an arithmetic takes the decisions that collisions consist of.
//!
//! Most compute: the formulas of [`detect`](crate::detect) and
//! [`respond`], one operation after the other. That is what the
//! methods of [`Kernel`] do unless an arithmetic has its own. One that stores
//! rounded numbers and yet decides exactly has: it takes each decision as a
//! whole, from the numbers that it stores.
//!
//! The time of a meeting need not be such a number: it is a [`Time`]. (The
//! pattern is that of the kernels of CGAL, the Computational Geometry Algorithms
//! Library.)

use std::cmp::Ordering::{self, Equal, Greater, Less};
use std::fmt::Debug;

use crate::algebra::Expression;
use crate::body::{Disc, Wall};
use crate::detect::{
    Encounter, End, Overlap, Segment, meet_circle, meet_segment, overlap_circle, overlap_segment,
};
use crate::respond::{self, Normal, Restitution};
use crate::scalar::{Exact, Interval, Scalar};
use crate::vec2::Vec2;

/// A time at which bodies meet.
pub trait Time<S: Scalar>: Clone + Debug + Send + Sync + 'static {
    /// A time that is known as a number.
    fn at(time: S) -> Self;

    /// The time that is a delay later than another.
    fn after(since: &S, delay: S) -> Self;

    /// The order of two times.
    fn order(&self, other: &Self) -> Result<Ordering, S::Doubt>;

    /// Which comes first, this or a time that is known as a number.
    fn order_to(&self, time: &S) -> Result<Ordering, S::Doubt>;

    /// The order of this, as a delay, against what is left from `begun` to
    /// `end`.
    fn order_to_rest(&self, end: &S, begun: &S) -> Result<Ordering, S::Doubt>;

    /// Binary64 bounds.
    fn bounds(&self) -> Interval;

    /// The time as a number, rounded at most once.
    fn value(&self) -> S;

    /// The time that is this, as a delay, later than another; as a number,
    /// rounded at most once.
    fn value_after(&self, since: &S) -> S;

    /// The time, when it has come: with what several uses of it share, and lifted
    /// to `floor` where rounding alone put it before.
    #[must_use]
    fn settled(self, floor: &S) -> Self;
}

/// A number may be its own kind of time.
impl<S: Scalar> Time<S> for S {
    #[inline]
    fn at(time: S) -> Self {
        time
    }

    #[inline]
    fn after(since: &S, delay: S) -> Self {
        since.clone() + delay
    }

    #[inline]
    fn order(&self, other: &Self) -> Result<Ordering, S::Doubt> {
        self.compare(other)
    }

    #[inline]
    fn order_to(&self, time: &S) -> Result<Ordering, S::Doubt> {
        self.compare(time)
    }

    #[inline]
    fn order_to_rest(&self, end: &S, begun: &S) -> Result<Ordering, S::Doubt> {
        self.compare(&(end.clone() - begun))
    }

    #[inline]
    fn bounds(&self) -> Interval {
        self.hull()
    }

    #[inline]
    fn value(&self) -> S {
        self.clone()
    }

    #[inline]
    fn value_after(&self, since: &S) -> S {
        since.clone() + self
    }

    #[inline]
    fn settled(self, floor: &S) -> Self {
        self.not_before(floor)
    }
}

/// A disc, and the time at which it is where it says.
#[derive(Debug)]
pub struct Flight<'a, S: Kernel> {
    /// The disc.
    pub disc: &'a Disc<S>,
    /// The time.
    pub since: &'a S,
    /// What pulls it.
    pub pull: &'a S::Pull,
}

impl<S: Kernel> Clone for Flight<'_, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: Kernel> Copy for Flight<'_, S> {}

/// What acts on a disc in flight, and what holds it: by default nothing, as where
/// motion is straight.
pub trait Pull<S: Scalar>: Clone + Debug + Default + Send + Sync + 'static {
    /// That of a disc, among those of all.
    #[inline]
    fn of(pulls: &[Self], disc: usize) -> &Self {
        &pulls[disc]
    }

    /// Bounds of the acceleration, if there is any.
    #[inline]
    fn acceleration(&self) -> Option<Vec2<Interval>> {
        None
    }

    /// The walls that hold the disc, which rests on them or slides along one.
    #[inline]
    fn holders(&self) -> [Option<usize>; 2] {
        [None; 2]
    }

    /// Whether anything holds the disc.
    fn is_held(&self) -> bool {
        self.holders() != [None; 2]
    }

    /// Whether a wall holds the disc.
    fn is_held_by(&self, wall: usize) -> bool {
        self.holders().contains(&Some(wall))
    }

    /// Whether the disc moves, by construction, at a right angle to the normal of
    /// what it touched last.
    fn skims(&self) -> bool {
        false
    }

    /// Notes that it does.
    fn skim(&mut self) {}

    /// Notes that the disc touches a wall and does not move towards it: the wall
    /// holds it if it is pulled there.
    fn rest_on(
        &mut self,
        disc: &mut Disc<S>,
        wall: usize,
        walls: &[Wall<S>],
    ) -> Result<(), S::Doubt> {
        let _ = (disc, wall, walls);
        Ok(())
    }

    /// Notes that nothing holds the disc any more.
    fn let_go(&mut self) {}

    /// Notes that the disc has slid off at the end of a wall. Tells whether it
    /// flies off, rather than fall around the end.
    fn slide_off(&mut self, disc: &Disc<S>, corner: &Vec2<S>) -> Result<bool, S::Doubt> {
        let _ = (disc, corner);
        Ok(true)
    }
}

impl<S: Scalar> Pull<S> for () {
    /// Nothing, without a look: that would be a part of what a pair costs.
    #[inline]
    fn of(_: &[()], _: usize) -> &() {
        &()
    }
}

/// Two discs in flight.
#[derive(Debug)]
pub struct Approach<'a, S: Kernel> {
    /// The disc that is known since the earlier time.
    pub early: Flight<'a, S>,
    /// The disc that is known since the later one.
    pub late: Flight<'a, S>,
    /// Whether the two times are known to be one.
    pub together: bool,
}

impl<S: Kernel> Approach<'_, S> {
    /// Where the later disc is, seen from the earlier one, at the later time.
    #[inline]
    pub fn offset(&self) -> Vec2<S> {
        let (early, late) = (self.early.disc, self.late.disc);
        if self.together {
            return late.position.minus(&early.position);
        }
        let start = S::position_after(self.early, &self.wait());
        late.position.minus(&start)
    }

    /// How fast the later disc moves, seen from the earlier one, at the later
    /// time.
    #[inline]
    pub fn velocity(&self) -> Vec2<S> {
        let (early, late) = (self.early.disc, self.late.disc);
        if self.together || S::IS_STRAIGHT {
            return late.velocity.minus(&early.velocity);
        }
        let start = S::velocity_after(self.early, &self.wait());
        late.velocity.minus(&start)
    }

    fn wait(&self) -> S {
        self.late.since.clone() - self.early.since
    }

    /// The sum of the radii.
    #[inline]
    pub fn reach(&self) -> S {
        self.early.disc.radius.clone() + &self.late.disc.radius
    }
}

/// What a disc meets, and when.
#[derive(Clone, Debug)]
pub struct Met<T> {
    /// The time.
    pub time: T,
    /// Whether the two only pass in tangency, so that nothing changes.
    pub graze: bool,
    /// Whether they touch or overlap already.
    pub overlap: bool,
    /// Whether they overlap already, and do not only touch.
    pub inside: bool,
    /// Whether they touch and neither approach nor part, but are pressed together.
    pub rest: bool,
    /// The wall's end point that is touched, unless its interior is.
    pub end: Option<End>,
}

impl<T> Met<T> {
    /// A meeting of bodies that touch and approach, at a time.
    pub(crate) fn at_once<S: Scalar>(time: &S) -> Self
    where
        T: Time<S>,
    {
        Self {
            time: T::at(time.clone()),
            graze: false,
            overlap: true,
            inside: false,
            rest: false,
            end: None,
        }
    }

    /// What an encounter amounts to, seen from a time.
    #[inline]
    pub(crate) fn after<S: Scalar>(since: &S, encounter: Encounter<S>) -> Self
    where
        T: Time<S>,
    {
        Self {
            time: T::after(since, encounter.delay),
            graze: encounter.graze,
            overlap: encounter.overlap,
            inside: encounter.inside,
            rest: encounter.rest,
            end: encounter.end,
        }
    }
}

/// What can be told of a meeting before it is computed.
#[derive(Clone, Copy, Debug)]
pub enum Glance {
    /// The bodies do not meet.
    Clear,
    /// They do, apart now, within these bounds of the time; a wall at its end
    /// point, unless in its interior.
    Ahead(Interval, Option<End>),
    /// Nothing.
    Open,
}

impl Glance {
    /// What a meeting comes to.
    #[inline]
    fn at<S: Scalar, T: Time<S>>(met: Option<Met<T>>) -> Self {
        match met {
            None => Self::Clear,
            Some(met) if met.graze || met.overlap => Self::Open,
            Some(met) => Self::Ahead(met.time.bounds(), met.end),
        }
    }
}

/// A number type, and how bodies whose numbers it holds collide.
///
/// The errors of all methods are open decisions.
pub trait Kernel: Scalar {
    /// A time at which bodies meet.
    type Time: Time<Self>;

    /// What acts on a disc in flight; nothing where motion is straight.
    type Pull: Pull<Self>;

    /// Whether it is remembered that bodies touch which were brought to their
    /// contact, since the numbers do not show it.
    const REMEMBERS_CONTACTS: bool = true;

    /// Whether free motion is straight: bodies that have parted then do not meet
    /// again before one of them collides.
    const IS_STRAIGHT: bool = true;

    /// Where a disc is after it has been in flight for so long.
    #[inline]
    fn position_after(flight: Flight<'_, Self>, time: &Self) -> Vec2<Self> {
        flight.disc.position.moved(&flight.disc.velocity, time)
    }

    /// How fast a disc moves after it has been in flight for so long.
    #[inline]
    fn velocity_after(flight: Flight<'_, Self>, time: &Self) -> Vec2<Self> {
        let _ = time;
        flight.disc.velocity.clone()
    }

    /// When two discs meet again that touch where the later one is, and part, or
    /// of which one only `skims` the other.
    #[inline]
    fn meet_disc_again(
        approach: &Approach<'_, Self>,
        skims: bool,
    ) -> Result<Option<Met<Self::Time>>, Self::Doubt> {
        let _ = (approach, skims);
        Ok(None)
    }

    /// When a disc gets to the end of a wall that holds it.
    #[inline]
    fn leave_wall(
        flight: Flight<'_, Self>,
        wall: &Segment<Self>,
    ) -> Result<Option<Met<Self::Time>>, Self::Doubt> {
        let _ = (flight, wall);
        Ok(None)
    }

    /// How long a disc that has just hit a wall bounces on it, if nothing else
    /// happens, and each impact leaves so much of its speed.
    #[inline]
    fn bouncing(flight: Flight<'_, Self>, wall: &Segment<Self>, kept: &Self) -> Option<Self> {
        let _ = (flight, wall, kept);
        None
    }

    /// When a disc meets a wall again that it touches, in its interior or at an
    /// end point, and parts from, or only `skims`.
    #[inline]
    fn meet_wall_again(
        flight: Flight<'_, Self>,
        wall: &Segment<Self>,
        touched: Option<End>,
        skims: bool,
    ) -> Result<Option<Met<Self::Time>>, Self::Doubt> {
        let _ = (flight, wall, touched, skims);
        Ok(None)
    }

    /// Whether numbers are binary64 and discs move uniformly between impacts: as
    /// the stored numbers say, or as operations on them come to.
    const GLIDES: bool = false;

    /// When two discs meet, at least one of which can be deflected.
    #[inline]
    fn meet_discs(approach: &Approach<'_, Self>) -> Result<Option<Met<Self::Time>>, Self::Doubt> {
        let met = meet_circle(&approach.offset(), &approach.velocity(), &approach.reach())?;
        Ok(met.map(|encounter| Met::after(approach.late.since, encounter)))
    }

    /// When a disc meets a wall. The end points for which `barred` holds are
    /// known not to be met.
    #[inline]
    fn meet_wall(
        flight: Flight<'_, Self>,
        wall: &Segment<Self>,
        barred: impl Fn(End) -> bool,
    ) -> Result<Option<Met<Self::Time>>, Self::Doubt> {
        let Disc {
            position,
            velocity,
            radius,
            ..
        } = flight.disc;
        let met = meet_segment(position, velocity, radius, wall, barred)?;
        Ok(met.map(|encounter| Met::after(flight.since, encounter)))
    }

    /// The time of a meeting that is ahead within these bounds, where they tell
    /// it.
    #[inline]
    fn time_within(bounds: Interval) -> Option<Self::Time> {
        let _ = bounds;
        None
    }

    /// What can quickly be told of the meeting of two discs.
    #[inline]
    fn glance_at_discs(approach: &Approach<'_, Self>) -> Glance {
        let _ = approach;
        Glance::Open
    }

    /// What can quickly be told of the meeting of a disc and a wall.
    #[inline]
    fn glance_at_wall(
        flight: Flight<'_, Self>,
        wall: &Segment<Self>,
        barred: impl Fn(End) -> bool,
    ) -> Glance {
        let _ = (flight, wall, barred);
        Glance::Open
    }

    /// Where a disc is at a time, if nothing changes its motion.
    #[inline]
    fn position_at(flight: Flight<'_, Self>, time: &Self::Time) -> Vec2<Self> {
        Self::position_after(flight, &(time.value() - flight.since))
    }

    /// How fast a disc moves at a time, if nothing changes its motion.
    #[inline]
    fn velocity_at(flight: Flight<'_, Self>, time: &Self::Time) -> Vec2<Self> {
        if Self::IS_STRAIGHT {
            return flight.disc.velocity.clone();
        }
        Self::velocity_after(flight, &(time.value() - flight.since))
    }

    /// The overlap of two discs, if there is one.
    fn overlap_discs(
        first: &Disc<Self>,
        second: &Disc<Self>,
    ) -> Result<Option<Overlap<Self>>, Self::Doubt> {
        let offset = second.position.minus(&first.position);
        let reach = first.radius.clone() + &second.radius;
        overlap_circle(&offset, &reach)
    }

    /// The overlap of a disc and a wall, if there is one.
    fn overlap_wall(
        disc: &Disc<Self>,
        wall: &Segment<Self>,
    ) -> Result<Option<Overlap<Self>>, Self::Doubt> {
        overlap_segment(&disc.position, &disc.radius, wall)
    }

    /// Whether a disc moves towards a point that moves.
    fn approaches_point(
        disc: &Disc<Self>,
        point: &Vec2<Self>,
        velocity: &Vec2<Self>,
    ) -> Result<bool, Self::Doubt> {
        let closing = disc.velocity.minus(velocity);
        let offset = point.minus(&disc.position);
        Ok(closing.dot(&offset).sign()? == Greater)
    }

    /// Whether a disc moves towards a wall's line.
    fn approaches_wall(disc: &Disc<Self>, wall: &Segment<Self>) -> Result<bool, Self::Doubt> {
        let side = disc.position.minus(&wall.from).cross(&wall.along);
        let drift = disc.velocity.cross(&wall.along);
        Ok(match side.sign()? {
            Equal => false,
            Less => drift.sign()? == Greater,
            Greater => drift.sign()? == Less,
        })
    }

    /// Resolves the impact of two discs whose centres are at these places, on a
    /// normal that goes from the first to the second one.
    fn collide_discs(
        [first, second]: [&mut Disc<Self>; 2],
        centres: [&Vec2<Self>; 2],
        normal: &Normal<Self>,
        restitution: &Restitution<Self>,
    ) -> Result<(), Self::Doubt> {
        let _ = centres;
        respond::collide_discs(first, second, normal, restitution)
    }

    /// Resolves the impact of a disc, whose centre is at the first of two
    /// places, on a point at the second one.
    fn collide_point(
        disc: &mut Disc<Self>,
        places: [&Vec2<Self>; 2],
        normal: &Normal<Self>,
        restitution: &Restitution<Self>,
    ) -> Result<(), Self::Doubt> {
        let _ = places;
        respond::collide_wall(disc, normal, restitution)
    }

    /// Resolves the impact of a disc on the interior of a wall.
    fn collide_wall(
        disc: &mut Disc<Self>,
        wall: &Segment<Self>,
        normal: &Normal<Self>,
        restitution: &Restitution<Self>,
    ) -> Result<(), Self::Doubt> {
        let _ = wall;
        respond::collide_wall(disc, normal, restitution)
    }
}

impl Kernel for f64 {
    type Time = Self;
    type Pull = ();

    const GLIDES: bool = true;

    #[inline]
    fn time_within(bounds: Interval) -> Option<Self> {
        Some(bounds.lo())
    }

    #[inline]
    fn glance_at_discs(approach: &Approach<'_, Self>) -> Glance {
        let Ok(met) = Self::meet_discs(approach);
        Glance::at(met)
    }

    #[inline]
    fn glance_at_wall(
        flight: Flight<'_, Self>,
        wall: &Segment<Self>,
        barred: impl Fn(End) -> bool,
    ) -> Glance {
        let Ok(met) = Self::meet_wall(flight, wall, barred);
        Glance::at(met)
    }
}

impl Kernel for Interval {
    type Time = Self;
    type Pull = ();
}

impl Kernel for Exact {
    type Time = Self;
    type Pull = ();
}

impl Kernel for Expression {
    type Time = Self;
    type Pull = ();
}
