--- 3D scenes for LuaJIT: shapes and meshes, rays and overlaps, a camera, particles, ropes and cloth.
-- Values are the library's own structs, batches are FFI arrays of them, which are read and written in
-- place. A query that finds nothing returns nil; what goes wrong is raised with the library's message.
local ffi = require 'ffi'
local declared = require 'gamephys.declarations'
local declared_methods = require 'gamephys.methods'

ffi.cdef(declared.declarations)
local names = { OSX = 'libgamephys.1.dylib', Windows = 'gamephys.dll' }
local packaged = package.searchpath('gamephys.native', package.cpath) -- in rocks of a platform
local C = ffi.load(os.getenv 'GAMEPHYS_LIBRARY' or packaged or names[ffi.os] or 'libgamephys.so.1')

local gp, runtime = {}, { C = C, classes = {} }
for name, number in pairs(declared.constants) do gp[name] = number end
local OK, INCOMPLETE = gp.OK, gp.INCOMPLETE

-- Functions are looked up when they are called: an older library is refused before one is missed.
local version = C.gphys_version()
local major, minor = bit.rshift(version, 16), bit.band(bit.rshift(version, 8), 255)
if major ~= gp.VERSION_MAJOR or minor < gp.VERSION_MINOR then
    error(('the library is gamephys %d.%d, this package needs %d.%d'):format(major, minor, gp.VERSION_MAJOR, gp.VERSION_MINOR), 0)
end

-- Errors -----------------------------------------------------------------------------------------

--- What is raised: tostring gives the library's message, status its number.
local Error = { __tostring = function(self) return self.message end }

local function raise(status)
    error(setmetatable({ status = status, message = ffi.string(C.gphys_last_error()) }, Error))
end

function runtime.check(status)
    if status < 0 then raise(status) end
    return status
end

function runtime.found(status)
    if status < 0 then raise(status) end
    return status == OK
end

--- A status that is an answer: OK is yes, `no` is no.
function runtime.answered(status, no)
    return status ~= no and runtime.found(status)
end

--- Whether something caught by pcall came from the library.
function gp.is_error(caught) return getmetatable(caught) == Error end

-- Values -----------------------------------------------------------------------------------------

--- What is known of a C type: how to make one and many, its size.
local elements = {}
function runtime.element(name)
    local known = elements[name]
    if not known then
        known = {
            name = name,
            new = ffi.typeof(name),
            array = ffi.typeof(name .. '[?]'),
            pointer = ffi.typeof(name .. '*'),
            size = ffi.sizeof(name),
            init = name:match '_desc$' and C[name .. '_init'],
            numbers = name == 'gphys_mat4' and 16 or nil,
        }
        elements[name] = known
    end
    return known
end

local function refused(value, name, expected)
    if type(value) == 'number' then error(('%s %.17g is not %s'):format(name, value, expected), 4) end
    error(('%s: expected a number, got %s'):format(name, tostring(value)), 4)
end

--- An id, an index or a number of something. The C call would take what remains of it in 32 bits.
function runtime.whole(value, name)
    if type(value) == 'number' and value >= 0 and value < 2 ^ 32 and value % 1 == 0 then return value end
    if type(value) == 'cdata' then return runtime.whole(tonumber(value), name) end
    return refused(value, name, 'a whole number from 0 to 4294967295')
end

--- A set of bits, which the bit library gives with a sign.
function runtime.bits(value, name)
    if type(value) == 'number' and value >= -2 ^ 31 and value < 2 ^ 32 and value % 1 == 0 then return value % 2 ^ 32 end
    return refused(value, name, 'a set of 32 bits')
end

--- One of an enumeration's.
function runtime.signed(value, name)
    if type(value) == 'number' and value >= -2 ^ 31 and value < 2 ^ 31 and value % 1 == 0 then return value end
    return refused(value, name, 'a whole number of 32 bits')
end

function runtime.real(value, name)
    if type(value) == 'number' then return value end
    if type(value) == 'cdata' then return tonumber(value) or refused(value, name) end
    return refused(value, name)
end

