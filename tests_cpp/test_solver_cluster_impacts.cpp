// Restitution of rigid clusters that hit models, against Newton's law of impact and the conservation of energy and
// momentum.
#include "solver_world.h"

using namespace test;
using gphys::Quat;
using gphys::Vec3;

namespace {

constexpr float frame = 1.0f / 60;
constexpr double g = static_cast<double>(9.81f), mass = 2;
constexpr float radius = 0.03f;

/// 27 particles, turned by a unit quaternion. Its faces are 0.3 m wide.
gphys_body_id crate(World& world, Vec3 centre, Quat turned, float restitution, float friction) {
    const gphys::Mat3 rotation = rotation_matrix(turned);
    std::vector<gphys_vec3> points;
    for (int i = 0; i < 27; ++i) {
        const Vec3 local = Vec3{i % 3 - 1.0, i / 3 % 3 - 1.0, i / 9 - 1.0} * 0.12;
        points.push_back(gphys::narrow(centre + rotation * local));
    }
    gphys_body_desc desc = point_mass(radius, friction, restitution);
    desc.mass = mass;
    const gphys_body_id body = world.particles(points, desc);
    std::vector<uint32_t> all(27);
    for (uint32_t i = 0; i < 27; ++i) all[i] = i;
    gphys_cluster_id id = 0;
    REQUIRE(gphys_solver_add_cluster(world.solver, body, all.data(), 27, &id) == GPHYS_OK);
    return body;
}
void add_floor(World& world) {
    const gphys_plane floor{{0, 1, 0}, 0};
    world.model(GPHYS_SHAPE_PLANE, &floor);
}
Quat about(Vec3 axis, double angle) {
    axis = axis * (std::sin(angle / 2) / length(axis));
    return {axis.x, axis.y, axis.z, std::cos(angle / 2)};
}
void set_motion(World& world, gphys_body_id body, Vec3 velocity, Vec3 spin) {
    const std::vector<gphys_vec3> at = world.positions(body);
    const Vec3 centre = gphys::widen(at[13]);
    for (uint32_t p = 0; p < 27; ++p)
        world.set_velocity(body, p, gphys::narrow(velocity + cross(spin, gphys::widen(at[p]) - centre)));
}
Vec3 mean_velocity(const World& world, gphys_body_id body) {
    Vec3 sum;
    for (const gphys_vec3& v : world.velocities(body)) sum += gphys::widen(v);
    return sum / 27;
}
Vec3 sum_of_impulses(const World& world) {
    Vec3 sum;
    for (const gphys_impulse& impulse : impulses(world)) sum += gphys::widen(impulse.linear);
    return sum;
}

}  // namespace

TEST_CASE("A crate rises to the square of its restitution, on a face, an edge or a corner") {
    // Above its centre of mass, so it does not begin to turn.
    const Quat poses[] = {
        {0, 0, 0, 1}, about({0, 0, 1}, std::acos(0.5) * 0.75), about({1, 0, -1}, std::acos(std::sqrt(1.0 / 3)))};
    double worst = 0;
    for (const Quat& pose : poses) {
        for (const float restitution : {0.0f, 0.5f, 0.8f, 1.0f}) {
            for (const uint32_t substeps : {8u, 2u, 1u}) {
                World world(substeps);
                add_floor(world);
                const gphys_body_id body = crate(world, {0, 1.2, 0}, pose, restitution, 0);
                const double top = world.position(body, 13).y;
                double lowest = top, highest = 0;  // since it was lowest
                for (int i = 0; i < 100; ++i) {
                    world.step(frame);
                    const double y = world.position(body, 13).y;
                    highest = std::max(highest, y);
                    if (y < lowest) lowest = highest = y;
                    if (highest > lowest + 1e-3 && mean_velocity(world, body).y < 0) break;
                }
                const double e = static_cast<double>(restitution), share = (highest - lowest) / (top - lowest);
                worst = std::max(worst, std::fabs(share - e * e));
            }
        }
    }
    figure("the share of the fall that it rises differs from the square of restitution by", worst, "at most");
    // In a substep of a frame it falls by 7 cm: what is left of that at an impact counts as speed.
    CHECK(worst < 0.03);
}

TEST_CASE("A bat gives a crate its speed and restitution times that, and gets the impulse") {
    for (const float restitution : {0.0f, 0.5f, 1.0f}) {
        for (const double speed : {3.0, 15.0}) {
            for (const uint32_t substeps : {8u, 2u, 1u}) {
                World world(substeps, {0, 0, 0});
                double x = -1.65;
                const gphys_model_id bat = world.box({0.5f, 0.5f, 0.5f}, {static_cast<float>(x), 0, 0});
                const gphys_body_id body = crate(world, {0, 0, 0}, {0, 0, 0, 1}, restitution, 0);
                world.step(frame);
                Vec3 given;
                for (int i = 0; i < 60; ++i) {
                    x += speed / 60;
                    const gphys_transform there{{static_cast<float>(x), 0, 0}, {0, 0, 0, 1}, 1};
                    REQUIRE(gphys_scene_set_transform(world.scene, bat, &there) == GPHYS_OK);
                    world.step(frame);
                    given += sum_of_impulses(world);
                }
                const Vec3 velocity = mean_velocity(world, body);
                // The bat's places are float32, so its speed is known to a millionth of the way over a step.
                CHECK(std::fabs(velocity.x / speed - (1 + static_cast<double>(restitution))) < 1e-3);
                CHECK(length(given + velocity * mass) < 1e-3 * mass * speed);
            }
        }
    }
}

TEST_CASE("Crates that tumble gain no energy, press the ground with what they lose, and come to rest", "[simulation]") {
    const Vec3 velocities[] = {{1.5, 0, 0}, {0, -1, 1}, {-2, 1, -1}}, spins[] = {{6, 2, -3}, {-4, 7, 1}, {0, 3, 9}};
    for (const float restitution : {0.3f, 0.6f, 1.0f}) {
        for (const float friction : {0.0f, 0.5f}) {
            for (int i = 0; i < 3; ++i) {
                for (const uint32_t substeps : {8u, 1u}) {
                    World world(substeps);
                    add_floor(world);
                    const gphys_body_id body = crate(world, {0, 1.3, 0}, about(spins[i], 2.0), restitution, friction);
                    set_motion(world, body, velocities[i], spins[i]);
                    double energy = world.energy(body);
                    Vec3 momentum = mean_velocity(world, body) * mass;
                    for (int step = 0; step < 240; ++step) {
                        world.step(frame);
                        const double now = world.energy(body);
                        // Float32 velocities: some 1e-6 of 30 J.
                        REQUIRE(now < energy + 1e-4);
                        energy = now;
                        const Vec3 next = mean_velocity(world, body) * mass;
                        const Vec3 taken = momentum + Vec3{0, -g * mass / 60, 0} - next;
                        REQUIRE(length(taken - sum_of_impulses(world)) < 1e-4);
                        momentum = next;
                    }
                    const Vec3 end = mean_velocity(world, body);
                    if (friction > 0 && restitution < 0.5f) CHECK(length(end) < 1e-3);
                }
            }
        }
    }
}
