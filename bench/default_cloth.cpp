// Cloth as a game first meets it: with default settings, hanging, on models, and on models that move. Strain is
// measured here, from positions: how much too long and how much too short the sides of the grid are, and how much too
// long its diagonals. A run writes a row for each scene to standard output:
//   gamephys_bench_cloth [--only NAME] [--seconds S] [--substeps N] [--max_strain PART] [--damping RATE] [--flags N]
//   [--woven RATE] [--shear RATE] [--sleep_speed SPEED] [--vary N] [MESH.obj]
// "moved" is how far a particle is at the end from where it was a second before. Motion of cloth is chaotic: --vary
// begins N tenths of a millimetre aside, so that runs differ. With --woven, diagonals and bending are springs on which
// a particle would swing at so many radians a second; with --shear, diagonals alone. The mesh, if one is given, is made
// 1.2 m high, and a sheet falls on it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "measure.h"

namespace {

struct Options {
    std::string only, mesh;
    uint32_t varied = 0;
    double seconds = 0, max_strain = -1, damping = -1, sleep_speed = 0, woven = 0, shear = 0;
    int substeps = 0, flags = -1;
};

double distance(const gphys_vec3& a, const gphys_vec3& b) {
    return std::hypot(double{a.x} - b.x, double{a.y} - b.y, double{a.z} - b.z);
}

gphys_transform at(float x, float y, float z, float turned = 0) {
    return {{x, y, z}, {0, std::sin(turned / 2), 0, std::cos(turned / 2)}, 1};
}

/// A sheet, the models around it and what they do.
struct World {
    World(const Options& options, uint32_t columns_, uint32_t rows_) : columns(columns_), rows(rows_) {
        gphys_solver_desc desc;
        check(gphys_solver_desc_init(&desc, sizeof desc));
        if (options.substeps > 0) desc.substeps = static_cast<uint32_t>(options.substeps);
        if (options.max_strain >= 0) desc.max_strain = static_cast<float>(options.max_strain);
        desc.sleep_speed = static_cast<float>(options.sleep_speed);
        check(gphys_solver_create(&desc, &solver));
        check(gphys_scene_create(nullptr, &scene));
        check(gphys_body_desc_init(&body_desc, sizeof body_desc));
        if (options.damping >= 0) body_desc.damping = static_cast<float>(options.damping);
        const auto spring = [&](double rate) {
            return static_cast<float>(columns * rows / (double{body_desc.mass} * rate * rate));
        };
        if (options.woven > 0) body_desc.shear_compliance = body_desc.bend_compliance = spring(options.woven);
        if (options.shear > 0) body_desc.shear_compliance = spring(options.shear);
        varied = 1e-4f * static_cast<float>(options.varied);
        if (options.flags >= 0) body_desc.cloth_flags = static_cast<uint32_t>(options.flags);
    }
    ~World() {
        gphys_solver_destroy(solver);
        gphys_scene_destroy(scene);
        gphys_mesh_destroy(mesh);
    }
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    void add_sheet(gphys_vec3 corner, gphys_vec3 u, gphys_vec3 v) {
        corner.x += varied;
        corner.z += varied / 2;
        side_u = std::hypot(u.x, u.y, u.z) / static_cast<float>(columns - 1);
        side_v = std::hypot(v.x, v.y, v.z) / static_cast<float>(rows - 1);
        check(gphys_solver_add_cloth(solver, &body_desc, &corner, &u, &v, columns, rows, &body));
    }
    gphys_model_id add(gphys_shape_type type, const void* shape, const gphys_transform* transform = nullptr) {
        gphys_model_id model = 0;
        check(gphys_scene_add(scene, type, shape, transform, nullptr, &model));
        return model;
    }
    void pin(uint32_t p) { check(gphys_solver_set_pinned(solver, body, p, 1, 1)); }
    void attach(uint32_t p, gphys_model_id model) {
        check(gphys_solver_attach(solver, scene, body, p, model, nullptr));
    }
    uint32_t size() const { return columns * rows; }
    std::vector<gphys_vec3> positions() const {
        std::vector<gphys_vec3> out(size());
        check(gphys_solver_get_positions(solver, body, 0, size(), out.data(), sizeof out[0]));
        return out;
    }

