"""JavaScript: a reader and a writer for each struct, a class for each handle with a method for each
function, and the two entries of the package, which differ in how the library's memory is reached.
The types of TypeScript are in typescript.py."""
from ._names import (ANSWERS, MASKS, SHAPES, base_type, calls, camel, creations, element, lists, lower_camel, other_creations, plain,
                     settable)

HEAD = "// Generated from gamephys_api.json by bindings/generate.py. Not for editing.\n"
VIEWS = {"float": "f32", "double": "f64", "int32_t": "i32", "uint32_t": "u32"}
SIZES = {"float": 4, "double": 8, "int32_t": 4, "uint32_t": 4}
ARRAYS = ("gphys_vec3", "gphys_quat", "gphys_mat4")  # read as arrays of numbers, written from them too
# What a field is that is not given.
UNSAID = {"gphys_transform": {"position": "[0, 0, 0]", "rotation": "[0, 0, 0, 1]", "scale": "1"},
          "gphys_ray": {"t_max": "Infinity"}, "gphys_obb": {"rotation": "[0, 0, 0, 1]"}}
# What a parameter is that is not given, where none follows that must be.
DEFAULTS = {"layers": "ALL_LAYERS", "max_distance": "Infinity", "tolerance": "0", "link_length": "0", "compliance": "0",
            "first": "0", "count": "rest(this, body, first)", "pinned": "true"}


def checked(name, of, base, called):
    """A number that is what it must be: the check has its name for the message."""
    check = {"float": "real", "double": "real", "int32_t": "flag" if of == "int32_t" else "signed"}.get(
        base, "bits" if called in MASKS else "whole")
    return f"{check}({name}, '{called}')"



class Structs:
    def __init__(self, api):
        self.api = api
        self.by_name = {s["name"]: s for s in api["structs"]}

    def base(self, name):
        return base_type(self.api, name)

    def size(self, name, column):
        return SIZES.get(self.base(name)) or self.by_name[name]["size"][column]

    def is_desc(self, name):
        return name.endswith("_desc")

    def is_data(self, name):
        """Whether nothing in it is a pointer."""
        return all("*" not in self.base(f["type"]) for f in self.by_name[name]["fields"])

    def numbers_in(self, name):
        """The numbers that it consists of: f32, u32 or i32, or '' if of several kinds."""
        base = self.base(name)
        if base in VIEWS:
            return VIEWS[base]
        kinds = {self.numbers_in(f["type"]) for f in self.by_name[name]["fields"]}
        return kinds.pop() if len(kinds) == 1 else ""

    def numbers(self, name):
        """How many four-byte numbers, all pointers apart."""
        return self.size(name, 0) // 4


