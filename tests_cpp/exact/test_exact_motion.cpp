// When moving solids first touch convex shapes, planes, meshes, hulls and frusta. A time is proved: until shortly before
// it, what the solid has covered on its way stays away from the shape; around it the two meet. Shortly is an ulp of the
// time and the band of the contract.
#include "motion_cases.h"
#include "score.h"

using namespace test;

namespace {

template <class Solid>
using Sweep = gphys_status (*)(gphys_shape_type type, const void* shape, const Solid& solid, const gphys_vec3& way,
                               gphys_hit& hit);
template <class Solid>
gphys_status library(gphys_shape_type type, const void* shape, const Solid& solid, const gphys_vec3& way,
                     gphys_hit& hit) {
    return gphys_shape_sweep(type, shape, type_of(solid), &solid, &way, &hit);
}
template <class Solid>
gphys_status late(gphys_shape_type type, const void* shape, const Solid& solid, const gphys_vec3& way, gphys_hit& hit) {
    const gphys_status status = library(type, shape, solid, way, hit);
    hit.t = after(after(after(hit.t)));
    return status;
}
template <class Solid>
gphys_status early(gphys_shape_type type, const void* shape, const Solid& solid, const gphys_vec3& way,
                   gphys_hit& hit) {
    const gphys_status status = library(type, shape, solid, way, hit);
    for (int i = 0; i < 3; ++i) hit.t = std::nextafterf(hit.t, 0.0f);
    return status;
}
template <class Solid>
gphys_status of_a_grown_solid(gphys_shape_type type, const void* shape, const Solid& solid, const gphys_vec3& way,
                              gphys_hit& hit) {
    return library(type, shape, grown(solid), way, hit);
}
/// The normal of another place.
template <class Solid>
gphys_status turned(gphys_shape_type type, const void* shape, const Solid& solid, const gphys_vec3& way,
                    gphys_hit& hit) {
    const gphys_status status = library(type, shape, solid, way, hit);
    std::swap(hit.normal.x, hit.normal.y);
    return status;
}
template <class Solid>
gphys_status displaced(gphys_shape_type type, const void* shape, const Solid& solid, const gphys_vec3& way,
                       gphys_hit& hit) {
    const gphys_status status = library(type, shape, solid, way, hit);
    hit.point.x += 0x1p-16f * std::max(std::fabs(hit.point.x), std::fabs(way.x));
    return status;
}

template <class Target, class Solid>
class Way {
public:
    Way(const Target& target, const Solid& solid, const gphys_vec3& way) : target_(target), solid_(solid), way_(way) {
        for (const auto& part : target.parts) {
            parts_.emplace_back(part, solid, way, 1);
            size_ = std::max(size_, parts_.back().size());
        }
        band_ = 0x1p-40 * size_;
    }

    bool proves_miss() const { return stays_away_until(1); }
    bool proves(const gphys_hit& hit) const {
        if (hit.flags & GPHYS_HIT_INSIDE) {
            return hit.t == 0 && std::any_of(parts_.begin(), parts_.end(),
                                             [&](const auto& part) { return part.gets_within(band_, 0, 0); });
        }
        const float before = std::nextafterf(hit.t, 0.0f), later = std::min(after(hit.t), 1.0f);
        const auto& met = parts_[target_.part_of(hit.triangle)];
        return hit.t >= 0 && hit.t <= 1 && met.gets_within(band_, before, later) && stays_away_until(before) &&
               normal_is_right(met, hit) && point_is_right(hit);
    }

private:
    bool stays_away_until(double t) const {
        return t == 0 || std::all_of(parts_.begin(), parts_.end(),
                                     [&](const auto& part) { return part.stays_beyond(-band_, 0, t); });
    }
    /// What rounds the time, the normal and the point to floats.
    double rounding(const gphys_hit& hit) const {
        return 0x1p-20 * (size_ + hit.t * largest(widen(way_))) + 4 * ulp_of(0);
    }
    template <class Part>
    bool normal_is_right(const Part& met, const gphys_hit& hit) const {
        const Vec3 normal = widen(hit.normal);
        // Of a radius that is little more than rounding, the direction is not known better.
        const double radius = met.radius();
        const double turn = radius > 0 ? std::min(0x1p-36 * size_ / radius, 1.0) : 0;
        return std::fabs(length(normal) - 1) < 0x1p-22 && dot(normal, widen(way_)) <= 0 &&
               (met.gap(normal, hit.t) >= -rounding(hit) - turn * size_ || is_of_a_ray(hit));
    }
    /// A sphere without radius is met as by a ray, whose direction says the normal of a triangle without area.
    bool is_of_a_ray(const gphys_hit& hit) const {
        const auto& part = target_.parts[target_.part_of(hit.triangle)];
        if constexpr (std::is_same_v<Solid, gphys_sphere> &&
                      std::is_same_v<std::decay_t<decltype(part)>, gphys_triangle>) {
            return solid_.radius == 0 && CGAL::collinear(exact(part.a), exact(part.b), exact(part.c)) &&
                   length(widen(hit.normal) + normalized(widen(way_))) < 0x1p-22;
        }
        return false;
    }
    /// On the shape, and on the solid when it has come there.
    bool point_is_right(const gphys_hit& hit) const {
        const gphys_sphere point{hit.point, 0};
        const gphys_vec3 nowhere{}, back{-way_.x, -way_.y, -way_.z};
        const double near = rounding(hit) + 0x1p-22 * largest(widen(hit.point));
        using Part = std::decay_t<decltype(target_.parts[0])>;
        return Encounter<Part, gphys_sphere>(target_.parts[target_.part_of(hit.triangle)], point, nowhere, 0)
                   .gets_within(near, 0, 0) &&
               Encounter<Solid, gphys_sphere>(solid_, point, back, hit.t).gets_within(near, hit.t, hit.t);
    }

