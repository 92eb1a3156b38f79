"""The reference as pages of reStructuredText, from the header and what cmake/interface/record.sh keeps of it.

The header gives the sections, their order and the conventions at its top; bindings/gamephys_api.json, which a test
holds equal to the header, gives functions, parameters, fields and comments. Each function shows a call from a
program of this repository, and lists the programs with it.
"""
import json
import re

TITLES = {"Status and version": "status", "Values": "values", "Shapes": "shapes", "Mesh": "mesh", "Scene": "scene",
          "Camera": "camera", "Solver": "solver"}
BANNER = re.compile(r"^/\* -{20,}\n((?: \* .*\n| \*\n)+?) \* -{20,} \*/$", re.M)
PREFIXES = ["GPHYS_API"]  # a macro of the header itself
EXAMPLES = ["docs/guide/*.md", "examples/*.c", "examples/viewer/*.c", "tests_c/test_*.c"]


def sections(header):
    """[(file name, title, introduction, text)] of the header."""
    found = list(BANNER.finditer(header))
    ends = [match.start() for match in found[1:]] + [len(header)]
    for match, end in zip(found, ends):
        text = re.sub(r"^ \* ?", "", match.group(1), flags=re.M).strip()
        title = re.split(r"[.:\n]", text)[0]
        yield TITLES[title], title, text[len(title):].lstrip(".: \n"), header[match.end():end]


def conventions(header):
    """The table at the top of the header, as a definition list."""
    text = re.sub(r"^ \* ?", "", header[:header.index("*/")], flags=re.M)
    text = text[text.index("CONVENTIONS"):]
    lines = ["The rules below hold for every function unless its own comment says otherwise.", ""]
    for term, body in re.findall(r"^([A-Z][a-z]+) {2,}(.*(?:\n +.*)*)", text, re.M):
        lines += [term, *("   " + line.strip() for line in body.splitlines()), ""]
    return lines


# A declaration of a variable of that name, initialisers left out.
DECLARATION = r"^\s*(?:static |const )*(?:gphys_\w+|u?int32_t|float|double|int|any_shape)\b[ *]+(?:.*, *\**)?{}\b *[\[=,;]"


def indent(line):
    return len(line) - len(line.lstrip())


def statement(lines, at):
    """(first, last) of the lines of the statement around a line."""
    first, last = at, at
    while first > 0 and indent(lines[first]) > 0 and not re.search(r"[;{}]$|^#|\*/$|^$|:$", lines[first - 1]):
        first -= 1
    while last + 1 < len(lines) and not re.search(r"[;{}]( *//.*| */\*.*)?$", lines[last]):
        last += 1
    return first, last


def excerpt(lines, at, name, in_test):
    """The statement of a call and what is before it. Of a test the declarations of the arguments, and the call without
    the check around it."""
    first, last = statement(lines, at)
    chosen = lines[first:last + 1]
    if in_test:
        call = called(" ".join(line.strip() for line in chosen), name)
        declared = []
        for argument in dict.fromkeys(re.findall(r"(?<![.>\w])(?!gphys_|GPHYS_)[A-Za-z_]\w*\b", call)):
            for above in range(first - 1, -1, -1):
                bare = re.sub(r"\{.*\}", "", lines[above])
                if re.search(DECLARATION.format(argument), bare) and bare.endswith(";"):
                    declared.append(above)
                if not lines[above].startswith((" ", "}")) and lines[above]:
                    break  # the function begins
        return [lines[above].strip() for above in sorted(set(declared))] + folded(call)
    start = first
    while start > 0 and first - start < 5 and lines[start - 1].strip() and indent(lines[start - 1]) >= indent(lines[first]):
        start -= 1
    least = min(indent(line) for line in lines[start:last + 1] if line.strip())
    return [line[least:] for line in lines[start:last + 1]]


def called(text, name):
    """The call of a function in a statement, up to its closing parenthesis, with what its result goes to."""
    start = text.index(name + "(")
    depth, end = 0, start + len(name)
    while True:
        depth += (text[end] == "(") - (text[end] == ")")
        end += 1
        if depth == 0:
            break
    target = re.match(r"[\w.>\[\]-]+ = $", text[:start])
    return (target.group() if target else "") + text[start:end] + ";"


def folded(call, width=110):
    """A call on lines of at most so many columns, broken after commas."""
    lines = [""]
    for part in re.split(r"(?<=, )", call):
        if len(lines[-1]) + len(part) > width:
            lines.append("    ")
        lines[-1] += part
    return [line.rstrip() for line in lines]


