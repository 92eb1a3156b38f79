#include "solver/rope/rope_lanes.h"

#include "solver/rope/rope.h"
#include "solver/time_scheme.h"

namespace gphys {
namespace {

// A link that is to be shorter is as stiff sideways as one of this length.
constexpr double shortest = 1e-9;

template <int lanes>
void set(double (&to)[3][lanes], uint32_t lane, Vec3 value) {
    for (int k = 0; k < 3; ++k) to[k][lane] = value[k];
}
template <int lanes>
Vec3 get(const double (&from)[3][lanes], uint32_t lane) {
    return {from[0][lane], from[1][lane], from[2][lane]};
}

/// One of the ropes in the nodes.
template <int lanes>
class Lane {
public:
    Lane() = default;
    /// Without a body there is nothing in it.
    Lane(RopeNode<lanes>* nodes, uint32_t lane, Body* body) : nodes_(nodes), lane_(lane), body_(body) {}

    void put(uint32_t i, Vec3 gravity) {
        if (body_ && i < body_->size()) {
            put_particle(i, gravity);
        } else {
            put_nothing(i);
        }
    }
    /// Once all nodes are put.
    void link() {
        if (!body_) return;
        earlier_step_ = body_->earlier_step;
        for (const Chain& chain : body_->plan.chains) put_links(chain);
        for (const Chain& chain : body_->plan.chains) set_targets(chain);
    }

    /// One part of a substep, of so many seconds.
    void prepare(RopeStep<lanes>& step, double advance, bool trapezoid) {
        const double damping = body_ ? body_->settings.damping : 0;
        const TimeScheme scheme = trapezoid ? TimeScheme::trapezoid(advance) : TimeScheme(advance, earlier_step_);
        const double effective = scheme.step(damping);
        step.h[lane_] = scheme.h, step.rate[lane_] = 1 / scheme.h;
        step.next[lane_] = scheme.next, step.inverse_next[lane_] = 1 / scheme.next;
        step.now[lane_] = scheme.now, step.earlier[lane_] = scheme.earlier;
        step.damping[lane_] = damping, step.drag[lane_] = scheme.drag(damping);
        step.step_squared[lane_] = effective * effective;
        step.inverse_step_squared[lane_] = 1 / (effective * effective);
        step.curve[lane_] = scheme.earlier > 0 ? advance * advance / (2 * earlier_step_) : 0;
        earlier_step_ = advance;
    }

    bool stays(const RopeBounds<lanes>& bounds, const Box* box) const {
        if (bounds.lost[lane_] != 0) return false;
        if (!box) return true;
        double radius = 0;
        for (const double r : body_->radius) radius = std::max(radius, r);
        for (int k = 0; k < 3; ++k) {
            if (bounds.low[k][lane_] - radius < box->min[k] || bounds.high[k][lane_] + radius > box->max[k])
                return false;
        }
        return true;
    }

    void take(uint32_t i) const {
        Body& body = *body_;
        if (i >= body.size()) return;
        const uint32_t p = body.plan.particles[i];
        const RopeNode<lanes>& node = nodes_[i];
        body.position[p] = get(node.position, lane_);
        body.velocity[p] = get(node.velocity, lane_);
        body.start[p] = get(node.start, lane_);
        body.start_velocity[p] = get(node.start_velocity, lane_);
        body.earlier_velocity[p] = get(node.earlier_velocity, lane_);
    }
    /// Once all nodes are taken.
    void finish() const {
        Body& body = *body_;
        for (const Chain& chain : body.plan.chains) {
            for (uint32_t i = 0; i < chain.link_count; ++i) {
                body.plan.tension[chain.first_link + i] = nodes_[chain.first_particle + i].tension[lane_];
            }
        }
        body.earlier_step = earlier_step_;
        body.touched = false;
    }

private:
    void put_particle(uint32_t i, Vec3 gravity) {
        const Body& body = *body_;
        const uint32_t p = body.plan.particles[i];
        RopeNode<lanes>& node = nodes_[i];
        set(node.position, lane_, body.position[p]);
        set(node.velocity, lane_, body.velocity[p]);
        set(node.start, lane_, body.start[p]);
        set(node.start_velocity, lane_, body.start_velocity[p]);
        set(node.acceleration, lane_, gravity + body.force[p] * body.inverse_mass[p]);
        node.mass[lane_] = body.mass[p];
        node.free[lane_] = body.pinned(p) ? 0 : 1;
        put_no_link(node);
    }
    /// Beyond the end of a rope: a particle that stays at its first one, so that it takes up no room.
    void put_nothing(uint32_t i) {
        RopeNode<lanes>& node = nodes_[i];
        const Vec3 first = body_ ? at(0) : Vec3{};
        set(node.position, lane_, first);
        set(node.start, lane_, first);
        for (auto* vector : {&node.velocity, &node.start_velocity, &node.acceleration}) set(*vector, lane_, {});
        node.mass[lane_] = 1;
        node.free[lane_] = 0;
        put_no_link(node);
    }
    void put_no_link(RopeNode<lanes>& node) {
        node.present[lane_] = node.target[lane_] = node.compliance[lane_] = node.tension[lane_] = 0;
        node.inverse_target[lane_] = node.regularisation[lane_] = 1;
        node.sideways[lane_] = infinity;
    }

