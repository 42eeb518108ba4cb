//! What makes a scene one that can be simulated. Every comparison is exact.

use num_rational::BigRational;
use num_traits::{One, Signed};

use super::input::shown;
use super::{Cell, Disc, Effects, Mass, Restitution, Scene, SceneError, Wall};
use crate::scalar::Number;

type Verdict = Result<(), SceneError>;

/// The scene, if nothing is wrong with it. Effects that have no effect are
/// taken out, so that they cost nothing.
pub(super) fn validated(mut scene: Scene) -> Result<Scene, SceneError> {
    for (index, disc) in scene.discs.iter().enumerate() {
        check_disc(&format!("discs[{index}]"), disc)?;
    }
    for (index, wall) in scene.walls.iter().enumerate() {
        check_wall(&format!("walls[{index}]"), wall)?;
    }
    check_periodic(&scene)?;
    check_frame(&scene)?;
    check_effects(&scene)?;
    drop_idle(&mut scene.effects);
    Ok(scene)
}

fn check_disc(place: &str, disc: &Disc) -> Verdict {
    check_positive(&format!("{place}.radius"), &disc.radius)?;
    match &disc.mass {
        Mass::Finite(mass) => check_positive(&format!("{place}.mass"), mass),
        Mass::Infinite => Ok(()),
    }
}

fn check_wall(place: &str, wall: &Wall) -> Verdict {
    let [x, y] = &wall.from;
    require(!same_point(&wall.from, &wall.to), || {
        let found = format!("({}, {}) twice", shown(x), shown(y));
        SceneError::physical(place, "two different end points", found)
    })
}

fn check_periodic(scene: &Scene) -> Verdict {
    let Some(cell) = &scene.periodic else {
        return Ok(());
    };
    require(scene.walls.is_empty(), || {
        let found = format!("walls: {}", scene.walls.len());
        SceneError::physical("periodic", "a periodic cell or walls, not both", found)
    })?;
    let sides = sides(cell)?;
    for (index, disc) in scene.discs.iter().enumerate() {
        check_fits(&format!("discs[{index}].radius"), &disc.radius, &sides)?;
    }
    Ok(())
}

/// The lengths of a cell's sides, which must be positive.
fn sides(cell: &Cell) -> Result<[BigRational; 2], SceneError> {
    let side = |axis: usize| -> Result<BigRational, SceneError> {
        let [from, to] = [&cell.from[axis], &cell.to[axis]];
        let side = to.to_rational() - from.to_rational();
        require(side.is_positive(), || {
            let place = format!("periodic.to[{axis}]");
            SceneError::physical(
                place,
                format!("a number greater than {}", shown(from)),
                shown(to),
            )
        })?;
        let number = Number::try_from(side.clone());
        number.map_err(|error| SceneError::format(format!("periodic.to[{axis}]"), error))?;
        Ok(side)
    };
    Ok([side(0)?, side(1)?])
}

/// A disc may touch its own images, but not overlap them.
fn check_fits(place: &str, radius: &Number, sides: &[BigRational; 2]) -> Verdict {
    let twice = radius.to_rational() * BigRational::from_integer(2.into());
    require(sides.iter().all(|side| twice <= *side), || {
        SceneError::physical(
            place,
            "at most half a side of the periodic cell",
            shown(radius),
        )
    })
}

fn check_frame(scene: &Scene) -> Verdict {
    check_positive("frame.duration", &scene.frame.duration)?;
    require(scene.frame.count > 0, || {
        SceneError::physical("frame.count", "at least 1", scene.frame.count)
    })
}

fn check_effects(scene: &Scene) -> Verdict {
    match &scene.effects.restitution {
        Restitution::Elastic => {}
        Restitution::Newton {
            coefficient,
            walls,
            elastic_below,
        } => check_newton(coefficient, walls.as_ref(), elastic_below.as_ref())?,
        Restitution::Paper { loss } => check_paper(loss, &scene.discs)?,
    }
    match &scene.effects.drag {
        Some(rate) => check_drag(rate),
        None => Ok(()),
    }
}

fn check_newton(
    coefficient: &Number,
    walls: Option<&Number>,
    elastic_below: Option<&Number>,
) -> Verdict {
    check_fraction("effects.restitution.newton", coefficient)?;
    if let Some(walls) = walls {
        check_fraction("effects.restitution.walls", walls)?;
    }
    if let Some(speed) = elastic_below {
        check_positive("effects.restitution.elastic_below", speed)?;
    }
    Ok(())
}

/// A velocity can be cut to a part of itself only where it is known relative
/// to what: to the bodies that never move.
fn check_paper(loss: &Number, discs: &[Disc]) -> Verdict {
    let place = "effects.restitution.paper";
    check_fraction(place, loss)?;
    let drives = |disc: &Disc| disc.mass == Mass::Infinite && !is_zero(&disc.velocity);
    match discs.iter().position(drives) {
        Some(index) => Err(SceneError::physical(
            place,
            "no moving body of infinite mass",
            format_args!("discs[{index}]"),
        )),
        None => Ok(()),
    }
}

fn check_drag(rate: &Number) -> Verdict {
    require(rate.sign().is_ge(), || {
        SceneError::physical("effects.drag.linear", "a number not below 0", shown(rate))
    })
}

fn check_positive(place: &str, number: &Number) -> Verdict {
    require(number.is_positive(), || {
        SceneError::physical(place, "a positive number", shown(number))
    })
}

fn check_fraction(place: &str, number: &Number) -> Verdict {
    let is_fraction = number.sign().is_ge() && number.to_rational() <= BigRational::one();
    require(is_fraction, || {
        SceneError::physical(place, "a number from 0 to 1", shown(number))
    })
}

fn require(holds: bool, otherwise: impl FnOnce() -> SceneError) -> Verdict {
    if holds { Ok(()) } else { Err(otherwise()) }
}

fn drop_idle(effects: &mut Effects) {
    effects.drag.take_if(|rate| rate.is_zero());
    effects.gravity.take_if(|gravity| is_zero(gravity));
}

fn same_point(a: &[Number; 2], b: &[Number; 2]) -> bool {
    a.iter()
        .zip(b)
        .all(|(a, b)| a.to_rational() == b.to_rational())
}

fn is_zero(vector: &[Number; 2]) -> bool {
    vector.iter().all(Number::is_zero)
}
