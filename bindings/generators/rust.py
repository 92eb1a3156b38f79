"""Rust: structs and values (types.rs), the C functions (sys.rs), and a method for each function (objects.rs)."""
import re

from ._calls import arguments, batch_arrays
from ._docs import Language, outcome, paragraphs, translated, wrapped
from ._names import BUILT, SHAPES, base_type, calls, camel, common_prefix, creations, element, has_lists, lists, other_creations, plain

HEADER = "// Generated from gamephys_api.json by bindings/generate.py. Not for editing.\n"
NUMBERS = {"float": "f32", "double": "f64", "int32_t": "i32", "uint32_t": "u32", "size_t": "usize", "void": "c_void"}
CALLBACKS = ("gphys_allocator", "gphys_task_runner")
# What is written by hand, because a rule for one function would be longer.
BY_HAND = ("gphys_scene_has",)
# Whose numbers may be given as an array in place of the struct.
VECTORS = ("gphys_vec3", "gphys_quat")
# Where zeros are no useful start, the defaults are written by hand.
# What changes objects that the borrow checker cannot see: what callers must see to.
UNSAFE = {
    "gphys_mesh_set_vertices": "No other thread uses the mesh, nor a scene that has a model of it, meanwhile.",
    "gphys_mesh_create_from_body": "As long as the mesh follows the body, no other thread uses the mesh, nor a scene that has a model of "
                                   "it, while the solver steps, is restored or edits the body."}
OWN_DEFAULT = ("gphys_quat", "gphys_mat4", "gphys_transform", "gphys_orbit")
TEMPLATES = {
    "self": "self.handle.as_ptr()", "handle": "{n}.handle.as_ptr()", "handle?": "{n}.map_or(null_mut(), |o| o.handle.as_ptr())",
    "shape_type": "{shape}.shape_type()", "shape": "{n}.pointer()", "in": "{n}", "in?": "pointer({n})",
    "array": "{n}.data", "shape_array": "{n}.data", "stride": "{array}.stride", "out_array": "{n}.data",
    "batch_count": "count", "own_count": "{array}.count()?", "plain_count": "count", "scalar": "{n}",
    "out": "&mut {n}", "in_fixed": "{n}.as_ptr()", "out_fixed": "{n}.as_mut_ptr()", "list": "{n}", "capacity": "capacity",
    "total": "total", "ragged": "{n}", "offsets": "offsets", "new": "&mut made",
}


def with_life(api, of):
    """A struct's name, with the lifetime of what it points to."""
    return camel(of) + ("<'a>" if has_lists(api, of) else "")


def field_name(name):
    return name + "_" if name == "type" else name


def rust_type(api, of):
    """A number, struct, enum or id; pointers as they are in C."""
    of = of.strip()
    if of.endswith("*"):
        target = rust_type(api, of[:-1].replace("const ", ""))
        return ("*const " if of.startswith("const ") else "*mut ") + target
    return NUMBERS.get(of) or camel(of)


def docs(text, indent=""):
    """The header's comment as rustdoc: parameters as a list, C names and operators as code."""
    if not text:
        return ""
    text = re.sub(r"\b(gphys_\w+(?:\(\))?|GPHYS_\w+)", r"`\1`", text)
    text = re.sub(r"(?<!\w)([a-z_]+(?:\[[^\s`]+?\]+)+)", r"`\1`", text)
    text = re.sub(r"(?m)^\s*@param ([\w, ]+?)  +", r"* `\1`: ", text)
    text = re.sub(r"(?m)@return\s+", r"\n\nReturns ", text)
    text = re.sub(r"(?m)^((?:Cost|Error|Threads):)", r"\n\1", text)
    lines, in_list = [], False
    for line in map(str.strip, text.strip().split("\n")):
        in_list = line.startswith("* ") or in_list and line != ""
        lines.append("  " + line if in_list and not line.startswith("* ") else line)
    text = re.sub(r"\n{3,}", "\n\n", "\n".join(lines))
    return "".join(f"{indent}/// {line}".rstrip() + "\n" for line in text.split("\n"))


