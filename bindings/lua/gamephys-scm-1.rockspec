rockspec_format = '3.0'
package = 'gamephys'
version = 'scm-1'
source = { url = '.' } -- luarocks make, in this folder
description = {
    summary = 'A 3D scene library: ray casts, overlap and nearest queries, culling, picking, ropes and cloth',
    detailed = 'Objects and methods for LuaJIT over the native library gamephys, which is written in C++ and computes the same bits on every processor.',
    license = 'MIT',
    maintainer = 'The gamephys authors',
    labels = { 'physics', '3d', 'raycast', 'cloth', 'ffi' },
}
dependencies = { 'lua == 5.1' } -- LuaJIT
build = {
    type = 'builtin',
    modules = {
        gamephys = 'gamephys.lua',
        ['gamephys.declarations'] = 'gamephys/declarations.lua',
        ['gamephys.methods'] = 'gamephys/methods.lua',
    },
}
