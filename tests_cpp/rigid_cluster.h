// Bodies whose particles are all one rigid cluster, and what is joined to them.
#pragma once

#include "solver_world.h"

namespace test {

inline gphys_body_desc of_mass(float mass, float radius = 0.02f) {
    gphys_body_desc desc = World::body_desc();
    desc.mass = mass;
    desc.radius = radius;
    desc.friction = 0.5f;
    return desc;
}

/// A box of particles as a rigid cluster.
struct Rigid {
    gphys_body_id body;
    std::vector<gphys_vec3> placed;

    Rigid(World& world, gphys_vec3 centre, gphys_vec3 size, std::array<uint32_t, 3> counts, float mass,
          uint32_t body_layers = 0) {
        const auto along = [](uint32_t i, uint32_t count, float length) {
            return count > 1 ? length * (static_cast<float>(i) / static_cast<float>(count - 1) - 0.5f) : 0;
        };
        std::vector<uint32_t> all;
        for (uint32_t x = 0; x < counts[0]; ++x) {
            for (uint32_t y = 0; y < counts[1]; ++y) {
                for (uint32_t z = 0; z < counts[2]; ++z) {
                    placed.push_back({centre.x + along(x, counts[0], size.x), centre.y + along(y, counts[1], size.y),
                                      centre.z + along(z, counts[2], size.z)});
                    all.push_back(static_cast<uint32_t>(all.size()));
                }
            }
        }
        gphys_body_desc desc = of_mass(mass);
        desc.body_layers = body_layers;
        body = world.particles(placed, desc);
        gphys_cluster_id cluster = 0;
        REQUIRE(gphys_solver_add_cluster(world.solver, body, all.data(), static_cast<uint32_t>(all.size()), &cluster) ==
                GPHYS_OK);
    }
    uint32_t count() const { return static_cast<uint32_t>(placed.size()); }
    /// The particle nearest to a place.
    uint32_t at(gphys_vec3 place) const {
        const auto far = [&](gphys_vec3 p) { return distance(gphys::widen(p), gphys::widen(place)); };
        const auto nearest =
            std::min_element(placed.begin(), placed.end(), [&](gphys_vec3 a, gphys_vec3 b) { return far(a) < far(b); });
        return static_cast<uint32_t>(nearest - placed.begin());
    }
    /// Metres: the largest change of the distance between two particles.
    double distortion(const World& world) const {
        const std::vector<gphys_vec3> now = world.positions(body);
        double most = 0;
        for (uint32_t a = 0; a < count(); ++a) {
            for (uint32_t b = 0; b < a; ++b) {
                const double before = distance(gphys::widen(placed[a]), gphys::widen(placed[b]));
                most = std::max(most, std::fabs(distance(gphys::widen(now[a]), gphys::widen(now[b])) - before));
            }
        }
        return most;
    }
};

inline void join(World& world, gphys_body_id a, uint32_t particle_a, gphys_body_id b, uint32_t particle_b,
                 float length = 0, float compliance = 0) {
    gphys_joint_id joint = 0;
    REQUIRE(gphys_solver_join(world.solver, a, particle_a, b, particle_b, length, compliance, &joint) == GPHYS_OK);
}

inline gphys_body_id hook(World& world, gphys_vec3 at) {
    const gphys_body_id body = world.particles({at}, of_mass(1));
    world.pin(body, 0);
    return body;
}

/// newtons
inline double joint_force(const World& world, gphys_body_id body) {
    gphys_joint_info joints[8];
    uint32_t total = 0;
    REQUIRE(gphys_solver_get_joints(world.solver, body, joints, 8, &total) == GPHYS_OK);
    return joints[0].force;
}

/// The mean force on the only model that is touched, in the last step of 1/60 s.
inline gphys::Vec3 force_on_model(const World& world) {
    const std::vector<gphys_impulse> all = impulses(world);
    return all.empty() ? gphys::Vec3{} : gphys::widen(all[0].linear) * 60;
}

}  // namespace test
