// Embree: oriented boxes as user geometry, its own sphere type, triangle meshes, instances.
#include <embree3/rtcore.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "implementation.h"

namespace bench {

namespace {

struct V {
    float x, y, z;
};
V operator-(V a, V b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
float dot(V a, V b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
/// One instruction each, where std::fmax and std::fmin are calls for the sake of NaN.
float larger(float a, float b) { return a < b ? b : a; }
float smaller(float a, float b) { return a > b ? b : a; }

/// An oriented box as a user of Embree would keep it: centre, half extents, axes.
struct Box {
    V center, half, axis[3];
};

Box prepare(const gphys_obb& b) {
    const gphys_quat q = b.rotation;
    return {{b.center.x, b.center.y, b.center.z},
            {b.half_extents.x, b.half_extents.y, b.half_extents.z},
            {{1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y + q.w * q.z), 2 * (q.x * q.z - q.w * q.y)},
             {2 * (q.x * q.y - q.w * q.z), 1 - 2 * (q.x * q.x + q.z * q.z), 2 * (q.y * q.z + q.w * q.x)},
             {2 * (q.x * q.z + q.w * q.y), 2 * (q.y * q.z - q.w * q.x), 1 - 2 * (q.x * q.x + q.y * q.y)}}};
}

bool ray_box(const Box& box, V origin, V direction, float t_far, float& t) {
    const V o = origin - box.center;
    const float half[3] = {box.half.x, box.half.y, box.half.z};
    float t0 = 0, t1 = t_far;
    for (int k = 0; k < 3; ++k) {
        const float position = dot(o, box.axis[k]), inverse = 1 / dot(direction, box.axis[k]);
        const float middle = -position * inverse, reach = std::fabs(half[k] * inverse);
        t0 = larger(t0, middle - reach);
        t1 = smaller(t1, middle + reach);
    }
    t = t0;
    return t0 <= t1;
}

float squared_distance(const Box& box, V point) {
    const V d = point - box.center;
    const float half[3] = {box.half.x, box.half.y, box.half.z};
    float sum = 0;
    for (int k = 0; k < 3; ++k) {
        const float out = larger(0.0f, std::fabs(dot(d, box.axis[k])) - half[k]);
        sum += out * out;
    }
    return sum;
}
bool sphere_touches(const Box& box, V center, float radius) { return squared_distance(box, center) <= radius * radius; }
float squared_distance(const gphys_vec3& at, V point) {
    const V d = point - V{at.x, at.y, at.z};
    return dot(d, d);
}

/// The buffers of a mesh, which a user reads in callbacks.
struct Surface {
    struct Corners {
        V a, b, c;
    };

    Corners operator[](uint32_t triangle) const {
        const auto corner = [&](uint32_t k) {
            const gphys_vec3& p = vertices[indices[3 * triangle + k]];
            return V{p.x, p.y, p.z};
        };
        return {corner(0), corner(1), corner(2)};
    }

    const gphys_vec3* vertices;
    const uint32_t* indices;
};
/// By the region of the plane that the point is above (Ericson, "Real-time collision detection", 5.1.5).
float squared_distance(const Surface::Corners& t, V point) {
    const V ab = t.b - t.a, ac = t.c - t.a, from_a = point - t.a, from_b = point - t.b, from_c = point - t.c;
    const auto beyond = [&](V offset) { return dot(offset, offset); };
    const auto beside = [&](V from, V edge, float part) {
        return beyond({from.x - edge.x * part, from.y - edge.y * part, from.z - edge.z * part});
    };
    const float ab_a = dot(ab, from_a), ac_a = dot(ac, from_a);
    if (ab_a <= 0 && ac_a <= 0) return beyond(from_a);
    const float ab_b = dot(ab, from_b), ac_b = dot(ac, from_b);
    if (ab_b >= 0 && ac_b <= ab_b) return beyond(from_b);
    const float of_c = ab_a * ac_b - ab_b * ac_a;
    if (of_c <= 0 && ab_a >= 0 && ab_b <= 0) return beside(from_a, ab, ab_a / (ab_a - ab_b));
    const float ab_c = dot(ab, from_c), ac_c = dot(ac, from_c);
    if (ac_c >= 0 && ab_c <= ac_c) return beyond(from_c);
    const float of_b = ab_c * ac_a - ab_a * ac_c;
    if (of_b <= 0 && ac_a >= 0 && ac_c <= 0) return beside(from_a, ac, ac_a / (ac_a - ac_c));
    const float of_a = ab_b * ac_c - ab_c * ac_b;
    const float to_c = ac_b - ab_b, to_b = ab_c - ac_c;
    if (of_a <= 0 && to_c >= 0 && to_b >= 0) return beside(from_b, t.c - t.b, to_c / (to_c + to_b));
    const float scale = 1 / (of_a + of_b + of_c), v = of_b * scale, w = of_c * scale;
    return beyond({from_a.x - ab.x * v - ac.x * w, from_a.y - ab.y * v - ac.y * w, from_a.z - ab.z * v - ac.z * w});
}

/// By the fifteen axes of Gottschalk, Lin and Manocha 1996 that may separate them, those of the world first: most
/// boxes that do not touch are found by these.
bool aabb_touches(const Box& box, V center, V half_extents) {
    const V difference = box.center - center;
    const float d[3] = {difference.x, difference.y, difference.z};
    const float h[3] = {half_extents.x, half_extents.y, half_extents.z};
    const float half[3] = {box.half.x, box.half.y, box.half.z};
    float turn[3][3], size[3][3];  // component i of axis j
    for (int j = 0; j < 3; ++j) {
        const V& axis = box.axis[j];
        turn[0][j] = axis.x;
        turn[1][j] = axis.y;
        turn[2][j] = axis.z;
        for (int i = 0; i < 3; ++i) size[i][j] = std::fabs(turn[i][j]);
    }
    for (int i = 0; i < 3; ++i) {
        if (std::fabs(d[i]) > h[i] + half[0] * size[i][0] + half[1] * size[i][1] + half[2] * size[i][2]) return false;
    }
    for (int j = 0; j < 3; ++j) {
        const float reach = half[j] + h[0] * size[0][j] + h[1] * size[1][j] + h[2] * size[2][j];
        if (std::fabs(dot(difference, box.axis[j])) > reach) return false;
    }
    for (int i = 0; i < 3; ++i) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
        for (int j = 0; j < 3; ++j) {
            const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            const float reach =
                h[i1] * size[i2][j] + h[i2] * size[i1][j] + half[j1] * size[i][j2] + half[j2] * size[i][j1];
            if (std::fabs(d[i2] * turn[i1][j] - d[i1] * turn[i2][j]) > reach) return false;
        }
    }
    return true;
}

void box_bounds(const RTCBoundsFunctionArguments* args) {
    const Box& b = static_cast<const std::vector<Box>*>(args->geometryUserPtr)->at(args->primID);
    const auto reach = [&](float V::*axis) {
        return std::fabs(b.axis[0].*axis) * b.half.x + std::fabs(b.axis[1].*axis) * b.half.y +
               std::fabs(b.axis[2].*axis) * b.half.z;
    };
    RTCBounds& o = *args->bounds_o;
    o.lower_x = b.center.x - reach(&V::x);
    o.lower_y = b.center.y - reach(&V::y);
    o.lower_z = b.center.z - reach(&V::z);
    o.upper_x = b.center.x + reach(&V::x);
    o.upper_y = b.center.y + reach(&V::y);
    o.upper_z = b.center.z + reach(&V::z);
}

void point_bounds(const RTCBoundsFunctionArguments* args) {
    const gphys_vec3& p = (*static_cast<const std::vector<gphys_vec3>*>(args->geometryUserPtr))[args->primID];
    *args->bounds_o = {p.x, p.y, p.z, 0, p.x, p.y, p.z, 0};
}

void box_intersect(const RTCIntersectFunctionNArguments* args) {
    if (!args->valid[0]) return;
    auto* ray = reinterpret_cast<RTCRayHit*>(args->rayhit);
    const Box& b = (*static_cast<const std::vector<Box>*>(args->geometryUserPtr))[args->primID];
    float t;
    if (ray_box(b, {ray->ray.org_x, ray->ray.org_y, ray->ray.org_z}, {ray->ray.dir_x, ray->ray.dir_y, ray->ray.dir_z},
                ray->ray.tfar, t)) {
        ray->ray.tfar = t;
        ray->hit.primID = args->primID;
        ray->hit.geomID = args->geomID;
    }
}

/// The same for N rays side by side, in loops that the compiler vectorises. The fields of a packet are arrays of N
/// floats one after the other, in the order of RTCRayHit16.
template <unsigned N>
void box_intersect_lanes(const Box& box, const RTCIntersectFunctionNArguments* args) {
    float* const fields = reinterpret_cast<float*>(args->rayhit);
    const auto ray = [&](unsigned field, unsigned i) -> float& { return fields[field * N + i]; };
    constexpr unsigned org_x = 0, org_y = 1, org_z = 2, dir_x = 4, dir_y = 5, dir_z = 6, tfar = 8;
    const float half[3] = {box.half.x, box.half.y, box.half.z};
    float t0[N] = {}, t1[N];
    for (unsigned i = 0; i < N; ++i) t1[i] = ray(tfar, i);
    for (int k = 0; k < 3; ++k) {
        const V axis = box.axis[k];
        for (unsigned i = 0; i < N; ++i) {
            const float position = (ray(org_x, i) - box.center.x) * axis.x + (ray(org_y, i) - box.center.y) * axis.y +
                                   (ray(org_z, i) - box.center.z) * axis.z;
            const float inverse = 1 / (ray(dir_x, i) * axis.x + ray(dir_y, i) * axis.y + ray(dir_z, i) * axis.z);
            const float middle = -position * inverse, reach = std::fabs(half[k] * inverse);
            t0[i] = larger(t0[i], middle - reach);
            t1[i] = smaller(t1[i], middle + reach);
        }
    }
    for (unsigned i = 0; i < N; ++i) {
        if (!args->valid[i] || !(t0[i] <= t1[i])) continue;
        ray(tfar, i) = t0[i];
        RTCHitN* const hit = RTCRayHitN_HitN(args->rayhit, N);
        RTCHitN_primID(hit, N, i) = args->primID;
        RTCHitN_geomID(hit, N, i) = args->geomID;
    }
}

void box_intersect_packet(const RTCIntersectFunctionNArguments* args) {
    const Box& box = (*static_cast<const std::vector<Box>*>(args->geometryUserPtr))[args->primID];
    if (args->N == 16) {
        box_intersect_lanes<16>(box, args);
    } else if (args->N == 8) {
        box_intersect_lanes<8>(box, args);
    } else if (args->N == 4) {
        box_intersect_lanes<4>(box, args);
    } else {
        box_intersect_lanes<1>(box, args);
    }
}

void box_occluded(const RTCOccludedFunctionNArguments* args) {
    if (!args->valid[0]) return;
    auto* ray = reinterpret_cast<RTCRay*>(args->ray);
    const Box& b = (*static_cast<const std::vector<Box>*>(args->geometryUserPtr))[args->primID];
    float t;
    if (ray_box(b, {ray->org_x, ray->org_y, ray->org_z}, {ray->dir_x, ray->dir_y, ray->dir_z}, ray->tfar, t)) {
        ray->tfar = -std::numeric_limits<float>::infinity();
    }
}

class Embree final : public Implementation {
public:
    explicit Embree(EmbreeMode mode) : mode_(mode) {
        device_ = rtcNewDevice("threads=1");
        if (!device_) throw std::runtime_error("embree: no device");
        rtcSetDeviceMemoryMonitorFunction(
            device_,
            [](void* user, ssize_t bytes, bool) {
                static_cast<Heap*>(user)->add(bytes);
                return true;
            },
            &heap_);
    }
    ~Embree() override {
        release(inner_);
        release(scene_);
        rtcReleaseDevice(device_);
    }

