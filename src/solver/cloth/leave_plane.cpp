// Finds flat sheets, and displaces their particles (leave_plane.h).
#include "solver/cloth/leave_plane.h"

#include "solver/body.h"
#include "solver/cloth/cloth_contacts.h"
#include "solver/quads.h"

namespace gphys {
namespace {

// A shortening that relaxation and the next substeps would not remove.
constexpr double least_displaced = 0.05;
// Of links that were placed with a wrong length. Smaller errors are those of the last step.
constexpr double least_misplaced = 0.02;
// Of the average length of a link. The displacement changes lengths by at most its square, a thousandth; half of it was
// seen to be too little where the sheet is compressed within few frames.
constexpr double displacement = 0.03, flat = 1e-4;
// Of that, where nothing is compressed yet.
constexpr double part_of_joined = 0.1;
// Folds of fewer links have sharp edges.
constexpr double links_per_fold = 6, most_folded = 0.5;
// Most cloth is not flat, and this many particles show that.
constexpr uint32_t sample_size = 16;

Vec3 place(const ClothState& state, uint32_t particle) { return get(&state.at[4 * size_t{particle}]); }

/// The unit normal of the plane of all particles, or 0 if there is none or they are on a line.
Vec3 normal_of(const ClothState& state, double most) {
    const uint32_t count = state.particles, step = std::max(1u, count / sample_size);
    const Vec3 first = place(state, 0);
    Vec3 along, across;
    for (uint32_t p = 0; p < count; p += step) {
        const Vec3 other = place(state, p) - first;
        if (length_squared(other) > length_squared(along)) along = other;
    }
    for (uint32_t p = 0; p < count; p += step) {
        const Vec3 other = cross(along, place(state, p) - first);
        if (length_squared(other) > length_squared(across)) across = other;
    }
    if (across == Vec3{}) return {};
    const Vec3 normal = normalized(across);
    for (const uint32_t stride : {step, 1u}) {
        for (uint32_t p = 0; p < count; p += stride) {
            if (std::fabs(dot(normal, place(state, p) - first)) > most) return {};
        }
    }
    return normal;
}

/// Between -1 and 1, the same for a particle on every machine.
double scattered(uint32_t particle) {
    const uint32_t word = (particle + 1) * 0x9e3779b9u;
    return static_cast<double>(word ^ word >> 16) * 0x1p-31 - 1;
}

/// A wave of period 2 and amplitude 1, of parabolas.
double wave(double phase) {
    const double part = phase - 2 * std::floor((phase + 1) / 2);
    return 4 * part * (1 - std::fabs(part));
}

/// The direction in which links are shortened most, and by how much of their length, as if by the same everywhere.
struct Compression {
    Vec3 along;
    double shortening = 0;
};

Compression compression_of(const Cloth& cloth, Vec3 normal) {
    // Least squares: the shortening of a link in the direction (x, y) is (x^2, 2 x y, y^2) . strain.
    const Vec3 x = perpendicular(normal), y = cross(normal, x);
    Mat3 products{{}, {}, {}};
    Vec3 shortenings;
    for (const KeptLinks::Link& link : cloth.relaxation.kept.links) {
        const Vec3 way = place(cloth.state, link.b) - place(cloth.state, link.a);
        const double length = gphys::length(way);
        if (link.limit || link.rest == 0 || length == 0) continue;
        const double shortening = 1 - length / link.rest;
        const double cosine = dot(way, x) / length, sine = dot(way, y) / length;
        const Vec3 row{cosine * cosine, 2 * cosine * sine, sine * sine};
        products.x += row * row.x, products.y += row * row.y, products.z += row * row.z;
        shortenings += row * shortening;
    }
    const Vec3 others = cross(products.y, products.z);
    const double determinant = dot(products.x, others);
    if (!(determinant > 0)) return {};
    const Vec3 strain = Vec3{dot(shortenings, others), dot(shortenings, cross(products.z, products.x)),
                             dot(shortenings, cross(products.x, products.y))} /
                        determinant;
    const double half = (strain.x - strain.z) / 2, radius = std::sqrt(half * half + strain.y * strain.y);
    const Vec3 along = half >= 0 ? x * (half + radius) + y * strain.y : x * strain.y + y * (radius - half);
    return {radius > 0 ? normalized(along) : x, (strain.x + strain.z) / 2 + radius};
}

/// `part`: of the random displacement. move(particle, displacement)
template <class Move>
void fold(const Cloth& cloth, double part, Move&& move) {
    const double link = cloth.batches.link_length;
    if (link == 0) return;
    const Vec3 normal = normal_of(cloth.state, flat * link);
    if (normal == Vec3{}) return;
    const Compression most = compression_of(cloth, normal);
    // The mean square slope of the folds is that with which links have their lengths.
    const double shortening = std::clamp(most.shortening, 0.0, most_folded), kept = 1 - shortening;
    const double half_fold = links_per_fold * link * kept / 2;
    const double height = half_fold * std::sqrt((1 / (kept * kept) - 1) * 3 / 16);
    for (uint32_t p = 0; p < cloth.state.particles; ++p) {
        if (cloth.state.at[4 * size_t{p} + 3] == 0) continue;
        const double folded = height * wave(dot(most.along, place(cloth.state, p)) / half_fold);
        move(p, normal * (folded + part * displacement * link * scattered(p)));
    }
}

}  // namespace

double leave_plane(Body& body, double strain, bool collides) {
    double lost = 0;
    if (strain < least_displaced) return lost;
    Cloth& cloth = body.cloth;
    fold(cloth, 1, [&](uint32_t p, Vec3 way) {
        if (body.plan.joined && !cloth.tethers.is_unit(p)) return;
        const Vec3 before = place(cloth.state, p);
        displace(cloth.state, cloth.contacts, body.targets, p, way, collides);
        const float* const force = &cloth.state.acceleration[4 * size_t{p}];
        lost += force[3] * dot(get(force), before - place(cloth.state, p));
    });
    return lost;
}

bool start_cloth(Body& body) {
    ClothState& state = body.cloth.state;
    double largest = 0, shortest = 0;
    for (const KeptLinks::Link& link : body.cloth.relaxation.kept.links) {
        const float *a = &state.at[4 * size_t{link.a}], *b = &state.at[4 * size_t{link.b}];
        if (link.rest == 0 || (a[3] == 0 && b[3] == 0)) continue;
        const double strain = distance(get(a), get(b)) / link.rest - 1;
        largest = std::max(largest, strain);
        if (!link.limit) shortest = std::min(shortest, strain);
    }
    const double strain = std::max(largest, -shortest);
    const bool shortened = !state.held.empty() && strain >= least_displaced;
    if (shortened || body.plan.joined) {
        fold(body.cloth, shortened ? 1 : part_of_joined, [&](uint32_t p, Vec3 way) {
            float* const at = &state.at[4 * size_t{p}];
            put(at, get(at) + way);
        });
    }
    return strain > least_misplaced;
}

}  // namespace gphys
