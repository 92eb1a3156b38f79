// The inertia of points that move as one, and forces at them: rigid clusters.
#pragma once

#include "foundation/math.h"

namespace gphys {

/// Second moments of points about an origin: sums of products of coordinates.
struct SecondMoments {
    Vec3 squares, products;  // xx, yy, zz and yz, zx, xy

    void add(Vec3 at, double weight) {
        squares += by_component(at, at) * weight;
        products += Vec3{at.y * at.z, at.z * at.x, at.x * at.y} * weight;
    }
    void add(const SecondMoments& other, double weight) {
        squares += other.squares * weight;
        products += other.products * weight;
    }
    /// Of weight times squared distance.
    double sum() const { return squares.x + squares.y + squares.z; }
    /// Makes points that are nearly in a line so thick that the moment of inertia about it is at least this part of the
    /// sum of the three. Where points have left the line by an error, torques about it are not as small as that moment.
    void thicken(double part) {
        const Vec3 s = squares, p = products;
        const Vec3 x{s.y + s.z, -p.z, -p.y}, y{-p.z, s.z + s.x, -p.x}, z{-p.y, -p.x, s.x + s.y};
        const double sum = x.x + y.y + z.z;
        if (!(sum > 0)) return;
        // If one is small, the others are half of the sum.
        const double smallest = 4 * dot(x, cross(y, z)) / (sum * sum), missing = part * sum - smallest;
        if (missing > 0) squares += Vec3{missing, missing, missing} / 2;
    }
    /// The tensor of inertia. About a line through all points it is a rounding error, and so are torques: this part of
    /// the sum of squares is added to it.
    Mat3 inertia(double regularisation) const {
        const Vec3 s = squares, p = products;
        const double least = regularisation * (s.x + s.y + s.z);
        return {{s.y + s.z + least, -p.z, -p.y}, {-p.z, s.z + s.x + least, -p.x}, {-p.y, -p.x, s.x + s.y + least}};
    }
    /// Its inverse, times its determinant.
    Mat3 inverse(double regularisation, double& determinant) const {
        const auto [x, y, z] = inertia(regularisation);
        const Vec3 yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);
        determinant = dot(x, yz);
        return {yz, zx, xy};
    }
    /// 0 for points that all lie at the origin.
    Mat3 inverse_inertia() const {
        double determinant;
        const Mat3 times = inverse(1e-12, determinant);
        if (!(determinant > 0)) return {{}, {}, {}};
        return {times.x / determinant, times.y / determinant, times.z / determinant};
    }
};

/// Forces at points whose sum and whose torque about the mean of the points are given. Of all such forces they have the
/// least sum of squares.
class LeastForces {
public:
    /// `moments`: of the points, each with weight 1.
    LeastForces(Vec3 force, Vec3 torque, double count, const SecondMoments& moments)
        : mean_(force / count), turning_(moments.inverse_inertia() * torque) {}
    /// `arm`: of a point, from the mean.
    Vec3 at(Vec3 arm) const { return mean_ + cross(turning_, arm); }

private:
    Vec3 mean_, turning_;
};

}  // namespace gphys
