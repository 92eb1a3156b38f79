// Convex hulls of points, through the public interface: held against the hull that CGAL makes of the same points, and
// against distances of polytopes.
#include "certified_pairs.h"
#include "score.h"
#include "true_hull.h"

using namespace test;

namespace {

/// The same hull as a model: of points that are divided by a scale, which the model has. Powers of two, so that the
/// truth is that of the points.
class ScaledHull {
public:
    using Target = gphys_scene;

    explicit ScaledHull(const std::vector<gphys_vec3>& points) : status(GPHYS_ERROR_INVALID_ARGUMENT) {
        constexpr gphys_vec3 scale{4, 0.5f, 0x1p-10f};
        std::vector<gphys_vec3> divided;
        for (const gphys_vec3& p : points) {
            divided.push_back({p.x / scale.x, p.y / scale.y, p.z / scale.z});
            const gphys_vec3& d = divided.back();
            if (d.x * scale.x != p.x || d.y * scale.y != p.y || d.z * scale.z != p.z) return;
        }
        const MadeHull hull(divided);
        status = hull.status;
        if (status != GPHYS_OK) return;
        gphys_model_desc desc;
        gphys_model_id model;
        REQUIRE(gphys_model_desc_init(&desc, sizeof desc) == GPHYS_OK);
        desc.scale = scale;
        REQUIRE(gphys_scene_create(nullptr, &scene_) == GPHYS_OK);
        status = gphys_scene_add(scene_, GPHYS_SHAPE_MESH, *hull, nullptr, &desc, &model);
    }
    ~ScaledHull() { gphys_scene_destroy(scene_); }
    ScaledHull(const ScaledHull&) = delete;
    const gphys_scene* operator*() const { return scene_; }
    gphys_status status;

private:
    gphys_scene* scene_ = nullptr;
};

gphys_vec3 by(Cases& c, const std::vector<gphys_vec3>& all) {
    const auto any = [&] { return all[c.random.index(static_cast<uint32_t>(all.size()))]; };
    const gphys_vec3 p = any(), q = any(), r = any();
    return c.point_by(p, q, r);
}

template <class Hull>
using Holds = bool (*)(const typename Hull::Target* hull, const gphys_vec3& point);
bool library(const gphys_mesh* hull, const gphys_vec3& point) {
    int32_t contains = -1;
    REQUIRE(gphys_shape_contains(GPHYS_SHAPE_MESH, hull, &point, 0, &contains) == GPHYS_OK);
    return contains == 1;
}
/// By the planes, which are rounded.
bool by_planes(const gphys_mesh* hull, const gphys_vec3& point) {
    gphys_plane planes[256];
    uint32_t total;
    gphys_mesh_get_hull_planes(hull, planes, 256, &total);
    return std::all_of(planes, planes + total, [&](const gphys_plane& plane) {
        return dot(widen(plane.normal), widen(point)) <= plane.distance;
    });
}

/// As a ray that goes nowhere.
bool in_scaled(const gphys_scene* scene, const gphys_vec3& point) {
    const gphys_ray ray{point, {1, 0, 0}, 0};
    gphys_hit hit{};
    return gphys_scene_raycast(scene, &ray, 1, &hit) == GPHYS_OK;
}
bool in_scaled_box(const gphys_scene* scene, const gphys_vec3& point) {
    gphys_aabb box;
    REQUIRE(gphys_scene_get_scene_bounds(scene, &box) == GPHYS_OK);
    return point.x >= box.min.x && point.x <= box.max.x && point.y >= box.min.y && point.y <= box.max.y;
}

template <class Hull>
Score contains(Holds<Hull> holds, long count) {
    constexpr bool scaled = std::is_same_v<Hull, ScaledHull>;
    Cases c(scaled ? 87 : 81);
    Score score(scaled ? "contains scaled hull" : "contains hull");
    for (long i = 0; i < count; c.next()) {
        const std::vector<gphys_vec3> all = points(c, 14);
        const TrueHull truth(all);
        const Hull hull(all);
        if (hull.status != GPHYS_OK) {
            // Only flat ones are refused.
            if constexpr (!scaled) REQUIRE(truth.planes.empty());
            ++i;
            continue;
        }
        if constexpr (!scaled) REQUIRE(hull.faces() == truth.face_count());
        for (int k = 0; k < 20; ++k, ++i) {
            const gphys_vec3 point = by(c, all);
            score.answer(holds(*hull, point), truth.holds(exact(point)), point, all[0], all[1], all[2], all[3]);
        }
    }
    return score;
}

template <class Hull>
using Cast = bool (*)(const typename Hull::Target* hull, const gphys_ray& ray, gphys_hit& hit);
bool cast_at_scaled(const gphys_scene* scene, const gphys_ray& ray, gphys_hit& hit) {
    return gphys_scene_raycast(scene, &ray, 1, &hit) == GPHYS_OK;
}
bool cast_late_at_scaled(const gphys_scene* scene, const gphys_ray& ray, gphys_hit& hit) {
    if (!cast_at_scaled(scene, ray, hit)) return false;
    hit.t *= 1 + 0x1p-21f;
    return true;
}
bool cast(const gphys_mesh* hull, const gphys_ray& ray, gphys_hit& hit) {
    return gphys_shape_raycast(GPHYS_SHAPE_MESH, hull, &ray, &hit) == GPHYS_OK;
}
/// As at a surface, which is met from within, too.
bool cast_at_surface(const gphys_mesh* hull, const gphys_ray& ray, gphys_hit& hit) {
    return cast(hull, ray, hit) && (hit.flags & GPHYS_HIT_INSIDE) == 0;
}
bool cast_late(const gphys_mesh* hull, const gphys_ray& ray, gphys_hit& hit) {
    if (!cast(hull, ray, hit)) return false;
    hit.t *= 1 + 0x1p-21f;
    return true;
}

template <class Hull>
Score raycast(Cast<Hull> meets, long count) {
    constexpr bool scaled = std::is_same_v<Hull, ScaledHull>;
    Cases c(scaled ? 88 : 82);
    Score score(scaled ? "raycast scaled hull" : "raycast hull", 1, "ulp of t");
    for (long i = 0; i < count; c.next()) {
        const std::vector<gphys_vec3> all = points(c, 14);
        const TrueHull truth(all);
        const Hull hull(all);
        if (hull.status != GPHYS_OK) {
            ++i;
            continue;
        }
        for (int k = 0; k < 20; ++k, ++i) {
            const gphys_ray ray = c.ray_to(by(c, all));
            if (gphys_shape_validate(GPHYS_SHAPE_RAY, &ray) != GPHYS_OK) continue;
            gphys_hit hit{};
            const std::optional<Number> entry = truth.entry(ray);
            const bool met = meets(*hull, ray, hit);
            score.answer(met, entry.has_value(), ray, all[0], all[1], all[2], all[3]);
            if (!met || !entry) continue;
            const double t = rounded(*entry);
            if (t > FLT_MIN && t < FLT_MAX) score.error(error_of(hit.t, *entry) / ulp_of(t), ray, all[0], all[1]);
            REQUIRE((hit.flags & GPHYS_HIT_BACK) == 0);
            REQUIRE(((hit.flags & GPHYS_HIT_INSIDE) != 0) == truth.holds(exact(ray.origin)));
        }
    }
    return score;
}

template <class S>
using Overlaps = bool (*)(const gphys_mesh* hull, const S& solid);
template <class S>
bool overlap(const gphys_mesh* hull, const S& solid) {
    int32_t overlaps = -1;
    REQUIRE(gphys_shape_overlaps(GPHYS_SHAPE_MESH, hull, type_of(solid), &solid, &overlaps) == GPHYS_OK);
    return overlaps == 1;
}
/// Its triangles alone, which nothing inside touches.
template <class S>
bool overlap_of_surface(const gphys_mesh* hull, const S& solid) {
    uint32_t total = 0;
    gphys_mesh_overlap(hull, type_of(solid), &solid, nullptr, 0, &total);
    return total > 0;
}

gphys_aabb smaller(const gphys_aabb& b) {
    const Vec3 by = (widen(b.max) - widen(b.min)) * 0x1p-4;
    return {narrow(widen(b.min) + by), narrow(widen(b.max) - by)};
}
gphys_obb smaller(const gphys_obb& b) { return {b.center, narrow(widen(b.half_extents) * (1 - 0x1p-4)), b.rotation}; }
template <class S>
bool overlap_of_a_smaller_one(const gphys_mesh* hull, const S& solid) {
    return overlap(hull, smaller(solid));
}

/// Whether the hulls of two sets of corners are at most `reach` apart. Intervals decide nearly all cases, exact numbers
/// the rest.
bool are_within(double reach, const Rounded<double>& a, const Rounded<double>& b) {
    if (reach < 0) return false;
    const NearestCorners by(a, b);
    {
        const Upward upward;
        const auto intervals = [](const Rounded<double>& shape) {
            Rounded<Range> result({}, {}, Range(0));
            for (const VectorOf<double>& v : shape.corners)
                result.corners.emplace_back(Range(v.x), Range(v.y), Range(v.z));
            return result;
        };
        const Rounded<Range> p = intervals(a), q = intervals(b);
        const PairProof<Range> proof(p, q, by);
        if (proof.within(Range(reach))) return true;
        if (proof.beyond(Range(reach))) return false;
    }
    const CGAL::Quotient<Binary> square = squared_distance(a, b);
    return square.numerator() <= square.denominator() * Binary(reach) * Binary(reach);
}

/// Whether a box overlaps even if it is smaller by 2^-30 of itself, where that is more than rounding.
bool is_deep(const Rounded<double>& hull, Rounded<double> box, double size) {
    if (box.corners.size() != 8) return false;
    const VectorOf<double> first = box.corners[0], center = (first + box.corners[7]) * 0.5;
    for (const int axis : {1, 2, 4}) {
        if (largest(box.corners[static_cast<size_t>(axis)] - first) <= 0x1p-16 * size) return false;
    }
    for (auto& corner : box.corners) corner = center + (corner - center) * (1 - 0x1p-30);
    return are_within(0, hull, box);
}

/// A hull of up to eight vertices, as its corners.
template <class S>
auto overlaps(const char* name, uint64_t seed) {
    return [=](Overlaps<S> meets, long count) {
        Cases c(seed);
        Score score(name);
        for (long i = 0; i < count; c.next()) {
            const std::vector<gphys_vec3> all = points(c, 8);
            const MadeHull hull(all);
            if (hull.status != GPHYS_OK) {
                ++i;
                continue;
            }
            for (int k = 0; k < 5; ++k, ++i) {
                S solid;
                c.make(solid);
                const gphys_vec3 from = all[0];
                Rounded<double> corners({}, from, 0), other = rounded_of<double>(solid, from);
                double size = other.radius;
                for (const gphys_vec3& p : all) {
                    corners.corners.push_back(VectorOf<double>(p) - VectorOf<double>(from));
                    size = std::max(size, largest(corners.corners.back()));
                }
                for (const auto& p : other.corners) size = std::max(size, largest(p));
                const double slack = 0x1p-40 * 2 * size, r = other.radius;
                const auto up_to = [&](double distance) { return are_within(distance, corners, other); };
                score.answer(meets(*hull, solid), up_to(r + slack), !up_to(r - slack) && !is_deep(corners, other, size),
                             solid, all[0], all[1], all[2], all[3]);
            }
        }
        return score;
    };
}

}  // namespace

