"""Python: ctypes structs, numpy dtypes, prototypes, and a method for each function."""
from ._docs import Language, outcome, paragraphs, translated, wrapped
from ._names import (ANSWERS, BUILT, MASKS, OF_THE_DESC, SHAPES, base_type, calls, camel, counted_array, creations, element,
                     has_stride, lists, other_creations, plain, settable)

NUMBERS = {"float": "c_float", "int32_t": "c_int32", "uint32_t": "c_uint32", "size_t": "c_size_t"}
DTYPES = {"float": "<f4", "double": "<f8", "int32_t": "<i4", "uint32_t": "<u4"}
SCALARS = {"float": "np.float32", "double": "np.float64", "int32_t": "np.int32", "uint32_t": "np.uint32"}
# Structs that are nothing but numbers of one meaning become the last axis of an array.
VECTORS = {"gphys_vec3": 3, "gphys_quat": 4, "gphys_mat4": 16}
# What a field is that its struct is built without; the others are 0.
IDENTITY = "(0, 0, 0, 1)"
UNSAID = {("ray", "t_max"): 'float("inf")', ("quat", "w"): "1", ("transform", "rotation"): IDENTITY,
          ("transform", "scale"): "1", ("obb", "rotation"): IDENTITY}
# The shapes that functions take, where they do not take all.
MODELS = [s for s in SHAPES if s not in ("frustum", "ray", "segment")]
MOVING = ["sphere", "capsule", "aabb", "obb"]
TAKEN = {"scene_add": MODELS, "scene_set_shape": MODELS}

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
        base, "int | None" if "*" in base else f"Field[{camel(base)}]" if name in VECTORS else camel(base))


def given_hint(api, f):
    """The type of a field as callers give it."""
    return "VectorLike" if f["type"] in VECTORS else "bool" if f["type"] == "int32_t" else hint(api, f["type"])


def struct_doc(struct):
    """The comment of a struct, and of its fields."""
    fields = settable(struct)
    lines = [struct["doc"] or f"{camel(struct['name'])}: {', '.join(f['name'] for f in fields)}."]
    if any(f["doc"] for f in fields):
        lines += ["", "Fields:"]
    for f in fields:
        lines += wrapped(f["doc"], 110, f"    {f['name']}: ", "        ") if f["doc"] else []
    return "\n".join(lines)


def constructor(api, struct):
    """Builds the struct from its fields: numbers are written at once, whatever else is given takes the way that says
    what is wrong with it."""
    def unsaid(f):
        zero = "(0, 0, 0)" if f["type"] in VECTORS else "0"
        return UNSAID.get((plain(struct["name"]), f["name"]), zero)

    fields = struct["fields"]
    words = [f"{f['name']}: {given_hint(api, f)} = {unsaid(f)}" for f in fields]
    lines, numbers = [], []
    for f in fields:
        if f["type"] in VECTORS:
            parts = [f"{f['name']}_{axis}" for axis in "xyzw"[:VECTORS[f["type"]]]]
            lines.append(f"            {', '.join(parts)} = {f['name']}")
            numbers += parts
        else:
            numbers.append(f["name"])
    named = ", ".join(f"{f['name']}={f['name']}" for f in fields)
    return [f"    def __init__(self, {', '.join(words)}) -> None:", "        try:", *lines,
            f"            _pack_{len(numbers)}(self, 0, {', '.join(numbers)})", "        except NOT_NUMBERS:",
            f"            self._set({named})"]


LIST_HINT = "Sequence[int] | NDArray[Any]"


def desc_constructor(api, struct):
    fields = settable(struct)
    hints = [LIST_HINT if f["name"] in lists(struct) else given_hint(api, f).replace(" | None", "") for f in fields]
    words = [f"{f['name']}: {hint} | None = None" for f, hint in zip(fields, hints)]
    lines = [f"    def __init__(self, *, {', '.join(words)}) -> None:", "        self._start()"]
    for f in fields:
        lines += [f"        if {f['name']} is not None:", f"            self.{f['name']} = {f['name']}"]
    return lines


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
    elif "*" in base:
        kind = '"P"'
    else:
        kind, count = f"{plain(f['type'])}_dtype", f["count"]
    return f'("{f["name"]}", {kind}{f", ({count},)" if count > 1 else ""})'


