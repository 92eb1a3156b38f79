"""What the parameters of a function are for, read off the header's conventions:

handle      the object a function is about, or another one that it uses
new         where a created handle is put
shape_type, shape    `type, const void* shape`: a struct whose kind is told by a number
in          a pointer to one struct
array       pointer, [stride,] count: elements that are read
out         a pointer to one result
out_array   pointer, [stride]: one result for each element
list        out, capacity, out_total: as many results as there are
ragged      out, capacity, out_offsets: such a list for each element
stride, count, capacity, total, offsets    go with the above
scalar      a plain number
raw         none of these: only for callers of the C function itself
"""

# What `const float*` stands for, where it is not one float an element.
WIDTHS = {"points": 3, "vertices": 3, "pixels": 2}
# How many results there are, where no count says it.
LENGTHS = {"gphys_camera_pick_rays": "width * height"}


def element(parameter):
    return parameter["type"].replace("const ", "").rstrip("* ").strip()



def nullable(function, p):
    """Pointers that may be NULL, apart from outputs."""
    name = p["name"]
    if name in ("desc", "filter", "local_point"):
        return p["role"] == "in"
    if name in ("transform", "transforms"):
        return "_add" in function["name"]
    if name in ("descs", "filters", "library"):
        return True
    return name == "scene" and function["name"] in ("gphys_solver_step", "gphys_solver_advance")


def assign(function, handles):
    parameters = function["parameters"]
    names = [p["name"] for p in parameters]
    counted = any(name == "count" or name.endswith("_count") for name in names)
    for i, p in enumerate(parameters):
        name, of = p["name"], p["type"]
        following = names[i + 1:i + 3]
        pointer = of.endswith("*")
        is_const = of.startswith("const ")
        output = pointer and not is_const
        if of.endswith("**"):
            p["role"] = "new" if element(p) in handles else "raw"
        elif pointer and element(p) in handles:
            p["role"] = "handle"
        elif of == "gphys_shape_type":
            p["role"] = "shape_type"
        elif name == "count" or name.endswith("_count"):
            p["role"] = "count"
        elif name == "stride" or name.endswith("_stride"):
            p["role"] = "stride"
        elif name == "capacity":
            p["role"] = "capacity"
        elif name == "out_total":
            p["role"] = "total"
        elif name == "out_offsets":
            p["role"] = "offsets"
        elif output and following[:1] == ["capacity"] and following[1:] in (["out_total"], ["out_offsets"]):
            p["role"] = "list" if following[1] == "out_total" else "ragged"
        elif "void" in element(p):
            if is_const:
                p["role"] = "shape"
            else:
                p["role"] = "raw"
        elif pointer and is_const:
            strided = following[:1] and following[0].endswith("stride")
            p["role"] = "array" if strided or following[:1] and following[0].endswith("count") else "in"
            # `models, transforms, transform_stride, count`: an array without a stride of its own
            whole = element(p) == "gphys_frustum" or element(p).endswith("_desc")
            if p["role"] == "in" and counted and name.endswith("s") and not whole:
                p["role"] = "array"
        elif output:
            strided = following[:1] == ["out_stride"] or following[:1] == ["stride"]
            plural = function["name"].endswith("_batch") and name.endswith("s")
            p["role"] = "out_array" if strided or plural else "out"
        elif "(*)" in of or of == "gphys_task":
            p["role"] = "raw"
        else:
            p["role"] = "scalar"
        if p["role"] in ("array", "out_array") and element(p) == "float" and name in WIDTHS:
            p["width"] = WIDTHS[name]
        if p["role"] == "out_array" and function["name"] in LENGTHS:
            p["length"] = LENGTHS[function["name"]]
        if nullable(function, p):
            p["nullable"] = True
    # A shape with a stride of its own is one of an array of them.
    for i, p in enumerate(parameters[:-1]):
        if p["role"] == "shape" and parameters[i + 1]["role"] == "stride":
            p["role"] = "array"


def may_miss(function):
    """Whether GPHYS_OK may fail to come without an error: outputs are untouched then."""
    outputs = [p for p in function["parameters"] if p["role"].startswith(("out", "list", "ragged"))]
    said = "GPHYS_NO_HIT" in function["doc"] or "GPHYS_UNBOUNDED" in function["doc"]
    found = any(element(p) in ("gphys_hit", "gphys_nearest") for p in outputs)
    return bool(outputs) and all(p["role"] == "out" for p in outputs) and (said or found)


def with_roles(api):
    for function in api["functions"]:
        assign(function, api["handles"])
        function["may_miss"] = may_miss(function)
    return api
