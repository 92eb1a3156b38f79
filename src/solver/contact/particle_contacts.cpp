// Contacts between particles: spatial hashing (Teschner et al. 2003), a Verlet list (Verlet 1967), and relaxation of
// the contacts (particle_contacts.h).
#include "solver/contact/particle_contacts.h"

#include "solver/contact/collision.h"
#include "solver/contact/friction.h"
#include "solver/quads.h"

namespace gphys {
namespace {

// Capacity of the list and of the contacts, for each particle. In the densest packing of equal spheres each touches 12
// others and has 18 within 1.4 diameters; a pair counts once. Contacts beyond the capacity are dropped, those with the
// highest indices first.
constexpr uint32_t pairs_per_particle = 12;
constexpr uint32_t contacts_per_particle = 6;
// Pairs beyond the capacity are dropped, those of the particles with the highest indices first. n particles at one
// place have n^2 / 2 pairs. So if the capacity is exceeded and more than one in this many listed pairs overlaps deeply,
// each particle takes at most a fixed number of pairs, from a fixed number of particles in each cell around it. Then
// the cost is O(n), and the particles are separated over several substeps.
constexpr uint32_t one_deep_of = 8;
constexpr uint32_t crowded_pairs = 4;
constexpr uint32_t crowded_tests = 8;
// Margin of a particle at rest, in radii. With a larger margin the list is valid for longer and has more pairs.
constexpr double least_margin = 0.2;
// The margin of a moving particle covers this many substeps at its present speed.
constexpr double margin_substeps = 2;
// Gauss-Seidel sweeps over the contacts of a substep. Each sweep propagates a load by at least one particle, so for a
// deep pile more sweeps and more substeps help equally.
constexpr int sweeps = 4;
// Pairs with a smaller gap, in sums of their radii, are contacts too, because others may press them together.
constexpr double near_gap = 0.02;
// Pairs that overlap at the beginning of a substep separate by at most this much in it, in sums of their radii.
// Separating them at once would give them a high speed.
constexpr double most_correction = 0.1;
// Pairs that overlap by more than this at the beginning of a substep, in sums of their radii, overlap deeply: they were
// placed so, because impacts do not penetrate so far.
constexpr double deep = 0.5;

bool collides_with_others(const Body& body) { return body.settings.self_collision || body.settings.body_layers != 0; }

Vec3 place_of(const Body& body, uint32_t p) {
    return is_graph(body) ? body.cloth.state.origin + get(&body.cloth.state.at[4 * size_t{p}])
                          : body.particles.position[p];
}
Vec3 velocity_of(const Body& body, uint32_t p) {
    return is_graph(body) ? get(&body.cloth.state.velocity[4 * size_t{p}]) : body.particles.velocity[p];
}

bool linked(const Body& body, uint32_t a, uint32_t b) {
    const auto begin = body.contacts.self.linked.begin() + body.contacts.self.linked_begin[a],
               end = body.contacts.self.linked.begin() + body.contacts.self.linked_begin[a + 1];
    return std::binary_search(begin, end, b);
}

bool moves_freely(const Body& body) { return body.plan.method == GPHYS_SOLVE_FREE && !body.plan.joined; }

/// Within one body. Linked particles that overlap at rest do not collide.
bool collide_within(const Body& body, uint32_t a, uint32_t b) {
    if (!body.settings.self_collision) return false;
    if (body.plan.method == GPHYS_SOLVE_FREE) return true;
    return distance(body.contacts.self.placed[a], body.contacts.self.placed[b]) >
               body.particles.radius[a] + body.particles.radius[b] &&
           !linked(body, a, b);
}

/// The key of a cell. Different cells may share one, which costs time but changes no result.
uint64_t key_of(const int64_t (&cell)[3]) {
    uint64_t key = 0;
    for (const int64_t c : cell) {
        key = (key ^ static_cast<uint64_t>(c)) * 0x9e3779b97f4a7c15;  // 2^64 / golden ratio
        key ^= key >> 32;
    }
    return key;
}

/// A unit direction for a pair at one point. Different pairs have different directions, so that a pile spreads in all
/// directions. The direction depends on the indices alone and has the same bits on each machine; no component is 0.
Vec3 direction_of_pair(uint32_t a, uint32_t b) {
    constexpr int bits = 21;
    const uint64_t key = key_of({a, b, 0});
    const auto component = [&](int k) {
        const uint64_t part = (key >> (bits * k)) & ((uint64_t{1} << bits) - 1);
        return (static_cast<double>(part) + 0.5) / (1 << (bits - 1)) - 1;
    };
    const Vec3 direction{component(0), component(1), component(2)};
    return direction / length(direction);
}

struct Grid {
    double size;

