"""Turns a function into the pieces of a call, from templates that differ by language.

A template has {n} for the parameter's name and, where they exist, {shape} for the shape that a kind
belongs to, {array} for the array that a stride or count belongs to, {type} for the element's type.
"""
from ._names import element, has_stride


def arguments(call, templates, type_name):
    """The C call's arguments, in order. Templates are found by role, with '?' where the parameter may
    be NULL, or by 'self', 'shape_array' and 'plain_count' (a count that no array tells)."""
    parameters = call.function["parameters"]
    has_array = any(p["role"] == "array" for p in parameters)
    result = []
    for i, p in enumerate(parameters):
        role, values = p["role"], {"n": p["name"], "type": type_name(element(p))}
        key = role + ("?" if p.get("nullable") and role + "?" in templates else "")
        if role == "handle" and i == 0 and call.owner:
            key = "self"
        elif role == "shape_type":
            values["shape"] = parameters[i + 1]["name"]
        elif role == "array" and element(p) == "void":
            key = "shape_array"
        elif role in ("array", "out_array") and "packed_array" in templates and not has_stride(parameters, i):
            key = "packed_array"
        elif role == "stride":
            values["array"] = parameters[i - 1]["name"]
            if p["name"] == "stride" or p["name"] == "out_stride":
                values["array"] = parameters[i - 1]["name"]
            if parameters[i - 1].get("nullable"):
                key = "stride?" if "stride?" in templates else "stride"
            if parameters[i - 1]["role"] == "array" and element(parameters[i - 1]) == "void":
                key = "shape_stride" if "shape_stride" in templates else key
            values["type"] = type_name(element(parameters[i - 1]))
        elif role == "count":
            if not has_array:
                key = "plain_count"
            elif p["name"] == "count":
                key = "batch_count"
            else:
                before = [q for q in parameters[:i] if q["role"] == "array"][-1]
                values["array"], key = before["name"], "own_count"
        elif role in ("in", "out") and p.get("count"):
            key = role + "_fixed"
        elif role == "scalar":
            values["type"] = type_name(p["type"])
        result.append(templates[key].format(**values))
    return result


def batch_arrays(call):
    """The arrays whose common length is the batch's count."""
    parameters = call.function["parameters"]
    if not any(p["role"] == "count" and p["name"] == "count" for p in parameters):
        return []
    return [p for p in parameters if p["role"] == "array"]


def comment(text, prefix):
    return "".join(f"{prefix} {line}".rstrip() + "\n" for line in text.split("\n")) if text else ""
