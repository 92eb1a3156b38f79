// The volume constraint of cloth: its value and gradient, and one Newton step (volume.h).
#include "solver/cloth/volume.h"
#include "foundation/status.h"
#include "solver/body.h"
#include "solver/quads.h"
#include "solver/state.h"

namespace gphys {
namespace {

/// The sum of a . (b x c) over the triangles; at(p) is a position.
template <class At>
double six_volumes(const Body& body, At&& at) {
    double sum = 0;
    for (size_t i = 0; i < body.cloth.triangles.size(); i += 3) {
        sum +=
            dot(at(body.cloth.triangles[i]), cross(at(body.cloth.triangles[i + 1]), at(body.cloth.triangles[i + 2])));
    }
    return sum;
}

void add(float* to, Vec3 v) {
    for (int k = 0; k < 3; ++k) to[k] = static_cast<float>(to[k] + v[k]);
}

void find_gradient(Body& body) {
    Vector<Vec3>& gradient = body.cloth.volume.gradient;
    std::fill(gradient.begin(), gradient.end(), Vec3{});
    for (size_t i = 0; i < body.cloth.triangles.size(); i += 3) {
        const uint32_t* corner = &body.cloth.triangles[i];
        Vec3 at[3];
        for (int k = 0; k < 3; ++k) at[k] = get(&body.cloth.at[4 * size_t{corner[k]}]);
        for (int k = 0; k < 3; ++k) gradient[corner[k]] += cross(at[(k + 1) % 3], at[(k + 2) % 3]) / 6;
    }
}

}  // namespace

bool encloses_volume(const Body& body) {
    using Side = std::pair<uint32_t, uint32_t>;
    Vector<Side> sides(body.particles.position.get_allocator().resource());
    sides.reserve(body.cloth.triangles.size());
    for (size_t i = 0; i < body.cloth.triangles.size(); i += 3) {
        for (size_t k = 0; k < 3; ++k)
            sides.emplace_back(body.cloth.triangles[i + k], body.cloth.triangles[i + (k + 1) % 3]);
    }
    std::sort(sides.begin(), sides.end());
    if (std::adjacent_find(sides.begin(), sides.end()) != sides.end()) return false;
    return !sides.empty() && std::all_of(sides.begin(), sides.end(), [&](const Side& side) {
        return std::binary_search(sides.begin(), sides.end(), Side(side.second, side.first));
    });
}

double volume_of(const Body& body) {
    // Relative to a particle, because far from the origin the products would cancel.
    const Vec3 origin = body.particles.position[0];
    return six_volumes(body, [&](uint32_t p) { return body.particles.position[p] - origin; }) / 6;
}

double cloth_volume(const Body& body) {
    return six_volumes(body, [&](uint32_t p) { return get(&body.cloth.at[4 * size_t{p}]); }) / 6;
}

double stored_in_volume(const Body& body, double volume) {
    const double missing = body.cloth.volume.rest - volume;
    return body.cloth.volume.compliance > 0 ? missing * missing / (2 * body.cloth.volume.compliance) : 0;
}

void solve_volume(Body& body, double scale) {
    // The volume grows with the third power of lengths. For a change of more than a tenth the gradient would be too
    // inaccurate.
    constexpr double most_change = 0.1;
    Volume& volume = body.cloth.volume;
    Cloth& cloth = body.cloth;
    ClothContacts& contacts = body.cloth.contacts;
    const double now = cloth_volume(body), softness = volume.compliance * scale;
    const double most = most_change * std::max(std::fabs(now), most_change * volume.rest);
    const double wanted = std::clamp(volume.rest - now - softness * volume.given, -most, most);
    find_gradient(body);
    // Particles in contact move along their contact plane, or off it.
    const auto way = [&](uint32_t p) {
        Vec3 out = volume.gradient[p];
        if (!contacts.any_active()) return out;
        const Vec3 normal = get(&contacts.normals[4 * size_t{p}]);
        const double off = dot(out, normal) * wanted;
        return off < 0 ? out - normal * dot(out, normal) : out;
    };
    double mobility = 0;
    for (uint32_t p = 0; p < body.particles.size(); ++p)
        mobility += cloth.at[4 * size_t{p} + 3] * length_squared(way(p));
    if (mobility == 0) return;
    const double push = wanted / (mobility + softness);
    const bool is_noted = contacts.any_active() || !body.constraints.attachments.empty();
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        float* at = &cloth.at[4 * size_t{p}];
        add(at, way(p) * (push * at[3]));
        if (is_noted) add(&contacts.pulls[4 * size_t{p}], volume.gradient[p] * push);
    }
    volume.given += push;
    volume.pressure = volume.given * scale;
}

gphys_status set_volume(Body& body, double rest, double compliance) {
    if (!body.cloth.volume.held && !encloses_volume(body)) {
        return fail(GPHYS_ERROR_UNSUPPORTED, "body: its triangles do not close, or are not all turned the same way");
    }
    const double now = volume_of(body);
    if (rest < 0 && !(now > 0)) return fail(GPHYS_ERROR_UNSUPPORTED, "body: it is turned inside out");
    wake(body);
    if (!body.cloth.volume.held) body.plan.chains_current = false;
    body.cloth.volume.held = true;
    body.cloth.volume.rest = rest < 0 ? now : rest;
    body.cloth.volume.compliance = compliance;
    interrupt(body);
    return GPHYS_OK;
}

void release_volume(Body& body) {
    wake(body);
    body.cloth.volume.held = false;
    body.cloth.volume.pressure = 0;
    body.plan.chains_current = false;
    interrupt(body);
}

}  // namespace gphys
