"""The types of the JavaScript package for TypeScript, with the header's comments."""
from ._docs import Language, as_tags, as_text, translated
from ._names import (ANSWERS, SHAPES, base_type, calls, camel, creations, element, lists, lower_camel, other_creations, plain,
                     settable)
from .javascript import DEFAULTS, Structs

NUMBERS = ("float", "double", "int32_t", "uint32_t", "size_t")
PRIMITIVES = [s for s in SHAPES if s != "mesh"]

HEAD = """// Generated from gamephys_api.json by bindings/generate.py. Not for editing.

declare global {
    /** As newer libraries of TypeScript declare it, for those who have an older one. */
    interface SymbolConstructor { readonly dispose: unique symbol }
}

/** A vector or a quaternion: its numbers, or an object that has them by name, as in three.js. */
export type Vector = ArrayLike<number> | { readonly x: number; readonly y: number; readonly z: number; readonly w?: number };
/** Sixteen numbers column by column, or an object that has them, as in three.js. */
export type Matrix = ArrayLike<number> | { readonly elements: ArrayLike<number> } | Mat4;
/** What can be given for a struct: its fields by name, or in order as an array. */
export type Given<T> = T extends number ? number
    : T extends number[] ? Vector
    : T extends readonly (infer E)[] ? readonly Given<E>[]
    : T extends Transform ? { [K in keyof T]?: Given<T[K]> } | readonly unknown[] | ArrayLike<number>
    : T extends Ray ? Omit<{ [K in keyof T]: Given<T[K]> }, 't_max'> & { t_max?: number } | readonly unknown[] | ArrayLike<number>
    : { [K in keyof T]: Given<T[K]> } | readonly unknown[] | ArrayLike<number>;
/** Elements of a batch: rows of four-byte numbers, one after the other. */
export type Elements = Float32Array | Uint32Array | Int32Array | Uint8Array | Records;
/** The same, of floats only. */
export type Floats = Float32Array | Uint8Array | Records;
/** The same, of whole numbers only. Uint16Array is copied. */
export type Words = Uint32Array | Int32Array | Uint16Array | Uint8Array | Records;
/** A shape for a question about it. */
export type AnyShape = Shape | Mesh;

/** Rows of one kind of struct or number: views of all of them as numbers, and each as an object. */
export class Records<T = any> {
    private constructor();
    readonly kind: Kind;
    readonly length: number;
    /** Bytes from one to the next. */
    readonly stride: number;
    /** Views of the same memory. Take them afresh, and do not keep them, where it is the library's:
     *  a view of WebAssembly's memory has no elements any more once that has grown. */
    readonly f32: Float32Array;
    readonly u32: Uint32Array;
    readonly i32: Int32Array;
    /** Where the memory begins and ends on multiples of eight bytes. */
    readonly f64: Float64Array;
    get(index: number): T;
    set(index: number, value: Given<T>): void;
    [Symbol.iterator](): Iterator<T>;
    /** The elements, for JSON. Records are not cloned: post f32.slice() or u32.slice(). */
    toJSON(): T[];
    /** Gives the library's memory back at once. */
    close(): void;
    [Symbol.dispose](): void;
}
/** Memory that calls read and write in place, without a copy. All is 0, but rays have no end: their t_max is Infinity. */
export function records<K extends Kind>(kind: K, length: number): Records<Kinds[K]>;

export class Shape {
    private constructor();
    readonly kind: string;
    readonly type: number;
    readonly data: Float32Array;
    /** Its fields by name. */
    readonly value: any;
}
/** Many shapes of one kind. */
export class Shapes {
    private constructor();
    readonly kind: string;
    readonly type: number;
}
/** A call failed: the message is the library's, status its number. */
export class GamephysError extends Error { readonly status: number }
/** An object was used after close(). */
export class GamephysClosed extends Error {}

/** The library's version, such as "1.0.0". */
export function version(): string;
/** The name of a status, such as "GPHYS_NO_HIT". */
export function statusName(status: number): string;
/** The orbit settings that the library starts from. */
export function defaultOrbit(): Orbit;
/** A shape moved; that of a box along the axes is a turned box. */
export function transform(shape: Shape, by: Given<Transform>): Shape;
"""