def low_level(api):
    out = [HEADER, "from __future__ import annotations\n",
           "from ctypes import POINTER, Array, Structure, c_char_p, c_float, c_int32, c_size_t, c_uint32, c_void_p",
           "from struct import Struct", "from typing import Any, Sequence\n", "from numpy import dtype", "from numpy.typing import NDArray\n",
           "from ._library import function, needs", "from ._runtime import shape_types",
           "from ._values import NOT_NUMBERS, Built, Desc, Field, List, Value, Vector, VectorLike, struct\n"]
    for enum in api["enums"]:
        for value in enum["values"]:
            out.append(f"{plain(value['name'])} = {value['value']}" + (f"  # {' '.join(value['doc'].split())}"
                                                                      if value["doc"] else ""))
        out.append("")
    for name, value in api["constants"].items():
        out.append(f"{plain(name)} = {value.rstrip('u') if value.startswith('0x') else value.rstrip('f')}")
    out.append("\nneeds(VERSION_MAJOR, VERSION_MINOR)\n")
    widths = {sum(VECTORS.get(f["type"], 1) for f in s["fields"]) for s in api["structs"] if s["name"] in BUILT}
    out += [f'_pack_{width} = Struct("{width}f").pack_into' for width in sorted(widths)]
    structs = []
    for struct in api["structs"]:
        name = struct["name"]
        if name in ("gphys_allocator", "gphys_task_runner"):
            continue
        structs.append(camel(name))
        desc = name.endswith("_desc")
        vector = name in BUILT and name in VECTORS
        base = "Desc" if desc else "Built" if name in BUILT else "Value"
        out.append(f"\n\n@struct\nclass {camel(name)}({'Vector, Array[c_float]' if vector else f'{base}, Structure'}):")
        out.append(docstring(struct_doc(struct), "    "))
        listed = lists(struct)
        out.append(f"    __slots__ = ({' '.join(f'{chr(34)}_{n}{chr(34)},' for n in listed)})" if listed else "    __slots__ = ()")
        if listed:
            out.append(f"    _lists = {listed!r}".replace("'", '"'))
        for f in struct["fields"]:
            kind = "List" if f["name"] in listed else hint(api, f["type"]) if f["count"] == 1 else "Any"
            out.append(f"    {f['name']}: {kind}")
        fields = ", ".join('("%s", %s%s)' % (f["name"], ctype(api, f["type"]), f" * {f['count']}" if f["count"] > 1 else "")
                           for f in struct["fields"])
        out += ["    _type_ = c_float", f"    _length_ = {VECTORS[name]}"] if vector else [f"    _fields_ = [{fields}]"]
        if desc or name in BUILT:
            out += ["", *(desc_constructor(api, struct) if desc else constructor(api, struct))]
        pointers = any("*" in base_type(api, f["type"]) for f in struct["fields"])
        if desc or not pointers:
            width = VECTORS.get(name)
            entries = ", ".join(dtype_entry(api, f) for f in struct["fields"])
            out.append(f'\n\n{plain(name)}_dtype: dtype[Any] = ' + (f'dtype(("<f4", ({width},)))' if width else f"dtype([{entries}]{', align=True' if pointers else ''})"))
            out.append(f"{camel(name)}.dtype = {plain(name)}_dtype")
            structs.append(f"{plain(name)}_dtype")
    out.append("\n")
    for f in api["functions"]:
        arguments = []
        for p in f["parameters"]:
            base = base_type(api, p["type"])
            arguments.append(f"POINTER({camel(element(p))})" if by_pointer(api, p) else NUMBERS.get(base, "c_void_p"))
        returns = {"const char *": "c_char_p", "void": "None"}.get(f["returns"], ctype(api, f["returns"]))
        out.append(f'{f["name"]} = function("{f["name"]}", {returns}, [{", ".join(arguments)}])')
    inits = [s["name"] for s in api["structs"] if s["name"].endswith("_desc")]
    for name in inits:
        out.append(f"{camel(name)}._init = {name}_init")
    shapes = ", ".join(f"{camel(s)}: SHAPE_{s.upper()}" for s in SHAPES if s != "mesh")
    out.append(f"\nshape_types.update({{{shapes}}})")
    names = [plain(v["name"]) for e in api["enums"] for v in e["values"]] + [plain(name) for name in api["constants"]]
    out.append(exported(names + structs))
    return "\n".join(line for line in out if line is not None) + "\n"


