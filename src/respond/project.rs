//! The impulses that take as much energy as they can: the projection of
//! velocities onto those that do not approach.
//!
//! Given are the contacts' closing speeds a and the matrix G of how an impulse
//! at one contact slows another: impulses λ leave the closing speeds a - Gλ.
//! Wanted are λ ≥ 0 such that nothing closes any more, and such that a contact
//! with an impulse does not open either:
//!
//! λ ≥ 0, a - Gλ ≤ 0, λ·(a - Gλ) = 0.
//!
//! These are the conditions for the least of the kinetic energy ½λ·Gλ - a·λ
//! over λ ≥ 0. The velocities after it are unique, for it is strictly convex in
//! them. The impulses are unique where the contacts' gradients are independent.
//!
//! The method is that of Lawson and Hanson (Solving Least Squares Problems,
//! 1974, chapter 23) over any number: contacts enter a set of pressing ones
//! one by one, those whose impulse would have to pull leave it. Between bodies
//! at rest or of finite mass a contact that enters still closes, so its gradient
//! is independent of those in the set, on which nothing closes. Moving bodies of
//! infinite mass can make it depend on them: two that drive a disc the same way,
//! at different speeds. Then its impulse can take over from theirs, until one
//! of them is not needed any more and leaves. (If that never happens, the
//! contacts cannot part at all.) So every system that is solved has one
//! solution. Each
//! time the set is complete, its impulses are the best that these contacts can
//! do, and better than all before; so no set comes twice, and there are
//! finitely many. Where results round, "better" is required to hold in numbers,
//! or it ends there: what it has then is the best for its set of contacts all
//! the same, which is all that the conservation of energy rests on.

use std::cmp::Ordering::{Equal, Greater, Less};

use crate::scalar::Scalar;

/// How contacts act on each other.
pub(super) struct System<S> {
    /// By how much a unit impulse at the one contact (column) slows the
    /// closing of the other (row); symmetric.
    pub(super) response: Vec<Vec<S>>,
    /// How fast each contact closes.
    pub(super) closing: Vec<S>,
}

impl<S: Scalar> System<S> {
    /// The impulses, one for each contact.
    pub(super) fn project(&self) -> Result<Vec<S>, S::Doubt> {
        let zero = S::from_integer(0);
        let mut state = State {
            impulses: vec![zero; self.closing.len()],
            pressing: Vec::new(),
        };
        let mut refused = Vec::new();
        let mut best = None;
        while let Some(next) = self.still_closing(&state, &refused)? {
            let Some(candidate) = self.enter(&state, next)? else {
                refused.push(next);
                continue;
            };
            if S::ROUNDS && !self.is_better(&candidate, &mut best)? {
                break;
            }
            state = candidate;
            refused.clear();
        }
        Ok(state.impulses)
    }

    /// The first contact without an impulse that closes for certain; a doubt
    /// matters only if there is none.
    fn still_closing(
        &self,
        state: &State<S>,
        refused: &[usize],
    ) -> Result<Option<usize>, S::Doubt> {
        let mut doubt = None;
        for contact in 0..self.closing.len() {
            if state.pressing.contains(&contact) || refused.contains(&contact) {
                continue;
            }
            match self.rest(state, contact).sign() {
                Ok(Greater) => return Ok(Some(contact)),
                Ok(Equal | Less) => {}
                Err(reason) => doubt = Some(reason),
            }
        }
        doubt.map_or(Ok(None), Err)
    }

    /// The closing speed that the impulses leave of a contact's.
    fn rest(&self, state: &State<S>, contact: usize) -> S {
        state
            .pressing
            .iter()
            .fold(self.closing[contact].clone(), |rest, &other| {
                rest - self.response[contact][other].clone() * &state.impulses[other]
            })
    }

