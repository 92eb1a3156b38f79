"""Java: native methods for JNA, records for values, classes for settings and objects."""
from ._calls import arguments, batch_arrays
from ._docs import Language, as_tags, as_text, translated
from ._names import (ANSWERS, OF_THE_DESC, SHAPES, base_type, calls, camel, constants, creations, element, lists, lower_camel,
                     other_creations, plain, settable)

HEADER = "// Generated from gamephys_api.json by bindings/generate.py. Not for editing.\npackage gamephys;\n\n"
PRIMITIVES = {"float": "float", "double": "double", "int32_t": "int", "uint32_t": "int", "size_t": "long"}
BOXES = {"float": "Float", "double": "Double", "int": "Integer"}
LAYOUTS = {"float": "Layout.FLOAT", "double": "Layout.DOUBLE", "int": "Layout.INT"}
ACCESS = {"float": "Float", "double": "Double", "int": "Int"}
SLOT = 128  # bytes that Scratch has for one argument
DEFAULTS = {"layers": "Gamephys.ALL_LAYERS", "max_distance": "Float.POSITIVE_INFINITY", "tolerance": "0", "link_length": "0",
            "compliance": "0", "desc": "null", "descs": "null", "filter": "null", "filters": "null", "transform": "null", "transforms": "null", "local_point": "null"}
FLAGS = ("pinned", "keep_world", "reverse_z", "embed_meshes")
TEMPLATES = {
    "self": "self", "handle": "{n}_", "handle?": "{n}_",
    "shape_type": "{shape}.kind()", "shape": "", "in": "", "in?": "", "in_fixed": "", "array": "{n}.pointer()",
    "shape_array": "{n}.pointer()", "stride": "{array}.stride()", "batch_count": "count", "own_count": "{array}.size()",
    "plain_count": "count", "scalar": "{n}", "out": "", "out_fixed": "", "out_array": "room.pointer()", "list": "room",
    "capacity": "capacity", "total": "total", "ragged": "room", "offsets": "offsets", "new": "made",
}


# What records have besides their fields.
EXTRAS = {"Transform": """    /** What moves nothing. */
    public static final Transform IDENTITY = at(new Vec3(0, 0, 0));

    /** A place, neither turned nor scaled. */
    public static Transform at(Vec3 position) {
        return new Transform(position, new Quat(0, 0, 0, 1), 1);
    }

"""}


def name_of(p):
    return lower_camel(p["name"])


def java_type(api, of):
    return PRIMITIVES.get(base_type(api, of)) or camel(of)


def boxed(of):
    return BOXES.get(of, of)


def layout(of):
    return LAYOUTS.get(of, f"{of}.LAYOUT")


def struct(api, of):
    return next((s for s in api["structs"] if s["name"] == of), None)


TAG = "\0"  # stands before the tags of a method's comment, which then needs no <pre>


def doc(text, indent):
    if not text:
        return ""
    for character, escape in (("&", "&amp;"), ("<", "&lt;"), (">", "&gt;"), ("@", "&#64;"), (TAG + "&#64;", TAG + "@"), ("*/", "*&#47;")):
        text = text.replace(character, escape)
    lines = "".join(f"{indent} * {line}".rstrip() + "\n" for line in text.split("\n"))
    if TAG in lines:
        return f"{indent}/**\n{lines.replace(TAG, '')}{indent} */\n"
    return f"{indent}/**\n{indent} * <pre>\n{lines}{indent} * </pre>\n{indent} */\n"


def reading(api, of, at):
    kind = java_type(api, of)
    return f"memory.get{ACCESS[kind]}({at})" if kind in ACCESS else f"{kind}.read(memory, {at})"


def writing(api, of, at, value):
    kind = java_type(api, of)
    return f"memory.put{ACCESS[kind]}({at}, {value});" if kind in ACCESS else f"{value}.write(memory, {at});"