def struct(api, s):
    name = s["name"]
    is_desc = name.endswith("_desc")
    derive = "Clone, Copy, Debug" + ("" if is_desc or name in CALLBACKS else ", PartialEq")
    if not is_desc and name not in CALLBACKS + OWN_DEFAULT:
        derive += ", Default"
    listed = lists(s)
    align = '#[cfg_attr(target_pointer_width = "64", repr(align(8)))]\n' if listed else ""  # which a List does not ask for
    out = docs(s["doc"]) + f"#[repr(C)]\n{align}#[derive({derive})]\npub struct {with_life(api, name)} {{\n"
    for f in s["fields"]:
        if f["name"] in listed.values():
            continue
        kind = callback(f["type"]) if "(*)" in f["type"] else rust_type(api, f["type"])
        # What the library reads through is not for safe code to set.
        if is_desc and f["name"] == "struct_size":
            kind = f"Size<{with_life(api, name)}>"
        elif f["name"] in listed:
            kind = f"List<'a, {rust_type(api, element(f))}>"
        elif is_desc and "*" in f["type"]:
            kind = f"Hook<{rust_type(api, element(f))}>"
        kind = f"[{kind}; {f['count']}]" if f["count"] > 1 else kind
        out += docs(f["doc"], "    ") + f"    pub {field_name(f['name'])}: {kind},\n"
    return out + "}\n"


def callback(of):
    """'void (*)(void *, uint32_t)' -> 'unsafe extern "C" fn(*mut c_void, u32)', or NULL"""
    returns, parameters = re.fullmatch(r"(.*)\(\*\)\((.*)\)", of).groups()
    words = [rust_type({}, p) for p in parameters.split(", ")]
    back = "" if returns.strip() == "void" else f" -> {rust_type({}, returns)}"
    return f'Option<unsafe extern "C" fn({", ".join(words)}){back}>'


def types(api):
    out = [HEADER + "use crate::support::{Hook, List, Size};\nuse std::ffi::c_void;\n"]
    for enum in api["enums"]:
        if enum["name"]:
            kind = camel(enum["name"])
            prefix = common_prefix([v["name"] for v in enum["values"]])
            doc = next(t["doc"] for t in api["types"] if t["name"] == enum["name"])
            out.append(docs(doc) + "/// A later library may have values that are not listed here.\n"
                       "#[repr(transparent)]\n#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]\n"
                       f"pub struct {kind}(pub i32);\nimpl {kind} {{")
            for v in enum["values"]:
                out.append(docs(v["doc"], "    ") + f"    pub const {v['name'][len(prefix):]}: {kind} = {kind}({v['value']});")
            out.append("}\n")
        else:
            out += [docs(v["doc"]) + f"pub const {plain(v['name'])}: u32 = {v['value']};" for v in enum["values"]] + [""]
    for name, value in api["constants"].items():
        kind = "f32" if value.endswith("f") and not value.startswith("0x") else "u32"
        out.append(f"pub const {plain(name)}: {kind} = {value.rstrip('u') if kind == 'u32' else value.rstrip('f')};")
    for t in api["types"]:
        if base_type(api, t["name"]) == "uint32_t":
            out.append(docs(t["doc"]) + f"pub type {camel(t['name'])} = u32;")
    for c in api["callbacks"]:
        out.append(docs(c["doc"]) + f"pub type {camel(c['name'])} = {callback(c['type'])};")
    out.append("")
    out += [struct(api, s) for s in api["structs"]]
    out.append("// The layouts are those of C, or this does not compile.")
    for i, width in enumerate(api["widths"]):
        out.append(f'#[cfg(target_pointer_width = "{width}")]\nconst _: () = {{')
        out += [f"    assert!(std::mem::size_of::<{camel(s['name'])}>() == {s['size'][i]});" for s in api["structs"]]
        out.append("};")
    out.append('#[cfg(all(test, target_pointer_width = "64"))]\n#[test]\nfn fields_stand_where_c_has_them() {')
    for s in api["structs"]:
        out.append(f"    let s = std::mem::MaybeUninit::<{camel(s['name'])}>::uninit();\n    let p = s.as_ptr();")
        out += [f"    assert_eq!(unsafe {{ std::ptr::addr_of!((*p).{field_name(f['name'])}) }} as usize - p as usize, {f['offset'][0]});"
                for f in s["fields"] if f["name"] not in lists(s).values()]
    out.append("}\n")
    return "\n".join(out)


