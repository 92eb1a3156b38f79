// The convex hull of points, made by CGAL and by the library.
#pragma once

#include <CGAL/Polyhedron_3.h>
#include <CGAL/convex_hull_3.h>

#include <optional>

#include "oracle.h"

namespace test {

/// CGAL's hull, as triangles; empty if all points lie in one plane.
struct TrueHull {
    std::vector<Kernel::Plane_3> planes;
    std::vector<gphys_triangle> faces;  // one for each plane

    explicit TrueHull(const std::vector<gphys_vec3>& points) {
        std::vector<Point> exact_points;
        for (const gphys_vec3& p : points) exact_points.push_back(exact(p));
        // CGAL makes a single facet of coplanar points.
        const bool flat = [&] {
            for (size_t b = 0; b < exact_points.size(); ++b) {
                for (size_t c = b + 1; c < exact_points.size(); ++c) {
                    for (const Point& d : exact_points) {
                        if (!CGAL::coplanar(exact_points[0], exact_points[b], exact_points[c], d)) return false;
                    }
                }
            }
            return true;
        }();
        if (flat) return;
        CGAL::Object object;
        CGAL::convex_hull_3(exact_points.begin(), exact_points.end(), object);
        const auto* hull = CGAL::object_cast<CGAL::Polyhedron_3<Kernel>>(&object);
        if (!hull) return;
        for (auto facet = hull->facets_begin(); facet != hull->facets_end(); ++facet) {
            const auto side = facet->halfedge();
            const Point a = side->vertex()->point(), b = side->next()->vertex()->point(),
                        c = side->next()->next()->vertex()->point();
            planes.emplace_back(a, b, c);
            faces.push_back({as_float(a), as_float(b), as_float(c)});
        }
    }
    /// The number of faces: triangles in one plane count once.
    size_t face_count() const {
        std::vector<Kernel::Plane_3> different;
        for (const auto& plane : planes) {
            const bool known =
                std::any_of(different.begin(), different.end(), [&](const auto& d) { return d == plane; });
            if (!known) different.push_back(plane);
        }
        return different.size();
    }
    bool holds(const Point& p) const {
        return std::none_of(planes.begin(), planes.end(),
                            [&](const auto& plane) { return plane.has_on_positive_side(p); });
    }
    /// The t at which a ray enters the hull.
    std::optional<Number> entry(const gphys_ray& ray) const {
        Number in = 0, out = 0;
        bool bounded = !std::isinf(ray.t_max);
        if (bounded) out = ray.t_max;
        const Point from = exact(ray.origin);
        const Vector along = exact_vector(ray.direction);
        for (const auto& plane : planes) {
            const Vector n = plane.orthogonal_vector();
            const Number height = n * (from - plane.point()), climb = n * along;
            if (climb == 0) {
                if (height > 0) return {};
                continue;
            }
            const Number t = -height / climb;
            if (climb < 0) {
                if (t > in) in = t;
            } else if (!bounded || t < out) {
                out = t;
                bounded = true;
            }
        }
        if (bounded && in > out) return {};
        return in;
    }

private:
    static gphys_vec3 as_float(const Point& p) {
        const auto of = [](const Number& coordinate) { return static_cast<float>(CGAL::to_double(coordinate)); };
        return {of(p.x()), of(p.y()), of(p.z())};
    }
};

class MadeHull {
public:
    using Target = gphys_mesh;
    explicit MadeHull(const std::vector<gphys_vec3>& points) {
        status = gphys_mesh_create_hull(nullptr, &points[0].x, sizeof points[0], static_cast<uint32_t>(points.size()),
                                        &mesh_);
    }
    ~MadeHull() { gphys_mesh_destroy(mesh_); }
    MadeHull(const MadeHull&) = delete;
    const gphys_mesh* operator*() const { return mesh_; }
    uint32_t faces() const {
        uint32_t total = 0;
        gphys_mesh_get_hull_planes(mesh_, nullptr, 0, &total);
        return total;
    }
    gphys_status status;

private:
    gphys_mesh* mesh_ = nullptr;
};

inline std::vector<gphys_vec3> points(Cases& c, uint32_t most) {
    std::vector<gphys_vec3> all;
    for (uint32_t i = 4 + c.random.index(most - 3); i > 0; --i) all.push_back(c.point());
    return all;
}

}  // namespace test
