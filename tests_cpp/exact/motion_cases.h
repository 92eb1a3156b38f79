// Targets of sweeps and penetrations, with their convex parts: primitives, triangle meshes, convex hulls and frusta;
// and moving solids near them.
#pragma once

#include "frustum_target.h"
#include "true_hull.h"

namespace test {

template <class S>
struct ShapeTarget {
    std::vector<S> parts = std::vector<S>(1);

    bool make(Cases& c) {
        c.make(parts[0]);
        return true;
    }
    gphys_shape_type type() const { return type_of(parts[0]); }
    const void* data() const { return parts.data(); }
    const S& sample() const { return parts[0]; }
    gphys_vec3 aim(Cases& c) const { return target_on(c, parts[0]); }
    size_t part_of(uint32_t) const { return 0; }
};

/// An unbounded surface, which solids may hit from either side.
struct PlaneTarget {
    gphys_plane plane;

    bool make(Cases& c) {
        c.make(plane);
        return widen(plane.normal) != Vec3{};
    }
    gphys_shape_type type() const { return GPHYS_SHAPE_PLANE; }
    const void* data() const { return &plane; }
    const gphys_plane& sample() const { return plane; }
    gphys_vec3 aim(Cases& c) const { return target_on(c, plane); }
};

class MeshTarget {
public:
    std::vector<gphys_triangle> parts;

    MeshTarget() = default;
    MeshTarget(const MeshTarget&) = delete;
    ~MeshTarget() { gphys_mesh_destroy(mesh_); }

    bool make(Cases& c) {
        gphys_mesh_destroy(mesh_);
        parts.resize(1 + c.random.index(6));
        for (gphys_triangle& triangle : parts) c.make(triangle);
        const auto count = static_cast<uint32_t>(3 * parts.size());
        std::vector<uint32_t> indices(count);
        for (uint32_t i = 0; i < count; ++i) indices[i] = i;
        return gphys_mesh_create(nullptr, &parts[0].a.x, sizeof(gphys_vec3), count, indices.data(), count, &mesh_) ==
               GPHYS_OK;
    }
    gphys_shape_type type() const { return GPHYS_SHAPE_MESH; }
    const void* data() const { return mesh_; }
    const gphys_triangle& sample() const { return parts[0]; }
    gphys_vec3 aim(Cases& c) const { return target_on(c, parts[c.random.index(static_cast<uint32_t>(parts.size()))]); }
    size_t part_of(uint32_t triangle) const { return triangle; }

private:
    gphys_mesh* mesh_ = nullptr;
};

/// The corners of a hull, and the triangles of its faces.
struct HullPart {
    std::vector<gphys_vec3> corners;
    std::vector<gphys_triangle> faces;
};
template <class T>
Rounded<T> rounded_of(const HullPart& hull, gphys_vec3 from) {
    Rounded<T> result({}, from, 0);
    for (const gphys_vec3& corner : hull.corners) result.corners.push_back(VectorOf<T>(corner) - VectorOf<T>(from));
    return result;
}
template <class T>
Convex<T> convex_of(const HullPart& hull, gphys_vec3 from, double factor) {
    Convex<T> result{core_of<T>(hull, from, factor), {}, {}};
    for (const gphys_triangle& face : hull.faces) {
        const Convex<T> triangle = convex_of<T>(face, from, factor);
        result.normals.push_back(triangle.normals[0]);
        const gphys_vec3 corners[3] = {face.a, face.b, face.c};
        for (size_t i = 0; i < 3; ++i) {
            // The neighbour has each side, too, in the opposite direction.
            const gphys_vec3 &p = corners[i], &q = corners[(i + 1) % 3];
            if (std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z)) result.edges.push_back(triangle.edges[i]);
        }
    }
    return result;
}

class HullTarget {
public:
    std::vector<HullPart> parts = std::vector<HullPart>(1);

    bool make(Cases& c) {
        const std::vector<gphys_vec3> all = points(c, 12);
        const TrueHull truth(all);
        hull_.emplace(all);
        parts[0] = {all, truth.faces};
        return hull_->status == GPHYS_OK;
    }
    gphys_shape_type type() const { return GPHYS_SHAPE_MESH; }
    const void* data() const { return **hull_; }
    const gphys_triangle& sample() const { return parts[0].faces[0]; }
    gphys_vec3 aim(Cases& c) const {
        const auto& faces = parts[0].faces;
        return target_on(c, faces[c.random.index(static_cast<uint32_t>(faces.size()))]);
    }
    size_t part_of(uint32_t) const { return 0; }

private:
    std::optional<MadeHull> hull_;
};

