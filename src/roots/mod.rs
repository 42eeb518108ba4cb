//! Placeholder.
use crate::scalar::Scalar;
/// P.
#[derive(Clone, Debug)]
pub struct Polynomial<S>(pub [S; 5]);
/// D.
#[derive(Clone, Debug)]
pub struct Descent<S> {
    /// t
    pub time: S,
    /// g
    pub graze: bool,
}
/// R.
pub trait Roots: Scalar {
    /// d
    fn descent(f: &Polynomial<Self>, grazes: usize) -> Result<Option<Descent<Self>>, Self::Doubt>;
}
impl Roots for f64 {
    fn descent(_: &Polynomial<Self>, _: usize) -> Result<Option<Descent<Self>>, Self::Doubt> {
        Ok(None)
    }
}
impl Roots for crate::scalar::Exact {
    fn descent(_: &Polynomial<Self>, _: usize) -> Result<Option<Descent<Self>>, Self::Doubt> {
        Ok(None)
    }
}
