// Newton's iterations of ropes with contacts, side by side (ropes_beside_models.h).
#include "solver/rope/ropes_beside_models.h"

#include <limits>

#include "solver/rope/rope.h"
#include "solver/state_range.h"

namespace gphys {
namespace {

// The active contacts and those that friction holds must be found, too.
constexpr int most_iterations = 16;

template <int lanes>
struct LaneMemory;
template <>
struct LaneMemory<1> {
    static RopeNode<1>* nodes(RopeRoom& room) { return room.one.data(); }
    static RopePush<1>* pushes(RopeRoom& room) { return room.one_pushes.data(); }
    static const RopeKernelsOf<1>& kernels() { return rope_kernels(chosen_isa()).one; }
};
template <>
struct LaneMemory<8> {
    static RopeNode<8>* nodes(RopeRoom& room) { return room.eight.data(); }
    static RopePush<8>* pushes(RopeRoom& room) { return room.eight_pushes.data(); }
    static const RopeKernelsOf<8>& kernels() { return rope_kernels(chosen_isa()).eight; }
};

template <int lanes>
void put3(double (&to)[3][lanes], uint32_t lane, Vec3 v) {
    to[0][lane] = v.x, to[1][lane] = v.y, to[2][lane] = v.z;
}
template <int lanes>
Vec3 take3(const double (&from)[3][lanes], uint32_t lane) {
    return {from[0][lane], from[1][lane], from[2][lane]};
}

template <int lanes>
void clear(RopePush<lanes>& push, uint32_t lane) {
    // Every push has a stiffness.
    if (push.stiffness[0][lane] + push.stiffness[3][lane] + push.stiffness[5][lane] == 0) return;
    for (double(&value)[lanes] : push.stiffness) value[lane] = 0;
    put3(push.force, lane, {});
}

/// The particles of the only chain of a body, in order.
const uint32_t* particles_of(const Body& body) { return &body.plan.particles[body.plan.chains[0].first_particle]; }
uint32_t links_of(const Body& body) { return body.plan.chains[0].link_count; }

}  // namespace

template <int lanes>
RopesBesideModels<lanes>::RopesBesideModels(RopeRoom& room, uint32_t longest)
    : room_(room),
      kernels_(LaneMemory<lanes>::kernels()),
      nodes_(LaneMemory<lanes>::nodes(room)),
      pushes_(LaneMemory<lanes>::pushes(room)),
      longest_(longest) {}

template <int lanes>
uint32_t RopesBesideModels<lanes>::free_lane() const {
    uint32_t lane = 0;
    while (lanes_[lane].rope) ++lane;
    return lane;
}

template <int lanes>
void RopesBesideModels<lanes>::add(const RopeInStep& rope) {
    const uint32_t lane = free_lane();
    lanes_[lane].rope.emplace(rope);
    lanes_[lane].solving = false;
    ++count_;
    put_constants(lane, rope.body());
    // Lanes without a rope compute what the first one does, so that their numbers are valid.
    for (uint32_t other = 1; other < lanes && !filled_; ++other) {
        put_constants(other, rope.body());
    }
    filled_ = true;
}

template <int lanes>
void RopesBesideModels<lanes>::put_constants(uint32_t lane, Body& body) {
    const Chain& chain = body.plan.chains[0];
    const uint32_t* const particles = particles_of(body);
    set_targets(body, chain);
    double inverse_mass_before = 0;
    for (uint32_t i = 0; i < longest_; ++i) {
        const bool is_there = i <= chain.link_count;
        RopeNode<lanes>& node = nodes_[i];
        const uint32_t p = particles[is_there ? i : 0];
        const double inverse_mass = is_there ? body.particles.inverse_mass[p] : 0;
        node.mass[lane] = body.particles.mass[p];
        node.free[lane] = inverse_mass > 0 ? 1 : 0;
        put3(node.position, lane, body.particles.position[p]);
        put3(node.predicted, lane, body.particles.position[p]);
        node.tension[lane] = 0;
        clear(pushes_[i], lane);
        if (i > 0) {
            RopeNode<lanes>& before = nodes_[i - 1];
            const double inverse_masses = inverse_mass_before + inverse_mass;
            const bool present = is_there && inverse_masses > 0;
            const double target = present ? body.rope.target[chain.first_link + i - 1] : 0;
            before.present[lane] = present ? 1 : 0;
            before.target[lane] = target;
            before.inverse_target[lane] = present ? 1 / std::max(target, rope_shortest) : 1;
            before.compliance[lane] = present ? body.plan.compliance[chain.first_link + i - 1] : 0;
            before.regularisation[lane] = present ? rope_regularisation * inverse_masses : 1;
            before.sideways[lane] =
                present ? 2 * rope_settled * target * target : std::numeric_limits<double>::infinity();
        }
        inverse_mass_before = inverse_mass;
    }
    equations_.step_squared[lane] = equations_.inverse_step_squared[lane] = equations_.reach[lane] =
        equations_.most_tension[lane] = 1;
}

/// Newton's initial guess is the previous motion, with constraints, continued.
template <int lanes>
void RopesBesideModels<lanes>::put(uint32_t lane) {
    const RopeInStep& rope = *lanes_[lane].rope;
    const Body& body = rope.body();
    const uint32_t* const particles = particles_of(body);
    const History& history = body.history;
    const double h = rope.advance(), before = history.earlier_step;
    const double curve = before > 0 ? h * h / (2 * before) : 0;
    const bool onward = before > 0 || body.contacts.has_contact;
    double longest = 0, farthest = 0, mass = 0;
    for (uint32_t i = 0; i <= links_of(body); ++i) {
        RopeNode<lanes>& node = nodes_[i];
        const uint32_t p = particles[i];
        Vec3 at = history.predicted[p];
        put3(node.predicted, lane, at);
        clear(pushes_[i], lane);
        if (onward && !body.particles.pinned(p)) {
            const Vec3 velocity = history.start_velocity[p];
            at = history.start[p] + velocity * h + (velocity - history.earlier_velocity[p]) * curve;
        }
        put3(node.position, lane, at);
        farthest = std::max(farthest, length_squared(at - history.predicted[p]));
        mass += node.mass[lane];
        if (i == links_of(body)) continue;
        longest = std::max(longest, node.target[lane]);
        node.tension[lane] = body.rope.tension[body.plan.chains[0].first_link + i];
    }
    const double step = rope.effective_step();
    // A rope that is pressed together along a straight line leaves it by a small way. Newton's first correction may be
    // a thousand times that.
    equations_.reach[lane] = longest + std::sqrt(farthest);
    equations_.step_squared[lane] = step * step;
    equations_.inverse_step_squared[lane] = 1 / (step * step);
    // A million times what moves the whole rope so far: an iteration that goes astray overflows nowhere.
    equations_.most_tension[lane] = 1e6 * mass * equations_.reach[lane] * equations_.inverse_step_squared[lane];
}

template <int lanes>
void RopesBesideModels<lanes>::put_pushes(uint32_t lane) {
    const RopeInStep& rope = *lanes_[lane].rope;
    RopeContacts& contacts = *rope.contacts();
    Body& body = rope.body();
    const uint32_t* const particles = particles_of(body);
    const auto stiffness = [&](uint32_t link) {
        const RopeNode<lanes>& node = nodes_[link];
        return std::max(0.0, node.tension[lane]) * equations_.step_squared[lane] * node.inverse_target[lane];
    };
    for (uint32_t i = 0; i <= links_of(body); ++i) {
        const uint32_t p = particles[i];
        if (body.particles.pinned(p) || !contacts.any(p)) continue;
        body.particles.position[p] = take3(nodes_[i].position, lane);
        if (!contacts.acts(p)) {
            clear(pushes_[i], lane);
            continue;
        }
        const double mass =
            body.particles.mass[p] + (i > 0 ? stiffness(i - 1) : 0) + (i < links_of(body) ? stiffness(i) : 0);
        const ContactTerm term = contacts.term(body, p, mass);
        const double matrix[] = {term.xx, term.xy, term.xz, term.yy, term.yz, term.zz};
        for (int k = 0; k < 6; ++k) pushes_[i].stiffness[k][lane] = matrix[k];
        put3(pushes_[i].force, lane, term.force);
    }
}

/// Begins the next part of the lane's rope that has contacts. Returns false at the end of its step.
template <int lanes>
bool RopesBesideModels<lanes>::begin(uint32_t lane) {
    RopeInStep& rope = *lanes_[lane].rope;
    while (rope.begin_part()) {
        if (rope.contacts()) {
            put(lane);
            lanes_[lane].solving = true;
            lanes_[lane].iteration = 0;
            return true;
        }
        rope.end_part(rope.solve());
    }
    return false;
}

template <int lanes>
RopeInStep RopesBesideModels<lanes>::move_until_one_ends() {
    for (;;) {
        for (uint32_t i = 0; i < lanes; ++i) {
            Lane& lane = lanes_[i];
            if (!lane.rope || lane.solving || begin(i)) continue;
            const RopeInStep ended = *lane.rope;
            lane.rope.reset();
            --count_;
            return ended;
        }
        iterate();
    }
}

template <int lanes>
void RopesBesideModels<lanes>::iterate() {
    for (uint32_t lane = 0; lane < lanes; ++lane) {
        equations_.active[lane] = lanes_[lane].solving ? 1 : 0;
        if (lanes_[lane].solving) put_pushes(lane);
    }
    bool moving[lanes];
    kernels_.iterate(nodes_, pushes_, longest_, equations_, moving);
    for (uint32_t i = 0; i < lanes; ++i) {
        Lane& lane = lanes_[i];
        if (!lane.solving) continue;
        const bool settled = update(i) && !moving[i];
        if (!settled && ++lane.iteration < most_iterations) continue;
        take(i);
        lane.solving = false;
        lane.rope->end_part(settled || is_found(i));
    }
}

/// Returns whether the states of the contacts were right.
template <int lanes>
bool RopesBesideModels<lanes>::update(uint32_t lane) {
    const RopeInStep& rope = *lanes_[lane].rope;
    RopeContacts& contacts = *rope.contacts();
    Body& body = rope.body();
    const uint32_t* const particles = particles_of(body);
    for (uint32_t i = 0; i <= links_of(body); ++i) {
        if (contacts.any(particles[i])) body.particles.position[particles[i]] = take3(nodes_[i].position, lane);
    }
    return contacts.update(body, lanes_[lane].iteration);
}

template <int lanes>
void RopesBesideModels<lanes>::take(uint32_t lane) const {
    Body& body = lanes_[lane].rope->body();
    const uint32_t* const particles = particles_of(body);
    for (uint32_t i = 0; i <= links_of(body); ++i) {
        body.particles.position[particles[i]] = take3(nodes_[i].position, lane);
        if (i == links_of(body)) continue;
        const double tension = nodes_[i].tension[lane];
        body.rope.tension[body.plan.chains[0].first_link + i] = is_finite(tension) ? tension : 0;
    }
}

/// Whether the lengths of all links match their tensions.
template <int lanes>
bool RopesBesideModels<lanes>::is_found(uint32_t lane) const {
    for (uint32_t i = 0; i < links_of(lanes_[lane].rope->body()); ++i) {
        const RopeNode<lanes>& node = nodes_[i];
        if (node.present[lane] == 0 || node.target[lane] == 0) continue;
        const double length = distance(take3(node.position, lane), take3(nodes_[i + 1].position, lane));
        const double misfit = length - node.target[lane] - node.compliance[lane] * node.tension[lane];
        if (!(std::fabs(misfit) <= rope_lost * node.target[lane])) return false;
    }
    return true;
}

template class RopesBesideModels<1>;
template class RopesBesideModels<8>;

}  // namespace gphys
