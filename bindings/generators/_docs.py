"""The header's comments in the terms of another language.

A comment of the header speaks to C: of out parameters, strides, capacities and statuses. Here it is
taken apart into what it says of the function, of each parameter, of the result and of what fails; what a
binding does by itself is left out, and names become those of the language. A Language puts the pieces
into its own form of comment.
"""
import copy
import re
from dataclasses import dataclass
from typing import Callable

from ._names import ANSWERS, calls, creations, other_creations, plain

# What only a caller of C has to know: bindings make room for results, and know the sizes of arrays.
OF_C_ONLY = re.compile(r"\bstride\b|\bcapacity\b|\bout_total\b|\bKept when\b|\bcount elements\b|\bcount \+ 1 numbers\b"
                       r"|\bmay (?:each )?be NULL\b|\bout_size\b|\bas scratch memory\b|\bRoom for all\b"
                       r"|\bno byte beyond\b|\bso that a second call\b|\bWhere a ray's range crosses\b|\bwidth \* height elements\b")
# The kind of a shape is told by the shape itself.
OF_A_SHAPE = {"type": "shape"}
FOUND = {"GPHYS_NO_HIT": "nothing is found", "GPHYS_UNBOUNDED": "it is infinite"}


@dataclass
class Doc:
    text: str  # paragraphs
    cost: str
    parameters: list  # (name, text)
    result: str  # may be empty
    missing: str  # when the result is none
    errors: list  # (status, when)


def sentences(text):
    """The sentences of a paragraph, which may end in a line of their own."""
    return [s.strip() for s in re.split(r"(?<=[.:])\s+(?=[A-Z])", " ".join(text.split())) if s.strip()]


def kept(text):
    """Without the clauses that are for C."""
    result = []
    for sentence in sentences(text):
        clauses = [c.strip() for c in sentence.split(";")]
        left = [re.sub(r"^(?:\w+_)?count (?=ids|elements|numbers)", "", c) for c in clauses if not OF_C_ONLY.search(c)]
        if left:
            whole = "; ".join(left)
            result.append(whole if whole.endswith((".", ":")) or not sentence.endswith(".") else whole + ".")
    return " ".join(result)


def without_count(text):
    """The same of a function whose arrays know their length."""
    for pattern, instead in ((r"\bcount single calls\b", "as many single calls"), (r"\bcount calls\b", "as many calls"),
                             (r"O\(count\b", "O(elements"), (r"\bwhere count is\b", "where their number is"),
                             (r"\bof count (?=elements)", "of "), (r"(?<!_)\bcount (?=[a-z]+s\b)(?!elements|times)", "the ")):
        text = re.sub(pattern, instead, text)
    return text


def blocks(comment):
    """(kind, name, text): '' for text, 'param' and 'return' with the lines that are indented below."""
    found = []
    for line in comment.split("\n"):
        entry = re.match(r"@param\s+(\w+)\s+(.*)|@return\s+(.*)", line)
        inner = re.search(r"^(.+?)\s{2,}@return\s+(.*)", line)
        if inner:
            found += [["", "", inner[1]], ["return", "", inner[2]]]
        elif entry:
            found.append(["param", entry[1], entry[2]] if entry[1] else ["return", "", entry[3]])
        elif found and found[-1][0] and line.startswith("  "):
            found[-1][2] += " " + line.strip()
        elif found and not found[-1][0]:
            found[-1][2] += "\n" + line
        else:
            found.append(["", "", line])
    return found


def statuses(text):
    """'GPHYS_OK or GPHYS_NO_HIT; GPHYS_ERROR_X if y' -> [(status, condition)]; without one, it is text."""
    parts = re.split(r"\b(GPHYS_(?:OK|NO_HIT|UNBOUNDED|INCOMPLETE|ERROR_\w+))\b", text)
    if len(parts) == 1 or parts[0].strip():
        return []
    return [(name, re.sub(r"(^[\s,.;]+|[\s,.;]+(?:or|and)?[\s,.;]*$)", "", then))
            for name, then in zip(parts[1::2], parts[2::2])]