    // Beyond this, and for NaN, all are in one cell, because the cast would trap.
    static constexpr double most = 1e15;
    int64_t along(double x) const {
        const double cell = std::floor(x / size);
        return static_cast<int64_t>(cell > -most ? std::min(cell, most) : -most);
    }
    uint64_t key(Vec3 at) const { return key_of({along(at.x), along(at.y), along(at.z)}); }
};

/// The time at which two points, whose difference goes from `from` to `to`, are first as close as `reach`; above 1:
/// never.
double time_of_impact(Vec3 from, Vec3 to, double reach) {
    const Vec3 motion = to - from;
    const double a = length_squared(motion), b = dot(from, motion), c = length_squared(from) - reach * reach;
    if (c <= 0) return 0;
    const double discriminant = b * b - a * c;
    if (b >= 0 || discriminant < 0) return infinity;
    return c / (-b + std::sqrt(discriminant));
}

}  // namespace

void list_linked(Body& body) {
    const uint32_t n = body.particles.size();
    body.contacts.self.linked_begin.clear();  // marks the list as missing, in case memory runs out
    body.contacts.self.linked.resize(2 * size_t{body.constraints.ids.size()});
    body.contacts.self.linked_begin.assign(size_t{n} + 1, 0);
    for (uint32_t p = 0; p < n; ++p)
        body.contacts.self.linked_begin[p + 1] = body.contacts.self.linked_begin[p] + body.constraints.links[p].degree;
    for (uint32_t slot = 0; slot < body.constraints.ids.slots(); ++slot) {
        if (!body.constraints.ids.live(slot)) continue;
        const DistanceConstraint& c = body.constraints.by_slot[slot];
        body.contacts.self.linked[body.contacts.self.linked_begin[c.a]++] = c.b;
        body.contacts.self.linked[body.contacts.self.linked_begin[c.b]++] = c.a;
    }
    for (uint32_t p = n; p > 0; --p) body.contacts.self.linked_begin[p] = body.contacts.self.linked_begin[p - 1];
    body.contacts.self.linked_begin[0] = 0;
    for (uint32_t p = 0; p < n; ++p) {
        std::sort(body.contacts.self.linked.begin() + body.contacts.self.linked_begin[p],
                  body.contacts.self.linked.begin() + body.contacts.self.linked_begin[p + 1]);
    }
}

void ParticleContacts::reserve(const Vector<Body>& bodies, Vector<Island>& islands,
                               const Vector<uint32_t>& island_bodies) {
    uint32_t total = 0, most = 0;
    for (Island& island : islands) {
        island.first_particle = total;
        island.colliding_count = 0;
        for (uint32_t i = 0; i < island.body_count; ++i) {
            const Body& body = bodies[island_bodies[island.first_body + i]];
            if (collides_with_others(body)) island.colliding_count += body.particles.size();
        }
        total += island.colliding_count;
    }
    // Which bodies are near each other changes from step to step, so there is room for all that may collide.
    for (const Body& body : bodies) most += collides_with_others(body) ? body.particles.size() : 0;
    particles_.resize(most);
    pairs_.resize(size_t{most} * pairs_per_particle);
    contacts_.resize(size_t{most} * contacts_per_particle);
    buckets_.resize(size_t{most} * 4);
    sorted_.resize(most);
    keys_.resize(most);
    pair_counts_.resize(most);
    contact_counts_.resize(most);
    listed_.reserve(most);
}

void ParticleContacts::begin_step(const IdTable& ids, const Vector<Body>& bodies,
                                  const Vector<Island>& islands) noexcept {
    uint32_t moving = 0;
    for (const Island& island : islands) moving += island.colliding_count;
    listed_.begin_step(ids, bodies, moving);
}

ParticleContacts::Range ParticleContacts::range(const Island& island) {
    const size_t first = island.first_particle;
    uint32_t table = 1;
    while (table < 2 * island.colliding_count) table *= 2;  // with its end, at most four times the particles
    return {&particles_[first],
            island.colliding_count,
            &pairs_[first * pairs_per_particle],
            island.colliding_count * pairs_per_particle,
            &pair_counts_[first],
            &contact_counts_[first],
            &contacts_[first * contacts_per_particle],
            island.colliding_count * contacts_per_particle,
            &buckets_[first * 4],
            table,
            &sorted_[first],
            &keys_[first],
            listed_.of_island(island.first_particle, island.colliding_count)};
}

void ParticleContacts::begin(const Island& island, const IdTable& ids, const Vector<Body>& bodies,
                             const uint32_t* slots) {
    const Range range = this->range(island);
    Particle* next = range.particles;
    for (uint32_t i = 0; i < island.body_count; ++i) {
        const Body& body = bodies[slots[i]];
        if (!collides_with_others(body)) continue;
        for (uint32_t p = 0; p < body.particles.size(); ++p, ++next) {
            *next = {};
            next->body = slots[i];
            next->number = p;
            next->id = ids.id(slots[i]);
            next->radius = body.particles.radius[p];
            next->margin = -1;  // in no list yet
            next->at = place_of(body, p);
            if (!body.contacts.points.empty())
                next->contact_points = &body.contacts.points[size_t{p} * contact_points_per_particle];
        }
    }
    *range.pair_count = *range.contact_count = 0;
    range.listed.clear();
}

void ParticleContacts::gather(const Range& range, const Vector<Body>& bodies) const {
    for (uint32_t i = 0; i < range.count; ++i) {
        Particle& p = range.particles[i];
        const Body& body = bodies[p.body];
        p.before = p.at;
        p.at = p.uncorrected = place_of(body, p.number);
        p.velocity = p.uncorrected_velocity = velocity_of(body, p.number);
        p.inverse_mass = body.particles.inverse_mass[p.number];
    }
}

bool ParticleContacts::list_is_valid(const Range& range) const {
    return std::all_of(range.particles, range.particles + range.count, [](const Particle& p) {
        return p.margin >= 0 && length_squared(p.at - p.list_position) <= p.margin * p.margin;
    });
}

void ParticleContacts::find_pairs(const Range& range, const Vector<Body>& bodies) const {
    double sum = 0;
    for (uint32_t i = 0; i < range.count; ++i) {
        Particle& p = range.particles[i];
        p.list_position = p.at;
        p.margin = std::max(least_margin * p.radius, margin_substeps * distance(p.at, p.before));
        sum += p.reach();
    }
    uint32_t& count = *range.pair_count;
    count = 0;
    range.listed.sort();
    if (sum == 0) return;  // points at rest
    // Cells are as wide as two particles of average reach, so that such a particle visits 27 cells.
    const Grid grid{2 * sum / range.count};
    const uint32_t mask = range.table_size - 1;
    std::fill(range.buckets, range.buckets + range.table_size + 1, 0);
    for (uint32_t i = 0; i < range.count; ++i) {
        range.keys[i] = grid.key(range.particles[i].at);
        ++range.buckets[(range.keys[i] & mask) + 1];
    }
    for (uint32_t b = 0; b < range.table_size; ++b) range.buckets[b + 1] += range.buckets[b];
    for (uint32_t i = range.count; i-- > 0;) range.sorted[--range.buckets[(range.keys[i] & mask) + 1]] = i;
    // The start of each bucket has moved to the place after it: bucket b is buckets[b + 1] .. its successor's.
    const auto bucket = [&](uint32_t b, uint32_t& begin, uint32_t& end) {
        begin = range.buckets[b + 1];
        end = b + 1 < range.table_size ? range.buckets[b + 2] : range.count;
    };
    bool full = false;
    uint32_t deep_pairs = 0;
    uint32_t found = 0;  // by the particle under way
    const auto test_pair = [&](uint32_t i, uint32_t j) {
        const Particle &p = range.particles[i], &q = range.particles[j];
        // The particle with the larger reach finds the pair.
        if (q.reach() > p.reach() || (q.reach() == p.reach() && j <= i)) return;
        const double reach = p.reach() + q.reach();
        if (length_squared(p.at - q.at) > reach * reach || (p.inverse_mass == 0 && q.inverse_mass == 0)) return;
        const Body &a = bodies[p.body], &b = bodies[q.body];
        const bool may = p.body == q.body ? collide_within(a, p.number, q.number)
                                          : (a.settings.body_layers & b.settings.body_layers) != 0;
        if (!may) return;
        if (count == range.most_pairs) {
            full = true;
            return;
        }
        const double radii = (p.radius + q.radius) * (1 - deep);
        if (length_squared(p.at - q.at) < radii * radii) ++deep_pairs;
        range.pairs[count++] = {std::min(i, j), std::max(i, j)};
        ++found;
    };
    // The ranges of `sorted` that particle i has to test. Returns false if these are more than all particles.
    const auto each_cell = [&](uint32_t i, auto&& visit) {
        const Particle& p = range.particles[i];
        const double reach = 2 * p.reach();
        int64_t low[3], high[3];
        double cells = 1;
        for (int k = 0; k < 3; ++k) {
            low[k] = grid.along(p.at[k] - reach);
            high[k] = grid.along(p.at[k] + reach);
            cells *= static_cast<double>(high[k] - low[k] + 1);
        }
        if (cells > range.count) return false;
        for (int64_t x = low[0]; x <= high[0]; ++x) {
            for (int64_t y = low[1]; y <= high[1]; ++y) {
                for (int64_t z = low[2]; z <= high[2]; ++z) {
                    const uint64_t key = key_of({x, y, z});
                    uint32_t begin, end;
                    bucket(static_cast<uint32_t>(key & mask), begin, end);
                    if (begin < end) visit(key, begin, end);
                }
            }
        }
        return true;
    };
    for (uint32_t i = 0; i < range.count && !full; ++i) {
        const bool few = each_cell(i, [&](uint64_t key, uint32_t begin, uint32_t end) {
            for (; begin < end && !full; ++begin) {
                if (range.keys[range.sorted[begin]] == key) test_pair(i, range.sorted[begin]);
            }
        });
        if (few) continue;
        for (uint32_t j = 0; j < range.count && !full; ++j) test_pair(i, j);
    }
    if (!full || uint64_t{deep_pairs} * one_deep_of <= count) return;
    // The particles with the next indices, cyclically, so that all are in about as many pairs.
    count = 0;
    for (uint32_t i = 0; i < range.count; ++i) {
        found = 0;
        const auto search = [&](uint32_t entries, uint32_t next, auto&& entry) {
            for (uint32_t k = 0; k < std::min(entries, crowded_tests) && found < crowded_pairs; ++k) {
                entry(next + k < entries ? next + k : next + k - entries);
            }
        };
        const bool few = each_cell(i, [&](uint64_t key, uint32_t begin, uint32_t end) {
            if (found == crowded_pairs) return;
            const uint32_t *const list = range.sorted + begin, *const list_end = range.sorted + end;
            const auto next = static_cast<uint32_t>(std::upper_bound(list, list_end, i) - list);
            search(end - begin, next % (end - begin), [&](uint32_t k) {
                if (range.keys[list[k]] == key) test_pair(i, list[k]);
            });
        });
        if (!few) search(range.count, (i + 1) % range.count, [&](uint32_t j) { test_pair(i, j); });
    }
}

/// Returns whether many pairs overlap deeply: more than one contact in one_deep_of.
bool ParticleContacts::find_contacts(const Range& range, const Vector<Body>& bodies, double bounce_threshold,
                                     double h) const {
    uint32_t& count = *range.contact_count;
    count = 0;
    uint32_t deep_contacts = 0;
    for (uint32_t i = 0; i < *range.pair_count && count < range.most_contacts; ++i) {
        const Pair& pair = range.pairs[i];
        const Particle &a = range.particles[pair.a], &b = range.particles[pair.b];
        const double radii = a.radius + b.radius;
        const Vec3 before = b.before - a.before, now = b.at - a.at;
        const double t = time_of_impact(before, now, radii);
        if (t > 1 && length_squared(now) > radii * radii * (1 + near_gap) * (1 + near_gap)) continue;
        if (length_squared(before) < radii * radii * (1 - deep) * (1 - deep)) ++deep_contacts;
        const Vec3 at_impact = t > 1 ? now : before + (now - before) * t;
        const double length = gphys::length(at_impact);
        const Vec3 normal = length > 0 ? at_impact / length : direction_of_pair(pair.a, pair.b);
        const Body &of_a = bodies[a.body], &of_b = bodies[b.body];
        // The speed at the time of impact. The speed at the end of the substep is larger, and with it particles would
        // bounce for ever.
        const Vec3 at_end = b.velocity - a.velocity, gained = (at_end - (now - before) / h) * 2;
        const double approach = -dot(at_end - gained * (1 - std::min(t, 1.0)), normal);
        const double restitution = std::sqrt(of_a.settings.restitution * of_b.settings.restitution);
        const double friction =
            std::sqrt(friction_coefficients(of_a, a.number).kinetic * friction_coefficients(of_b, b.number).kinetic);
        const double closing = std::max(0.0, dot(before - now, normal));
        range.contacts[count++] = {pair.a,
                                   pair.b,
                                   normal,
                                   friction,
                                   approach > bounce_threshold ? restitution * approach : 0,
                                   0,
                                   0,
                                   closing + most_correction * radii,
                                   0,
                                   0};
    }
    return uint64_t{deep_contacts} * one_deep_of > count;
}

namespace {

/// The value without motion into the models in contact: other particles cannot push a particle into a model.
template <class Particle>
Vec3 blocked_by_models(const Particle& p, Vec3 value, Vec3 uncorrected) {
    if (!p.contact_points) return value;
    for (uint32_t i = 0; i < contact_points_per_particle && p.contact_points[i].model != 0; ++i) {
        const Vec3 normal = widen(p.contact_points[i].normal);
        value -= normal * std::min(0.0, dot(value - uncorrected, normal));
    }
    return value;
}

/// Adds a correction to the relative position or velocity of two particles, in proportion to their inverse masses. If
/// models block one of them, the other takes its share.
template <class Particle>
void apply_correction(Particle& a, Particle& b, Vec3 correction, Vec3 Particle::*value, Vec3 Particle::*uncorrected) {
    const double inverse_mass = a.inverse_mass + b.inverse_mass, square = length_squared(correction);
    if (square == 0) return;
    const Vec3 to_a = a.*value - correction * (a.inverse_mass / inverse_mass),
               to_b = b.*value + correction * (b.inverse_mass / inverse_mass);
    a.*value = blocked_by_models(a, to_a, a.*uncorrected);
    b.*value = blocked_by_models(b, to_b, b.*uncorrected);
    const double lost_a = dot(a.*value - to_a, correction) / square, lost_b = dot(to_b - b.*value, correction) / square;
    if (lost_a > 0 && b.inverse_mass > 0)
        b.*value = blocked_by_models(b, b.*value + correction * lost_a, b.*uncorrected);
    if (lost_b > 0 && a.inverse_mass > 0)
        a.*value = blocked_by_models(a, a.*value - correction * lost_b, a.*uncorrected);
}

template <class Particle, class Contact>
void solve_position(Contact& contact, Particle& a, Particle& b) {
    const auto move = [&](Vec3 displacement) {
        apply_correction(a, b, displacement, &Particle::at, &Particle::uncorrected);
    };
    const double overlap = a.radius + b.radius - dot(b.at - a.at, contact.normal);
    // The accumulated separation is clamped, so a correction that was too large is undone.
    const double correction = std::clamp(overlap, -contact.separation, contact.most_separation - contact.separation);
    contact.separation += correction;
    move(contact.normal * correction);
    const Vec3 relative = (b.at - b.before) - (a.at - a.before),
               tangential = relative - contact.normal * dot(relative, contact.normal);
    const double sliding = length(tangential),
                 most = contact.friction * contact.separation - contact.friction_displacement;
    if (sliding == 0 || most <= 0) return;
    const double held = std::min(sliding, most);
    contact.friction_displacement += held;
    move(tangential * (-held / sliding));
}

template <class Particle, class Contact>
void solve_velocity(Contact& contact, Particle& a, Particle& b) {
    if (contact.separation <= 0) return;
    const auto accelerate = [&](Vec3 change) {
        apply_correction(a, b, change, &Particle::velocity, &Particle::uncorrected_velocity);
    };
    const double normal_speed = dot(b.velocity - a.velocity, contact.normal);
    const double change = std::max(contact.target_speed - normal_speed, -contact.normal_change);
    contact.normal_change += change;
    accelerate(contact.normal * change);
    // Coulomb's law for the change of velocity alone: friction has acted on the correction of positions already.
    const Vec3 relative = b.velocity - a.velocity,
               tangential = relative - contact.normal * dot(relative, contact.normal);
    const double speed = length(tangential), most = contact.friction * contact.normal_change - contact.friction_change;
    if (speed == 0 || most <= 0) return;
    const double held = std::min(speed, most);
    contact.friction_change += held;
    accelerate(tangential * (-held / speed));
}

/// Calls visit(particle, displacement) for the particles that contacts have moved.
template <class Particle, class Visit>
void each_moved(const Particle* first, const Particle* end, Visit&& visit) {
    for (const Particle* p = first; p != end; ++p) {
        if (p->inverse_mass > 0 && p->at != p->uncorrected) visit(p->number, p->at - p->uncorrected);
    }
}

/// For particles of a body whose constraints are solved afterwards: corrects their predicted positions.
template <class Particle>
void correct_predicted(const Particle* first, const Particle* end, Body& body) {
    each_moved(first, end, [&](uint32_t p, Vec3 displacement) {
        if (is_graph(body)) {
            float* const at = &body.cloth.state.at[4 * size_t{p}];
            put(at, get(at) + displacement);
            return;
        }
        body.particles.position[p] += displacement;
        body.history.predicted[p] += displacement;
        if (body.plan.limited) body.rope.slack[p] = 0;
    });
}

/// For particles at the end of their substep: corrects their positions as far as the models allow.
template <class Particle>
void correct_moved(const Particle* first, const Particle* end, Body& body, const CollisionContext& around,
                   double bounce_threshold) {
    if (is_graph(body)) {
        each_moved(first, end, [&](uint32_t p, Vec3 displacement) {
            float* const at = &body.cloth.state.at[4 * size_t{p}];
            put(at, get(at) + displacement);
            if (collides(body, around)) push_out_of_planes(body.cloth.contacts, body.cloth.state, p);
        });
        return;
    }
    double longest = 0;
    each_moved(first, end,
               [&](uint32_t, Vec3 displacement) { longest = std::max(longest, length_squared(displacement)); });
    if (longest > 0 && collides(body, around)) {
        const Collider collider(around, body,
                                swept_box(body, body.particles.position, body.particles.position, std::sqrt(longest)));
        if (!collider.idle()) {
            each_moved(first, end, [&](uint32_t p, Vec3 displacement) {
                collider.slide(body, p, body.particles.position[p], displacement, around.end, bounce_threshold);
            });
            return;
        }
    }
    each_moved(first, end, [&](uint32_t p, Vec3 displacement) {
        body.particles.position[p] += displacement;
        keep_in_range(body.particles.position[p], body.particles.velocity[p]);
    });
}

}  // namespace

/// Calls visit(body, first, end) for the bodies of an island that collide with others, and their particles.
template <class Visit>
void ParticleContacts::each_body(const Island& island, Vector<Body>& bodies, const uint32_t* slots, Visit&& visit) {
    Particle* first = range(island).particles;
    for (uint32_t i = 0; i < island.body_count; ++i) {
        Body& body = bodies[slots[i]];
        if (!collides_with_others(body)) continue;
        visit(body, first, first + body.particles.size());
        first += body.particles.size();
    }
}

/// For pairs of different bodies that have been separated in this substep: adds `change` of their contact, times
/// `rate`, to their impulse.
void ParticleContacts::add_impulses(const Range& range, double Contact::*change, double rate) const {
    Pair* pair = range.pairs;
    for (uint32_t i = 0; i < *range.contact_count; ++i) {
        const Contact& contact = range.contacts[i];
        const Particle &a = range.particles[contact.a], &b = range.particles[contact.b];
        // Contacts are in the order of the pairs.
        while (pair->a != contact.a || pair->b != contact.b) ++pair;
        if (!(contact.separation > 0) || a.body == b.body) continue;
        if (pair->listed == IslandContacts::none)
            pair->listed = range.listed.add({a.id, a.number, b.id, b.number, {}, 0});
        if (pair->listed == IslandContacts::none) continue;
        BodyContact& listed = range.listed[pair->listed];
        listed.normal = narrow(contact.normal);
        const double more = contact.*change * rate / (a.inverse_mass + b.inverse_mass);
        if (more > 0) listed.impulse = to_float(static_cast<double>(listed.impulse) + more);
    }
}

ParticleContacts::Found ParticleContacts::solve_contacts(const Island& island, const Vector<Body>& bodies,
                                                         double bounce_threshold, double h) {
    const Range range = this->range(island);
    gather(range, bodies);
    if (!list_is_valid(range)) find_pairs(range, bodies);
    const bool any_deep = find_contacts(range, bodies, bounce_threshold, h);
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        for (uint32_t i = 0; i < *range.contact_count; ++i) {
            Contact& contact = range.contacts[i];
            solve_position(contact, range.particles[contact.a], range.particles[contact.b]);
        }
    }
    return {*range.contact_count > 0, any_deep};
}

