"""Python: ctypes structs, numpy dtypes, prototypes, and a method for each function."""
from ._docs import Language, outcome, paragraphs, translated, wrapped
from ._names import ANSWERS, BUILT, SHAPES, base_type, calls, camel, counted_array, creations, element, other_creations, plain

NUMBERS = {"float": "c_float", "int32_t": "c_int32", "uint32_t": "c_uint32", "size_t": "c_size_t"}
DTYPES = {"float": "<f4", "double": "<f8", "int32_t": "<i4", "uint32_t": "<u4"}
# Structs that are nothing but numbers of one meaning become the last axis of an array.
VECTORS = {"gphys_vec3": 3, "gphys_quat": 4, "gphys_mat4": 16}

HEADER = '''"""Generated from gamephys_api.json by bindings/generate.py. Not for editing."""
'''


def ctype(api, name):
    base = base_type(api, name)
    if base in NUMBERS:
        return NUMBERS[base]
    return "c_void_p" if "*" in base else camel(base)


def hint(api, name):
    base = base_type(api, name)
    return {"float": "float", "int32_t": "int", "uint32_t": "int", "size_t": "int"}.get(
        base, "int | None" if "*" in base else camel(base))


def docstring(text, indent):
    if not text:
        return ""
    lines = text.replace("\\", "\\\\").split("\n")
    return "\n".join([f'{indent}"""{lines[0]}', *(f"{indent}{line}".rstrip() for line in lines[1:])]) + '"""\n'


def dtype_entry(api, f):
    count = VECTORS.get(f["type"], 1) * f["count"]
    base = base_type(api, f["type"])
    if f["type"] in VECTORS:
        kind = '"<f4"'
    elif base in DTYPES:
        kind = f'"{DTYPES[base]}"'
    else:
        kind, count = f"{plain(f['type'])}_dtype", f["count"]
    return f'("{f["name"]}", {kind}{f", ({count},)" if count > 1 else ""})'


def low_level(api):
    out = [HEADER, "from __future__ import annotations\n",
           "from ctypes import Structure, c_char_p, c_float, c_int32, c_size_t, c_uint32, c_void_p\n",
           "from numpy import dtype\n", "from ._runtime import Built, Desc, Value, function, needs\n"]
    for enum in api["enums"]:
        for value in enum["values"]:
            out.append(f"{plain(value['name'])} = {value['value']}" + (f"  # {' '.join(value['doc'].split())}"
                                                                      if value["doc"] else ""))
        out.append("")
    for name, value in api["constants"].items():
        out.append(f"{plain(name)} = {value.rstrip('u') if value.startswith('0x') else value.rstrip('f')}")
    out.append("\nneeds(VERSION_MAJOR, VERSION_MINOR)")
    for struct in api["structs"]:
        name = struct["name"]
        if name in ("gphys_allocator", "gphys_task_runner"):
            continue
        desc = name.endswith("_desc")
        out.append(f"\n\nclass {camel(name)}({'Desc' if desc else 'Built' if name in BUILT else 'Value'}, Structure):")
        out.append(docstring(struct["doc"], "    ").rstrip("\n")) if struct["doc"] else None
        for f in struct["fields"]:
            kind = hint(api, f["type"]) if f["count"] == 1 else "object"
            comment = f"  # {' '.join(f['doc'].split())}" if f["doc"] else ""
            out.append(f"    {f['name']}: {kind}{comment}")
        fields = ", ".join('("%s", %s%s)' % (f["name"], ctype(api, f["type"]), f" * {f['count']}" if f["count"] > 1 else "")
                           for f in struct["fields"])
        out.append(f"    _fields_ = [{fields}]")
        if not any("*" in base_type(api, f["type"]) for f in struct["fields"]):
            width = VECTORS.get(name)
            entries = ", ".join(dtype_entry(api, f) for f in struct["fields"])
            out.append(f'\n\n{plain(name)}_dtype = ' + (f'dtype(("<f4", ({width},)))' if width else f"dtype([{entries}])"))
            out.append(f"{camel(name)}.dtype = {plain(name)}_dtype")
    out.append("\n")
    for f in api["functions"]:
        arguments = []
        for p in f["parameters"]:
            base = base_type(api, p["type"])
            arguments.append(NUMBERS.get(base, "c_void_p"))
        returns = {"const char *": "c_char_p", "void": "None"}.get(f["returns"], ctype(api, f["returns"]))
        out.append(f'{f["name"]} = function("{f["name"]}", {returns}, [{", ".join(arguments)}])')
    inits = [s["name"] for s in api["structs"] if s["name"].endswith("_desc")]
    for name in inits:
        out.append(f"{camel(name)}._init = {name}_init")
    shapes = ", ".join(f"{camel(s)}: SHAPE_{s.upper()}" for s in SHAPES if s != "mesh")
    out.append(f"\nshape_types = {{{shapes}}}")
    return "\n".join(line for line in out if line is not None) + "\n"


