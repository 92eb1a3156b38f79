// Ropes and cloth that are inside a solid: placed there, or caught by a model that jumped.
//
// Moving all particles to the surface at once, each along its minimum translation, would tear apart what links hold
// together, and the links would throw them about. A body with constraints leaves at a bounded speed instead, and by
// corrections of positions alone. At the end of a substep each particle in a solid moves towards the surface by at most
// `leaving_speed` times the substep. Then all links get their lengths back, weighted by the masses of the particles.
// Velocities do not change, so leaving creates no kinetic energy, except from the remaining strain. (Separate
// correction of positions and velocities: Guendelman, Bridson & Fedkiw 2003; a bound for the speed of separation is
// common in engines.) During the substeps a contact plane at its present place keeps each particle from going deeper,
// so a particle slightly below a floor does not fall through.
//
// The depth in a convex solid is a concave function, and so is its sum over all particles. Such a sum has no local
// minimum inside the solid, so no particles are trapped. It may have a maximum at which the directions contradict each
// other, such as the middle of a ball for a rope across it; then all particles move in one direction.
#include "solver/contact/leave_solids.h"
#include "solver/cloth/cloth_chains.h"
#include "solver/contact/collision_memory.h"
#include "solver/quads.h"

namespace gphys {
namespace {

/// The directions in which particles leave solids.
class LeavingDirections {
public:
    explicit LeavingDirections(double most) : most_(most) {}

    void add(Vec3 normal) {
        sum_ += normal;
        ++count_;
    }
    bool any() const { return count_ > 0; }
    /// The displacement of a particle. Call when all normals are added.
    Vec3 displacement(Vec3 normal, double depth) const {
        // A unit vector along no axis of an upright model.
        constexpr Vec3 aside{0.48, 0.6, 0.64};
        constexpr double agreed = 0.25;
        const Vec3 mean = sum_ / count_;
        const double agreement = length(mean), contradiction = std::max(0.0, 1 - agreement / agreed);
        const Vec3 common =
            mean / std::max(agreement, agreed) + aside * (dot(aside, mean) < 0 ? -contradiction : contradiction);
        const Vec3 direction = normal + common * (1 - agreement);
        const double size = length(direction);
        return (size > 0 ? direction / size : normal) * std::min(depth, most_);
    }

private:
    double most_;
    Vec3 sum_;
    uint32_t count_ = 0;
};

/// The links would move a few penetrating particles back, because friction holds the particles around them. Where it
/// strains no link much, they stay at their targets instead, and later substeps move their neighbours.
void keep_targets(Body& body) {
    constexpr double much = 0.02;
    Cloth& cloth = body.cloth;
    ClothContacts& contacts = body.cloth.contacts;
    const auto swap_with_target = [&](ClothContact& n) {
        float* const at = &cloth.state.at[4 * size_t{n.particle}];
        const Vec3 target = n.target;
        n.target = get(at);
        put(at, target);
        n.is_at_target = !n.is_at_target;
    };
    // Clusters leave as wholes, if no joints would open.
    for (ClothContact& n : contacts.candidates) {
        if (n.depth > 0 && (body.plan.joined || !cloth.clusters.has(n.particle))) swap_with_target(n);
    }
    for (uint32_t slot = 0; slot < body.constraints.ids.slots(); ++slot) {
        const DistanceConstraint& link = body.constraints.by_slot[slot];
        if (!body.constraints.ids.live(slot) || link.compliance > 0) continue;
        const float *a = &cloth.state.at[4 * size_t{link.a}], *b = &cloth.state.at[4 * size_t{link.b}];
        const double stretch = distance(get(a), get(b)) - link.rest;
        if ((link.limit ? stretch : std::fabs(stretch)) <= much * link.rest) continue;
        for (const uint32_t p : {link.a, link.b}) {
            const uint32_t place = contacts.candidate_of[p];
            if (place != ClothContacts::none && contacts.candidates[place].is_at_target) {
                swap_with_target(contacts.candidates[place]);
            }
        }
    }
    for (ClothContact& n : contacts.candidates) n.is_at_target = false;
}

/// At most a fraction of a link, so that links rotate little.
double within_links(double distance, double link_length) {
    return link_length > 0 ? std::min(distance, link_length / 4) : distance;
}

double average_link(const Plan& plan) {
    double sum = 0;
    for (const double rest : plan.rest) sum += rest;
    return plan.rest.empty() ? 0 : sum / static_cast<double>(plan.rest.size());
}

}  // namespace

bool begin_leaving(Body& body, const CollisionContext& around) {
    const Collider& collider = around.memory->collider.emplace(
        around, body, swept_box(body, body.particles.position, body.particles.position, 0));
    LeavingDirections directions(within_links(collider.most_push(), average_link(body.plan)));
    body.history.start = body.particles.position;
    // Calls visit(particle, normal, depth).
    const auto each_within = [&](auto&& visit) {
        for (uint32_t p = 0; p < body.particles.size(); ++p) {
            if (body.particles.pinned(p) || !body.contacts.held[p]) continue;
            const Vec3 out = collider.minimum_translation(
                body, p,
                body.contacts.points[size_t{p} * contact_points_per_particle + body.contacts.held[p] - 1].model);
            const double depth = length(out);
            if (depth > 0) visit(p, out / depth, depth);
        }
    };
    each_within([&](uint32_t, Vec3 normal, double) { directions.add(normal); });
    each_within([&](uint32_t p, Vec3 normal, double depth) {
        body.particles.position[p] += directions.displacement(normal, depth);
    });
    return directions.any();
}

void end_leaving(Body& body, const CollisionContext& around, bool lengths_found) {
    if (!lengths_found) {
        body.particles.position = body.history.start;
        return;
    }
    // Particles at the border of the range may have been pushed across it.
    for (uint32_t p = 0; p < body.particles.size(); ++p)
        keep_in_range(body.particles.position[p], body.particles.velocity[p], body.history.start[p]);
    if (!collides(body, around)) return;
    // Particles that links have moved stop at models.
    const Collider& collider =
        around.memory->collider.emplace(around, body, swept_box(body, body.history.start, body.particles.position, 0));
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        if (body.particles.pinned(p) || (body.contacts.penetrating && body.contacts.held[p])) continue;
        const Vec3 displacement = body.particles.position[p] - body.history.start[p];
        Impact impact;
        if (!collider.sweep(p, body.history.start[p], displacement, around.end, impact)) continue;
        const double t = impact.inside ? 0 : collider.stop_short(body, p, body.history.start[p], displacement, impact);
        body.particles.position[p] = body.history.start[p] + displacement * t;
    }
}

