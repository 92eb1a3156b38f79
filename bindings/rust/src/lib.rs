#![doc = include_str!("../README.md")]
#![deny(missing_debug_implementations)]

#[rustfmt::skip]
mod objects;
mod shapes;
mod support;
#[rustfmt::skip]
#[allow(missing_debug_implementations, non_camel_case_types)]
pub mod sys;
#[rustfmt::skip]
mod types;

pub use objects::*;
pub use shapes::{transform, PlainShape, Shape, Shapes};
pub use support::{Batch, BatchMut, Error, Hook, List, Ragged, Result, Size};
pub use types::*;

/// Major, minor and patch version of the loaded library.
pub fn version() -> (u32, u32, u32) {
    let number = unsafe { sys::gphys_version() };
    (number >> 16, number >> 8 & 0xff, number & 0xff)
}
