package gamephys

// #include "shims.h"
import "C"

import (
	"runtime"
	"unsafe"
)

// Shape is a Sphere, Capsule, AABB, OBB, Plane, Triangle, Frustum, Ray, Segment or *Mesh.
type Shape interface {
	Shapes
	single()
}

// Shapes are shapes of one kind, such as Spheres, or one Shape, which stands for all of a batch.
type Shapes interface {
	shapes() (shapes, error)
}

// What C is given: the kind, where they are, how many, and how far apart.
type shapes struct {
	kind   C.gphys_shape_type
	data   unsafe.Pointer
	count  int
	stride C.uint32_t
}

func shapesOf(given Shapes) (shapes, error) {
	if given == nil {
		return shapes{}, invalid("no shape is given")
	}
	return given.shapes()
}

func (o *Mesh) single() {}

func (o *Mesh) shapes() (shapes, error) {
	handle, err := o.open()
	return shapes{C.GPHYS_SHAPE_MESH, handle, 1, 0}, err
}

// Vec makes a vector.
func Vec(x, y, z float32) Vec3 { return Vec3{x, y, z} }

// Place is a transform without rotation or scale.
func Place(position Vec3) Transform { return Transform{position, Quat{W: 1}, 1} }

// DefaultOrbit has the defaults of the loaded library.
func DefaultOrbit() (orbit Orbit) {
	C.gphys_orbit_init((*C.gphys_orbit)(unsafe.Pointer(&orbit)))
	return
}

// Transformed moves a shape; each float of the result is within 1 ulp of its largest coordinate. The
// result is of the same type, but an OBB for an AABB.
func Transformed(shape Shape, transform Transform) (Shape, error) {
	given, err := shapesOf(shape)
	if err != nil {
		return nil, err
	}
	kind := ShapeType(given.kind)
	if kind == ShapeAABB {
		kind = ShapeOBB
	}
	return readShape(kind, func(out unsafe.Pointer, _ uintptr) error {
		r := C.go_gphys_shape_transform(given.kind, given.data, *(*C.gphys_transform)(unsafe.Pointer(&transform)), out)
		runtime.KeepAlive(shape)
		return check(r.status, r.message)
	})
}

// Has tells whether the id names a model of this scene.
func (o *Scene) Has(model ModelID) bool {
	self, err := o.open()
	if err != nil {
		return false
	}
	r := C.go_gphys_scene_has(self, C.gphys_model_id(model))
	runtime.KeepAlive(o)
	return check(r.status, r.message) == nil
}

// Shape is a model's shape in its own coordinates; ErrUnsupported for a mesh, which NewMeshFromScene gives.
func (o *Scene) Shape(model ModelID) (Shape, error) {
	info, err := o.Info(model)
	if err != nil {
		return nil, err
	}
	return readShape(info.Type, func(out unsafe.Pointer, size uintptr) error {
		r := C.go_gphys_scene_get_shape(o.handle, C.gphys_model_id(model), out, C.uint32_t(size))
		runtime.KeepAlive(o)
		return check(r.status, r.message)
	})
}
