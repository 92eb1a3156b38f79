// Particles of cloth that are attached to models (cloth_attachments.h).
#include "solver/cloth/cloth_attachments.h"
#include "solver/cloth/second_moments.h"
#include "solver/cloth/whole_motion.h"
#include "solver/contact/collision.h"
#include "solver/quads.h"

namespace gphys {
namespace {

Vec3 place(const ClothState& state, uint32_t particle) { return get(&state.at[4 * size_t{particle}]); }

}  // namespace

/// Attached particles move along arcs as their models rotate. Interpolating linearly between two positions on a circle
/// would bring them closer to each other.
void follow_models(const Constraints& constraints, const CollisionContext& around, ClothState& state,
                   ChainContacts& contacts) {
    if (constraints.attachments.empty()) return;
    const double way = around.way(around.end);
    gphys_model_id model = 0;
    const MovedModel* moved = nullptr;
    Transform now;
    for (const Attachment& attachment : constraints.attachments) {
        Vec3 next = attachment.begin + (attachment.end - attachment.begin) * way;
        if (attachment.model != model) {
            model = attachment.model;
            moved = find_moved(around, model);
            if (moved) now = interpolate(moved->world, around.scene->world(model), way);
        }
        if (moved && way < 1) {
            const Vec3 aside = attachment.begin - widen(moved->world).apply(attachment.local);
            next = now.apply(attachment.local) + aside * (1 - way);
        }
        put(&state.at[4 * size_t{attachment.particle}], next - state.origin, farthest_in_cloth);
    }
    for (const uint32_t p : state.held) put(&contacts.pulls[4 * size_t{p}], {});
}

void add_pull_impulses(const Constraints& constraints, const CollisionContext& around, const ClothState& state,
                       const ChainContacts& in_chains, ClothContacts& contacts, Vector<ModelImpulse>& impulses,
                       double step, double h) {
    if (!around.scene) return;
    const double to_velocity = h / (step * step);
    const auto pull = [&](uint32_t p) { return get(&in_chains.pulls[4 * size_t{p}]) * to_velocity; };
    for (const uint32_t p : state.held) contacts.add(place(state, p), pull(p));
    for (const Attachment& attachment : constraints.attachments) {
        const uint32_t p = attachment.particle;
        add_impulse(impulses, around, attachment.model, state.origin + place(state, p), pull(p) * state.average_mass);
    }
}

void add_missing_impulses(const Body& body, const CollisionContext& around, const Momentum& missing,
                          Vector<ModelImpulse>& impulses) {
    const ClothState& state = body.cloth.state;
    const ClothContacts& contacts = body.cloth.contacts;
    const auto each_holding = [&](const auto& visit) {
        for (const uint32_t p : state.held) visit(p);
        for (const uint32_t number : contacts.active) {
            if (state.held.empty()) visit(contacts.candidates[number].particle);
        }
    };
    const double count = static_cast<double>(state.held.empty() ? contacts.active.size() : state.held.size());
    Vec3 centre;
    each_holding([&](uint32_t p) { centre += place(state, p) / count; });
    SecondMoments moments;
    each_holding([&](uint32_t p) { moments.add(place(state, p) - centre, 1); });
    // On a line they take no moment about it: they count as a hundredth of their length thick, or rounding would be.
    moments.thicken(1e-4);
    const LeastForces shares(missing.linear, missing.angular - cross(centre, missing.linear), count, moments);
    const auto give = [&](uint32_t particle, gphys_model_id model) {
        const Vec3 at = place(state, particle);
        add_impulse(impulses, around, model, state.origin + at, shares.at(at - centre));
    };
    for (const Attachment& attachment : body.constraints.attachments) give(attachment.particle, attachment.model);
    for (const uint32_t number : contacts.active) {
        const ClothContact& n = contacts.candidates[number];
        if (state.held.empty()) give(n.particle, n.planes[n.active_plane].model);
    }
}

void place_attached(const Constraints& constraints, const ClothState& state, Vector<Vec3>& positions) {
    for (const Attachment& attachment : constraints.attachments) {
        float there[3];
        put(there, attachment.end - state.origin, farthest_in_cloth);
        if (get(there) == get(&state.at[4 * size_t{attachment.particle}]))
            positions[attachment.particle] = attachment.end;
    }
}

/// add_pull_impulses has counted the pulls of this substep as continuous forces, by the factor h / step^2. In an impact
/// they act by the factor next / h. `counted_` is the difference.
TautLimits::TautLimits(const Constraints& constraints, const CollisionContext& around, ChainContacts& in_chains,
                       ClothContacts& contacts, Vector<ModelImpulse>& impulses, const TimeScheme& scheme,
                       double damping)
    : constraints_(constraints),
      around_(around),
      in_chains_(in_chains),
      contacts_(contacts),
      impulses_(impulses),
      counted_(scheme.h / (scheme.step(damping) * scheme.step(damping)) - scheme.next / scheme.h) {}

void TautLimits::add_to_model(const ClothState& state, uint32_t particle, Vec3 impulse) {
    const float* at = &state.at[4 * size_t{particle}];
    if (!around_.scene || constraints_.attachments.empty() || at[3] != 0) return;
    float* pull = &in_chains_.pulls[4 * size_t{particle}];
    const Vec3 more = impulse - get(pull) * counted_;
    put(pull, {});
    contacts_.add(get(at), more);
    if (const Attachment* attachment = find_attachment(constraints_, particle))
        add_impulse(impulses_, around_, attachment->model, state.origin + get(at), more * state.average_mass);
}

bool TautLimits::apply_impacts(const Vector<LimitInCloth>& limits, ClothState& state, Vector<double>& loads) {
    // Relative to the length: ten times the rounding of positions within about a metre.
    constexpr double slack = 1e-6;
    bool any = false;
    for (const LimitInCloth& limit : limits) {
        const size_t a = 4 * size_t{limit.a}, b = 4 * size_t{limit.b};
        const double shortest = limit.rest * (1 - slack), mobility = double{state.at[a + 3]} + state.at[b + 3];
        if (distance(get(&state.start[a]), get(&state.start[b])) >= shortest || mobility == 0) continue;
        const Vec3 along = get(&state.at[b]) - get(&state.at[a]);
        const double length = gphys::length(along);
        if (length < shortest || length == 0) continue;
        any = true;
        const Vec3 apart =
            along * (dot(get(&state.velocity[b]) - get(&state.velocity[a]), along) / (length * length * mobility));
        put(&state.velocity[a], get(&state.velocity[a]) + apart * state.at[a + 3], fastest_in_cloth);
        put(&state.velocity[b], get(&state.velocity[b]) - apart * state.at[b + 3], fastest_in_cloth);
        add_to_model(state, limit.a, apart);
        add_to_model(state, limit.b, -apart);
        if (!loads.empty()) loads[limit.link] += dot(apart, along) / length * state.average_mass;
    }
    return any;
}

}  // namespace gphys