    gphys_solver* solver = nullptr;
    gphys_scene* scene = nullptr;
    gphys_mesh* mesh = nullptr;
    gphys_body_desc body_desc{};
    gphys_body_id body = 0;
    uint32_t columns, rows;
    float varied = 0;  // metres, of where sheets begin
    double side_u = 0, side_v = 0, seconds = 10;
    std::function<void(double)> act = [](double) {};  // what the models do, after so many seconds
    std::function<double(const gphys_vec3&)> depth = [](const gphys_vec3&) { return 0.0; };  // of a point in them
};

/// Of a frame, in parts of the length.
struct Strain {
    double stretch = 0, compression = 0, diagonal = 0;

    void add(const Strain& other) {
        stretch = std::max(stretch, other.stretch);
        compression = std::max(compression, other.compression);
        diagonal = std::max(diagonal, other.diagonal);
    }
};

Strain strain_of(const World& world, const std::vector<gphys_vec3>& at) {
    Strain strain;
    const auto side = [&](uint32_t a, uint32_t b, double rest) {
        const double part = distance(at[a], at[b]) / rest - 1;
        strain.stretch = std::max(strain.stretch, part);
        strain.compression = std::max(strain.compression, -part);
    };
    const double across = std::hypot(world.side_u, world.side_v);
    const auto diagonal = [&](uint32_t a, uint32_t b) {
        strain.diagonal = std::max(strain.diagonal, distance(at[a], at[b]) / across - 1);
    };
    for (uint32_t row = 0; row < world.rows; ++row) {
        for (uint32_t column = 0; column < world.columns; ++column) {
            const uint32_t p = row * world.columns + column;
            if (column > 0) side(p - 1, p, world.side_u);
            if (row > 0) side(p - world.columns, p, world.side_v);
            if (row > 0 && column > 0) {
                diagonal(p - world.columns - 1, p);
                diagonal(p - world.columns, p - 1);
            }
        }
    }
    return strain;
}

double part_of(std::vector<double> values, double part) {
    std::sort(values.begin(), values.end());
    return values[static_cast<size_t>(part * static_cast<double>(values.size() - 1))];
}

double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

void measure(const char* name, World& world, const Options& options) {
    const double seconds = options.seconds > 0 ? options.seconds : world.seconds;
    const int frames = static_cast<int>(std::lround(seconds / frame));
    std::vector<double> times, stretch;
    Strain peak, rest;
    std::vector<gphys_vec3> second;
    double fastest = 0, deepest = 0, calm_since = 0;
    std::vector<gphys_vec3> before = world.positions();
    for (int i = 0; i < frames; ++i) {
        world.act((i + 1) * double{frame});
        const double start = now();
        check(gphys_solver_step(world.solver, world.scene, frame_time(i)));
        times.push_back(1e3 * (now() - start));
        const std::vector<gphys_vec3> at = world.positions();
        const Strain strain = strain_of(world, at);
        stretch.push_back(strain.stretch);
        peak.add(strain);
        double speed = 0;
        for (uint32_t p = 0; p < world.size(); ++p) {
            speed = std::max(speed, distance(before[p], at[p]) / frame);
            deepest = std::max(deepest, world.depth(at[p]));
        }
        if (speed > 1e-3) calm_since = (i + 1) * double{frame};
        if (i >= frames - 60) rest.add(strain), fastest = std::max(fastest, speed);
        before = at;
        if (i == frames - 61) second = at;
    }
    double shifted = 0;
    for (uint32_t p = 0; p < world.size() && !second.empty(); ++p) {
        shifted = std::max(shifted, distance(second[p], before[p]));
    }
    std::printf("%-10s %7.1f %6.1f %6.1f | %6.1f %6.1f | %6.1f %6.1f | %8.1f %6.1f %6.1f %6.1f | %6.2f %6.2f %6.1f\n",
                name, 100 * peak.stretch, 100 * part_of(stretch, 0.99), 100 * rest.stretch, 100 * peak.compression,
                100 * rest.compression, 100 * peak.diagonal, 100 * rest.diagonal, 1e3 * fastest, 1e3 * shifted,
                calm_since < seconds ? calm_since : -1, 1e3 * deepest, mean(times), part_of(times, 0.99),
                *std::max_element(times.begin(), times.end()));
    std::fflush(stdout);
}

/// Triangles of a file of Wavefront's format, 1.2 m high, in the middle above y = 0.
void read_mesh(const std::string& name, std::vector<float>& vertices, std::vector<uint32_t>& indices) {
    FILE* file = std::fopen(name.c_str(), "r");
    if (!file) throw std::runtime_error("no file " + name);
    char line[512];
    while (std::fgets(line, sizeof line, file)) {
        float v[3];
        if (std::sscanf(line, "v %f %f %f", &v[0], &v[1], &v[2]) == 3) vertices.insert(vertices.end(), v, v + 3);
        if (std::strncmp(line, "f ", 2) != 0) continue;
        std::vector<uint32_t> corners;
        char* rest = nullptr;
        for (char* word = strtok_r(line + 2, " \r\n", &rest); word; word = strtok_r(nullptr, " \r\n", &rest)) {
            corners.push_back(static_cast<uint32_t>(std::atoi(word)) - 1);
        }
        for (size_t k = 2; k < corners.size(); ++k) {
            indices.insert(indices.end(), {corners[0], corners[k - 1], corners[k]});
        }
    }
    std::fclose(file);
    float low[3] = {1e30f, 1e30f, 1e30f}, high[3] = {-1e30f, -1e30f, -1e30f};
    for (size_t i = 0; i < vertices.size(); ++i) {
        low[i % 3] = std::min(low[i % 3], vertices[i]), high[i % 3] = std::max(high[i % 3], vertices[i]);
    }
    const float scale = 1.2f / (high[1] - low[1]);
    const float middle[3] = {(low[0] + high[0]) / 2, low[1], (low[2] + high[2]) / 2};
    for (size_t i = 0; i < vertices.size(); ++i) vertices[i] = (vertices[i] - middle[i % 3]) * scale;
}

void hang(World& world) {
    world.add_sheet({-1, 0, -1}, {2, 0, 0}, {0, 0, 2});
    for (const uint32_t corner : {0u, world.columns - 1}) {
        world.pin(corner);
    }
}

void fall_on_sphere(World& world) {
    static const gphys_sphere sphere{{0, 0, 0}, 0.5f};
    world.add(GPHYS_SHAPE_SPHERE, &sphere);
    world.add_sheet({-1, 0.6f, -1}, {2, 0, 0}, {0, 0, 2});
    world.depth = [](const gphys_vec3& p) { return 0.5 - std::hypot(p.x, p.y, p.z); };
}

double depth_in_box(const gphys_aabb& box, const gphys_vec3& p) {
    return std::min(
        {p.x - box.min.x, box.max.x - p.x, p.y - box.min.y, box.max.y - p.y, p.z - box.min.z, box.max.z - p.z});
}

void fall_on_box(World& world) {
    static const gphys_aabb box{{-0.4f, -0.4f, -0.4f}, {0.4f, 0.4f, 0.4f}};
    world.add(GPHYS_SHAPE_AABB, &box);
    world.add_sheet({-1, 0.5f, -1}, {2, 0, 0}, {0, 0, 2});
    world.depth = [](const gphys_vec3& p) { return depth_in_box(box, p); };
}

void fall_on_mesh(World& world, const Options& options) {
    std::vector<float> vertices;
    std::vector<uint32_t> indices;
    read_mesh(options.mesh, vertices, indices);
    check(gphys_mesh_create(nullptr, vertices.data(), 12, static_cast<uint32_t>(vertices.size() / 3), indices.data(),
                            static_cast<uint32_t>(indices.size()), &world.mesh));
    world.add(GPHYS_SHAPE_MESH, world.mesh);
    world.add_sheet({-1, 1.3f, -1}, {2, 0, 0}, {0, 0, 2});
}

/// A flag at a pole, and the ground below: only some of its particles can touch anything.
void fly_flag(World& world) {
    static const gphys_plane ground{{0, 1, 0}, -4};
    static const gphys_capsule pole{{-0.06f, -4, 0}, {-0.06f, 0.2f, 0}, 0.05f};
    world.add(GPHYS_SHAPE_PLANE, &ground);
    world.add(GPHYS_SHAPE_CAPSULE, &pole);
    world.add_sheet({0, 0, 0}, {2, 0, 0}, {0, -1.5f, 0});
    for (uint32_t p = 0; p < world.size(); p += world.columns) world.pin(p);
}

/// A curtain hangs from its upper edge in front of a wall that it does not touch.
void hang_at_wall(World& world) {
    static const gphys_plane ground{{0, 1, 0}, -2.5f};
    static const gphys_aabb wall{{-2, -2.5f, -0.6f}, {2, 0.5f, -0.3f}};
    world.add(GPHYS_SHAPE_PLANE, &ground);
    world.add(GPHYS_SHAPE_AABB, &wall);
    world.add_sheet({-1, 0, 0}, {2, 0, 0}, {0, -2, 0});
    for (uint32_t p = 0; p < world.columns; ++p) world.pin(p);
}

/// A curtain hangs from its upper edge, and somebody walks through it at 5 m/s.
void walk_through(World& world) {
    static const gphys_capsule body{{0, -0.5f, 0}, {0, 0.5f, 0}, 0.3f};
    gphys_transform start = at(0, -1, 5);
    const gphys_model_id walker = world.add(GPHYS_SHAPE_CAPSULE, &body, &start);
    world.add_sheet({-1, 0, 0}, {2, 0, 0}, {0, -2, 0});
    for (uint32_t p = 0; p < world.columns; ++p) world.pin(p);
    world.act = [&world, walker](double time) {
        const gphys_transform place = at(0, -1, static_cast<float>(std::max(-5.0, 5 - 5 * time)));
        check(gphys_scene_set_transform(world.scene, walker, &place));
    };
}

/// A cape on a capsule that runs at 6 m/s, turns about within a fifth of a second and stops after six seconds. Then it
/// turns once more or, if it `jumps`, is turned about from one frame to the next. If it is `aimed`, an animation
/// carries the cape as it was sewn: particles stay within a distance of that which grows to half a metre at the hem,
/// and go no more than 2 cm towards the runner.
void wear(World& world, bool jumps, bool aimed) {
    static const gphys_capsule body{{0, 0.3f, 0}, {0, 1.5f, 0}, 0.25f};
    const gphys_model_id runner = world.add(GPHYS_SHAPE_CAPSULE, &body);
    world.add_sheet({-0.4f, 1.5f, 0.28f}, {0.8f, 0, 0}, {0, -1.1f, 0.1f});
    for (uint32_t p = 0; p < world.columns; ++p) {
        world.attach(p, runner);
    }
    const std::vector<gphys_vec3> sewn = world.positions();
    world.act = [&world, runner, jumps, aimed, sewn](double time) {
        // To and fro along z: half of each two seconds this way, half that way, turned by half a turn between.
        const double running = std::min(std::max(time - 0.5, 0.0), 6.0), phase = std::fmod(running, 2.0);
        const double way = phase < 1 ? 6 * phase : 6 * (2 - phase);
        const auto turning = [](double since) { return 3.14159265 * std::min(std::max(since / 0.2, 0.0), 1.0); };
        const double turned = running >= 6                 ? 3.14159265 + turning(jumps ? 1 : time - 6.5)
                              : phase < 0.2 && running > 1 ? 3.14159265 + turning(phase)
                                                           : turning(phase - 1);
        const gphys_transform place = at(0, 0, static_cast<float>(-way), static_cast<float>(turned));
        check(gphys_scene_set_transform(world.scene, runner, &place));
        if (!aimed) return;
        const float c = static_cast<float>(std::cos(turned)), s = static_cast<float>(std::sin(turned));
        std::vector<gphys_animation_target> targets(sewn.size());
        for (uint32_t p = 0; p < sewn.size(); ++p) {
            const gphys_vec3 q = sewn[p];
            const float down = static_cast<float>(p / world.columns) / static_cast<float>(world.rows - 1);
            targets[p] = {
                {c * q.x + s * q.z, q.y, c * q.z - s * q.x - static_cast<float>(way)}, {s, 0, c}, 0.5f * down, 0.02f};
        }
        check(gphys_solver_set_animation_targets(world.solver, world.body, 0, world.size(), targets.data(),
                                                 sizeof targets[0]));
    };
}

/// A sheet fixed to a bar at one edge; in one frame the bar is 0.1 m further in the plane of the sheet.
void jump(World& world) {
    static const gphys_aabb bar{{-1, -0.01f, -0.05f}, {1, 0.01f, -0.03f}};
    const gphys_model_id model = world.add(GPHYS_SHAPE_AABB, &bar);
    world.body_desc.damping = 2;
    world.add_sheet({-1, 0, 0}, {2, 0, 0}, {0, 0, 2});
    for (uint32_t p = 0; p < world.size(); p += world.columns) {
        world.attach(p, model);
    }
    world.act = [&world, model](double time) {
        const gphys_transform place = at(time > 0.1 ? 0.1f : 0, 0, 0);
        check(gphys_scene_set_transform(world.scene, model, &place));
    };
    world.seconds = 20;
}

struct Scene {
    const char* name;
    uint32_t columns, rows;
    std::function<void(World&)> make;
};

}  // namespace

