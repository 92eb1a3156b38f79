"""What the generated modules stand on: the library, errors, objects, and arrays without copies."""
from __future__ import annotations

import ctypes
import ctypes.util
import os
import sys
import weakref
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

_NAMES = {"win32": "gamephys.dll", "darwin": "libgamephys.1.dylib"}


def _load():
    """The library: $GAMEPHYS_LIBRARY, else the one in this package, else the system's."""
    name = _NAMES.get(sys.platform, "libgamephys.so.1")
    packaged = Path(__file__).with_name(name)
    return ctypes.CDLL(os.environ.get("GAMEPHYS_LIBRARY") or (str(packaged) if packaged.exists() else name))


library = _load()


def needs(major, minor):
    """Refuse a library that lacks what this package calls."""
    version = library.gphys_version()
    if version >> 16 != major or version >> 8 & 255 < minor:
        raise ImportError(f"the library is gamephys {version >> 16}.{version >> 8 & 255}, this package needs {major}.{minor}")


def function(name, returns, arguments):
    prototype = getattr(library, name)
    prototype.restype = returns
    prototype.argtypes = arguments
    return prototype


# --- errors ---------------------------------------------------------------------------------


class Error(Exception):
    """A call failed; the message is the library's, status its number."""

    def __init__(self, status: int, message: str):
        super().__init__(message)
        self.status = status


class InvalidArgument(Error, ValueError):
    pass


class InvalidId(Error, LookupError):
    pass


class OutOfMemory(Error, MemoryError):
    pass


_CLASSES = {-1: InvalidArgument, -2: InvalidId, -4: OutOfMemory}
_last_error = function("gphys_last_error", ctypes.c_char_p, [])
_OK, _NO_HIT, _INCOMPLETE, _UNBOUNDED = 0, 1, 2, 3


def check(status):
    """Raise if the status is an error; an answer without a result is none here."""
    if status < 0:
        raise _CLASSES.get(status, Error)(status, _last_error().decode())


def found(status):
    if status < 0:
        check(status)
    return status == _OK


# --- values and objects ---------------------------------------------------------------------


class Value:
    """A plain struct: built from numbers and tuples, compared and printed by its fields."""

    dtype: ClassVar[np.dtype]
    _fields_: ClassVar[Any]

    def __iter__(self):
        return (getattr(self, name) for name, *_ in self._fields_)

    def __eq__(self, other):
        return type(self) is type(other) and bytes(self) == bytes(other)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self):
        fields = ", ".join(f"{name}={getattr(self, name)!r}" for name, *_ in self._fields_)
        return f"{type(self).__name__}({fields})"


class Built(Value):
    """A struct that callers build: from all its fields, by name from some, or of zeros."""

    def __init__(self, *fields, **named):
        if fields:
            lengths = [len(getattr(kind, "_fields_", ())) for _, kind, *_ in self._fields_]
            if len(fields) != len(lengths):
                raise ValueError(f"{type(self).__name__} has {len(lengths)} fields, got {len(fields)}")
            for (name, *_), length, field in zip(self._fields_, lengths, fields):
                if isinstance(field, tuple) and len(field) != length:
                    raise ValueError(f"{type(self).__name__}.{name} has {length} numbers, got {len(field)}")
        super().__init__(*fields, **named)


class Desc(Value):
    """Settings: the library's defaults, changed by the keywords given."""

    _init: ClassVar[Any]

    @classmethod
    def array(cls, count: int, **fields: Any) -> np.ndarray:
        """So many of them in a numpy array, for a batch. A field is one value for all, or one for each."""
        descs = np.full(count, np.frombuffer(bytes(cls()), cls.dtype))
        for name, values in fields.items():
            if name not in (cls.dtype.names or ()):
                raise TypeError(f"{cls.__name__} has no field {name}")
            descs[name] = numbers_as(cls.dtype[name].base, np.asarray(values))
        return descs

    def __init__(self, **fields):
        check(type(self)._init(ctypes.addressof(self), ctypes.sizeof(self)))
        for name, value in fields.items():
            if not any(name == field[0] for field in self._fields_):
                raise TypeError(f"{type(self).__name__} has no field {name}")
            setattr(self, name, value)


