//! The timeline of a scene, for a game or a viewer: where bodies are whenever it is
//! asked, and the impacts up to then.
//!
//! To look does not disturb: the impacts are the same to the last bit however often
//! and whenever the bodies are looked at in between, for a body is kept where its own
//! last impact left it.
//!
//! ```
//! use carom::playback::Playback;
//! use carom::scene::{Disc, Scene};
//!
//! let ball = Disc::at([0, 0], 1).velocity([3, 0]);
//! let scene = Scene::builder("ball").disc(ball).wall([5, -9], [5, 9]).frame(10, 1);
//! let mut playback = Playback::<f64>::new(&scene.build()?, ())?;
//!
//! let Ok(impacts) = playback.advance(&1.0);
//! assert!(impacts.is_empty());
//! assert_eq!(playback.discs()[0].position.x, 3.0);
//!
//! // It meets the wall after 4/3, at 4.
//! let Ok(impacts) = playback.advance(&1.0);
//! assert_eq!(impacts.len(), 1);
//! assert_eq!(playback.discs()[0].position.x, 2.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use std::cmp::Ordering::{Greater, Less};

use crate::arithmetic::Arithmetic;
use crate::body::Disc;
use crate::effects::{Course, course};
use crate::impact::Impact;
use crate::scalar::{Doubt, Number, Undecided};
use crate::scene::Scene;
use crate::simulation::Algorithm;
use crate::support::{Unsupported, check_distances, check_number, check_support};
use crate::timeline::{Accumulation, Setup};
use crate::world::World;

/// A timeline at some time, which moves on.
#[derive(Clone, Debug)]
pub struct Playback<S: Arithmetic> {
    course: Box<dyn Course<S>>,
    time: S,
    end: S,
}

/// Why a scene is not played.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PlaybackError {
    /// It asks for something that cannot be simulated.
    #[error(transparent)]
    Unsupported(#[from] Unsupported),
    /// It is open what the discs meet first.
    #[error(transparent)]
    Undecided(#[from] Undecided),
}

impl<S: Arithmetic> Playback<S> {
    /// A scene from its start to the end of its last frame.
    ///
    /// # Errors
    ///
    /// The scene cannot be simulated, or not with this precision.
    pub fn new(scene: &Scene, precision: S::Precision) -> Result<Self, PlaybackError> {
        let end = S::from_rational(scene.frame().total(), precision);
        Self::start(scene, end, precision)
    }

    /// A scene from its start to another end, such as one that is as good as never.
    ///
    /// # Errors
    ///
    /// The scene cannot be simulated, or not with this precision.
    pub fn until(
        scene: &Scene,
        end: &Number,
        precision: S::Precision,
    ) -> Result<Self, PlaybackError> {
        check_number::<S>("until", end)?;
        check_distances(scene, &end.to_rational())?;
        Self::start(scene, S::from_number(end, precision), precision)
    }

    fn start(scene: &Scene, end: S, precision: S::Precision) -> Result<Self, PlaybackError> {
        check_support::<S>(scene, Algorithm::Timeline)?;
        let world = World::new(scene, precision);
        let started = course(world, scene.effects(), &end, &Setup::default(), precision);
        Ok(Self {
            course: started.map_err(Doubt::into_undecided)?,
            time: S::from_integer(0),
            end,
        })
    }

    /// Moves on by a time, and returns the impacts on the way. The end is as far as
    /// it goes, or the limit of impacts that [accumulate](Self::accumulation).
    ///
    /// # Errors
    ///
    /// It cannot be decided which impact is the next.
    pub fn advance(&mut self, by: &S) -> Result<Vec<Impact<S>>, S::Doubt> {
        self.advance_to(&(self.time.clone() + by))
    }

    /// Moves on to a time, unless it is past, and returns the impacts on the way.
    ///
    /// # Errors
    ///
    /// It cannot be decided which impact is the next.
    pub fn advance_to(&mut self, time: &S) -> Result<Vec<Impact<S>>, S::Doubt> {
        let time = earlier(time, &self.end)?.clone();
        let mut impacts = Vec::new();
        while let Some(impact) = self.next_before(&time)? {
            impacts.push(impact);
        }
        if self.accumulation().is_none() && time.compare(&self.time)? == Greater {
            self.time = time;
        }
        Ok(impacts)
    }

    /// All impacts that are still to come, one after the other: each takes the time on
    /// to its own.
    pub fn impacts(&mut self) -> Impacts<'_, S> {
        Impacts { playback: self }
    }

    fn next_before(&mut self, limit: &S) -> Result<Option<Impact<S>>, S::Doubt> {
        let next = self.course.next_impact(limit)?;
        if next.is_some() {
            self.time = self.course.now();
        }
        Ok(next)
    }

    /// The present time.
    pub fn time(&self) -> &S {
        &self.time
    }

    /// The discs as they are at the present time, after all impacts up to then.
    pub fn discs(&self) -> Vec<Disc<S>> {
        self.course.discs_at(&self.time)
    }

    /// Infinitely many impacts that have come up, beyond which nothing is known: then
    /// the time stands still.
    pub fn accumulation(&self) -> Option<Accumulation<S>> {
        self.course.accumulation()
    }
}

