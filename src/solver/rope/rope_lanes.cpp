// Undisturbed ropes, one or eight side by side, through all substeps of a step (rope_lanes.h).
#include "solver/rope/rope_lanes.h"

#include "solver/rope/rope.h"
#include "solver/time_scheme.h"

namespace gphys {
namespace {

bool is_between_pins(const Particles& particles) {
    return std::count(particles.inverse_mass.begin(), particles.inverse_mass.end(), 0.0) > 1;
}

double* numbers_of(Vector<Vec3>& vectors) {
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    return reinterpret_cast<double*>(vectors.data());
}

RopeArrays arrays_of(Body& body, const Chain& chain, bool estimated) {
    Plan& plan = body.plan;
    RopeArrays arrays;
    arrays.particles = plan.particles.data() + chain.first_particle;
    arrays.count = chain.link_count + 1;
    arrays.position = numbers_of(body.particles.position);
    arrays.velocity = numbers_of(body.particles.velocity);
    arrays.start = numbers_of(body.history.start);
    arrays.start_velocity = numbers_of(body.history.start_velocity);
    arrays.earlier_velocity = estimated ? numbers_of(body.history.earlier_velocity) : nullptr;
    arrays.force = numbers_of(body.particles.force);
    arrays.mass = body.particles.mass.data();
    arrays.inverse_mass = body.particles.inverse_mass.data();
    arrays.target = body.rope.target.data() + chain.first_link;
    arrays.compliance = plan.compliance.data() + chain.first_link;
    arrays.tension = body.rope.tension.data() + chain.first_link;
    arrays.forced = body.particles.forced;
    return arrays;
}

/// Bodies side by side, all with the same number of chains. A lane without a body repeats the first one.
template <int lanes>
class Lanes {
public:
    Lanes(const RopeKernelsOf<lanes>& kernels, RopeNode<lanes>* nodes, UndisturbedRope* ropes, uint32_t count,
          const StepOfRopes& step)
        : kernels_(kernels), nodes_(nodes), ropes_(ropes), count_(count), step_(step) {
        for (uint32_t lane = 0; lane < lanes; ++lane) bodies_[lane] = ropes[lane < count ? lane : 0].body;
    }

    void put() {
        std::fill_n(agility_, lanes, 0.0);
        for (size_t i = 0; i < chains(); ++i) put_chain(i);
    }
    /// Chooses the lanes whose substeps have two stages.
    void choose() {
        for (uint32_t lane = 0; lane < count_; ++lane) {
            constexpr double most = most_turn_in_stages * most_turn_in_stages;
            const double h = step_.dt / step_.substeps;
            bodies_[lane]->history.in_stages =
                bodies_[lane]->history.earlier_step > 0 && agility_[lane] * h * h <= most;
        }
    }

    /// Moves the chosen lanes only; all lanes use the same formula.
    void move_if(bool in_stages) {
        bool wanted[lanes] = {};
        for (uint32_t lane = 0; lane < count_; ++lane) wanted[lane] = bodies_[lane]->history.in_stages == in_stages;
        if (std::count(wanted, wanted + lanes, true) == 0) return;
        if (moved_) put();
        moved_ = true;
        reset_bounds();
        for (size_t i = 0; i < chains(); ++i) move_chain(i, in_stages);
        for (uint32_t lane = 0; lane < count_; ++lane) {
            if (!wanted[lane]) continue;
            wanted[lane] = ropes_[lane].stayed = stays(lane);
        }
        for (size_t i = 0; i < chains(); ++i) take_chain(i, wanted);
        for (uint32_t lane = 0; lane < count_; ++lane) {
            if (!wanted[lane]) continue;
            bodies_[lane]->history.earlier_step = earlier_step_[lane];
            bodies_[lane]->contacts.has_contact = false;
        }
    }

private:
    size_t chains() const { return bodies_[0]->plan.chains.size(); }
    RopeNode<lanes>* nodes_of(size_t chain) const { return nodes_ + bodies_[0]->plan.chains[chain].first_particle; }

    /// Returns the number of nodes.
    uint32_t list(size_t chain, RopeArrays (&ropes)[lanes]) const {
        uint32_t longest = 0;
        for (uint32_t lane = 0; lane < lanes; ++lane) {
            ropes[lane] = arrays_of(*bodies_[lane], bodies_[lane]->plan.chains[chain], step_.estimated);
            longest = std::max(longest, ropes[lane].count);
        }
        return longest;
    }

    void put_chain(size_t i) {
        RopeArrays ropes[lanes];
        const uint32_t nodes = list(i, ropes);
        for (uint32_t lane = 0; lane < lanes; ++lane) {
            Plan& plan = bodies_[lane]->plan;
            const Chain& chain = plan.chains[i];
            if (is_between_pins(bodies_[lane]->particles)) {
                set_targets(*bodies_[lane], chain);
            } else {
                ropes[lane].target = plan.rest.data() + chain.first_link;
            }
        }
        double agility[lanes];
        kernels_.put(nodes_of(i), nodes, ropes, {step_.gravity.x, step_.gravity.y, step_.gravity.z});
        kernels_.find_agility(nodes_of(i), nodes, agility);
        for (int lane = 0; lane < lanes; ++lane) agility_[lane] = std::max(agility_[lane], agility[lane]);
    }

    void reset_bounds() {
        for (int k = 0; k < 3; ++k) {
            std::fill_n(bounds_.low[k], lanes, infinity);
            std::fill_n(bounds_.high[k], lanes, -infinity);
        }
        std::fill_n(bounds_.lost, lanes, 0.0);
    }