def exported(names):
    return "\n".join(["\n__all__ = [", *wrapped(" ".join(f'"{name}",' for name in names), 110, "    ", "    "), "]"])


def by_pointer(api, p):
    """One struct that the function reads: ctypes takes the struct itself."""
    return p["role"] == "in" and not p.get("count") and base_type(api, element(p)) not in DTYPES


def default(p):
    if p["name"] == "layers":
        return "low.ALL_LAYERS"
    if p["name"] == "max_distance":
        return 'float("inf")'
    if p["name"] in ("desc", "descs", "filter", "filters", "transform", "transforms", "local_point"):
        return "None"
    if p["role"] == "count":
        return "None"
    if p["name"] == "pinned":
        return "True"
    return "0" if p["name"] in ("tolerance", "link_length", "compliance", "first") else None


def shapes_hint(call, p):
    """The shapes that the parameter may be, all in one word or one by one."""
    taken = MOVING if p["name"] == "moving" else TAKEN.get(plain(call.function["name"]))
    return " | ".join("Mesh" if s == "mesh" else f"low.{camel(s)}" for s in taken) if taken else "Shape"


def input_hint(api, call, p):
    if p["role"] == "shape":
        return shapes_hint(call, p)
    if p["role"] == "array" and element(p) == "void":
        return "ArrayLike | Mesh"
    if p["role"] == "array" and element(p).endswith("_desc"):
        return f"NDArray[np.void] | Sequence[low.{camel(element(p))}] | low.{camel(element(p))} | None"
    if p["role"] == "array":
        return "ArrayLike | None" if p["name"] == "transforms" else "ArrayLike"
    if p["role"] == "handle":
        return f"{camel(element(p))} | None"
    if p["role"] == "in" and p.get("count"):
        return "ArrayLike"
    if p["role"] == "in":
        kind = camel(element(p))
        either = f"low.{kind}" if kind.endswith("Desc") else {"gphys_mat4": "low.Mat4 | ArrayLike"}.get(
            element(p), "VectorLike" if element(p) in VECTORS else f"low.{kind} | StructLike")
        return either + (" | None" if p.get("nullable") or default(p) else "")
    if p["role"] == "count":
        return "int | None"
    return "bool" if p["type"] == "int32_t" else hint(api, p["type"])


def array_hint(api, of):
    base = base_type(api, of)
    return f"NDArray[{'np.float32' if of in VECTORS else SCALARS.get(base, 'np.void')}]"


def output_hint(api, p):
    of = element(p)
    if p["role"] == "ragged":
        return f"tuple[{array_hint(api, of)}, NDArray[np.uint32]]"
    if p["role"] in ("list", "out_array") or p.get("count") or of == "gphys_mat4":
        return array_hint(api, of)
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
        words.append(f"{p['name']}: {input_hint(api, call, p)}" + (f" = {p['default']}" if p["default"] else ""))
    if any(p["role"] == "out_array" for p in call.outputs):
        words += ["*", "out: NDArray[Any] | None = None"]
    return ", ".join(words)


def checked(api, p):
    """The statement that refuses what a number cannot be. Most are of the right type, which costs least to ask."""
    name, base = p["name"], base_type(api, p["type"])
    if base == "float":
        return f'if type({name}) is not float: {name} = number({name}, "{name}")'
    if p["type"] == "int32_t":
        return f'if type({name}) is not bool: {name} = flag({name}, "{name}")'
    check, bits = ("mask", 32) if name in MASKS else ("whole", 32) if base == "uint32_t" else ("value", 31)
    return f'if type({name}) is not int or {name} >> {bits}: {name} = {check}({name}, "{name}")'


