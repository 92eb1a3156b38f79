"""Plain structs: built from whatever has numbers, and refusing fields that do not exist."""
from __future__ import annotations

import ctypes
import struct as _struct
from functools import partial
from operator import itemgetter
from typing import TYPE_CHECKING, Any, Callable, ClassVar, Generic, Iterator, Sequence, TypeVar, Union, overload

import numpy as np
from numpy.typing import NDArray

from ._library import check
from ._numbers import flag, mask, number, numbers_as, unsigned, value

V = TypeVar("V")
# What writing a struct's numbers at once raises if they are none, or not so many.
NOT_NUMBERS = (TypeError, ValueError, OverflowError, _struct.error)


class Value:
    """A plain struct: compared, copied and printed by its fields; it has no others."""

    __slots__ = ()
    dtype: ClassVar[np.dtype[Any]]
    _fields_: ClassVar[Any]
    _lists: ClassVar[dict[str, str]] = {}  # fields that are a list: their names, and those of the fields with its length

    def __iter__(self) -> Iterator[Any]:
        return (getattr(self, name) for name, *_ in self._fields_)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Value) or type(self) is not type(other):
            return False
        if self._lists:
            return list(map(_comparable, self)) == list(map(_comparable, other))
        return bytes(self) == bytes(other)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        fields = ", ".join(f"{name}={getattr(self, name)!r}" for name, *_ in self._fields_)
        return f"{type(self).__name__}({fields})"

    def __reduce__(self) -> tuple[Any, ...]:
        if any(kind is ctypes.c_void_p and name not in self._lists and getattr(self, name) for name, kind in self._fields_):
            raise TypeError(f"{type(self).__name__} with a pointer cannot be copied")
        return _rebuilt, (type(self), bytes(self), *(getattr(self, name) for name in self._lists))


def _comparable(field: Any) -> Any:
    return field.tolist() if isinstance(field, np.ndarray) else field


def _rebuilt(kind: Any, memory: bytes, *lists: Any) -> Any:
    made = kind.from_buffer_copy(memory)
    for name, numbers in zip(kind._lists, lists):
        setattr(made, name, numbers)
    return made


class Vector(Value):
    """A few float32 numbers with names, and by index. numpy takes it as an array, and its arithmetic gives arrays."""

    __slots__ = ()
    _names: ClassVar[tuple[str, ...]]

    if TYPE_CHECKING:
        def __len__(self) -> int: ...
        def __getitem__(self, at: Any) -> Any: ...

    def __iter__(self) -> Iterator[float]:
        return iter(self[:])

    def __eq__(self, other: object) -> Any:
        return NotImplemented if isinstance(other, np.ndarray) else (
            isinstance(other, (Vector, tuple, list)) and tuple(self) == tuple(other))

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{name}={number!r}' for name, number in zip(self._names, self))})"

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), tuple(self)

    def __neg__(self) -> NDArray[np.float32]:
        return -np.asarray(self, "<f4")

    def __add__(self, other: Any) -> Any:
        return np.asarray(self) + other

    def __radd__(self, other: Any) -> Any:
        return other + np.asarray(self)

    def __sub__(self, other: Any) -> Any:
        return np.asarray(self) - other

    def __rsub__(self, other: Any) -> Any:
        return other - np.asarray(self)

    def __mul__(self, other: Any) -> Any:
        return np.asarray(self) * other

    def __rmul__(self, other: Any) -> Any:
        return other * np.asarray(self)

    def __truediv__(self, other: Any) -> Any:
        return np.asarray(self) / other

    def _set(self, **numbers: Any) -> None:
        for name, given in numbers.items():
            setattr(self, name, number(given, f"{type(self).__name__}.{name}"))


VectorLike = Union[Sequence[float], NDArray[Any], Vector]
StructLike = Union[Sequence[Any], NDArray[Any], np.void]


def vector_of(given: Any, kind: Any, name: str) -> Any:
    """A vector of its class, or of anything that has so many numbers."""
    if type(given) is kind:
        return given
    try:
        numbers = tuple(given)
    except TypeError:
        raise TypeError(f"{name}: expected {kind._length_} numbers, got {type(given).__name__}") from None
    if len(numbers) != kind._length_:
        raise ValueError(f"{name} has {kind._length_} numbers, got {len(numbers)}")
    return kind(*numbers)


