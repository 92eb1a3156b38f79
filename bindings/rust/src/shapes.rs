//! Shapes of any kind: what functions take as a number and a pointer.
use crate::objects::{AnyShape, Mesh, Scene};
use crate::support::{check, Batch, Result};
use crate::sys;
use crate::types::*;
use std::ffi::c_void;
use std::mem::size_of;

mod sealed {
    pub trait Sealed {}
}

/// A shape: one of the structs, or a mesh.
pub trait Shape: sealed::Sealed {
    fn shape_type(&self) -> ShapeType;
    #[doc(hidden)]
    fn pointer(&self) -> *const c_void;
}

/// A shape that is a plain struct.
pub trait PlainShape: Shape + Copy + Default + Into<AnyShape> {
    const TYPE: ShapeType;
    /// What [`transform`] makes of it: the same, but for a box along the axes.
    type Transformed: PlainShape;
}

macro_rules! plain_shape {
    ($name:ident, $number:ident, $transformed:ident) => {
        impl PlainShape for $name {
            const TYPE: ShapeType = ShapeType::$number;
            type Transformed = $transformed;
        }
        impl Shape for $name {
            fn shape_type(&self) -> ShapeType {
                ShapeType::$number
            }
            fn pointer(&self) -> *const std::ffi::c_void {
                self as *const Self as *const std::ffi::c_void
            }
        }
        impl crate::shapes::Sealed for $name {}
        impl From<$name> for AnyShape {
            fn from(shape: $name) -> AnyShape {
                AnyShape::$name(shape)
            }
        }
    };
}
pub(crate) use plain_shape;
pub(crate) use sealed::Sealed;

impl sealed::Sealed for Mesh {}
impl Shape for Mesh {
    fn shape_type(&self) -> ShapeType {
        ShapeType::MESH
    }
    fn pointer(&self) -> *const c_void {
        self.handle.as_ptr() as *const c_void
    }
}

/// An array of shapes of one kind, or one shape that stands for each of them.
#[derive(Clone, Copy, Debug)]
pub struct Shapes<'a> {
    kind: ShapeType,
    pub(crate) data: *const c_void,
    pub(crate) length: Option<usize>,
    pub(crate) stride: u32,
    borrowed: std::marker::PhantomData<&'a ()>,
}

impl<'a> Shapes<'a> {
    /// The same shape for each element of a batch.
    pub fn one(shape: &'a dyn Shape) -> Self {
        Shapes {
            kind: shape.shape_type(),
            data: shape.pointer(),
            length: None,
            stride: 0,
            borrowed: std::marker::PhantomData,
        }
    }

    pub(crate) fn shape_type(&self) -> ShapeType {
        self.kind
    }
}

impl<'a, T: PlainShape> From<Batch<'a, T>> for Shapes<'a> {
    fn from(batch: Batch<'a, T>) -> Self {
        Shapes {
            kind: T::TYPE,
            data: batch.data.cast(),
            length: batch.length,
            stride: batch.stride,
            borrowed: std::marker::PhantomData,
        }
    }
}

impl<'a, T: PlainShape> From<&'a [T]> for Shapes<'a> {
    fn from(shapes: &'a [T]) -> Self {
        Batch::from(shapes).into()
    }
}

impl<'a, T: PlainShape> From<&'a Vec<T>> for Shapes<'a> {
    fn from(shapes: &'a Vec<T>) -> Self {
        Batch::from(shapes).into()
    }
}

impl<'a, T: PlainShape, const N: usize> From<&'a [T; N]> for Shapes<'a> {
    fn from(shapes: &'a [T; N]) -> Self {
        Batch::from(shapes).into()
    }
}

/// Move a shape. Each float of the result is within 1 ulp of its largest coordinate.
pub fn transform<S: PlainShape>(shape: &S, transform: &Transform) -> Result<S::Transformed> {
    let mut moved = S::Transformed::default();
    check(unsafe {
        sys::gphys_shape_transform(S::TYPE, shape.pointer(), transform, (&mut moved as *mut S::Transformed).cast())
    })?;
    Ok(moved)
}

impl Scene {
    /// Whether the id names a model of this scene.
    pub fn has(&self, model: ModelId) -> bool {
        unsafe { sys::gphys_scene_has(self.handle.as_ptr(), model) == Status::OK }
    }

    /// A model's shape in its own coordinates; an error for a mesh, which [`Mesh::from_scene`] gives.
    pub fn get_shape(&self, model: ModelId) -> Result<AnyShape> {
        let kind = self.get_info(model)?.type_;
        AnyShape::read(kind, |out, size| {
            check(unsafe { sys::gphys_scene_get_shape(self.handle.as_ptr(), model, out, size) })
        })
    }
}

/// Read a struct of this kind.
pub(crate) fn read_plain<S: PlainShape>(read: impl FnOnce(*mut c_void, u32) -> Result<()>) -> Result<AnyShape> {
    let mut shape = S::default();
    read((&mut shape as *mut S).cast(), size_of::<S>() as u32)?;
    Ok(shape.into())
}