    /// Lets a contact press, and those leave that would have to pull. None if
    /// it cannot help, which rounding alone, or a contact of two bodies that
    /// nothing deflects, brings about.
    fn enter(&self, state: &State<S>, next: usize) -> Result<Option<State<S>>, S::Doubt> {
        let mut state = state.clone();
        let others = state.pressing.clone();
        state.pressing.push(next);
        state.pressing.sort_unstable();
        while !state.pressing.is_empty() {
            let Some(wanted) = self.solve(&state.pressing, &self.closing)? else {
                let is_new = state.pressing.len() > others.len();
                if is_new && self.take_over(&mut state, &others, next)? {
                    continue;
                }
                return Ok(None);
            };
            if state.takes(&wanted)? {
                return Ok(state.pressing.contains(&next).then_some(state));
            }
        }
        Ok(None)
    }

    /// Lets the impulse of a contact that depends on others grow in their
    /// place, as far as none of theirs pulls, and those leave which stop it
    /// there. None may.
    fn take_over(
        &self,
        state: &mut State<S>,
        others: &[usize],
        next: usize,
    ) -> Result<bool, S::Doubt> {
        let Some(parts) = self.solve(others, &self.response[next])? else {
            return Ok(false);
        };
        let mut first: Option<(usize, S)> = None;
        for (&contact, part) in others.iter().zip(&parts) {
            if part.sign()? == Greater {
                let most = state.impulses[contact].clone() / part;
                if first
                    .as_ref()
                    .map_or(Ok(Less), |(_, least)| most.compare(least))?
                    == Less
                {
                    first = Some((contact, most));
                }
            }
        }
        let Some((leaving, most)) = first else {
            return Ok(false);
        };
        for (&contact, part) in others.iter().zip(&parts) {
            state.impulses[contact] = state.impulses[contact].clone() - most.clone() * part;
        }
        state.impulses[next] = most;
        state.impulses[leaving] = S::from_integer(0);
        state.pressing.retain(|contact| *contact != leaving);
        Ok(true)
    }

    /// The impulses of these contacts alone that make up for such closing
    /// speeds, unless the contacts depend on each other. By elimination; the
    /// matrix is positive definite, so no pivot has to be looked for.
    fn solve(&self, contacts: &[usize], closing: &[S]) -> Result<Option<Vec<S>>, S::Doubt> {
        let row = |&contact: &usize| {
            let entries = contacts.iter();
            let entries = entries.map(|&other| self.response[contact][other].clone());
            entries.chain([closing[contact].clone()]).collect()
        };
        let mut rows: Vec<Vec<S>> = contacts.iter().map(row).collect();
        for pivot in 0..rows.len() {
            if rows[pivot][pivot].sign()? != Greater {
                return Ok(None);
            }
            let (done, below) = rows.split_at_mut(pivot + 1);
            below
                .iter_mut()
                .for_each(|row| eliminate(row, &done[pivot], pivot));
        }
        Ok(Some(substitute(&rows)))
    }

    /// Whether the energy taken, ½a·λ, is more than ever before.
    fn is_better(&self, state: &State<S>, best: &mut Option<S>) -> Result<bool, S::Doubt> {
        let taken = state
            .pressing
            .iter()
            .fold(S::from_integer(0), |taken, &contact| {
                taken + self.closing[contact].clone() * &state.impulses[contact]
            });
        let better = match &best {
            Some(best) => taken.compare(best)? == Greater,
            None => true,
        };
        *best = Some(taken);
        Ok(better)
    }
}

/// Takes so much of the pivot's row from another that its entry vanishes.
fn eliminate<S: Scalar>(row: &mut [S], pivot_row: &[S], pivot: usize) {
    let factor = row[pivot].clone() / &pivot_row[pivot];
    for (entry, above) in row.iter_mut().zip(pivot_row).skip(pivot + 1) {
        *entry = entry.clone() - factor.clone() * above;
    }
}