def taken_apart(call):
    """A Doc of a function's comment, still with C's names."""
    function = call.function
    doc = Doc("", "", [], "", "", [])
    inputs = {p.get("c_name", p["name"]) for p in call.inputs}
    paragraphs = []
    counted = function["doc"] if "count" in inputs else without_count(function["doc"])
    for kind, name, text in blocks(counted):
        if not kind:
            paragraphs.append(kept(text))
        elif kind == "param":
            given, rest = OF_A_SHAPE.get(name, name), kept(text)
            if given in inputs and doc.parameters and doc.parameters[-1][1] == rest:
                doc.parameters[-1] = (f"{doc.parameters[-1][0]}, {given}", rest)
            elif given in inputs and rest:
                doc.parameters.append((given, rest))
            elif rest != "0 or 1" and rest and name.startswith("out_") and f"{rest.rstrip('.')}." not in doc.result:
                doc.result += (" " if doc.result else "") + rest.rstrip(".") + "."
        else:
            answers = statuses(text)
            if not answers:
                paragraphs.append(f"Fails {text}." if text.startswith("as ") else kept(text))
            for status, when in answers:
                if status in ("GPHYS_OK", "GPHYS_INCOMPLETE") or status == ANSWERS.get(function["name"]):
                    continue
                if status in FOUND and function["may_miss"]:
                    doc.missing += ("; " if doc.missing else "") + (when or f"if {FOUND[status]}")
                elif status not in FOUND:
                    doc.errors.append((status, kept(when)))
    doc.text, _, doc.cost = "\n".join(filter(None, paragraphs)).partition("Cost: ")
    # What follows the cost in a paragraph of its own is about the function.
    doc.cost, _, more = doc.cost.partition("\n")
    doc.text = "\n".join(filter(None, [doc.text.strip(), more]))
    if function["may_miss"] and not doc.missing:
        doc.missing = "if nothing is found"
    return doc


@dataclass
class Language:
    null: str  # what stands for NULL
    function: Callable  # (owner as a type's name or None, the Call) -> how users write it
    type: Callable  # 'gphys_scene_desc' -> 'SceneDesc'
    constant: Callable  # 'GPHYS_HIT_INSIDE' -> 'HIT_INSIDE'
    parameter: Callable  # 'near_distance' -> 'nearDistance'
    message: str = "the error's message"  # gphys_last_error()
    flags: tuple = ()  # what stands for 0 and 1 of a parameter that is one of them


class Docs:
    def __init__(self, api, language):
        self.language = language
        self.calls = {c.function["name"]: c for c in calls(api)}
        self.made = {c.function["name"]: handle for handle, c in creations(api).items()}
        self.made.update({f"{handle}_destroy": handle for handle in self.made.values()})
        self.made.update({c.function["name"]: handle for handle in api["handles"] for c in other_creations(api, handle)})
        self.types = {t["name"] for kind in ("structs", "types") for t in api[kind]} | set(api["handles"])
        self.parameters = {p["name"] for f in api["functions"] for p in f["parameters"]}
        self.values = {v["name"] for e in api["enums"] for v in e["values"]} | set(api["constants"])

    def named(self, match):
        name = match[0].removesuffix("()")
        if name == "gphys_last_error":
            return self.language.message
        call = self.calls.get(name)
        if call:
            return self.language.function(call.owner and self.language.type(call.owner), call)
        if name in self.made:
            return self.language.type(self.made[name])
        if name in self.types:
            return self.language.type(name)
        if name.startswith("GPHYS_"):
            return self.language.constant(name) if name in self.values else plain(name)
        return plain(name)

    def phrase(self, text):
        """A sentence with the language's names."""
        text = re.sub(r"\bthe gphys_solver_add_\.\.\. functions\b", "the functions that add bodies", text)
        text = re.sub(r"\bgphys_shape_\* functions\b", "functions of shapes", text)
        text = re.sub(r"\breturn (GPHYS_ERROR_)", r"fail with \1", text)
        text = re.sub(r"\b(GPHYS_\w+)_\.\.\.", lambda m: plain(m[1]).lower().replace("_", " ") + " values", text)
        text = re.sub(r"\bNULL\b", self.language.null, text)
        text = re.sub(r"\b(?:gphys|GPHYS)_\w+(?:\(\))?", self.named, text)
        text = re.sub(r"\bout_(\w+)", lambda m: self.language.parameter(m[1]), text)
        return re.sub(r"\b[a-z]+(?:_[a-z0-9]+)+\b",
                      lambda m: self.language.parameter(m[0]) if m[0] in self.parameters else m[0], text)

    def of(self, call):
        """A Doc in the language's names."""
        doc = taken_apart(call)
        name = self.language.parameter
        flags = {p.get("c_name", p["name"]) for p in call.inputs if p["role"] == "scalar" and p["type"] == "int32_t"}
        if self.language.flags:
            doc.parameters = [(n, re.sub(r"\b([01])(?=: )", lambda m: self.language.flags[int(m[1])], text) if n in flags else text)
                              for n, text in doc.parameters]
        return Doc("\n".join(map(self.phrase, doc.text.split("\n"))), self.phrase(doc.cost),
                   [(", ".join(name(n) for n in names.split(", ")), self.phrase(text)) for names, text in doc.parameters],
                   self.phrase(doc.result), self.phrase(doc.missing),
                   [(self.language.constant(status), self.phrase(when)) for status, when in doc.errors])

    def plain(self, text):
        """The comment of a struct, a field or a value, in the language's names."""
        return "\n".join(self.phrase(line) for line in text.split("\n")) if text else text


