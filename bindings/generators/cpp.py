"""C++: a header of classes over the C interface. Structs are the C ones under shorter names."""
import re

from ._calls import arguments, batch_arrays, comment
from ._docs import Language, as_text, translated
from ._names import ANSWERS, SHAPES, base_type, calls, camel, creations, element, lists, other_creations

HEADER = """// SPDX-FileCopyrightText: 2026 The gamephys authors
// SPDX-License-Identifier: MIT
// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
"""
TEMPLATES = {
    "self": "handle()", "handle": "{n}.handle()", "handle?": "optional_handle({n})",
    "shape_type": "{shape}.type", "shape": "{n}.pointer", "in": "&{n}", "in?": "{n}",
    "array": "{n}.data", "packed_array": "{n}.contiguous(\"{n}\")", "shape_array": "{n}.data", "stride": "{array}.stride", "out_array": "{n}.data",
    "batch_count": "count", "own_count": "{array}.size", "plain_count": "count", "scalar": "{n}",
    "out": "&{n}", "in_fixed": "{n}.data()", "out_fixed": "{n}.data()", "list": "{n}", "capacity": "capacity", "total": "total",
    "ragged": "{n}", "offsets": "offsets", "new": "&made",
}


def cpp_type(api, of):
    return of if of in ("float", "double") or base_type(api, of).endswith("_t") else camel(of)


def parameter(api, p, last):
    of, n = cpp_type(api, element(p)), p["name"]
    if p["role"] == "shape":
        return f"ShapeRef {n}"
    if p["role"] == "array":
        return f"ShapeSpan {n}" if element(p) == "void" else f"Span<const {of}> {n}" + (" = {}" if last and p.get("nullable") else "")
    if p["role"] == "handle":
        const = "const " if p["type"].startswith("const ") else ""
        return f"{const}{of}* {n}" if p.get("nullable") else f"{const}{of}& {n}"
    if p.get("count"):
        return f"const std::array<{of}, {p['count']}>& {n}"
    if p["role"] == "in":
        return f"const {of}* {n}" + (" = nullptr" if last else "") if p.get("nullable") else f"const {of}& {n}"
    text = f"{cpp_type(api, p['type'])} {n}"
    return text + " = GPHYS_ALL_LAYERS" if last and n == "layers" else text


def parameters(api, call):
    """The last ones may have defaults, unless spans for results follow."""
    outs = [f"Span<{cpp_type(api, element(p))}> {p['name']}" for p in call.outputs if p["role"] == "out_array"]
    words, last = [], not outs
    for p in reversed(call.inputs):
        text = parameter(api, p, last)
        last = last and " = " in text
        words.insert(0, text)
    return ", ".join(words + outs)


def result(api, call):
    """(type, declarations, value) of what a method returns."""
    outs = [p for p in call.outputs if p["role"] == "out"]
    if not outs:
        return "void", [], ""
    types = [f"std::array<{cpp_type(api, element(p))}, {p['count']}>" if p.get("count") else cpp_type(api, element(p)) for p in outs]
    names = [p["name"] for p in outs]
    declared = [f"{t} {n}{{}};" for t, n in zip(types, names)]
    if len(outs) == 1:
        kind, value = types[0], names[0]
    else:
        kind, value = f"std::tuple<{', '.join(types)}>", f"std::make_tuple({', '.join(names)})"
    if element(outs[0]) == "int32_t" and len(outs) == 1:
        kind, value = "bool", f"{value} != 0"
    return kind, declared, value