    const Target& target_;
    const Solid& solid_;
    const gphys_vec3 way_;
    std::vector<Encounter<std::decay_t<decltype(std::declval<Target>().parts[0])>, Solid>> parts_;
    double size_ = 0, band_;
};

/// The same of a plane: by the heights of the solid above it, with 300 digits, for a normal has any length.
template <class Solid>
class Way<PlaneTarget, Solid> {
public:
    Way(const PlaneTarget& target, const Solid& solid, const gphys_vec3& way)
        : plane_(target.plane), solid_(solid), way_(way), climb_(dot(BigVec(plane_.normal), BigVec(way))) {
        const Rounded<Big> corners = rounded_of<Big>(solid, {});
        const BigVec normal(plane_.normal);
        const Big steepness = sqrt(dot(normal, normal)), radius = corners.radius * steepness;
        for (const BigVec& corner : corners.corners) {
            const Big height = dot(normal, corner) - Big(plane_.distance);
            low_ = std::min(low_, Big(height - radius));
            high_ = std::max(high_, Big(height + radius));
        }
        for (const VectorOf<double>& corner : rounded_of<double>(solid, {}).corners)
            size_ = std::max(size_, largest(corner) + rounded(corners.radius));
        size_ += std::fabs(plane_.distance) / rounded(steepness) + largest(widen(way));
        band_ = Big(0x1p-40 * size_) * steepness;
    }

    bool proves_miss() const { return stays_away_until(1); }
    bool proves(const gphys_hit& hit) const {
        if (hit.flags & GPHYS_HIT_INSIDE) return hit.t == 0 && low_ <= band_ && high_ >= -band_;
        const float before = std::nextafterf(hit.t, 0.0f), later = std::min(after(hit.t), 1.0f);
        return hit.t >= 0 && hit.t <= 1 && gets_within(before, later) && stays_away_until(before) &&
               normal_is_right(hit) && point_is_right(hit);
    }

private:
    /// On one side.
    bool stays_away_until(double t) const {
        const Big rise = climb_ * Big(t);
        return std::min(low_, Big(low_ + rise)) >= -band_ || std::max(high_, Big(high_ + rise)) <= band_;
    }
    bool gets_within(double from, double to) const {
        // At one end of that time, or where the solid begins or ends to touch the plane, or that all but the band away.
        const Big nearly = band_ * Big(0.999);
        for (const Big& height : {low_, high_}) {
            for (const Big& edge : {nearly, Big(0), Big(-nearly)}) {
                if (climb_ != 0 && is_within((edge - height) / climb_, from, to)) return true;
            }
        }
        return is_within(from, from, to) || is_within(to, from, to);
    }
    bool is_within(const Big& t, double from, double to) const {
        return t >= from && t <= to && low_ + climb_ * t <= band_ && high_ + climb_ * t >= -band_;
    }
    bool normal_is_right(const gphys_hit& hit) const {
        const Vec3 normal = widen(hit.normal), up = normalized(widen(plane_.normal));
        const bool is_above = (hit.flags & GPHYS_HIT_BACK) == 0;
        return length(normal - (is_above ? up : -up)) < 0x1p-22 && dot(normal, widen(way_)) <= 0 &&
               (is_above ? low_ >= -band_ : high_ <= band_);
    }
    /// On the plane, and on the solid when it has come there.
    bool point_is_right(const gphys_hit& hit) const {
        const gphys_vec3 back{-way_.x, -way_.y, -way_.z};
        const double near = 0x1p-20 * size_ + 0x1p-22 * largest(widen(hit.point)) + 4 * ulp_of(0);
        const Vec3 normal = widen(plane_.normal);
        return std::fabs(dot(normal, widen(hit.point)) - plane_.distance) <= near * length(normal) &&
               Encounter<Solid, gphys_sphere>(solid_, {hit.point, 0}, back, hit.t).gets_within(near, hit.t, hit.t);
    }

