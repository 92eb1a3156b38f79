// Casts between the opaque structs of the public header, which are never defined, and the internal objects.
#pragma once

#include "foundation/status.h"

namespace gphys {

class Mesh;
class Scene;
class Camera;
class Solver;

inline Mesh* unwrap(gphys_mesh* mesh) { return reinterpret_cast<Mesh*>(mesh); }
inline Scene* unwrap(gphys_scene* scene) { return reinterpret_cast<Scene*>(scene); }
inline Camera* unwrap(gphys_camera* camera) { return reinterpret_cast<Camera*>(camera); }
inline Solver* unwrap(gphys_solver* solver) { return reinterpret_cast<Solver*>(solver); }

inline const Mesh* unwrap(const gphys_mesh* mesh) { return reinterpret_cast<const Mesh*>(mesh); }
inline const Scene* unwrap(const gphys_scene* scene) { return reinterpret_cast<const Scene*>(scene); }
inline const Camera* unwrap(const gphys_camera* camera) { return reinterpret_cast<const Camera*>(camera); }
inline const Solver* unwrap(const gphys_solver* solver) { return reinterpret_cast<const Solver*>(solver); }

inline gphys_mesh* wrap(Mesh* mesh) { return reinterpret_cast<gphys_mesh*>(mesh); }
inline gphys_scene* wrap(Scene* scene) { return reinterpret_cast<gphys_scene*>(scene); }
inline gphys_camera* wrap(Camera* camera) { return reinterpret_cast<gphys_camera*>(camera); }
inline gphys_solver* wrap(Solver* solver) { return reinterpret_cast<gphys_solver*>(solver); }

}  // namespace gphys