def wrapped(text, width, prefix="", hanging=""):
    """Lines of at most `width` characters; those after the first begin with `hanging`."""
    lines, line = [], prefix
    for word in text.split():
        if len(line) + len(word) > width and line.strip():
            lines.append(line.rstrip())
            line = hanging
        line += word + " "
    return [*lines, line.rstrip()]


def ended(text):
    return text if text.endswith(".") else text + "."


def paragraphs(doc, width):
    return [line for paragraph in doc.text.split("\n") for line in wrapped(paragraph, width)]


def outcome(doc, nothing):
    """What comes back, `nothing` when there is no answer."""
    missing = f"{nothing} {ended(doc.missing)}" if doc.missing else ""
    return " ".join(filter(None, [doc.result, missing]))


def as_text(doc, nothing, fails, width=100):
    """For comments without fields: parameters as a list, sentences for the rest. fails has a place for the status."""
    lines = paragraphs(doc, width)
    for names, text in doc.parameters:
        lines += wrapped(text, width, f"  - {names}: ", "    ")
    if outcome(doc, nothing):
        lines += wrapped(f"Result: {outcome(doc, nothing)}", width)
    for status, when in doc.errors:
        lines += wrapped(f"{fails.format(status)} {ended(when)}", width)
    return "\n".join(lines + wrapped(f"Cost: {doc.cost}", width))


def as_tags(doc, nothing, returns, fails, separator=" ", width=100):
    """For comments with @param and the like; returns and fails are their tags."""
    lines = paragraphs(doc, width) + wrapped(f"Cost: {doc.cost}", width)
    for names, text in doc.parameters:
        for name in names.split(", "):
            lines += wrapped(text, width, f"@param {name}{separator}", "    ")
    if outcome(doc, nothing):
        lines += wrapped(f"{returns} {outcome(doc, nothing)}", width, "", "    ")
    for status, when in doc.errors:
        lines += wrapped(f"{fails.format(status)} {when}", width, "", "    ")
    return "\n".join(lines)


def translated(api, language, layout):
    """The description with comments for the language; layout makes the comment of a
    function from its Doc, told whether that creates an object."""
    docs = Docs(api, language)
    mine = copy.deepcopy(api)
    for kind in ("types", "callbacks", "structs"):
        for entry in mine[kind]:
            entry["doc"] = docs.plain(entry["doc"])
            for field in entry.get("fields", []):
                field["doc"] = docs.plain(field["doc"])
    for enum in mine["enums"]:
        for value in enum["values"]:
            value["doc"] = docs.plain(value["doc"])
    every = {c.function["name"]: c for c in [*calls(api), *creations(api).values(),
                                               *(c for h in api["handles"] for c in other_creations(api, h))]}
    for function in mine["functions"]:
        if function["name"] in every:
            call = every[function["name"]]
            function["doc"] = layout(docs.of(call), not call.owner and function["name"] in docs.made)
    return mine
