#include "workload.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace bench {

namespace {

gphys_vec3 operator+(gphys_vec3 a, gphys_vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
gphys_vec3 operator-(gphys_vec3 a, gphys_vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
gphys_vec3 operator*(gphys_vec3 a, float s) { return {a.x * s, a.y * s, a.z * s}; }
float dot(gphys_vec3 a, gphys_vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
gphys_vec3 cross(gphys_vec3 a, gphys_vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
gphys_vec3 unit(gphys_vec3 a) { return a * (1.0f / std::sqrt(dot(a, a))); }

struct View {
    gphys_vec3 eye, right, up, forward;
};

View outside_looking_in(float half_side) {
    View v;
    v.eye = gphys_vec3{1.1f, 0.9f, 1.6f} * half_side;
    v.forward = unit(gphys_vec3{0, 0, 0} - v.eye);
    v.right = unit(cross(v.forward, gphys_vec3{0, 1, 0}));
    v.up = cross(v.right, v.forward);
    return v;
}

}  // namespace

uint64_t Random::next() {
    uint64_t z = (state_ += 0x9E3779B97F4A7C15ull);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return z ^ (z >> 31);
}

float Random::uniform(float low, float high) {
    return low + (high - low) * static_cast<float>(next() >> 40) * 0x1p-24f;
}

gphys_vec3 Random::point(float extent) {
    const float x = uniform(-extent, extent), y = uniform(-extent, extent), z = uniform(-extent, extent);
    return {x, y, z};
}

gphys_vec3 Random::direction() {
    for (;;) {
        const gphys_vec3 p = point(1);
        const float l2 = dot(p, p);
        if (l2 > 1e-3f && l2 < 1) return unit(p);
    }
}

gphys_quat Random::rotation() {
    for (;;) {
        const float x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1), w = uniform(-1, 1);
        const float l2 = x * x + y * y + z * z + w * w;
        if (l2 < 1e-2f || l2 > 1) continue;
        const float s = 1 / std::sqrt(l2);
        return {x * s, y * s, z * s, w * s};
    }
}

float half_side(uint32_t n) { return 2 * std::cbrt(static_cast<float>(n)); }

std::vector<gphys_obb> boxes(uint32_t n) {
    Random random(1234 + n);
    std::vector<gphys_obb> result(n);
    for (gphys_obb& b : result) {
        b.center = random.point(half_side(n));
        b.half_extents = gphys_vec3{0.6f, 0.6f, 0.6f} + random.point(0.4f);
        b.rotation = random.rotation();
    }
    return result;
}

std::vector<gphys_sphere> spheres(uint32_t n) {
    Random random(4321 + n);
    std::vector<gphys_sphere> result(n);
    for (gphys_sphere& s : result) {
        s.center = random.point(half_side(n));
        s.radius = random.uniform(0.2f, 1);
    }
    return result;
}

std::vector<gphys_transform> placements(uint32_t n) {
    Random random(5678 + n);
    std::vector<gphys_transform> result(n);
    for (gphys_transform& t : result) {
        t.position = random.point(half_side(n));
        t.rotation = random.rotation();
        t.scale = random.uniform(0.5f, 1);
    }
    return result;
}

std::vector<Stretched> forest(uint32_t n) {
    Random random(8765 + n);
    std::vector<Stretched> result;
    for (const gphys_transform& place : placements(n)) {
        const float x = random.uniform(0.3f, 1), y = random.uniform(0.3f, 1);
        result.push_back({place, {x, y, random.uniform(0.3f, 1)}});
    }
    return result;
}

void jiggle(std::vector<gphys_obb>& boxes, uint64_t frame) {
    Random random(99 + frame);
    for (gphys_obb& b : boxes) {
        b.center = b.center + random.point(0.1f);
        const gphys_vec3 turn = random.point(0.02f);
        const gphys_quat q = b.rotation;
        gphys_quat r = {
            q.x + turn.x * q.w + turn.y * q.z - turn.z * q.y, q.y + turn.y * q.w + turn.z * q.x - turn.x * q.z,
            q.z + turn.z * q.w + turn.x * q.y - turn.y * q.x, q.w - turn.x * q.x - turn.y * q.y - turn.z * q.z};
        const float s = 1 / std::sqrt(r.x * r.x + r.y * r.y + r.z * r.z + r.w * r.w);
        b.rotation = {r.x * s, r.y * s, r.z * s, r.w * s};
    }
}

Drift::Drift(size_t count, float half_side) : velocities_(count), half_side_(half_side) {
    Random random(101);
    for (gphys_vec3& v : velocities_) v = random.point(0.2f);
}

void Drift::step(std::vector<gphys_obb>& boxes) {
    for (size_t i = 0; i < boxes.size(); ++i) {
        for (float gphys_vec3::*const axis : {&gphys_vec3::x, &gphys_vec3::y, &gphys_vec3::z}) {
            float &at = boxes[i].center.*axis, &velocity = velocities_[i].*axis;
            at += velocity;
            if (std::fabs(at) > half_side_) velocity = std::copysign(velocity, -at);
        }
    }
}

std::vector<Arrangement> arrangements(uint32_t n) {
    const std::vector<gphys_obb> random = boxes(n);
    std::vector<Arrangement> all(5, {"", random});
    all[0].name = "random";
    all[1].name = "sorted";
    std::sort(all[1].boxes.begin(), all[1].boxes.end(),
              [](const gphys_obb& a, const gphys_obb& b) { return a.center.x < b.center.x; });
    all[2].name = "line";
    all[3].name = "rows";
    all[4].name = "one_place";
    const auto in_row = static_cast<uint32_t>(std::sqrt(static_cast<float>(n)));
    for (uint32_t i = 0; i < n; ++i) {
        all[2].boxes[i].center = {2.0f * static_cast<float>(i), 0, 0};
        all[3].boxes[i].center = {3.0f * static_cast<float>(i % in_row), 0, 3.0f * static_cast<float>(i / in_row)};
        all[4].boxes[i] = random.front();
    }
    return all;
}

std::vector<Jump> jumps(uint32_t n, uint32_t count, uint64_t seed) {
    Random random(seed);
    std::vector<Jump> result(count);
    for (Jump& jump : result) {
        jump.object = static_cast<uint32_t>(random.next() % n);
        jump.to.center = random.point(half_side(n));
        jump.to.half_extents = gphys_vec3{0.6f, 0.6f, 0.6f} + random.point(0.4f);
        jump.to.rotation = random.rotation();
    }
    return result;
}

std::vector<gphys_ray> rays_at(const std::vector<gphys_obb>& boxes, uint32_t count) {
    Random random(4242);
    std::vector<gphys_ray> result(count);
    for (gphys_ray& r : result) {
        const gphys_vec3 target = boxes[random.next() % boxes.size()].center + random.point(0.5f);
        const float distance = random.uniform(5, 50);
        r.direction = random.direction();
        r.origin = target - r.direction * distance;
        r.t_max = 2 * distance;
    }
    return result;
}

std::vector<gphys_ray> random_rays(float half_side, uint32_t count) {
    Random random(777);
    const float radius = half_side * 1.7321f + 3;
    std::vector<gphys_ray> result(count);
    for (gphys_ray& r : result) {
        r.origin = random.direction() * radius;
        r.direction = unit(random.point(half_side) - r.origin);
        r.t_max = 2.2f * radius;
    }
    return result;
}

std::vector<gphys_ray> camera_rays(float half_side, uint32_t width, uint32_t height) {
    const View v = outside_looking_in(half_side);
    const float tangent = std::tan(0.5f), aspect = static_cast<float>(width) / static_cast<float>(height);
    std::vector<gphys_ray> result;
    result.reserve(width * height);
    for (uint32_t tile_y = 0; tile_y < height; tile_y += 8) {
        for (uint32_t tile_x = 0; tile_x < width; tile_x += 8) {
            for (uint32_t y = tile_y; y < tile_y + 8; ++y) {
                for (uint32_t x = tile_x; x < tile_x + 8; ++x) {
                    const float sx = ((static_cast<float>(x) + 0.5f) / static_cast<float>(width) * 2 - 1) * tangent;
                    const float sy = (1 - (static_cast<float>(y) + 0.5f) / static_cast<float>(height) * 2) * tangent;
                    result.push_back({v.eye, unit(v.forward + v.right * (sx * aspect) + v.up * sy), 10 * half_side});
                }
            }
        }
    }
    return result;
}

std::vector<gphys_sphere> query_spheres(float half_side, uint32_t count, float radius) {
    Random random(31);
    std::vector<gphys_sphere> result(count);
    for (gphys_sphere& s : result) s = {random.point(half_side), radius};
    return result;
}

std::vector<gphys_aabb> query_boxes(float half_side, uint32_t count, float half) {
    Random random(37);
    const gphys_vec3 extent{half, half, half};
    std::vector<gphys_aabb> result(count);
    for (gphys_aabb& b : result) {
        const gphys_vec3 center = random.point(half_side);
        b = {center - extent, center + extent};
    }
    return result;
}

std::vector<gphys_vec3> query_points(float half_side, uint32_t count) {
    Random random(41);
    std::vector<gphys_vec3> result(count);
    for (gphys_vec3& p : result) p = random.point(half_side);
    return result;
}

std::vector<gphys_vec3> points_near(const Triangles& mesh, uint32_t count) {
    Random random(47);
    std::vector<gphys_vec3> result(count);
    for (gphys_vec3& p : result) {
        const gphys_vec3& vertex =
            mesh.vertices[mesh.indices[static_cast<size_t>(random.next() % mesh.indices.size())]];
        p = vertex + random.direction() * random.uniform(0, 0.01f);
    }
    return result;
}

std::vector<gphys_segment> query_segments(float half_side, uint32_t count, float length) {
    Random random(43);
    std::vector<gphys_segment> result(count);
    for (gphys_segment& s : result) {
        s.a = random.point(half_side);
        s.b = s.a + random.direction() * length;
    }
    return result;
}

std::vector<Sweep> query_sweeps(float half_side, uint32_t count, float radius, float length) {
    Random random(47);
    std::vector<Sweep> result(count);
    for (Sweep& s : result) {
        s.sphere = {random.point(half_side), radius};
        s.displacement = random.direction() * length;
    }
    return result;
}

std::vector<CapsuleSweep> query_capsule_sweeps(float half_side, uint32_t count, float length) {
    Random random(61);
    std::vector<CapsuleSweep> result(count);
    for (CapsuleSweep& sweep : result) {
        const gphys_vec3 at = random.point(half_side), axis = random.direction();
        sweep = {{at, at + axis, 0.25f}, random.direction() * length};
    }
    return result;
}
std::vector<BoxSweep> query_box_sweeps(float half_side, uint32_t count, float length) {
    Random random(62);
    std::vector<BoxSweep> result(count);
    for (BoxSweep& sweep : result) {
        sweep = {{random.point(half_side), {0.5f, 0.3f, 0.2f}, random.rotation()}, random.direction() * length};
    }
    return result;
}

gphys_frustum view(float half_side) {
    // From a corner region towards the middle: about a tenth of the objects lie within.
    const View v = outside_looking_in(0.62f * half_side);
    const float tan_x = 0.4f, tan_y = 0.3f, near_distance = 0.1f, far_distance = 1.65f * half_side;
    const auto side = [](gphys_vec3 axis, gphys_vec3 forward, float tangent) {
        return gphys_plane{unit(axis + forward * tangent), 0};
    };
    const gphys_vec3 zero{0, 0, 0};
    return {v.eye,
            {{v.forward, near_distance},
             {zero - v.forward, -far_distance},
             side(v.right, v.forward, tan_x),
             side(zero - v.right, v.forward, tan_x),
             side(v.up, v.forward, tan_y),
             side(zero - v.up, v.forward, tan_y)}};
}

Triangles rock() {
    Random random(7);
    std::vector<gphys_vec3> points;
    for (int i = 0; i < 40; ++i) points.push_back(random.direction() * random.uniform(0.9f, 1));
    gphys_mesh* hull = nullptr;
    if (gphys_mesh_create_hull(nullptr, &points[0].x, sizeof points[0], static_cast<uint32_t>(points.size()), &hull) !=
        GPHYS_OK) {
        throw std::runtime_error(gphys_last_error());
    }
    Triangles result;
    uint32_t total = 0;
    gphys_mesh_get_vertices(hull, nullptr, 0, &total);
    result.vertices.resize(total);
    gphys_mesh_get_vertices(hull, result.vertices.data(), total, &total);
    gphys_mesh_get_indices(hull, nullptr, 0, &total);
    result.indices.resize(total);
    gphys_mesh_get_indices(hull, result.indices.data(), total, &total);
    gphys_mesh_destroy(hull);
    return result;
}

Triangles bumpy_sphere(int level) {
    const float g = 1.61803399f;
    Triangles m;
    m.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                  {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    m.indices = {0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4,  11, 10, 2,  10, 7, 6, 7, 1, 8,
                 3, 9,  4, 3, 4, 2, 3, 2, 6, 3, 6, 8,  3, 8,  9,  4, 9, 5, 2, 4,  11, 6,  2,  10, 8,  6, 7, 9, 8, 1};
    for (gphys_vec3& v : m.vertices) v = unit(v);
    for (int i = 0; i < level; ++i) {
        std::map<std::pair<uint32_t, uint32_t>, uint32_t> middle_of;
        const auto middle = [&](uint32_t a, uint32_t b) {
            const auto found = middle_of.try_emplace(std::minmax(a, b), static_cast<uint32_t>(m.vertices.size()));
            if (found.second) m.vertices.push_back(unit(m.vertices[a] + m.vertices[b]));
            return found.first->second;
        };
        std::vector<uint32_t> finer;
        finer.reserve(m.indices.size() * 4);
        for (size_t t = 0; t < m.indices.size(); t += 3) {
            const uint32_t a = m.indices[t], b = m.indices[t + 1], c = m.indices[t + 2];
            const uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca});
        }
        m.indices = std::move(finer);
    }
    for (gphys_vec3& v : m.vertices) {
        v = v * (1 + 0.1f * std::sin(11 * v.x) * std::sin(13 * v.y) * std::sin(17 * v.z) +
                 0.02f * std::sin(71 * v.x + 57 * v.y) * std::sin(67 * v.z));
    }
    return m;
}

namespace {

void add_grid(Triangles& m, uint32_t rows, uint32_t columns, uint32_t width) {
    for (uint32_t i = 0; i + 1 < rows; ++i) {
        for (uint32_t k = 0; k < columns; ++k) {
            const uint32_t next = (k + 1) % width;
            const uint32_t a = i * width + k, b = a + width, c = i * width + next, d = c + width;
            m.indices.insert(m.indices.end(), {a, b, c, c, b, d});
        }
    }
}

}  // namespace

Triangles tube(uint32_t rings, uint32_t around) {
    Triangles m;
    for (uint32_t i = 0; i < rings; ++i) {
        for (uint32_t k = 0; k < around; ++k) {
            const double angle = 2 * 3.14159265358979 * k / around;
            m.vertices.push_back({2.0f * static_cast<float>(i) / static_cast<float>(rings) - 1,
                                  static_cast<float>(0.2 * std::cos(angle)),
                                  static_cast<float>(0.2 * std::sin(angle))});
        }
    }
    add_grid(m, rings, around, around);
    return m;
}

Triangles sheet(uint32_t side) {
    Triangles m;
    for (uint32_t i = 0; i < side; ++i) {
        for (uint32_t k = 0; k < side; ++k) {
            const float scale = 2.0f / static_cast<float>(side - 1);
            m.vertices.push_back({static_cast<float>(i) * scale - 1, 0, static_cast<float>(k) * scale - 1});
        }
    }
    add_grid(m, side, side - 1, side);
    return m;
}

std::vector<gphys_vec3> bent(const Triangles& tube, double phase) {
    std::vector<gphys_vec3> vertices = tube.vertices;
    const double angle = 1.2 * std::sin(phase) + 1.3;  // half of the way round at the most
    for (gphys_vec3& v : vertices) {
        const double turn = angle * v.x, radius = 1 / angle - v.y;
        v = {static_cast<float>(radius * std::sin(turn)), static_cast<float>(1 / angle - radius * std::cos(turn)), v.z};
    }
    return vertices;
}

std::vector<gphys_vec3> waving(const Triangles& sheet, double phase) {
    std::vector<gphys_vec3> vertices = sheet.vertices;
    for (gphys_vec3& v : vertices) {
        v.y = static_cast<float>(0.15 * std::sin(7 * v.x + phase) * std::cos(5 * v.z - 0.7 * phase));
        v.x += static_cast<float>(0.05 * std::sin(3 * v.z + phase));
    }
    return vertices;
}

}  // namespace bench
