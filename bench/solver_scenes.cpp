// Bodies that collide: a rain of free particles on boxes, balls in a pit, a rope over a post, and a sheet over a fine
// mesh.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>
#include <tuple>

#include "solver.h"

namespace bench {

namespace {

constexpr double pi = 3.14159265358979;

class GamephysInScene final : public Method {
public:
    explicit GamephysInScene(uint32_t substeps) : GamephysInScene(with_substeps(substeps)) {}
    explicit GamephysInScene(gphys_solver_desc desc) {
        desc.gravity = {0, -static_cast<float>(gravity), 0};
        check(gphys_solver_create(&desc, &solver));
        check(gphys_scene_create(nullptr, &scene));
    }
    ~GamephysInScene() override {
        gphys_solver_destroy(solver);
        gphys_scene_destroy(scene);
        gphys_mesh_destroy(mesh);
    }
    void step(float seconds) override { check(gphys_solver_step(solver, scene, seconds)); }
    std::vector<gphys_vec3> positions() const override { return read(gphys_solver_get_positions); }
    std::vector<gphys_vec3> velocities() const override { return read(gphys_solver_get_velocities); }

    void add(gphys_shape_type type, const void* shape) {
        gphys_model_id model = 0;
        check(gphys_scene_add(scene, type, shape, nullptr, nullptr, &model));
    }

    gphys_solver* solver = nullptr;
    gphys_scene* scene = nullptr;
    gphys_mesh* mesh = nullptr;
    std::vector<std::pair<gphys_body_id, uint32_t>> bodies;

