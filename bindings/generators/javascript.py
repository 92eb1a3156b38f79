"""JavaScript: what index.js builds its methods from, and the types of TypeScript."""
import json

from ._names import SHAPES, base_type, calls, camel, creations, element, lower_camel, plain

NUMBERS = ("float", "double", "int32_t", "uint32_t", "size_t")


def described(api, call):
    f = call.function
    return {
        "c": f["name"], "owner": camel(call.owner) if call.owner else None, "name": lower_camel(call.name),
        "inputs": [p["name"] for p in call.inputs], "mayMiss": f["may_miss"],
        "parameters": [{"name": p["name"], "role": p["role"], "of": base_type(api, element(p)),
                        **{key: p[key] for key in ("width", "count", "length") if key in p}} for p in f["parameters"]],
    }


def data(api):
    made = creations(api)
    return {
        "constants": {plain(v["name"]): v["value"] for e in api["enums"] for v in e["values"]}
        | {plain(n): float(v.rstrip("f")) if "e" in v and not v.startswith("0x") else int(v.rstrip("u"), 0)
           for n, v in api["constants"].items()},
        "structs": {s["name"]: {"size": s["size"], "fields": [
            {"name": f["name"], "of": base_type(api, f["type"]), "count": f["count"], "offset": f["offset"]} for f in s["fields"]]}
            for s in api["structs"]},
        "shapes": [s for s in SHAPES if s != "mesh"],
        "creations": {camel(h): described(api, c) for h, c in made.items()},
        "calls": [described(api, c) for c in calls(api)],
        "inits": [f["name"] for f in api["functions"] if f["name"].endswith("_init")],
        "destroys": {camel(h): f"{h}_destroy" for h in api["handles"]},
    }


def typescript(api):
    def value(of, count=1):
        base = base_type(api, of)
        if base in NUMBERS:
            return "number" if count == 1 else "ArrayLike<number>"
        if of in ("gphys_vec3", "gphys_quat", "gphys_mat4"):
            return "ArrayLike<number>"
        return (camel(of) if "*" not in base else "null") + ("[]" if count > 1 else "")

    def given(p):
        of = element(p)
        null = " | null" if p.get("nullable") else ""
        if p["role"] == "handle":
            return camel(of) + null
        if p["role"] == "shape":
            return "Shape"
        if p["role"] == "array":
            return ("Shapes | Shape" if of == "void" else "Elements") + null
        if p.get("count"):
            return "ArrayLike<number>"
        if p["role"] == "in":
            return ("Partial<%s>" % camel(of) if of.endswith("_desc") else value(of)) + null
        return "number"

    def got(call):
        words = []
        for p in call.outputs:
            of = element(p)
            if p["role"] == "ragged":
                words.append("{ values: Records; offsets: Uint32Array }")
            elif p["role"] in ("list", "out_array") or p.get("count"):
                words.append("Records")
            else:
                words.append("boolean" if of == "int32_t" else value(of))
        text = "void" if not words else words[0] if len(words) == 1 else f"[{', '.join(words)}]"
        return text + (" | null" if call.function["may_miss"] else "")

    def signature(call):
        words, optional = [], True
        for p in reversed(call.inputs):
            optional = optional and (p.get("nullable", False) or p["name"] == "layers")
            words.insert(0, f"{p['name']}{'?' if optional else ''}: {given(p)}")
        if any(p["role"] == "out_array" for p in call.outputs):
            words.append("out?: ArrayBufferView")
        return ", ".join(words)

    def doc(text, indent):
        return "" if not text else f"{indent}/** " + text.replace("*/", "* /").replace("\n", f"\n{indent} * ") + " */\n"

    out = ["// Generated from gamephys_api.json by bindings/generate.py. Not for editing.",
           "/** Elements of a batch: rows of 4-byte numbers, one after the other. */",
           "export type Elements = Float32Array | Uint32Array | Int32Array | Records;",
           "/** Results of a batch: one view for each type of number, and objects on demand. */",
           "export interface Records {\n    readonly length: number;\n    readonly stride: number;\n    readonly f32: Float32Array;\n"
           "    readonly u32: Uint32Array;\n    readonly i32: Int32Array;\n    readonly f64?: Float64Array;\n    get(index: number): any;\n}",
           "export interface Shape { readonly type: number }",
           "export interface Shapes { readonly type: number; readonly data: Float32Array }",
           "export class GamephysError extends Error { readonly status: number }"]
    for s in api["structs"]:
        fields = "".join(f"    {f['name']}: {value(f['type'], f['count'])};\n" for f in s["fields"])
        out.append(doc(s["doc"], "") + f"export interface {camel(s['name'])} {{\n{fields}}}")
    for s in SHAPES:
        if s != "mesh":
            fields = next(x["fields"] for x in api["structs"] if x["name"] == f"gphys_{s}")
            words = ", ".join(f"{f['name']}: {value(f['type'], f['count'])}" for f in fields)
            out.append(f"export function {s}({words}): Shape;")
    out.append("export function shapes(kind: string, data: Float32Array): Shapes;")
    out.append("export function defaultOrbit(): Orbit;")
    made = creations(api)
    for h in api["handles"]:
        out.append(doc(made[h].function["doc"], "") + f"export class {camel(h)} {{\n    constructor({signature(made[h])});\n"
                   "    /** Frees the object at once. */\n    close(): void;")
        for call in calls(api):
            if call.owner == h:
                out.append(doc(call.function["doc"], "    ") + f"    {lower_camel(call.name)}({signature(call)}): {got(call)};")
        out.append("}")
    for call in calls(api):
        if not call.owner:
            out.append(doc(call.function["doc"], "") + f"export function {lower_camel(call.name)}({signature(call)}): {got(call)};")
    for e in api["enums"]:
        for v in e["values"]:
            out.append(f"export const {plain(v['name'])}: {v['value']};")
    out += [f"export const {plain(n)}: number;" for n in api["constants"]]
    return "\n".join(out) + "\n"


def generate(api):
    return {"javascript/api.json": json.dumps(data(api), indent=0) + "\n", "javascript/index.d.ts": typescript(api)}
