// Casts between the opaque structs of the public header, which are never defined, and the internal objects.
#pragma once

#include "foundation/status.h"

namespace gphys {

#define GPHYS_HANDLE(Object, Handle)                                                                      \
    class Object;                                                                                         \
    inline Object* unwrap(Handle* handle) { return reinterpret_cast<Object*>(handle); }                   \
    inline const Object* unwrap(const Handle* handle) { return reinterpret_cast<const Object*>(handle); } \
    inline Handle* wrap(Object* object) { return reinterpret_cast<Handle*>(object); }
GPHYS_HANDLE(Mesh, gphys_mesh)
GPHYS_HANDLE(Scene, gphys_scene)
GPHYS_HANDLE(Camera, gphys_camera)
GPHYS_HANDLE(Solver, gphys_solver)
#undef GPHYS_HANDLE

}  // namespace gphys
