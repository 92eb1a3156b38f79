// Tears cloth at a particle, and removes other broken links (tear.h).
//
// The links of the particle follow the surface. An edge between the two sides is doubled, with the same rest length and
// compliance. A link that is no edge follows the triangles that it crosses. Links from one side to the other across the
// particle, which resisted bending and shear there, are removed.
#include "solver/tearing/tear.h"

#include "solver/body.h"
#include "solver/state.h"

namespace gphys {
namespace {

// Marks of particles, while one of them parts.
constexpr uint8_t keeps = 1, parts = 2;  // a corner of a triangle that keeps the particle, that gets its copy
constexpr uint8_t touched = 4;           // in the neighbourhood of a break, until the end of the step
// Of triangles: on the side of the broken link.
constexpr uint8_t beside = 1;
// A particle parts into masses of at least this, so that snapshots of them are valid.
constexpr double least_part = 1e-40;
/// Links that one tear adds at most: those along the cut that both sides have. Others stay with the particle.
constexpr uint32_t most_new_links = 8;

/// The items of a particle.
struct Listed {
    const uint32_t *first, *last;

    const uint32_t* begin() const { return first; }
    const uint32_t* end() const { return last; }
};
Listed listed(const Vector<uint32_t>& begin, const Vector<uint32_t>& at, uint32_t particle) {
    return {at.data() + begin[particle], at.data() + begin[particle + 1]};
}

/// Counting sort: each(visit) calls visit(particle, item). Uses reserved memory.
template <class Each>
void list_by_particle(Vector<uint32_t>& begin, Vector<uint32_t>& at, uint32_t particles, const Each& each) {
    begin.assign(particles + size_t{1}, 0);
    each([&](uint32_t particle, uint32_t) { ++begin[particle]; });
    uint32_t end = 0;
    for (uint32_t p = 0; p <= particles; ++p) begin[p] = end += begin[p];
    at.resize(end);
    each([&](uint32_t particle, uint32_t item) { at[--begin[particle]] = item; });
}

/// The last items first, so that those of each particle end in ascending order.
template <class Visit>
void each_link_end(const Constraints& constraints, Visit&& visit) {
    for (uint32_t slot = constraints.ids.slots(); slot-- > 0;) {
        if (!constraints.ids.live(slot)) continue;
        visit(constraints.by_slot[slot].a, slot);
        visit(constraints.by_slot[slot].b, slot);
    }
}
template <class Visit>
void each_corner(const Vector<uint32_t>& triangles, Visit&& visit) {
    for (size_t t = triangles.size() / 3; t-- > 0;) {
        const uint32_t a = triangles[3 * t], b = triangles[3 * t + 1], c = triangles[3 * t + 2];
        visit(a, static_cast<uint32_t>(t));
        if (b != a) visit(b, static_cast<uint32_t>(t));
        if (c != a && c != b) visit(c, static_cast<uint32_t>(t));
    }
}

/// Calls visit(array, elements per particle, whether a step may fill it) for all arrays by particle that last from step
/// to step, except those of ClothState.
template <class Visit>
void each_particle_array(Body& body, Visit&& visit) {
    Particles& particles = body.particles;
    for (Vector<Vec3>* values : {&particles.position, &particles.velocity, &particles.force, &body.history.start,
                                 &body.history.start_velocity, &body.history.earlier, &body.history.earlier_velocity}) {
        visit(*values, 1, true);
    }
    for (Vector<double>* values : {&particles.mass, &particles.inverse_mass, &particles.radius}) {
        visit(*values, 1, true);
    }
    visit(body.constraints.links, 1, true);
    visit(body.contacts.points, contact_points_per_particle, true);
    visit(body.contacts.point_count, 1, true);
    visit(body.contacts.stuck, 1, true);
    visit(body.cloth.cache.search_balls, 4, true);
    visit(body.contacts.friction_factor, 1, false);
    visit(body.contacts.self.placed, 1, false);
    visit(body.air.velocity, 1, false);
    visit(body.targets.all, 1, false);
}

/// Capacity for that many elements, so that adding some now and then does not take quadratic time.
template <class T>
void reserve_in_all(Vector<T>& values, size_t count) {
    if (count > values.capacity()) values.reserve(std::max(count, values.capacity() + values.capacity() / 2));
}

}  // namespace

bool reserve_tears(Body& body, uint32_t count) {
    const uint32_t particles = body.particles.size();
    Constraints& constraints = body.constraints;
    if (count > IdTable::capacity - particles || !constraints.ids.reserve(most_new_links * count)) return false;
    each_particle_array(body, [&](auto& values, uint32_t of_each, bool filled_by_steps) {
        if (filled_by_steps || !values.empty()) reserve_in_all(values, of_each * (size_t{particles} + count));
    });
    const size_t floats = cloth_floats(particles + count, body.cloth.batches.spare);
    for (Vector<float>* values : {&body.cloth.state.moved, &body.cloth.state.velocity_before}) {
        reserve_in_all(*values, floats);
    }
    const size_t slots = constraints.ids.slots() + size_t{most_new_links} * count;
    reserve_in_all(constraints.by_slot, slots);
    if (body.breaking.possible()) reserve_in_all(body.breaking.force, slots);
    reserve_plan_edits(body);
    TearSpace& space = body.breaking.space;
    const size_t corners = body.cloth.sheet.triangles.size();
    reserve_in_all(space.link_begin, particles + size_t{1});
    reserve_in_all(space.links, 2 * slots);
    reserve_in_all(space.triangle_begin, particles + size_t{1});
    reserve_in_all(space.triangles, corners);
    reserve_in_all(space.spokes, corners);
    reserve_in_all(space.parting, corners / 3);
    reserve_in_all(space.sides, corners / 3);
    reserve_in_all(space.marks, particles + size_t{count});
    reserve_in_all(space.remaining, particles + size_t{count});
    return true;
}

Tearing::Tearing(Body& body) : body_(body), space_(body.breaking.space), listed_(body.particles.size()) {
    list_by_particle(space_.link_begin, space_.links, listed_,
                     [&](auto&& visit) { each_link_end(body.constraints, visit); });
    list_by_particle(space_.triangle_begin, space_.triangles, listed_,
                     [&](auto&& visit) { each_corner(body.cloth.sheet.triangles, visit); });
    space_.sides.assign(body.cloth.sheet.triangles.size() / 3, 0);
    space_.marks.assign(listed_, 0);
}

bool Tearing::is_corner(uint32_t triangle, uint32_t particle) const noexcept {
    const uint32_t* const corner = &body_.cloth.sheet.triangles[size_t{3} * triangle];
    return corner[0] == particle || corner[1] == particle || corner[2] == particle;
}

/// Both must be in the lists.
bool Tearing::is_edge(uint32_t a, uint32_t b) const noexcept {
    const Listed around = listed(space_.triangle_begin, space_.triangles, a);
    return std::any_of(around.begin(), around.end(), [&](uint32_t t) { return is_corner(t, b); });
}

/// Divides the triangles around a particle by the plane through it that is normal to the direction to `from`. The
/// parting ones are on that side, and connected: those with `from` as a corner, and others up to the plane.
Tearing::Division Tearing::divide(uint32_t particle, uint32_t from) noexcept {
    const Vector<Vec3>& position = body_.particles.position;
    const Vector<uint32_t>& triangles = body_.cloth.sheet.triangles;
    const Listed around = listed(space_.triangle_begin, space_.triangles, particle);
    const Vec3 direction = position[from] - position[particle];
    double most = -infinity;
    space_.spokes.clear();
    space_.parting.clear();
    for (const uint32_t t : around) {
        Vec3 middle;  // from the particle; twice or once as far
        for (size_t corner = 3 * size_t{t}; corner < 3 * (size_t{t} + 1); ++corner) {
            if (triangles[corner] == particle) continue;
            space_.spokes.push_back({triangles[corner], t});
            middle += position[triangles[corner]] - position[particle];
        }
        const double length = gphys::length(middle), along = dot(middle, direction);
        if (!(along > 0)) continue;
        space_.sides[t] = beside;
        const double straight = is_corner(t, from) ? infinity : along / length;
        if (straight <= most) continue;
        most = straight;
        space_.parting.assign(1, t);
    }
    std::sort(space_.spokes.begin(), space_.spokes.end());
    // Breadth-first search, from triangle to triangle across their common edges.
    if (!space_.parting.empty()) space_.sides[space_.parting.front()] = 0;
    for (size_t i = 0; i < space_.parting.size(); ++i) {
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t corner = triangles[size_t{3} * space_.parting[i] + k];
            auto spoke = std::lower_bound(space_.spokes.begin(), space_.spokes.end(), Spoke{corner, 0});
            for (; spoke != space_.spokes.end() && spoke->corner == corner; ++spoke) {
                if (space_.sides[spoke->triangle] != beside) continue;
                space_.sides[spoke->triangle] = 0;
                space_.parting.push_back(spoke->triangle);
            }
        }
    }
    for (const uint32_t t : around) space_.sides[t] = 0;
    Division division;
    division.particle = particle;
    division.parting = static_cast<uint32_t>(space_.parting.size());
    division.all = static_cast<uint32_t>(around.last - around.first);
    division.possible = division.parting > 0 && division.parting < division.all &&
                        body_.particles.mass[particle] / division.all >= least_part;
    division.pinned = body_.particles.pinned(particle);
    division.interior = true;
    for (size_t i = 0; i < space_.spokes.size(); ++i) {
        const uint32_t corner = space_.spokes[i].corner;
        const bool shared = (i > 0 && space_.spokes[i - 1].corner == corner) ||
                            (i + 1 < space_.spokes.size() && space_.spokes[i + 1].corner == corner);
        division.interior = division.interior && shared;
    }
    return division;
}

