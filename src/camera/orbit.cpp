// Orbit control: pending input is applied to yaw, pitch, distance and target, within the limits (orbit.h).
#include "camera/orbit.h"

#include "foundation/elementary.h"

namespace gphys {

Orbit::Orbit(const gphys_orbit& settings, double right_sign)
    : settings_(settings),
      speeds_{settings.radians_per_unit, settings.radians_per_unit, settings.metres_per_unit, settings.metres_per_unit,
              settings.metres_per_unit},
      up_(normalized(widen(settings.up))),
      yaw_zero_(cross(perpendicular(up_), up_)),
      yaw_quarter_(cross(up_, yaw_zero_) * right_sign),
      target_(widen(settings.target)),
      yaw_(settings.yaw),
      pitch_(settings.pitch),
      distance_(settings.distance) {
    limit();
}

void Orbit::rotate(double units_x, double units_y) {
    pending_yaw_ += units_x;
    pending_pitch_ += units_y;
}

void Orbit::zoom(double units) { pending_zoom_ += units; }

void Orbit::pan(double units_right, double units_up) {
    pending_right_ += units_right;
    pending_up_ += units_up;
}

// Panning comes first, because the input refers to the image of the last update.
void Orbit::update() {
    const Mat3 seen = axes();
    target_ += seen.x * (pending_right_ * speeds_.pan_x) + seen.y * (pending_up_ * speeds_.pan_y);
    yaw_ += pending_yaw_ * speeds_.rotate_x;
    pitch_ += pending_pitch_ * speeds_.rotate_y;
    distance_ -= pending_zoom_ * speeds_.zoom;
    pending_yaw_ = pending_pitch_ = pending_zoom_ = pending_right_ = pending_up_ = 0;
    limit();
}

// The float nearest to pi / 2 is above it, and beyond pi / 2 the view would turn over.
void Orbit::limit() {
    constexpr double furthest = GPHYS_MAX_COORDINATE;
    yaw_ = std::remainder(yaw_, 2 * pi);
    pitch_ = std::clamp<double>(pitch_, settings_.min_pitch, settings_.max_pitch);
    pitch_ = std::clamp(pitch_, -pi / 2, pi / 2);
    distance_ = std::clamp(distance_, static_cast<double>(settings_.min_distance),
                           std::min(static_cast<double>(settings_.max_distance), furthest));
    target_ = max(min(target_, {furthest, furthest, furthest}), {-furthest, -furthest, -furthest});
}

gphys_orbit Orbit::settings() const {
    gphys_orbit now = settings_;
    now.target = narrow(target_);
    now.yaw = static_cast<float>(yaw_);
    now.pitch = static_cast<float>(pitch_);
    now.distance = static_cast<float>(distance_);
    return now;
}

// Computed from the angles, which are well defined even where the view is parallel to up; a look-at matrix is not.
Mat3 Orbit::axes() const {
    const SinCos pitch = sin_cos(pitch_), yaw = sin_cos(yaw_);
    const Vec3 level = yaw_zero_ * yaw.cos + yaw_quarter_ * yaw.sin;
    const Vec3 right = yaw_quarter_ * yaw.cos - yaw_zero_ * yaw.sin;
    return {right, level * pitch.sin + up_ * pitch.cos, level * pitch.cos - up_ * pitch.sin};
}

Vec3 Orbit::position() const { return target_ - axes().z * distance_; }

}  // namespace gphys