void leave_solids(Body& body, double h) {
    // One sweep would leave some hundredths of the displacements as strain.
    constexpr int sweeps = 2;
    Cloth& cloth = body.cloth;
    ClothContacts& contacts = body.cloth.contacts;
    LeavingDirections directions(within_links(leaving_speed * h, body.cloth.batches.link_length));
    const auto each_penetrating = [&](auto&& visit) {
        for (ClothContact& n : contacts.candidates) {
            if (n.depth > 0) visit(n, &cloth.state.at[4 * size_t{n.particle}], n.planes[n.deepest_plane].normal);
        }
    };
    each_penetrating([&](ClothContact&, float*, Vec3 normal) { directions.add(normal); });
    if (!directions.any()) return;
    each_penetrating([&](ClothContact& n, float* at, Vec3 normal) {
        n.target = get(at) + directions.displacement(normal, n.depth);
        put(at, n.target);
    });
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        project_links(cloth.batches, cloth.reach, cloth.state, cloth.shares.team);
        if (!cloth.clusters.empty()) project_clusters(cloth.clusters, cloth.state);
    }
    keep_targets(body);
    for (ClothContact& n : contacts.candidates) {
        if (n.depth == 0) push_out_of_planes(contacts, cloth.state, n.particle);
    }
    // The contact planes follow these particles.
    each_penetrating([&](ClothContact& n, float* at, Vec3 normal) {
        ContactPlane& deepest = n.planes[n.deepest_plane];
        deepest.offset = std::min(deepest.offset + n.depth, dot(normal, get(at)));
        for (uint32_t i = 0; i < n.plane_count; ++i) {
            ContactPlane& plane = n.planes[i];
            if (n.penetrated_planes >> i & 1) plane.offset = std::min(plane.offset, dot(plane.normal, get(at)));
        }
    });
}

}  // namespace gphys