--- A table of fields by name, with what is meant by those that are missing.
local function by_name(of, given)
    local all = {}
    for name, value in pairs(of.unsaid) do all[name] = value end
    for name, value in pairs(given) do
        if not of.fields[name] then error(('%s has no field %s'):format(of.name, tostring(name)), 4) end
        all[name] = value
    end
    return all
end

--- A struct as it is, or made from a table; a matrix from 16 numbers.
function runtime.to_value(of, given)
    if type(given) ~= 'table' then return given end
    if #given == of.numbers then return of.new({ given }) end
    if of.built and given[1] == nil then given = by_name(of, given) end
    if of.third and given[3] == nil and given[2] ~= nil then return ffi.new(of.new, given[1], given[2], of.third) end
    return ffi.new(of.new, given)
end

local void = ffi.typeof 'void*'

--- A pointer does not say how many elements it has, and its own size would be taken for theirs.
local function refuse_pointer(of, given)
    if ffi.istype(of.pointer, given) or ffi.istype(void, given) then error('a pointer does not say how many elements it has', 4) end
end

--- A given number of elements.
function runtime.to_numbers(of, given, count)
    if type(given) == 'table' then given = of.array(#given, given) end
    if type(given) ~= 'cdata' then error(('expected %d numbers, got a %s'):format(count, type(given)), 3) end
    refuse_pointer(of, given)
    if ffi.sizeof(given) ~= count * of.size then error(('expected %d numbers, got %d'):format(count, ffi.sizeof(given) / of.size), 3) end
    return given
end

--- What descs point to lives as long as they do.
local kept = setmetatable({}, { __mode = 'k' })

--- A list of ids in a desc: a table or an array of them, and its length beside it.
local function list_into(made, name, count, given)
    local of = runtime.element 'uint32_t'
    if type(given) == 'table' then
        for _, id in ipairs(given) do runtime.whole(id, name) end
        given = of.array(#given, given)
    end
    local list = runtime.to_array(of, given)
    made[name], made[count] = list, list and gp.length(list) or 0
    kept[made] = list
end

--- Settings: the library's defaults, changed by a table.
function runtime.to_desc(of, given)
    if type(given) ~= 'table' then return given end
    local made = of.new()
    runtime.check(of.init(made, of.size))
    for name, field in pairs(given) do
        if of.lists[name] then
            list_into(made, name, of.lists[name], field)
        else
            if of.numbers_of[name] then field = runtime[of.numbers_of[name]](field, name) end
            made[name] = field
        end
    end
    return made
end

function runtime.to_flag(given, name)
    if type(given) == 'boolean' then return given and 1 or 0 end
    return runtime.signed(given, name)
end

-- Shapes -----------------------------------------------------------------------------------------

local function opened(object)
    local pointer = object.pointer
    if pointer == nil then error(object.name .. ' is closed', 3) end
    return pointer
end
runtime.opened = opened

function runtime.kind(shape)
    local kind = type(shape) == 'cdata' and shape.kind
    if not kind then error('not a shape: ' .. tostring(shape), 3) end
    return kind
end

function runtime.address(shape)
    if shape.kind == gp.SHAPE_MESH then return opened(shape) end
    return shape
end

-- Arrays -----------------------------------------------------------------------------------------

--- An array of zeros, or of the elements of a table: array('ray', 100), array('float', {1, 2, 3}).
function gp.array(name, given)
    local of = runtime.element(elements['gphys_' .. name] and 'gphys_' .. name or name)
    if type(given) == 'table' then return of.array(#given, given) end
    return of.array(given)
end

--- How many elements an array has.
function gp.length(array)
    for _, name in ipairs { 'uint32_t', 'int32_t', 'float', 'double' } do
        if ffi.istype(runtime.element(name).array, array) then return ffi.sizeof(array) / elements[name].size end
    end
    return ffi.sizeof(array) / ffi.sizeof(array[0])
end

--- Memory of the caller, the number of elements in it and the bytes between them. One struct stands
--- for all: it has no number, and a step of 0.
function runtime.to_array(of, given, width)
    if given == nil then return nil, nil, 0 end
    if type(given) == 'table' then
        if of.name == 'uint32_t' then
            for i, number in ipairs(given) do runtime.whole(number, 'element ' .. i) end
        end
        given = of.array(#given, given)
    end
    if type(given) ~= 'cdata' then error('expected an array or a table, got a ' .. type(given), 3) end
    refuse_pointer(of, given)
    if ffi.istype(of.new, given) then return given, nil, 0 end
    local bytes, size = ffi.sizeof(given), of.size * (width or 1)
    if bytes % size ~= 0 then error('not a whole number of elements of ' .. size .. ' bytes', 3) end
    return given, bytes / size, size
end

--- The same for shapes, with their kind before the number.
function runtime.to_shapes(given)
    if type(given) == 'table' then
        local of = runtime.element(given[1] and runtime.kind(given[1]) and given[1].struct or 'gphys_sphere') -- none are of any kind
        given = of.array(#given, given)
    end
    if type(given) == 'cdata' and ffi.istype(elements.gphys_mesh.new, given) then
        return opened(given), gp.SHAPE_MESH, nil, 0
    end
    for _, of in ipairs(elements.shapes) do
        if ffi.istype(of.new, given) then return given, of.kind, nil, 0 end
        if ffi.istype(of.array, given) then return given, of.kind, ffi.sizeof(given) / of.size, of.size end
    end
    error('not shapes: ' .. tostring(given), 3)
end

--- The same for settings: tables of fields, for each element or for all, over the library's defaults.
function runtime.to_descs(of, given)
    if type(given) ~= 'table' then return runtime.to_array(of, given) end
    if not given[1] then return runtime.to_desc(of, given), nil, 0 end
    local made, each = of.array(#given), {}
    for i, fields in ipairs(given) do
        each[i] = runtime.to_desc(of, fields)
        made[i - 1] = each[i]
    end
    if next(of.lists) then kept[made] = each end
    return made, #given, of.size
end

--- The length that arrays share; nil stands for any.
function runtime.common(first, second, third)
    local count = first or second or third or error('no array says how many there are', 3)
    local other = second and second ~= count and second or third and third ~= count and third
    if other then error(('arrays of different lengths: %d and %d'):format(count, other), 3) end
    return count
end

--- Room for results: the caller's, if it gave some.
function runtime.results(of, out, count)
    if not out then return of.array(count) end
    if type(out) ~= 'cdata' then error('room for results must be an array, not a ' .. type(out), 3) end
    refuse_pointer(of, out)
    if ffi.sizeof(out) ~= count * of.size then error('room for results has another length', 3) end
    return out
end

local function trimmed(of, out, capacity, total)
    if capacity == total then return out end
    local exact = of.array(total)
    ffi.copy(exact, out, total * of.size)
    return exact
end

--- All elements of a list, whose call is repeated with enough room if it has to be; and their number.
function runtime.list(of, call)
    local capacity, total = 64, ffi.new 'uint32_t[1]'
    while true do
        local out = of.array(capacity)
        if runtime.check(call(out, capacity, total)) ~= INCOMPLETE then
            return trimmed(of, out, capacity, total[0]), total[0]
        end
        capacity = total[0]
    end
end

--- A list for each element: those of element i are values[offsets[i]] up to values[offsets[i + 1]].
function runtime.ragged(of, call, count)
    local capacity, offsets = math.max(64, count), ffi.new('uint32_t[?]', count + 1)
    while true do
        local out = of.array(capacity)
        if runtime.check(call(out, capacity, offsets)) ~= INCOMPLETE then
            return trimmed(of, out, capacity, offsets[count]), offsets
        end
        capacity = offsets[count]
    end
end

-- Objects ----------------------------------------------------------------------------------------

--- A class whose instances own an object of the library: freed by close, or by the collector.
function runtime.class(name)
    local struct = ('gphys_lua_%s'):format(name)
    ffi.cdef(('typedef struct { gphys_%s* pointer; } %s;'):format(name, struct))
    local destroy, box = C[('gphys_%s_destroy'):format(name)], ffi.typeof(('gphys_%s*[1]'):format(name))
    local class = { name = name, kind = name == 'mesh' and gp.SHAPE_MESH or nil }
    --- Free the object now. Using it afterwards is an error; closing again does nothing.
    function class:close()
        destroy(self.pointer)
        self.pointer = nil
    end
    local new = ffi.metatype(struct, { __index = class, __gc = class.close })
    elements['gphys_' .. name] = { new = new }
    runtime.classes[name] = class
    function class.create(call)
        local made = box()
        runtime.check(call(made))
        return new(made[0])
    end
    return class
end

--- A value as its field by field text, for printing and for messages.
local function described(fields)
    return function(self)
        local words = {}
        for i, name in ipairs(fields) do words[i] = name .. ' = ' .. tostring(self[name]) end
        return '{' .. table.concat(words, ', ') .. '}'
    end
end

-- What a field is that is not given; the others are 0.
local unsaid = {
    transform = { rotation = { 0, 0, 0, 1 }, scale = 1 },
    ray = { t_max = math.huge },
    obb = { rotation = { 0, 0, 0, 1 } },
    quat = { w = 1 },
}
elements.shapes = {}
local kinds = {}
for _, name in ipairs(declared.shapes) do kinds[name] = gp['SHAPE_' .. name:upper()] end
for _, struct in ipairs(declared.structs) do
    local name, of = struct.name, runtime.element('gphys_' .. struct.name)
    of.kind = kinds[name]
    if of.kind then elements.shapes[#elements.shapes + 1] = of end
    of.fields, of.unsaid, of.numbers_of = {}, unsaid[name] or {}, struct.numbers
    of.lists = struct.lists or {}
    of.built, of.third = struct.built, of.unsaid[struct.fields[3]]
    for _, field in ipairs(struct.fields) do of.fields[field] = true end
    ffi.metatype(of.new, {
        __new = struct.built and function(kind, first, second, third, fourth)
            if first == nil then return ffi.new(kind, of.unsaid) end
            if type(first) == 'table' and first[1] == nil then return ffi.new(kind, by_name(of, first)) end
            if second == nil then return ffi.new(kind, first) end
            third = third or of.third
            if fourth ~= nil then return ffi.new(kind, first, second, third, fourth) end
            if third ~= nil then return ffi.new(kind, first, second, third) end
            return ffi.new(kind, first, second)
        end or nil,
        __tostring = described(struct.fields),
        __index = { kind = of.kind, struct = of.name },
    })
    -- gphys_model_info is gp.ModelInfo
    gp[(name:gsub('^%l', string.upper):gsub('_(%l)', string.upper))] = of.new
end

declared_methods(gp, runtime)

-- What needs more than its declaration -----------------------------------------------------------

local version = C.gphys_version()
gp.VERSION = ('%d.%d.%d'):format(bit.rshift(version, 16), bit.band(bit.rshift(version, 8), 255), bit.band(version, 255))

--- Name of a status, such as "GPHYS_NO_HIT".
function gp.status_name(status) return ffi.string(C.gphys_status_name(status)) end

--- The orbit settings that the library starts from.
function gp.default_orbit()
    local orbit = gp.Orbit()
    runtime.check(C.gphys_orbit_init(orbit))
    return orbit
end

--- The shape moved by a transform; an Aabb becomes an Obb.
function gp.transform(shape, by)
    local kind = runtime.kind(shape)
    local moved = (kind == gp.SHAPE_AABB or kind == gp.SHAPE_MESH) and gp.Obb() or ffi.typeof(shape)()
    runtime.check(C.gphys_shape_transform(kind, runtime.address(shape), runtime.to_value(elements.gphys_transform, by), moved))
    return moved
end

--- The shape of a model in its own coordinates; an error for a mesh, which gp.Mesh_from_scene gives.
function runtime.classes.scene:get_shape(model)
    local kind, of = self:get_info(model).type, elements.gphys_frustum
    for _, shape in ipairs(elements.shapes) do
        if shape.kind == kind then of = shape end
    end
    local shape = of.new()
    runtime.check(C.gphys_scene_get_shape(opened(self), model, shape, of.size))
    return shape
end

return gp