def sys(api):
    out = [HEADER + "//! The C functions as they are.\n\nuse crate::types::*;\nuse std::ffi::c_void;\nuse std::os::raw::c_char;\n"]
    for handle in api["handles"]:
        out.append(f"#[repr(C)]\npub struct {handle} {{\n    _opaque: [u8; 0],\n}}")
    out.append('\n#[link(name = "gamephys")]\nextern "C" {')
    for f in api["functions"]:
        words = [f"{field_name(p['name'])}: {c_parameter(api, p)}" for p in f["parameters"]]
        returns = {"void": "", "const char *": " -> *const c_char"}.get(f["returns"], f" -> {rust_type(api, f['returns'])}")
        out.append(f"    pub fn {f['name']}({', '.join(words)}){returns};")
    out.append("}\n")
    return "\n".join(out)


def c_parameter(api, p):
    of = p["type"]
    stars = of.count("*")
    if not stars:
        return rust_type(api, of)
    target = element(p)
    target = target if target in api["handles"] else item(api, p)
    # Handles are written through by no caller: *mut is what owners hold.
    inner = "*mut " if target in api["handles"] or not of.startswith("const ") else "*const "
    return "*mut " * (stars - 1) + inner + target


def has_stride(call, p):
    following = call.function["parameters"]
    i = following.index(p)
    return i + 1 < len(following) and following[i + 1]["role"] == "stride"


def item(api, p):
    of = rust_type(api, element(p))
    return {3: "Vec3", 2: "[f32; 2]"}[p["width"]] if "width" in p else of


def parameter(api, call, p):
    of, n = rust_type(api, element(p)), field_name(p["name"])
    if p["role"] == "shape":
        return f"{n}: &dyn Shape"
    if p["role"] == "array":
        if element(p) == "void":
            return f"{n}: impl Into<Shapes<'a>>"
        return f"{n}: impl Into<Batch<'a, {with_life(api, element(p)) if has_lists(api, element(p)) else item(api, p)}>>" if has_stride(call, p) else f"{n}: &[{of}]"
    if p["role"] == "handle":
        reference = "&" if p["type"].startswith("const ") else "&mut "
        return f"{n}: Option<{reference}{of}>" if p.get("nullable") else f"{n}: {reference}{of}"
    if p.get("count"):
        return f"{n}: &[{of}; {p['count']}]"
    if p["role"] == "in" and p.get("nullable"):
        return f"{n}: Option<&{of}>"
    if p["role"] == "in":
        return f"{n}: impl Into<{of}>" if element(p) in VECTORS else f"{n}: &{of}"
    return f"{n}: bool" if p["type"] == "int32_t" else f"{n}: {rust_type(api, p['type'])}"


def result(api, call):
    """(type, value) of what a method returns."""
    outs = [p for p in call.outputs if p["role"] == "out"]
    words = [(f"[{rust_type(api, element(p))}; {p['count']}]", p["name"]) if p.get("count") else
             ("bool", f"{p['name']} != 0") if element(p) == "int32_t" else
             (rust_type(api, element(p)), p["name"]) for p in outs]
    if len(words) == 1:
        return words[0]
    return f"({', '.join(w[0] for w in words)})", f"({', '.join(w[1] for w in words)})"


def counted_by_out(call):
    """Whether the array for results says how many elements there are."""
    return (any(p["name"] == "count" for p in call.inputs) and
            any(p["role"] == "out_array" and not p.get("length") for p in call.outputs))


def prepare(api, call):
    """The statements before the C call: everything that it points to gets a place."""
    lines = []
    for p in call.inputs:
        n = field_name(p["name"])
        if p["role"] == "array":
            lines.append(f"let {n} = {n}.into();" if has_stride(call, p) else f"let {n} = Batch::from({n});")
        elif p["role"] == "in" and element(p) in VECTORS and not p.get("nullable"):
            lines.append(f"let {n} = &{n}.into();")
        elif p["role"] == "scalar" and p["type"] == "int32_t":
            lines.append(f"let {n} = i32::from({n});")
    for p in call.outputs:
        if p["role"] == "out_array":
            lines.append(f"let {p['name']} = {p['name']}.into();" if has_stride(call, p) else
                         f"let {p['name']} = BatchMut::from({p['name']});")
    if counted_by_out(call):
        lines.append(f"let count = {call.outputs[0]['name']}.count()?;")
    arrays = batch_arrays(call)
    if arrays:
        lines.append(f"let count = common_length(&[{', '.join(p['name'] + '.length' for p in arrays)}])?;")
    for p in call.outputs:
        if p["role"] == "out_array" and not counted_by_out(call):
            length = p.get("length")
            length = " * ".join(f"u64::from({w})" for w in length.split(" * ")) if length else "count.into()"
            lines.append(f"{p['name']}.require({length})?;")
    return lines