def record(api, s):
    """A record that reads and writes itself in the library's layout."""
    name, size = camel(s["name"]), s["size"][0]
    components, reads, writes, check = [], [], [], ""
    for f in s["fields"]:
        kind, n, at, count = java_type(api, f["type"]), lower_camel(f["name"]), f["offset"][0], f["count"]
        place = f"at + {at}" if at else "at"
        if count == 1:
            components.append(f"{kind} {n}")
            reads.append(reading(api, f["type"], place))
            writes.append(writing(api, f["type"], place, n))
        else:
            step = size_of(api, f["type"])
            components.append(f"java.util.List<{boxed(kind)}> {n}")
            reads.append(f"java.util.stream.IntStream.range(0, {count}).mapToObj(i -> {reading(api, f['type'], f'{place} + {step} * i')}).toList()")
            writes.append(f"for (int i = 0; i < {count}; ++i) {writing(api, f['type'], f'{place} + {step} * i', f'{n}.get(i)')}")
            check += (f"    public {name} {{\n        {n} = java.util.List.copyOf({n});\n"
                      f"        if ({n}.size() != {count}) throw new IllegalArgumentException(\"{name} has {count} elements\");\n    }}\n\n")
    shape = plain(s["name"])
    kind = f"Gamephys.SHAPE_{shape.upper()}" if shape in SHAPES else "0"
    text = HEADER + "import java.nio.ByteBuffer;\n\n" + doc(s["doc"], "")
    text += f"public record {name}({', '.join(components)}) implements {'Shape, ' if shape in SHAPES else ''}Value {{\n"
    text += f"    public static final Layout<{name}> LAYOUT = new Layout<>({size}, {kind}, {name}::read, {name}::write);\n\n{check}{EXTRAS.get(name, '')}"
    text += f"    static {name} read(ByteBuffer memory, int at) {{\n        return new {name}(\n                {(',' + chr(10) + ' ' * 16).join(reads)});\n    }}\n\n"
    text += "    @Override\n    public void write(ByteBuffer memory, int at) {\n" + "".join(f"        {w}\n" for w in writes) + "    }\n"
    if shape in SHAPES:
        text += f"\n    @Override\n    public int kind() {{\n        return {kind};\n    }}\n"
    return text + "}\n"


def size_of(api, of):
    base = base_type(api, of)
    return {"float": 4, "double": 8, "int32_t": 4, "uint32_t": 4}.get(base) or struct(api, base)["size"][0]


def settings(api, s):
    name = camel(s["name"])

    def place(f):
        wide, narrow = f["offset"]
        return str(wide) if wide == narrow else f"Low.pick({wide}, {narrow})"

    wide, narrow = s["size"]
    size = str(wide) if wide == narrow else f"Low.pick({wide}, {narrow})"
    text = HEADER + "import com.sun.jna.Pointer;\nimport java.nio.ByteBuffer;\n\n"
    text += (doc(s["doc"], "") or f"/** Settings: the library's defaults, until one is changed. */\n")
    listed, places = lists(s), {f["name"]: place(f) for f in s["fields"]}
    assert len(listed) < 2, "Listed keeps one"
    text += f"public final class {name}{' extends Listed' if listed else ''} {{\n"
    if any(p["role"] == "array" and element(p) == s["name"] for f in api["functions"] for p in f["parameters"]):
        text += (f"    /** For a Batch of copies: Batch.copyOf, or Batch.shared for one that stands for all. */\n"
                 f"    public static final Layout<{name}> LAYOUT = new Layout<>({size}, 0, {name}::read, {name}::write);\n\n")
        copies = (f"\n    private static {name} read(ByteBuffer memory, int at) {{\n        {name} copy = new {name}();\n"
                  f"        copy.memory.put(0, memory, at, {size});\n        return copy;\n    }}\n\n"
                  f"    private void write(ByteBuffer to, int at) {{\n        to.put(at, memory, 0, {size});\n    }}\n")
    else:
        copies = ""
    text += f"    private final ByteBuffer memory = Batch.direct({size});\n\n"
    text += f"    public {name}() {{\n        Low.check(Low.{s['name']}_init(pointer(), memory.capacity()));\n    }}\n\n"
    text += "    Pointer pointer() {\n        return com.sun.jna.Native.getDirectBufferPointer(memory);\n    }\n"
    for f in settable(s):
        n, about = lower_camel(f["name"]), doc(f["doc"], "    ")
        if f["name"] in listed:
            text += (f"\n{about}    public {name} {n}(int... value) {{\n        Batch<Integer> copy = Batch.ints(value);\n"
                     f"        pointer().setPointer({place(f)}, value.length == 0 ? null : copy.pointer());\n"
                     f"        memory.putInt({places[listed[f['name']]]}, value.length);\n        list = copy;\n        return this;\n    }}\n"
                     f"\n    /** The same from a Batch or another list. */\n    public {name} {n}(java.util.List<Integer> value) {{\n"
                     f"        return {n}(value.stream().mapToInt(Integer::intValue).toArray());\n    }}\n")
            continue
        if "*" in f["type"]:
            text += (f"\n{about}    public {name} {n}(Pointer value) {{\n        pointer().setPointer({place(f)}, value);\n        return this;\n    }}\n")
            continue
        kind = java_type(api, f["type"])
        text += f"\n{about}    public {name} {n}({kind} value) {{\n        {writing(api, f['type'], place(f), 'value')}\n        return this;\n    }}\n"
        text += f"\n    public {kind} {n}() {{\n        return {reading(api, f['type'], place(f))};\n    }}\n"
    return text + copies + "}\n"


