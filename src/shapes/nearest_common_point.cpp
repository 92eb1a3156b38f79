// An LP-type problem (Matousek, Sharir, Welzl 1996), solved by an active-set method: at most three half-spaces, a
// basis, determine the nearest point. While a half-space excludes the point, the one that excludes it most is added.
// The nearest point of these half-spaces, at most four, is on the plane of the added one. Each exchange moves the point
// away from the origin, so no basis recurs.
#include "shapes/nearest_common_point.h"

namespace gphys {

Vec3 foot_on(const Plane& plane) { return plane.normal * (plane.distance / length_squared(plane.normal)); }

bool foot_on(const Plane& a, const Plane& b, Vec3& foot) {
    const double gram = length_squared(cross(a.normal, b.normal));
    if (gram == 0) return false;
    // u a + v b such that both planes' equations hold.
    const double aa = length_squared(a.normal), bb = length_squared(b.normal), ab = dot(a.normal, b.normal);
    const double u = (a.distance * bb - b.distance * ab) / gram, v = (b.distance * aa - a.distance * ab) / gram;
    foot = a.normal * u + b.normal * v;
    return true;
}

namespace {

bool foot_on(const Plane& a, const Plane& b, const Plane& c, Vec3& foot) {
    const Vec3 bc = cross(b.normal, c.normal), ca = cross(c.normal, a.normal), ab = cross(a.normal, b.normal);
    const double volume = dot(a.normal, bc);
    if (volume == 0) return false;
    foot = (bc * a.distance + ca * b.distance + ab * c.distance) / volume;
    return true;
}

class Search {
public:
    Search(const Plane* halfspaces, int count) : halfspaces_(halfspaces), count_(count) {
        for (int i = 0; i < count; ++i) size_[i] = length(halfspaces[i].normal);
    }

    CommonPoint run() {
        // Most problems need two to five exchanges. The limit ends cycles that rounding may cause.
        for (int exchange = 0; exchange < 4 * count_; ++exchange) {
            const int worst = furthest_behind();
            if (worst < 0) return result(CommonPoint::Outcome::found);
            if (!exchange_for(worst)) {
                CommonPoint none = result(CommonPoint::Outcome::none);
                none.planes[none.plane_count++] = worst;
                return none;
            }
        }
        return result(CommonPoint::Outcome::unsure);
    }

private:
    struct Basis {
        int count = 0;
        int plane[3] = {};
    };
    /// The distance by which a half-space excludes a point, minus a tolerance for rounding: about 2^-50 of the
    /// coordinates, and more where planes intersect at small angles.
    double depth(int i, Vec3 point) const {
        const Plane& plane = halfspaces_[i];
        return (plane.distance - dot(plane.normal, point)) / size_[i] - 0x1p-44 * length(point);
    }
    int furthest_behind() const {
        int worst = -1;
        double most = 0;
        for (int i = 0; i < count_; ++i) {
            const double d = depth(i, point_);
            if (d > most) {
                most = d;
                worst = i;
            }
        }
        return worst;
    }
    /// The nearest point of the basis and another half-space, which lies on the plane of the latter.
    bool exchange_for(int other) {
        Basis next;
        double least = infinity;
        for (int subset = 0; subset < 1 << basis_.count; ++subset) {
            if (subset == 7) continue;  // four planes
            Basis own{1, {other, 0, 0}};
            for (int i = 0; i < basis_.count; ++i) {
                if (subset >> i & 1) own.plane[own.count++] = basis_.plane[i];
            }
            Vec3 foot;
            if (!foot_on_all(own, foot) || length_squared(foot) >= least) continue;
            bool common = true;
            for (int i = 0; i < basis_.count && common; ++i) {
                common = (subset >> i & 1) != 0 || depth(basis_.plane[i], foot) <= 0;
            }
            if (!common) continue;
            least = length_squared(foot);
            point_ = foot;
            next = own;
        }
        if (least == infinity) return false;
        basis_ = next;
        return true;
    }
    bool foot_on_all(const Basis& basis, Vec3& foot) const {
        const Plane& a = halfspaces_[basis.plane[0]];
        if (basis.count == 3) return foot_on(a, halfspaces_[basis.plane[1]], halfspaces_[basis.plane[2]], foot);
        if (basis.count == 2) return gphys::foot_on(a, halfspaces_[basis.plane[1]], foot);
        foot = gphys::foot_on(a);
        return true;
    }
    CommonPoint result(CommonPoint::Outcome outcome) const {
        CommonPoint common{outcome, point_, basis_.count, {}};
        std::copy(basis_.plane, basis_.plane + basis_.count, common.planes);
        return common;
    }

    const Plane* halfspaces_;
    int count_;
    double size_[12];
    Basis basis_;
    Vec3 point_;
};

}  // namespace

CommonPoint nearest_common_point(const Plane* halfspaces, int count) { return Search(halfspaces, count).run(); }

}  // namespace gphys
