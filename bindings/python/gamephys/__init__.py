"""A 3D scene library: shapes and meshes, rays and overlaps, a camera that culls and picks, cloth.

Objects (Mesh, Scene, Camera, Solver) own memory of the library: close() frees it at once. Single
values are small structs (Ray, Hit, Sphere, ...); tuples do in their place where the kind is known.
Batches take and return numpy arrays, without copies, of the dtypes ray_dtype, hit_dtype, ...; rows
of float32 do for rays, points and vertices. A query that finds nothing returns None. Calls release
the interpreter's lock: queries may run in several threads at once, changes need the caller's lock.
"""
import ctypes as _ctypes
from typing import Any as _Any

import numpy as _np
from numpy.typing import ArrayLike as _ArrayLike, NDArray as _NDArray

from . import _low
from ._library import Error, InvalidArgument, InvalidId, OutOfMemory, check as _check
from ._low import *  # noqa: F401,F403
from ._objects import *  # noqa: F401,F403
from ._objects import Camera, Mesh, Scene, Solver
from ._runtime import shape_of as _shape_of, value_of as _value_of

_version = _low.gphys_version()
__version__ = f"{_version >> 16}.{_version >> 8 & 255}.{_version & 255}"


def status_name(status: int) -> str:
    """Name of a status, such as "GPHYS_NO_HIT"."""
    return str(_low.gphys_status_name(status).decode())


def default_orbit() -> _low.Orbit:
    """The orbit settings that the library starts from."""
    orbit = _low.Orbit()
    _check(_low.gphys_orbit_init(_ctypes.byref(orbit)))
    return orbit


def rays(count: int, origin: _ArrayLike = (0, 0, 0), direction: _ArrayLike = (0, 0, 0),
         t_max: _ArrayLike = float("inf")) -> _NDArray[_np.void]:
    """So many rays in an array, for a batch. A field is one value for all, or one for each; without t_max they have no
    end, whereas those of numpy.zeros end where they begin."""
    made: _NDArray[_np.void] = _np.zeros(count, _low.ray_dtype)
    made["origin"], made["direction"], made["t_max"] = origin, direction, t_max
    return made


def transform(shape: _Any, by: _Any) -> _Any:
    """The shape moved by a Transform; an Aabb becomes an Obb."""
    kind, memory = _shape_of(shape)
    result: _Any = _low.Obb if kind in (_low.SHAPE_AABB, _low.SHAPE_MESH) else type(shape)
    moved = result()
    _check(_low.gphys_shape_transform(kind, memory, _value_of(by, _low.Transform, "by"), _ctypes.byref(moved)))
    return moved