def default(p):
    if p["name"] == "layers":
        return "low.ALL_LAYERS"
    if p["name"] == "max_distance":
        return 'float("inf")'
    if p["name"] in ("desc", "descs", "filter", "filters", "transform", "transforms", "local_point"):
        return "None"
    return "0" if p["name"] in ("tolerance", "link_length", "compliance", "first") else None


def input_hint(api, p):
    if p["role"] == "shape":
        return "Shape"
    if p["role"] == "array" and element(p).endswith("_desc"):
        return f"np.ndarray | Sequence[low.{camel(element(p))}] | low.{camel(element(p))} | None"
    if p["role"] == "array":
        return "ArrayLike | None" if p["name"] == "transforms" else "ArrayLike"
    if p["role"] == "handle":
        return f"{camel(element(p))} | None"
    if p["role"] == "in" and p.get("count"):
        return "ArrayLike"
    if p["role"] == "in":
        kind = camel(element(p))
        return f"low.{kind} | None" if kind.endswith("Desc") or default(p) else f"low.{kind} | Sequence"
    return hint(api, p["type"])


def output_hint(api, p):
    if p["role"] == "ragged":
        return "tuple[np.ndarray, np.ndarray]"
    if p["role"] in ("list", "out_array") or p.get("count"):
        return "np.ndarray"
    of = element(p)
    if of == "int32_t":
        return "bool"
    return hint(api, of) if base_type(api, of) in NUMBERS else f"low.{camel(of)}"


def numpy_type(api, of):
    base = base_type(api, of)
    return f'"{DTYPES[base]}"' if base in DTYPES else f"low.{plain(of)}_dtype"


def signature(api, call, first):
    words = [first] if first else []
    optional = True
    for p in reversed(call.inputs):
        optional = optional and default(p) is not None
        p["default"] = default(p) if optional else None
    for p in call.inputs:
        words.append(f"{p['name']}: {input_hint(api, p)}" + (f" = {p['default']}" if p["default"] else ""))
    if any(p["role"] == "out_array" for p in call.outputs):
        words += ["*", "out: np.ndarray | None = None"]
    return ", ".join(words)


