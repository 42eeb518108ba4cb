//! How the paper resolves an intersection (P3.5).
//!
//! The paper says only that "it is best to resolve the intersection". Here the
//! two are moved apart along the line of their centres to exact contact, by
//! shares in inverse proportion to their masses; an impulse follows only if
//! they approach. Concentric discs and a centre on a wall give no direction
//! and are left alone (D14).

use crate::body::Feature;
use crate::impact::two;
use crate::kernel::Kernel;
use crate::respond::{Share, shares};
use crate::vec2::Vec2;
use crate::world::{Obstacle, World};

/// Moves a disc and an obstacle apart, if they overlap, so that they touch:
/// what of the obstacle is returned.
pub(super) fn separate<S: Kernel>(
    world: &mut World<S>,
    disc: usize,
    obstacle: Obstacle,
) -> Result<Option<Feature>, S::Doubt> {
    let overlap = world.overlap(disc, obstacle)?;
    let Some((feature, separation)) = overlap.and_then(|(feature, overlap)| {
        let separation = overlap.separation?;
        Some((feature, separation))
    }) else {
        return Ok(None);
    };
    let push = separation.direction.scaled(&separation.lack);
    match feature {
        Feature::Disc(other) => {
            let [first, second] = two(&mut world.discs, disc, other as usize);
            let (first_share, second_share) = shares(&first.mass, &second.mass);
            displace(&mut first.position, &-push.clone(), &first_share);
            displace(&mut second.position, &push, &second_share);
            world.leave_contacts(other as usize, &separation.direction);
        }
        Feature::Wall(_) | Feature::Corner(_) => {
            displace(&mut world.discs[disc].position, &-push, &Share::Whole);
        }
    }
    world.leave_contacts(disc, &separation.direction);
    world.join(disc, feature);
    Ok(Some(feature))
}

fn displace<S: Kernel>(position: &mut Vec2<S>, push: &Vec2<S>, share: &Share<S>) {
    *position = match share {
        Share::Nothing => return,
        Share::Part(part) => position.moved(push, part),
        Share::Whole => position.plus(push),
    };
}
