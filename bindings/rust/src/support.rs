//! What the generated methods stand on: errors, arrays with any step between elements, lists.
use crate::sys;
use crate::types::*;
use std::ffi::CStr;
use std::marker::PhantomData;
use std::mem::{size_of, MaybeUninit};
use std::ptr::null;

/// A call failed and changed nothing; the message is the library's.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    pub status: Status,
    message: String,
}

pub type Result<T> = std::result::Result<T, Error>;

impl Error {
    fn argument(message: &str) -> Error {
        Error { status: Status::ERROR_INVALID_ARGUMENT, message: message.into() }
    }
}

impl std::fmt::Display for Error {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Error {}

impl std::fmt::Display for Status {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        let name = unsafe { CStr::from_ptr(sys::gphys_status_name(*self)) };
        f.write_str(&name.to_string_lossy())
    }
}

pub(crate) fn check(status: Status) -> Result<()> {
    if status.0 >= 0 {
        return Ok(());
    }
    // Each thread has its own message, and this one made the call.
    let message = unsafe { CStr::from_ptr(sys::gphys_last_error()) };
    Err(Error { status, message: message.to_string_lossy().into_owned() })
}

/// Whether there is an answer.
pub(crate) fn found(status: Status) -> Result<bool> {
    check(status)?;
    Ok(status == Status::OK)
}

pub(crate) fn pointer<T>(value: Option<&T>) -> *const T {
    value.map_or(null(), |v| v)
}

pub(crate) fn initialized<T>(init: impl FnOnce(*mut T) -> Status) -> T {
    let mut value = MaybeUninit::uninit();
    check(init(value.as_mut_ptr())).expect("a library that knows this struct");
    unsafe { value.assume_init() }
}

/// The size of a desc, which says how new it is; only its defaults have one.
#[repr(transparent)]
pub struct Size<Desc>(u32, PhantomData<fn() -> Desc>);

/// What the library calls back: none unless [`Hook::new`] made it.
#[repr(transparent)]
pub struct Hook<T>(*const T);

impl<T> Hook<T> {
    /// # Safety
    /// What it points to is valid until the object is created; its functions and its `user` until the
    /// object is dropped, on every thread that uses the object. The functions do what their comments say.
    pub unsafe fn new(hook: *const T) -> Hook<T> {
        Hook(hook)
    }
}

/// A list in a desc: a slice that is borrowed as long as the desc is used. `(&ids).into()` makes one.
// The length follows the pointer at once, as in C.
#[repr(C, packed(4))]
pub struct List<'a, T> {
    data: *const T,
    length: u32,
    borrowed: PhantomData<&'a [T]>,
}

impl<'a, T> From<&'a [T]> for List<'a, T> {
    /// # Panics
    /// If there are more elements than a call takes.
    fn from(elements: &'a [T]) -> Self {
        let length = u32::try_from(elements.len()).expect("fewer than 2^32 elements");
        let data = if length == 0 { null() } else { elements.as_ptr() };
        List { data, length, borrowed: PhantomData }
    }
}
impl<'a, T> From<&'a Vec<T>> for List<'a, T> {
    fn from(elements: &'a Vec<T>) -> Self {
        elements.as_slice().into()
    }
}
impl<'a, T, const N: usize> From<&'a [T; N]> for List<'a, T> {
    fn from(elements: &'a [T; N]) -> Self {
        elements.as_slice().into()
    }
}
// It is a shared slice.
unsafe impl<T: Sync> Send for List<'_, T> {}
unsafe impl<T: Sync> Sync for List<'_, T> {}
impl<T> Clone for List<'_, T> {
    fn clone(&self) -> Self {
        *self
    }
}
impl<T> Copy for List<'_, T> {}
impl<T> std::fmt::Debug for List<'_, T> {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        let length = self.length;
        write!(f, "List of {length}")
    }
}

impl<Desc> Clone for Size<Desc> {
    fn clone(&self) -> Self {
        *self
    }
}
impl<Desc> Copy for Size<Desc> {}
impl<Desc> std::fmt::Debug for Size<Desc> {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        self.0.fmt(f)
    }
}
impl<T> Clone for Hook<T> {
    fn clone(&self) -> Self {
        *self
    }
}
impl<T> Copy for Hook<T> {}
impl<T> std::fmt::Debug for Hook<T> {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        self.0.fmt(f)
    }
}

