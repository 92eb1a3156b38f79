// How deep solids are in convex shapes, meshes, hulls and frusta, and which way leads out. A depth is proved: gone that
// far along the normal, but for a band, the solid is out; and the ball of that radius is in the Minkowski difference,
// so that no other way is shorter.
#include "motion_cases.h"
#include "score.h"

using namespace test;

namespace {

template <class Solid>
using Escape = gphys_status (*)(gphys_shape_type type, const void* shape, const Solid& solid, gphys_penetration& out);
template <class Solid>
gphys_status library(gphys_shape_type type, const void* shape, const Solid& solid, gphys_penetration& out) {
    return gphys_shape_penetration(type, shape, type_of(solid), &solid, &out);
}
template <class Solid>
gphys_status deeper(gphys_shape_type type, const void* shape, const Solid& solid, gphys_penetration& out) {
    const gphys_status status = library(type, shape, solid, out);
    out.depth = after(after(after(out.depth)));
    return status;
}
template <class Solid>
gphys_status less_deep(gphys_shape_type type, const void* shape, const Solid& solid, gphys_penetration& out) {
    const gphys_status status = library(type, shape, solid, out);
    for (int i = 0; i < 3; ++i) out.depth = std::nextafterf(out.depth, 0.0f);
    return status;
}
template <class Solid>
gphys_status of_a_grown_solid(gphys_shape_type type, const void* shape, const Solid& solid, gphys_penetration& out) {
    return library(type, shape, grown(solid), out);
}
template <class Solid>
gphys_status the_other_way(gphys_shape_type type, const void* shape, const Solid& solid, gphys_penetration& out) {
    const gphys_status status = library(type, shape, solid, out);
    out.normal = {-out.normal.x, -out.normal.y, -out.normal.z};
    return status;
}
template <class Solid>
gphys_status displaced(gphys_shape_type type, const void* shape, const Solid& solid, gphys_penetration& out) {
    const gphys_status status = library(type, shape, solid, out);
    out.point.x += 0x1p-16f * std::max(std::fabs(out.point.x), out.depth);
    return status;
}

template <class Target, class Solid>
class WayOut {
    using Part = std::decay_t<decltype(std::declval<Target>().parts[0])>;

public:
    WayOut(const Target& target, const Solid& solid) : target_(target), solid_(solid) {
        for (const Part& part : target.parts) {
            parts_.emplace_back(part, solid, gphys_vec3{}, 0);
            size_ = std::max(size_, parts_.back().size());
        }
        band_ = 0x1p-40 * size_;
    }

    bool proves_apart() const {
        return std::all_of(parts_.begin(), parts_.end(),
                           [&](const auto& part) { return part.stays_beyond(-band_, 0, 0); });
    }
    bool proves(const gphys_penetration& out) const {
        const Part& part = target_.parts[target_.part_of(out.triangle)];
        const auto& met = parts_[target_.part_of(out.triangle)];
        const double ulp = ulp_of(out.depth);
        if (!(out.depth >= 0) || std::fabs(length(widen(out.normal)) - 1) > 0x1p-22) return false;
        // Where the cores all but touch, the way out may be that of a face beside the nearest point.
        const double radius = met.radius();
        const double band = radius > 0 && std::fabs(radius - out.depth) <= 0x1p-32 * size_ ? 0x1p-31 * size_ : band_;
        if (!met.gets_within(-out.depth + ulp + band, 0, 0)) return false;
        // No part is deeper.
        for (const auto& each : parts_) {
            if (!each.stays_beyond(-out.depth - ulp - band, 0, 0)) return false;
        }
        // Gone that way, which is rounded to floats in direction and length.
        const gphys_vec3 way = out.normal;
        const double rounding = 0x1p-22 * out.depth + 2 * ulp;
        if (!Encounter<Part, Solid>(part, solid_, way, out.depth).stays_beyond(-band - rounding, out.depth, out.depth))
            return false;
        return point_is_right(part, out);
    }

private:
    /// On the shape, and on the solid when it has gone there.
    bool point_is_right(const Part& part, const gphys_penetration& out) const {
        const gphys_sphere point{out.point, 0};
        const gphys_vec3 back{-out.normal.x, -out.normal.y, -out.normal.z};
        const double near = 0x1p-20 * size_ + 0x1p-22 * largest(widen(out.point)) + 4 * ulp_of(0);
        return Encounter<Part, gphys_sphere>(part, point, gphys_vec3{}, 0).gets_within(near, 0, 0) &&
               Encounter<Solid, gphys_sphere>(solid_, point, back, out.depth).gets_within(near, out.depth, out.depth);
    }