class Object:
    """Owns one object of the library. Freed by close(), by `with`, or when nothing refers to it."""

    _destroy: ClassVar[Any] = None
    _finalizer: weakref.finalize | None = None

    def _own(self, handle):
        self._open_handle = handle
        self._finalizer = weakref.finalize(self, type(self)._destroy, handle)

    @property
    def _handle(self):
        if self._finalizer is None or not self._finalizer.alive:
            raise ValueError(f"{type(self).__name__} is closed")
        return self._open_handle

    def close(self):
        """Free the object now. Using it afterwards raises ValueError; closing again does nothing."""
        if self._finalizer is not None:
            self._finalizer()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()


class Models(Object):
    """What a scene can do besides calling one function of the library."""

    def get_shape(self, model: int) -> Any:
        """The shape of a model in its own coordinates. Those of meshes are not known: Error."""
        from . import _low

        kinds = {number: kind for kind, number in _low.shape_types.items()}
        info = _low.ModelInfo()
        check(_low.gphys_scene_get_info(self._handle, model, ctypes.addressof(info)))
        shape = kinds.get(info.type, _low.Frustum)()
        check(_low.gphys_scene_get_shape(self._handle, model, ctypes.addressof(shape), ctypes.sizeof(shape)))
        return shape

    def __contains__(self, model: int) -> bool:
        return self.has(model)  # type: ignore[attr-defined]


def handle_of(thing, kind):
    if thing is None:
        return None
    if not isinstance(thing, kind):
        raise TypeError(f"expected {kind.__name__}, got {type(thing).__name__}")
    return thing._handle


# --- arguments ------------------------------------------------------------------------------


class Argument:
    """Memory for one call: its address, the bytes between elements, and who keeps it alive."""

    __slots__ = ("address", "stride", "length", "numbers", "array")

    def __init__(self, address, stride=0, length=None, numbers=0, array=None):
        self.address, self.stride, self.length, self.numbers, self.array = address, stride, length, numbers, array


_NONE = Argument(None)


def value_of(thing, kind):
    """One struct: of its class, or anything that fills it, such as a tuple or an array's element."""
    if thing is None:
        return _NONE
    if not isinstance(thing, kind):
        if isinstance(thing, (np.ndarray, np.void)):
            thing = kind.from_buffer_copy(np.ascontiguousarray(thing, kind.dtype if thing.dtype.names else "<f4"))
        elif isinstance(thing, Value) or issubclass(kind, Desc):
            raise TypeError(f"expected {kind.__name__}, got {type(thing).__name__}")
        elif kind.__name__ == "Mat4":
            thing = kind(tuple(thing))
        else:
            thing = kind(*thing)
    return Argument(ctypes.addressof(thing), array=thing)


def array_of(things, dtype, width=1):
    """An array of the dtype, taken as it is where it is one: any step between elements, no copy.
    float32 arrays whose last axis holds an element's numbers will do for structs of floats."""
    if things is None:
        return _NONE
    dtype = np.dtype(dtype)
    base, inner = dtype.subdtype or (dtype, ())
    if isinstance(things, (list, tuple)) and things and isinstance(things[0], Value):
        kind = type(things[0])
        if hasattr(kind, "dtype") and kind.dtype == dtype:
            return structs_of(things, kind)
    if isinstance(things, (list, tuple)) and things and base.names and isinstance(things[0], (tuple, np.void)):
        array = np.asarray(things, base)
    else:
        array = np.asarray(things)
    size = base.itemsize * width * int(np.prod(inner, dtype=int))
    if array.dtype.names is None:
        # Plain numbers: rows of them.
        number = base if base.names is None else np.dtype("<f4")
        array = numbers_as(number, array)
        row = size // 4
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
    if length > 1 and (stride < size or stride % 4):
        array = np.ascontiguousarray(array)
        stride = array.strides[0]
    return Argument(array.__array_interface__["data"][0], stride, length, array.size, array)