    void put_links(const Chain& chain) {
        const Body& body = *body_;
        for (uint32_t i = 0; i < chain.link_count; ++i) {
            const uint32_t first = chain.first_particle + i;
            const double inverse_masses =
                body.inverse_mass[body.plan.particles[first]] + body.inverse_mass[body.plan.particles[first + 1]];
            if (inverse_masses == 0) continue;
            RopeNode<lanes>& node = nodes_[first];
            node.present[lane_] = 1;
            node.compliance[lane_] = body.plan.compliance[chain.first_link + i];
            node.regularisation[lane_] = rope_regularisation * inverse_masses;
            node.tension[lane_] = body.plan.tension[chain.first_link + i];
        }
    }

    void set_target(uint32_t i, double target) {
        RopeNode<lanes>& node = nodes_[i];
        if (node.present[lane_] == 0) return;
        node.target[lane_] = target;
        node.inverse_target[lane_] = 1 / std::max(target, shortest);
        node.sideways[lane_] = 2 * rope_settled * target * target;
    }

    void set_targets(const Chain& chain) {
        const Plan& plan = body_->plan;
        const uint32_t first = chain.first_particle;
        for (uint32_t i = 0; i < chain.link_count; ++i) set_target(first + i, plan.rest[chain.first_link + i]);
        share_stretch(
            plan, chain, [&](uint32_t i) { return nodes_[first + i].free[lane_] == 0; },
            [&](uint32_t i) { return at(first + i); },
            [&](uint32_t i, double length) { set_target(first + i, length); });
    }
    Vec3 at(uint32_t i) const { return get(nodes_[i].position, lane_); }

    RopeNode<lanes>* nodes_ = nullptr;
    uint32_t lane_ = 0;
    Body* body_ = nullptr;
    double earlier_step_ = 0;
};

template <int lanes>
void move_lanes(void (*move)(RopeNode<lanes>*, uint32_t, const RopeStep<lanes>&, bool, RopeBounds<lanes>&),
                RopeNode<lanes>* nodes, UndisturbedRope* ropes, uint32_t count, Vec3 gravity, double dt,
                uint32_t substeps) {
    uint32_t longest = 0;
    for (uint32_t r = 0; r < count; ++r) longest = std::max(longest, ropes[r].body->size());
    Lane<lanes> all[lanes];
    for (uint32_t lane = 0; lane < lanes; ++lane) {
        all[lane] = Lane<lanes>(nodes, lane, lane < count ? ropes[lane].body : nullptr);
    }
    // Node by node, as a node of eight lanes is as large as the near cache can hold a few of.
    for (uint32_t i = 0; i < longest; ++i) {
        for (Lane<lanes>& lane : all) lane.put(i, gravity);
    }
    for (Lane<lanes>& lane : all) lane.link();
    RopeBounds<lanes> bounds;
    for (int k = 0; k < 3; ++k) {
        std::fill_n(bounds.low[k], lanes, infinity);
        std::fill_n(bounds.high[k], lanes, -infinity);
    }
    std::fill_n(bounds.lost, lanes, 0.0);
    const auto move_part = [&](double part, bool trapezoid) {
        RopeStep<lanes> step;
        for (Lane<lanes>& lane : all) lane.prepare(step, part, trapezoid);
        move(nodes, longest, step, trapezoid, bounds);
    };
    const Body& first = *ropes[0].body;
    const double h = dt / substeps;
    for (uint32_t i = 0; i < substeps; ++i) {
        if (i == 0 && starts_again(first)) {
            for (const double part : starting_parts) move_part(h * part, false);
        } else if (first.in_stages) {
            move_part(h * stages[0], true);
            move_part(h * stages[1], false);
        } else {
            move_part(h, false);
        }
    }
    for (uint32_t r = 0; r < count; ++r) {
        ropes[r].stayed = all[r].stays(bounds, ropes[r].confines);
    }
    for (uint32_t i = 0; i < longest; ++i) {
        for (uint32_t r = 0; r < count; ++r) {
            if (ropes[r].stayed) all[r].take(i);
        }
    }
    for (uint32_t r = 0; r < count; ++r) {
        if (ropes[r].stayed) all[r].finish();
    }
}

}  // namespace

bool is_plain_rope(const Body& body) {
    const Plan& plan = body.plan;
    return plan.method == GPHYS_SOLVE_DIRECT && plan.particles.size() == body.size() && !plan.limited && !plan.damped &&
           body.attachments.empty();
}

void move_ropes(UndisturbedRope* ropes, uint32_t count, RopeRoom& room, Vec3 gravity, double dt, uint32_t substeps) {
    const RopeKernels& kernels = rope_kernels(chosen_isa());
    if (count == 1) {
        move_lanes(kernels.move_one, room.one.data(), ropes, count, gravity, dt, substeps);
    } else {
        move_lanes(kernels.move_eight, room.eight.data(), ropes, count, gravity, dt, substeps);
    }
}

}  // namespace gphys