/// Solves rows in triangular form; their last entries are the right side.
fn substitute<S: Scalar>(rows: &[Vec<S>]) -> Vec<S> {
    let count = rows.len();
    let mut solution = vec![S::from_integer(0); count];
    for (index, row) in rows.iter().enumerate().rev() {
        let rest = (index + 1..count).fold(row[count].clone(), |rest, other| {
            rest - row[other].clone() * &solution[other]
        });
        solution[index] = rest / &row[index];
    }
    solution
}

/// Impulses that push, and at which contacts.
#[derive(Clone)]
struct State<S> {
    /// One for each contact.
    impulses: Vec<S>,
    /// The contacts with an impulse, in order.
    pressing: Vec<usize>,
}

impl<S: Scalar> State<S> {
    /// Takes the impulses wanted at the pressing contacts if all of them push.
    /// Otherwise goes towards them as far as none pulls, and lets that contact
    /// leave which stops it there.
    fn takes(&mut self, wanted: &[S]) -> Result<bool, S::Doubt> {
        let Some((leaving, way)) = self.first_to_pull(wanted)? else {
            for (&contact, wanted) in self.pressing.iter().zip(wanted) {
                self.impulses[contact] = wanted.clone();
            }
            return Ok(true);
        };
        for (&contact, wanted) in self.pressing.iter().zip(wanted) {
            let impulse = self.impulses[contact].clone();
            self.impulses[contact] = impulse.clone() + (wanted.clone() - impulse) * &way;
        }
        let contact = self.pressing.remove(leaving);
        self.impulses[contact] = S::from_integer(0);
        Ok(false)
    }