int main(int count, char** arguments) {
    Options options;
    for (int i = 1; i < count; ++i) {
        const std::string word = arguments[i];
        const auto value = [&] { return i + 1 < count ? arguments[++i] : ""; };
        if (word == "--only") {
            options.only = value();
        } else if (word == "--seconds") {
            options.seconds = std::atof(value());
        } else if (word == "--substeps") {
            options.substeps = std::atoi(value());
        } else if (word == "--max_strain") {
            options.max_strain = std::atof(value());
        } else if (word == "--damping") {
            options.damping = std::atof(value());
        } else if (word == "--sleep_speed") {
            options.sleep_speed = std::atof(value());
        } else if (word == "--woven") {
            options.woven = std::atof(value());
        } else if (word == "--shear") {
            options.shear = std::atof(value());
        } else if (word == "--vary") {
            options.varied = static_cast<uint32_t>(std::atoi(value()));
        } else if (word == "--flags") {
            options.flags = std::atoi(value());
        } else {
            options.mesh = word;
        }
    }
    std::vector<Scene> scenes{{"hanging", 100, 100, hang},
                              {"flag", 60, 60, fly_flag},
                              {"wall", 60, 60, hang_at_wall},
                              {"sphere", 100, 100, fall_on_sphere},
                              {"box", 30, 30, fall_on_box},
                              {"curtain", 60, 60, walk_through},
                              {"cape", 30, 40, [](World& world) { wear(world, false, false); }},
                              {"cape_jump", 30, 40, [](World& world) { wear(world, true, false); }},
                              {"cape_aimed", 30, 40, [](World& world) { wear(world, false, true); }},
                              {"jump", 30, 30, jump}};
    if (!options.mesh.empty()) {
        scenes.push_back({"mesh", 100, 100, [&](World& world) { fall_on_mesh(world, options); }});
    }
    std::printf(
        "           sides longer %%           shorter %%        diagonals %%     mm/s     mm   calm   depth |       "
        "ms\n");
    std::printf(
        "scene         peak    p99   rest |   peak   rest |   peak   rest |     rest  moved after s    mm |   mean    "
        "p99  "
        "worst\n");
    try {
        for (const Scene& scene : scenes) {
            if (!options.only.empty() && options.only.find(scene.name) == std::string::npos) continue;
            World world(options, scene.columns, scene.rows);
            scene.make(world);
            measure(scene.name, world, options);
        }
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "%s\n", problem.what());
        return 1;
    }
}