/// A copy of a particle at its place, with the mass and the force of the parting triangles. It is free.
uint32_t Tearing::copy_particle(const Division& division) noexcept {
    Particles& particles = body_.particles;
    const uint32_t from = division.particle, copy = particles.size();
    each_particle_array(body_, [&](auto& values, uint32_t of_each, bool) {
        if (values.empty()) return;
        for (uint32_t i = 0; i < of_each; ++i) values.push_back(values[size_t{of_each} * from + i]);
    });
    for (Vector<float>* values : {&body_.cloth.state.moved, &body_.cloth.state.velocity_before}) {
        if (values->empty()) continue;
        values->resize(cloth_floats(copy + 1, body_.cloth.batches.spare));
        std::copy_n(&(*values)[size_t{4} * from], 4, &(*values)[size_t{4} * copy]);
    }
    body_.constraints.links[copy] = {};
    const double share = static_cast<double>(division.parting) / division.all;
    particles.mass[copy] = particles.mass[from] * share;
    particles.mass[from] -= particles.mass[copy];
    particles.force[copy] = particles.force[from] * share;
    particles.force[from] = particles.force[from] - particles.force[copy];
    if (!particles.pinned(from)) particles.inverse_mass[from] = 1 / particles.mass[from];
    particles.inverse_mass[copy] = 1 / particles.mass[copy];
    if (!body_.targets.empty() && body_.targets.all[copy].max_distance == 0) body_.targets.all[copy] = {};
    space_.marks.push_back(touched);
    return copy;
}