def structs_of(things, kind):
    """A list of structs of one kind, copied."""
    for thing in things:
        if type(thing) is not kind:
            raise TypeError(f"expected {kind.__name__}, got {type(thing).__name__}")
    array = (kind * len(things))(*things)
    size = ctypes.sizeof(kind)
    return Argument(ctypes.addressof(array), size, len(things), size // 4 * len(things), array)


def descs_of(things, kind):
    """An array of descs, such as Desc.array makes; a list of them; or one that stands for all."""
    if isinstance(things, kind):
        return Argument(ctypes.addressof(things), array=things)
    if isinstance(things, (list, tuple)):
        return structs_of(things, kind)
    if things is not None and getattr(things, "dtype", None) != kind.dtype:
        raise TypeError(f"expected {kind.__name__}s, got {type(things).__name__}")
    return array_of(things, kind.dtype)


def numbers_as(number, array):
    """Floats of the library's width; whole numbers only from such, and in range."""
    if array.dtype == number or array.size == 0:
        return array.astype(number, copy=False)
    whole = number.kind in "iu"
    if array.dtype.kind not in ("iu" if whole else "iuf"):
        raise TypeError(f"expected {'whole numbers' if whole else 'numbers'}, got {array.dtype}")
    if whole and not np.iinfo(number).min <= array.min() <= array.max() <= np.iinfo(number).max:
        raise ValueError(f"a number is out of the range of {number}")
    return array.astype(number)


def numbers_of(things, dtype, count):
    """A given number of numbers, such as an origin."""
    array = np.ascontiguousarray(things, dtype)
    if array.shape != (count,):
        raise ValueError(f"expected {count} numbers, got the shape {array.shape}")
    return Argument(array.__array_interface__["data"][0], array=array)


def shape_of(shape):
    """(kind, memory) of a shape."""
    from . import _low, _objects

    if isinstance(shape, _objects.Mesh):
        return _low.SHAPE_MESH, Argument(shape._handle)
    kind = _low.shape_types.get(type(shape))
    if kind is None:
        raise TypeError(f"{type(shape).__name__} is not a shape")
    return kind, Argument(ctypes.addressof(shape), array=shape)


def shapes_of(shapes):
    """(kind, memory) of an array of shapes of one kind, a list of them, or one that stands for all."""
    from . import _low

    if isinstance(shapes, np.ndarray):
        for kind, number in _low.shape_types.items():
            if kind.dtype == shapes.dtype:
                return number, array_of(shapes, kind.dtype)
        raise TypeError(f"{shapes.dtype} is no shape's dtype")
    if isinstance(shapes, (list, tuple)) and shapes and type(shapes[0]) in _low.shape_types:
        kind = type(shapes[0])
        return _low.shape_types[kind], structs_of(shapes, kind)
    return shape_of(shapes)


def common_length(*arguments):
    """The number of elements of a batch. What stands for all of them has no length."""
    lengths = {argument.length for argument in arguments if argument.length is not None}
    if len(lengths) != 1:
        raise ValueError("arrays of different lengths" if lengths else "no array says how many there are")
    return lengths.pop()


# --- results --------------------------------------------------------------------------------


def result_array(out, length, dtype):
    """Where results go: the caller's array, if given, else a new one."""
    dtype = np.dtype(dtype)
    if out is None:
        out = np.empty(length, dtype)
    elif not isinstance(out, np.ndarray):
        raise TypeError(f"out must be a numpy array, not {type(out).__name__}")
    elif out.shape[:1] != (length,) or (out.dtype != (dtype.base if dtype.subdtype else dtype)):
        raise ValueError(f"out must be {length} elements of {dtype}")
    elif not out.flags.writeable:
        raise ValueError("out is read-only")
    elif dtype.subdtype and (out.shape[1:] != dtype.shape or out.strides[-1] != 4):
        raise ValueError(f"out must have contiguous rows of {dtype}")
    stride = out.strides[0] if length > 1 else dtype.itemsize
    if stride < dtype.itemsize:
        raise ValueError("out must not run backwards")
    return Argument(out.__array_interface__["data"][0], stride, length, array=out)


_GUESS = 64  # elements; most lists are shorter, the others take a second call


def list_of(call, arguments, dtype):
    """All results of a call that takes (..., out, capacity, out_total)."""
    total = ctypes.c_uint32()
    capacity = _GUESS
    while True:
        array = np.empty(capacity, dtype)
        status = call(*arguments, array.__array_interface__["data"][0], capacity, ctypes.byref(total))
        check(status)
        if status != _INCOMPLETE:
            return array[:total.value]
        capacity = total.value


def ragged_of(call, arguments, dtype, count):
    """All results of a call that takes (..., out, capacity, out_offsets): (results, offsets); those
    of element i are results[offsets[i]:offsets[i + 1]]."""
    offsets = np.empty(count + 1, "<u4")
    capacity = max(count, _GUESS)
    while True:
        array = np.empty(capacity, dtype)
        status = call(*arguments, array.__array_interface__["data"][0], capacity, offsets.__array_interface__["data"][0])
        check(status)
        if status != _INCOMPLETE:
            return array[:offsets[-1]], offsets
        capacity = int(offsets[-1])
