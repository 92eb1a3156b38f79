// Undisturbed ropes, one or eight side by side, through all substeps of a step (rope_lanes.h): gather, move, scatter.
#include "solver/rope/rope_lanes.h"

#include "solver/rope/rope.h"
#include "solver/rope/stretched_ropes.h"
#include "solver/time_scheme.h"

namespace gphys {
namespace {

bool is_between_pins(const Particles& particles) {
    return std::count(particles.inverse_mass.begin(), particles.inverse_mass.end(), 0.0) > 1;
}

bool is_stretched(const Body& body, const Chain& chain) {
    const double* const rest = body.plan.rest.data() + chain.first_link;
    return !std::equal(rest, rest + chain.link_count, body.rope.target.data() + chain.first_link);
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

/// Ropes in the lanes of the kernels, all with the same number of chains. A lane without a rope repeats the first one.
template <int lanes>
class UndisturbedRopes {
public:
    UndisturbedRopes(const RopeKernelsOf<lanes>& kernels, RopeNode<lanes>* nodes, UndisturbedRope* ropes,
                     uint32_t count, const RopeStepSettings& step)
        : kernels_(kernels), nodes_(nodes), ropes_(ropes), count_(count), step_(step) {
        for (uint32_t lane = 0; lane < lanes; ++lane) bodies_[lane] = ropes[lane < count ? lane : 0].body;
    }

    void gather() {
        std::fill_n(frequency_squared_, lanes, 0.0);
        std::fill_n(varies_, lanes, false);
        for (size_t i = 0; i < chains(); ++i) gather_chain(i);
    }
    /// Call after gather: chooses the lanes whose substeps have two stages.
    void choose_stages() {
        for (uint32_t lane = 0; lane < count_; ++lane) {
            constexpr double most = trapezoid_most_angle * trapezoid_most_angle;
            const double h = step_.whole.step_time / step_.substeps;
            bodies_[lane]->history.in_stages =
                bodies_[lane]->history.earlier_step > 0 && frequency_squared_[lane] * h * h <= most;
        }
    }

    /// Moves the lanes whose choice was `in_stages`: all lanes of a kernel use the same formula, and the others are not
    /// scattered.
    void move_if(bool in_stages) {
        bool wanted[lanes] = {};
        for (uint32_t lane = 0; lane < count_; ++lane) wanted[lane] = bodies_[lane]->history.in_stages == in_stages;
        if (std::count(wanted, wanted + lanes, true) == 0) return;
        if (moved_) gather();
        moved_ = true;
        reset_bounds();
        for (size_t i = 0; i < chains(); ++i) move_chain(i, in_stages, wanted);
        for (uint32_t lane = 0; lane < count_; ++lane) {
            if (!wanted[lane]) continue;
            wanted[lane] = ropes_[lane].stayed = stays_undisturbed(lane);
        }
        for (size_t i = 0; i < chains(); ++i) scatter_chain(i, wanted);
        for (uint32_t lane = 0; lane < count_; ++lane) {
            if (!wanted[lane]) continue;
            bodies_[lane]->history.earlier_step = earlier_step_[lane];
            bodies_[lane]->contacts.has_contact = false;
        }
    }

private:
    size_t chains() const { return bodies_[0]->plan.chains.size(); }
    RopeNode<lanes>* nodes_of(size_t chain) const { return nodes_ + bodies_[0]->plan.chains[chain].first_particle; }

    /// Returns the number of nodes of the longest.
    uint32_t list_arrays(size_t chain, RopeArrays (&ropes)[lanes]) const {
        uint32_t longest = 0;
        for (uint32_t lane = 0; lane < lanes; ++lane) {
            ropes[lane] = arrays_of(*bodies_[lane], bodies_[lane]->plan.chains[chain], step_.estimated);
            longest = std::max(longest, ropes[lane].count);
        }
        return longest;
    }

    void gather_chain(size_t i) {
        RopeArrays ropes[lanes];
        const uint32_t nodes = list_arrays(i, ropes);
        for (uint32_t lane = 0; lane < lanes; ++lane) {
            Plan& plan = bodies_[lane]->plan;
            const Chain& chain = plan.chains[i];
            if (is_between_pins(bodies_[lane]->particles)) {
                set_targets(*bodies_[lane], chain);
                varies_[lane] =
                    varies_[lane] || (are_carried(bodies_[lane]->constraints) && is_stretched(*bodies_[lane], chain));
            } else {
                ropes[lane].target = plan.rest.data() + chain.first_link;
            }
        }
        double frequency_squared[lanes];
        kernels_.gather(nodes_of(i), nodes, ropes, {step_.gravity.x, step_.gravity.y, step_.gravity.z});
        for (uint32_t lane = 0; lane < count_; ++lane) carry_attached(i, lane);
        kernels_.find_largest_frequency(nodes_of(i), nodes, frequency_squared);
        for (int lane = 0; lane < lanes; ++lane)
            frequency_squared_[lane] = std::max(frequency_squared_[lane], frequency_squared[lane]);
    }

    /// Calls visit(node, attachment) for the nodes of a chain that are attached.
    template <class Visit>
    void each_attached(size_t chain, uint32_t lane, Visit&& visit) const {
        const Body& body = *bodies_[lane];
        if (body.constraints.attachments.empty()) return;
        const Chain& links = body.plan.chains[chain];
        for (uint32_t i = 0; i <= links.link_count; ++i) {
            if (nodes_of(chain)[i].free[lane] != 0) continue;
            const uint32_t particle = body.plan.particles[links.first_particle + i];
            if (const Attachment* attachment = find_attachment(body.constraints, particle)) visit(i, *attachment);
        }
    }

    /// Gives attached nodes the velocity at which their models take them along.
    void carry_attached(size_t chain, uint32_t lane) const {
        each_attached(chain, lane, [&](uint32_t i, const Attachment& attachment) {
            set3(nodes_of(chain)[i].velocity, lane, (attachment.end - attachment.begin) / step_.whole.way_time());
        });
    }

    /// Adds the impulses of the links at attached nodes on their models, of a part in which their tensions act for
    /// `seconds`. `end`: the fraction of the step at the end of the part.
    void add_attached_impulses(size_t chain, uint32_t lane, double seconds, double end) const {
        if (!step_.whole.scene) return;
        const RopeNode<lanes>* const nodes = nodes_of(chain);
        const uint32_t link_count = bodies_[lane]->plan.chains[chain].link_count;
        CollisionContext around = step_.whole;
        around.end = end;
        each_attached(chain, lane, [&](uint32_t i, const Attachment& attachment) {
            const Vec3 at = get3(nodes[i].position, lane);
            const auto pull = [&](uint32_t link, uint32_t other) {
                const Vec3 along = get3(nodes[other].position, lane) - at;
                const double length = gphys::length(along);
                return length > 0 ? along * (nodes[link].tension[lane] * seconds / length) : Vec3{};
            };
            const Vec3 impulse = (i > 0 ? pull(i - 1, i - 1) : Vec3{}) + (i < link_count ? pull(i, i + 1) : Vec3{});
            add_impulse(*bodies_[lane], around, attachment.model, at, impulse);
        });
    }

    void reset_bounds() {
        for (int k = 0; k < 3; ++k) {
            std::fill_n(bounds_.low[k], lanes, infinity);
            std::fill_n(bounds_.high[k], lanes, -infinity);
        }
        std::fill_n(bounds_.failed, lanes, 0.0);
    }

    /// Adds up the loads of the lanes that are wanted, on models and on links that break, of a part in which their
    /// tensions act for `seconds`. `end`: the fraction of the step at the end of the part.
    void add_loads(size_t chain, const double (&seconds)[lanes], const bool (&wanted)[lanes], double end) const {
        for (uint32_t lane = 0; lane < lanes; ++lane) {
            Body& body = *bodies_[lane];
            if (!wanted[lane]) continue;
            add_attached_impulses(chain, lane, seconds[lane], end);
            if (!body.breaking.possible()) continue;
            const Chain& links = body.plan.chains[chain];
            for (uint32_t i = 0; i < links.link_count; ++i)
                body.breaking.impulse[links.first_link + i] += nodes_of(chain)[i].tension[lane] * seconds[lane];
        }
    }

    void move_chain(size_t chain, bool in_stages, const bool (&wanted)[lanes]) {
        for (uint32_t lane = 0; lane < lanes; ++lane) earlier_step_[lane] = bodies_[lane]->history.earlier_step;
        uint32_t nodes = 0;
        for (const Body* body : bodies_) nodes = std::max(nodes, body->plan.chains[chain].link_count + 1);
        double fraction = 0;
        const auto move_part = [&](double advance, bool trapezoid) {
            const double begin = fraction;
            fraction += advance / step_.whole.step_time;
            RopeScheme<lanes> part;
            for (uint32_t lane = 0; lane < lanes; ++lane) set_scheme(part, lane, advance, trapezoid);
            if (trapezoid) add_loads(chain, part.h, wanted, begin);  // its explicit part is as long
            kernels_.move(nodes_of(chain), nodes, part, trapezoid, bounds_);
            add_loads(chain, part.h, wanted, fraction);
        };
        const double h = step_.whole.step_time / step_.substeps;
        for (uint32_t i = 0; i < step_.substeps; ++i) {
            if (i == 0 && restarts(bodies_[0]->history, bodies_[0]->contacts)) {
                for (const double part : starting_parts) move_part(h * part, false);
            } else if (in_stages) {
                move_part(h * stages[0], true);
                move_part(h * stages[1], false);
            } else {
                move_part(h, false);
            }
        }
    }

    /// Sets the coefficients of a lane for one part of a substep, of `advance` seconds.
    void set_scheme(RopeScheme<lanes>& part, uint32_t lane, double advance, bool trapezoid) {
        const double damping = bodies_[lane]->settings.damping;
        const TimeScheme scheme = trapezoid ? TimeScheme::trapezoid(advance) : TimeScheme(advance, earlier_step_[lane]);
        const double effective = scheme.step(damping);
        part.h[lane] = scheme.h, part.rate[lane] = 1 / scheme.h;
        part.next[lane] = scheme.next, part.inverse_next[lane] = 1 / scheme.next;
        part.now[lane] = scheme.now, part.earlier[lane] = scheme.earlier;
        part.damping[lane] = damping, part.drag[lane] = scheme.drag(damping);
        part.step_squared[lane] = effective * effective;
        part.inverse_step_squared[lane] = 1 / (effective * effective);
        part.extrapolation[lane] = scheme.earlier > 0 ? advance * advance / (2 * earlier_step_[lane]) : 0;
        earlier_step_[lane] = advance;
    }

    /// Whether the rope has stayed in its region, its lengths are those of the whole step, and Newton's method has not
    /// failed.
    bool stays_undisturbed(uint32_t lane) const {
        if (bounds_.failed[lane] != 0 || varies_[lane]) return false;
        for (int k = 0; k < 3; ++k) {
            constexpr double range = GPHYS_MAX_COORDINATE;
            if (bounds_.low[k][lane] < -range || bounds_.high[k][lane] > range) return false;
        }
        const Box* const box = ropes_[lane].region;
        if (!box) return true;
        const double radius = bodies_[lane]->particles.largest_radius;
        for (int k = 0; k < 3; ++k) {
            if (bounds_.low[k][lane] - radius < box->min[k] || bounds_.high[k][lane] + radius > box->max[k])
                return false;
        }
        return true;
    }

    void scatter_chain(size_t i, const bool (&wanted)[lanes]) const {
        RopeArrays ropes[lanes];
        const uint32_t nodes = list_arrays(i, ropes);
        kernels_.scatter(nodes_of(i), nodes, ropes, wanted);
        for (uint32_t lane = 0; lane < count_; ++lane) {
            if (!wanted[lane]) continue;
            each_attached(i, lane, [&](uint32_t, const Attachment& attachment) {
                const double way = step_.whole.share;
                bodies_[lane]->particles.position[attachment.particle] =
                    way < 1 ? attachment.begin + (attachment.end - attachment.begin) * way : attachment.end;
            });
        }
    }

    const RopeKernelsOf<lanes>& kernels_;
    RopeNode<lanes>* nodes_;
    UndisturbedRope* ropes_;
    uint32_t count_;
    const RopeStepSettings& step_;
    Body* bodies_[lanes];
    double frequency_squared_[lanes], earlier_step_[lanes];
    bool varies_[lanes];  // whether the lengths that links can have depend on where models take their pins
    RopeBounds<lanes> bounds_;
    bool moved_ = false;
};

template <int lanes>
void move_lanes(const RopeKernelsOf<lanes>& kernels, RopeNode<lanes>* nodes, UndisturbedRope* ropes, uint32_t count,
                const RopeStepSettings& step) {
    UndisturbedRopes<lanes> all(kernels, nodes, ropes, count, step);
    all.gather();
    all.choose_stages();
    for (const bool in_stages : {true, false}) all.move_if(in_stages);
}

}  // namespace

void RopeScratch::reserve(size_t alone, size_t in_lanes, size_t in_contact_lanes, size_t moving_models) {
    const auto enlarge = [](auto& nodes, size_t count) {
        if (nodes.size() < count) nodes.resize(count);
    };
    enlarge(one, alone);
    enlarge(one_terms, alone);
    enlarge(eight, in_lanes);
    enlarge(eight_terms, in_contact_lanes);
    const size_t contact_lanes = in_contact_lanes > 0 ? rope_lanes : alone > 0 ? 1 : 0;
    while (contacts.size() < contact_lanes) contacts.emplace_back(contacts.get_allocator().resource());
    for (size_t lane = 0; lane < contact_lanes; ++lane)
        contacts[lane].reserve(static_cast<uint32_t>(lane == 0 ? alone : in_contact_lanes), moving_models);
}

bool is_plain_rope(const Body& body) {
    const Plan& plan = body.plan;
    return plan.method == GPHYS_SOLVE_DIRECT && plan.particles.size() == body.particles.size() && !plan.limited &&
           !plan.damped && !body.rope.bending.resists() && body.constraints.length_changes.empty() &&
           body.targets.empty();
}

void move_ropes(UndisturbedRope* ropes, uint32_t count, RopeScratch& scratch, const RopeStepSettings& step) {
    const RopeKernels& kernels = rope_kernels(chosen_isa());
    if (count == 1) {
        move_lanes(kernels.one, scratch.one.data(), ropes, count, step);
    } else {
        move_lanes(kernels.eight, scratch.eight.data(), ropes, count, step);
    }
}

void choose_stages(Body& body, RopeScratch& scratch, const RopeStepSettings& step) {
    UndisturbedRope rope{&body, nullptr, false};
    UndisturbedRopes<1> alone(rope_kernels(chosen_isa()).one, scratch.one.data(), &rope, 1, step);
    alone.gather();
    alone.choose_stages();
}

}  // namespace gphys