/// Elements to read: a slice, one field of each element of a slice, or one element for all.
#[derive(Clone, Copy, Debug)]
pub struct Batch<'a, T> {
    pub(crate) data: *const T,
    pub(crate) length: Option<usize>,
    pub(crate) stride: u32,
    borrowed: PhantomData<&'a [T]>,
}

/// Elements to write: a slice, or one field of each element of a slice.
#[derive(Debug)]
pub struct BatchMut<'a, T> {
    pub(crate) data: *mut T,
    length: usize,
    pub(crate) stride: u32,
    borrowed: PhantomData<&'a mut [T]>,
}

impl<'a, T> Batch<'a, T> {
    fn new(data: *const T, length: Option<usize>, stride: usize) -> Self {
        Batch { data, length, stride: narrow(stride), borrowed: PhantomData }
    }

    /// The same value for each element of a batch.
    pub fn one(value: &'a T) -> Self {
        Batch::new(value, None, 0)
    }

    /// Nothing, where the function allows it.
    pub fn none() -> Self {
        Batch::new(null(), None, 0)
    }

    /// A field of each element, without a copy: `Batch::field(&ships, |ship| &ship.ray)`.
    ///
    /// # Panics
    /// If the references are not to the same place within each element.
    pub fn field<S>(elements: &'a [S], field: impl Fn(&S) -> &T) -> Self {
        let base = elements.as_ptr();
        let offset = common_offset(
            elements.iter().map(|e| (e as *const S as usize, field(e) as *const T as usize)),
            size_of::<S>(),
            size_of::<T>(),
        );
        Batch::new((base as *const u8).wrapping_add(offset) as *const T, Some(elements.len()), size_of::<S>())
    }

    pub(crate) fn count(&self) -> Result<u32> {
        common_length(&[self.length])
    }
}

impl<'a, T> BatchMut<'a, T> {
    /// A field of each element; see [`Batch::field`].
    pub fn field<S>(elements: &'a mut [S], field: impl Fn(&mut S) -> &mut T) -> Self {
        let length = elements.len();
        let places = elements.iter_mut().map(|e| (e as *mut S as usize, field(e) as *mut T as usize));
        let offset = common_offset(places, size_of::<S>(), size_of::<T>());
        let data = (elements.as_mut_ptr() as *mut u8).wrapping_add(offset) as *mut T;
        BatchMut { data, length, stride: narrow(size_of::<S>()), borrowed: PhantomData }
    }

    pub(crate) fn count(&self) -> Result<u32> {
        common_length(&[Some(self.length)])
    }

    pub(crate) fn require(&self, length: u64) -> Result<()> {
        if self.length as u64 == length {
            return Ok(());
        }
        Err(Error::argument(&format!("room for {length} results is needed, not for {}", self.length)))
    }
}

fn narrow(stride: usize) -> u32 {
    u32::try_from(stride).expect("elements of less than 4 GiB")
}

/// The offset of the field in all elements. Looking at each keeps references safe that are chosen by
/// value, such as those into an enum.
fn common_offset(places: impl Iterator<Item = (usize, usize)>, size: usize, field_size: usize) -> usize {
    let mut common = None;
    for (element, field) in places {
        let offset = field.wrapping_sub(element);
        assert!(field_size <= size && offset <= size - field_size, "the field is not within its element");
        assert!(*common.get_or_insert(offset) == offset, "the field is not at the same place in each element");
    }
    common.unwrap_or(0)
}

impl<'a, T> From<&'a [T]> for Batch<'a, T> {
    fn from(elements: &'a [T]) -> Self {
        Batch::new(elements.as_ptr(), Some(elements.len()), size_of::<T>())
    }
}

impl<'a, T> From<&'a Vec<T>> for Batch<'a, T> {
    fn from(elements: &'a Vec<T>) -> Self {
        elements.as_slice().into()
    }
}

impl<'a, T, const N: usize> From<&'a [T; N]> for Batch<'a, T> {
    fn from(elements: &'a [T; N]) -> Self {
        elements.as_slice().into()
    }
}

// Points may be arrays of three numbers too, which have the same layout.
impl<'a> From<&'a [[f32; 3]]> for Batch<'a, Vec3> {
    fn from(points: &'a [[f32; 3]]) -> Self {
        Batch::new(points.as_ptr().cast(), Some(points.len()), size_of::<Vec3>())
    }
}

impl<'a> From<&'a Vec<[f32; 3]>> for Batch<'a, Vec3> {
    fn from(points: &'a Vec<[f32; 3]>) -> Self {
        points.as_slice().into()
    }
}