def method(api, call):
    f = call.function
    args = arguments(call, TEMPLATES, lambda of: cpp_type(api, of))
    listed = [p for p in call.outputs if p["role"] in ("list", "ragged")]
    out_array = [p for p in call.outputs if p["role"] == "out_array"]
    const = " const" if call.owner and f["parameters"][0]["type"].startswith("const") else ""
    inline = "" if call.owner else "inline "
    lines, indent = [], "    " if call.owner else ""
    arrays = batch_arrays(call)
    if arrays:
        lines.append(f"const uint32_t count = common_size({{{', '.join(p['name'] + '.sizes()' for p in arrays)}}});")
    for p in out_array:
        length = f.get("length") or p.get("length") or "count"
        if not arrays and length == "count":
            pass
        lines.append(f"require_size({p['name']}.size, {length});")
    name = f["name"]
    if listed:
        of = cpp_type(api, element(listed[0]))
        kind = f"Ragged<{of}>" if listed[0]["role"] == "ragged" else f"std::vector<{of}>"
        tail = "uint32_t* total" if listed[0]["role"] == "list" else "uint32_t* offsets"
        extra = "" if listed[0]["role"] == "list" else ", count"
        lines.append(f"return {'list' if not extra else 'ragged'}<{of}>([&]({of}* {listed[0]['name']}, uint32_t capacity, {tail}) "
                     f"{{ return {name}({', '.join(args)}); }}{extra});")
    else:
        kind, declared, value = result(api, call)
        lines += declared
        if name in ANSWERS:
            kind = "bool"
            lines.append(f"const gphys_status status = {name}({', '.join(args)});")
            lines.append(f"return status != {ANSWERS[name]} && found(status);")
        elif f["may_miss"]:
            kind = f"std::optional<{kind}>"
            lines.append(f"if (!found({name}({', '.join(args)}))) return std::nullopt;")
        else:
            lines.append(f"check({name}({', '.join(args)}));")
        if value:
            lines.append(f"return {value};")
    text = comment(f["doc"], indent + "//")
    text += f"{indent}{inline}{kind} {call.name}({parameters(api, call)}){const} {{\n"
    text += "".join(f"{indent}    {line}\n" for line in lines)
    return text + f"{indent}}}\n"


def with_list(api, struct, pointer, count):
    """The defaults with a list in them; a vector that is about to go is refused."""
    name, short = camel(struct["name"]), struct["name"][6:]
    of = cpp_type(api, element(next(f for f in struct["fields"] if f["name"] == pointer)))
    return (f"// The same with {pointer}, to which the result points: they have to stay as long as it is used.\n"
            f"inline {name} {short}(Span<const {of}> {pointer}) {{\n    {name} desc = {short}();\n"
            f"    desc.{pointer} = {pointer}.contiguous(\"{pointer}\");\n    desc.{count} = {pointer}.size;\n    return desc;\n}}\n"
            f"inline {name} {short}(std::vector<{of}>&& {pointer}) = delete;")


# What needs more than its declaration.
SCENE_EXTRA = """    // A model's shape in its own coordinates; S is that shape's struct, else std::invalid_argument. An Error for a
    // mesh, which Mesh(scene, model) gives.
    template <class S>
    S get_shape(gphys_model_id model) const {
        S shape{};
        const gphys_shape_type type = get_info(model).type;
        if (type != GPHYS_SHAPE_MESH && type != ShapeRef(shape).type) throw std::invalid_argument("a shape of another kind");
        check(gphys_scene_get_shape(handle(), model, &shape, sizeof shape));
        return shape;
    }
"""
EXTRA = """// The shape moved; an Aabb becomes an Obb.
template <class S>
auto transform(const S& shape, const Transform& by) {
    std::conditional_t<std::is_same_v<S, Aabb>, Obb, S> moved{};
    check(gphys_shape_transform(ShapeRef(shape).type, &shape, &by, &moved));
    return moved;
}
// The orbit settings that the library starts from.
inline Orbit orbit() {
    Orbit settings;
    check(gphys_orbit_init(&settings));
    return settings;
}
"""


# Values keep their C names, which the C header below defines.
LANGUAGE = Language(null="nullptr", function=lambda owner, call: f"{owner or 'gamephys'}::{call.name}", type=camel,
                    constant=lambda name: name, parameter=lambda name: name, message="the exception's message")


