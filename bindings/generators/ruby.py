"""Ruby: the functions for the ffi gem, values as Structs, and a method for each function."""
from ._calls import arguments, batch_arrays, comment
from ._docs import Language, as_tags, translated
from ._names import ANSWERS, MASKS, SHAPES, base_type, calls, camel, constants, creations, element, lists, other_creations, plain

HEADER = "# frozen_string_literal: true\n\n# Generated from gamephys_api.json by bindings/generate.py. Not for editing.\n"
FFI = {"float": ":float", "double": ":double", "int32_t": ":int32", "uint32_t": ":uint32", "size_t": ":size_t", "void": ":void"}
NUMBERS = {"float": "Float32", "double": "Float64", "int32_t": "Int32", "uint32_t": "UInt32"}
FORMATS = {"float": "f", "double": "d", "int32_t": "l", "uint32_t": "L"}
ARRAYS = ("gphys_vec3", "gphys_quat", "gphys_mat4")  # values that are arrays of numbers
TEMPLATES = {
    "self": "opened", "handle": "Low.opened({n}, {type})", "handle?": "{n} && Low.opened({n}, {type})", "shape_type": "{shape}.class::KIND",
    "shape": "Low.shape({n})", "in": "{type}.pack({n})", "in?": "{n} && {type}.pack({n})",
    "in_fixed": "{type}.pack_all({n}, {count})", "array": "{n}.pointer", "shape_array": "{n}.pointer",
    "stride": "{array}.stride", "batch_count": "count", "own_count": "{array}.count", "plain_count": "count",
    "scalar": "{n}", "out": "{n}", "out_fixed": "{n}", "out_array": "out.pointer", "list": "out",
    "capacity": "capacity", "total": "total", "ragged": "out", "offsets": "offsets", "new": "made",
}
# Optional parameters that are named in a call.
KEYWORDS = {"layers": "ALL_LAYERS", "max_distance": "Float::INFINITY", "tolerance": "0", "link_length": "0", "compliance": "0"}
POSITIONAL = ("transform", "transforms", "descs", "filters", "local_point")


def kind(api, of):
    """The Ruby constant that knows a C type."""
    return NUMBERS.get(base_type(api, of)) or camel(of)


def flat(api, of):
    """The format characters of a type's numbers, one each."""
    base = base_type(api, of)
    if base in FORMATS:
        return FORMATS[base]
    struct = next(s for s in api["structs"] if s["name"] == base)
    return "".join(flat(api, f["type"]) * f["count"] for f in struct["fields"])


def packed(letters):
    """'ffffLL' -> 'f4L2'"""
    out, i = "", 0
    while i < len(letters):
        run = len(letters[i:]) - len(letters[i:].lstrip(letters[i]))
        out += letters[i] + (str(run) if run > 1 else "")
        i += run
    return out


def value_class(api, struct):
    name, letters = struct["name"], flat(api, struct["name"])
    shape = plain(name)
    sizes = f"FORMAT, COUNT, BYTES = '{packed(letters)}', {len(letters)}, {struct['size'][0]}"
    about = comment(struct["doc"], "#")
    if name in ARRAYS:
        return f"{about}module {camel(name)} # an Array of {len(letters)} numbers\n  extend Plain\n  {sizes}\nend\n"
    numbers, reads, at = [], [], 0
    for f in struct["fields"]:
        size = len(flat(api, f["type"]))
        base = base_type(api, f["type"])
        if base in FORMATS:
            numbers.append(f["name"])
            reads.append(f"n[{at}]")
        elif base in ARRAYS:
            numbers.append(f"*{f['name']}")
            reads.append(f"n[{at}, {size}]")
        elif f["count"] > 1:
            numbers.append(f"*{f['name']}.flat_map {{ |each| {camel(base)}.coerce(each).numbers }}")
            reads.append(f"n[{at}, {size * f['count']}].each_slice({size}).map {{ |m| {camel(base)}.from(m) }}")
        else:
            numbers.append(f"*{camel(base)}.coerce({f['name']}).numbers")
            reads.append(f"{camel(base)}.from(n[{at}, {size}])")
        at += size * f["count"]
    fields = ", ".join(f":{f['name']}" for f in struct["fields"])
    text = f"{about}{camel(name)} = ::Struct.new({fields}) do\n  extend Value\n\n"
    if name == "gphys_transform":
        text += ("  # In order or by name; what is not given is the identity.\n"
                 "  def initialize(place = [0, 0, 0], turn = [0, 0, 0, 1], size = 1, position: place, rotation: turn, scale: size)\n"
                 "    super(position, rotation, scale)\n  end\n\n"
                 "  def self.coerce(value) = value.is_a?(Hash) ? new(**value) : super\n")
    text += f"  def self.from(n) = new({', '.join(reads)})\n  def numbers = [{', '.join(numbers)}]\nend\n"
    text += f"{camel(name)}::FORMAT, {camel(name)}::COUNT, {camel(name)}::BYTES = " + sizes.split(" = ")[1] + "\n"
    return text + (f"{camel(name)}::KIND = SHAPE_{shape.upper()}\n" if shape in SHAPES else "")