TEST_CASE("points are in the hull of points exactly when they are", "[hull]") {
    prove(cases(20000, 2000000), contains<MadeHull>, library, by_planes);
}

TEST_CASE("rays meet hulls exactly when they do", "[hull]") {
    prove(cases(20000, 2000000), raycast<MadeHull>, cast, cast_at_surface, cast_late);
}

TEST_CASE("a hull that is scaled per axis as a model holds points and meets rays exactly when it does", "[hull]") {
    prove(cases(20000, 1000000), contains<ScaledHull>, in_scaled, in_scaled_box);
    prove(cases(20000, 1000000), raycast<ScaledHull>, cast_at_scaled, cast_late_at_scaled);
}

TEST_CASE("solids overlap hulls when they do, but for 2^-40 of the coordinates", "[hull]") {
    const long count = cases(1000, 1000000);
    prove(count, overlaps<gphys_sphere>("overlap hull, sphere", 83), overlap<gphys_sphere>,
          overlap_of_surface<gphys_sphere>);
    prove(count, overlaps<gphys_capsule>("overlap hull, capsule", 84), overlap<gphys_capsule>,
          overlap_of_surface<gphys_capsule>);
    prove(count, overlaps<gphys_aabb>("overlap hull, AABB", 85), overlap<gphys_aabb>,
          overlap_of_a_smaller_one<gphys_aabb>);
    prove(count, overlaps<gphys_obb>("overlap hull, OBB", 86), overlap<gphys_obb>, overlap_of_a_smaller_one<gphys_obb>);
}
