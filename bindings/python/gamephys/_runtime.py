"""What the generated methods stand on: objects, and arrays without copies."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, ClassVar, Iterator, TypeVar

import numpy as np
from numpy.typing import NDArray

from ._library import INCOMPLETE, check
from ._numbers import numbers_as, whole
from ._values import Desc, Value, Vector, vector_of

T = TypeVar("T")

# --- objects --------------------------------------------------------------------------------


class Handle(ctypes.c_void_p):
    """An object of the library, destroyed when nothing refers to this. A call refers to it while it runs."""

    def __init__(self, address: int, destroy: Any) -> None:
        super().__init__(address)
        self.destroy = destroy

    def __del__(self) -> None:
        self.destroy(self.value)


class Object:
    """Owns one object of the library. Freed by close(), by `with`, or when nothing refers to it."""

    _destroy: ClassVar[Any] = None
    _shape_type: ClassVar[int] = 0  # of those that are shapes
    _handle: Handle

    def _own(self, address: Any) -> None:
        self._handle = Handle(address, type(self)._destroy)

    if not TYPE_CHECKING:

        def __getattr__(self, name):
            if name == "_handle":
                raise ValueError(f"{type(self).__name__} is closed")
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")

    def close(self) -> None:
        """Free the object now, or when the calls end that other threads are in. Using it afterwards raises ValueError;
        closing again does nothing."""
        self.__dict__.pop("_handle", None)

    def __enter__(self: T) -> T:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __reduce_ex__(self, protocol: Any) -> Any:
        raise TypeError(f"{type(self).__name__} cannot be copied or pickled")

    def __repr__(self) -> str:
        name = f"gamephys.{type(self).__name__}"
        return f"<{name}{self._described()}>" if "_handle" in self.__dict__ else f"<{name}, closed>"

    def _described(self) -> str:
        if not self._shape_type:
            return ""
        return f" of {self.get_info().triangle_count} triangles"  # type: ignore[attr-defined]


class Collection(Object):
    """An object that has members with ids."""

    _list: ClassVar[tuple[str, str]]  # the function that lists them, and what they are

    def __len__(self) -> int:
        from . import _low

        total = ctypes.c_uint32()
        check(getattr(_low, self._list[0])(self._handle, None, 0, ctypes.byref(total)))
        return total.value

    def __bool__(self) -> bool:
        return True

    def _described(self) -> str:
        return f" of {len(self)} {self._list[1]}"


class Models(Collection):
    """What a scene can do besides calling one function of the library."""

    _list = ("gphys_scene_get_models", "models")

    def get_shape(self, model: int) -> Any:
        """The shape of a model in its own coordinates. That of a mesh is an Error: Mesh.from_scene gives it."""
        from . import _low

        kinds = {number: kind for kind, number in shape_types.items()}
        info = _low.ModelInfo()
        model = whole(model, "model")
        check(_low.gphys_scene_get_info(self._handle, model, ctypes.addressof(info)))
        shape = kinds.get(info.type, _low.Frustum)()
        check(_low.gphys_scene_get_shape(self._handle, model, ctypes.addressof(shape), ctypes.sizeof(shape)))
        return shape

    def __contains__(self, model: int) -> bool:
        return self.has(model)  # type: ignore[attr-defined, no-any-return]

    def __iter__(self) -> Iterator[int]:
        return iter(self.get_models().tolist())  # type: ignore[attr-defined]


class Bodies(Collection):
    """What a solver can do besides calling one function of the library."""

    _list = ("gphys_solver_get_bodies", "bodies")

    def __iter__(self) -> Iterator[int]:
        return iter(self.get_bodies().tolist())  # type: ignore[attr-defined]

    def _rest(self, body: int, first: int) -> int:
        """The number of a body's particles from the first that is asked for."""
        return max(self.get_body_info(body).particle_count - first, 0)  # type: ignore[attr-defined, no-any-return]


def handle_of(thing: Any, kind: type[Object]) -> Handle | None:
    if thing is None:
        return None
    if not isinstance(thing, kind):
        raise TypeError(f"expected {kind.__name__}, got {type(thing).__name__}")
    return thing._handle


# --- arguments ------------------------------------------------------------------------------


class Argument:
    """Memory for one call: its address, the bytes between elements, and who keeps it alive."""

    __slots__ = ("address", "stride", "length", "numbers", "array")
    array: NDArray[Any]

    def __init__(self, address: Any, stride: int = 0, length: int | None = None, numbers: int = 0, array: Any = None) -> None:
        self.address, self.stride, self.length, self.numbers, self.array = address, stride, length, numbers, array


_NONE = Argument(None)