def indices(struct, field):
    """Where a field stands, in four-byte numbers, as an expression: it may depend on the pointers' size."""
    wide, narrow = (offset // 4 for offset in field["offset"])
    return str(wide) if wide == narrow else f"(v.wide ? {wide} : {narrow})"


def at(index):
    return "at" if index == "0" else f"at + {index}"


def reader(structs, struct):
    def value(field):
        base, where = structs.base(field["type"]), at(indices(struct, field))
        if base in VIEWS:
            view = f"v.{VIEWS[base]}"
            return f"{view}[{where}]" if field["count"] == 1 else f"Array.from({view}.subarray({where}, {where} + {field['count']}))"
        if field["count"] == 1:
            return f"read{camel(base)}(v, {where})"
        return f"Array.from({{ length: {field['count']} }}, (_, i) => read{camel(base)}(v, {where} + {structs.numbers(base)} * i))"

    name, fields = struct["name"], struct["fields"]
    if name in ARRAYS:
        body = value(fields[0]) if len(fields) == 1 else "[" + ", ".join(value(f) for f in fields) + "]"
    else:
        body = "({ " + ", ".join(f"{f['name']}: {value(f)}" for f in fields) + " })"
    return f"export const read{camel(name)} = (v, at) => {body};\n"


def write_field(structs, field, index, value):
    """Statements that write one field at an index: all its elements, if it has several."""
    base = structs.base(field["type"])

    def store(where, x):
        if base in VIEWS:
            return f"v.{VIEWS[base]}[{where}] = {checked(x, field['type'], base, field['name'])};"
        return f"write{camel(base)}(v, {where}, {x});"

    if field["count"] == 1:
        return [store(at(index), value)]
    step = 1 if base in VIEWS else structs.numbers(base)
    where = at(index) + (f" + {step} * i" if step > 1 else " + i")
    return [f"const {field['name']} = {value};",
            f"for (let i = 0; i < {field['count']}; ++i) {store(where, field['name'] + '[i]')}"]


def writer(structs, struct):
    name, fields = struct["name"], struct["fields"]
    lines = [f"export function write{camel(name)}(v, at, value) {{"]
    if len(fields) == 1:  # a matrix: its numbers, or an object with them
        f = fields[0]
        lines += [f"    {line}" for line in
                  write_field(structs, f, "0", f"row(value, {f['count']}, '{plain(name)}') ? value : value.{f['name']} ?? value.elements")]
    else:
        lines.append(f"    const rows = row(value, {len(fields)}, '{plain(name)}');")
        unsaid = UNSAID.get(name, {})
        if unsaid:
            known = ", ".join(f"'{f['name']}'" for f in fields)
            missing = " || ".join(f"value.{field} === undefined" for field in unsaid)
            lines.append(f"    if (!rows && ({missing})) only(value, [{known}], '{plain(name)}');")
        for i, f in enumerate(fields):
            other = f" ?? {unsaid[f['name']]}" if f["name"] in unsaid else ""
            lines += [f"    {line}" for line in
                      write_field(structs, f, indices(struct, f), f"rows ? value[{i}] : value.{f['name']}{other}")]
    return "\n".join(lines) + "\n}\n"


def desc_writer(structs, struct):
    """Fields by name over the library's defaults, which are there already."""
    name = struct["name"]
    lines = [f"export function write{camel(name)}(v, at, value) {{", f"    named(value, '{plain(name)}');",
             "    for (const name in value) {", "        switch (name) {"]
    fields, listed = {f["name"]: f for f in struct["fields"]}, lists(struct)
    for f in settable(struct):
        if f["name"] in listed:
            pointer, count = at(indices(struct, f)), at(indices(struct, fields[listed[f["name"]]]))
            lines += [f"            case '{f['name']}': {{", f"                const {{ address, length }} = v.hold(value[name], '{f['name']}');",
                      f"                v.u32[{pointer}] = address;",
                      f"                if (v.wide) v.u32[{pointer} + 1] = Math.floor(address / 2 ** 32);",
                      f"                v.u32[{count}] = length;", "                break;", "            }"]
            continue
        if "*" in f["type"]:
            continue
        [store] = write_field(structs, f, indices(struct, f), "value[name]")
        lines.append(f"            case '{f['name']}': {store} break;")
    lines.append(f"            default: throw new TypeError(`{plain(name)} has no field ${{name}}`);")
    return "\n".join(lines) + "\n        }\n    }\n}\n"


def structs_file(structs):
    out = [HEAD, """import { bits, flag, real, signed, whole } from './numbers.js';

function named(value, name) {
    if (typeof value !== 'object') throw new TypeError(`expected a ${name}, got ${value}`);
}

/** Refuses a field that is misspelt where those that are missing have a meaning. */
function only(value, fields, name) {
    for (const field in value) if (!fields.includes(field)) throw new TypeError(`${name} has no field ${field}`);
}

/** Whether the fields are given in order, as an array, and not by name. */
function row(value, count, name) {
    if (typeof value !== 'object' || value === null) throw new TypeError(`expected a ${name}, got ${value}`);
    if (value.length === undefined) return false;
    if (value.length !== count) throw new TypeError(`${name}: expected ${count} fields, got ${value.length}`);
    return true;
}

// v: views of memory, at: where in it, counted in numbers of four bytes

"""]
    types = [f"    {plain(b)}: {{ size: {s}, read: (v, at) => v.{VIEWS[b]}[{'at >> 1' if s == 8 else 'at'}] }},\n" for b, s in SIZES.items()]
    for struct in structs.api["structs"]:
        name = struct["name"]
        if structs.is_desc(name):
            out.append(desc_writer(structs, struct))
        elif structs.is_data(name):
            out += [reader(structs, struct), writer(structs, struct)]
            types.append(f"    {plain(name)}: {{ size: {struct['size'][0]}, read: read{camel(name)}, write: write{camel(name)} }},\n")
    out.append("/** What arrays can contain. */\nexport const types = {\n" + "".join(types) + "};\n")
    return "".join(out)


def constants_file(api):
    lines = [HEAD]
    for e in api["enums"]:
        lines += [f"export const {plain(v['name'])} = {v['value']};\n" for v in e["values"]]
    lines += [f"export const {plain(n)} = {v.rstrip('fu') if 'x' not in v else v.rstrip('u')};\n" for n, v in api["constants"].items()]
    return "".join(lines)


class Method:
    """The text of one method. Single values have their places in the memory that calls pass values
    through, given here; arrays and lists get theirs at run time."""

    def __init__(self, structs, call):
        self.structs, self.call = structs, call
        self.parameters = call.function["parameters"]
        self.top = 0
        self.before, self.after, self.results, self.arguments = [], [], [], []
        self.new = self.listed = None
        for i, p in enumerate(self.parameters):
            self.arguments.append(self.argument(i, p))

    def place(self, size, alignment=4):
        self.top = -(-self.top // alignment) * alignment
        place, self.top = self.top, self.top + size
        return place

    def address(self, place):
        return f"base + {place}" if place else "base"

    def is_batch(self):
        return any(p["role"] in ("array", "out_array", "list", "ragged") or self.has_lists(p) for p in self.parameters)

    def has_lists(self, p):
        return self.structs.is_desc(element(p)) and lists(self.structs.by_name[element(p)])

    def counted(self):
        """The arrays whose common length is the count."""
        if not any(p["role"] == "count" and p["name"] == "count" for p in self.parameters):
            return []
        return [p for p in self.parameters if p["role"] == "array"]

    def argument(self, i, p):
        structs, role, name = self.structs, p["role"], p["name"]
        of = structs.base(element(p))
        if role == "handle":
            if i == 0 and self.call.owner:
                return "this.pointer"
            return f"pointer({name}, {camel(of)}, '{name}', {'true' if p.get('nullable') else 'false'})"
        if role == "shape_type":
            shape = self.parameters[i + 1]
            return f"{shape['name']}_.type" if shape["role"] == "array" else f"typeOf({shape['name']})"
        if role == "shape":
            return f"putShape({name}, {self.place(SHAPE_SIZE) // 4})"
        if role == "in":
            return self.given(p, of)
        if role == "array":
            kind = self.input(name, of, structs.size(of, 0) * p.get("width", 1) if of != "void" else 0)
            if name == "indices":
                kind = kind.replace("indices,", "indices ?? ascending(vertices_.length),")
            if p.get("nullable"):
                kind = f"{name} == null ? nothing : {kind}"
            self.before.append(f"const {name}_ = {kind};")
            return f"pass({name}_)"
        if role == "stride":
            other = self.parameters[i - 1]
            if other["role"] == "out_array":
                return str(structs.size(structs.base(element(other)), 0))
            if element(other) == "void" or other.get("nullable"):
                return f"{other['name']}_.stride"
            return str(structs.size(structs.base(element(other)), 0) * other.get("width", 1))
        if role == "count":
            arrays = [q for q in self.parameters if q["role"] == "array"]
            if not arrays or name == "count":
                return "count" if arrays else checked(name, "uint32_t", "uint32_t", name)
            array = [q for q in self.parameters[:i] if q["role"] == "array"][-1]
            return f"{array['name']}_.numbers" if name == "index_count" else f"{array['name']}_.length"
        if role == "out":
            return self.out(p, of)
        if role == "out_array":
            count = p["length"] if p.get("length") else "count"
            self.before.append(f"const {name}_ = output(out, '{plain(of)}', {count});")
            self.results.append(f"finish({name}_)")
            return f"pass({name}_)"
        if role in ("list", "ragged"):
            self.listed = (role, of)
            return "room"
        if role == "capacity":
            return "capacity"
        if role == "total":
            self.total = self.place(4)
            return self.address(self.total)
        if role == "offsets":
            return "pass(offsets)"
        if role == "new":
            self.new = self.place(8, 8)
            return self.address(self.new)
        assert role == "scalar", role
        return checked(name, p["type"], structs.base(of), name)

    def input(self, name, of, bytes):
        if of == "void":
            return f"inputShapes({name})"
        if self.structs.is_desc(of):
            narrow = self.structs.size(of, 1)
            size = bytes if bytes == narrow else f"v.wide ? {bytes} : {narrow}"
            return f"inputDescs({name}, {self.place(bytes, 8) // 4}, {size}, native.{of}_init, write{camel(of)}, '{name}')"
        return f"input({name}, {bytes}, '{name}', '{self.structs.numbers_in(of)}')"

    def given(self, p, of):
        structs, name = self.structs, p["name"]
        if p.get("count"):
            place = self.place(structs.size(of, 0) * p["count"], 8)
            index = place // structs.size(of, 0)
            self.before.append(f"numbers(v.{VIEWS[of]}, {index}, {name}, {p['count']}, '{name}');")
            return self.address(place)
        place = self.place(structs.size(of, 0), 8)
        write = f"write{camel(of)}(v, {place // 4}, {name});"
        if structs.is_desc(of):
            wide, narrow = (structs.size(of, column) for column in (0, 1))
            size = wide if wide == narrow else f"v.wide ? {wide} : {narrow}"
            write = f"check(native.{of}_init({self.address(place)}, {size})); {write}"
        if not p.get("nullable"):
            self.before.append(write)
            return self.address(place)
        self.before.append(f"if ({name} != null) {{ {write} }}")
        return f"{name} == null ? 0 : {self.address(place)}"

    def out(self, p, of):
        structs = self.structs
        size = structs.size(of, 0)
        place = self.place(size * p.get("count", 1), 8 if of == "double" else 4)
        if p.get("count"):
            step = size // (8 if of == "double" else 4)
            first = place // (8 if of == "double" else 4)
            reads = [f"v.{VIEWS[of]}[{first + i}]" if of in VIEWS else f"read{camel(of)}(v, {first + step * i})" for i in range(p["count"])]
            self.results.append("[" + ", ".join(reads) + "]")
        elif of in VIEWS:
            read = f"v.{VIEWS[of]}[{place // size}]"
            self.results.append(f"{read} !== 0" if element(p) == "int32_t" else read)
        else:
            self.results.append(f"read{camel(of)}(v, {place // 4})")
        return self.address(place)

    def signature(self):
        words, optional = [], True
        for p in reversed(self.call.inputs):
            unsaid = DEFAULTS.get(p["name"]) if p["role"] in ("scalar", "count") and self.call.name != "set_layers" else None
            optional = optional and (unsaid is not None or p.get("nullable", False))
            words.insert(0, p["name"] + (f" = {unsaid}" if optional and unsaid else ""))
        if any(p["role"] == "out_array" for p in self.parameters):
            words.append("out")
        return ", ".join(words)

    def body(self):
        lines = list(self.before)
        counted = self.counted()
        if counted:
            words = "".join(f", {p['name']}_" for p in counted)
            first = next(i for i, line in enumerate(lines + ["count"]) if "output(" in line or line == "count")
            lines.insert(first, f"const count = common({words[2:]});")
        if self.is_batch():
            lines.insert(0, "begin();")
        arguments = list(self.arguments)
        if self.listed and self.listed[0] == "ragged":
            lines.append("const offsets = output(undefined, 'uint32_t', count + 1);")
        if self.listed:  # asked again with more room: what is passed stays where it is
            for i, a in enumerate(arguments):
                if a.startswith("pass("):
                    arguments[i] = f"{self.parameters[i]['name']}At"
                    lines.append(f"const {arguments[i]} = {a};")
        call = f"native.{self.call.function['name']}({', '.join(arguments)})"
        if self.listed:
            role, of = self.listed
            if role == "ragged":
                lines.append(f"return ragged('{plain(of)}', offsets, (room, capacity) => {call});")
            else:
                lines.append(f"return list('{plain(of)}', {self.total // 4}, (room, capacity) => {call});")
        elif self.call.function["may_miss"]:
            lines += [f"if (check({call}) !== OK) return null;", f"return {self.result()};"]
        elif self.call.function["name"] in ANSWERS:
            no = plain(ANSWERS[self.call.function["name"]])
            lines += [f"const status = {call};", f"return status !== {no} && check(status) === OK;"]
        else:
            lines.append(f"check({call});")
            if self.new is not None:
                lines.append(f"return made({self.new});")
            elif self.results:
                lines.append(f"return {self.result()};")
        return lines

    def result(self):
        return self.results[0] if len(self.results) == 1 else f"[{', '.join(self.results)}]"


def method(structs, call, indent, prefix=""):
    m = Method(structs, call)
    lines = "".join(f"{indent}    {line}\n" for line in m.body())
    assert m.top <= PASS_BYTES, call.name
    return f"{indent}{prefix}{lower_camel(call.name)}({m.signature()}) {{\n{lines}{indent}}}\n"


SHAPE_SIZE = 108  # of the largest, a frustum
PASS_BYTES = 1024  # of the memory that single values pass through; runtime.js has the same


def names(api):
    """What an entry of the package exports beside the constants."""
    free = [lower_camel(c.name) for c in calls(api) if not c.owner]
    return ([camel(h) for h in api["handles"]] + [s for s in SHAPES if s != "mesh"] + free
            + ["GamephysClosed", "GamephysError", "Records", "Shape", "Shapes", "defaultOrbit", "records", "shapes", "statusName",
               "transform", "version"])


def objects_file(structs):
    api = structs.api
    made = creations(api)
    used = sorted({f"{verb}{camel(s['name'])}" for s in api["structs"] for verb in ("read", "write")
                   if (structs.is_desc(s["name"]) and verb == "write") or (not structs.is_desc(s["name"]) and structs.is_data(s["name"]))})
    body = []
    for h in api["handles"]:
        create = Method(structs, made[h])
        body.append(f"    class {camel(h)} extends Handle {{\n        constructor({create.signature()}) {{\n"
                    f"            super(() => {{\n" + "".join(f"                {line}\n" for line in create.body())
                    + f"            }}, native.{h}_destroy);\n        }}\n")
        for c in other_creations(api, h):
            other = Method(structs, c)
            body.append(f"        static {lower_camel(c.name)}({other.signature()}) {{\n"
                        f"            return Reflect.construct(Handle, [() => {{\n" + "".join(f"                {line}\n" for line in other.body())
                        + f"            }}, native.{h}_destroy], {camel(h)});\n        }}\n")
        body += [method(structs, c, "        ") for c in calls(api) if c.owner == h]
        body.append("    }\n")
    free = [c for c in calls(api) if not c.owner]
    body += [method(structs, c, "    ", "function ") for c in free]
    text = "".join(body)
    used = [u for u in used if f"{u}(" in text]
    shapes = "".join(f"        {s}: (...fields) => new Shape('{s}', fields),\n" for s in SHAPES if s != "mesh")
    return (HEAD + f"import {{ {', '.join(['ALL_LAYERS', *map(plain, ANSWERS.values()), 'OK'])} }} from './constants.js';\n"
            + "import { bits, flag, real, signed, whole } from './numbers.js';\nimport { " + ", ".join(used)
            + " } from './structs.js';\nimport { Shape, runtime } from './runtime.js';\n\n"
            + "/** Everything of the library but constants, over one way to reach its memory and functions. */\n"
            + "export function objects(memory) {\n"
            + "    const { native, v, base, Handle, begin, check, common, finish, input, inputDescs, inputShapes, list, made, nothing,\n"
            + "        numbers, ascending, output, pass, pointer, putShape, ragged, rest, typeOf, more } = runtime(memory);\n\n" + text
            + "    return {\n        " + ", ".join([camel(h) for h in api["handles"]] + [lower_camel(c.name) for c in free]) + ",\n"
            + shapes + "        ...more(Scene, Mesh),\n    };\n}\n")


def signatures_file(structs):
    """How the native functions are called: what they return, and a letter for each parameter."""
    letters = {"float": "f", "double": "d", "int32_t": "i", "uint32_t": "u", "size_t": "z"}
    lines = []
    for f in structs.api["functions"]:
        word = ""
        for p in f["parameters"]:
            if p["role"] in ("array", "out_array", "list", "ragged", "offsets"):
                word += "a"
            elif "*" in p["type"]:
                word += "p"
            else:
                word += letters[structs.base(p["type"])]
        result = {"void": "v", "const char *": "s"}.get(f["returns"]) or letters[structs.base(f["returns"])]
        lines.append(f"    {f['name']}: '{result}{word}',\n")
    return (HEAD + "\n// The result, then the parameters: v nothing, s text, f float, d double, i int32_t, u uint32_t,\n"
            "// z size_t, p an address as a number, a an array.\nexport const signatures = {\n" + "".join(lines) + "};\n")


def entry(api, back_end):
    memory = "wasm_beside" if back_end == "wasm" else f"{back_end}_memory"
    return (HEAD + f"import {{ memory }} from './lib/{memory}.js';\nimport {{ objects }} from './lib/objects.js';\n\n"
            "export * from './lib/constants.js';\nexport const {\n" + "".join(f"    {n},\n" for n in names(api))
            + f"}} = objects({'' if back_end == 'native' else 'await '}memory());\n")


def generate(api):
    structs = Structs(api)
    return {
        "javascript/lib/constants.js": constants_file(api),
        "javascript/lib/structs.js": structs_file(structs),
        "javascript/lib/objects.js": objects_file(structs),
        "javascript/lib/signatures.js": signatures_file(structs),
        "javascript/native.js": entry(api, "native"),
        "javascript/node.js": entry(api, "node"),
        "javascript/wasm.js": entry(api, "wasm"),
    }
