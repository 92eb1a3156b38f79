// The point that a rigid cluster turns about: its centre of mass, or the mean of the particles that do not move freely.
#pragma once

#include <cstdint>

#include "solver/cloth/second_moments.h"

namespace gphys {

/// Sums over the particles of a cluster.
class ClusterPivot {
public:
    /// `rest`: in the shape. `mass`: 0 if it does not move freely.
    void add(Vec3 at, Vec3 rest, double mass) {
        const double weight = mass > 0 ? mass : 1;
        Sums& sums = mass > 0 ? free_ : held_;
        sums.at += at * weight;
        sums.rest += rest * weight;
        sums.weight += weight;
    }
    /// Whether any of them moves freely.
    bool moves() const { return free_.weight > 0; }
    uint32_t held_count() const { return static_cast<uint32_t>(held_.weight); }
    double mass() const { return free_.weight; }
    double inverse_mass() const { return held_.weight > 0 ? 0 : 1 / free_.weight; }
    Vec3 at() const { return sums().at / sums().weight; }
    Vec3 rest() const { return sums().rest / sums().weight; }

private:
    struct Sums {
        Vec3 at, rest;
        double weight = 0;
    };
    const Sums& sums() const { return held_.weight > 0 ? held_ : free_; }

    Sums free_, held_;
};

/// The sum of weight * at * rest^T, from the pivot.
struct Covariance {
    Mat3 matrix{{}, {}, {}};

    void add(Vec3 at, Vec3 rest, double weight) {
        const Vec3 weighted = at * weight;
        matrix.x += weighted * rest.x;
        matrix.y += weighted * rest.y;
        matrix.z += weighted * rest.z;
    }
    void add(const Covariance& other, double weight) {
        matrix.x += other.matrix.x * weight;
        matrix.y += other.matrix.y * weight;
        matrix.z += other.matrix.z * weight;
    }
};

/// The weight of particles that do not move freely, in the covariance and in the inertia: they have many times the
/// moment of inertia of the others, so they determine the rotation first. With two of them the free particles determine
/// the rotation about the line through these, with one the whole rotation. `free`, `held`: sums of mass or 1 times
/// squared distance from the pivot. `mass`: of the free ones.
inline double weight_of_held(double free, double held, double mass) {
    constexpr double ratio = 1e6;
    // Held particles at one point do not determine the rotation.
    constexpr double one_point = 1e-12;
    return held > one_point * free / mass ? ratio * free / held : 0;
}

}  // namespace gphys