    bool load(const std::vector<gphys_obb>& boxes) override {
        start();
        boxes_.reserve(boxes.size());
        for (const gphys_obb& b : boxes) boxes_.push_back(prepare(b));
        heap_.add(static_cast<int64_t>(boxes_.size() * sizeof boxes_[0]));  // what its callbacks read
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
        rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(boxes_.size()));
        rtcSetGeometryUserData(geometry, &boxes_);
        rtcSetGeometryBoundsFunction(geometry, box_bounds, nullptr);
        rtcSetGeometryIntersectFunction(geometry, wants_packets() ? box_intersect_packet : box_intersect);
        rtcSetGeometryOccludedFunction(geometry, box_occluded);
        finish(geometry);
        return true;
    }

    bool load(const std::vector<gphys_sphere>& spheres) override {
        start();
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_SPHERE_POINT);
        auto* data = static_cast<gphys_sphere*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, sizeof(gphys_sphere), spheres.size()));
        std::copy(spheres.begin(), spheres.end(), data);
        finish(geometry);
        return true;
    }

    bool load(const std::vector<gphys_vec3>& points) override {
        start();
        points_ = points;
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
        rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(points_.size()));
        rtcSetGeometryUserData(geometry, &points_);
        rtcSetGeometryBoundsFunction(geometry, point_bounds, nullptr);
        finish(geometry);
        return true;
    }

    bool load(const Triangles& mesh) override {
        start();
        RTCGeometry geometry = triangles(mesh);
        surface_.vertices =
            static_cast<const gphys_vec3*>(rtcGetGeometryBufferData(geometry, RTC_BUFFER_TYPE_VERTEX, 0));
        surface_.indices = static_cast<const uint32_t*>(rtcGetGeometryBufferData(geometry, RTC_BUFFER_TYPE_INDEX, 0));
        finish(geometry);
        return true;
    }

    bool load_deformable(const Triangles& mesh) override { return load(mesh); }

    bool deform(const std::vector<gphys_vec3>& vertices) override {
        RTCGeometry geometry = rtcGetGeometry(scene_, 0);
        std::copy(vertices.begin(), vertices.end(),
                  static_cast<gphys_vec3*>(rtcGetGeometryBufferData(geometry, RTC_BUFFER_TYPE_VERTEX, 0)));
        rtcUpdateGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0);
        rtcCommitGeometry(geometry);
        rtcCommitScene(scene_);
        return true;
    }

    bool load(const Triangles& mesh, const std::vector<gphys_transform>& placements) override {
        std::vector<Stretched> even;
        for (const gphys_transform& place : placements) even.push_back({place, {1, 1, 1}});
        return load(mesh, even);
    }

    bool load(const Triangles& mesh, const std::vector<Stretched>& stretched) override {
        start();
        inner_ = rtcNewScene(device_);
        attach(inner_, triangles(mesh));
        rtcCommitScene(inner_);
        for (const Stretched& s : stretched) {
            const gphys_transform& t = s.place;
            RTCGeometry instance = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_INSTANCE);
            rtcSetGeometryInstancedScene(instance, inner_);
            const Box axes = prepare({{0, 0, 0}, {0, 0, 0}, t.rotation});
            const float x = t.scale * s.scale.x, y = t.scale * s.scale.y, z = t.scale * s.scale.z;
            const float m[12] = {axes.axis[0].x * x, axes.axis[0].y * x, axes.axis[0].z * x, axes.axis[1].x * y,
                                 axes.axis[1].y * y, axes.axis[1].z * y, axes.axis[2].x * z, axes.axis[2].y * z,
                                 axes.axis[2].z * z, t.position.x,       t.position.y,       t.position.z};
            rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, m);
            attach(scene_, instance);
        }
        instances_ = true;
        rtcCommitScene(scene_);
        return true;
    }

    /// It has no solids but those of its users: the surface of the hull.
    bool load_hull(const Triangles& mesh, const std::vector<gphys_transform>& placements) override {
        return load(mesh, placements);
    }

    bool wants_packets() const override { return mode_ == EmbreeMode::packets || mode_ == EmbreeMode::packets_robust; }
    uint64_t memory() const override { return heap_.now(); }
    uint64_t peak_memory() const override { return heap_.peak(); }

    bool closest_singly(const std::vector<gphys_ray>& rays) override { return !wants_packets() && closest(rays); }
    bool any_singly(const std::vector<gphys_ray>& rays, std::vector<int32_t>& answers) override {
        return !wants_packets() && any(rays, answers);
    }

    bool closest(const std::vector<gphys_ray>& rays) override {
        if (wants_packets()) return closest_by_packets(rays);
        answers_.resize(rays.size());
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        for (size_t i = 0; i < rays.size(); ++i) {
            RTCRayHit r;
            r.ray = to_embree(rays[i]);
            r.hit.geomID = r.hit.primID = r.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(scene_, &context, &r);
            answers_[i] = answer(r.hit.geomID, r.hit.instID[0], r.hit.primID, r.ray.tfar);
        }
        return true;
    }

    bool nearest(const std::vector<gphys_vec3>& points) override {
        if (wants_packets()) return false;
        if (surface_.indices) return nearest_of(surface_, points);
        if (!boxes_.empty()) return nearest_of(boxes_, points);
        return !points_.empty() && nearest_of(points_, points);
    }
    bool nearest_singly(const std::vector<gphys_vec3>& points) override { return nearest(points); }

    bool segments(const std::vector<gphys_segment>& segments) override {
        if (mode_ == EmbreeMode::packets) return false;
        answers_.resize(segments.size());
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        for (size_t i = 0; i < segments.size(); ++i) {
            const gphys_vec3 a = segments[i].a, b = segments[i].b;
            RTCRayHit r;
            r.ray = to_embree({a, {b.x - a.x, b.y - a.y, b.z - a.z}, 1});
            r.hit.geomID = r.hit.primID = r.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(scene_, &context, &r);
            answers_[i] = answer(r.hit.geomID, r.hit.instID[0], r.hit.primID, r.ray.tfar);
        }
        return true;
    }

    bool any(const std::vector<gphys_ray>& rays, std::vector<int32_t>& answers) override {
        answers.resize(rays.size());
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        for (size_t i = 0; i < rays.size(); ++i) {
            RTCRay r = to_embree(rays[i]);
            rtcOccluded1(scene_, &context, &r);
            answers[i] = r.tfar < 0;
        }
        return true;
    }

    bool overlap(const std::vector<gphys_sphere>& queries, uint64_t& total) override {
        if (boxes_.empty()) return false;
        total = 0;
        for (const gphys_sphere& q : queries) {
            const V center{q.center.x, q.center.y, q.center.z};
            total += count_near(center, q.radius, [&](const Box& b) { return sphere_touches(b, center, q.radius); });
        }
        return true;
    }

    /// A point query knows spheres only: it is of the one around the box.
    bool overlap(const std::vector<gphys_aabb>& queries, uint64_t& total) override {
        if (boxes_.empty()) return false;
        total = 0;
        for (const gphys_aabb& q : queries) {
            const V center{(q.min.x + q.max.x) / 2, (q.min.y + q.max.y) / 2, (q.min.z + q.max.z) / 2};
            const V half{(q.max.x - q.min.x) / 2, (q.max.y - q.min.y) / 2, (q.max.z - q.min.z) / 2};
            const float radius = 1.00001f * std::sqrt(dot(half, half));
            total += count_near(center, radius, [&](const Box& b) { return aabb_touches(b, center, half); });
        }
        return true;
    }

    bool move_all(const std::vector<gphys_obb>& boxes) override {
        for (size_t i = 0; i < boxes.size(); ++i) boxes_[i] = prepare(boxes[i]);
        rtcCommitGeometry(rtcGetGeometry(scene_, 0));
        rtcCommitScene(scene_);
        return true;
    }