class Reference:
    def __init__(self, source):
        self.source = source
        self.header = (source / "include/gamephys_c.h").read_text()
        self.api = json.loads((source / "bindings/gamephys_api.json").read_text())
        api = self.api
        self.functions = {f["name"]: f for f in api["functions"]}
        self.structs = {s["name"]: s for s in api["structs"]}
        self.types = {t["name"]: t for t in api["types"]}
        self.callbacks = {c["name"]: c for c in api["callbacks"]}
        self.handles = {h if isinstance(h, str) else h["name"] for h in api["handles"]}
        self.values = {v["name"]: v for e in api["enums"] for v in e["values"]}
        self.first_of = {e["values"][0]["name"]: e for e in api["enums"]}
        self.callers = self.find_callers()

    def find_callers(self):
        """{function: [(how little it shows, path, line of the call, lines)]}, sorted. A program of the guide shows more
        than a test, and a call that succeeds more than one that has to fail."""
        callers = {}
        for rank, pattern in enumerate(EXAMPLES):
            for path in sorted(self.source.glob(pattern)):
                text = path.read_text()
                blocks = re.findall(r"^```c\n(.*?)^```", text, re.M | re.S) if path.suffix == ".md" else [text]
                for lines in (block.splitlines() for block in blocks):
                    for at, line in enumerate(lines):
                        for name in re.findall(r"\bgphys_\w+(?=\()", line):
                            first, last = statement(lines, at)
                            call = " ".join(lines[first:last + 1])
                            fails = rank == len(EXAMPLES) - 1 and not re.match(r"\s*(DO\(|assert_int_equal\(.*GPHYS_OK)", call)
                            poor = fails or "? " in call or name + "(NULL" in call
                            penalty = (poor, rank, call.count("NULL"))
                            callers.setdefault(name, []).append((penalty, path.relative_to(self.source).as_posix(), at, lines))
        return {name: sorted(found, key=lambda one: one[0]) for name, found in callers.items()}

    def prose(self, text):
        """A comment as reStructuredText: names become links, what looks like markup is kept as it is."""
        roles = [(self.functions, "func"), (self.structs, "struct"), (self.types, "type"), (self.callbacks, "type"),
                 (self.handles, "type"), (self.values, "enumerator"), (self.api["constants"], "macro")]

        def mark(word):
            if word.startswith("`"):
                return "``" + " ".join(word[1:-1].split()) + "``"
            for names, role in roles:
                if word in names:
                    return f":c:{role}:`{word}`"
            struct, _, field = word.partition(".")
            if field in [known["name"] for known in self.structs.get(struct, {"fields": []})["fields"]]:
                return f":c:member:`{word}`"
            if re.fullmatch(r"(?:gphys|GPHYS)_\w*[^_\W]", word) and word not in PREFIXES:
                raise SystemExit(f"the header speaks of {word}, which it does not declare: {text}")
            return f"``{word}``"

        parts = re.split(r"(`[^`]+`|\*?\b(?:gphys|GPHYS)_[\w*]+(?:\.\w+)?|\*_\w+|\b\w+_\b)", text)
        for i, part in enumerate(parts):
            if i % 2:
                parts[i] = mark(part)
                if parts[i][-1:] == "`" and re.match(r"[\w(\[.]", "".join(parts[i + 1:])):
                    parts[i] += "\\ "
            else:
                parts[i] = part.replace("\\", "\\\\").replace("*", "\\*").replace("|", "\\|")
        return "".join(parts)

    def paragraphs(self, text, indent):
        return [indent + line.strip() for line in self.prose(text).splitlines()] + [""]

    def declaration(self, function):
        def parameter(p):
            array = re.fullmatch(r"(.*?)(\[\d+\])", p["type"])
            kind, extent = array.groups() if array else (p["type"], "")
            return f"{kind.rstrip()}{'' if kind.endswith('*') else ' '}{p['name']}{extent}"

        return f"{function['returns']} {function['name']}({', '.join(map(parameter, function['parameters'])) or 'void'})"

    def function(self, name):
        """The comment in parts: text, parameters, return, and the sentences on errors, cost and threads."""
        doc = re.sub(r"(?<=[.;]) +(Cost|Threads): ", r"\n\1: ", self.functions[name]["doc"])
        lines = [f".. c:function:: {self.declaration(self.functions[name])}", ""]
        fields, text = [], []
        target = text
        for line in doc.splitlines():
            tag = re.match(r"@param +((?:\w+, )*\w+) +(.*)|@return +(.*)", line)
            own = re.match(r"(Cost|Threads|Error): +(.*)", line)
            if tag:
                title = f"param {tag.group(1)}" if tag.group(1) else "returns"
                target = [tag.group(2) or tag.group(3)]
                fields.append((title, target))
            elif own:
                target = [own.group(2)]
                fields.append((own.group(1), target))
            elif line.startswith(" ") or target is text or fields and fields[-1][0] in ("Cost", "Threads", "Error"):
                target.append(line)
            else:  # text again, after parameters
                target = text
                text += ["", line]
        lines += self.paragraphs("\n".join(text), "   ")
        for title, body in sorted(fields, key=lambda field: field[0] in ("Cost", "Threads", "Error")):
            body = self.prose(" ".join(part.strip() for part in body))
            lines.append(f"   :{title.replace('param', 'Parameters', 1) if ',' in title else title}: {body}")
        callers = self.callers.get(name, [])
        if not callers:
            raise SystemExit(f"no program calls {name}: the reference needs an example")
        programs = list(dict.fromkeys(path for _, path, _, _ in callers))[:4]
        shown = [f":download:`{path} </{path}>`" if not path.endswith(".md") else f":doc:`/{path[:-3]}`" for path in programs]
        lines += [f"   :Programs: {', '.join(shown)}", "", "   .. code-block:: c", ""]
        (_, rank, _), _, at, of = callers[0]
        lines += [f"      {line}" for line in excerpt(of, at, name, rank == len(EXAMPLES) - 1)]
        return lines + [""]

    def struct(self, name):
        struct = self.structs[name]
        lines = [f".. c:struct:: {name}", ""] + self.paragraphs(struct["doc"], "   ")
        for field in struct["fields"]:
            callback = re.fullmatch(r"(.*\(\*)(\).*)", field["type"])
            if callback:
                declared = f"{callback.group(1)}{field['name']}{callback.group(2)}"
            else:
                kind = field["type"].rstrip()
                extent = f"[{field['count']}]" if field["count"] > 1 else ""
                declared = f"{kind}{'' if kind.endswith('*') else ' '}{field['name']}{extent}"
            lines += [f"   .. c:member:: {declared}", ""] + self.paragraphs(field["doc"], "      ")
        return lines

    def enumeration(self, values):
        lines = []
        for value in values["values"]:
            lines += [f".. c:enumerator:: {value['name']} = {value['value']}", "", *self.paragraphs(value["doc"], "   ")]
        return lines

    def entries(self, text):
        """What a section of the header declares, in its order."""
        pattern = (r"typedef struct (?P<struct>gphys_\w+) \{|typedef struct (?P<handle>gphys_\w+) gphys_\w+;"
                   r"|typedef void \(\*(?P<callback>\w+)\)|typedef \w+ (?P<type>gphys_\w+);"
                   r"|^(?:    |enum \{ )(?P<value>GPHYS_\w+) = |#define (?P<macro>GPHYS_\w+) |(?P<function>gphys_\w+)\((?=[^*])")
        for match in re.finditer(pattern, text, re.M):
            kind, name = match.lastgroup, match.group(match.lastgroup)
            if kind == "struct":
                yield self.struct(name)
            elif kind == "handle":
                yield [f".. c:type:: {name}", "", "   A handle: opaque.", ""]
            elif kind == "callback":
                callback = self.callbacks[name]
                declared = callback["type"].replace("(*)", f"(*{name})")
                yield [f".. c:type:: {declared}", ""] + self.paragraphs(callback["doc"], "   ")
            elif kind == "type" and name in self.types:
                yield [f".. c:type:: {self.types[name]['type']} {name}", ""] + self.paragraphs(self.types[name]["doc"], "   ")
            elif kind == "type":
                yield [f".. c:type:: uint32_t {name}", "", "   An id; 0 is none.", ""]
            elif kind == "value" and name in self.first_of:
                yield self.enumeration(self.first_of[name])
            elif kind == "macro" and name in self.api["constants"]:
                yield [f".. c:macro:: {name}", "", f"   ``{self.api['constants'][name]}``", ""]
            elif kind == "function" and name in self.functions and text[:match.start()].rstrip().split("\n")[-1].startswith("GPHYS_API"):
                yield self.function(name)

    def pages(self):
        """{name: text} of the pages."""
        pages, listed = {}, []
        for name, title, introduction, text in sections(self.header):
            heading = "Questions about shapes" if name == "shapes" else title
            body = [heading, "=" * len(heading), ""] + self.paragraphs(introduction[:1].upper() + introduction[1:], "")
            for entry in self.entries(text):
                body += entry
            pages[name] = "\n".join(body)
            listed.append(name)
        missing = [name for name in [*self.functions, *self.structs, *self.values]
                   if not any(re.search(rf":: .*\b{name}\b", page) for page in pages.values())]
        if missing:
            raise SystemExit(f"the reference leaves out {' '.join(missing)}")
        index = ["Reference", "=========", "", "The C interface, from ``include/gamephys_c.h``. Conventions first.", "",
                 ".. toctree::", "", *(f"   {name}" for name in listed), "", "Conventions", "-----------", "",
                 *self.prose("\n".join(conventions(self.header))).splitlines()]
        pages["index"] = "\n".join(index)
        return pages
