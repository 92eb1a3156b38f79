// Adding and removing bodies. A body is complete before the solver takes it, so a failure leaves the solver unchanged.
#include "foundation/strided.h"
#include "mesh/mesh.h"
#include "solver/solver.h"

namespace gphys {
namespace {

BodyOwner make_body(gphys_body_kind kind, const gphys_body_desc& desc, uint32_t count,
                    std::pmr::memory_resource* memory) {
    BodyOwner made = new_body(memory);
    Body& body = *made;
    body.kind = kind;
    body.settings = {desc.damping, desc.friction, std::max(desc.friction, desc.static_friction), desc.restitution,
                     desc.layers};
    body.settings.body_layers = desc.body_layers;
    body.settings.self_collision = desc.self_collision;
    body.rope.bending.stiffness = desc.bending_stiffness;
    const double mass = static_cast<double>(desc.mass) / count;
    body.particles.position.resize(count);
    body.particles.velocity.resize(count);
    body.particles.force.resize(count);
    body.particles.mass.assign(count, mass);
    body.particles.inverse_mass.assign(count, 1 / mass);
    body.particles.radius.assign(count, desc.radius);
    body.constraints.links.resize(count);
    return made;
}

BodyOwner make_body(gphys_body_kind kind, const gphys_body_desc& desc, const gphys_vec3* positions, uint32_t stride,
                    uint32_t count, std::pmr::memory_resource* memory) {
    BodyOwner body = make_body(kind, desc, count, memory);
    const Strided<gphys_vec3> from(positions, stride);
    for (uint32_t p = 0; p < count; ++p) body->particles.position[p] = widen(from[p]);
    return body;
}

/// A rope or cloth has fewer than 2^24 constraints; otherwise add_constraint fails.
gphys_status link(Body& body, uint32_t a, uint32_t b, double compliance) {
    gphys_constraint_id ignored;
    return add_constraint(body, {a, b, -1, compliance, 0, 0}, ignored);
}

/// Call after all constraints were added.
void set_breaking_force(Body& body, const gphys_body_desc& desc) {
    if (desc.breaking_force > 0) body.breaking.force.assign(body.constraints.by_slot.size(), desc.breaking_force);
}

/// The number of edges that link_grid makes in a grid in the direction (du, dv).
uint64_t grid_edges(uint32_t columns, uint32_t rows, uint32_t du, uint32_t dv) {
    return uint64_t{columns - std::min(columns, du)} * (rows - std::min(rows, dv));
}

/// Links the edges of a grid in the direction (columns, rows) = (du, dv).
gphys_status link_grid(Body& body, uint32_t columns, uint32_t rows, uint32_t du, int dv, double compliance) {
    const uint32_t down = dv < 0 ? static_cast<uint32_t>(-dv) : 0, up = dv > 0 ? static_cast<uint32_t>(dv) : 0;
    for (uint32_t row = down; row + up < rows; ++row) {
        for (uint32_t column = 0; column + du < columns; ++column) {
            const uint32_t a = row * columns + column;
            GPHYS_TRY(link(body, a, a + du + up * columns - down * columns, compliance));
        }
    }
    return GPHYS_OK;
}

}  // namespace

gphys_status Solver::insert(BodyOwner body, gphys_body_id& out) {
    if (!state_.ids.reserve(1)) return fail(GPHYS_ERROR_CAPACITY, "the solver would have more than 2^24 - 1 bodies");
    state_.bodies.reserve_slot();
    if (body->settings.self_collision) body->contacts.self.placed = body->particles.position;
    out = state_.ids.add();
    state_.bodies.put(IdTable::slot_of(out), std::move(body));
    return GPHYS_OK;
}

gphys_status Solver::add_particles(const gphys_body_desc& desc, const gphys_vec3* positions, uint32_t stride,
                                   uint32_t count, gphys_body_id& out) {
    return insert(make_body(GPHYS_BODY_PARTICLES, desc, positions, stride, count, &memory), out);
}

gphys_status Solver::add_rope(const gphys_body_desc& desc, const gphys_vec3* positions, uint32_t stride, uint32_t count,
                              double link_length, gphys_body_id& out) {
    BodyOwner made = make_body(GPHYS_BODY_ROPE, desc, positions, stride, count, &memory);
    Body& body = *made;
    for (uint32_t p = 0; p + 1 < count; ++p) {
        gphys_constraint_id ignored;
        GPHYS_TRY(add_constraint(body, {p, p + 1, link_length > 0 ? link_length : -1, desc.compliance, 0, 0}, ignored));
    }
    set_breaking_force(body, desc);
    return insert(std::move(made), out);
}

gphys_status Solver::add_cloth(const gphys_body_desc& desc, Vec3 corner, Vec3 edge_u, Vec3 edge_v, uint32_t columns,
                               uint32_t rows, gphys_body_id& out) {
    // Checked before millions of particles are made in vain.
    const bool shears = desc.cloth_flags & GPHYS_CLOTH_SHEAR, bends = desc.cloth_flags & GPHYS_CLOTH_BEND;
    const uint64_t edges = grid_edges(columns, rows, 0, 1) + grid_edges(columns, rows, 1, 0) +
                           (shears ? 2 * grid_edges(columns, rows, 1, 1) : 0) +
                           (bends ? grid_edges(columns, rows, 0, 2) + grid_edges(columns, rows, 2, 0) : 0);
    if (edges > IdTable::capacity)
        return fail(GPHYS_ERROR_CAPACITY, "the body would have more than 2^24 - 1 constraints");

    BodyOwner made = make_body(GPHYS_BODY_CLOTH, desc, columns * rows, &memory);
    Body& body = *made;
    for (uint32_t row = 0; row < rows; ++row) {
        for (uint32_t column = 0; column < columns; ++column) {
            body.particles.position[row * columns + column] = corner +
                                                              edge_u * (static_cast<double>(column) / (columns - 1)) +
                                                              edge_v * (static_cast<double>(row) / (rows - 1));
        }
    }
    body.cloth.sheet.triangles.reserve(size_t{6} * (columns - 1) * (rows - 1));
    for (uint32_t row = 0; row + 1 < rows; ++row) {
        for (uint32_t column = 0; column + 1 < columns; ++column) {
            const uint32_t a = row * columns + column, b = a + 1, c = a + columns, d = c + 1;
            body.cloth.sheet.triangles.insert(body.cloth.sheet.triangles.end(), {a, b, c, c, b, d});
        }
    }

    struct Direction {
        uint32_t du;
        int dv;
        double compliance;
    };
    const double stretch = desc.compliance, bend = desc.bend_compliance;
    const double shear = desc.shear_compliance > 0 ? desc.shear_compliance : stretch;
    Vector<Direction> directions({{0, 1, stretch}, {1, 0, stretch}}, &memory);
    if (desc.cloth_flags & GPHYS_CLOTH_SHEAR) {
        directions.push_back({1, 1, shear});
        directions.push_back({1, -1, shear});
        // Both diagonals make each cell rigid in its plane, so no two particles can be farther apart than in the flat
        // sheet.
        if (shear == 0) body.cloth.sheet.rest_position = body.particles.position;
    }
    if (desc.cloth_flags & GPHYS_CLOTH_BEND) {
        directions.push_back({0, 2, bend});
        directions.push_back({2, 0, bend});
    }
    for (const Direction& d : directions) GPHYS_TRY(link_grid(body, columns, rows, d.du, d.dv, d.compliance));
    set_breaking_force(body, desc);
    return insert(std::move(made), out);
}

namespace {

/// An edge of a triangle, from the lower to the higher vertex, and the corner opposite to it.
struct Side3 {
    uint32_t low, high, opposite;