/// The side, as marks of both or of none, whose triangles around the particle are next to `far`. A triangle that has an
/// edge in common with one of `far` counts more than one that has a corner in common with its neighbours.
uint8_t Tearing::side_of(uint32_t particle, uint32_t far) const noexcept {
    int best[2] = {0, 0};
    for (const uint32_t t : listed(space_.triangle_begin, space_.triangles, particle)) {
        const uint32_t* const corner = &body_.cloth.sheet.triangles[size_t{3} * t];
        int common = 0;
        for (const uint32_t other : listed(space_.triangle_begin, space_.triangles, far)) {
            int corners = 0;
            for (int k = 0; k < 3; ++k) corners += corner[k] != particle && is_corner(other, corner[k]);
            common = std::max(common, corners);
        }
        int& of_side = best[space_.sides[t]];
        of_side = std::max(of_side, common);
    }
    if (best[0] == best[1]) return best[0] > 0 ? keeps | parts : 0;
    return best[0] > best[1] ? keeps : parts;
}

void Tearing::share_links(uint32_t particle, uint32_t copy) noexcept {
    Constraints& constraints = body_.constraints;
    uint32_t added = 0;
    for (const uint32_t slot : listed(space_.link_begin, space_.links, particle)) {
        const uint32_t far = other_end(constraints.by_slot[slot], particle);
        uint8_t side = space_.marks[far] & (keeps | parts);
        if (side == 0) side = side_of(particle, far);
        if (side == parts) replace_end(body_, slot, particle, copy);
        if (side == (keeps | parts) && added < most_new_links) {
            DistanceConstraint doubled = constraints.by_slot[slot];
            (doubled.a == particle ? doubled.a : doubled.b) = copy;
            const uint32_t copied = insert_constraint(body_, doubled, can_add_to_plan(body_));
            if (body_.breaking.possible()) body_.breaking.force[copied] = body_.breaking.force[slot];
            ++added;
        }
        space_.marks[far] |= touched;
    }
    for (const Spoke& spoke : space_.spokes) {
        if ((space_.marks[spoke.corner] & (keeps | parts)) != keeps) continue;
        for (const uint32_t slot : listed(space_.link_begin, space_.links, spoke.corner)) {
            if (!constraints.ids.live(slot)) continue;
            const uint32_t far = other_end(constraints.by_slot[slot], spoke.corner);
            if ((space_.marks[far] & (keeps | parts)) == parts && !is_edge(spoke.corner, far))
                erase_constraint(body_, slot, can_add_to_plan(body_));
        }
    }
}

