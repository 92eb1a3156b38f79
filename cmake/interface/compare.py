#!/usr/bin/env python3
"""Compare two descriptions of the header: compare.py OLD.json NEW.json [--compatible]

Prints every difference in meaning or layout, comments included, and fails if there is any. With
--compatible, where OLD is a release, only what docs/releasing.md forbids is printed and counted: what
breaks a program or a binding made for OLD, and additions (functions, values, types, fields at the end
of *_desc structs) without a raised minor version.
"""
import json
import sys

# Kinds of entries by the key that names them.
LISTS = ("types", "enums", "handles", "callbacks", "structs", "functions")


def named(api):
    """(what it is, name) -> entry; enums are taken apart into their values."""
    entries = {("constant", name): value for name, value in api["constants"].items()}
    for kind in LISTS:
        for entry in api[kind]:
            if kind == "enums":
                for value in entry["values"]:
                    entries["enums", value["name"]] = value
            elif isinstance(entry, str):
                entries[kind, entry] = entry
            else:
                entries[kind, entry["name"]] = entry
    return entries


def without_comments(entry):
    if isinstance(entry, dict):
        return {key: without_comments(value) for key, value in entry.items() if key not in ("doc", "role", "width", "length", "may_miss", "nullable")}
    return [without_comments(item) for item in entry] if isinstance(entry, list) else entry


def struct_breaks(name, old, new):
    grows = name.endswith("_desc")
    for i, field in enumerate(old["fields"]):
        there = new["fields"][i:i + 1]
        if there != [field]:
            yield f"{name}.{field['name']} was {field}, there is {there[0] if there else 'nothing'}"
            return
    if len(new["fields"]) > len(old["fields"]) and not grows:
        yield f"{name} is frozen and has the new field {new['fields'][len(old['fields'])]['name']}"
    elif new["size"] != old["size"] and not grows:
        yield f"{name}: size was {old['size']}, is {new['size']}"
    if new["align"] != old["align"]:
        yield f"{name}: alignment was {old['align']}, is {new['align']}"


def additions(old, new):
    for key, entry in new.items():
        if key not in old:
            yield key[1]
        elif key[0] == "structs":
            yield from (f"{key[1]}.{field['name']}" for field in entry["fields"][len(old[key]["fields"]):])


def version(api):
    return [int(number) for number in api["version"].split(".")]


def version_breaks(old, new, added):
    was, now = version(old), version(new)
    if now[0] != was[0]:
        yield f"the major version was {was[0]}, is {now[0]}: a new major version begins its own record, see docs/releasing.md"
    elif now < was:
        yield f"the version was {old['version']}, is {new['version']}"
    elif added and now[1] == was[1]:
        yield f"new since {old['version']}, so the minor version must be raised: {', '.join(added)}"


def breaks(old, new):
    for key, was in old.items():
        kind, name = key
        if name.startswith("GPHYS_VERSION_"):
            continue
        if key not in new:
            yield f"{name} is gone"
        elif kind == "structs":
            yield from struct_breaks(name, was, new[key])
        elif was != new[key]:
            yield f"{name} was {was}, is {new[key]}"


def differences(old, new):
    for key in sorted({*old, *new}):
        if old.get(key) != new.get(key):
            verb = "added" if key not in old else "removed" if key not in new else "changed"
            yield f"{verb}: {key[1]}"


def main():
    paths = [argument for argument in sys.argv[1:] if argument != "--compatible"]
    with open(paths[0]) as old, open(paths[1]) as new:
        old, new = json.load(old), json.load(new)
    if "--compatible" in sys.argv:
        was, now = named(without_comments(old)), named(without_comments(new))
        found = [*breaks(was, now), *version_breaks(old, new, list(additions(was, now)))]
    else:
        found = list(differences(named(old), named(new)))
        if not found and old != new:
            found = ["the order or the version changed"]
    print("\n".join(found))
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
