// Ropes and cloth that are inside a solid: placed there, or caught by a model that jumped.
//
// Moving all particles to the surface at once, each along its minimum translation, would tear apart what links hold
// together, and the links would throw them about. A body with constraints leaves at a bounded speed instead, and by
// corrections of positions alone. At the end of a substep each particle in a solid moves towards the surface by at most
// `leaving_speed` times the substep. Then all links get their lengths back, weighted by the masses of the particles.
// Velocities do not change, so leaving creates no kinetic energy, except from the remaining strain. (Separate
// correction of positions and velocities: Guendelman, Bridson & Fedkiw 2003; a bound for the speed of separation is
// common in engines.) During the substeps the solid holds particles where they are. Nothing goes deeper, so a particle
// slightly below a floor does not fall through.
//
// The depth in a convex solid is a concave function, and so is its sum over all particles. So they have no local
// minimum inside, in which particles would be trapped, only maxima, such as the middle of a ball for a rope across it.
// If the directions contradict each other, all particles move aside together.
#include "solver/contact/leave_solids.h"
#include "solver/cloth/cloth_chains.h"
#include "solver/contact/collision.h"
#include "solver/quads.h"

namespace gphys {
namespace {

/// Directions out of solids, of all particles that are in one.
class WaysOut {
public:
    explicit WaysOut(double most) : most_(most) {}

    void add(Vec3 normal) {
        sum_ += normal;
        ++count_;
    }
    bool any() const { return count_ > 0; }
    /// Once all are added: the displacement of a particle.
    Vec3 way(Vec3 normal, double depth) const {
        // A unit vector along no axis of an upright model.
        constexpr Vec3 aside{0.48, 0.6, 0.64};
        constexpr double agreed = 0.25;
        const Vec3 mean = sum_ / count_;
        const double agreement = length(mean), alone = std::max(0.0, 1 - agreement / agreed);
        const Vec3 together = mean / std::max(agreement, agreed) + aside * (dot(aside, mean) < 0 ? -alone : alone);
        const Vec3 way = normal + together * (1 - agreement);
        const double size = length(way);
        return (size > 0 ? way / size : normal) * std::min(depth, most_);
    }

private:
    double most_;
    Vec3 sum_;
    uint32_t count_ = 0;
};

/// Friction around a few sunk particles would pull them back again and again. Where that strains no link much, the
/// particles stay at their aims, and pull along their neighbours.
void keep_aims(Body& body) {
    constexpr double much = 0.02;
    Cloth& cloth = body.cloth;
    ClothContacts& contacts = body.cloth.contacts;
    const auto swap_with_aim = [&](ClothContact& n) {
        float* const at = &cloth.state.at[4 * size_t{n.particle}];
        const Vec3 aim = n.aim;
        n.aim = get(at);
        put(at, aim);
        n.aims = !n.aims;
    };
    for (ClothContact& n : contacts.candidates) {
        if (n.depth > 0) swap_with_aim(n);
    }
    for (uint32_t slot = 0; slot < body.constraints.ids.slots(); ++slot) {
        const DistanceConstraint& link = body.constraints.by_slot[slot];
        if (!body.constraints.ids.live(slot) || link.compliance > 0) continue;
        const float *a = &cloth.state.at[4 * size_t{link.a}], *b = &cloth.state.at[4 * size_t{link.b}];
        const double stretch = distance(get(a), get(b)) - link.rest;
        if ((link.limit ? stretch : std::fabs(stretch)) <= much * link.rest) continue;
        for (const uint32_t p : {link.a, link.b}) {
            const uint32_t place = contacts.candidate_of[p];
            if (place != ClothContacts::none && contacts.candidates[place].aims) {
                swap_with_aim(contacts.candidates[place]);
            }
        }
    }
    for (ClothContact& n : contacts.candidates) n.aims = false;
}

/// At most a fraction of a link, so that links turn little.
double within_links(double way, double link_length) { return link_length > 0 ? std::min(way, link_length / 4) : way; }

double average_link(const Plan& plan) {
    double sum = 0;
    for (const double rest : plan.rest) sum += rest;
    return plan.rest.empty() ? 0 : sum / static_cast<double>(plan.rest.size());
}

}  // namespace

bool begin_leaving(Body& body, const CollisionContext& around) {
    const Collider collider(around, body, swept_box(body, body.particles.position, body.particles.position, 0));
    WaysOut ways(within_links(collider.most_push(), average_link(body.plan)));
    body.history.start = body.particles.position;
    // Calls visit(particle, normal, depth).
    const auto each_within = [&](auto&& visit) {
        for (uint32_t p = 0; p < body.particles.size(); ++p) {
            if (body.particles.pinned(p) || !body.contacts.held[p]) continue;
            const Vec3 out = collider.way_out(
                body, p,
                body.contacts.points[size_t{p} * contact_points_per_particle + body.contacts.held[p] - 1].model);
            const double depth = length(out);
            if (depth > 0) visit(p, out / depth, depth);
        }
    };
    each_within([&](uint32_t, Vec3 normal, double) { ways.add(normal); });
    each_within([&](uint32_t p, Vec3 normal, double depth) { body.particles.position[p] += ways.way(normal, depth); });
    return ways.any();
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
    // Particles that links have moved stop at models in their way.
    const Collider collider(around, body, swept_box(body, body.history.start, body.particles.position, 0));
    for (uint32_t p = 0; p < body.particles.size(); ++p) {
        if (body.particles.pinned(p) || (body.contacts.sunk && body.contacts.held[p])) continue;
        const Vec3 way = body.particles.position[p] - body.history.start[p];
        Impact impact;
        if (!collider.sweep(p, body.history.start[p], way, around.end, impact)) continue;
        const double t = impact.inside ? 0 : collider.stop_short(body, p, body.history.start[p], way, impact);
        body.particles.position[p] = body.history.start[p] + way * t;
    }
}

void leave_solids(Body& body, double h) {
    // One sweep would leave some hundredths of the displacements as strain.
    constexpr int sweeps = 2;
    Cloth& cloth = body.cloth;
    ClothContacts& contacts = body.cloth.contacts;
    WaysOut ways(within_links(leaving_speed * h, body.cloth.batches.link_length));
    const auto each_sunk = [&](auto&& visit) {
        for (ClothContact& n : contacts.candidates) {
            if (n.depth > 0) visit(n, &cloth.state.at[4 * size_t{n.particle}], n.planes[n.sunk_most].normal);
        }
    };
    each_sunk([&](ClothContact&, float*, Vec3 normal) { ways.add(normal); });
    if (!ways.any()) return;
    each_sunk([&](ClothContact& n, float* at, Vec3 normal) {
        n.aim = get(at) + ways.way(normal, n.depth);
        put(at, n.aim);
    });
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        project_links(cloth.batches, cloth.reach, cloth.state, cloth.shares.team);
        if (!cloth.clusters.empty()) project_clusters(cloth.clusters, cloth.state);
    }
    keep_aims(body);
    for (ClothContact& n : contacts.candidates) {
        if (n.depth == 0) stay_outside(contacts, cloth.state, n.particle);
    }
    // The contact planes follow these particles.
    each_sunk([&](ClothContact& n, float* at, Vec3 normal) {
        ContactPlane& deepest = n.planes[n.sunk_most];
        deepest.offset = std::min(deepest.offset + n.depth, dot(normal, get(at)));
        for (uint32_t i = 0; i < n.plane_count; ++i) {
            ContactPlane& plane = n.planes[i];
            if (n.sunk_planes >> i & 1) plane.offset = std::min(plane.offset, dot(plane.normal, get(at)));
        }
    });
}

}  // namespace gphys
