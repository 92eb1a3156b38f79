"""What the generators of all languages share: names, and functions as their users see them."""
from dataclasses import dataclass, field

SHAPES = ("sphere", "capsule", "aabb", "obb", "plane", "triangle", "frustum", "mesh", "ray", "segment")
# Structs that users build: they get a constructor.
BUILT = tuple(f"gphys_{s}" for s in SHAPES if s not in ("mesh", "frustum")) + ("gphys_vec3", "gphys_quat", "gphys_transform")

# Masks of bits, which languages with signed numbers write as ~1 or 1 << 31, too.
MASKS = ("layers", "body_layers", "flags", "cloth_flags")

# Fields of descs that are not for users to set.
OF_THE_DESC = ("struct_size", "reserved")


def element(parameter):
    """'const gphys_ray *' -> 'gphys_ray'"""
    return parameter["type"].replace("const ", "").rstrip("* ").strip()


def plain(name):
    """'gphys_scene_desc' -> 'scene_desc', 'GPHYS_OK' -> 'OK'"""
    return name[6:] if name[:6].lower() == "gphys_" else name


def camel(name):
    """'gphys_scene_desc' -> 'SceneDesc'"""
    return "".join(word.capitalize() for word in plain(name).split("_"))


def lower_camel(name):
    """'gphys_raycast_batch' -> 'raycastBatch'"""
    text = camel(name)
    return text[:1].lower() + text[1:]


def lists(struct):
    """The lists among a desc's fields: a pointer's name -> that of its count, which is the next field."""
    fields = struct["fields"]
    return {f["name"]: count["name"] for f, count in zip(fields, fields[1:])
            if f["type"].startswith("const ") and f["type"].endswith("*") and count["name"].endswith("_count") and f["name"].endswith("s")}


def has_lists(api, name):
    return any(lists(s) for s in api["structs"] if s["name"] == name)


def settable(struct):
    """The fields that users set: the length of a list goes with the list."""
    lengths = lists(struct).values()
    return [f for f in struct["fields"] if f["name"] not in OF_THE_DESC and f["name"] not in lengths]


def base_type(api, name):
    """A typedef of a number resolved: 'gphys_model_id' -> 'uint32_t'."""
    return next((t["type"] for t in api["types"] if t["name"] == name), name)


def common_prefix(names):
    """'GPHYS_SIDE_' of GPHYS_SIDE_INSIDE, ...: up to the last underscore that all share."""
    first, last = min(names), max(names)
    n = next((i for i, (a, b) in enumerate(zip(first, last)) if a != b), len(first))
    return first[:first.rindex("_", 0, n) + 1]


# Functions whose status is the answer: OK is yes, the status here is no.
ANSWERS = {"gphys_scene_has": "GPHYS_ERROR_INVALID_ID"}


@dataclass
class Call:
    """A C function as a method of an object, or as a free function when owner is None."""

    function: dict
    owner: str  # a handle such as gphys_scene, or None
    name: str  # without prefix and owner
    inputs: list = field(default_factory=list)  # parameters that the user gives, descs last
    outputs: list = field(default_factory=list)  # parameters that become results


def is_created(function):
    return any(p["role"] == "new" for p in function["parameters"])


def calls(api):
    """Every function that fits the conventions, except those that make and destroy objects and
    descs, and the three without a status."""
    for function in api["functions"]:
        parameters = function["parameters"]
        name = function["name"]
        if function["returns"] != "gphys_status" or name.endswith("_init") or is_created(function):
            continue
        if any(p["role"] == "raw" for p in parameters):
            continue
        yield as_call(api, function)


def created_handle(function):
    return next(element(p) for p in function["parameters"] if p["role"] == "new")


def creations(api):
    """handle -> its create function as a Call."""
    return {h: as_call(api, f) for f in api["functions"] if is_created(f) for h in [created_handle(f)]
            if f["name"] == f"{h}_create"}


def other_creations(api, handle):
    """What else makes such an object, or gives another reference to one: Calls without an owner, with names such as
    'from_snapshot' or, of the object that has it, 'from_scene'."""
    for f in api["functions"]:
        if not is_created(f) or created_handle(f) != handle or f["name"] == f"{handle}_create":
            continue
        call = as_call(api, f)
        call.name = f["name"].removeprefix(f"{handle}_create_")
        if call.owner:
            call.name, call.owner = f"from_{plain(call.owner)}", None
            call.inputs.insert(0, f["parameters"][0])
        yield call


def as_call(api, function):
    parameters = function["parameters"]
    first = element(parameters[0]) if parameters[0]["role"] == "handle" else None
    owner = first if first and function["name"].startswith(first + "_") else None
    name = function["name"][len(owner) + 1:] if owner else plain(function["name"]).removeprefix("shape_")
    call = Call(function, owner, name)
    has_array = any(p["role"] == "array" for p in parameters)
    for i, p in enumerate(parameters):
        role = p["role"]
        if role in ("out", "out_array", "list", "ragged"):
            call.outputs.append(p)
        elif role == "handle" and i == 0 and owner:
            continue
        elif role in ("stride", "capacity", "total", "offsets", "new", "shape_type"):
            continue
        elif role == "count" and has_array:
            continue
        else:
            call.inputs.append(p)
    call.inputs.sort(key=lambda p: p["name"] == "desc")
    return call


def declarations(api, prefix=""):
    """The header as plain C for a parser without a preprocessor, each line after the prefix."""
    lines = [f"typedef {t['type']} {t['name']};" for t in api["types"]]
    lines += [f"typedef struct {h} {h};" for h in api["handles"]]
    lines += [f"typedef {declared(c['type'], c['name'])};" for c in api["callbacks"]]
    for struct in api["structs"]:
        fields = "".join(f" {declared(f['type'], f['name'])}{'[%d]' % f['count'] if f['count'] > 1 else ''};"
                         for f in struct["fields"])
        lines.append(f"typedef struct {struct['name']} {{{fields} }} {struct['name']};")
    for f in api["functions"]:
        parameters = ", ".join(declared(p["type"], p["name"]) for p in f["parameters"]) or "void"
        lines.append(f"{declared(f['returns'], f['name'])}({parameters});")
    return "\n".join(prefix + line for line in lines)


def declared(of, name):
    """A type and a name as C writes them: 'void (*)(int)' has it in the middle."""
    return of.replace("(*)", f"(*{name})") if "(*)" in of else f"{of} {name}".replace("* ", "*")


def constants(api):
    """Name without prefix -> number, of all enumerators and macros."""
    values = {plain(v["name"]): v["value"] for e in api["enums"] for v in e["values"]}
    for name, text in api["constants"].items():
        number = float(text.rstrip("f")) if "e" in text and not text.startswith("0x") else int(text.rstrip("u"), 0)
        values[plain(name)] = number
    return values


def shape_of(parameters, i):
    """The shape_type parameter that tells the kind of parameters[i]."""
    return parameters[i - 1] if parameters[i - 1]["role"] == "shape_type" else None


def has_stride(parameters, i):
    """Whether the library takes an array with any step between its elements, not only side by side."""
    return i + 1 < len(parameters) and parameters[i + 1]["role"] == "stride"


def counted_array(parameters, i):
    """The input array whose length the count parameters[i] is: the one before it."""
    return next((p for p in reversed(parameters[:i]) if p["role"] == "array"), None) or next(
        p for p in parameters[i:] if p["role"] == "array")
