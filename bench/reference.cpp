// The obvious loops in double precision that say which answers are right.
#include <algorithm>
#include <cmath>
#include <limits>

#include "implementation.h"

namespace bench {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct V {
    double x, y, z;
};
V v(gphys_vec3 a) { return {a.x, a.y, a.z}; }
V operator-(V a, V b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(V a, V b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
V cross(V a, V b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

/// a turned by the inverse of q.
V turn_back(gphys_quat q, V a) {
    const double s = 1 / (double(q.x) * q.x + double(q.y) * q.y + double(q.z) * q.z + double(q.w) * q.w);
    const V u{-q.x, -q.y, -q.z};
    const V c = cross(u, a);
    const double w = q.w, uu = dot(u, u), ua = dot(u, a);
    const auto component = [&](double ui, double ai, double ci) {
        return s * (2 * ua * ui + (w * w - uu) * ai + 2 * w * ci);
    };
    return {component(u.x, a.x, c.x), component(u.y, a.y, c.y), component(u.z, a.z, c.z)};
}

double ray_box(V origin, V direction, double t_max, const gphys_obb& box) {
    const V o = turn_back(box.rotation, origin - v(box.center)), d = turn_back(box.rotation, direction);
    const V h = v(box.half_extents);
    double t_near = 0, t_far = t_max;
    const auto slab = [&](double origin, double direction, double half) {
        if (direction == 0) {
            if (std::fabs(origin) > half) t_far = -1;
            return;
        }
        const double a = (-half - origin) / direction, b = (half - origin) / direction;
        t_near = std::max(t_near, std::min(a, b));
        t_far = std::min(t_far, std::max(a, b));
    };
    slab(o.x, d.x, h.x);
    slab(o.y, d.y, h.y);
    slab(o.z, d.z, h.z);
    return t_near <= t_far ? t_near : infinity;
}

double distance(V point, const gphys_obb& box) {
    const V local = turn_back(box.rotation, point - v(box.center)), h = v(box.half_extents);
    const V out{std::max(std::fabs(local.x) - h.x, 0.0), std::max(std::fabs(local.y) - h.y, 0.0),
                std::max(std::fabs(local.z) - h.z, 0.0)};
    return std::sqrt(dot(out, out));
}

/// The distance to a box is a convex function of the way: its least is found by thirds, the contact by halves.
double sweep_box(const Sweep& sweep, const gphys_obb& box) {
    const V from = v(sweep.sphere.center), way = v(sweep.displacement), h = v(box.half_extents);
    const double radius = sweep.sphere.radius, apart = std::sqrt(dot(from - v(box.center), from - v(box.center)));
    if (apart > radius + std::sqrt(dot(way, way)) + std::sqrt(dot(h, h))) return infinity;
    const auto gap = [&](double t) {
        return distance({from.x + t * way.x, from.y + t * way.y, from.z + t * way.z}, box) - radius;
    };
    if (gap(0) <= 0) return 0;
    double low = 0, high = 1;  // of where it is least
    for (int i = 0; i < 100; ++i) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        (gap(a) <= gap(b) ? high : low) = gap(a) <= gap(b) ? b : a;
    }
    if (gap(low) > 0) return infinity;
    double outside = 0, touching = low;
    for (int i = 0; i < 60; ++i) {
        const double middle = (outside + touching) / 2;
        (gap(middle) > 0 ? outside : touching) = middle;
    }
    return touching;
}

double ray_sphere(const gphys_ray& ray, const gphys_sphere& sphere) {
    const V d = v(ray.direction), to_center = v(sphere.center) - v(ray.origin);
    const double dd = dot(d, d), b = dot(to_center, d) / dd;
    const V off{to_center.x - b * d.x, to_center.y - b * d.y, to_center.z - b * d.z};
    const double k = double(sphere.radius) * sphere.radius - dot(off, off);
    if (k < 0) return infinity;
    const double q = std::sqrt(k / dd);
    const double t = b - q < 0 && b + q >= 0 ? 0 : b - q;
    return t >= 0 && t <= ray.t_max ? t : infinity;
}

double ray_triangle(V o, V d, double t_max, V a, V b, V c) {
    const V e1 = b - a, e2 = c - a, p = cross(d, e2), s = o - a, q = cross(s, e1);
    const double det = dot(e1, p);
    if (det == 0) return infinity;
    const double u = dot(s, p) / det, w = dot(d, q) / det, t = dot(e2, q) / det;
    return u >= 0 && w >= 0 && u + w <= 1 && t >= 0 && t <= t_max ? t : infinity;
}

double ray_mesh(V o, V d, double t_max, const Triangles& mesh, uint32_t& triangle) {
    double best = infinity;
    for (uint32_t i = 0; i < mesh.count(); ++i) {
        const V a = v(mesh.vertices[mesh.indices[3 * i]]), b = v(mesh.vertices[mesh.indices[3 * i + 1]]),
                c = v(mesh.vertices[mesh.indices[3 * i + 2]]);
        const double t = ray_triangle(o, d, t_max, a, b, c);
        if (t < best) {
            best = t;
            triangle = i;
        }
    }
    return best;
}

template <class Object, class Query, class Cast>
Answer first_of(const std::vector<Object>& objects, const Query& query, Cast cast) {
    double best = infinity;
    uint32_t object = no_object;
    for (uint32_t i = 0; i < objects.size(); ++i) {
        const double t = cast(query, objects[i]);
        if (t < best) {
            best = t;
            object = i;
        }
    }
    return {static_cast<float>(best), object};
}

/// Of a mesh that lies within 1.2 of its origin.
double ray_placed_mesh(const gphys_ray& r, const Triangles& mesh, const gphys_transform& t, gphys_vec3 scale) {
    const double x = double{t.scale} * scale.x, y = double{t.scale} * scale.y, z = double{t.scale} * scale.z;
    const auto scaled = [&](V a) { return V{a.x / x, a.y / y, a.z / z}; };
    const V o = scaled(turn_back(t.rotation, v(r.origin) - v(t.position)));
    const V d = scaled(turn_back(t.rotation, v(r.direction)));
    const double along = -dot(o, d) / dot(d, d);
    const V nearest{o.x + along * d.x, o.y + along * d.y, o.z + along * d.z};
    uint32_t triangle = 0;
    return dot(nearest, nearest) > 1.44 ? infinity : ray_mesh(o, d, r.t_max, mesh, triangle);
}

}  // namespace

Answer reference(const std::vector<gphys_obb>& boxes, const gphys_ray& ray) {
    return first_of(boxes, ray, [](const gphys_ray& r, const gphys_obb& box) {
        return ray_box(v(r.origin), v(r.direction), r.t_max, box);
    });
}

Answer reference(const std::vector<gphys_obb>& boxes, const gphys_segment& segment) {
    return first_of(boxes, segment, [](const gphys_segment& s, const gphys_obb& box) {
        return ray_box(v(s.a), v(s.b) - v(s.a), 1, box);
    });
}

Answer reference(const std::vector<gphys_obb>& boxes, const Sweep& sweep) { return first_of(boxes, sweep, sweep_box); }

/// The least of the distances to the edges, and to the plane where the foot of the point is inside all edges.
Answer reference(const Triangles& mesh, const gphys_vec3& point) {
    double best = infinity;
    uint32_t triangle = no_object;
    for (uint32_t i = 0; i < mesh.count(); ++i) {
        V corner[3];
        for (int k = 0; k < 3; ++k) corner[k] = v(mesh.vertices[mesh.indices[3 * i + k]]) - v(point);
        const V normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
        double squared = infinity;
        bool inside = true;
        for (int k = 0; k < 3; ++k) {
            const V a = corner[k], along = corner[(k + 1) % 3] - a;
            const double t = std::clamp(-dot(a, along) / dot(along, along), 0.0, 1.0);
            const V q{a.x + t * along.x, a.y + t * along.y, a.z + t * along.z};
            squared = std::min(squared, dot(q, q));
            inside = inside && dot(normal, cross(a, corner[(k + 1) % 3])) >= 0;
        }
        const double height = dot(normal, corner[0]);
        if (inside) squared = std::min(squared, height * height / dot(normal, normal));
        if (squared < best) {
            best = squared;
            triangle = i;
        }
    }
    return {static_cast<float>(std::sqrt(best)), triangle};
}

Answer reference(const std::vector<gphys_obb>& boxes, const gphys_vec3& point) {
    return first_of(boxes, point, [](const gphys_vec3& p, const gphys_obb& box) { return distance(v(p), box); });
}

Answer reference(const std::vector<gphys_vec3>& points, const gphys_vec3& point) {
    return first_of(points, point, [](const gphys_vec3& p, const gphys_vec3& other) {
        const V apart = v(p) - v(other);
        return std::sqrt(dot(apart, apart));
    });
}

Answer reference(const std::vector<gphys_sphere>& spheres, const gphys_ray& ray) {
    return first_of(spheres, ray, ray_sphere);
}

Answer reference(const Triangles& mesh, const gphys_ray& ray) {
    uint32_t triangle = no_object;
    const double t = ray_mesh(v(ray.origin), v(ray.direction), ray.t_max, mesh, triangle);
    return {static_cast<float>(t), triangle};
}

Answer reference(const Triangles& mesh, const std::vector<gphys_transform>& placements, const gphys_ray& ray) {
    return first_of(placements, ray, [&](const gphys_ray& r, const gphys_transform& t) {
        return ray_placed_mesh(r, mesh, t, {1, 1, 1});
    });
}

Answer reference(const Triangles& mesh, const std::vector<Stretched>& placements, const gphys_ray& ray) {
    return first_of(placements, ray,
                    [&](const gphys_ray& r, const Stretched& s) { return ray_placed_mesh(r, mesh, s.place, s.scale); });
}

}  // namespace bench
