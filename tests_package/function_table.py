#!/usr/bin/env python3
"""The table of all functions: what fuzzes, tests, measures and binds each. function_table.py SOURCE [--write]

Prints docs/functions.md, or writes it. Fails if a function has no fuzz target, no C test or no binding of a language,
or if one of those that programs call all the time has no benchmark. A benchmark is a row of the report or of the
solver's figures: it may measure the code below the interface.
"""

import re
import subprocess
import sys
from pathlib import Path

source = Path(sys.argv[1])
sys.dont_write_bytecode = True
sys.path.insert(0, str(source / "bench"))
from cases import SOLVER, words as words_of_case

fuzz_sources = {
    "shapes": ["shapes.cpp", "shape_relations.cpp"],
    "mesh": ["mesh.cpp", "mesh_source.h", "shape_relations.cpp"],
    "world": ["world.cpp", "world_scene.cpp", "world_scene_snapshot.cpp", "world_queries.cpp", "world_filter.cpp", "world_camera.cpp", "world_solver.cpp",
              "mesh_source.h"],
    "snapshot": ["snapshot.cpp", "mesh_source.h"],
    "soak": ["soak.cpp"],
}

# What is called each frame or for each ray. Where a benchmark names no function, its case.
hot = {
    "gphys_scene_raycast": "scene_ray_random",
    "gphys_scene_raycast_batch": "scene_ray_rows",
    "gphys_scene_raycast_any": "scene_ray_any",
    "gphys_scene_raycast_any_batch": "scene_ray_any",
    "gphys_scene_overlap": "overlap_sphere",
    "gphys_scene_overlap_batch": "overlap_box",
    "gphys_scene_cull": "cull",
    "gphys_camera_cull": "cull",
    "gphys_scene_set_transform": "update_some",
    "gphys_scene_set_transforms": "update_all",
    "gphys_scene_add": "replace_some",
    "gphys_scene_add_batch": "build_scene",
    "gphys_scene_remove": "replace_some",
    "gphys_scene_remove_batch": "replace_some",
    "gphys_mesh_create": "build_mesh",
    "gphys_shape_raycast": "mesh_ray_random",
    "gphys_shape_raycast_batch": "mesh_ray_rows",
    "gphys_solver_step": "free_100k_all",
}

languages = {
    "C++": "cpp/gamephys", "C#": "csharp/src", "Go": "go", "Java": "java/src", "JavaScript": "javascript/lib",
    "Lua": "lua/gamephys", "Python": "python/gamephys", "Ruby": "ruby/lib", "Rust": "rust/src",
}
# The C++ header includes the C header: these two need no other form there.
left_out = {("C++", "gphys_version"), ("C++", "gphys_status_name")}


def words(paths):
    found = set()
    for path in paths:
        found |= set(re.findall(r"\bgphys_\w+", path.read_text(errors="replace")))
    return found


def files(folder, *patterns):
    return [path for pattern in patterns for path in sorted((source / folder).rglob(pattern))
            if path.is_file() and not {"node_modules", "target", "build"} & set(path.parts)]


functions = subprocess.run(["bash", source / "tests_package/functions.sh"], env={"SOURCE": source, "PATH": "/usr/bin:/bin"},
                           capture_output=True, text=True, check=True).stdout.split()
fuzzed = {target: words(source / "fuzz" / name for name in [*names, "check.cpp"]) for target, names in fuzz_sources.items()}
c_tests = {path.stem: words([path]) for path in files("tests_c", "test_*.c")}
cpp_tests = words(files("tests_cpp", "*.cpp", "*.h"))
figures = "\n".join(path.read_text() for path in files("docs", "report.md", "solver_figures.md"))
bound = {language: words(files(f"bindings/{folder}", "*")) if (source / "bindings" / folder).is_dir() else set()
         for language, folder in languages.items()}

holes = []
lines = ["# Coverage of each function", "",
         "Written by `tests_package/function_table.py`, which fails if a function has no fuzz target, no C test or no",
         "binding of a language, or if a frequently called function has no benchmark.", "",
         "| function | fuzz targets | C tests | C++ tests | benchmark | bindings |", "|---|---|---|---|---|---|"]
for function in functions:
    targets = [target for target, names in fuzzed.items() if function in names]
    tests = [name.removeprefix("test_") for name, names in c_tests.items() if function in names]
    case = hot.get(function, "")
    work = SOLVER.get(case) or words_of_case(case) if case else ""
    missing = [language for language, names in bound.items() if function not in names and (language, function) not in left_out]
    if not set(targets) - {"soak"}:
        holes.append(f"{function}: no fuzz target calls it")
    if not tests:
        holes.append(f"{function}: no C test calls it")
    holes += [f"{function}: not bound in {language}" for language in missing]
    if case and work not in figures:
        holes.append(f"{function}: the figures have no row '{work}'")
    lines.append(f"| `{function}` | {', '.join(targets)} | {', '.join(tests)} | {'yes' if function in cpp_tests else ''} | "
                 f"{work} | {len(languages) - len(missing)} of {len(languages)} |")
holes += [f"{function}: said to be called all the time, but no function" for function in hot if function not in functions]
table = "\n".join(lines) + "\n"
if holes:
    print("\n".join(holes), file=sys.stderr)
elif "--write" in sys.argv[2:]:
    (source / "docs/functions.md").write_text(table)
else:
    print(table, end="")
sys.exit(bool(holes))
