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
double six_volumes(const ClothSheet& sheet, At&& at) {
    double sum = 0;
    for (size_t i = 0; i < sheet.triangles.size(); i += 3) {
        sum += dot(at(sheet.triangles[i]), cross(at(sheet.triangles[i + 1]), at(sheet.triangles[i + 2])));
    }
    return sum;
}

void add(float* to, Vec3 v) {
    for (int k = 0; k < 3; ++k) to[k] = static_cast<float>(to[k] + v[k]);
}

void find_gradient(const ClothSheet& sheet, const ClothState& state, Vector<Vec3>& gradient) {
    std::fill(gradient.begin(), gradient.end(), Vec3{});
    for (size_t i = 0; i < sheet.triangles.size(); i += 3) {
        const uint32_t* corner = &sheet.triangles[i];
        Vec3 at[3];
        for (int k = 0; k < 3; ++k) at[k] = get(&state.at[4 * size_t{corner[k]}]);
        for (int k = 0; k < 3; ++k) gradient[corner[k]] += cross(at[(k + 1) % 3], at[(k + 2) % 3]) / 6;
    }
}

}  // namespace

bool encloses_volume(const ClothSheet& sheet) {
    using Side = std::pair<uint32_t, uint32_t>;
    Vector<Side> sides(sheet.triangles.get_allocator().resource());
    sides.reserve(sheet.triangles.size());
    for (size_t i = 0; i < sheet.triangles.size(); i += 3) {
        for (size_t k = 0; k < 3; ++k) sides.emplace_back(sheet.triangles[i + k], sheet.triangles[i + (k + 1) % 3]);
    }
    std::sort(sides.begin(), sides.end());
    if (std::adjacent_find(sides.begin(), sides.end()) != sides.end()) return false;
    return !sides.empty() && std::all_of(sides.begin(), sides.end(), [&](const Side& side) {
        return std::binary_search(sides.begin(), sides.end(), Side(side.second, side.first));
    });
}

double volume_of(const ClothSheet& sheet, const Particles& particles) {
    // Relative to a particle, because far from the origin the products would cancel.
    const Vec3 origin = particles.position[0];
    return six_volumes(sheet, [&](uint32_t p) { return particles.position[p] - origin; }) / 6;
}

double cloth_volume(const ClothSheet& sheet, const ClothState& state) {
    return six_volumes(sheet, [&](uint32_t p) { return get(&state.at[4 * size_t{p}]); }) / 6;
}

double stored_in_volume(const Volume& constraint, double volume) {
    const double missing = constraint.rest - volume;
    return constraint.compliance > 0 ? missing * missing / (2 * constraint.compliance) : 0;
}

void solve_volume(Volume& volume, const ClothSheet& sheet, ClothState& state, ChainContacts& contacts, double scale,
                  bool has_contact, bool pulls_count) {
    // The volume grows with the third power of lengths. For a change of more than a tenth the gradient would be too
    // inaccurate.
    constexpr double most_change = 0.1;
    const double now = cloth_volume(sheet, state), softness = volume.compliance * scale;
    const double most = most_change * std::max(std::fabs(now), most_change * volume.rest);
    const double error = std::clamp(volume.rest - now - softness * volume.multiplier, -most, most);
    find_gradient(sheet, state, volume.gradient);
    // Particles in contact move along their contact plane, or off it.
    const auto direction = [&](uint32_t p) {
        Vec3 out = volume.gradient[p];
        if (!has_contact) return out;
        const Vec3 normal = get(&contacts.normals[4 * size_t{p}]);
        const double off = dot(out, normal) * error;
        return off < 0 ? out - normal * dot(out, normal) : out;
    };
    double inverse_mass = 0;
    for (uint32_t p = 0; p < state.particles; ++p)
        inverse_mass += state.at[4 * size_t{p} + 3] * length_squared(direction(p));
    if (inverse_mass == 0) return;
    const double change = error / (inverse_mass + softness);
    for (uint32_t p = 0; p < state.particles; ++p) {
        float* at = &state.at[4 * size_t{p}];
        add(at, direction(p) * (change * at[3]));
        if (pulls_count) add(&contacts.pulls[4 * size_t{p}], volume.gradient[p] * change);
    }
    volume.multiplier += change;
    volume.pressure = volume.multiplier * scale;
}

gphys_status set_volume(Body& body, double rest, double compliance) {
    if (!body.cloth.volume.held && !encloses_volume(body.cloth.sheet)) {
        return fail(GPHYS_ERROR_UNSUPPORTED, "body: its triangles are not a closed surface of one orientation");
    }
    const double now = volume_of(body.cloth.sheet, body.particles);
    if (rest < 0 && !(now > 0)) return fail(GPHYS_ERROR_UNSUPPORTED, "body: its triangles face inward");
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