void ParticleContacts::solve_positions(const Island& island, Vector<Body>& bodies, const uint32_t* slots,
                                       const CollisionContext& around, Vec3 gravity, double h) {
    const double bounce_threshold = find_bounce_threshold(gravity, h);
    const Found contacts = solve_contacts(island, bodies, bounce_threshold, h);
    const Range range = this->range(island);
    // Separating deep pairs changes no velocity, so it transfers no impulse.
    if (contacts.any) add_impulses(range, &Contact::separation, contacts.deep ? 0 : 1 / h);
    for (uint32_t i = 0; i < *range.pair_count; ++i) {
        for (const uint32_t p : {range.pairs[i].a, range.pairs[i].b})
            bodies[range.particles[p].body].contacts.near = true;
    }
    each_body(island, bodies, slots, [&](Body& body, const Particle* first, const Particle* end) {
        if (body.contacts.near) body.cloth.balance.closed = false;  // others do work
        if (!contacts.any) return;
        if (!moves_freely(body)) {
            correct_predicted(first, end, body);
            return;
        }
        // If many pairs overlap deeply, the correction changes no velocities, because it would give the particles high
        // speeds. Approaching pairs are stopped by solve_velocities.
        if (!contacts.deep)
            each_moved(first, end, [&](uint32_t p, Vec3 change) { body.particles.velocity[p] += change / h; });
        correct_moved(first, end, body, around, bounce_threshold);
    });
}