private:
    template <class Objects>
    bool nearest_of(const Objects& objects, const std::vector<gphys_vec3>& points) {
        answers_.clear();
        for (const gphys_vec3& point : points) answers_.push_back(nearest_of(objects, point));
        return true;
    }
    /// The ball of a point query shrinks to each object that is nearer.
    template <class Objects>
    Answer nearest_of(const Objects& objects, gphys_vec3 point) const {
        struct Found {
            const Objects& objects;
            V point;
            float squared;
            uint32_t object;
        } found{objects, {point.x, point.y, point.z}, std::numeric_limits<float>::infinity(), no_object};
        RTCPointQuery query{point.x, point.y, point.z, 0, std::numeric_limits<float>::infinity()};
        RTCPointQueryContext context;
        rtcInitPointQueryContext(&context);
        rtcPointQuery(
            scene_, &query, &context,
            [](RTCPointQueryFunctionArguments* args) {
                auto* f = static_cast<Found*>(args->userPtr);
                const float squared = squared_distance(f->objects[args->primID], f->point);
                if (squared >= f->squared) return false;
                f->squared = squared;
                f->object = args->primID;
                args->query->radius = std::sqrt(squared);
                return true;
            },
            &found);
        return {std::sqrt(found.squared), found.object};
    }

    /// How many boxes pass a test, of those whose bounds are that near.
    template <class Test>
    uint64_t count_near(V center, float radius, const Test& test) const {
        struct Found {
            const std::vector<Box>& boxes;
            const Test& test;
            uint64_t count;
        } found{boxes_, test, 0};
        RTCPointQuery query{center.x, center.y, center.z, 0, radius};
        RTCPointQueryContext context;
        rtcInitPointQueryContext(&context);
        rtcPointQuery(
            scene_, &query, &context,
            [](RTCPointQueryFunctionArguments* args) {
                auto* f = static_cast<Found*>(args->userPtr);
                f->count += f->test(f->boxes[args->primID]);
                return false;
            },
            &found);
        return found.count;
    }

    bool closest_by_packets(const std::vector<gphys_ray>& rays) {
        answers_.resize(rays.size());
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        for (size_t first = 0; first < rays.size(); first += 16) {
            alignas(64) int valid[16];
            RTCRayHit16 r;
            for (size_t lane = 0; lane < 16; ++lane) {
                valid[lane] = first + lane < rays.size() ? -1 : 0;
                const RTCRay one = to_embree(rays[std::min(first + lane, rays.size() - 1)]);
                r.ray.org_x[lane] = one.org_x;
                r.ray.org_y[lane] = one.org_y;
                r.ray.org_z[lane] = one.org_z;
                r.ray.tnear[lane] = one.tnear;
                r.ray.dir_x[lane] = one.dir_x;
                r.ray.dir_y[lane] = one.dir_y;
                r.ray.dir_z[lane] = one.dir_z;
                r.ray.time[lane] = one.time;
                r.ray.tfar[lane] = one.tfar;
                r.ray.mask[lane] = one.mask;
                r.ray.id[lane] = one.id;
                r.ray.flags[lane] = one.flags;
                r.hit.geomID[lane] = r.hit.primID[lane] = r.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
            }
            rtcIntersect16(valid, scene_, &context, &r);
            for (size_t lane = 0; lane < 16 && valid[lane]; ++lane) {
                answers_[first + lane] =
                    answer(r.hit.geomID[lane], r.hit.instID[0][lane], r.hit.primID[lane], r.ray.tfar[lane]);
            }
        }
        return true;
    }

    Answer answer(unsigned geometry, unsigned instance, unsigned primitive, float t) const {
        if (geometry == RTC_INVALID_GEOMETRY_ID) return {std::numeric_limits<float>::infinity(), no_object};
        return {t, instances_ ? instance : primitive};
    }

    static void release(RTCScene& scene) {
        if (scene) rtcReleaseScene(scene);
        scene = nullptr;
    }

    void start() {
        release(inner_);
        release(scene_);
        if (!boxes_.empty()) heap_.add(-static_cast<int64_t>(boxes_.size() * sizeof boxes_[0]));
        boxes_ = {};
        points_ = {};
        surface_ = {};
        heap_.forget_peak();
        scene_ = rtcNewScene(device_);
        instances_ = false;
        if (mode_ == EmbreeMode::robust || mode_ == EmbreeMode::packets_robust)
            rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        if (mode_ == EmbreeMode::refit) {  // Embree refits only under both of these, else it rebuilds
            rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_DYNAMIC);
            rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_LOW);
        }
    }

    RTCGeometry triangles(const Triangles& mesh) {
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertices = static_cast<gphys_vec3*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(gphys_vec3), mesh.vertices.size()));
        auto* indices = static_cast<uint32_t*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.count()));
        std::copy(mesh.vertices.begin(), mesh.vertices.end(), vertices);
        std::copy(mesh.indices.begin(), mesh.indices.end(), indices);
        return geometry;
    }

    void attach(RTCScene scene, RTCGeometry geometry) {
        if (mode_ == EmbreeMode::refit) rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_REFIT);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
    }

    void finish(RTCGeometry geometry) {
        attach(scene_, geometry);
        rtcCommitScene(scene_);
    }

    static RTCRay to_embree(const gphys_ray& r) {
        RTCRay e;
        e.org_x = r.origin.x;
        e.org_y = r.origin.y;
        e.org_z = r.origin.z;
        e.tnear = 0;
        e.dir_x = r.direction.x;
        e.dir_y = r.direction.y;
        e.dir_z = r.direction.z;
        e.time = 0;
        e.tfar = r.t_max;
        e.mask = 0xffffffff;
        e.id = 0;
        e.flags = 0;
        return e;
    }

    RTCDevice device_;
    RTCScene scene_ = nullptr, inner_ = nullptr;
    std::vector<Box> boxes_;
    Heap heap_;
    std::vector<gphys_vec3> points_;
    Surface surface_{};
    EmbreeMode mode_;
    bool instances_ = false;
};

}  // namespace

std::unique_ptr<Implementation> make_embree(EmbreeMode mode) { return std::make_unique<Embree>(mode); }

}  // namespace bench
