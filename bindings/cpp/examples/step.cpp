// A rope with a weight, and a cloth that falls over a ball.
#include <cmath>
#include <cstdio>
#include <gamephys.hpp>

int main() {
    namespace gp = gamephys;
    gp::Scene scene;
    scene.add(gp::Plane{{0, 1, 0}, 0});
    scene.add(gp::Sphere{{0, 1, 0}, 1});
    gp::Solver solver;
    auto desc = gp::body_desc();
    desc.damping = 2;
    std::vector<gp::Vec3> line(41, {5, 3, 0});
    for (size_t i = 0; i < line.size(); ++i) line[i].x += 0.05f * float(i);
    const auto rope = solver.add_rope(line, 0, &desc);
    solver.set_pinned(rope, 0, 1, 1);
    solver.set_masses(rope, 40, std::array<float, 1>{5});
    desc.radius = 0.02f;
    desc.cloth_flags = GPHYS_CLOTH_BEND;
    const auto cloth = solver.add_cloth({-1.5f, 3, -1.5f}, {3, 0, 0}, {0, 0, 3}, 31, 31, &desc);
    for (int frame = 0; frame < 360; ++frame) solver.advance(&scene, 1.0f / 60);

    std::vector<gp::Vec3> positions(solver.get_body_info(cloth).particle_count);
    solver.get_positions(cloth, 0, uint32_t(positions.size()), positions);
    float height = INFINITY;
    for (const auto& p : positions) height = std::fmin(height, std::hypot(p.x, p.y - 1, p.z) - 1);
    solver.get_positions(rope, 0, 41, line);
    std::printf("weight %.3f m below the nail, cloth %.4f m above the ball\n", 3 - line[40].y, height);
    return line[40].y < 1.02f && height > 0.015f && height < 0.03f ? 0 : 1;
}
