"""C#: structs and enums (Values.cs), the C functions (Low.cs), and a method for each function (Objects.cs)."""
import copy

from ._calls import arguments, batch_arrays
from ._docs import Language, outcome, paragraphs, translated, wrapped
from ._names import (BUILT, OF_THE_DESC, SHAPES, base_type, calls, camel, common_prefix, creations, element, has_lists, lists,
                     lower_camel, other_creations, settable)

HEADER = "// Generated from gamephys_api.json by bindings/generate.py. Not for editing.\n"
NUMBERS = {"float": "float", "double": "double", "int32_t": "int", "uint32_t": "uint", "size_t": "UIntPtr", "void": "void"}
# What is written by hand, because a rule for one function would be longer.
BY_HAND = ("gphys_scene_has",)
# What may be left out of a call: these parameters come last.
DEFAULTS = {"layers": "Constants.AllLayers", "max_distance": "float.PositiveInfinity", "tolerance": "0", "link_length": "0", "compliance": "0"}
WORDS = ("in", "out", "ref", "params", "object", "lock", "fixed", "base")
TEMPLATES = {
    "self": "Handle", "handle": "{n}.Handle",
    "handle?": "{n} == null ? {type}Handle.None : {n}.Handle", "shape_type": "{shape}.Type", "shape": "{n}_",
    "in": "&{n}", "in?": "{n}.HasValue ? &{n}_ : null", "in_fixed": "{n}_", "array": "{n}_", "shape_array": "{n}_", "stride": "StrideOf({array})",
    "shape_stride": "{array}.Stride", "batch_count": "count", "own_count": "(uint){array}.Length", "plain_count": "count", "scalar": "{n}",
    "flag": "{n} ? 1 : 0", "out_array": "{n}_", "out_stride": "(uint)sizeof({type})", "out": "&{n}", "out_fixed": "{n}_", "list": "out_",
    "capacity": "(uint)result.Length", "total": "&total", "ragged": "out_", "offsets": "offsets_", "new": "&made",
}


def cs_type(of):
    return NUMBERS.get(of) or camel(of)


def raw(api, of):
    """The struct that the C function is given: settings with lists have another for their users."""
    return typed(api, of) + ("Data" if has_lists(api, of) else "")


def typed(api, of):
    """Ids are plain numbers."""
    return "uint" if base_type(api, of) == "uint32_t" else cs_type(of)


def local(name):
    """'out_hit' -> 'hit'"""
    text = lower_camel(name.removeprefix("out_"))
    return "@" + text if text in WORDS else text


