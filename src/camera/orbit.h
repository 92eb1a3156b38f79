// Orbit control: a view that circles a target, with angles, limits and input. Independent of the camera.
#pragma once

#include "foundation/math.h"

namespace gphys {

class Orbit {
public:
    /// `right_sign`: 1 if right is cross(up, forward), as for a left-handed camera; -1 if it is
    /// cross(forward, up). Angles and distance outside their limits are brought inside.
    Orbit(const gphys_orbit& settings, double right_sign);

    // Input accumulates until the next update.
    void rotate(double units_x, double units_y);
    void zoom(double units);
    void pan(double units_right, double units_up);
    void update();
    void set_speeds(const gphys_orbit_speeds& speeds) { speeds_ = speeds; }
    const gphys_orbit_speeds& speeds() const { return speeds_; }
    /// Move the target: the origin of the world has changed.
    void shift(Vec3 offset) { target_ += offset; }

    gphys_orbit settings() const;
    /// Columns right, up, forward.
    Mat3 axes() const;
    Vec3 position() const;

private:
    void limit();

    gphys_orbit settings_;
    gphys_orbit_speeds speeds_;
    Vec3 up_, yaw_zero_, yaw_quarter_;  // orthonormal: the view at yaw 0 and at yaw pi / 2
    Vec3 target_;
    double yaw_, pitch_, distance_;
    double pending_yaw_ = 0, pending_pitch_ = 0, pending_zoom_ = 0;  // in input units
    double pending_right_ = 0, pending_up_ = 0;
};

}  // namespace gphys
