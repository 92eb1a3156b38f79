"""Builds the wheel (PEP 517): the package and the shared library, which CMake makes from the tree
around this folder unless $GAMEPHYS_LIBRARY names one that is built already."""
import base64
import csv
import hashlib
import io
import os
import re
import subprocess
import sysconfig
import tempfile
import zipfile
from pathlib import Path

HERE = Path(__file__).parent
SOURCE = HERE.parent.parent
METADATA = """Metadata-Version: 2.4
Name: gamephys
Version: {version}
Summary: A 3D scene library: ray casts, overlap and nearest queries, culling, picking, ropes and cloth
Description-Content-Type: text/markdown
Keywords: physics,3d,raycast,bvh,cloth,rope
Author: The gamephys authors
License-Expression: MIT
License-File: LICENSE
Requires-Python: >=3.9
Requires-Dist: numpy>=1.21

{readme}"""


def _version():
    header = (SOURCE / "include" / "gamephys_c.h").read_text()
    return ".".join(re.findall(r"#define GPHYS_VERSION_\w+ (\d+)", header))


def _library(folder):
    built = os.environ.get("GAMEPHYS_LIBRARY")
    if built:
        return Path(built)
    options = ["-DCMAKE_BUILD_TYPE=Release", "-DGAMEPHYS_TESTS=OFF", "-DGAMEPHYS_EXAMPLES=OFF", "-DGAMEPHYS_BENCH=OFF"]
    subprocess.run(["cmake", "-S", SOURCE, "-B", folder, *options], check=True)
    jobs = str(os.cpu_count() or 1)  # without a number make starts them all
    subprocess.run(["cmake", "--build", folder, "--target", "gamephys", "--parallel", jobs, "--config", "Release"],
                   check=True)
    return next(path for name in ("libgamephys.so.1", "libgamephys.1.dylib", "gamephys.dll", "libgamephys.dll")
                for path in Path(folder).rglob(name))


def _tag(library):
    """The systems that the wheel runs on: on Linux, where the library needs nothing but glibc, all with the newest
    version of glibc that it asks for (PEP 600); else those like this one."""
    platform = re.sub(r"[-.]", "_", sysconfig.get_platform())
    versions = [int(minor) for minor in re.findall(rb"\0GLIBC_2\.(\d+)\b", library)]
    if platform.startswith("linux_") and versions and b"GLIBCXX_" not in library:
        platform = f"manylinux_2_{max(versions)}_{platform.removeprefix('linux_')}"
    return f"py3-none-{platform}"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    version = _version()
    info = f"gamephys-{version}.dist-info"
    files = {f"gamephys/{path.name}": path.read_bytes() for path in sorted((HERE / "gamephys").glob("*.py"))}
    files["gamephys/py.typed"] = (HERE / "gamephys" / "py.typed").read_bytes()
    with tempfile.TemporaryDirectory() as folder:
        library = _library(folder)
        name = {".dll": "gamephys.dll", ".dylib": "libgamephys.1.dylib"}.get(library.suffix, "libgamephys.so.1")
        files[f"gamephys/{name}"] = library.read_bytes()
    tag = _tag(files[f"gamephys/{name}"])
    readme = (HERE / "README.md").read_text(encoding="utf-8")
    files[f"{info}/METADATA"] = METADATA.format(version=version, readme=readme).encode()
    files[f"{info}/licenses/LICENSE"] = (SOURCE / "LICENSE").read_bytes()
    files[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: gamephys\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()
    record = io.StringIO()
    rows = csv.writer(record, lineterminator="\n")
    for path, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        rows.writerow([path, f"sha256={digest}", len(content)])
    rows.writerow([f"{info}/RECORD", "", ""])
    files[f"{info}/RECORD"] = record.getvalue().encode()
    wheel = f"gamephys-{version}-{tag}.whl"
    with zipfile.ZipFile(Path(wheel_directory) / wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, content in files.items():
            archive.writestr(path, content)
    return wheel