def native_type(api, p_type):
    if p_type.startswith("const char"):
        return "String"
    return "Pointer" if "*" in p_type else PRIMITIVES.get(base_type(api, p_type), "void")


def low(api):
    text = HEADER + "import com.sun.jna.Pointer;\n\n/** The C functions. */\nclass LowFunctions {\n    static {\n        Low.load(LowFunctions.class);\n    }\n\n"
    for f in api["functions"]:
        given = ", ".join(f"{native_type(api, p['type'])} {name_of(p)}" for p in f["parameters"])
        text += f"    static native {native_type(api, f['returns'])} {f['name']}({given});\n"
    return text + "}\n"


def given_type(api, p):
    of = java_type(api, element(p))
    if p["role"] == "shape":
        return "Shape"
    if p["role"] == "array":
        return "Shapes" if element(p) == "void" else f"Batch<{boxed(of)}>"
    if p["role"] == "in" and p.get("count"):
        return f"{of}[]"
    return "boolean" if p["name"] in FLAGS else of


def default(p):
    return DEFAULTS.get(p["name"]) if p["role"] in ("scalar", "in", "array") else None


def method(api, call, creation=None):
    """The lines of a method without indent, and those of its shorter forms."""
    f, parameters = call.function, call.function["parameters"]
    lines, scratch = [], False
    words = arguments(call, TEMPLATES, lambda of: of)
    for i, p in enumerate(parameters):
        n, role, of = name_of(p), p["role"], java_type(api, element(p))
        if role == "shape":
            words[i], scratch = f"Low.shape({n}, scratch, {i})", True
        elif role == "shape_type" and parameters[i + 1]["role"] == "array":
            words[i] = f"{name_of(parameters[i + 1])}.kind()"
        elif role == "shape_type":
            words[i] = f"{name_of(parameters[i + 1])}.kind()"
        elif role == "in" and element(p).endswith("_desc"):
            words[i] = f"{n} == null ? null : {n}.pointer()"
        elif role == "in" and p.get("count"):
            words[i], scratch = f"scratch.put({i}, {n}, {p['count']})", True
        elif role == "in":
            words[i], scratch = f"scratch.put({i}, {n})", True
        elif role == "array":
            words[i] = f"Batch.pointer({n})" if p.get("nullable") else f"{n}.pointer()"
        elif role == "stride" and p["name"] == "out_stride":
            words[i] = f"{layout(java_type(api, element(parameters[i - 1])))}.bytes()"
        elif role == "stride":
            array = parameters[i - 1]
            step = f", {4 * array['width']}" if "width" in array else ""
            words[i] = (f"Batch.stride({name_of(array)})" if array.get("nullable") else f"{name_of(array)}.stride({step.lstrip(', ')})")
        elif role == "count" and p["name"] != "count":
            array = [q for q in parameters[:i] if q["role"] == "array"][-1]
            words[i] = f"{name_of(array)}.size()" if "width" not in array else f"{name_of(array)}.size({array['width']})"
        elif role == "out":
            words[i], scratch = f"scratch.slot({i})", True
        elif role == "scalar":
            words[i] = f"{n} ? 1 : 0" if p["name"] in FLAGS else n
    arrays = batch_arrays(call)
    if arrays:
        sizes = [f"{name_of(p)}.common({p['width']})" if "width" in p else
                 f"Batch.common({name_of(p)})" if p.get("nullable") else f"{name_of(p)}.common()" for p in arrays]
        lines.append(f"int count = Low.common({', '.join(sizes)});")
    if scratch:
        lines.insert(0, "Scratch scratch = Scratch.get();")
    fences = [n for n in (["this"] if call.owner and not creation else []) + [
        name_of(p) for i, p in enumerate(parameters)
        if p["role"] == "array" or p["role"] == "shape" or p["role"] == "in" and element(p).endswith("_desc")
        or p["role"] == "handle" and not (i == 0 and call.owner)]]
    fence = f"Low.keep({', '.join(fences)});" if fences else None
    held = [("self" if i == 0 and call.owner and not creation else f"{p['name']}_", "this" if i == 0 and call.owner and not creation
             else name_of(p)) for i, p in enumerate(parameters) if p["role"] == "handle"]
    held += [(None, f"Low.mesh({name_of(p)})") for p in parameters if p["role"] == "shape"]
    held += [(None, f"{name_of(p)}.mesh()") for p in parameters if p["role"] == "array" and element(p) == "void"]
    outs, result_record = call.outputs, ""
    invoke = f"Low.{f['name']}({', '.join(words)})"
    given = [f"{given_type(api, p)} {name_of(p)}" for p in call.inputs]
    defaults = [default(p) for p in call.inputs]
    listed = next((p for p in outs if p["role"] in ("list", "ragged")), None)
    out_array = next((p for p in outs if p["role"] == "out_array"), None)

    def status():
        """The call, during which nobody frees the objects that it uses."""
        text = [f"status = {invoke};"]
        for pointer, object in reversed(held):
            entered = f"Owned.enter({object});"
            text = [f"Pointer {pointer} = {entered}" if pointer else entered, "try {", *(f"    {line}" for line in text),
                    "} finally {", f"    Owned.leave({object});", "}"]
        return (["int status;", *text] if held else [f"int status = {invoke};"]) + ([fence] if fence else [])

    if creation:
        inner = "".join(f"\n        {line}" for line in [*status(), "return status;"])
        lines += [f"return Low.create(made -> {{{inner}\n    }});"]
        kind = "Pointer"
    elif listed:
        of = java_type(api, element(listed))
        call_lines = "{" + "".join(f"\n            {line}" for line in [*status(), "return status;"]) + "\n        }"
        if listed["role"] == "list":
            kind = f"Batch<{boxed(of)}>"
            lines.append(f"return Low.list({layout(of)}, (room, capacity, total) -> {call_lines});")
        else:
            kind = f"Ragged<{boxed(of)}>"
            lines.append(f"return Low.ragged({layout(of)}, count, (room, capacity, offsets) -> {call_lines});")
    elif out_array:
        of = java_type(api, element(out_array))
        kind = f"Batch<{boxed(of)}>"
        given.append(f"{kind} out")
        defaults.append("null")
        lines.append(f"{kind} room = Batch.room({layout(of)}, {out_array.get('length', 'count')}, out);")
        fence = fence[:-2] + ", room);" if fence else "Low.keep(room);"
        lines += [*status(), "Low.check(status);", "return room;"]
    elif f["name"] in ANSWERS:
        kind = "boolean"
        lines += [*status(), f"return Low.answered(status, Gamephys.{plain(ANSWERS[f['name']])});"]
    elif not outs:
        kind = "void"
        lines += [*status(), "Low.check(status);"]
    else:
        types, values = [], []
        for i, p in enumerate(parameters):
            if p["role"] != "out":
                continue
            of = java_type(api, element(p))
            if p.get("count") and of in ACCESS:
                types.append(f"{of}[]")
                values.append(f"scratch.{of}s({i}, {p['count']})")
            elif p.get("count"):
                types.append(f"java.util.List<{of}>")
                values.append(f"scratch.list({i}, {p['count']}, {layout(of)})")
            elif element(p) == "int32_t":
                types.append("boolean")
                values.append(f"scratch.get{ACCESS[of]}({i}) != 0")
            elif of in ACCESS:
                types.append(of)
                values.append(f"scratch.get{ACCESS[of]}({i})")
            else:
                types.append(of)
                values.append(f"{of}.read(scratch.memory, Scratch.at({i}))")
        if len(types) == 1:
            kind, value = types[0], values[0]
        else:
            kind = camel(call.name).removeprefix("Get") + "Result"
            fields = ", ".join(f"{t} {lower_camel(p['name'].removeprefix('out_'))}" for t, p in zip(types, outs))
            result_record = f"/** What {lower_camel(call.name)} returns. */\npublic record {kind}({fields}) {{}}\n\n"
            value = f"new {kind}({', '.join(values)})"
        lines += status()
        if f["may_miss"]:
            lines.append(f"return Low.found(status) ? Optional.of({value}) : Optional.empty();")
            kind = f"Optional<{boxed(kind)}>"
        else:
            lines += ["Low.check(status);", f"return {value};"]
    name = "create" if creation else lower_camel(call.name)
    static = "" if call.owner and not creation else "static "
    visible = "private " if creation else "public "
    body = "".join(f"    {line}\n" for line in lines)
    text = result_record + ("" if creation else doc(f["doc"], ""))
    text += f"{visible}{static}{kind} {name}({', '.join(given)}) {{\n{body}}}\n"
    shorter = []
    short = len(given)
    while short and defaults[short - 1] is not None and not (call.name == "set_layers"):
        short -= 1
        rest = [g.split()[-1] for g in given[:short]] + [cast(given[i], d) for i, d in enumerate(defaults[short:], short)]
        shorter.append((given[:short], rest))
    if creation:
        return text, [(given, [g.split()[-1] for g in given]), *shorter]
    for given_short, rest in shorter:
        back = "" if kind == "void" else "return "
        text += (f"\n/** The same with defaults. */\npublic {static}{kind} {name}({', '.join(given_short)}) {{\n"
                 f"    {back}{name}({', '.join(rest)});\n}}\n")
    return text, None


