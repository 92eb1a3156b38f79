"""Lua: the declarations for LuaJIT's FFI, and a method for each function."""
from ._calls import arguments, batch_arrays, comment
from ._docs import Language, as_tags, translated
from ._names import (ANSWERS, BUILT, MASKS, SHAPES, base_type, calls, camel, constants, creations, declarations, element, lists,
                     other_creations, plain)

HEADER = "-- Generated from gamephys_api.json by bindings/generate.py. Not for editing.\n"
TEMPLATES = {
    "self": "opened(self)", "handle": "opened({n})", "handle?": "{n} and opened({n})",
    "shape_type": "kind({shape})", "shape": "address({n})", "in": "to_value({type}, {n})",
    "in?": "{n} and to_value({type}, {n})", "in_fixed": "to_numbers({type}, {n})", "array": "{n}",
    "shape_array": "{n}", "stride": "{array}_stride", "batch_count": "count", "own_count": "{array}_count",
    "plain_count": "count", "scalar": "{n}", "out": "{n}", "out_fixed": "{n}", "out_array": "out", "list": "out",
    "capacity": "capacity", "total": "total", "ragged": "out", "offsets": "offsets", "new": "made",
}
NUMBERS = ("float", "double", "int32_t", "uint32_t")


def lua_type(api, of):
    """The local variable that knows a C type."""
    base = base_type(api, of)
    return base if base in NUMBERS else camel(of)


def is_struct(api, p):
    return base_type(api, element(p)) not in NUMBERS


def argument_list(api, call):
    words = arguments(call, TEMPLATES, lambda of: lua_type(api, of))
    for i, p in enumerate(call.function["parameters"]):
        name = p["name"]
        if p["role"] == "in" and element(p).endswith("_desc"):
            words[i] = f"{name} and to_desc({lua_type(api, element(p))}, {name})"
        elif p["role"] == "in" and p.get("count"):
            words[i] = f"to_numbers({lua_type(api, element(p))}, {name}, {p['count']})"
        elif p["role"] == "shape_type" and call.function["parameters"][i + 1]["role"] == "array":
            words[i] = f"{call.function['parameters'][i + 1]['name']}_kind"
        elif p["role"] == "stride" and p["name"] == "out_stride":
            words[i] = f"{lua_type(api, element(call.function['parameters'][i - 1]))}.size"
        elif p["role"] == "count" and p["name"] == "index_count":
            words[i] = "indices_count"
        elif p["role"] == "scalar" or p["role"] == "count" and words[i] == name == "count" and not batch_arrays(call):
            words[i] = checked(api, call, p)
    return words


# What a parameter is that is not given.
DEFAULTS = {"layers": "ALL_LAYERS", "max_distance": "math.huge", "tolerance": "0", "link_length": "0", "compliance": "0"}


def checked(api, call, p):
    """A number that is what it must be: the check has its name for the message."""
    name = p["name"]
    other = DEFAULTS.get(name) if call.name != "set_layers" else None
    if p["type"] == "int32_t":
        return f"to_flag({name}, '{name}')"
    if name == "pinned":
        return name
    base = base_type(api, p["type"])
    check = {"float": "real", "int32_t": "signed"}.get(base, "bits" if name in MASKS else "whole")
    return f"{check}({name}{f' or {other}' if other else ''}, '{name}')"


def prepared(api, call):
    """Statements that turn arrays into memory, its step and its number of elements."""
    lines = []
    for p in call.function["parameters"]:
        n = p["name"]
        if p["role"] == "array" and element(p).endswith("_desc"):
            lines.append(f"local {n}, {n}_count, {n}_stride = to_descs({lua_type(api, element(p))}, {n})")
        elif p["role"] == "array" and element(p) == "void":
            lines.append(f"local {n}, {n}_kind, {n}_count, {n}_stride = to_shapes({n})")
        elif p["role"] == "array":
            width = f", {p['width']}" if "width" in p else ""
            lines.append(f"local {n}, {n}_count, {n}_stride = to_array({lua_type(api, element(p))}, {n}{width})")
    if any(p["role"] == "count" and p["name"] == "count" for p in call.inputs):
        lines += ["if first == nil then first = 0 end",
                  "if count == nil then count = math.max(0, self:get_body_info(body).particle_count - whole(first, 'first')) end"]
        lines += ["if pinned == nil then pinned = true end"] if any(p["name"] == "pinned" for p in call.inputs) else []
    arrays = [p["name"] + "_count" for p in batch_arrays(call)]
    assert len(arrays) <= 3, "runtime.common takes three"
    if arrays:
        lines.append(f"local count = common({', '.join(arrays)})")
    return lines


