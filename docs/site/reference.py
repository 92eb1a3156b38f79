"""The reference as pages of reStructuredText, from the header and what cmake/interface/record.sh keeps of it.

The header gives the sections, their order and the conventions at its top; bindings/gamephys_api.json, which a test
holds equal to the header, gives functions, parameters, fields and comments. Each function shows an example from a
program of docs/examples, without which there is no reference, and lists the programs that call it.

reference.py SOURCE: checks that each function has an example.
"""
import json
import re
import sys
from pathlib import Path

TITLES = {"Status and version": "status", "Values": "values", "Shapes": "shapes", "Mesh": "mesh", "Scene": "scene",
          "Camera": "camera", "Solver": "solver"}
BANNER = re.compile(r"^/\* -{20,}\n((?: \* .*\n| \*\n)+?) \* -{20,} \*/$", re.M)
PREFIXES = ["GPHYS_API"]  # a macro of the header itself
PROGRAMS = ["docs/examples/*.c", "docs/guide/*.md", "examples/*.c", "examples/viewer/*.c"]
# An example: a function that returns nothing, and the comment before it.
EXAMPLE = re.compile(r"^/\*(?:(?!\*/)[\s\S])*\*/\nstatic void \w+\((?:.*\n)+?}\n", re.M)
MACROS = "examples/check.h"  # of the examples
LONGEST = 20  # lines of an example


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
    start = header.index("CONVENTIONS")
    text = re.sub(r"^ \* ?", "", header[start:header.index("*/", start)], flags=re.M)
    lines = ["The rules below hold for every function unless its own comment says otherwise.", ""]
    for term, body in re.findall(r"^([A-Z][a-z]+) {2,}(.*(?:\n +.*)*)", text, re.M):
        lines += [term, *("   " + line.strip() for line in body.splitlines()), ""]
    return lines


def calls(text):
    return re.findall(r"\bgphys_\w+(?=\()", text)


def alike_joined(fields):
    """One field for parameters in a row that have the same text."""
    joined = []
    for title, body in fields:
        if joined and title.startswith("param ") and joined[-1][0].startswith("param ") and joined[-1][1] == body:
            joined[-1] = (f"{joined[-1][0]}, {title[len('param '):]}", body)
        else:
            joined.append((title, body))
    return joined


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
        self.examples = self.find_examples()
        self.programs = self.find_programs()

    def find_examples(self):
        """{function: (path, lines)} of the example that shows it with the fewest others, and of these before others."""
        found = {}
        for path in sorted(self.source.glob(PROGRAMS[0])):
            for text in EXAMPLE.findall(path.read_text()):
                names, lines = list(dict.fromkeys(calls(text))), text.splitlines()
                if len(lines) > LONGEST:
                    raise SystemExit(f"{path}: an example has {len(lines)} lines, more than {LONGEST}: {lines[0]}")
                for place, name in enumerate(names):
                    found.setdefault(name, []).append((len(names), place, len(lines), path.relative_to(self.source), lines))
        missing = [name for name in self.functions if name not in found]
        if missing:
            raise SystemExit(f"no example of docs/examples calls {' '.join(missing)}")
        return {name: min(several)[-2:] for name, several in found.items()}

    def setting(self, path):
        """What the comment at the top of a program says of its examples, behind its first sentence."""
        comment = re.match(r"/\*((?:(?!\*/)[\s\S])*)\*/", (self.source / path).read_text()).group(1)
        return " ".join(re.sub(r"\n \* ?", " ", comment).split()).partition(". ")[2]

    def find_programs(self):
        """{function: paths of the programs that call it}, that of its example first."""
        programs = {name: [path.as_posix()] for name, (path, _) in self.examples.items()}
        for pattern in PROGRAMS[1:]:
            for path in sorted(self.source.glob(pattern)):
                text = path.read_text()
                if path.suffix == ".md":
                    text = "".join(re.findall(r"^```c\n(.*?)^```", text, re.M | re.S))
                for name in dict.fromkeys(calls(text)):
                    programs[name].append(path.relative_to(self.source).as_posix())
        return programs

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
            tag = re.match(r"@param +(\w+) +(.*)|@return +(.*)", line)
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
        for title, body in sorted(alike_joined(fields), key=lambda field: field[0] in ("Cost", "Threads", "Error")):
            body = self.prose(" ".join(part.strip() for part in body))
            lines.append(f"   :{title.replace('param', 'Parameters', 1) if ',' in title else title}: {body}")
        programs = self.programs[name][:4]
        shown = [f":download:`{path} </{path}>`" if not path.endswith(".md") else f":doc:`/{path[:-3]}`" for path in programs]
        path, example = self.examples[name]
        lines += [f"   :Programs: {', '.join(shown)}", "", *self.paragraphs(self.setting(path), "   ")]
        lines += ["   .. code-block:: c", "", *(f"      {line}" for line in example)]
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
                 "Each function has an example, a part of a program that the tests compile and run. ``MUST(call)`` stops the",
                 "program with the library's explanation if a call does not return ``GPHYS_OK``, and ``EXPECT(condition)``",
                 f"stops it if an answer is not what the example says: :download:`{MACROS} </{MACROS}>`.", "",
                 ".. toctree::", "", *(f"   {name}" for name in listed), "", "Conventions", "-----------", "",
                 *self.prose("\n".join(conventions(self.header))).splitlines()]
        pages["index"] = "\n".join(index)
        return pages


if __name__ == "__main__":
    print(f"{len(Reference(Path(sys.argv[1])).functions)} functions, each with an example")