def factories(handle, call, forms):
    """Static methods. Of constructors the parameters may clash: a Batch is one to Java, whatever its elements are."""
    name = camel(handle)
    text = f"private {name}(Pointer made) {{\n    super(made, Low::{handle}_destroy);\n}}\n"
    for given, rest in forms:
        text += ("\n" + doc(call.function["doc"], "") + f"public static {name} {lower_camel(call.name)}({', '.join(given)}) {{\n"
                 f"    return new {name}(create{camel(call.name)}({', '.join(rest)}));\n}}\n")
    return text


def cast(declaration, value):
    """A null that says of which type it is, where methods are overloaded."""
    return f"({declaration.rsplit(' ', 1)[0]}) null" if value == "null" else value


def indented(text):
    return "".join(f"    {line}".rstrip() + "\n" for line in text.splitlines())


LANGUAGE = Language(null="null", function=lambda owner, call: f"{owner or 'Gamephys'}.{lower_camel(call.name)}", type=camel,
                    constant=plain, parameter=lambda name: lower_camel(name.removeprefix("out_")),
                    message="the exception's message", flags=("false", "true"))


def commented(doc, creates):
    if creates:
        return as_text(doc, "empty", "Throws GamephysException with {}")
    return TAG + as_tags(doc, "empty", "@return", "@throws GamephysException with {}:").replace("\n@", "\n" + TAG + "@")