def values(api):
    out = [HEADER + "module Gamephys"]
    out.append("\n".join(f"{name} = {number!r}" for name, number in constants(api).items()) + "\n")
    for base, name in NUMBERS.items():
        out.append(f"module {name}\n  extend {'Whole' if base == 'uint32_t' else 'Plain'}\n  FORMAT, COUNT, BYTES = '{FORMATS[base]}', 1, {8 if base == 'double' else 4}\n"
                   "  def self.from(n) = n[0]\nend\n")
    out += [value_class(api, s) for s in api["structs"]
            if not s["name"].endswith("_desc") and not any("*" in base_type(api, f["type"]) for f in s["fields"])]
    return indented("\n".join(out)) + "end\n"


def indented(text):
    """The lines after the first `module Gamephys` two spaces further in."""
    head, body = text.split("module Gamephys\n", 1)
    return head + "module Gamephys\n" + "".join(f"  {line}".rstrip() + "\n" for line in body.splitlines())


def ffi_type(api, of):
    return FFI.get(base_type(api, of), ":pointer") if "*" not in of else ":string" if of == "const char *" else ":pointer"


def low(api):
    out = [HEADER + "module Gamephys\nmodule Low\n"]
    for s in api["structs"]:
        if s["name"].endswith("_desc"):
            fields = ", ".join(f":{f['name']}, " + (camel(f["type"]) if f["type"] in ARRAYS else ffi_type(api, base_type(api, f["type"])))
                               for f in s["fields"])
            fields = fields.replace("Vec3", "[:float, 3]")
            listed = "".join(f"    LISTS = {{ {', '.join(f'{n}: :{count}' for n, count in some.items())} }}.freeze\n"
                             for some in [lists(s)] if some)
            out.append(f"  class {camel(s['name'])} < FFI::Struct\n    layout {fields}\n{listed}  end\n")
    for f in api["functions"]:
        given = ", ".join(ffi_type(api, p["type"]) for p in f["parameters"])
        out.append(f"  attach_function :{f['name']}, [{given}], {ffi_type(api, f['returns'])}")
    return indented("\n".join(out) + "\nend\n") + "end\n"


def signature(call):
    required, optional, keywords = [], [], []
    outs = any(p["role"] == "out_array" for p in call.outputs)
    for p in call.inputs:
        n = p["name"]
        if p["role"] == "in" and n == "desc":
            keywords.append("**desc")
        elif p["role"] == "in" and element(p).endswith("_desc"):
            optional.append(f"{n} = nil")
        elif n in KEYWORDS and call.name != "set_layers":
            keywords.append(f"{n}: {KEYWORDS[n]}")
        elif n in POSITIONAL and p.get("nullable"):
            optional.append(f"{n} = nil")
        else:
            required.append(n)
    if outs:
        keywords.insert(len(keywords) - (keywords[-1:] == ["**desc"]), "out: nil")
    return ", ".join([*required, *optional, *keywords])


def argument_list(api, call):
    parameters = call.function["parameters"]
    templates = dict(TEMPLATES, in_fixed=TEMPLATES["in_fixed"].replace("{count}", str(next(
        (p["count"] for p in parameters if p.get("count")), 0))))
    words = arguments(call, templates, lambda of: kind(api, of))
    for i, p in enumerate(parameters):
        n = p["name"]
        if p["role"] == "in" and n == "desc":
            words[i] = f"Low.desc(Low::{camel(element(p))}, :{element(p)}_init, desc)"
        elif p["role"] == "in" and element(p).endswith("_desc"):
            words[i] = f"{n} && Low.desc(Low::{camel(element(p))}, :{element(p)}_init, {n})"
        elif p["role"] == "shape_type" and parameters[i + 1]["role"] == "array":
            words[i] = f"{parameters[i + 1]['name']}.kind::KIND"
        elif p["role"] == "shape_type":
            words[i] = f"Low.kind({parameters[i + 1]['name']})"
        elif p["role"] == "stride" and n == "out_stride":
            words[i] = f"{kind(api, element(parameters[i - 1]))}::BYTES"
        elif n in ("pinned", "keep_world", "reverse_z", "embed_meshes"):
            words[i] = f"Low.flag({n})"
        elif p["role"] in ("scalar", "count") and words[i] == n != "count" and base_type(api, p["type"]) == "uint32_t" and n not in MASKS:
            words[i] = f"Low.whole({n})"
    return words


def prepared(api, call):
    lines = []
    for p in call.function["parameters"]:
        if p["role"] == "array" and element(p).endswith("_desc"):
            lines.append(f"{p['name']} = Low.descs(Low::{camel(element(p))}, :{element(p)}_init, {p['name']})")
        elif p["role"] == "array":
            of = "" if element(p) == "void" else f"{kind(api, element(p))}, "
            width = f", {p['width']}" if "width" in p else ""
            lines.append(f"{p['name']} = Low.{'array' if of else 'shapes'}({of}{p['name']}{width})")
    arrays = [p["name"] for p in batch_arrays(call)]
    if arrays:
        lines.append(f"count = Low.common({', '.join(arrays)})")
    return lines