    const Target& target_;
    const Solid& solid_;
    std::vector<Encounter<Part, Solid>> parts_;
    double size_ = 0, band_;
};

template <class Target, class Solid>
auto examine(const std::string& name, uint64_t seed) {
    return [=](Escape<Solid> escape, long count) {
        Cases c(seed);
        Score score(name);
        for (long i = 0; i < count; c.next()) {
            Target target;
            if (!target.make(c)) continue;
            for (int k = 0; k < 10; ++k) {
                const Solid solid = solid_at<Solid>(c, c.one_in(3) ? c.point() : target.aim(c));
                gphys_penetration out{};
                const gphys_status status = escape(target.type(), target.data(), solid, out);
                if (status == GPHYS_ERROR_INVALID_ARGUMENT) continue;  // beyond the largest coordinates
                const bool met = status == GPHYS_OK;
                const WayOut<Target, Solid> truth(target, solid);
                const bool right = met ? truth.proves(out) : status == GPHYS_NO_HIT && truth.proves_apart();
                score.answer(met, met == right, met != right, solid, target.sample());
                ++i;
            }
        }
        return score;
    };
}

template <class Target, class Solid>
void prove_way_out(const std::string& name, uint64_t seed) {
    prove(cases(1000, 1000000), examine<Target, Solid>(name, seed), library<Solid>, deeper<Solid>, less_deep<Solid>,
          of_a_grown_solid<Solid>, the_other_way<Solid>, displaced<Solid>);
}
template <class Solid>
void prove_ways_out(const std::string& name, uint64_t seed) {
    prove_way_out<ShapeTarget<gphys_sphere>, Solid>(name + ", sphere", seed);
    prove_way_out<ShapeTarget<gphys_capsule>, Solid>(name + ", capsule", seed + 1);
    prove_way_out<ShapeTarget<gphys_aabb>, Solid>(name + ", AABB", seed + 2);
    prove_way_out<ShapeTarget<gphys_obb>, Solid>(name + ", OBB", seed + 3);
    prove_way_out<ShapeTarget<gphys_triangle>, Solid>(name + ", triangle", seed + 4);
    prove_way_out<MeshTarget, Solid>(name + ", mesh", seed + 5);
    prove_way_out<HullTarget, Solid>(name + ", hull", seed + 6);
}

}  // namespace

TEST_CASE("the way of a sphere out of shapes, meshes and hulls leads out, and none is shorter", "[penetration]") {
    prove_ways_out<gphys_sphere>("penetration sphere", 301);
}
TEST_CASE("the way of a capsule out of shapes, meshes and hulls leads out, and none is shorter", "[penetration]") {
    prove_ways_out<gphys_capsule>("penetration capsule", 311);
}
TEST_CASE("the way of an AABB out of shapes, meshes and hulls leads out, and none is shorter", "[penetration]") {
    prove_ways_out<gphys_aabb>("penetration AABB", 321);
}
TEST_CASE("the way of an OBB out of shapes, meshes and hulls leads out, and none is shorter", "[penetration]") {
    prove_ways_out<gphys_obb>("penetration OBB", 331);
}
TEST_CASE("the way of solids out of frusta leads out, and none is shorter", "[penetration]") {
    prove_way_out<FrustumTarget, gphys_sphere>("penetration sphere, frustum", 341);
    prove_way_out<FrustumTarget, gphys_capsule>("penetration capsule, frustum", 342);
    prove_way_out<FrustumTarget, gphys_aabb>("penetration AABB, frustum", 343);
    prove_way_out<FrustumTarget, gphys_obb>("penetration OBB, frustum", 344);
}
TEST_CASE("the edge of almost parallel planes of a frustum is that of the planes as they are", "[penetration]") {
    // The planes far and right meet at 1e-5 rad, 1e6 from the origin. The box is there.
    FrustumTarget target;
    REQUIRE(target.parts[0].make({{-2, 4, 4},
                                  {{{0x1.221352p-24f, 0x1.5224dap-16f, 1}, 1},
                                   {{1, -0x1.5224dap-16f, -1}, -0x1.6a09e6p+2f},
                                   {{0x1.000004p+0f, 0x1.cc7f34p-16f, 0x1.fffffep-1f}, 0},
                                   {{-0x1.fffffep-1f, 0x1.af950ap-17f, 0x1.000002p+0f}, 0},
                                   {{-0x1.ebb152p-18f, 0x1.fffeacp-1f, -0x1.01b0a4p-1f}, 0},
                                   {{0x1.edf1aap-18f, -0x1.fffd5cp-1f, 0x1.000152p+0f}, 0}}}));
    const gphys_obb box{{0x1.26d364p+20f, 0x1.893544p+19f, 0x1.26d30cp+20f},
                        {3, 0x1.fffffep+0f, 3},
                        {-0x1.edfdap-20f, 0x1.60bb22p-23f, -0x1.6b9be8p-23f, 1}};
    gphys_penetration out{};
    REQUIRE(library<gphys_obb>(target.type(), target.data(), box, out) == GPHYS_OK);
    CHECK(WayOut<FrustumTarget, gphys_obb>(target, box).proves(out));
}