def body(api, call, self_handle):
    """The statements of a method, and the arguments of the C call."""
    f, lines, arguments = call.function, [], []
    parameters = f["parameters"]
    length = None
    for i, p in enumerate(parameters):
        name, role = p["name"], p["role"]
        if role == "handle":
            arguments.append("self._handle" if i == 0 and call.owner else f"handle_of({name}, {camel(element(p))})")
        elif role == "shape_type":
            arguments.append(f"{name}_")
        elif role == "shape":
            lines.append(f"{parameters[i - 1]['name']}_, {name}_ = shape_of({name})")
            arguments.append(f"{name}_.address")
        elif role == "in" and p.get("count"):
            lines.append(f"{name}_ = numbers_of({name}, {numpy_type(api, element(p))}, {p['count']})")
            arguments.append(f"{name}_.address")
        elif role == "in":
            lines.append(f"{name}_ = value_of({name}, low.{camel(element(p))})")
            arguments.append(f"{name}_.address")
        elif role == "array":
            if element(p) == "void":
                lines.append(f"{parameters[i - 1]['name']}_, {name}_ = shapes_of({name})")
            elif element(p).endswith("_desc"):
                lines.append(f"{name}_ = descs_of({name}, low.{camel(element(p))})")
            else:
                width = f", {p['width']}" if "width" in p else ""
                lines.append(f"{name}_ = array_of({name}, {numpy_type(api, element(p))}{width})")
            arguments.append(f"{name}_.address")
        elif role == "one":
            arguments.append("0")
        elif role == "stride" and name == "out_stride":
            arguments.append("out_.stride")
        elif role == "stride":
            arguments.append(f"{parameters[i - 1]['name']}_.stride")
        elif role == "count":
            arrays = [q for q in parameters if q["role"] == "array"]
            if not arrays:
                length = name
                arguments.append(name)
            elif name == "count":
                length = "count"
                lines.append(("count = common_length", arrays))
                arguments.append("count")
            else:
                arguments.append(f"{counted_array(parameters, i)['name']}_.numbers" if name == "index_count" else
                                 f"{counted_array(parameters, i)['name']}_.length")
        elif role == "out_array":
            size = p.get("length", length)
            lines.append(("result", size, p))
            arguments.append("out_.address")
        elif role == "out":
            of = element(p)
            kind = f"low.{camel(of)}" if base_type(api, of) not in NUMBERS else f"ctypes.{NUMBERS[base_type(api, of)]}"
            lines.append(f"{name} = {kind}()" if not p.get("count") else
                         f"{name} = np.empty({p['count']}, {numpy_type(api, of)})")
            arguments.append(f"ctypes.byref({name})" if not p.get("count") else f"{name}.ctypes.data")
        elif role in ("capacity", "total", "offsets", "list", "ragged"):
            continue
        else:
            arguments.append(name)
    # The length is known when all arrays are, and room for results is made when the length is.
    arrays = [line for line in lines if isinstance(line, str)]
    lengths = [f"{what[0]}({', '.join(p['name'] + '_' for p in what[1])})" for what in lines if len(what) == 2]
    results = [f"out_ = result_array(out, {size}, {numpy_type(api, element(p))})"
               for kind, size, p in (what for what in lines if what[0] == "result")]
    return arrays + lengths + results, arguments


def result_of(api, p):
    of = element(p)
    if p["role"] == "out_array":
        return "out_.array"
    if p.get("count"):
        return p["name"]
    if of == "int32_t":
        return f"bool({p['name']}.value)"
    return f"{p['name']}.value" if base_type(api, of) in NUMBERS else p["name"]


def method(api, call, indent, first):
    f = call.function
    results = [output_hint(api, p) for p in call.outputs]
    returns = "None" if not results else results[0] if len(results) == 1 else f"tuple[{', '.join(results)}]"
    may_miss = f["may_miss"]
    if may_miss:
        returns += " | None"
    inner = indent + "    "
    text = f"{indent}def {call.name}({signature(api, call, first)}) -> {returns}:\n{docstring(f['doc'], inner)}"
    lines, arguments = body(api, call, first)
    text += "".join(f"{inner}{line}\n" for line in lines)
    target = f"low.{f['name']}"
    listed = [p for p in call.outputs if p["role"] in ("list", "ragged")]
    if listed:
        kind = numpy_type(api, element(listed[0]))
        offsets = ", count" if listed[0]["role"] == "ragged" else ""
        helper = "ragged_of" if offsets else "list_of"
        return text + f"{inner}return {helper}({target}, ({', '.join(arguments)},), {kind}{offsets})\n"
    invoke = f"{target}({', '.join(arguments)})"
    if f["name"] in ANSWERS:
        return text.replace("-> None:", "-> bool:") + (f"{inner}status = {invoke}\n"
                f"{inner}return status != low.{plain(ANSWERS[f['name']])} and found(status)\n")
    if not call.outputs:
        return text + f"{inner}check({invoke})\n"
    result = ", ".join(result_of(api, p) for p in call.outputs)
    if may_miss:
        return text + f"{inner}return {result if len(call.outputs) == 1 else f'({result})'} if found({invoke}) else None\n"
    return text + f"{inner}check({invoke})\n{inner}return {result}\n"