def packed(parameters, i):
    """An argument for arrays whose elements the library takes only side by side: those without a stride."""
    return "" if has_stride(parameters, i) else ", packed=True"


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
            arguments.append(f"{name}_")
        elif role == "in" and p.get("count"):
            lines.append(f"{name}_ = numbers_of({name}, {numpy_type(api, element(p))}, {p['count']})")
            arguments.append(f"{name}_.address")
        elif role == "in" and element(p) == "gphys_mat4":
            lines.append(f'{name}_ = matrix_of({name}, low.Mat4, "{name}")')
            arguments.append(f"{name}_")
        elif role == "in":
            kind = f"low.{camel(element(p))}"
            same = f"{name} is None" if p.get("nullable") else f"type({name}) is {kind}"
            lines.append(f'{name}_ = {name} if {same} else value_of({name}, {kind}, "{name}")')
            arguments.append(f"{name}_")
        elif role == "array":
            if element(p) == "void":
                lines.append(f"{parameters[i - 1]['name']}_, {name}_ = shapes_of({name})")
            elif element(p).endswith("_desc"):
                lines.append(f"{name}_ = descs_of({name}, low.{camel(element(p))})")
            else:
                width = f", {p['width']}" if "width" in p else ""
                lines.append(f"{name}_ = array_of({name}, {numpy_type(api, element(p))}{width}{packed(parameters, i)})")
            arguments.append(f"{name}_.address")
        elif role == "stride" and name == "out_stride":
            arguments.append("out_.stride")
        elif role == "stride":
            arguments.append(f"{parameters[i - 1]['name']}_.stride")
        elif role == "count":
            arrays = [q for q in parameters if q["role"] == "array"]
            if not arrays:
                length = name
                lines += [f"if {name} is None: {name} = self._rest(body, first)", checked(api, p)]
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
            lines.append(("result", f"{size}, {numpy_type(api, element(p))}{packed(parameters, i)}"))
            arguments.append("out_.address")
        elif role == "out":
            of = element(p)
            kind = f"low.{camel(of)}" if base_type(api, of) not in NUMBERS else f"ctypes.{NUMBERS[base_type(api, of)]}"
            lines.append(f"{name} = {kind}()" if not p.get("count") else
                         f"{name} = np.empty({p['count']}, {numpy_type(api, of)})")
            arguments.append(f"ctypes.byref({name})" if not p.get("count") else f"{name}.ctypes.data")
        elif role in ("capacity", "total", "offsets", "list", "ragged"):
            continue
        elif role == "new":
            arguments.append(name)
        else:
            lines.append(checked(api, p))
            arguments.append(name)
    # The length is known when all arrays are, and room for results is made when the length is.
    arrays = [line for line in lines if isinstance(line, str)]
    lengths = [f"{what[0]}({', '.join(p['name'] + '_' for p in what[1])})" for what in lines
               if what[0] == "count = common_length"]
    results = [f"out_ = result_array(out, {what[1]})" for what in lines if what[0] == "result"]
    return arrays + lengths + results, arguments


def result_of(api, p):
    of = element(p)
    if p["role"] == "out_array":
        return "out_.array"
    if p.get("count"):
        return p["name"]
    if of == "gphys_mat4":
        return f"matrix({p['name']})"
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
                f"{inner}return not status or status != low.{plain(ANSWERS[f['name']])} and found(status)\n")
    text += f"{inner}status = {invoke}\n{inner}if status < 0: check(status)\n"  # asked here, which costs less than the call
    if not call.outputs:
        return text
    result = ", ".join(result_of(api, p) for p in call.outputs)
    if may_miss:
        return text + f"{inner}return None if status else {result if len(call.outputs) == 1 else f'({result})'}\n"
    return text + f"{inner}return {result}\n"


# What an object can do besides calling one function of the library.
BASES = {"gphys_scene": "Models", "gphys_solver": "Bodies"}


def objects(api):
    out = [HEADER + '''from __future__ import annotations

import ctypes
from typing import Any, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _low as low
from ._library import check, found
from ._numbers import flag, mask, number, value, whole
from ._runtime import (Bodies, Models, Object, array_of, common_length, descs_of, handle_of, list_of, matrix, matrix_of,
                       numbers_of, ragged_of, result_array, shape_of, shapes_of, value_of)
from ._values import StructLike, VectorLike
''']
    made = creations(api)
    methods = list(calls(api))
    for handle in api["handles"]:
        creation = made[handle]
        out.append(f"\n\nclass {camel(handle)}({BASES.get(handle, 'Object')}):")
        doc = docstring(creation.function["doc"], "    ").rstrip("\n")
        out.append(doc) if doc else None
        out.append(f"    _destroy = low.{handle}_destroy")
        out.append("    _shape_type = low.SHAPE_MESH\n" if handle == "gphys_mesh" else "")
        lines, arguments = body(api, creation, None)
        out.append(f"    def __init__({signature(api, creation, 'self')}) -> None:")
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
    out.append(exported([*map(camel, api["handles"]), "Shape", *(call.name for call in methods if not call.owner)]))
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
