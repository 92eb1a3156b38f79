// Package gamephys is a 3D scene library: shapes and meshes in a scene, rays and overlaps asked of it, a
// camera that culls and picks, and particles, ropes and cloth that move through it.
//
// Mesh, Scene, Camera and Solver have a method for each C function, named as there without prefix
// and Get. Their comments are those of the C header, which say GPHYS_OK for a nil error and name
// functions and parameters as in C.
//
// Methods that do not change an object may run in several goroutines at once; what changes it needs
// a lock of yours.
package gamephys

// #cgo CFLAGS: -Werror=implicit-function-declaration
// #include "shims.h"
import "C"

import (
	"errors"
	"fmt"
	"math"
	"unsafe"
)

// ErrClosed is what methods of an object return after Close.
var ErrClosed = errors.New("gamephys: the object is closed")

// Error is a failed call, which changed nothing: errors.Is(err, ErrInvalidArgument) tells its kind.
type Error struct {
	Status  Status
	Message string // the library's
}

func (e *Error) Error() string { return "gamephys: " + e.Message }

// Unwrap gives the kind.
func (e *Error) Unwrap() error { return e.Status }

// Error is the name of the status in C.
func (s Status) Error() string { return C.GoString(C.gphys_status_name(C.gphys_status(s))) }

// Version is the major, minor and patch version of the loaded library.
func Version() (major, minor, patch uint32) {
	number := uint32(C.gphys_version())
	return number >> 16, number >> 8 & 0xff, number & 0xff
}

func check(status C.gphys_status, message *C.char) error {
	if status >= 0 {
		return nil
	}
	if message == nil { // there was no memory for it
		return &Error{Status(status), Status(status).Error()}
	}
	defer C.free(unsafe.Pointer(message))
	return &Error{Status(status), C.GoString(message)}
}

func invalid(format string, values ...any) error {
	return &Error{ErrInvalidArgument, fmt.Sprintf(format, values...)}
}

func boolean(value bool) C.int32_t {
	if value {
		return 1
	}
	return 0
}

// --- arrays ---------------------------------------------------------------------------------

func data[T any](elements []T) unsafe.Pointer {
	if len(elements) == 0 {
		return nil
	}
	return unsafe.Pointer(&elements[0])
}

func size[T any]([]T) C.uint32_t {
	var element T
	return C.uint32_t(unsafe.Sizeof(element))
}

// step is the stride of a batch's input: one element stands for all.
func step[T any](elements []T) C.uint32_t { return stepOf(elements, uintptr(size(elements))) }

// stepOf is the same where elements have another size in C.
func stepOf[T any](elements []T, size uintptr) C.uint32_t {
	if len(elements) == 1 {
		return 0
	}
	return C.uint32_t(size)
}

// only is a slice of the one element, or of none.
func only[T any](element *T) []T {
	if element == nil {
		return nil
	}
	return unsafe.Slice(element, 1)
}

func checkLength(length int) error {
	if uint64(length) > math.MaxUint32 {
		return invalid("%d elements are more than a call takes", length)
	}
	return nil
}

// optional is the length of an array that may be left out.
func optional[T any](elements []T) int {
	if elements == nil {
		return 1
	}
	return len(elements)
}

// commonLength is the number of elements of a batch. A shared array of one element stands for all.
func commonLength(fixed []int, shared ...int) (int, error) {
	count := 1
	for _, length := range shared {
		if length != 1 {
			count = length
			break
		}
	}
	if len(fixed) > 0 {
		count = fixed[0]
	}
	for _, length := range fixed {
		if length != count {
			return 0, invalid("arrays of different lengths: %d and %d", length, count)
		}
	}
	for _, length := range shared {
		if length != 1 && length != count {
			return 0, invalid("arrays of different lengths: %d and %d", length, count)
		}
	}
	return count, checkLength(count)
}

func requireLength(length, wanted int) error {
	if length != wanted {
		return invalid("room for %d results is needed, not for %d", wanted, length)
	}
	return nil
}

// --- lists ----------------------------------------------------------------------------------

// Ragged is a list for each element of a batch.
type Ragged[T any] struct {
	Values  []T      // the lists one behind another
	Offsets []uint32 // list i is Values[Offsets[i]:Offsets[i+1]]
}

// At is the list of element i.
func (r Ragged[T]) At(i int) []T { return r.Values[r.Offsets[i]:r.Offsets[i+1]] }

// Most lists are shorter; the others take a second call.
const guess = 64

func list[T any](call func(out unsafe.Pointer, capacity C.uint32_t) (C.gphys_status, *C.char, C.uint32_t)) ([]T, error) {
	values := make([]T, guess)
	for {
		status, message, total := call(data(values), C.uint32_t(len(values)))
		if err := check(status, message); err != nil {
			return nil, err
		}
		if status != C.GPHYS_INCOMPLETE {
			return values[:total], nil
		}
		values = make([]T, total)
	}
}

func ragged[T any](count int, call func(out unsafe.Pointer, capacity C.uint32_t, offsets *C.uint32_t) (C.gphys_status, *C.char)) (Ragged[T], error) {
	values := make([]T, guess+count)
	offsets := make([]uint32, count+1)
	for {
		capacity := len(values)
		if uint64(capacity) > math.MaxUint32 {
			capacity = math.MaxUint32
		}
		status, message := call(data(values), C.uint32_t(capacity), (*C.uint32_t)(data(offsets)))
		if err := check(status, message); err != nil {
			return Ragged[T]{}, err
		}
		if status != C.GPHYS_INCOMPLETE {
			return Ragged[T]{values[:offsets[count]], offsets}, nil
		}
		values = make([]T, offsets[count])
	}
}