def method(api, call):
    f, outs = call.function, call.outputs
    lines, results = prepared(api, call), []
    for p in outs:
        of = kind(api, element(p))
        if p["role"] == "out_array":
            lines.append(f"out = Low.results({of}, out, {p.get('length', 'count')})")
            results.append("out")
        elif p["role"] == "out" and p.get("count"):
            lines.append(f"{p['name']} = {of}.room({p['count']})")
            results.append(f"{of}.unpack_all({p['name']}, {p['count']})")
        elif p["role"] == "out":
            lines.append(f"{p['name']} = {of}.room")
            results.append(f"{of}.unpack({p['name']})" + (" != 0" if element(p) == "int32_t" else ""))
    invoke = f"Low.{f['name']}({', '.join(argument_list(api, call))})"
    listed = next((p for p in outs if p["role"] in ("list", "ragged")), None)
    answer = ", ".join(results) if len(results) < 2 else f"[{', '.join(results)}]"
    if listed and listed["role"] == "list":
        lines.append(f"Low.list({kind(api, element(listed))}) {{ |out, capacity, total| {invoke} }}")
    elif listed:
        lines.append(f"Low.ragged({kind(api, element(listed))}, count) {{ |out, capacity, offsets| {invoke} }}")
    elif f["name"] in ANSWERS:
        lines.append(f"Low.answered({invoke}, {plain(ANSWERS[f['name']])})")
    elif f["may_miss"]:
        lines.append(f"{answer} if Low.found({invoke})")
    else:
        lines += [f"Low.check({invoke})", answer if results else "nil"]
    asks = not call.owner or f["parameters"][0]["type"].startswith("const")  # what changes its object has no question mark
    question = f["name"] in ANSWERS or asks and len(outs) == 1 and outs[0]["role"] == "out" and element(outs[0]) == "int32_t"
    head = f"{'' if call.owner else 'self.'}{call.name}{'?' if question else ''}"
    given = signature(call)
    text = comment(f["doc"], "#") + f"def {head}{f'({given})' if given else ''}\n"
    return text + "".join(f"  {line}\n" for line in lines) + "end\n"


def methods(api):
    made, every = creations(api), list(calls(api))
    out = [HEADER + "module Gamephys"]
    for handle in api["handles"]:
        creation = made[handle]
        body = [f"class Pointer < FFI::AutoPointer\n  def self.release(pointer) = Low.{handle}_destroy(pointer)\nend\n"]
        if handle == "gphys_mesh":
            body.append("KIND = SHAPE_MESH\n")
        body.append(comment(creation.function["doc"], "#") + f"def initialize({signature(creation)})\n" +
                    "".join(f"  {line}\n" for line in prepared(api, creation)) +
                    f"  own(Pointer) {{ |made| Low.{creation.function['name']}({', '.join(argument_list(api, creation))}) }}\nend\n")
        for c in other_creations(api, handle):
            body.append(comment(c.function["doc"], "#") + f"def self.{c.name}({signature(c)})\n" +
                        "".join(f"  {line}\n" for line in prepared(api, c)) +
                        f"  allocate.tap do |object|\n    object.send(:own, Pointer) {{ |made| Low.{c.function['name']}({', '.join(argument_list(api, c))}) }}\n  end\nend\n")
        body += [method(api, c) for c in every if c.owner == handle]
        text = "".join(f"  {line}".rstrip() + "\n" for line in "\n".join(body).splitlines())
        out.append(f"class {camel(handle)} < Owned\n{text}end\n")
    out += [method(api, c) for c in every if not c.owner]
    return indented("\n".join(out)) + "end\n"


LANGUAGE = Language(null="nil", function=lambda owner, call: f"{owner}#{call.name}" if owner else f"Gamephys.{call.name}",
                    type=camel, constant=plain, parameter=lambda name: name.removeprefix("out_"))
# Statuses that are exceptions of their own.
EXCEPTIONS = {"ERROR_INVALID_ARGUMENT": "InvalidArgument", "ERROR_INVALID_ID": "InvalidId", "ERROR_OUT_OF_MEMORY": "OutOfMemory"}


def commented(doc, creates):
    doc.errors = [(EXCEPTIONS.get(status, "Error"), when if status in EXCEPTIONS else f"{when} ({status})")
                  for status, when in doc.errors]
    return as_tags(doc, "nil", "@return", "@raise [{}]")


def generate(api):
    api = translated(api, LANGUAGE, commented)
    return {"ruby/lib/gamephys/low.rb": low(api), "ruby/lib/gamephys/values.rb": values(api),
            "ruby/lib/gamephys/methods.rb": methods(api)}