    /// The place among the pressing contacts of the first whose impulse gets
    /// to zero on the way to what is wanted, and which part of the way that is.
    fn first_to_pull(&self, wanted: &[S]) -> Result<Option<(usize, S)>, S::Doubt> {
        let mut first: Option<(usize, S)> = None;
        for (place, (&contact, wanted)) in self.pressing.iter().zip(wanted).enumerate() {
            if wanted.sign()? == Greater {
                continue;
            }
            let impulse = &self.impulses[contact];
            let step = impulse.clone() - wanted;
            let way = match step.sign()? {
                Greater => impulse.clone() / &step,
                Less | Equal => S::from_integer(0),
            };
            let sooner = match &first {
                Some((_, before)) => way.compare(before)? == Less,
                None => true,
            };
            if sooner {
                first = Some((place, way));
            }
        }
        Ok(first)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::scalar::Exact;

    fn system(response: &[&[i32]], closing: &[i32]) -> System<Exact> {
        let numbers = |row: &[i32]| {
            row.iter()
                .map(|&entry| Exact::from_integer(entry))
                .collect()
        };
        System {
            response: response.iter().map(|row| numbers(row)).collect(),
            closing: numbers(closing),
        }
    }

    fn impulses(response: &[&[i32]], closing: &[i32]) -> Vec<f64> {
        let solved = system(response, closing).project().unwrap();
        solved.iter().map(Exact::to_f64).collect()
    }

    #[test]
    fn what_opens_takes_no_impulse() {
        assert_eq!(impulses(&[&[2, -1], &[-1, 2]], &[-1, -1]), [0.0, 0.0]);
        assert_eq!(impulses(&[&[2, 1], &[1, 2]], &[4, -1]), [2.0, 0.0]);
        // The second closes by 1, but the first impulse opens it by 3.
        assert_eq!(impulses(&[&[2, 1], &[1, 2]], &[6, 1]), [3.0, 0.0]);
    }

    #[test]
    fn a_contact_leaves_when_another_has_entered() {
        // The first presses (1/2) until the second does; with both, it would
        // have to pull: 2x + 3y = 1, 3x + 5y = 3 gives x = -4.
        assert_eq!(impulses(&[&[2, 3], &[3, 5]], &[1, 3]), [0.0, 0.6]);
    }

    #[test]
    fn contacts_that_depend_on_each_other_share() {
        // The same contact twice, and once with half its gradient.
        let solved = impulses(&[&[4, 4, 2], &[4, 4, 2], &[2, 2, 1]], &[8, 8, 4]);
        assert_eq!(4.0 * solved[0] + 4.0 * solved[1] + 2.0 * solved[2], 8.0);
        // A channel of no play: what one side takes, the other cannot.
        assert_eq!(impulses(&[&[1, -1], &[-1, 1]], &[3, -3]), [3.0, 0.0]);
    }

    #[test]
    fn a_contact_takes_over_from_those_that_it_depends_on() {
        // The second closes faster in the same direction, or in one that the
        // first two make up: (1, 0), (0, 1) and (1, 1).
        assert_eq!(impulses(&[&[1, 1], &[1, 1]], &[7, 10]), [0.0, 10.0]);
        let sum: &[&[i32]] = &[&[1, 0, 1], &[0, 1, 1], &[1, 1, 2]];
        assert_eq!(impulses(sum, &[2, 3, 9]), [0.0, 0.0, 4.5]);
        // The third takes over the 2 of the first, and then all.
        assert_eq!(impulses(sum, &[2, 4, 8]), [0.0, 0.0, 4.0]);
    }

    #[test]
    fn a_contact_that_nothing_moves_is_left_alone() {
        assert_eq!(impulses(&[&[0, 0], &[0, 2]], &[1, 2]), [0.0, 1.0]);
    }

    /// G = BᵀB for a matrix B of small integers, and a = Bᵀv.
    fn gram(columns: &[[i32; 4]], velocity: [i32; 4]) -> System<Exact> {
        let dot = |a: &[i32; 4], b: &[i32; 4]| a.iter().zip(b).map(|(a, b)| a * b).sum::<i32>();
        let response: Vec<Vec<i32>> = columns
            .iter()
            .map(|one| columns.iter().map(|other| dot(one, other)).collect())
            .collect();
        let rows: Vec<&[i32]> = response.iter().map(Vec::as_slice).collect();
        let closing: Vec<i32> = columns.iter().map(|one| dot(one, &velocity)).collect();
        system(&rows, &closing)
    }

    proptest! {
        /// The conditions that the solution is defined by, for dependent
        /// gradients too: up to seven in four dimensions.
        #[test]
        fn nothing_closes_and_what_presses_does_not_open(
            columns in prop::collection::vec(prop::array::uniform4(-3..=3), 1..8),
            velocity in prop::array::uniform4(-5..=5),
        ) {
            let system = gram(&columns, velocity);
            let impulses = system.project().unwrap();
            for (row, closing) in system.response.iter().zip(&system.closing) {
                let rest = row.iter().zip(&impulses).fold(closing.clone(), |rest, (entry, impulse)| {
                    rest - entry.clone() * impulse
                });
                prop_assert!(rest.sign().unwrap().is_le());
            }
            for (contact, impulse) in impulses.iter().enumerate() {
                prop_assert!(impulse.sign().unwrap().is_ge());
                if impulse.sign().unwrap().is_gt() {
                    let pressing = State {
                        impulses: impulses.clone(),
                        pressing: (0..impulses.len()).collect(),
                    };
                    prop_assert!(system.rest(&pressing, contact).sign().unwrap().is_eq());
                }
            }
        }

        #[test]
        fn binary64_ends_and_never_pulls(
            columns in prop::collection::vec(prop::array::uniform4(-3..=3), 1..8),
            velocity in prop::array::uniform4(-5..=5),
        ) {
            let exact = gram(&columns, velocity);
            let rounded = System {
                response: exact.response.iter().map(|row| row.iter().map(Exact::to_f64).collect()).collect(),
                closing: exact.closing.iter().map(Exact::to_f64).collect(),
            };
            prop_assert!(rounded.project().unwrap().iter().all(|impulse: &f64| *impulse >= 0.0));
        }
    }
}
