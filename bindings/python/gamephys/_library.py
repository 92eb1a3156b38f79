"""The library, and its errors as exceptions."""
from __future__ import annotations

import ctypes
import os
import sys
from pathlib import Path
from typing import Any

_NAMES = {"win32": "gamephys.dll", "darwin": "libgamephys.1.dylib"}


def _load() -> Any:
    """The library: $GAMEPHYS_LIBRARY, else the one in this package, else the system's."""
    name = _NAMES.get(sys.platform, "libgamephys.so.1")
    packaged = Path(__file__).with_name(name)
    return ctypes.CDLL(os.environ.get("GAMEPHYS_LIBRARY") or (str(packaged) if packaged.exists() else name))


library = _load()


def needs(major: int, minor: int) -> None:
    """Refuse a library that lacks what this package calls."""
    version = library.gphys_version()
    if version >> 16 != major or version >> 8 & 255 < minor:
        raise ImportError(f"the library is gamephys {version >> 16}.{version >> 8 & 255}, this package needs {major}.{minor}")


def function(name: str, returns: Any, arguments: list[Any]) -> Any:
    prototype = getattr(library, name)
    prototype.restype = returns
    prototype.argtypes = arguments
    return prototype


class Error(Exception):
    """A call failed; the message is the library's, status its number."""

    def __init__(self, status: int, message: str) -> None:
        super().__init__(message)
        self.status = status


class InvalidArgument(Error, ValueError):
    """A value that the function does not take."""


class InvalidId(Error, LookupError):
    """No such model, body, constraint or joint, or no longer."""


class OutOfMemory(Error, MemoryError):
    """The library got no memory."""


_CLASSES = {-1: InvalidArgument, -2: InvalidId, -4: OutOfMemory}
_last_error = function("gphys_last_error", ctypes.c_char_p, [])
OK, INCOMPLETE = 0, 2


def check(status: int) -> None:
    """Raise if the status is an error; an answer without a result is none here."""
    if status < 0:
        raise _CLASSES.get(status, Error)(status, _last_error().decode())


def found(status: int) -> bool:
    if status < 0:
        check(status)
    return status == OK