    void move_chain(size_t chain, bool in_stages) {
        for (uint32_t lane = 0; lane < lanes; ++lane) earlier_step_[lane] = bodies_[lane]->history.earlier_step;
        uint32_t nodes = 0;
        for (const Body* body : bodies_) nodes = std::max(nodes, body->plan.chains[chain].link_count + 1);
        const auto move_part = [&](double advance, bool trapezoid) {
            RopeStep<lanes> part;
            for (uint32_t lane = 0; lane < lanes; ++lane) prepare(part, lane, advance, trapezoid);
            kernels_.move(nodes_of(chain), nodes, part, trapezoid, bounds_);
        };
        const double h = step_.dt / step_.substeps;
        for (uint32_t i = 0; i < step_.substeps; ++i) {
            if (i == 0 && starts_again(*bodies_[0])) {
                for (const double part : starting_parts) move_part(h * part, false);
            } else if (in_stages) {
                move_part(h * stages[0], true);
                move_part(h * stages[1], false);
            } else {
                move_part(h, false);
            }
        }
    }

    /// Prepares one part of a substep, of `advance` seconds.
    void prepare(RopeStep<lanes>& part, uint32_t lane, double advance, bool trapezoid) {
        const double damping = bodies_[lane]->settings.damping;
        const TimeScheme scheme = trapezoid ? TimeScheme::trapezoid(advance) : TimeScheme(advance, earlier_step_[lane]);
        const double effective = scheme.step(damping);
        part.h[lane] = scheme.h, part.rate[lane] = 1 / scheme.h;
        part.next[lane] = scheme.next, part.inverse_next[lane] = 1 / scheme.next;
        part.now[lane] = scheme.now, part.earlier[lane] = scheme.earlier;
        part.damping[lane] = damping, part.drag[lane] = scheme.drag(damping);
        part.step_squared[lane] = effective * effective;
        part.inverse_step_squared[lane] = 1 / (effective * effective);
        part.curve[lane] = scheme.earlier > 0 ? advance * advance / (2 * earlier_step_[lane]) : 0;
        earlier_step_[lane] = advance;
    }

    bool stays(uint32_t lane) const {
        if (bounds_.lost[lane] != 0) return false;
        for (int k = 0; k < 3; ++k) {
            constexpr double range = GPHYS_MAX_COORDINATE;
            if (bounds_.low[k][lane] < -range || bounds_.high[k][lane] > range) return false;
        }
        const Box* const box = ropes_[lane].confines;
        if (!box) return true;
        const double radius = bodies_[lane]->particles.largest_radius;
        for (int k = 0; k < 3; ++k) {
            if (bounds_.low[k][lane] - radius < box->min[k] || bounds_.high[k][lane] + radius > box->max[k])
                return false;
        }
        return true;
    }

    void take_chain(size_t i, const bool (&wanted)[lanes]) const {
        RopeArrays ropes[lanes];
        const uint32_t nodes = list(i, ropes);
        kernels_.take(nodes_of(i), nodes, ropes, wanted);
    }

    const RopeKernelsOf<lanes>& kernels_;
    RopeNode<lanes>* nodes_;
    UndisturbedRope* ropes_;
    uint32_t count_;
    const StepOfRopes& step_;
    Body* bodies_[lanes];
    double agility_[lanes], earlier_step_[lanes];
    RopeBounds<lanes> bounds_;
    bool moved_ = false;
};

template <int lanes>
void move_lanes(const RopeKernelsOf<lanes>& kernels, RopeNode<lanes>* nodes, UndisturbedRope* ropes, uint32_t count,
                const StepOfRopes& step) {
    Lanes<lanes> all(kernels, nodes, ropes, count, step);
    all.put();
    all.choose();
    for (const bool in_stages : {true, false}) all.move_if(in_stages);
}

}  // namespace

void RopeRoom::reserve(size_t alone, size_t together, size_t beside) {
    const auto enlarge = [](auto& nodes, size_t count) {
        if (nodes.size() < count) nodes.resize(count);
    };
    enlarge(one, alone);
    enlarge(one_pushes, alone);
    enlarge(eight, together);
    enlarge(eight_pushes, beside);
    const size_t wanted = beside > 0 ? ropes_together : alone > 0 ? 1 : 0;
    while (contacts.size() < wanted) contacts.emplace_back(contacts.get_allocator().resource());
    for (size_t lane = 0; lane < wanted; ++lane)
        contacts[lane].reserve(static_cast<uint32_t>(lane == 0 ? alone : beside));
}

bool is_plain_rope(const Body& body) {
    const Plan& plan = body.plan;
    return plan.method == GPHYS_SOLVE_DIRECT && plan.particles.size() == body.particles.size() && !plan.limited &&
           !plan.damped && body.constraints.attachments.empty() && body.constraints.length_changes.empty() &&
           body.targets.empty();
}

void move_ropes(UndisturbedRope* ropes, uint32_t count, RopeRoom& room, const StepOfRopes& step) {
    const RopeKernels& kernels = rope_kernels(chosen_isa());
    if (count == 1) {
        move_lanes(kernels.one, room.one.data(), ropes, count, step);
    } else {
        move_lanes(kernels.eight, room.eight.data(), ropes, count, step);
    }
}

void choose_stages(Body& body, RopeRoom& room, const StepOfRopes& step) {
    UndisturbedRope rope{&body, nullptr, false};
    Lanes<1> alone(rope_kernels(chosen_isa()).one, room.one.data(), &rope, 1, step);
    alone.put();
    alone.choose();
}

}  // namespace gphys