if TYPE_CHECKING:

    class List:
        """A list of ids in a struct: read as an array, or None, and set from anything that is a list of them."""

        @overload
        def __get__(self, owner: None, kind: Any) -> List: ...
        @overload
        def __get__(self, owner: Any, kind: Any) -> NDArray[np.uint32] | None: ...
        def __get__(self, owner: Any, kind: Any) -> Any: ...
        def __init__(self, kind: Any, name: str, length: str) -> None: ...
        def __set__(self, owner: Any, given: Sequence[int] | NDArray[Any] | None) -> None: ...

    class Field(Generic[V]):
        """A vector in a struct: read as its class, and set from anything that has so many numbers."""

        @overload
        def __get__(self, owner: None, kind: Any) -> Field[V]: ...
        @overload
        def __get__(self, owner: Any, kind: Any) -> V: ...
        def __get__(self, owner: Any, kind: Any) -> Any: ...
        def __init__(self, field: Any, check: Callable[[Any], Any]) -> None: ...
        def __set__(self, owner: Any, given: VectorLike) -> None: ...

else:

    class List(property):
        """A field that is a list of ids, which the struct keeps alive; the length goes with it."""

        def __init__(self, kind, name, length):
            pointer, count, kept = getattr(kind, name), getattr(kind, length), f"_{name}"

            def read(struct):
                return getattr(struct, kept, None) if pointer.__get__(struct) else None

            def write(struct, given):
                array = np.array([] if given is None else numbers_as(np.dtype("<u4"), np.asarray(given).reshape(-1)), "<u4")
                array.flags.writeable = False
                setattr(struct, kept, array)
                pointer.__set__(struct, array.__array_interface__["data"][0] if array.size else None)
                count.__set__(struct, array.size)

            super().__init__(read, write)
            self.offset, self.size = pointer.offset, pointer.size

    class Field(property):
        """A field of a struct that checks what it is set to; offset and size are those of ctypes."""

        def __init__(self, field, check):
            super().__init__(field.__get__, lambda struct, given: field.__set__(struct, check(given)))
            self.offset, self.size = field.offset, field.size


_MASKS = ("layers", "body_layers", "flags", "cloth_flags")
_CHECKS: dict[Any, Callable[..., Any]] = {ctypes.c_uint32: unsigned, ctypes.c_int32: flag}


def struct(kind: type[V]) -> type[V]:
    """Gives the fields of a struct, or the numbers of a vector, names that check what they are set to."""
    made: Any = kind
    if issubclass(made, Vector):
        made._names = tuple(name for name in made.__annotations__ if not name.startswith("_"))
        for at, name in enumerate(made._names):
            setattr(made, name, property(itemgetter(at), partial(_set_number, at)))
        return kind
    for name, length in made._lists.items():
        setattr(made, name, List(made, name, length))
        setattr(made, length, Field(getattr(made, length), partial(_refused, f"{made.__name__}.{length} goes with {name}")))
    for name, of, *_ in made._fields_:
        if name in made._lists or name in made._lists.values():
            continue
        check = mask if name in _MASKS else _CHECKS.get(of)
        if issubclass(of, Vector):
            check = partial(vector_of, kind=of)
        if check:
            setattr(made, name, Field(getattr(made, name), partial(check, name=f"{made.__name__}.{name}")))
    return kind


def _refused(why: str, _: Any) -> Any:
    raise AttributeError(why)


def _set_number(at: int, vector: Any, given: Any) -> None:
    vector[at] = given


class Built(Value):
    """A struct that callers build."""

    __slots__ = ()

    def _set(self, **fields: Any) -> None:
        """One by one, with errors that name the field."""
        for name, given in fields.items():
            known = isinstance(getattr(self, name), Vector)
            setattr(self, name, given if known else number(given, f"{type(self).__name__}.{name}"))


class Desc(Value):
    """Settings: the library's defaults, changed by the keywords given."""

    __slots__ = ()
    _init: ClassVar[Any]

    @classmethod
    def array(cls, count: int, **fields: Any) -> NDArray[np.void]:
        """So many of them in a numpy array, for a batch. A field is one value for all, or one for each."""
        descs: NDArray[np.void] = np.full(count, np.frombuffer(bytes(cls()), cls.dtype))
        for name, values in fields.items():
            if name in cls._lists:
                raise TypeError(f"{cls.__name__}.array: {name} is a list; give a list of {cls.__name__} instead of an array")
            if name not in (cls.dtype.names or ()):
                raise TypeError(f"{cls.__name__} has no field {name}")
            numbers = np.asarray(values)
            if name in _MASKS and numbers.dtype.kind == "i" and numbers.size:
                value(int(numbers.min()), name)
                numbers = numbers.astype("i8") & 2**32 - 1 if numbers.max() < 2**32 else numbers
            descs[name] = numbers_as(cls.dtype[name].base, numbers)
        return descs

    def _start(self) -> None:
        check(type(self)._init(ctypes.byref(self), ctypes.sizeof(self)))  # type: ignore[arg-type]