def escaped(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


def docs(text, indent=""):
    if not text:
        return ""
    if text.startswith("<summary>"):
        return "".join(f"{indent}/// {line}".rstrip() + "\n" for line in text.split("\n"))
    lines = escaped(text).split("\n")
    if len(lines) == 1:
        return f"{indent}/// <summary>{lines[0]}</summary>\n"
    return "".join(f"{indent}/// {line}".rstrip() + "\n" for line in ["<summary>", *lines, "</summary>"])


def field(name):
    return "Parameters" if name == "params" else camel(name)


def with_lists(api, s):
    """Settings whose lists are arrays, and how they become memory of the library's layout for the time of a call."""
    name, listed, fields = camel(s["name"]), lists(s), {f["name"]: f for f in s["fields"]}
    size = f"sizeof({name}Data)"
    out = docs(s["doc"]) + f"public struct {name} {{\n    internal {name}Data Data;\n"
    for f in settable(s):
        n, kind = field(f["name"]), typed(api, f["type"])
        out += docs(f["doc"], "    ") + (f"    public {typed(api, element(f))}[] {n};\n" if f["name"] in listed else
                                         f"    public {kind} {n} {{ get {{ return Data.{n}; }} set {{ Data.{n} = value; }} }}\n")
    out += (f"    /// <summary>The defaults of the loaded library, to be changed.</summary>\n    public static unsafe {name} Default {{\n"
            f"        get {{\n            {name}Data desc;\n            Support.Check(Low.{s['name']}_init(&desc, (uint){size}));\n"
            f"            return new {name} {{ Data = desc }};\n        }}\n    }}\n}}\n\n")
    counted = "".join(f"            bytes += {field(n)}Of(desc).Length * (long)sizeof({typed(api, element(fields[n]))});\n" for n in listed)
    written, of_each = "", ""
    for n, count in listed.items():
        kind = typed(api, element(fields[n]))
        assert kind == "uint", "lists of other elements need their alignment"
        of_each += f"    private static {kind}[] {field(n)}Of({name} desc) {{ return desc.{field(n)} ?? Array.Empty<{kind}>(); }}\n"
        written += (f"            var given{field(n)} = {field(n)}Of(descs[i]);\n"
                    f"            Pointer[i].{field(n)} = given{field(n)}.Length == 0 ? IntPtr.Zero : (IntPtr)list;\n"
                    f"            Pointer[i].{field(count)} = (uint)given{field(n)}.Length;\n"
                    f"            foreach (var number in given{field(n)}) *list++ = number;\n")
    return out + (f"// Such settings in memory of the library's layout, with their lists behind them, for the time of a call.\n"
                  f"internal unsafe struct {name}s : IDisposable {{\n    internal readonly {name}Data* Pointer;\n    internal readonly uint Stride;\n\n"
                  f"    internal {name}s({name}? desc) : this(desc.HasValue ? new[] {{ desc.Value }} : null) {{ }}\n\n"
                  f"    internal {name}s(ReadOnlySpan<{name}> descs) {{\n        Pointer = null;\n        Stride = descs.Length == 1 ? 0 : (uint){size};\n"
                  f"        if (descs.Length == 0) return;\n        var bytes = (long){size} * descs.Length;\n        foreach (var desc in descs) {{\n{counted}        }}\n"
                  f"        Pointer = ({name}Data*)Marshal.AllocHGlobal(new IntPtr(bytes));\n        var list = (uint*)(Pointer + descs.Length);\n"
                  f"        for (var i = 0; i < descs.Length; ++i) {{\n            Pointer[i] = descs[i].Data;\n{written}        }}\n    }}\n\n{of_each}"
                  f"    public void Dispose() {{ Marshal.FreeHGlobal((IntPtr)Pointer); }}\n}}\n")


def struct(api, s):
    name, listed = camel(s["name"]), has_lists(api, s["name"])
    head = f"internal struct {name}Data" if listed else f"public partial struct {name}"
    out = ("" if listed else docs(s["doc"])) + f"[StructLayout(LayoutKind.Sequential)]\n{head} {{\n"
    for f in s["fields"]:
        kind = "IntPtr" if "*" in f["type"] else typed(api, f["type"])
        if f["count"] > 1:
            single = f["name"].removesuffix("s") if len(f["name"]) > 1 else f["name"]
            names = ", ".join(f"{single}{i}" for i in range(f["count"]))
            out += docs(f["doc"], "    ") + f"    private {kind} {names};\n"
            out += (f"    public unsafe {kind} this[int index] {{\n"
                    f"        get {{ fixed ({kind}* first = &{single}0) return first[InRange(index, {f['count']})]; }}\n"
                    f"        set {{ fixed ({kind}* first = &{single}0) first[InRange(index, {f['count']})] = value; }}\n    }}\n"
                    f"    private static int InRange(int index, int count) {{\n"
                    f"        return index >= 0 && index < count ? index : throw new IndexOutOfRangeException();\n    }}\n")
            continue
        if listed:
            out += f"    internal {kind} {field(f['name'])};\n"
            continue
        access = "internal" if f["name"] in OF_THE_DESC else "public"
        text = f["doc"] + (("\n" if f["doc"] else "") + f"The address of a {element(f)}." if "*" in f["type"] and "(" not in f["type"] else "")
        out += docs(text, "    ") + f"    {access} {kind} {field(f['name'])};\n"
    if s["name"] in BUILT:
        words = ", ".join(f"{typed(api, f['type'])} {lower_camel(f['name'])}" for f in s["fields"])
        sets = " ".join(f"{field(f['name'])} = {lower_camel(f['name'])};" for f in s["fields"])
        out += f"    public {name}({words}) {{ {sets} }}\n"
    if listed:
        return f"{out}}}\n\n{with_lists(api, s)}"
    if s["name"].endswith("_desc"):
        out += (f"    /// <summary>The defaults of the loaded library, to be changed.</summary>\n    public static unsafe {name} Default {{\n"
                f"        get {{\n            {name} desc;\n            Support.Check(Low.{s['name']}_init(&desc, (uint)sizeof({name})));\n"
                f"            return desc;\n        }}\n    }}\n")
    return out + "}\n"


def values(api):
    out = [HEADER + "using System;\nusing System.Runtime.InteropServices;\n\nnamespace Gamephys {\n"]
    for enum in api["enums"]:
        if not enum["name"]:
            continue
        prefix = common_prefix([v["name"] for v in enum["values"]])
        out.append(docs(next(t["doc"] for t in api["types"] if t["name"] == enum["name"])) + f"public enum {camel(enum['name'])} {{")
        out += [docs(v["doc"], "    ") + f"    {camel(v['name'][len(prefix):])} = {v['value']}," for v in enum["values"]] + ["}\n"]
    out.append("public static class Constants {")
    for enum in api["enums"]:
        if not enum["name"]:
            out += [docs(v["doc"], "    ") + f"    public const uint {camel(v['name'])} = {v['value']};" for v in enum["values"]]
    for name, value in api["constants"].items():
        kind = "float" if value.endswith("f") and not value.startswith("0x") else "uint"
        out.append(f"    public const {kind} {camel(name)} = {value};")
    out.append("}\n")
    out += [struct(api, s) for s in api["structs"]]
    kinds = [s for s in SHAPES if s != "mesh"]
    out.append("[StructLayout(LayoutKind.Explicit)]\ninternal struct AnyShape {")
    out += [f"    [FieldOffset(0)] internal {camel(s)} {camel(s)};" for s in kinds]
    out.append("}\n\npublic partial struct Shape {")
    for s in kinds:
        name = camel(s)
        out.append(f"    public static implicit operator Shape({name} shape) {{\n        return new Shape {{ Type = ShapeType.{name}, Data = new AnyShape {{ {name} = shape }} }};\n    }}")
        out.append(f"    public {name} {name} {{ get {{ return Type == ShapeType.{name} ? Data.{name} : throw new InvalidCastException(\"the shape is a \" + Type); }} }}")
    out.append("}\n\npublic readonly ref partial struct Shapes {")
    for s in kinds:
        name = camel(s)
        for given in (f"{name}[]", f"Span<{name}>", f"ReadOnlySpan<{name}>"):
            out.append(f"    public static implicit operator Shapes({given} shapes) {{\n"
                       f"        return new Shapes(ShapeType.{name}, MemoryMarshal.AsBytes<{name}>(shapes), shapes.Length);\n    }}")
    out.append("}\n\n}")
    return "\n".join(out) + "\n"


def layout(api):
    out = [HEADER + "using System;\nusing System.Reflection;\nusing Gamephys;\n\n// Size and offsets of each struct as C has them, on 64-bit machines.\n"
           "static class Layout {\n    public static readonly (Type Type, int Size, string[] Names, int[] Offsets)[] Structs = {"]
    for s in api["structs"]:
        single = [f for f in s["fields"] if f["count"] == 1]
        names, offsets = ", ".join(f'"{field(f["name"])}"' for f in single), ", ".join(str(f["offset"][0]) for f in single)
        kind = f'typeof({camel(s["name"])})'
        if has_lists(api, s["name"]):
            kind += '.GetField("Data", BindingFlags.Instance | BindingFlags.NonPublic).FieldType'
        out.append(f"        ({kind}, {s['size'][0]}, new string[] {{ {names} }}, new int[] {{ {offsets} }}),")
    out.append("    };\n}")
    return "\n".join(out) + "\n"


def c_parameter(api, p):
    of = p["type"]
    if of.endswith("**"):
        return f"IntPtr* {p['name']}"
    if p["role"] == "handle":
        return f"{camel(element(p))}Handle {p['name']}"
    return f"{raw(api, element(p))}{'*' if '*' in of else ''} {'@' if p['name'] in WORDS else ''}{p['name']}"


def low(api):
    out = [HEADER + "using System;\nusing System.Runtime.InteropServices;\n\nnamespace Gamephys {\n\n"
           "// The C functions as they are.\ninternal static unsafe class Low {\n    private const string Library = \"gamephys\";\n"]
    for f in api["functions"]:
        if f["returns"] == "void":
            words = f"IntPtr {f['parameters'][0]['name']}"
        else:
            words = ", ".join(c_parameter(api, p) for p in f["parameters"])
        returns = {"const char *": "IntPtr", "void": "void"}.get(f["returns"]) or typed(api, f["returns"])
        out.append(f"    [DllImport(Library)] internal static extern {returns} {f['name']}({words});")
    out.append("}\n")
    for handle in api["handles"]:
        name = f"{camel(handle)}Handle"
        out.append(f"internal sealed class {name} : ObjectHandle {{\n    internal static readonly {name} None = new {name}(IntPtr.Zero);\n"
                   f"    internal {name}(IntPtr made) : base(made) {{ }}\n"
                   f"    protected override bool ReleaseHandle() {{\n        Low.{handle}_destroy(handle);\n        return true;\n    }}\n}}\n")
    out.append("}")
    return "\n".join(out) + "\n"


def has_stride(call, p):
    following = call.function["parameters"]
    i = following.index(p)
    return i + 1 < len(following) and following[i + 1]["role"] in ("stride", "out_stride")


def item(api, p):
    return {3: "Vec3", 2: "Vec2"}[p["width"]] if "width" in p else typed(api, element(p))


def rename(calls):
    """Give the parameters C#'s names, and roles to those that C# treats apart."""
    for call in calls:
        parameters = call.function["parameters"]
        given = {local(p["name"]) for p in call.inputs}
        for p in parameters:
            p["c_name"], name = p["name"], local(p["name"])
            p["name"] = "out" + name.capitalize() if p["role"] == "out" and name in given else name
        for before, p in zip([None, *parameters], parameters):
            if p["role"] == "stride" and before["role"] == "out_array":
                p["role"], p["name"], p["type"] = "out_stride", before["name"], before["type"]
            elif p["role"] == "scalar" and p["type"] == "int32_t":
                p["role"] = "flag"


def counted_by_out(call):
    return (any(p["name"] == "count" for p in call.inputs) and
            any(p["role"] == "out_array" and not p.get("length") for p in call.outputs))


def default(p):
    if p["role"] in ("in", "handle", "array") and p.get("nullable"):
        return "default" if p["role"] == "array" else "null"
    return DEFAULTS.get(p["c_name"]) if p["role"] == "scalar" else None


def parameter(api, p):
    n, of = p["name"], typed(api, element(p))
    if p["role"] == "shape":
        return f"Shape {n}"
    if p["role"] == "array":
        return f"Shapes {n}" if element(p) == "void" else f"ReadOnlySpan<{item(api, p)}> {n}"
    if p["role"] == "handle":
        return f"{of} {n}"
    if p.get("count"):
        return f"ReadOnlySpan<{of}> {n}"
    if p["role"] == "in":
        return f"{of}{'?' if p.get('nullable') else ''} {n}"
    return f"bool {n}" if p["role"] == "flag" else f"{typed(api, p['type'])} {n}"


def signature(api, call):
    inputs = [p for p in call.inputs if not (p["name"] == "count" and counted_by_out(call))]
    words = [parameter(api, p) for p in inputs if default(p) is None]
    words += [f"Span<{typed(api, element(p))}> {p['name']}" for p in call.outputs if p["role"] == "out_array"]
    for p in inputs:
        if default(p):
            value = default(p)
            value = f"default(ReadOnlySpan<{item(api, p)}>)" if value == "default" else value
            words.append(f"{parameter(api, p)} = {value}")
    return ", ".join(words)


def prepare(api, call):
    """(statements before the C call, what has to stay in place for it, what has to stay alive)"""
    lines, pins, alive = [], [], []
    for p in call.function["parameters"]:
        n, role = p["name"], p["role"]
        if role == "shape":
            lines.append(f"void* {n}_ = {n}.Mesh == null ? (void*)&{n}.Data : {n}.Mesh.Pointer;")
            alive.append(f"{n}.Mesh")
        elif role in ("in", "array") and has_lists(api, element(p)):
            pins.append(f"using (var {n}_ = new {camel(element(p))}s({n}))")
        elif role == "in" and p.get("nullable"):
            lines.append(f"var {n}_ = {n}.GetValueOrDefault();")
        elif role == "in" and p.get("count"):
            lines.append(f"RequireLength({n}.Length, {p['count']});")
            pins.append(f"fixed ({typed(api, element(p))}* {n}_ = &MemoryMarshal.GetReference({n}))")
        elif role == "array" and element(p) == "void":
            lines.append(f"var {n}One = {n}.One;")
            pins.append(f"fixed (byte* {n}First = &MemoryMarshal.GetReference({n}.Bytes))")
            alive.append(f"{n}One.Mesh")
        elif role in ("array", "out_array"):
            kind = "float" if "width" in p else typed(api, element(p))
            pins.append(f"fixed ({item(api, p) if role == 'array' else kind}* {n}_ = &MemoryMarshal.GetReference({n}))")
    arrays = batch_arrays(call)
    if counted_by_out(call):
        lines.append(f"var count = (uint){call.outputs[0]['name']}.Length;")
    elif arrays:
        fixed = [f"{p['name']}.Length" for p in arrays if not has_stride(call, p)]
        shared = [f"{p['name']}.Count" if element(p) == "void" else f"{p['name']}.Length"
                  for p in arrays if has_stride(call, p) and not p.get("nullable")]
        shared += [f"Optional({p['name']})" for p in arrays if p.get("nullable")]
        lines.append(f"var count = CommonLength({fixed[0] if fixed else -1}, {', '.join(shared) or '1'});")
    for p in call.outputs:
        if p["role"] == "out_array" and not counted_by_out(call):
            length = p.get("length")
            lines.append(f"RequireLength({p['name']}.Length, {f'(ulong){length}' if length else 'count'});")
        elif p["role"] == "out" and p.get("count"):
            lines.append(f"var {p['name']} = new {typed(api, element(p))}[{p['count']}];")
            pins.append(f"fixed ({typed(api, element(p))}* {p['name']}_ = {p['name']})")
        elif p["role"] == "out":
            lines.append(f"var {p['name']} = default({typed(api, element(p))});")
    return lines, pins, alive


def cs_arguments(api, call):
    # Arrays with a length of their own have no element that stands for all.
    templates = TEMPLATES if batch_arrays(call) else {**TEMPLATES, "stride": "SizeOf({array})"}
    args = arguments(call, templates, lambda of: typed(api, of))
    for i, p in enumerate(call.function["parameters"]):
        n = p["name"]
        if p["role"] in ("in", "array") and has_lists(api, element(p)):
            args[i] = f"{n}_.Pointer"
            if p["role"] == "array":
                args[i + 1] = f"{n}_.Stride"
        elif p["role"] == "array" and element(p) == "void":
            args[i] = f"{n}.IsOne ? ({n}One.Mesh == null ? (void*)&{n}One.Data : {n}One.Mesh.Pointer) : {n}First"
        elif "width" in p:
            args[i] = f"(float*){n}_"
    return ", ".join(args)


def pinned(pins, statement, indent):
    """The statement below its fixed statements."""
    return "".join(f"{indent}{pin}\n" for pin in pins) + f"{indent}{statement}\n"


def body(api, call):
    """(type of the result, text)"""
    f, indent = call.function, "        "
    lines, pins, alive = prepare(api, call)
    text = "".join(f"{indent}{line}\n" for line in lines)
    keep = "".join(f"{indent}GC.KeepAlive({a});\n" for a in alive)
    invoke = f"Low.{f['name']}({cs_arguments(api, call)})"
    listed = [p for p in call.outputs if p["role"] in ("list", "ragged")]
    if listed:
        of, ragged = typed(api, element(listed[0])), listed[0]["role"] == "ragged"
        text += f"{indent}var result = new {of}[Guess{' + count' if ragged else ''}];\n"
        text += f"{indent}var offsets = new uint[count + 1];\n" if ragged else ""
        text += f"{indent}for (;;) {{\n" + ("" if ragged else f"{indent}    uint total;\n") + f"{indent}    Status status;\n"
        text += pinned(pins + [f"fixed ({of}* out_ = result)"] + (["fixed (uint* offsets_ = offsets)"] if ragged else []),
                       f"status = {invoke};", indent + "    ")
        text += keep.replace(indent, indent + "    ")
        text += f"{indent}    Check(status);\n" + (f"{indent}    var total = offsets[count];\n" if ragged else "")
        text += f"{indent}    if (status != Status.Incomplete) {{\n{indent}        Array.Resize(ref result, (int)total);\n"
        text += f"{indent}        return {f'new Ragged<{of}>(result, offsets)' if ragged else 'result'};\n{indent}    }}\n"
        text += f"{indent}    result = new {of}[total];\n{indent}}}\n"
        return f"Ragged<{of}>" if ragged else f"{of}[]", text
    outs = [p for p in call.outputs if p["role"] == "out"]
    kinds = [f"{typed(api, element(p))}[]" if p.get("count") else "bool" if element(p) == "int32_t" else typed(api, element(p)) for p in outs]
    results = [f"{p['name']} != 0" if kind == "bool" else p["name"] for p, kind in zip(outs, kinds)]
    kind = "void" if not outs else kinds[0] if len(outs) == 1 else "(" + ", ".join(f"{k} {camel(p['name'])}" for k, p in zip(kinds, outs)) + ")"
    value = "" if not outs else results[0] if len(outs) == 1 else f"({', '.join(results)})"
    if not keep and not f["may_miss"]:
        return kind, text + pinned(pins, f"Check({invoke});", indent) + (f"{indent}return {value};\n" if outs else "")
    if pins:
        text += f"{indent}Status status;\n" + pinned(pins, f"status = {invoke};", indent) + keep
    else:
        text += f"{indent}var status = {invoke};\n" + keep
    if f["may_miss"]:
        reference = kind.endswith("[]")
        text += f"{indent}return Found(status) ? {value} : {'null' if reference else f'({kind}?)null'};\n"
        return kind if reference else kind + "?", text
    text += f"{indent}Check(status);\n" + (f"{indent}return {value};\n" if outs else "")
    return kind, text


def method(api, call):
    kind, text = body(api, call)
    return (docs(call.function["doc"], "    ") +
            f"    public {'' if call.owner else 'static '}unsafe {kind} {camel(call.name)}({signature(api, call)}) {{\n{text}    }}\n")


def objects(api):
    out = [HEADER + "using System;\nusing System.Runtime.InteropServices;\nusing static Gamephys.Support;\n\nnamespace Gamephys {\n"]
    made = creations(api)
    methods = [c for c in calls(api) if c.function["name"] not in BY_HAND]
    others = {handle: list(other_creations(api, handle)) for handle in api["handles"]}
    rename([*methods, *made.values(), *(c for some in others.values() for c in some)])
    for handle in api["handles"]:
        name, constructors = camel(handle), ""
        for creation in [made[handle], *others[handle]]:
            lines, pins, _ = prepare(api, creation)
            text = "".join(f"        {line}\n" for line in [*lines, "IntPtr made;"])
            text += pinned(pins, f"Check(Low.{creation.function['name']}({cs_arguments(api, creation)}));", "        ")
            constructors += (docs(creation.function["doc"], "    ") + f"    public unsafe {name}({signature(api, creation)}) {{\n{text}"
                             f"        Handle = new {name}Handle(made);\n    }}\n\n")
        out.append(f"/// <summary>Owns a {handle}: freed by Dispose, or else by the garbage collector.</summary>\n"
                   f"public sealed partial class {name} : IDisposable {{\n    internal readonly {name}Handle Handle;\n\n" +
                   constructors + "    /// <summary>Frees the object at once. Any use afterwards throws ObjectDisposedException.</summary>\n"
                   "    public void Dispose() { Handle.Dispose(); }\n")
        out += [method(api, call) for call in methods if call.owner == handle]
        out.append("}\n")
    out.append("/// <summary>Questions about single shapes, without a scene.</summary>\npublic static partial class Geometry {")
    out += [method(api, call) for call in methods if not call.owner]
    out.append("}\n\n}")
    return "\n".join(out) + "\n"


def language(api):
    names = {}
    for enum in api["enums"]:
        for value in enum["values"]:
            prefix = common_prefix([v["name"] for v in enum["values"]]) if enum["name"] else ""
            names[value["name"]] = f"{camel(enum['name'])}.{camel(value['name'][len(prefix):])}" if prefix else camel(value["name"])
    return Language(null="null", function=lambda owner, call: f"{owner or 'Geometry'}.{camel(call.name)}", type=camel,
                    constant=lambda name: names.get(name, camel(name)), parameter=lambda name: local(name).lstrip("@"),
                    message="the exception's message", flags=("false", "true"))


def commented(doc, creates):
    """XML: a summary, a param for each parameter, what is returned and thrown."""
    lines = [escaped(line) for line in [*paragraphs(doc, 100), *wrapped(f"Cost: {doc.cost}", 100)]]
    lines[0] = "<summary>" + lines[0]
    lines[-1] += "</summary>"
    for names, text in doc.parameters:
        for name in names.split(", "):
            lines += wrapped(escaped(text) + "</param>", 100, f'<param name="{name}">')
    if outcome(doc, "null"):
        lines += wrapped(escaped(outcome(doc, "null")) + "</returns>", 100, "<returns>")
    for status, when in doc.errors:
        lines += wrapped(escaped(f"{status}: {when}") + "</exception>", 100, '<exception cref="GamephysException">')
    return "\n".join(lines)


def generate(api):
    api = translated(api, language(api), commented)
    return {"csharp/src/Values.cs": values(api), "csharp/src/Low.cs": low(api), "csharp/src/Objects.cs": objects(copy.deepcopy(api)),
            "csharp/tests/Layout.cs": layout(api)}
