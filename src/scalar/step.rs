//! A computation taken as a whole, over any [`Scalar`].
//!
//! One operation after another, an enclosure forgets how the errors of its
//! operands hang together, and grows faster than the truth: the wrapping
//! effect. A type that can do better with the whole computation at hand does
//! so in [`Scalar::step`].

use super::Scalar;

/// A computation written once for all numbers.
///
/// The maps visit the numbers of an input or an output in a fixed order.
pub trait Step {
    /// What goes in.
    type Input<T>;
    /// What comes out.
    type Output<T>;

    /// Computes one from the other; none where the input is not of the kind
    /// that the step is for.
    ///
    /// # Errors
    ///
    /// A decision on the way is left open.
    fn apply<T: Scalar>(input: &Self::Input<T>) -> Result<Option<Self::Output<T>>, T::Doubt>;

    /// The input in another arithmetic.
    fn map_input<T, U>(input: &Self::Input<T>, make: impl Fn(&T) -> U) -> Self::Input<U>;

    /// The output in another arithmetic.
    fn map_output<T, U>(output: &Self::Output<T>, make: impl Fn(&T) -> U) -> Self::Output<U>;
}