def objects(api):
    out = [HEADER + '''from __future__ import annotations

import ctypes
from typing import Sequence, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _low as low
from ._runtime import (Models, Object, array_of, check, common_length, descs_of, found, handle_of, list_of,
                       numbers_of, ragged_of, result_array, shape_of, shapes_of, value_of)
''']
    made = creations(api)
    methods = list(calls(api))
    for handle in api["handles"]:
        creation = made[handle]
        out.append(f"\n\nclass {camel(handle)}({'Models' if handle == 'gphys_scene' else 'Object'}):")
        doc = docstring(creation.function["doc"], "    ").rstrip("\n")
        out.append(doc) if doc else None
        out.append(f"    _destroy = low.{handle}_destroy\n")
        lines, arguments = body(api, creation, None)
        out.append(f"    def __init__({signature(api, creation, 'self')}):")
        out += [f"        {line}" for line in lines]
        arguments = ["ctypes.byref(handle)" if a == creation.function["parameters"][-1]["name"] else a for a in arguments]
        out.append("        handle = ctypes.c_void_p()")
        out.append(f"        check(low.{creation.function['name']}({', '.join(arguments)}))")
        out.append("        self._own(handle.value)\n")
        for c in other_creations(api, handle):
            lines, arguments = body(api, c, None)
            arguments = ["ctypes.byref(handle)" if a == c.function["parameters"][-1]["name"] else a for a in arguments]
            lines += ["handle = ctypes.c_void_p()", f"check(low.{c.function['name']}({', '.join(arguments)}))",
                      f"made = cls.__new__(cls)", "made._own(handle.value)", "return made"]
            out.append(f"    @classmethod\n    def {c.name}({signature(api, c, 'cls')}) -> {camel(handle)}:\n" +
                       docstring(c.function["doc"], "        ") + "".join(f"        {line}\n" for line in lines))
        out += [method(api, call, "    ", "self") for call in methods if call.owner == handle]
    out.append("\nShape = Union[%s]\n" % ", ".join(
        "Mesh" if s == "mesh" else f"low.{camel(s)}" for s in SHAPES))
    out += ["\n" + method(api, call, "", "") for call in methods if not call.owner]
    return "\n".join(line for line in out if line is not None)


LANGUAGE = Language(null="None", function=lambda owner, call: f"{owner or 'gamephys'}.{call.name}", type=camel, constant=plain,
                    parameter=lambda name: name.removeprefix("out_"), flags=("False", "True"))
# Statuses that are exceptions of their own; the others are an Error with that status.
EXCEPTIONS = {"ERROR_INVALID_ARGUMENT": "InvalidArgument", "ERROR_INVALID_ID": "InvalidId", "ERROR_OUT_OF_MEMORY": "OutOfMemory"}


def layout(doc, creates):
    lines = paragraphs(doc, 96) + wrapped(f"Cost: {doc.cost}", 96)
    sections = {"Args": [f"{names}: {text}" for names, text in doc.parameters],
                "Returns": [text] if (text := outcome(doc, "None")) else [],
                "Raises": [f"{EXCEPTIONS.get(status, f'Error, status {status}')}: {when}" for status, when in doc.errors]}
    for title, entries in sections.items():
        if entries:
            lines += ["", f"{title}:"]
            for entry in entries:
                lines += wrapped(entry, 96, "    ", "        ")
    return "\n".join(lines)


def generate(api):
    api = translated(api, LANGUAGE, layout)
    return {"python/gamephys/_low.py": low_level(api), "python/gamephys/_objects.py": objects(api)}