void ParticleContacts::solve_velocities(const Island& island, Vector<Body>& bodies, const uint32_t* slots) {
    const Range range = this->range(island);
    for (uint32_t i = 0; i < range.count; ++i) {
        Particle& p = range.particles[i];
        p.velocity = p.uncorrected_velocity = velocity_of(bodies[p.body], p.number);
    }
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        for (uint32_t i = 0; i < *range.contact_count; ++i) {
            Contact& contact = range.contacts[i];
            solve_velocity(contact, range.particles[contact.a], range.particles[contact.b]);
        }
    }
    add_impulses(range, &Contact::normal_change, 1);
    each_body(island, bodies, slots, [&](Body& body, const Particle* first, const Particle* end) {
        for (const Particle* p = first; p != end; ++p) {
            if (p->velocity == p->uncorrected_velocity) continue;
            if (is_graph(body)) {
                put(&body.cloth.state.velocity[4 * size_t{p->number}], p->velocity);
            } else {
                body.particles.velocity[p->number] = p->velocity;
            }
        }
        if (!body.contacts.near) return;
        // Motion with contacts is not smooth, so the time scheme must not use its history.
        body.contacts.near = false;
        body.contacts.has_contact = true;
        body.history.earlier_step = 0;
    });
}

void ParticleContacts::solve_final_positions(const Island& island, Vector<Body>& bodies, const uint32_t* slots,
                                             const CollisionContext& around, Vec3 gravity, double h) {
    const double bounce_threshold = find_bounce_threshold(gravity, h);
    if (!solve_contacts(island, bodies, bounce_threshold, h).any) return;
    each_body(island, bodies, slots, [&](Body& body, const Particle* first, const Particle* end) {
        if (!moves_freely(body)) correct_moved(first, end, body, around, bounce_threshold);
    });
}

}  // namespace gphys