def value_of(thing: Any, kind: Any, name: str) -> Any:
    """One struct: of its class, or anything that fills it, such as a tuple or an array's element."""
    if thing is None or isinstance(thing, kind):
        return thing
    if issubclass(kind, Vector):
        return vector_of(thing, kind, name)
    if isinstance(thing, (np.ndarray, np.void)):
        array = np.asarray(thing) if thing.dtype.names else numbers_as(np.dtype("<f4"), np.asarray(thing))
        if array.dtype.names and array.dtype != kind.dtype or array.nbytes != ctypes.sizeof(kind):
            raise ValueError(f"{name}: expected the numbers of one {kind.__name__}, got {array.dtype} of the shape {array.shape}")
        return kind.from_buffer_copy(np.ascontiguousarray(array))
    if isinstance(thing, Value) or issubclass(kind, Desc):
        raise TypeError(f"{name}: expected {kind.__name__}, got {type(thing).__name__}")
    try:
        fields = tuple(thing)
    except TypeError:
        raise TypeError(f"{name}: expected {kind.__name__}, got {type(thing).__name__}") from None
    if len(fields) != len(kind._fields_):
        raise ValueError(f"{name}: {kind.__name__} has {len(kind._fields_)} fields, got {len(fields)}")
    return kind(*fields)


def matrix_of(thing: Any, kind: Any, name: str) -> Any:
    """A matrix whose rows are given, as numpy writes them, or its 16 numbers column by column, as they lie in memory."""
    if thing is None or isinstance(thing, kind):
        return thing
    array = numbers_as(np.dtype("<f4"), np.asarray(thing))
    if array.shape not in ((4, 4), (16,)):
        raise ValueError(f"{name}: expected 4 rows of 4 numbers, or 16 numbers, got the shape {array.shape}")
    return kind.from_buffer_copy(np.ascontiguousarray(array.T))


def matrix(memory: Any) -> NDArray[np.float32]:
    """A matrix as numpy writes it: matrix @ (x, y, z, 1) transforms a point."""
    return np.frombuffer(memory, "<f4").reshape(4, 4).T


def array_of(things: Any, dtype: Any, width: int = 1, packed: bool = False) -> Argument:
    """An array of the dtype, taken as it is where it is one: any step between elements, no copy, unless the library
    takes elements only side by side (packed).
    float32 arrays whose last axis holds an element's numbers will do for structs of floats."""
    if things is None:
        return _NONE
    dtype = np.dtype(dtype)
    base, inner = dtype.subdtype or (dtype, ())
    if isinstance(things, (bytes, bytearray)):  # what a file has, such as a snapshot
        things = np.frombuffer(things, base)
    if isinstance(things, (list, tuple)) and things and isinstance(things[0], Value):
        kind = type(things[0])
        if hasattr(kind, "dtype") and kind.dtype == dtype:
            return structs_of(things, kind)
    if isinstance(things, (list, tuple)) and things and base.names and isinstance(things[0], (tuple, np.void)):
        array = np.asarray(things, base)
    else:
        array = np.asarray(things)
    if array.size == 0 and array.ndim == 1 and array.dtype.names is None:
        return Argument(None, 0, 0)
    size = base.itemsize * width * int(np.prod(inner, dtype=int))
    if array.dtype.names is None:
        # Plain numbers: rows of them.
        number = base if base.names is None else np.dtype("<f4")
        array = numbers_as(number, array)
        row = size // 4
        if row == 1 and array.ndim == 0:
            raise TypeError(f"expected an array of numbers, or a list, got {array}")
        if row > 1 and (array.ndim < 2 or array.shape[-1] != row):
            raise ValueError(f"expected rows of {row} numbers, got the shape {array.shape}")
        if row > 1 and array.ndim > 2 or row == 1 and array.ndim > 1:
            array = array.reshape(-1, row) if row > 1 else array.reshape(-1)
        if row > 1 and array.strides[-1] != 4:
            array = np.ascontiguousarray(array)
    elif array.dtype != base:
        raise ValueError(f"expected elements of {base}, got {array.dtype}")
    elif array.ndim != 1:
        array = array.reshape(-1)
    length = array.shape[0]
    stride = array.strides[0] if length > 1 else size
    address = array.__array_interface__["data"][0]
    if length > 1 and (stride < size or stride % 4 or packed and stride != size) or address % 4:
        array = array.copy()
        stride, address = array.strides[0], array.__array_interface__["data"][0]
    return Argument(address, stride, length, array.size, array)


