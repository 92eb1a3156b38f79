rockspec_format = '3.0'
package = 'gamephys'
version = 'scm-1'
source = { url = '.' } -- luarocks make, in this folder
description = { summary = '3D scene queries, camera and cloth, through the native library', license = 'MIT' }
dependencies = { 'lua == 5.1' } -- LuaJIT
build = {
    type = 'builtin',
    modules = {
        gamephys = 'gamephys.lua',
        ['gamephys.declarations'] = 'gamephys/declarations.lua',
        ['gamephys.methods'] = 'gamephys/methods.lua',
    },
}