void Tearing::part(const Division& division, gphys_break& out) noexcept {
    const uint32_t particle = division.particle;
    Vector<uint32_t>& triangles = body_.cloth.sheet.triangles;
    for (const uint32_t t : space_.parting) space_.sides[t] = beside;
    for (const Spoke& spoke : space_.spokes) {
        space_.marks[spoke.corner] |= space_.sides[spoke.triangle] == beside ? parts : keeps;
    }
    const uint32_t copy = copy_particle(division);
    share_links(particle, copy);
    for (const Spoke& spoke : space_.spokes) {
        space_.marks[spoke.corner] = touched;
        space_.sides[spoke.triangle] = 0;
    }
    space_.marks[particle] = touched;
    for (const uint32_t t : space_.parting) {
        std::replace(&triangles[size_t{3} * t], &triangles[size_t{3} * t] + 3, particle, copy);
    }
    out.torn_particle = particle;
    out.new_particle = copy;
}

bool Tearing::break_link(uint32_t slot, gphys_break& out) noexcept {
    const DistanceConstraint link = body_.constraints.by_slot[slot];
    out.constraint = body_.constraints.ids.id(slot);
    out.particle_a = link.a;
    out.particle_b = link.b;
    out.torn_particle = out.new_particle = GPHYS_NO_PARTICLE;
    if (std::max(link.a, link.b) >= listed_) return false;
    const auto is_touched = [&](uint32_t particle) { return (space_.marks[particle] & touched) != 0; };
    Division best;
    for (const uint32_t end : {link.a, link.b}) {
        if (is_touched(end)) continue;
        const Division division = divide(end, other_end(link, end));
        if (division.is_better(best)) best = division;
    }
    if (best.possible) {
        part(divide(best.particle, other_end(link, best.particle)), out);
        return true;
    }
    if (is_touched(link.a) || is_touched(link.b) || is_edge(link.a, link.b)) return false;
    erase_constraint(body_, slot, can_add_to_plan(body_));
    space_.marks[link.a] = space_.marks[link.b] = touched;
    return true;
}

void Tearing::finish() noexcept {
    body_.cloth.cache.current = false;  // the contact planes of the copies are unknown
    body_.cloth.sheet.rest_position.clear();
    if (body_.particles.size() > listed_) body_.cloth.volume.held = false;
    body_.contacts.self.linked_begin.clear();
    body_.plan.reach_current = false;
    if (is_graph(body_) && method_of(body_, space_.remaining) == GPHYS_SOLVE_GRAPH) return;
    body_.plan.chains_current = false;
    interrupt(body_);
}

}  // namespace gphys