def generate(api):
    api = translated(api, LANGUAGE, lambda doc, creates: as_text(doc, "std::nullopt", "Throws Error with {}"))
    out = [HEADER + '#ifndef GAMEPHYS_HPP\n#define GAMEPHYS_HPP\n\n#include "gamephys_support.hpp"\n\nnamespace gamephys {\n']
    for struct in api["structs"]:
        out.append(f"using {camel(struct['name'])} = {struct['name']};")
    out.append("")
    for struct in api["structs"]:
        name = struct["name"]
        if name.endswith("_desc"):
            out.append(f"inline {camel(name)} {name[6:]}() {{\n    {camel(name)} desc;\n"
                       f"    check({name}_init(&desc, sizeof desc));\n    return desc;\n}}")
        out += [with_list(api, struct, pointer, count) for pointer, count in lists(struct).items()]
    out.append("\nstruct ShapeRef;\nstruct ShapeSpan;\n")
    made = creations(api)
    methods = list(calls(api))
    for handle in api["handles"]:
        out.append(f"class {camel(handle)};")
    shapes = [s for s in SHAPES if s != "mesh"]
    body = "".join(f"    ShapeRef(const gphys_{s}& shape) : type(GPHYS_SHAPE_{s.upper()}), pointer(&shape) {{}}\n" for s in shapes)
    out.append("\n// A shape of any kind, for the time of a call.\nstruct ShapeRef {\n    gphys_shape_type type;\n"
               "    const void* pointer;\n" + body + "    ShapeRef(const Mesh& mesh);\n};\n")
    body = "".join(f"    ShapeSpan(Span<const gphys_{s}> shapes) : type(GPHYS_SHAPE_{s.upper()}), data(shapes.data), "
                   f"stride(shapes.stride), size(shapes.size) {{}}\n" for s in shapes)
    body += "".join(f"    ShapeSpan(const gphys_{s}& shape) : ShapeSpan(ShapeRef(shape)) {{}}\n" for s in shapes)
    body += ("    template <class C, class T = ElementOf<C>>\n"
             "    ShapeSpan(const C& shapes) : ShapeSpan(Span<const T>(shapes)) {}\n")
    out.append("// An array of shapes of one kind, or one shape that stands for each of them.\nstruct ShapeSpan {\n"
               "    gphys_shape_type type;\n    const void* data;\n    uint32_t stride = 0;\n"
               "    uint32_t size = 1;\n    uint32_t sizes() const { return stride ? size : ANY_SIZE; }\n" + body +
               "    ShapeSpan(ShapeRef shape) : type(shape.type), data(shape.pointer) {}\n"
               "    ShapeSpan(const Mesh& mesh) : ShapeSpan(ShapeRef(mesh)) {}\n};\n")
    defined = []
    for handle in api["handles"]:
        out.append(f"class {camel(handle)} : public Object<{handle}, {handle}_destroy> {{\npublic:")
        for creation in [made[handle], *other_creations(api, handle)]:
            name, head = camel(handle), comment(creation.function["doc"], "    //") + "    explicit "
            body = (f"{{\n    {handle}* made = nullptr;\n"
                    f"    check({creation.function['name']}({', '.join(arguments(creation, TEMPLATES, str))}));\n    own(made);\n}}\n")
            if any(p["role"] == "handle" for p in creation.inputs):  # its class comes later
                out.append(f"{head}{name}({parameters(api, creation)});\n")
                words = re.sub(r" = \w+", "", parameters(api, creation))
                defined.append(f"inline {name}::{name}({words}) {body}")
            else:
                out.append(f"{head}{name}({parameters(api, creation)}) " + body.replace("\n", "\n    ").rstrip() + "\n")
        out += [method(api, call) for call in methods if call.owner == handle]
        if handle == "gphys_scene":
            out.append(SCENE_EXTRA)
        out.append("};\n")
        if handle == "gphys_mesh":
            out.append("inline ShapeRef::ShapeRef(const Mesh& mesh) : type(GPHYS_SHAPE_MESH), pointer(mesh.handle()) {}\n")
    out += defined
    out += [method(api, call) for call in methods if not call.owner]
    out.append(EXTRA)
    out.append("} // namespace gamephys\n\n#endif\n")
    return {"cpp/gamephys/gamephys.hpp": "\n".join(out)}