    bool operator<(const Side3& other) const {
        if (low != other.low) return low < other.low;
        return high != other.high ? high < other.high : opposite < other.opposite;
    }
};

}  // namespace

gphys_status Solver::add_cloth_mesh(const gphys_body_desc& desc, const Mesh& mesh, const Transform& placement,
                                    gphys_body_id& out) {
    const uint32_t count = static_cast<uint32_t>(mesh.vertices().size());
    BodyOwner made = make_body(GPHYS_BODY_CLOTH, desc, count, &memory);
    Body& body = *made;
    for (uint32_t p = 0; p < count; ++p) body.particles.position[p] = placement.apply(widen(mesh.vertices()[p]));
    body.cloth.sheet.triangles.assign(mesh.indices().begin(), mesh.indices().end());

    Vector<Side3> sides(&memory);
    sides.reserve(body.cloth.sheet.triangles.size());
    for (size_t i = 0; i < body.cloth.sheet.triangles.size(); i += 3) {
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t a = body.cloth.sheet.triangles[i + k], b = body.cloth.sheet.triangles[i + (k + 1) % 3];
            if (a != b) sides.push_back({std::min(a, b), std::max(a, b), body.cloth.sheet.triangles[i + (k + 2) % 3]});
        }
    }
    std::sort(sides.begin(), sides.end());
    const auto same_edge = [](const Side3& a, const Side3& b) { return a.low == b.low && a.high == b.high; };
    for (size_t i = 0; i < sides.size(); ++i) {
        if (i > 0 && same_edge(sides[i - 1], sides[i])) continue;
        GPHYS_TRY(link(body, sides[i].low, sides[i].high, desc.compliance));
    }
    if (desc.cloth_flags & GPHYS_CLOTH_BEND) {
        for (size_t i = 1; i < sides.size(); ++i) {
            if (!same_edge(sides[i - 1], sides[i]) || sides[i - 1].opposite == sides[i].opposite) continue;
            GPHYS_TRY(link(body, sides[i - 1].opposite, sides[i].opposite, desc.bend_compliance));
        }
    }
    set_breaking_force(body, desc);
    return insert(std::move(made), out);
}

gphys_status Solver::remove(gphys_body_id id) {
    GPHYS_TRY(check(id));
    meshes_.let_go(id);
    remove_joints_of(IdTable::slot_of(id));
    state_.ids.remove(id);
    const uint32_t slot = IdTable::slot_of(id);
    impulse_sums_.remove(slot, state_.bodies[slot].contacts.impulses);
    state_.bodies.remove(slot);
    return GPHYS_OK;
}

gphys_status Solver::check(gphys_body_id id) const {
    return state_.ids.has(id) ? GPHYS_OK : fail(GPHYS_ERROR_INVALID_ID, "body", id, "the id of a body of the solver");
}

void Solver::list(Smallest<gphys_body_id>& out) const {
    for (const uint32_t slot : state_.ids) out.add(state_.ids.id(slot));
}

}  // namespace gphys