fn earlier<'a, S: Arithmetic>(one: &'a S, other: &'a S) -> Result<&'a S, S::Doubt> {
    Ok(match one.compare(other)? {
        Less => one,
        _ => other,
    })
}

/// The impacts of a [`Playback`] in their order.
#[derive(Debug)]
pub struct Impacts<'a, S: Arithmetic> {
    playback: &'a mut Playback<S>,
}

impl<S: Arithmetic> Iterator for Impacts<'_, S> {
    type Item = Result<Impact<S>, S::Doubt>;

    fn next(&mut self) -> Option<Self::Item> {
        let end = self.playback.end.clone();
        self.playback.next_before(&end).transpose()
    }
}

#[cfg(test)]
mod tests {
    use std::cmp::Ordering::Equal;

    use super::*;
    use crate::scalar::{Exact, Scalar};
    use crate::scene::{Restitution, SceneBuilder};

    fn ball() -> SceneBuilder {
        let ball = crate::scene::Disc::at([0, 0], 1).velocity([3, 0]);
        Scene::builder("ball")
            .disc(ball)
            .wall([5, -9], [5, 9])
            .frame(10, 1)
    }

    fn playback(scene: SceneBuilder) -> Playback<f64> {
        Playback::new(&scene.build().unwrap(), ()).unwrap()
    }

    #[test]
    fn time_goes_neither_back_nor_past_the_end() {
        let mut playback = playback(ball());
        let Ok(impacts) = playback.advance_to(&20.0);
        assert_eq!((impacts.len(), *playback.time()), (1, 10.0));
        let Ok(impacts) = playback.advance(&-3.0);
        assert_eq!((impacts.len(), *playback.time()), (0, 10.0));
        // From 4 at 4/3 back at 3: to 4 - 3 (10 - 4/3).
        assert_eq!(playback.discs()[0].position.x, -22.0);
    }

    #[test]
    fn another_end_than_the_scenes() {
        let scene = ball().build().unwrap();
        let end = Number::from(100);
        let mut playback = Playback::<Exact>::until(&scene, &end, 128).unwrap();
        let impacts: Vec<_> = playback.impacts().map(Result::unwrap).collect();
        assert_eq!(impacts.len(), 1);
        let time = playback.time().compare(&Exact::from_integer(2));
        assert_eq!(time, Ok(Less));
        playback.advance(&Exact::from_integer(1000)).unwrap();
        let time = playback.time().compare(&Exact::from_integer(100));
        assert_eq!(time, Ok(Equal));
    }

    /// A disc of mass 1/100 between two others that come together, which lose half of
    /// their speed at each impact.
    #[test]
    fn an_accumulation_stops_the_time() {
        let disc = |x: i32, mass: &str, speed: i32| {
            crate::scene::Disc::at([x, 0], 1)
                .mass(mass)
                .velocity([speed, 0])
        };
        let discs = [disc(-4, "1", 1), disc(0, "1/100", 0), disc(4, "1", -1)];
        let scene = Scene::builder("collapse").discs(discs).frame(10, 1);
        let mut playback =
            playback(scene.restitution(Restitution::newton(Number::try_from(0.125).unwrap())));
        let Ok(_) = playback.advance(&10.0);
        assert!(playback.accumulation().is_some());
        let time = *playback.time();
        let Ok(impacts) = playback.advance(&1.0);
        assert!(impacts.is_empty() && *playback.time() == time && time < 3.0);
    }

    #[test]
    fn what_is_not_supported_is_told() {
        let scene = ball().gravity([0, -1]).linear_drag(1).build().unwrap();
        let error = Playback::<crate::scalar::Filtered>::new(&scene, ()).err();
        assert!(matches!(error, Some(PlaybackError::Unsupported(_))));
    }
}