impl<'a, const N: usize> From<&'a [[f32; 3]; N]> for Batch<'a, Vec3> {
    fn from(points: &'a [[f32; 3]; N]) -> Self {
        points.as_slice().into()
    }
}

impl<'a, T> From<&'a mut [T]> for BatchMut<'a, T> {
    fn from(elements: &'a mut [T]) -> Self {
        BatchMut {
            data: elements.as_mut_ptr(),
            length: elements.len(),
            stride: size_of::<T>() as u32,
            borrowed: PhantomData,
        }
    }
}

impl<'a, T> From<&'a mut Vec<T>> for BatchMut<'a, T> {
    fn from(elements: &'a mut Vec<T>) -> Self {
        elements.as_mut_slice().into()
    }
}

impl<'a, T, const N: usize> From<&'a mut [T; N]> for BatchMut<'a, T> {
    fn from(elements: &'a mut [T; N]) -> Self {
        elements.as_mut_slice().into()
    }
}

/// The number of elements of a batch. What stands for all of them has no length.
pub(crate) fn common_length(lengths: &[Option<usize>]) -> Result<u32> {
    let mut known = lengths.iter().flatten();
    let length = *known.next().ok_or_else(|| Error::argument("no array says how many elements there are"))?;
    if let Some(other) = known.find(|other| **other != length) {
        return Err(Error::argument(&format!("arrays of different lengths: {length} and {other}")));
    }
    u32::try_from(length).map_err(|_| Error::argument("more elements than a call takes"))
}

/// A list for each element of a batch.
#[derive(Clone, Debug, PartialEq)]
pub struct Ragged<T> {
    /// The lists one behind another.
    pub values: Vec<T>,
    /// List i is `values[offsets[i]..offsets[i + 1]]`.
    pub offsets: Vec<u32>,
}

impl<T> std::ops::Index<usize> for Ragged<T> {
    type Output = [T];
    fn index(&self, i: usize) -> &[T] {
        &self.values[self.offsets[i] as usize..self.offsets[i + 1] as usize]
    }
}

/// Most lists are shorter; the others take a second call.
const GUESS: usize = 64;

pub(crate) fn list<T>(call: impl Fn(*mut T, u32, *mut u32) -> Status) -> Result<Vec<T>> {
    let mut values = Vec::with_capacity(GUESS);
    let mut total = 0;
    loop {
        let status = call(values.as_mut_ptr(), values.capacity() as u32, &mut total);
        check(status)?;
        if status != Status::INCOMPLETE {
            unsafe { values.set_len(total as usize) }
            return Ok(values);
        }
        values.reserve(total as usize);
    }
}

pub(crate) fn ragged<T>(count: u32, call: impl Fn(*mut T, u32, *mut u32) -> Status) -> Result<Ragged<T>> {
    let mut values = Vec::with_capacity(GUESS.max(count as usize));
    let mut offsets = vec![0; count as usize + 1];
    loop {
        let status = call(values.as_mut_ptr(), values.capacity() as u32, offsets.as_mut_ptr());
        check(status)?;
        let total = offsets[count as usize] as usize;
        if status != Status::INCOMPLETE {
            unsafe { values.set_len(total) }
            return Ok(Ragged { values, offsets });
        }
        values.reserve(total);
    }
}

impl Default for Quat {
    /// No rotation.
    fn default() -> Quat {
        Quat { x: 0.0, y: 0.0, z: 0.0, w: 1.0 }
    }
}

impl Default for Transform {
    /// The identity.
    fn default() -> Transform {
        Transform { position: Vec3::default(), rotation: Quat::default(), scale: 1.0 }
    }
}

impl Default for Mat4 {
    /// The identity.
    fn default() -> Mat4 {
        Mat4 { m: [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0] }
    }
}

impl Default for Orbit {
    /// The defaults of the loaded library.
    fn default() -> Orbit {
        initialized(|orbit| unsafe { sys::gphys_orbit_init(orbit) })
    }
}

impl From<[f32; 3]> for Vec3 {
    fn from([x, y, z]: [f32; 3]) -> Vec3 {
        Vec3 { x, y, z }
    }
}

impl From<Vec3> for [f32; 3] {
    fn from(v: Vec3) -> [f32; 3] {
        [v.x, v.y, v.z]
    }
}

impl From<[f32; 4]> for Quat {
    fn from([x, y, z, w]: [f32; 4]) -> Quat {
        Quat { x, y, z, w }
    }
}