    const gphys_plane plane_;
    const Solid& solid_;
    const gphys_vec3 way_;
    const Big climb_;
    Big low_ = INFINITY, high_ = -INFINITY, band_;
    double size_ = 0;
};

template <class Target, class Solid>
auto examine(const std::string& name, uint64_t seed) {
    return [=](Sweep<Solid> sweep, long count) {
        Cases c(seed);
        Score score(name);
        for (long i = 0; i < count; c.next()) {
            Target target;
            if (!target.make(c)) continue;
            for (int k = 0; k < 10; ++k) {
                const gphys_ray ray = c.ray_to(target.aim(c));
                const Solid solid = solid_at<Solid>(c, ray.origin);
                gphys_vec3 way = ray.direction;
                if (c.one_in(2)) way = {way.x * 2, way.y * 2, way.z * 2};
                gphys_hit hit{};
                const gphys_status status = sweep(target.type(), target.data(), solid, way, hit);
                if (status == GPHYS_ERROR_INVALID_ARGUMENT) continue;  // beyond the largest coordinates
                const bool met = status == GPHYS_OK;
                const Way<Target, Solid> truth(target, solid, way);
                const bool right = met ? truth.proves(hit) : status == GPHYS_NO_HIT && truth.proves_miss();
                score.answer(met, met == right, met != right, solid, way, target.sample());
                ++i;
            }
        }
        return score;
    };
}

template <class Target, class Solid>
void prove_sweep(const std::string& name, uint64_t seed) {
    prove(cases(1000, 1000000), examine<Target, Solid>(name, seed), library<Solid>, late<Solid>, early<Solid>,
          of_a_grown_solid<Solid>, turned<Solid>, displaced<Solid>);
}

template <class Solid>
void prove_sweeps(const std::string& name, uint64_t seed) {
    prove_sweep<ShapeTarget<gphys_sphere>, Solid>(name + ", sphere", seed);
    prove_sweep<ShapeTarget<gphys_capsule>, Solid>(name + ", capsule", seed + 1);
    prove_sweep<ShapeTarget<gphys_aabb>, Solid>(name + ", AABB", seed + 2);
    prove_sweep<ShapeTarget<gphys_obb>, Solid>(name + ", OBB", seed + 3);
    prove_sweep<ShapeTarget<gphys_triangle>, Solid>(name + ", triangle", seed + 4);
    prove_sweep<PlaneTarget, Solid>(name + ", plane", seed + 5);
}
template <class Solid>
void prove_sweeps_of_meshes(const std::string& name, uint64_t seed) {
    prove_sweep<MeshTarget, Solid>(name + ", mesh", seed);
    prove_sweep<HullTarget, Solid>(name + ", hull", seed + 1);
}

}  // namespace

TEST_CASE("a capsule swept against each shape touches it when it does", "[motion]") {
    prove_sweeps<gphys_capsule>("sweep capsule", 201);
}
TEST_CASE("an AABB swept against each shape touches it when it does", "[motion]") {
    prove_sweeps<gphys_aabb>("sweep AABB", 211);
}
TEST_CASE("an OBB swept against each shape touches it when it does", "[motion]") {
    prove_sweeps<gphys_obb>("sweep OBB", 221);
}
TEST_CASE("solids swept against meshes and hulls touch them when they do", "[motion]") {
    prove_sweeps_of_meshes<gphys_sphere>("sweep sphere", 231);
    prove_sweeps_of_meshes<gphys_capsule>("sweep capsule", 233);
    prove_sweeps_of_meshes<gphys_aabb>("sweep AABB", 235);
    prove_sweeps_of_meshes<gphys_obb>("sweep OBB", 237);
}
TEST_CASE("solids swept against frusta touch them when they do", "[motion]") {
    prove_sweep<FrustumTarget, gphys_capsule>("sweep capsule, frustum", 241);
    prove_sweep<FrustumTarget, gphys_aabb>("sweep AABB, frustum", 242);
    prove_sweep<FrustumTarget, gphys_obb>("sweep OBB, frustum", 243);
}