def typescript(api):
    structs = {s["name"]: s for s in api["structs"]}
    numbers = Structs(api)

    def is_data(s):
        return not any("*" in base_type(api, f["type"]) for f in s["fields"])

    def value(of, count=1):
        base = base_type(api, of)
        if base in NUMBERS:
            return "number" if count == 1 else "number[]"
        if of in ("gphys_vec3", "gphys_quat", "gphys_mat4"):
            return "number[]"
        return camel(of) + ("[]" if count > 1 else "")

    def given(p):
        of = element(p)
        null = " | null" if p.get("nullable") else ""
        if p["role"] == "handle":
            return camel(of) + null
        if p["role"] == "shape":
            return "AnyShape"
        if p["role"] == "array" and of.endswith("_desc"):
            return f"readonly Partial<{camel(of)}>[] | Partial<{camel(of)}>" + null
        if p["role"] == "array":
            if of == "void":
                return "Shapes | AnyShape" + null
            kind = {"f32": "Floats", "u32": "Words"}.get(numbers.numbers_in(of), "Elements")
            return kind + (" | null" if p["name"] == "indices" else null)
        if p.get("count"):
            return "ArrayLike<number>"
        if p["role"] == "in" and of == "gphys_mat4":
            return "Matrix" + null
        if p["role"] == "in":
            return ("Partial<%s>" % camel(of) if of.endswith("_desc") else f"Given<{value(of)}>") + null
        return "boolean | number" if p["type"] == "int32_t" else "number"

    def got(call):
        words = []
        for p in call.outputs:
            of = element(p)
            if p["role"] == "ragged":
                words.append(f"{{ values: Records<{value(of)}>; offsets: Uint32Array }}")
            elif p["role"] in ("list", "out_array"):
                words.append(f"Records<{value(of)}>")
            elif p.get("count"):
                words.append(value(of) + "[]")
            else:
                words.append("boolean" if of == "int32_t" else value(of))
        if call.function["name"] in ANSWERS:
            return "boolean"
        text = "void" if not words else words[0] if len(words) == 1 else f"[{', '.join(words)}]"
        return text + (" | null" if call.function["may_miss"] else "")

    def signature(call):
        words, optional = [], True
        for p in reversed(call.inputs):
            unsaid = p["name"] in DEFAULTS and p["role"] in ("scalar", "count") and call.name != "set_layers" or p["name"] == "indices"
            optional = optional and (p.get("nullable", False) or unsaid)
            words.insert(0, f"{p['name']}{'?' if optional else ''}: {given(p)}")
        if any(p["role"] == "out_array" for p in call.outputs):
            words.append("out?: Elements")
        return ", ".join(words)

    def doc(text, indent):
        return "" if not text else f"{indent}/** " + text.replace("*/", "* /").replace("\n", f"\n{indent} * ") + " */\n"

    out = [HEAD]
    kinds = {b: "number" for b in ("float", "double", "int32_t", "uint32_t")}
    for s in structs.values():
        desc = s["name"].endswith("_desc")
        if not desc and not is_data(s):
            continue
        if not desc:
            kinds[plain(s["name"])] = value(s["name"])
        fields = "".join(doc(f["doc"], "    ") + f"    {f['name']}: {'readonly number[] | Words | null' if f['name'] in lists(s) else value(f['type'], f['count'])};\n"
                         for f in settable(s) if f["name"] in lists(s) or "*" not in base_type(api, f["type"]))
        out.append(doc(s["doc"], "") + f"export interface {camel(s['name'])} {{\n{fields}}}")
    out.append("/** The elements of Records, by the name of their kind. */\nexport interface Kinds {\n"
               + "".join(f"    {k}: {v};\n" for k, v in kinds.items()) + "}\nexport type Kind = keyof Kinds;")
    for s in PRIMITIVES:
        words = ", ".join(f"{f['name']}: Given<{value(f['type'], f['count'])}>" for f in structs[f"gphys_{s}"]["fields"])
        out.append(f"export function {s}({words}): Shape;")
    out.append("export function shapes(kind: " + " | ".join(f"'{s}'" for s in PRIMITIVES) + ", data: Float32Array | Records): Shapes;")
    made = creations(api)
    for h in api["handles"]:
        out.append(doc(made[h].function["doc"], "") + f"export class {camel(h)} {{\n    constructor({signature(made[h])});\n"
                   "    /** Frees the object at once. */\n    close(): void;\n    [Symbol.dispose](): void;\n"
                   "    /** Throws: an object is not data, and is not cloned. */\n    toJSON(): never;")
        out += [doc(c.function["doc"], "    ") + f"    static {lower_camel(c.name)}({signature(c)}): {camel(h)};"
                for c in other_creations(api, h)]
        out += [doc(c.function["doc"], "    ") + f"    {lower_camel(c.name)}({signature(c)}): {got(c)};"
                for c in calls(api) if c.owner == h]
        if h == "gphys_scene":
            out.append("    /** The shape of a model, in its own coordinates; not of a mesh, which Mesh.fromScene gives. */\n    getShape(model: number): Shape;")
        out.append("}")
    out += [doc(c.function["doc"], "") + f"export function {lower_camel(c.name)}({signature(c)}): {got(c)};"
            for c in calls(api) if not c.owner]
    out += [f"export const {plain(v['name'])}: {v['value']};" for e in api["enums"] for v in e["values"]]
    out += [f"export const {plain(n)}: number;" for n in api["constants"]]
    return "\n".join(out) + "\n"


LANGUAGE = Language(null="null", function=lambda owner, call: f"{owner}.{lower_camel(call.name)}" if owner else lower_camel(call.name),
                    type=camel, constant=plain, parameter=lambda name: name.removeprefix("out_"), flags=("false", "true"))


def commented(doc, creates):
    if creates:
        return as_text(doc, "null", "Throws GamephysError with {}")
    return as_tags(doc, "null", "@returns", "@throws {{GamephysError}} {}:", separator=" - ")


def generate(api):
    api = translated(api, LANGUAGE, commented)
    return {"javascript/index.d.ts": typescript(api)}