def generate(api):
    api = translated(api, LANGUAGE, commented)
    folder, files = "java/src/main/java/gamephys/", {}
    largest = max(s["size"][0] for s in api["structs"] if not s["name"].endswith("_desc"))
    assert largest <= SLOT, f"a struct of {largest} bytes: make Scratch larger"
    for s in api["structs"]:
        if s["name"].endswith("_desc"):
            files[f"{folder}{camel(s['name'])}.java"] = settings(api, s)
        elif not any("*" in base_type(api, f["type"]) for f in s["fields"]):
            files[f"{folder}{camel(s['name'])}.java"] = record(api, s)
    files[f"{folder}LowFunctions.java"] = low(api)
    made, every = creations(api), list(calls(api))
    for handle in api["handles"]:
        name, creation = camel(handle), made[handle]
        create, forms = method(api, creation, creation=True)
        text = HEADER + "import com.sun.jna.Pointer;\nimport java.util.Optional;\n\n" + doc(creation.function["doc"], "")
        text += f"public final class {name} extends {name}Base{' implements Shape' if handle == 'gphys_mesh' else ''} {{\n"
        for given, rest in forms:
            text += f"    public {name}({', '.join(given)}) {{\n        super(create({', '.join(rest)}), Low::{handle}_destroy);\n    }}\n\n"
        text += indented(create)
        for c in other_creations(api, handle):
            create, forms = method(api, c, creation=True)
            if not c.name.startswith("from_"):
                create = create.replace(" create(", f" create{camel(c.name)}(", 1)
                text += "\n" + indented(factories(handle, c, forms))
                text += "\n" + indented(create)
                continue
            for given, rest in forms:
                text += "\n" + indented(doc(c.function["doc"], "") + f"public {name}({', '.join(given)}) {{\n    super(create({', '.join(rest)}), Low::{handle}_destroy);\n}}\n")
            text += "\n" + indented(create)
        for c in every:
            if c.owner == handle:
                text += "\n" + indented(method(api, c)[0])
        if handle == "gphys_mesh":
            text += "\n    @Override\n    public int kind() {\n        return Gamephys.SHAPE_MESH;\n    }\n"
        files[f"{folder}{name}.java"] = (text + "}\n").replace(f"{name}Base", "SceneBase" if handle == "gphys_scene" else "Owned")
    text = HEADER + "import java.util.Optional;\n\n/** Constants, and questions about single shapes. */\npublic final class Gamephys extends GamephysBase {\n    private Gamephys() {}\n\n"
    for name, number in constants(api).items():
        if isinstance(number, float):
            text += f"    public static final float {name} = {number!r}f;\n"
        else:
            text += f"    public static final int {name} = {number if number < 2 ** 31 else f'0x{number:08x}'};\n"
    for c in every:
        if not c.owner:
            text += "\n" + indented(method(api, c)[0])
    files[f"{folder}Gamephys.java"] = text + "}\n"
    return files