def signature(api, call, receiver):
    words = [receiver] if receiver else []
    words += [parameter(api, call, p) for p in call.inputs if not (p["name"] == "count" and counted_by_out(call))]
    for p in call.outputs:
        if p["role"] == "out_array":
            of = rust_type(api, element(p))
            words.append(f"{p['name']}: impl Into<BatchMut<'a, {of}>>" if has_stride(call, p) else f"{p['name']}: &mut [{of}]")
    words = ", ".join(words)
    return ("<'a>" if "'a" in words else "") + f"({words})"


def method(api, call):
    f, indent = call.function, "    " if call.owner else ""
    const = f["parameters"][0]["type"].startswith("const")
    receiver = ("&self" if const else "&mut self") if call.owner else None
    args = arguments(call, {**TEMPLATES, "scalar": "{n}"}, lambda of: rust_type(api, of))
    args = [field_name(a) for a in args]
    lines = prepare(api, call)
    name = f"sys::{f['name']}"
    listed = [p for p in call.outputs if p["role"] in ("list", "ragged")]
    if listed:
        of, n = rust_type(api, element(listed[0])), listed[0]["name"]
        ragged = listed[0]["role"] == "ragged"
        kind = f"Ragged<{of}>" if ragged else f"Vec<{of}>"
        lines.append(f"{'ragged(count, ' if ragged else 'list('}|{n}, capacity, {'offsets' if ragged else 'total'}| "
                     f"unsafe {{ {name}({', '.join(args)}) }})")
    else:
        kind, value = result(api, call)
        for p in call.outputs:
            if p["role"] == "out":
                of = rust_type(api, element(p))
                lines.append(f"let mut {p['name']} = " + (f"[{of}::default(); {p['count']}];" if p.get("count") else f"{of}::default();"))
        invoke = f"unsafe {{ {name}({', '.join(args)}) }}"
        if f["may_miss"]:
            kind = f"Option<{kind}>"
            lines.append(f"Ok(found({invoke})?.then_some({value}))")
        elif value == "()":
            lines.append(f"check({invoke})")
        else:
            lines += [f"check({invoke})?;", f"Ok({value})"]
    text, keyword = introduction(f, indent)
    text += f"{indent}pub {keyword} {call.name}{signature(api, call, receiver)} -> Result<{kind}> {{\n"
    return text + "".join(f"{indent}    {line}\n" for line in lines) + indent + "}\n"


def introduction(function, indent):
    """Its comment, and the keyword that it begins with."""
    text = docs(function["doc"], indent)
    if function["name"] not in UNSAFE:
        return text, "fn"
    safety = "\n".join(wrapped(UNSAFE[function["name"]], 100))
    return text + f"{indent}///\n" + docs("# Safety\n" + safety, indent), "unsafe fn"


def constructor(api, s):
    name, words, values = camel(s["name"]), [], []
    for f in s["fields"]:
        vector = f["type"] in VECTORS
        words.append(f"{f['name']}: " + (f"impl Into<{camel(f['type'])}>" if vector else rust_type(api, f["type"])))
        values.append(f"{f['name']}: {f['name']}.into()" if vector else f["name"])
    return (f"impl {name} {{\n    pub fn new({', '.join(words)}) -> {name} {{\n"
            f"        {name} {{ {', '.join(values)} }}\n    }}\n}}\n")


