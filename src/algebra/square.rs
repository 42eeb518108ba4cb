//! Whether a number of a tower is a square there.
//!
//! Let K be a field of reals, e in K no square of K, and x = a + b√e with a
//! and b in K.
//!
//! - **b = 0.** (r + s√e)² = r² + s² e + 2 r s √e has no part with √e only if
//!   r or s is zero. So x is a square in K(√e) exactly if a is one in K, then
//!   √x is there; or if a/e = s² is one in K, equivalently a e = (s e)²; then
//!   √x = s√e.
//! - **b ≠ 0.** If x = (r + s√e)², then a = r² + s² e and b = 2 r s, hence
//!   a² - b² e = (r² - s² e)² is a square n² in K, and r² is (a + n)/2 for one
//!   of the signs of n. Conversely, if such an n exists and (a + n)/2 = r²,
//!   then with s = b / (2 r) we have s² e = b² e / (4 r²) = (a² - n²) /
//!   (2 (a + n)) = (a - n)/2, so that r² + s² e = a and 2 r s = b. Here r is
//!   not zero: n = -a would give b² e = 0.
//!
//! Each question about K(√e) becomes two or three about K, and in Q the answer
//! is known. Nearly all numbers that are no squares are found out before that,
//! by their images in prime fields (see [`modular`](super::modular)).

use num_bigint::BigInt;
use num_rational::BigRational;

use super::element::Element;
use super::rational::rational_root;
use super::tower::{Stop, Tower};

impl Tower {
    /// A number whose square is `x`, of either sign, if there is one.
    pub(super) fn square_root(&self, x: &Element) -> Result<Option<Element>, Stop> {
        self.root_in(self.height(), x)
    }

    /// A square root among the numbers made of the first `height` radicals.
    fn root_in(&self, height: usize, x: &Element) -> Result<Option<Element>, Stop> {
        if x.is_zero() {
            return Ok(Some(x.clone()));
        }
        if let Some(value) = x.to_rational().filter(|_| height == 0) {
            return Ok(rational_root(&value).as_ref().map(Element::rational));
        }
        if self.embeddings[height]
            .iter()
            .any(|map| map.refutes_square(x))
        {
            return Ok(None);
        }
        let level = height - 1;
        let (a, b) = x.split(level);
        if b.is_zero() {
            self.root_of_lower(level, &a)
        } else {
            self.root_of_mixed(level, &a, &b)
        }
    }

    /// √a for a in K: r, or s√e.
    fn root_of_lower(&self, level: usize, a: &Element) -> Result<Option<Element>, Stop> {
        if let Some(root) = self.root_in(level, a)? {
            return Ok(Some(root));
        }
        let e = self.radicand(level);
        let Some(root) = self.root_in(level, &self.mul(a, &e)?)? else {
            return Ok(None);
        };
        let s = self.mul(&root, &self.inverse(&e)?)?;
        Ok(Some(s.times_radical(level)))
    }

    /// √(a + b√e) with b ≠ 0: r + s√e.
    fn root_of_mixed(
        &self,
        level: usize,
        a: &Element,
        b: &Element,
    ) -> Result<Option<Element>, Stop> {
        let Some(n) = self.root_in(level, &self.norm(a, b, level)?)? else {
            return Ok(None);
        };
        let half = BigRational::new(BigInt::from(1), BigInt::from(2));
        for sum in [a.add(&n), a.sub(&n)] {
            let Some(r) = self.root_in(level, &self.within(sum.scaled(&half))?)? else {
                continue;
            };
            let s = self.mul(&b.scaled(&half), &self.inverse(&r)?)?;
            return Ok(Some(r.add(&s.times_radical(level))));
        }
        Ok(None)
    }
}
