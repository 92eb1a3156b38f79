// gphys_orbit_init, gphys_camera_set_orbit and the input of the orbit.
#include "camera/camera.h"

#include "c_api/api.h"
#include "c_api/handles.h"

using namespace gphys;

namespace {

bool is_pitch(float angle) { return std::fabs(angle) <= static_cast<float>(pi / 2); }

gphys_status check(const gphys_orbit_speeds& speeds) {
    GPHYS_TRY(check_coordinate("speeds.rotate_x", speeds.rotate_x));
    GPHYS_TRY(check_coordinate("speeds.rotate_y", speeds.rotate_y));
    GPHYS_TRY(check_coordinate("speeds.zoom", speeds.zoom));
    GPHYS_TRY(check_coordinate("speeds.pan_x", speeds.pan_x));
    return check_coordinate("speeds.pan_y", speeds.pan_y);
}

gphys_status check(const gphys_orbit& orbit) {
    GPHYS_TRY(check_valid("orbit.target", orbit.target));
    GPHYS_TRY(check_valid("orbit.up", orbit.up));
    GPHYS_REQUIRE_IN_RANGE(widen(orbit.up) != Vec3{}, "orbit.up: length", 0, "above 0");
    GPHYS_REQUIRE_IN_RANGE(orbit.distance > 0 && is_coordinate(orbit.distance), "orbit.distance", orbit.distance,
                           positive_range);
    GPHYS_TRY(check_coordinate("orbit.yaw", orbit.yaw));
    GPHYS_TRY(check_coordinate("orbit.pitch", orbit.pitch));
    GPHYS_TRY(check_coordinate("orbit.radians_per_unit", orbit.radians_per_unit));
    GPHYS_TRY(check_coordinate("orbit.metres_per_unit", orbit.metres_per_unit));
    GPHYS_REQUIRE_IN_RANGE(orbit.min_distance > 0 && is_coordinate(orbit.min_distance), "orbit.min_distance",
                           orbit.min_distance, positive_range);
    GPHYS_REQUIRE_IN_RANGE(orbit.max_distance >= orbit.min_distance, "orbit.max_distance", orbit.max_distance,
                           "at least min_distance");
    GPHYS_REQUIRE_IN_RANGE(is_pitch(orbit.min_pitch), "orbit.min_pitch", orbit.min_pitch, "from -pi/2 to pi/2");
    GPHYS_REQUIRE_IN_RANGE(is_pitch(orbit.max_pitch) && orbit.min_pitch <= orbit.max_pitch, "orbit.max_pitch",
                           orbit.max_pitch, "from min_pitch to pi/2");
    return GPHYS_OK;
}

gphys_status check_finite(const char* name, float value) {
    GPHYS_REQUIRE_IN_RANGE(std::isfinite(value), name, value, "finite");
    return GPHYS_OK;
}

/// apply(Orbit&) for a camera that has one; a const camera has a const one.
template <class Handle, class Apply>
gphys_status with_orbit(Handle* camera, Apply&& apply) {
    GPHYS_REQUIRE_POINTERS(camera);
    auto* const orbit = unwrap(camera)->orbit();
    if (!orbit) return fail(GPHYS_ERROR_UNSUPPORTED, "camera: gphys_camera_set_orbit was not called");
    apply(*orbit);
    return GPHYS_OK;
}

}  // namespace

gphys_status gphys_orbit_init(gphys_orbit* orbit) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(orbit);
        constexpr float degrees_89 = static_cast<float>(89 * pi / 180);
        gphys_orbit initial{};
        initial.up = {0, 1, 0};
        initial.distance = 10;
        initial.radians_per_unit = 1;
        initial.metres_per_unit = 1;
        initial.min_distance = 0.01f;
        initial.max_distance = INFINITY;
        initial.min_pitch = -degrees_89;
        initial.max_pitch = degrees_89;
        *orbit = initial;
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_set_orbit(gphys_camera* camera, const gphys_orbit* orbit) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera, orbit);
        GPHYS_TRY(check(*orbit));
        unwrap(camera)->set_orbit(*orbit);
        return GPHYS_OK;
    });
}

gphys_status gphys_camera_get_orbit(const gphys_camera* camera, gphys_orbit* out_orbit) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera, out_orbit);
        return with_orbit(camera, [&](const Orbit& orbit) { *out_orbit = orbit.settings(); });
    });
}

gphys_status gphys_camera_set_orbit_speeds(gphys_camera* camera, const gphys_orbit_speeds* speeds) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera, speeds);
        GPHYS_TRY(check(*speeds));
        return with_orbit(camera, [&](Orbit& orbit) { orbit.set_speeds(*speeds); });
    });
}

gphys_status gphys_camera_get_orbit_speeds(const gphys_camera* camera, gphys_orbit_speeds* out_speeds) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_REQUIRE_POINTERS(camera, out_speeds);
        return with_orbit(camera, [&](const Orbit& orbit) { *out_speeds = orbit.speeds(); });
    });
}

gphys_status gphys_camera_orbit_rotate(gphys_camera* camera, float units_x, float units_y) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_finite("units_x", units_x));
        GPHYS_TRY(check_finite("units_y", units_y));
        return with_orbit(camera, [&](Orbit& orbit) { orbit.rotate(units_x, units_y); });
    });
}

gphys_status gphys_camera_orbit_zoom(gphys_camera* camera, float units) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_finite("units", units));
        return with_orbit(camera, [&](Orbit& orbit) { orbit.zoom(units); });
    });
}

gphys_status gphys_camera_orbit_pan(gphys_camera* camera, float units_right, float units_up) {
    return guarded(__func__, [&]() -> gphys_status {
        GPHYS_TRY(check_finite("units_right", units_right));
        GPHYS_TRY(check_finite("units_up", units_up));
        return with_orbit(camera, [&](Orbit& orbit) { orbit.pan(units_right, units_up); });
    });
}

gphys_status gphys_camera_orbit_update(gphys_camera* camera) {
    return guarded(__func__, [&]() -> gphys_status {
        return with_orbit(camera, [&](Orbit& orbit) {
            orbit.update();
            unwrap(camera)->follow_orbit();
        });
    });
}