def objects(api):
    out = [HEADER + "use crate::shapes::*;\nuse crate::support::*;\nuse crate::sys;\nuse crate::types::*;\nuse std::ffi::c_void;\nuse std::ptr::{null_mut, NonNull};\n"]
    out += [constructor(api, s) for s in api["structs"] if s["name"] in BUILT]
    for s in api["structs"]:
        if s["name"].endswith("_desc"):
            name = camel(s["name"])
            life = "<'_>" if lists(s) else ""
            out.append(f"impl Default for {name}{life} {{\n    /// The defaults of the loaded library.\n    fn default() -> Self {{\n"
                       f"        initialized(|desc| unsafe {{ sys::{s['name']}_init(desc, std::mem::size_of::<{name}>() as u32) }})\n    }}\n}}\n")
    shapes = [s for s in SHAPES if s != "mesh"]
    out += [f"plain_shape!({camel(s)}, {s.upper()}, {'Obb' if s == 'aabb' else camel(s)});" for s in shapes]
    out.append("\n/// A shape of any kind.\n#[derive(Clone, Copy, Debug, PartialEq)]\n#[non_exhaustive]\npub enum AnyShape {")
    out += [f"    {camel(s)}({camel(s)})," for s in shapes]
    out.append("}\n\nimpl AnyShape {\n    pub(crate) fn read(kind: ShapeType, read: impl FnOnce(*mut c_void, u32) -> Result<()>) -> Result<AnyShape> {\n"
               "        match kind {")
    out += [f"            ShapeType::{s.upper()} => read_plain::<{camel(s)}>(read)," for s in shapes]
    # The library knows why there is no struct of this kind.
    out.append("            _ => read_plain::<Sphere>(read),\n        }\n    }\n}\n")
    made = creations(api)
    methods = [c for c in calls(api) if c.function["name"] not in BY_HAND]
    for handle in api["handles"]:
        name = camel(handle)
        out.append(f"/// Owns a `{handle}` and frees it when dropped.\n#[derive(Debug)]\npub struct {name} {{\n"
                   f"    pub(crate) handle: NonNull<sys::{handle}>,\n}}\n")
        out.append(f"// Functions that take a const object may run at the same time: they take &self here, all others &mut self.\n"
                   f"unsafe impl Send for {name} {{}}\nunsafe impl Sync for {name} {{}}\n")
        out.append(f"impl Drop for {name} {{\n    fn drop(&mut self) {{\n        unsafe {{ sys::{handle}_destroy(self.handle.as_ptr()) }}\n    }}\n}}\n")
        out.append(f"impl {name} {{")
        for word, creation in [("new", made[handle]), *((c.name, c) for c in other_creations(api, handle))]:
            args = ", ".join(arguments(creation, TEMPLATES, str))
            lines = prepare(api, creation) + ["let mut made = null_mut();", f"check(unsafe {{ sys::{creation.function['name']}({args}) }})?;",
                                              f"Ok({name} {{ handle: NonNull::new(made).expect(\"a created object\") }})"]
            text, keyword = introduction(creation.function, "    ")
            out.append(text + f"    pub {keyword} {word}{signature(api, creation, None)} -> Result<{name}> {{\n" + "".join(f"        {line}\n" for line in lines) + "    }\n")
        out += [method(api, call) for call in methods if call.owner == handle]
        out.append("}\n")
    out += [method(api, call) for call in methods if not call.owner]
    return "\n".join(out)


def language(api):
    names = {}
    for enum in api["enums"]:
        for value in enum["values"]:
            prefix = common_prefix([v["name"] for v in enum["values"]]) if enum["name"] else ""
            names[value["name"]] = f"{camel(enum['name'])}::{value['name'][len(prefix):]}" if prefix else plain(value["name"])
    return Language(null="None", function=lambda owner, call: f"`{owner[1:-1]}::{call.name}`" if owner else f"`{call.name}`",
                    type=lambda name: f"`{camel(name)}`", constant=lambda name: f"`{names.get(name, plain(name))}`",
                    parameter=lambda name: name.removeprefix("out_"), flags=("false", "true"))


def commented(doc, creates):
    """As rustdoc has it: parameters as a list, errors in a section of their own."""
    lines = paragraphs(doc, 100) + ["", *wrapped(f"Cost: {doc.cost}", 100)]
    if doc.parameters:
        lines.append("")
    for names, text in doc.parameters:
        names = ", ".join(f"`{name}`" for name in names.split(", "))
        lines += wrapped(text, 100, f"* {names}: ", "  ")
    if outcome(doc, "`None`"):
        lines += ["", *wrapped(f"Returns {outcome(doc, '`None`')}", 100)]
    if doc.errors:
        lines += ["", "# Errors"]
    for status, when in doc.errors:
        lines += wrapped(when, 100, f"* {status}: ", "  ")
    return "\n".join(lines)


def generate(api):
    api = translated(api, language(api), commented)
    return {"rust/src/types.rs": types(api), "rust/src/sys.rs": sys(api), "rust/src/objects.rs": objects(api)}
