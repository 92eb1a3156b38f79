// The same queries through the same trees with plain float tests: what gamephys would cost, and get
// wrong, if it trusted float arithmetic as other libraries do.
#include <memory>

#include "bvh/bvh_queries.h"
#include "float_kernels.h"
#include "implementation.h"
#include "mesh/mesh.h"

namespace bench {

namespace {

using gphys::Bvh8;
using gphys::FloatRay;
using gphys::RayProbe;

struct FloatVec {
    float x, y, z;
};
FloatVec operator-(FloatVec a, FloatVec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
FloatVec operator+(FloatVec a, FloatVec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
FloatVec operator*(FloatVec a, float s) { return {a.x * s, a.y * s, a.z * s}; }
FloatVec cross(FloatVec a, FloatVec b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
float dot(FloatVec a, FloatVec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
FloatVec vec(const float* v) { return {v[0], v[1], v[2]}; }
FloatVec vec(const gphys_vec3& v) { return {v.x, v.y, v.z}; }

/// A box with its axes as floats.
struct FloatBox {
    FloatVec center, half, axis[3];

    FloatBox(const gphys_obb& box) : center(vec(box.center)), half(vec(box.half_extents)) {
        const gphys::Mat3 m = gphys::rotation_matrix(gphys::widen(box.rotation));
        const gphys::Vec3 columns[3] = {m.x, m.y, m.z};
        for (int k = 0; k < 3; ++k) axis[k] = vec(gphys::narrow(columns[k]));
    }

    /// Slabs by reciprocals (Williams et al. 2005).
    bool hit(const FloatRay& ray, float& t) const {
        const FloatVec from = vec(ray.origin) - center, along = vec(ray.direction);
        const float halves[3] = {half.x, half.y, half.z};
        float entry = 0, exit = ray.t;
        for (int k = 0; k < 3; ++k) {
            const float o = dot(from, axis[k]), inverse = 1 / dot(along, axis[k]);
            const float t0 = (-halves[k] - o) * inverse, t1 = (halves[k] - o) * inverse;
            entry = std::max(entry, std::min(t0, t1));
            exit = std::min(exit, std::max(t0, t1));
        }
        t = entry;
        return entry <= exit;
    }
    /// Of the face that a point lies on.
    FloatVec normal_at(FloatVec point) const {
        const FloatVec from = point - center;
        const float halves[3] = {half.x, half.y, half.z};
        FloatVec normal{0, 0, 0};
        float nearest = INFINITY;
        for (int k = 0; k < 3; ++k) {
            const float height = dot(from, axis[k]), below = std::fabs(std::fabs(height) - halves[k]);
            if (below >= nearest) continue;
            nearest = below;
            normal = axis[k] * std::copysign(1.0f, height);
        }
        return normal;
    }
    bool touches(const gphys_sphere& sphere) const {
        const FloatVec from = vec(sphere.center) - center;
        const float halves[3] = {half.x, half.y, half.z};
        float square = 0;
        for (int k = 0; k < 3; ++k) {
            const float out = std::max(std::fabs(dot(from, axis[k])) - halves[k], 0.0f);
            square += out * out;
        }
        return square <= sphere.radius * sphere.radius;
    }
};

struct FloatSphere {
    FloatVec center;
    float radius;

    FloatSphere(const gphys_sphere& s) : center(vec(s.center)), radius(s.radius) {}

    bool hit(const FloatRay& ray, float& t) const {
        const FloatVec from = vec(ray.origin) - center, along = vec(ray.direction);
        const float a = dot(along, along), b = dot(from, along), c = dot(from, from) - radius * radius;
        const float discriminant = b * b - a * c;
        if (discriminant < 0 || (c > 0 && b > 0)) return false;
        t = std::max((-b - std::sqrt(discriminant)) / a, 0.0f);
        return t <= ray.t;
    }
    FloatVec normal_at(FloatVec point) const { return (point - center) * (1 / radius); }
};

/// All that the library tells of a hit, too.
gphys_hit to_hit(const FloatRay& ray, FloatVec point, FloatVec normal, float u = 0, float v = 0) {
    return {ray.item, ray.item, ray.t, {point.x, point.y, point.z}, {normal.x, normal.y, normal.z}, ray.item, u, v, 0};
}
FloatVec point_of(const FloatRay& ray) { return vec(ray.origin) + vec(ray.direction) * ray.t; }

class GamephysFloat final : public Implementation {
public:
    bool load(const std::vector<gphys_obb>& content) override {
        boxes_.assign(content.begin(), content.end());
        build(content);
        return true;
    }
    bool load(const std::vector<gphys_sphere>& content) override {
        spheres_.assign(content.begin(), content.end());
        build(content);
        return true;
    }
    bool load(const Triangles& content) override {
        const gphys::MeshArrays arrays{&content.vertices[0].x, sizeof(gphys_vec3),
                                       static_cast<uint32_t>(content.vertices.size()), content.indices.data(),
                                       static_cast<uint32_t>(content.indices.size())};
        gphys::Memory memory(nullptr);
        mesh_.reset(gphys::create<gphys::Mesh>(nullptr, arrays, gphys::examine(arrays, &memory), gphys::chosen_isa()));
        return true;
    }

    bool closest(const std::vector<gphys_ray>& rays) override {
        hits_.resize(rays.size());
        constexpr uint32_t at_once = Bvh8::rays_at_once;
        for (size_t first = 0; first < rays.size(); first += at_once) {
            const auto count = static_cast<uint32_t>(std::min<size_t>(at_once, rays.size() - first));
            if (mesh_) {
                meet_mesh(&rays[first], count, &hits_[first]);
            } else if (spheres_.empty()) {
                meet(boxes_, &rays[first], count, &hits_[first]);
            } else {
                meet(spheres_, &rays[first], count, &hits_[first]);
            }
        }
        return true;
    }
    std::vector<Answer> answers() const override {
        std::vector<Answer> found;
        found.reserve(hits_.size());
        for (const auto& hit : hits_) found.push_back({hit.t, hit.triangle});
        return found;
    }

    bool overlap(const std::vector<gphys_sphere>& queries, uint64_t& total) override {
        if (boxes_.empty()) return false;
        total = 0;
        for (const gphys_sphere& sphere : queries) {
            octree_->overlap_ball(gphys::widen(sphere.center), static_cast<double>(sphere.radius),
                                  [&](uint32_t item, bool inside) {
                                      total += inside || boxes_[item].touches(sphere);
                                      return true;
                                  });
        }
        return true;
    }

private:
    struct Release {
        void operator()(const gphys::Mesh* mesh) const { gphys::Mesh::release(mesh); }
    };

    template <class Shape>
    void build(const std::vector<Shape>& content) {
        std::vector<gphys::Box> around;
        std::vector<uint32_t> numbers;
        for (const Shape& shape : content) {
            numbers.push_back(static_cast<uint32_t>(around.size()));
            around.push_back(gphys::bounds(gphys::widen(shape)));
        }
        octree_ = std::make_unique<Bvh8>(std::pmr::get_default_resource());
        octree_->build(around.data(), numbers.data(), static_cast<uint32_t>(numbers.size()));
    }

    template <class Shape>
    void meet(const std::vector<Shape>& shapes, const gphys_ray* rays, uint32_t count, gphys_hit* hits) {
        prepared_.assign(rays, rays + count);
        gphys::Ray exact[Bvh8::rays_at_once];
        for (uint32_t i = 0; i < count; ++i) exact[i] = gphys::widen(rays[i]);
        octree_->raycast_many(exact, count, [&](const uint32_t* numbers, const uint32_t* items, uint32_t size) {
            uint32_t shorter = 0;
            for (uint32_t k = 0; k < size; ++k) {
                FloatRay& ray = prepared_[numbers[k]];
                const uint32_t item = items[k];
                float t;
                if (!shapes[item].hit(ray, t) || (t == ray.t && item > ray.item)) continue;
                ray.t = t;
                ray.item = item;
                exact[numbers[k]].t_max = static_cast<double>(t);
                shorter |= 1u << k;
            }
            return shorter;
        });
        for (uint32_t i = 0; i < count; ++i) {
            const FloatRay& ray = prepared_[i];
            const FloatVec point = point_of(ray);
            hits[i] = to_hit(ray, point, ray.item == no_object ? FloatVec{} : shapes[ray.item].normal_at(point));
        }
    }

    void meet_mesh(const gphys_ray* rays, uint32_t count, gphys_hit* hits) {
        const gphys::Box root = mesh_->bounds();
        RayProbe along[Bvh8::rays_at_once];
        float limits[Bvh8::rays_at_once];
        gphys::Ray exact[Bvh8::rays_at_once];
        prepared_.assign(rays, rays + count);
        for (uint32_t i = 0; i < count; ++i) {
            exact[i] = gphys::widen(rays[i]);
            along[i] = RayProbe(exact[i].origin, exact[i].direction, 0, root);
            limits[i] = along[i].limit(exact[i].t_max);
        }
        const auto probe_of = [&](uint32_t i) -> const RayProbe& { return along[i]; };
        const auto ray_of = [&](uint32_t i) -> const gphys::Ray& { return exact[i]; };
        const Bvh8& tree = mesh_->bvh();
        gphys::RayPackets(root, tree.size())
            .split(ray_of, probe_of, count, [&](uint32_t first, uint32_t last, bool together) {
                kernels_.rays(tree.nodes(), tree.root(), mesh_->packets().data(), along + first,
                              prepared_.data() + first, limits + first, last - first, together);
            });
        for (uint32_t i = 0; i < count; ++i) {
            const FloatRay& ray = prepared_[i];
            FloatVec normal{};
            if (ray.item != no_object) {
                const uint32_t* corner = mesh_->indices().data() + 3 * ray.item;
                const FloatVec a = vec(mesh_->vertices()[corner[0]]);
                normal = cross(vec(mesh_->vertices()[corner[1]]) - a, vec(mesh_->vertices()[corner[2]]) - a);
                normal = normal * (1 / std::copysign(std::sqrt(dot(normal, normal)), -dot(normal, vec(ray.direction))));
            }
            hits[i] = to_hit(ray, point_of(ray), normal, ray.u, ray.v);
        }
    }

    const gphys::FloatKernels& kernels_ = gphys::float_kernels(gphys::chosen_isa());
    std::vector<FloatBox> boxes_;
    std::vector<FloatSphere> spheres_;
    std::unique_ptr<Bvh8> octree_;
    std::unique_ptr<const gphys::Mesh, Release> mesh_;
    std::vector<FloatRay> prepared_;
    std::vector<gphys_hit> hits_;
};

}  // namespace

std::unique_ptr<Implementation> make_gamephys_float() { return std::make_unique<GamephysFloat>(); }

}  // namespace bench