inline gphys_vec3 moved(const gphys_vec3& p, Vec3 by) { return narrow(widen(p) + by); }
inline gphys_sphere moved(const gphys_sphere& s, Vec3 by) { return {moved(s.center, by), s.radius}; }
inline gphys_capsule moved(const gphys_capsule& s, Vec3 by) { return {moved(s.a, by), moved(s.b, by), s.radius}; }
inline gphys_aabb moved(const gphys_aabb& b, Vec3 by) { return {moved(b.min, by), moved(b.max, by)}; }
inline gphys_obb moved(const gphys_obb& b, Vec3 by) { return {moved(b.center, by), b.half_extents, b.rotation}; }

/// A solid with one of its points at a place.
template <class Solid>
Solid solid_at(Cases& c, const gphys_vec3& place) {
    Solid solid;
    c.make(solid);
    return moved(solid, widen(place) - widen(target_on(c, solid)));
}

/// The largest coordinate of a part besides those of its corners.
template <class Part>
double size_beside_corners(const Part&, gphys_vec3) {
    return 0;
}

/// A part of a target and a moving solid, with proofs about their separation at some or all times.
template <class Part, class Solid>
class Encounter {
public:
    /// `end`: the time at which the motion `way` * t ends.
    Encounter(const Part& part, const Solid& solid, const gphys_vec3& way, double end)
        : part_(part), solid_(solid), way_(way), from_(anchor(solid)) {
        for (const Rounded<double>& each : {rounded_of<double>(part, from_), rounded_of<double>(solid, from_)}) {
            for (const VectorOf<double>& corner : each.corners) size_ = std::max(size_, largest(corner) + each.radius);
        }
        size_ = std::max(size_, size_beside_corners(part, from_)) + largest(widen(way)) * end;
    }
    /// Upper bound of all coordinates relative to the first point of the solid, during the motion.
    double size() const { return size_; }

    /// The sum of both radii.
    double radius() const { return rounded_of<double>(part_, from_).radius + rounded_of<double>(solid_, from_).radius; }

    template <class Ask>
    bool between(double from, double to, const Ask& ask) const {
        const double factor = size_ > 0 ? std::ldexp(1.0, -std::ilogb(size_)) : 1;
        const auto build = [&](auto number) {
            using T = decltype(number);
            auto pair = std::make_pair(convex_of<T>(part_, from_, factor), convex_of<T>(solid_, from_, factor));
            const VectorOf<T> way = VectorOf<T>(way_) * T(factor);
            if (from == to) {
                for (auto& corner : pair.second.core.corners) corner = corner + way * T(from);
            } else {
                pair.second.sweep(way * T(from), way * T(to));
            }
            return pair;
        };
        return ask(Separation(build), factor);
    }
    /// Whether it is proved that the separation is at most `distance` at some time between `from` and `to`; at least
    /// `distance` at all these times.
    bool gets_within(double distance, double from, double to) const {
        return between(from, to, [&](const auto& pair, double factor) { return pair.at_most(distance * factor); });
    }
    bool stays_beyond(double distance, double from, double to) const {
        return between(from, to, [&](const auto& pair, double factor) { return pair.at_least(distance * factor); });
    }
    /// The gap along a vector at a time, in doubles.
    double gap(Vec3 n, double t) const {
        const auto high = [&](const Rounded<double>& of, Vec3 along) {
            double high = -INFINITY;
            for (const VectorOf<double>& p : of.corners)
                high = std::max(high, along.x * p.x + along.y * p.y + along.z * p.z);
            return high + of.radius * length(along);
        };
        return -high(rounded_of<double>(part_, from_), n) - high(rounded_of<double>(solid_, from_), -n) +
               dot(n, widen(way_)) * t;
    }

private:
    const Part& part_;
    const Solid& solid_;
    const gphys_vec3 way_, from_;
    double size_ = 0;
};

}  // namespace test