    static gphys_solver_desc with_substeps(uint32_t substeps) {
        gphys_solver_desc desc;
        check(gphys_solver_desc_init(&desc, sizeof desc));
        desc.substeps = substeps;
        return desc;
    }

private:
    template <class Get>
    std::vector<gphys_vec3> read(Get&& get) const {
        std::vector<gphys_vec3> out;
        for (const auto& [body, size] : bodies) {
            out.resize(out.size() + size);
            check(get(solver, body, 0, size, &out[out.size() - size], 12));
        }
        return out;
    }
};

double radius_of_ball(double down, double around) {
    return 0.5 * (1 + 0.12 * std::sin(3 * down) * std::sin(4 * around));
}

/// 4 rings^2 triangles, less those at the poles.
void make_bumpy_ball(uint32_t rings, std::vector<float>& vertices, std::vector<uint32_t>& indices) {
    const uint32_t columns = 2 * rings;
    for (uint32_t ring = 0; ring <= rings; ++ring) {
        for (uint32_t column = 0; column < columns; ++column) {
            const double down = pi * ring / rings, around = 2 * pi * column / columns;
            const double radius = radius_of_ball(down, around);
            for (const double x :
                 {std::sin(down) * std::cos(around), std::cos(down), std::sin(down) * std::sin(around)}) {
                vertices.push_back(static_cast<float>(radius * x));
            }
            if (ring == 0) continue;
            const uint32_t right = (column + 1) % columns, above = (ring - 1) * columns, below = ring * columns;
            if (ring > 1) indices.insert(indices.end(), {above + column, above + right, below + column});
            if (ring < rings) indices.insert(indices.end(), {above + right, below + right, below + column});
        }
    }
}

std::vector<double> time_steps(Method& method, double seconds, float time_of(long) = frame_time) {
    std::vector<double> times;
    for (long i = 0; i < std::lround(seconds / frame); ++i) {
        const double start = now();
        method.step(time_of(i));
        times.push_back(now() - start);
    }
    return times;
}

double median(std::vector<double> times) {
    std::nth_element(times.begin(), times.begin() + static_cast<long>(times.size() / 2), times.end());
    return times[times.size() / 2];
}

/// How far a point is inside the box, or 0.
double depth_in(const gphys_aabb& box, gphys_vec3 p) {
    const float depth = std::min(
        {p.x - box.min.x, box.max.x - p.x, p.y - box.min.y, box.max.y - p.y, p.z - box.min.z, box.max.z - p.z});
    return std::max(0.0, static_cast<double>(depth));
}

}  // namespace

Rain make_rain(uint32_t particles, uint32_t boxes) {
    Rain rain;
    std::mt19937 random(1);
    const auto uniform = [&](double low, double high) {
        return static_cast<float>(std::uniform_real_distribution<double>(low, high)(random));
    };
    for (uint32_t i = 0; i < boxes; ++i) {
        const float x = uniform(0, 100), z = uniform(0, 100), height = uniform(0.5, 5);
        rain.boxes.push_back({{x - 1, 0, z - 1}, {x + 1, height, z + 1}});
    }
    for (uint32_t first = 0; first < particles; first += cloud_size) {
        const float x = uniform(0, 98), y = uniform(6, 20), z = uniform(0, 98);
        for (uint32_t i = 0; i < cloud_size; ++i) {
            rain.particles.push_back({x + uniform(0, 2), y + uniform(0, 2), z + uniform(0, 2)});
        }
    }
    return rain;
}

Pit make_pit(uint32_t balls) {
    Pit pit{{}, 0.1f, 1};
    std::mt19937 random(2);
    const auto uniform = [&](double low, double high) {
        return static_cast<float>(std::uniform_real_distribution<double>(low, high)(random));
    };
    constexpr uint32_t row = 8;
    constexpr float spacing = 0.24f;
    for (uint32_t i = 0; i < balls; ++i) {
        const auto along = [&](uint32_t place) {
            return spacing * (static_cast<float>(place) - 0.5f * (row - 1)) + uniform(-0.01, 0.01);
        };
        const float y = 0.2f + spacing * static_cast<float>(i / (row * row));
        pit.balls.push_back({along(i % row), y, along(i / row % row)});
    }
    return pit;
}

System make_post_rope() {
    constexpr uint32_t links = 120;
    constexpr double length = 0.03, away = double{post_radius} + double{post_rope_radius}, half = pi * away / 2;
    System rope;
    rope.body_size = links + 1;
    rope.post = away;
    for (uint32_t i = 0; i <= links; ++i) {
        const double way = (i - 0.5 * links) * length;
        const bool on = std::fabs(way) < half;
        rope.positions.push_back({static_cast<float>(on ? away * std::sin(way / away) : std::copysign(away, way)),
                                  static_cast<float>(on ? away * std::cos(way / away) : half - std::fabs(way)), 0});
        if (i > 0) rope.links.push_back({i - 1, i, length, 0});
    }
    // The sides of the polygon on the post are shorter than the arc: links have the lengths that they are given.
    for (Link& link : rope.links) {
        const gphys_vec3 a = rope.positions[link.a], b = rope.positions[link.b];
        link.rest = std::hypot(double{a.x} - b.x, double{a.y} - b.y);
    }
    rope.masses.assign(links + 1, 0.5f / (links + 1));
    rope.masses.front() = 1;
    rope.masses.back() = 3;
    return rope;
}

double post_rope_height(const System& rope, double seconds) {
    // What has come over the post adds its weight: y'' m = g (difference + 2 s y).
    const double of_rope = 0.5 / 3.6, mass = 1 + 3 + 0.5, rate = std::sqrt(2 * of_rope * gravity / mass);
    return rope.positions.back().y - (3.0 - 1.0) / (2 * of_rope) * (std::cosh(rate * seconds) - 1);
}

Drape make_drape(uint32_t columns) {
    Drape drape;
    make_bumpy_ball(133, drape.vertices, drape.indices);
    System& sheet = drape.sheet;
    sheet.body_size = columns * columns;
    sheet.columns = columns;
    sheet.damping = 1;
    const double spacing = 2.0 / (columns - 1);
    for (uint32_t i = 0; i < sheet.body_size; ++i) {
        const uint32_t column = i % columns, row = i / columns;
        sheet.positions.push_back(
            {static_cast<float>(column * spacing - 1), 0.6f, static_cast<float>(row * spacing - 1)});
        if (column > 0) sheet.links.push_back({i - 1, i, spacing, 0});
        if (row > 0) sheet.links.push_back({i - columns, i, spacing, 0});
    }
    sheet.masses.assign(sheet.body_size, 1.0f / static_cast<float>(sheet.body_size));
    return drape;
}

std::unique_ptr<Method> make_gamephys_rain(const Rain& rain) {
    auto world = std::make_unique<GamephysInScene>(1);
    for (const gphys_aabb& box : rain.boxes) world->add(GPHYS_SHAPE_AABB, &box);
    const gphys_plane ground{{0, 1, 0}, 0};
    world->add(GPHYS_SHAPE_PLANE, &ground);
    for (size_t first = 0; first < rain.particles.size(); first += cloud_size) {
        gphys_body_id body = 0;
        check(gphys_solver_add_particles(world->solver, nullptr, &rain.particles[first], sizeof rain.particles[0],
                                         cloud_size, &body));
        world->bodies.emplace_back(body, cloud_size);
    }
    return world;
}

std::unique_ptr<Method> make_gamephys_pit(const Pit& pit, uint32_t substeps) {
    auto world = std::make_unique<GamephysInScene>(substeps);
    const float wide = pit.half_width;
    const gphys_plane planes[] = {
        {{0, 1, 0}, 0}, {{1, 0, 0}, -wide}, {{-1, 0, 0}, -wide}, {{0, 0, 1}, -wide}, {{0, 0, -1}, -wide}};
    for (const gphys_plane& plane : planes) world->add(GPHYS_SHAPE_PLANE, &plane);
    gphys_body_desc desc;
    check(gphys_body_desc_init(&desc, sizeof desc));
    desc.radius = pit.radius;
    desc.self_collision = 1;
    desc.friction = 0;
    desc.restitution = 0;
    const auto count = static_cast<uint32_t>(pit.balls.size());
    gphys_body_id body = 0;
    check(gphys_solver_add_particles(world->solver, &desc, pit.balls.data(), sizeof pit.balls[0], count, &body));
    world->bodies.emplace_back(body, count);
    return world;
}

std::unique_ptr<Method> make_gamephys_post(const System& rope, uint32_t substeps) {
    auto world = std::make_unique<GamephysInScene>(substeps);
    const gphys_capsule post{{0, 0, -2}, {0, 0, 2}, post_radius};
    world->add(GPHYS_SHAPE_CAPSULE, &post);
    gphys_body_desc desc;
    check(gphys_body_desc_init(&desc, sizeof desc));
    desc.radius = post_rope_radius;
    desc.friction = 0;
    gphys_body_id body = 0;
    check(gphys_solver_add_rope(world->solver, &desc, rope.positions.data(), sizeof rope.positions[0], rope.body_size,
                                0, &body));
    check(gphys_solver_set_masses(world->solver, body, 0, rope.body_size, rope.masses.data(), sizeof(float)));
    world->bodies.emplace_back(body, rope.body_size);
    return world;
}

namespace {

std::unique_ptr<GamephysInScene> drape_in(std::unique_ptr<GamephysInScene> world, const Drape& drape) {
    check(gphys_mesh_create(nullptr, drape.vertices.data(), 12, static_cast<uint32_t>(drape.vertices.size() / 3),
                            drape.indices.data(), static_cast<uint32_t>(drape.indices.size()), &world->mesh));
    world->add(GPHYS_SHAPE_MESH, world->mesh);
    gphys_body_desc desc;
    check(gphys_body_desc_init(&desc, sizeof desc));
    desc.damping = drape.sheet.damping;
    desc.cloth_flags = 0;
    const std::vector<gphys_vec3>& at = drape.sheet.positions;
    const uint32_t n = drape.sheet.columns;
    const auto edge = [&](uint32_t to) {
        return gphys_vec3{at[to].x - at[0].x, at[to].y - at[0].y, at[to].z - at[0].z};
    };
    const gphys_vec3 u = edge(n - 1), v = edge(n * (n - 1));
    gphys_body_id body = 0;
    check(gphys_solver_add_cloth(world->solver, &desc, &at[0], &u, &v, n, n, &body));
    world->bodies.emplace_back(body, n * n);
    return world;
}

}  // namespace

std::unique_ptr<Method> make_gamephys_drape(const Drape& drape, uint32_t substeps) {
    return drape_in(std::make_unique<GamephysInScene>(substeps), drape);
}

/// Throws unless the particles of a method are where those of the rain are, each at a place of its own.
static void check_input(const Rain& rain, const Method& method) {
    std::vector<gphys_vec3> positions = method.positions();
    const auto less = [](const gphys_vec3& a, const gphys_vec3& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    };
    const auto same = [](const gphys_vec3& a, const gphys_vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; };
    std::vector<gphys_vec3> given = rain.particles;
    if (!std::equal(given.begin(), given.end(), positions.begin(), positions.end(), same)) {
        throw std::runtime_error("the particles are not where the rain has them");
    }
    std::sort(positions.begin(), positions.end(), less);
    // Some coincide by chance, as their coordinates are floats.
    const auto distinct = std::unique(positions.begin(), positions.end(), same) - positions.begin();
    if (static_cast<double>(distinct) < 0.99 * static_cast<double>(given.size())) {
        throw std::runtime_error("particles of the rain lie in the same place");
    }
}

std::vector<RainResult> measure_rain(const Rain& rain, Method& method, double& depth) {
    check_input(rain, method);
    const std::vector<double> times = time_steps(method, 3);
    // Clouds are 6 to 22 m above the ground and fall for 0.5 to 2.1 s.
    const auto between = [&](double from, double to) {
        return median({times.begin() + std::lround(from / frame), times.begin() + std::lround(to / frame)});
    };
    depth = 0;
    for (const gphys_vec3& p : method.positions()) {
        depth = std::max(depth, -static_cast<double>(p.y));
        for (const gphys_aabb& box : rain.boxes) depth = std::max(depth, depth_in(box, p));
    }
    const std::vector<double> equal_steps = time_steps(method, 0.5, [](long) { return frame; });
    const double sum = std::accumulate(times.begin(), times.end(), 0.0);
    return {{"flying", between(0.1, 0.4)},
            {"landing", between(1.5, 2)},
            {"lying", between(2.5, 3)},
            {"all", sum / static_cast<double>(times.size())},
            {"steady", median(equal_steps)}};
}

/// The largest overlap of two balls, or of a ball and the pit; `touching` gets how many pairs are nearer than 1.1
/// diameters.
static double overlap_in(const Pit& pit, std::vector<gphys_vec3> balls, size_t& touching) {
    const float diameter = 2 * pit.radius;
    double overlap = 0;
    touching = 0;
    std::sort(balls.begin(), balls.end(), [](const gphys_vec3& a, const gphys_vec3& b) { return a.x < b.x; });
    for (size_t i = 0; i < balls.size(); ++i) {
        const gphys_vec3& a = balls[i];
        const float out = std::max({-a.y, std::fabs(a.x) - pit.half_width, std::fabs(a.z) - pit.half_width});
        overlap = std::max(overlap, double{out} + double{pit.radius});
        for (size_t j = i + 1; j < balls.size() && balls[j].x - a.x < 1.1f * diameter; ++j) {
            const gphys_vec3& b = balls[j];
            const double apart = std::hypot(double{b.x} - a.x, double{b.y} - a.y, double{b.z} - a.z);
            overlap = std::max(overlap, double{diameter} - apart);
            touching += apart < 1.1 * double{diameter};
        }
    }
    return overlap;
}

PitResult measure_pit(const Pit& pit, Method& method, double seconds) {
    const auto same = [](const gphys_vec3& a, const gphys_vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; };
    const std::vector<gphys_vec3> begin = method.positions();
    size_t touching = 0;
    if (!std::equal(begin.begin(), begin.end(), pit.balls.begin(), pit.balls.end(), same) ||
        overlap_in(pit, begin, touching) > 0) {
        throw std::runtime_error("the balls are not where the pit has them, or overlap there");
    }
    std::vector<double> times;
    double overlap = 0;
    for (long i = 0; i < std::lround(seconds / frame); ++i) {
        const double start = now();
        method.step(frame_time(i));
        times.push_back(now() - start);
        overlap = std::max(overlap, overlap_in(pit, method.positions(), touching));
    }

    if (touching < 3 * begin.size()) throw std::runtime_error("the balls are no heap");
    return {spread_of(times), overlap};
}

double measure_drape(Method& method, double seconds) { return median(time_steps(method, seconds)); }

DrapeFrames measure_drape_within(const Drape& drape, float max_strain, uint32_t max_substeps, double seconds,
                                 const std::function<void(const std::vector<gphys_vec3>&)>& seen) {
    gphys_solver_desc desc;
    check(gphys_solver_desc_init(&desc, sizeof desc));
    desc.max_strain = max_strain;
    desc.max_substeps = max_substeps;
    const std::unique_ptr<GamephysInScene> world = drape_in(std::make_unique<GamephysInScene>(desc), drape);
    const long frames = std::lround(seconds / frame);
    DrapeFrames result;
    for (long i = 0; i < frames; ++i) {
        const double start = now();
        world->step(frame_time(i));
        const double taken = now() - start;
        uint32_t substeps = 0;
        check(gphys_solver_get_substeps(world->solver, world->bodies[0].first, &substeps));
        result.mean += taken / static_cast<double>(frames);
        result.substeps += substeps / static_cast<double>(frames);
        result.longest = std::max(result.longest, taken);
        result.most_substeps = std::max(result.most_substeps, substeps);
        seen(world->positions());
    }
    return result;
}

double depth_in_ball(const std::vector<gphys_vec3>& positions) {
    double depth = 0;
    for (const gphys_vec3& p : positions) {
        const double x = p.x, y = p.y, z = p.z, away = std::sqrt(x * x + y * y + z * z);
        if (away > 0) depth = std::max(depth, radius_of_ball(std::acos(y / away), std::atan2(z, x)) - away);
    }
    return depth;
}

}  // namespace bench
