// Newton's iterations of ropes with contacts, side by side (rope_contact_lanes.h).
#include "solver/rope/rope_contact_lanes.h"

#include <limits>

#include "solver/rope/rope.h"
#include "solver/rope/stretched_ropes.h"
#include "solver/state_range.h"

namespace gphys {
namespace {

// More than for links alone, because the iterations also determine which contacts are active and which of them stick.
constexpr int most_iterations = 16;

template <int lanes>
struct LaneMemory;
template <>
struct LaneMemory<1> {
    static RopeNode<1>* nodes(RopeScratch& scratch) { return scratch.one.data(); }
    static RopeContactTerm<1>* terms(RopeScratch& scratch) { return scratch.one_terms.data(); }
    static const RopeKernelsOf<1>& kernels() { return rope_kernels(chosen_isa()).one; }
};
template <>
struct LaneMemory<8> {
    static RopeNode<8>* nodes(RopeScratch& scratch) { return scratch.eight.data(); }
    static RopeContactTerm<8>* terms(RopeScratch& scratch) { return scratch.eight_terms.data(); }
    static const RopeKernelsOf<8>& kernels() { return rope_kernels(chosen_isa()).eight; }
};

template <int lanes>
void clear(RopeContactTerm<lanes>& term, uint32_t lane) {
    // A term that is not 0 has a stiffness.
    if (term.stiffness[0][lane] + term.stiffness[3][lane] + term.stiffness[5][lane] == 0) return;
    for (double(&value)[lanes] : term.stiffness) value[lane] = 0;
    set3(term.force, lane, {});
}

/// Call after `present` is set.
template <int lanes>
void set_target(RopeNode<lanes>& node, uint32_t lane, double target) {
    const bool present = node.present[lane] != 0;
    node.target[lane] = target;
    node.inverse_target[lane] = present ? 1 / std::max(target, rope_shortest) : 1;
    node.lateral_tolerance[lane] =
        present ? 2 * rope_tolerance * target * target : std::numeric_limits<double>::infinity();
}

/// The particles of the only chain, in order, and the number of its links.
const uint32_t* particles_of(const Plan& plan) { return &plan.particles[plan.chains[0].first_particle]; }
uint32_t links_of(const Plan& plan) { return plan.chains[0].link_count; }

}  // namespace

template <int lanes>
RopeContactLanes<lanes>::RopeContactLanes(RopeScratch& scratch, uint32_t longest)
    : scratch_(scratch),
      kernels_(LaneMemory<lanes>::kernels()),
      nodes_(LaneMemory<lanes>::nodes(scratch)),
      terms_(LaneMemory<lanes>::terms(scratch)),
      longest_(longest) {}

template <int lanes>
uint32_t RopeContactLanes<lanes>::free_lane() const {
    uint32_t lane = 0;
    while (lanes_[lane].rope) ++lane;
    return lane;
}

template <int lanes>
void RopeContactLanes<lanes>::add(const RopeStepper& rope) {
    const uint32_t lane = free_lane();
    lanes_[lane].rope.emplace(rope);
    lanes_[lane].solving = false;
    ++count_;
    gather_constants(lane, rope.body());
    // Lanes without a rope compute the same as the first one, so that no number is invalid.
    for (uint32_t other = 1; other < lanes && !filled_; ++other) gather_constants(other, rope.body());
    filled_ = true;
}

template <int lanes>
void RopeContactLanes<lanes>::gather_constants(uint32_t lane, Body& body) {
    const Chain& chain = body.plan.chains[0];
    const uint32_t* const particles = particles_of(body.plan);
    set_targets(body, chain);
    double inverse_mass_before = 0;
    for (uint32_t i = 0; i < longest_; ++i) {
        const bool is_there = i <= chain.link_count;
        RopeNode<lanes>& node = nodes_[i];
        const uint32_t p = particles[is_there ? i : 0];
        const double inverse_mass = is_there ? body.particles.inverse_mass[p] : 0;
        node.mass[lane] = body.particles.mass[p];
        node.free[lane] = inverse_mass > 0 ? 1 : 0;
        set3(node.position, lane, body.particles.position[p]);
        set3(node.predicted, lane, body.particles.position[p]);
        node.tension[lane] = 0;
        clear(terms_[i], lane);
        if (i > 0) {
            RopeNode<lanes>& before = nodes_[i - 1];
            const double inverse_masses = inverse_mass_before + inverse_mass;
            const bool present = is_there && inverse_masses > 0;
            before.present[lane] = present ? 1 : 0;
            set_target(before, lane, present ? body.rope.target[chain.first_link + i - 1] : 0);
            before.compliance[lane] = present ? body.plan.compliance[chain.first_link + i - 1] : 0;
            before.regularisation[lane] = present ? rope_regularisation * inverse_masses : 1;
        }
        inverse_mass_before = inverse_mass;
    }
    equations_.step_squared[lane] = equations_.inverse_step_squared[lane] = equations_.most_displacement[lane] =
        equations_.most_tension[lane] = 1;
}

/// Newton's initial guess is the previous motion, which obeyed the constraints, extrapolated.
template <int lanes>
void RopeContactLanes<lanes>::gather_prediction(uint32_t lane) {
    const RopeStepper& rope = *lanes_[lane].rope;
    Body& body = rope.body();
    const uint32_t* const particles = particles_of(body.plan);
    if (!body.constraints.attachments.empty()) set_targets(body, body.plan.chains[0]);
    const History& history = body.history;
    const double h = rope.advance(), before = history.earlier_step;
    const double extrapolation = before > 0 ? h * h / (2 * before) : 0;
    const bool has_history = before > 0 || body.contacts.has_contact;
    double longest = 0, farthest = 0, mass = 0;
    for (uint32_t i = 0; i <= links_of(body.plan); ++i) {
        RopeNode<lanes>& node = nodes_[i];
        const uint32_t p = particles[i];
        Vec3 at = body.particles.pinned(p) ? body.particles.position[p] : history.predicted[p];
        set3(node.predicted, lane, at);
        clear(terms_[i], lane);
        if (has_history && !body.particles.pinned(p)) {
            const Vec3 velocity = history.start_velocity[p];
            at = history.start[p] + velocity * h + (velocity - history.earlier_velocity[p]) * extrapolation;
        }
        set3(node.position, lane, at);
        farthest = std::max(farthest, length_squared(at - get3(node.predicted, lane)));
        mass += node.mass[lane];
        if (i == links_of(body.plan)) continue;
        const double target = body.rope.target[body.plan.chains[0].first_link + i];
        if (node.present[lane] != 0 && node.target[lane] != target) set_target(node, lane, target);
        longest = std::max(longest, node.target[lane]);
        node.tension[lane] = body.rope.tension[body.plan.chains[0].first_link + i];
    }
    const double step = rope.effective_step();
    // A straight rope that is compressed buckles by a small distance, but Newton's first correction may be a thousand
    // times as large.
    equations_.most_displacement[lane] = longest + std::sqrt(farthest);
    equations_.step_squared[lane] = step * step;
    equations_.inverse_step_squared[lane] = 1 / (step * step);
    // A million times the tension that moves the whole rope that far, so that no iteration overflows.
    equations_.most_tension[lane] =
        1e6 * mass * equations_.most_displacement[lane] * equations_.inverse_step_squared[lane];
}

template <int lanes>
void RopeContactLanes<lanes>::gather_contacts(uint32_t lane) {
    const RopeStepper& rope = *lanes_[lane].rope;
    if (!rope.contacts()) return;
    RopeContacts& contacts = *rope.contacts();
    Body& body = rope.body();
    const uint32_t* const particles = particles_of(body.plan);
    const auto stiffness = [&](uint32_t link) {
        const RopeNode<lanes>& node = nodes_[link];
        return std::max(0.0, node.tension[lane]) * equations_.step_squared[lane] * node.inverse_target[lane];
    };
    for (uint32_t i = 0; i <= links_of(body.plan); ++i) {
        const uint32_t p = particles[i];
        if (body.particles.pinned(p) || !contacts.has_contacts(p)) continue;
        body.particles.position[p] = get3(nodes_[i].position, lane);
        if (!contacts.has_active(p)) {
            clear(terms_[i], lane);
            continue;
        }
        const double mass =
            body.particles.mass[p] + (i > 0 ? stiffness(i - 1) : 0) + (i < links_of(body.plan) ? stiffness(i) : 0);
        const ContactTerm term = contacts.term(body, p, mass);
        const double matrix[] = {term.xx, term.xy, term.xz, term.yy, term.yz, term.zz};
        for (int k = 0; k < 6; ++k) terms_[i].stiffness[k][lane] = matrix[k];
        set3(terms_[i].force, lane, term.force);
    }
}

/// Advances the lane's rope to its next part. Returns false at the end of its step.
template <int lanes>
bool RopeContactLanes<lanes>::begin_part(uint32_t lane) {
    RopeStepper& rope = *lanes_[lane].rope;
    if (!rope.begin_part()) return false;
    gather_prediction(lane);
    lanes_[lane].solving = true;
    lanes_[lane].iteration = 0;
    return true;
}

template <int lanes>
RopeStepper RopeContactLanes<lanes>::move_until_one_ends() {
    for (;;) {
        for (uint32_t i = 0; i < lanes; ++i) {
            Lane& lane = lanes_[i];
            if (!lane.rope || lane.solving || begin_part(i)) continue;
            const RopeStepper ended = *lane.rope;
            lane.rope.reset();
            --count_;
            return ended;
        }
        iterate();
    }
}

template <int lanes>
void RopeContactLanes<lanes>::iterate() {
    for (uint32_t lane = 0; lane < lanes; ++lane) {
        equations_.active[lane] = lanes_[lane].solving ? 1 : 0;
        if (lanes_[lane].solving) gather_contacts(lane);
    }
    bool unconverged[lanes];
    kernels_.iterate(nodes_, terms_, longest_, equations_, unconverged);
    for (uint32_t i = 0; i < lanes; ++i) {
        Lane& lane = lanes_[i];
        if (!lane.solving) continue;
        const bool converged = update_contacts(i) && !unconverged[i];
        if (!converged && ++lane.iteration < most_iterations) continue;
        scatter(i);
        lane.solving = false;
        lane.rope->end_part(converged || is_solved(i));
    }
}

/// Returns whether the states of the contacts have converged.
template <int lanes>
bool RopeContactLanes<lanes>::update_contacts(uint32_t lane) {
    const RopeStepper& rope = *lanes_[lane].rope;
    if (!rope.contacts()) return true;
    RopeContacts& contacts = *rope.contacts();
    Body& body = rope.body();
    const uint32_t* const particles = particles_of(body.plan);
    for (uint32_t i = 0; i <= links_of(body.plan); ++i) {
        if (contacts.has_contacts(particles[i])) body.particles.position[particles[i]] = get3(nodes_[i].position, lane);
    }
    return contacts.update(body, lanes_[lane].iteration);
}

template <int lanes>
void RopeContactLanes<lanes>::scatter(uint32_t lane) const {
    Body& body = lanes_[lane].rope->body();
    const uint32_t* const particles = particles_of(body.plan);
    for (uint32_t i = 0; i <= links_of(body.plan); ++i) {
        body.particles.position[particles[i]] = get3(nodes_[i].position, lane);
        if (i == links_of(body.plan)) continue;
        const double tension = nodes_[i].tension[lane];
        body.rope.tension[body.plan.chains[0].first_link + i] = is_finite(tension) ? tension : 0;
    }
}

/// Whether the lengths of all links match their tensions closely enough.
template <int lanes>
bool RopeContactLanes<lanes>::is_solved(uint32_t lane) const {
    for (uint32_t i = 0; i < links_of(lanes_[lane].rope->body().plan); ++i) {
        const RopeNode<lanes>& node = nodes_[i];
        if (node.present[lane] == 0 || node.target[lane] == 0) continue;
        const double length = distance(get3(node.position, lane), get3(nodes_[i + 1].position, lane));
        const double residual = length - node.target[lane] - node.compliance[lane] * node.tension[lane];
        if (!(std::fabs(residual) <= rope_failure * node.target[lane])) return false;
    }
    return true;
}

template class RopeContactLanes<1>;
template class RopeContactLanes<8>;

}  // namespace gphys