def structs_of(things: Any, kind: Any) -> Argument:
    """A list of structs of one kind, copied."""
    for thing in things:
        if type(thing) is not kind:
            raise TypeError(f"expected {kind.__name__}, got {type(thing).__name__}")
    array = (kind * len(things))(*things)
    size = ctypes.sizeof(kind)
    # The elements keep what they point to alive.
    return Argument(ctypes.addressof(array), size, len(things), size // 4 * len(things), (array, *things) if kind._lists else array)


def descs_of(things: Any, kind: Any) -> Argument:
    """An array of descs, such as Desc.array makes; a list of them; or one that stands for all."""
    if isinstance(things, kind):
        return Argument(ctypes.addressof(things), array=things)
    if isinstance(things, (list, tuple)):
        return structs_of(things, kind)
    if things is not None and getattr(things, "dtype", None) != kind.dtype:
        raise TypeError(f"expected {kind.__name__}s, got {type(things).__name__}")
    return array_of(things, kind.dtype)


def numbers_of(things: Any, dtype: Any, count: int) -> Argument:
    """A given number of numbers, such as an origin."""
    array = np.ascontiguousarray(things, dtype)
    if array.shape != (count,):
        raise ValueError(f"expected {count} numbers, got the shape {array.shape}")
    return Argument(array.__array_interface__["data"][0], array=array)


shape_types: dict[Any, int] = {}  # of the structs


def shape_of(shape: Any) -> tuple[int, Any]:
    """(kind, pointer) of a shape."""
    kind = shape_types.get(type(shape))
    if kind is not None:
        return kind, ctypes.byref(shape)
    if isinstance(shape, Object) and shape._shape_type:
        return shape._shape_type, shape._handle
    raise TypeError(f"{type(shape).__name__} is not a shape")


def shapes_of(shapes: Any) -> tuple[int, Argument]:
    """(kind, memory) of an array of shapes of one kind, a list of them, or one that stands for all."""
    if isinstance(shapes, np.ndarray) and shapes.dtype.names:
        for kind, number in shape_types.items():
            if kind.dtype == shapes.dtype:
                return number, array_of(shapes, kind.dtype)
        raise TypeError(f"{shapes.dtype} is no shape's dtype")
    if isinstance(shapes, (list, tuple, np.ndarray)):
        if len(shapes) == 0:
            return 1, Argument(None, 0, 0)  # of any kind
        if type(shapes[0]) in shape_types:
            kind = type(shapes[0])
            return shape_types[kind], structs_of(shapes, kind)
    number, pointer = shape_of(shapes)
    return number, Argument(pointer)


def common_length(*arguments: Argument) -> int:
    """The number of elements of a batch. What stands for all of them has no length."""
    lengths = [argument.length for argument in arguments if argument.length is not None]
    if not lengths:
        raise ValueError("no array says how many there are")
    for length in lengths:
        if length != lengths[0]:
            raise ValueError(f"arrays of different lengths: {lengths[0]} and {length}")
    return lengths[0]


# --- results --------------------------------------------------------------------------------


def result_array(out: NDArray[Any] | None, length: int, dtype: Any, packed: bool = False) -> Argument:
    """Where results go: the caller's array, if given, else a new one. packed: as in array_of."""
    dtype = np.dtype(dtype)
    if out is None:
        out = np.empty(length, dtype)
    elif not isinstance(out, np.ndarray):
        raise TypeError(f"out must be a numpy array, not {type(out).__name__}")
    elif out.shape != (length, *dtype.shape) or out.dtype != dtype.base:
        raise ValueError(f"out must be {length} elements of {dtype}")
    elif not out.flags.writeable:
        raise ValueError("out is read-only")
    elif dtype.subdtype and out.strides[-1] != 4:
        raise ValueError(f"out must have contiguous rows of {dtype}")
    elif out.__array_interface__["data"][0] % 4:
        raise ValueError("out must begin at a multiple of 4 bytes")
    stride = out.strides[0] if length > 1 else dtype.itemsize
    if stride < dtype.itemsize:
        raise ValueError("out must not run backwards")
    if packed and stride != dtype.itemsize:
        raise ValueError("out must be contiguous")
    return Argument(out.__array_interface__["data"][0], stride, length, array=out)


_GUESS = 64  # elements; most lists are shorter, the others take a second call


def list_of(call: Any, arguments: tuple[Any, ...], dtype: Any) -> NDArray[Any]:
    """All results of a call that takes (..., out, capacity, out_total)."""
    total = ctypes.c_uint32()
    capacity = _GUESS
    while True:
        array = np.empty(capacity, dtype)
        status = call(*arguments, array.__array_interface__["data"][0], capacity, ctypes.byref(total))
        check(status)
        if status != INCOMPLETE:
            return array[:total.value]
        capacity = total.value


def ragged_of(call: Any, arguments: tuple[Any, ...], dtype: Any, count: int) -> tuple[NDArray[Any], NDArray[np.uint32]]:
    """All results of a call that takes (..., out, capacity, out_offsets): (results, offsets); those
    of element i are results[offsets[i]:offsets[i + 1]]."""
    offsets = np.empty(count + 1, "<u4")
    capacity = max(count, _GUESS)
    while True:
        array = np.empty(capacity, dtype)
        status = call(*arguments, array.__array_interface__["data"][0], capacity, offsets.__array_interface__["data"][0])
        check(status)
        if status != INCOMPLETE:
            return array[:offsets[-1]], offsets
        capacity = int(offsets[-1])
