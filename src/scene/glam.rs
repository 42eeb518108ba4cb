//! Points as [`glam::DVec2`], the public vector of binary64.
//!
//! ```
//! use carom::scene::{Disc, Scene};
//! use glam::DVec2;
//!
//! let place = DVec2::new(0.5, 0.25);
//! let scene = Scene::builder("one").disc(Disc::at(place, 1)).build()?;
//! assert_eq!(scene.discs()[0].position_f64(), place);
//! # Ok::<(), carom::scene::SceneError>(())
//! ```

use glam::DVec2;

use super::{Disc, IntoNumber, IntoPoint};
use crate::scalar::{Number, NumberError};

impl IntoPoint for DVec2 {
    fn into_point(self) -> [Result<Number, NumberError>; 2] {
        self.to_array().map(IntoNumber::into_number)
    }
}

/// The point with each coordinate rounded to nearest.
pub fn to_dvec2(point: &[Number; 2]) -> DVec2 {
    let [x, y] = point;
    DVec2::new(x.to_f64(), y.to_f64())
}

impl Disc {
    /// The centre, rounded to nearest.
    pub fn position_f64(&self) -> DVec2 {
        to_dvec2(&self.position)
    }

    /// The velocity, rounded to nearest.
    pub fn velocity_f64(&self) -> DVec2 {
        to_dvec2(&self.velocity)
    }
}