def method(api, call):
    f, outs = call.function, call.outputs
    args = argument_list(api, call)
    names = [p["name"] for p in call.inputs]
    kept, lines = [], prepared(api, call)
    single = outs[0] if len(outs) == 1 and outs[0]["role"] == "out" and is_struct(api, outs[0]) and not outs[0].get("count") else None
    results = []
    for p in outs:
        of = lua_type(api, element(p))
        if p["role"] == "out_array":
            names.append("out")
            lines.append(f"out = results({of}, out, {p.get('length', 'count')})")
            results.append("out")
        elif p["role"] != "out":
            continue
        elif p.get("count"):
            lines.append(f"local {p['name']} = {of}.array({p['count']})")
            results.append(p["name"])
        elif is_struct(api, p):
            if p is single:
                names.append(p["name"])
                lines.append(f"{p['name']} = {p['name']} or {of}.new()")
            else:
                lines.append(f"local {p['name']} = {of}.new()")
            results.append(p["name"])
        else:
            kept.append(f"local {p['name']} = {of}.array(1)")
            results.append(f"{p['name']}[0]" + (" ~= 0" if element(p) == "int32_t" else ""))
    invoke = f"C.{f['name']}({', '.join(args)})"
    listed = next((p for p in outs if p["role"] in ("list", "ragged")), None)
    if listed:
        of, ragged = lua_type(api, element(listed)), listed["role"] == "ragged"
        lines.append(f"return {'ragged' if ragged else 'list'}({of}, function(out, capacity, {'offsets' if ragged else 'total'})\n"
                     f"        return {invoke}\n    end{', count' if ragged else ''})")
    elif f["name"] in ANSWERS:
        lines.append(f"return answered({invoke}, {constants(api)[plain(ANSWERS[f['name']])]})")
    elif f["may_miss"]:
        lines.append(f"if found({invoke}) then return {', '.join(results)} end")
    else:
        lines.append(f"check({invoke})")
        if results:
            lines.append(f"return {', '.join(results)}")
    owner = f"{camel(call.owner)}:" if call.owner else "gp."
    text = comment(f["doc"], "---") + f"function {owner}{call.name}({', '.join(names)})\n"
    text += "".join(f"    {line}\n" for line in lines) + "end\n"
    if kept:  # where numbers are put, once for all calls
        text = "do\n" + "".join(f"    {line}\n" for line in [*kept, *text.splitlines()]) + "end\n"
    return text


def declared(api):
    text = HEADER + "return {\n    declarations = [[\n" + declarations(api) + "\n]],\n    constants = {\n"
    text += "".join(f"        {name} = {value!r},\n" for name, value in constants(api).items())
    text += "    },\n    structs = {\n"
    for struct in api["structs"]:
        fields = ", ".join(f'"{f["name"]}"' for f in struct["fields"])
        checks = {f["name"]: "bits" if f["name"] in MASKS else {"uint32_t": "whole", "int32_t": "to_flag"}.get(base_type(api, f["type"]))
                  for f in struct["fields"] if f["count"] == 1}
        numbers = ", ".join(f'{name} = "{check}"' for name, check in checks.items() if check)
        listed = ", ".join(f'{name} = "{count}"' for name, count in lists(struct).items())
        listed = f", lists = {{ {listed} }}" if listed else ""
        built = ", built = true" if struct["name"] in BUILT else ""
        text += f'        {{ name = "{plain(struct["name"])}", fields = {{ {fields} }}, numbers = {{ {numbers} }}{listed}{built} }},\n'
    text += "    },\n"
    text += "    shapes = {" + ", ".join(f'"{s}"' for s in SHAPES if s != "mesh") + "},\n"
    return text + "    objects = {" + ", ".join(f'"{plain(h)}"' for h in api["handles"]) + "},\n}\n"


def methods(api):
    made, every = creations(api), list(calls(api))
    used = [s["name"] for s in api["structs"] if s["name"] not in ("gphys_allocator", "gphys_task_runner")]
    out = [HEADER + "return function(gp, runtime)",
           "local C, ALL_LAYERS = runtime.C, gp.ALL_LAYERS",
           "local opened, kind, address, to_value = runtime.opened, runtime.kind, runtime.address, runtime.to_value",
           "local to_numbers, to_desc, to_descs, to_flag = runtime.to_numbers, runtime.to_desc, runtime.to_descs, runtime.to_flag",
           "local to_array, to_shapes, common, results = runtime.to_array, runtime.to_shapes, runtime.common, runtime.results",
           "local whole, bits, signed, real = runtime.whole, runtime.bits, runtime.signed, runtime.real",
           "local list, ragged, check, found, answered = runtime.list, runtime.ragged, runtime.check, runtime.found, "
           "runtime.answered",
           *(f"local {n} = runtime.element '{n}'" for n in NUMBERS),
           *(f"local {camel(n)} = runtime.element '{n}'" for n in used), ""]
    for handle in api["handles"]:
        name = camel(handle)
        out.append(f"local {name} = runtime.class '{plain(handle)}'")
        for word, creation in [(name, made[handle]), *((f"{name}_{c.name}", c) for c in other_creations(api, handle))]:
            names = ", ".join(p["name"] for p in creation.inputs)
            out.append(comment(creation.function["doc"], "---") + f"function gp.{word}({names})")
            out += [f"    {line}" for line in prepared(api, creation)]
            out.append(f"    return {name}.create(function(made)\n        return C.{creation.function['name']}"
                       f"({', '.join(argument_list(api, creation))})\n    end)\nend\n")
        out += [method(api, c) for c in every if c.owner == handle]
    out += [method(api, c) for c in every if not c.owner]
    return "\n".join(out) + "end\n"


LANGUAGE = Language(null="nil", function=lambda owner, call: f"{owner}:{call.name}" if owner else f"gp.{call.name}", type=camel,
                    constant=plain, parameter=lambda name: name.removeprefix("out_"))


def generate(api):
    api = translated(api, LANGUAGE, lambda doc, creates: as_tags(doc, "nil", "@return", "@raise status {}:"))
    return {"lua/gamephys/declarations.lua": declared(api), "lua/gamephys/methods.lua": methods(api)}
