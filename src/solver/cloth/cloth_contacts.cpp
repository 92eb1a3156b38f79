#include "solver/cloth/cloth_contacts.h"

#include "solver/contact/collision.h"

namespace gphys {
namespace {

// Parts of models that a particle looks at; where a ball holds more it is made smaller.
constexpr uint32_t most_parts = 64;

Vec3 get(const float* from) { return {from[0], from[1], from[2]}; }
void put(float* to, Vec3 v) {
    for (int k = 0; k < 3; ++k) to[k] = static_cast<float>(v[k]);
}

/// How far cloth stays off: as `skin`, and 2^-21 of its coordinates, which is 4 times the rounding of
/// float32.
double clearance(const Body& body, uint32_t p, Vec3 at) {
    return skin(body.radius[p], body.cloth.origin + at) + 0x1p-21 * max_component(abs(at));
}

/// What a particle has given to the model that it touched last.
void hand_over(Neighbour& n, Body& body, const Surroundings& around) {
    if (n.getting == 0) return;
    const double mass = body.cloth.average_mass * body.cloth.mass[4 * size_t{n.particle}];
    give(body, around, n.getting, body.cloth.origin, n.given * mass, n.turning * mass);
    n.getting = 0;
    n.given = n.turning = {};
}

class Lookout {
public:
    Lookout(const Surroundings& around, Body& body, double step_length)
        : around_(around), body_(body), step_length_(step_length) {}

    /// Find the ball and the walls of a particle, which is pushed out of what it is in.
    void look(uint32_t p, Vec3 gravity) {
        ClothContacts& contacts = body_.cloth_contacts;
        float* at = &body_.cloth.at[4 * size_t{p}];
        const Vec3 velocity = get(&body_.cloth.velocity[4 * size_t{p}]);
        const double radius = body_.radius[p];
        // As far as it comes in a step, and half as far again; but no further than to its neighbours, which a
        // step seldom takes it, so that few parts are near.
        double reach = std::min(1.5 * step_length_ * (length(velocity) + step_length_ * length(gravity)),
                                std::max(body_.cloth.link_length, radius));
        Neighbour found{};
        found.particle = p;
        uint32_t count = 0;
        for (int halvings = 0; halvings < 4; ++halvings, reach /= 2) {
            count = collect(body_.cloth.origin + get(at), radius + reach);
            if (count <= most_parts) break;
        }
        if (count > most_parts) {  // on a mesh much finer than the particle: it is swept in each substep
            count = most_parts;
            reach = 0;
        }
        if (moves_beside(body_.cloth.origin + get(at), radius + reach)) reach = 0;
        choose_walls(p, get(at), count, reach, found);
        for (uint32_t i = 0; i < found.wall_count; ++i) {
            const double depth = found.walls[i].offset - dot(found.walls[i].normal, get(at));
            if (depth > 0) put(at, get(at) + found.walls[i].normal * depth);
        }
        float* ball = &contacts.balls[4 * size_t{p}];
        put(ball, get(at));
        ball[3] = static_cast<float>(reach * reach);
        uint32_t& place = contacts.place[p];
        if (found.wall_count == 0 && place == ClothContacts::nowhere) return;
        if (place == ClothContacts::nowhere) {
            place = static_cast<uint32_t>(contacts.neighbours.size());
            contacts.neighbours.push_back(found);
        } else {
            record_touches(contacts.neighbours[place]);
            contacts.neighbours[place] = found;
        }
    }

    void record_touches(Neighbour& n) {
        hand_over(n, body_, around_);
        const Vec3 at = body_.cloth.origin + get(&body_.cloth.at[4 * size_t{n.particle}]);
        for (uint32_t i = 0; i < n.wall_count; ++i) {
            const Wall& wall = n.walls[i];
            if (n.touched >> i & 1) {
                record_touch(body_, n.particle, *around_.scene, wall.model, at - wall.normal * body_.radius[n.particle],
                             wall.normal);
            }
        }
    }

private:
    bool find_moved(gphys_model_id model) const {
        return std::binary_search(around_.moved->begin(), around_.moved->end(), PlacedModel{model, {}});
    }

    /// Whether a model that moves in this step may come near: then there is no ball, and the particle is
    /// swept in each substep.
    bool moves_beside(Vec3 at, double reach) const {
        for (const PlacedModel& before : *around_.moved) {
            if (!(around_.scene->layers(before.model) & body_.settings.layers)) continue;
            Box box;
            if (!around_.scene->bounds(before.model, box)) return true;
            // As seen from the model the particle comes from here; on an arc, if it turns.
            const Vec3 from = around_.scene->world_transform(before.model).apply(widen(before.world).inverse_apply(at));
            const double room = reach + distance(from, at);
            if (touch(box, bounds(Sphere{at, room}))) return true;
        }
        return false;
    }

    uint32_t collect(Vec3 at, double reach) {
        uint32_t count = 0;
        around_.scene->for_each_in_box(bounds(Sphere{at, reach}), body_.settings.layers, [&](gphys_model_id model) {
            if (find_moved(model)) return;
            const uint32_t room = count < most_parts ? most_parts - count : 0;
            const uint32_t more = around_.scene->parts_near(model, at, reach, parts_ + (most_parts - room), room);
            for (uint32_t i = 0; i < std::min(more, room); ++i) models_[count + i] = model;
            count += more;
        });
        return count;
    }

    /// Nearest first. Leaves parts out that are behind the wall of a nearer one; those for which there
    /// is no room limit the reach.
    void choose_walls(uint32_t p, Vec3 at, uint32_t count, double& reach, Neighbour& found) {
        for (uint32_t i = 0; i < count; ++i) order_[i] = i;
        std::sort(order_, order_ + count, [&](uint32_t a, uint32_t b) {
            const double da = parts_[a].signed_distance, db = parts_[b].signed_distance;
            return da != db ? da < db : a < b;
        });
        const double radius = body_.radius[p], off = radius + clearance(body_, p, at);
        for (uint32_t i = 0; i < count; ++i) {
            const NearPart& part = parts_[order_[i]];
            if (is_behind(part, off, found)) continue;
            if (found.wall_count == Neighbour::most_walls) {
                reach = std::max(0.0, std::min(reach, part.signed_distance - off));
                return;
            }
            Wall& wall = found.walls[found.wall_count++];
            wall.normal = part.normal;
            wall.offset = dot(part.normal, part.closest - body_.cloth.origin) + off;
            wall.model = models_[order_[i]];
        }
    }

    bool is_behind(const NearPart& part, double off, const Neighbour& found) const {
        if (!part.is_triangle) return false;
        for (uint32_t i = 0; i < found.wall_count; ++i) {
            const Wall& wall = found.walls[i];
            // Coplanar triangles share a wall: half of the clearance, or of the radius and it, is room
            // for their rounding.
            const double height = wall.offset - off + (off - body_.radius[found.particle]) / 2;
            const auto below = [&](Vec3 corner) { return dot(wall.normal, corner - body_.cloth.origin) <= height; };
            if (below(part.triangle.a) && below(part.triangle.b) && below(part.triangle.c)) return true;
        }
        return false;
    }

    const Surroundings& around_;
    Body& body_;
    double step_length_;
    NearPart parts_[most_parts];
    gphys_model_id models_[most_parts];
    uint32_t order_[most_parts];
};

/// The wall that the place is most deep in, or nearest to.
uint32_t deepest(const Neighbour& n, Vec3 at, double& depth) {
    uint32_t best = 0;
    depth = -infinity;
    for (uint32_t i = 0; i < n.wall_count; ++i) {
        const double d = n.walls[i].offset - dot(n.walls[i].normal, at);
        if (d > depth) depth = d, best = i;
    }
    return best;
}

/// Out of all walls; those that move it are noted.
void push_out(Neighbour& n, float* at) {
    // Twice, as the second wall may push it into the first.
    for (int pass = 0; pass < 2; ++pass) {
        for (uint32_t i = 0; i < n.wall_count; ++i) {
            const double depth = n.walls[i].offset - dot(n.walls[i].normal, get(at));
            if (depth <= 0) continue;
            put(at, get(at) + n.walls[i].normal * depth);
            n.pressed += depth;
            n.touched |= 1u << i;
            if (n.touching < 0) n.touching = static_cast<int32_t>(i);
        }
        if (n.wall_count == 1) return;
    }
}

}  // namespace

void reserve_cloth_contacts(Body& body) {
    ClothContacts& contacts = body.cloth_contacts;
    contacts.neighbours.reserve(body.size());
    contacts.escaped.resize(body.size());
    contacts.place.resize(body.size());
    for (Vector<float>* values : {&contacts.balls, &contacts.normals, &contacts.pulls}) {
        values->resize(body.cloth.at.size());
    }
}

void look_around_cloth(Body& body, const Surroundings& around, Vec3 gravity) {
    ClothContacts& contacts = body.cloth_contacts;
    contacts.neighbours.clear();
    std::fill(contacts.place.begin(), contacts.place.end(), ClothContacts::nowhere);
    std::fill(contacts.normals.begin(), contacts.normals.end(), 0.0f);
    Lookout lookout(around, body, around.step_time);
    for (uint32_t p = 0; p < body.size(); ++p) {
        if (!body.pinned(p)) lookout.look(p, gravity);
    }
}

void touch_walls(Body& body, Vec3 gravity, const TimeScheme& scheme) {
    ClothState& cloth = body.cloth;
    const BodySettings& settings = body.settings;
    const double h = scheme.h, drag = scheme.drag(body.settings.damping);
    ClothContacts& contacts = body.cloth_contacts;
    contacts.touching = false;
    // What gravity moves a particle by in a substep is near enough to touch.
    const double near = length(gravity) * h * h;
    for (Neighbour& n : contacts.neighbours) {
        const size_t i = 4 * size_t{n.particle};
        float* at = &cloth.at[i];
        const Vec3 start = get(&cloth.start[i]), moved = get(at) - start;
        const double pressed_before = n.touching >= 0 ? n.total : 0;
        n.pressed = 0;
        n.total = 0;
        n.held = false;
        n.touching = -1;
        if (n.wall_count == 0) continue;
        n.coming = (scheme.from_history(get(&cloth.velocity[i]), get(&cloth.velocity_before[i])) +
                    get(&cloth.acceleration[i]) * h) *
                   drag;
        double depth;
        const uint32_t wall = deepest(n, get(at), depth);
        if (depth < -near) continue;
        contacts.touching = true;
        n.touching = static_cast<int32_t>(wall);
        n.touched |= 1u << wall;
        const Vec3 normal = n.walls[wall].normal;
        n.approach = -dot(moved, normal) / h;
        float* pull = &contacts.pulls[i];
        const Vec3 along = moved - normal * dot(moved, normal);
        // What links will add to the pressure is known from the substep before. To find out whether friction
        // holds the particle both count, as it is let go if not; but not to slow it by.
        const double presses = std::max(pressed_before, depth), may_hold = pressed_before + std::max(0.0, depth);
        n.still = settings.sticks() && rests(body, n.particle, get(&cloth.velocity[i]), gravity);
        const double hold = n.still             ? settings.static_friction * may_hold
                            : settings.sticks() ? settings.friction * presses
                                                : settings.friction * may_hold;
        const double way = length(along);
        if (settings.friction > 0 && way <= hold && !n.slipping) {
            n.held = true;
            n.inverse_mass = at[3];
            put(pull, moved / n.inverse_mass);
            n.first_pull = get(pull);
            put(at, start);
            at[3] = 0;
        } else {
            put(pull, {});
            n.first_pull = {};
            put(&contacts.normals[i], normal);
            n.slowed = std::min(way, settings.friction * presses);
            if (way > 0) put(at, get(at) - along * (n.slowed / way));
            n.slipping = false;
            push_out(n, at);
        }
    }
}

namespace {

/// A held particle is let go for the next substep if what pulls it leaves the cone of friction.
void try_to_hold(Neighbour& n, const ClothContacts& contacts, double friction) {
    const Vec3 normal = n.walls[n.touching].normal, pull = get(&contacts.pulls[4 * size_t{n.particle}]);
    const double off = dot(pull, normal);
    n.slipping = length(pull - normal * off) > friction * -off;
    n.total = std::max(0.0, -off) * n.inverse_mass;
}

void slow_down(Neighbour& n, const ClothContacts& contacts, double friction, Vec3 start, float* at) {
    const Vec3 normal = n.walls[n.touching].normal, moved = get(at) - start;
    const double pulled = std::max(0.0, -dot(get(&contacts.pulls[4 * size_t{n.particle}]), normal)) * at[3];
    n.total = n.pressed + pulled;
    const Vec3 along = moved - normal * dot(moved, normal);
    const double way = length(along), hold = friction * n.total - n.slowed;
    if (hold <= 0) return;
    put(at, way > hold ? get(at) - along * (hold / way) : start);
}

}  // namespace

void note_places(Body& body) {
    for (Neighbour& n : body.cloth_contacts.neighbours) n.chained = get(&body.cloth.at[4 * size_t{n.particle}]);
}

void leave_walls(Body& body) {
    ClothState& cloth = body.cloth;
    ClothContacts& contacts = body.cloth_contacts;
    const double friction = body.settings.friction;
    for (Neighbour& n : contacts.neighbours) {
        const size_t i = 4 * size_t{n.particle};
        float* at = &cloth.at[i];
        const Vec3 limited = get(at);
        const bool before = n.touching >= 0;
        if (n.held) {
            try_to_hold(n, contacts, n.still ? body.settings.static_friction : friction);
            at[3] = static_cast<float>(n.inverse_mass);
            if (!(get(at) == get(&cloth.start[i]))) push_out(n, at);  // a reach limit has moved it
        } else if (n.wall_count > 0) {
            push_out(n, at);
            if (!before && n.touching >= 0) put(&contacts.pulls[i], {}), n.approach = 0;
            if (n.touching >= 0) slow_down(n, contacts, friction, get(&cloth.start[i]), at);
            put(&contacts.normals[i], {});
        }
        contacts.touching = contacts.touching || n.touching >= 0;
        if (n.touching < 0) continue;
        // As metres: what chains and limits have moved it by, or what walls have.
        n.moved = before ? (get(&contacts.pulls[i]) - n.first_pull) * at[3] + (limited - n.chained) : limited - get(at);
        n.chained_touching = before;
    }
}

namespace {

/// What the particle has lost goes to the model that it touches.
void lose(Neighbour& n, Body& body, const Surroundings& around, Vec3 velocity) {
    const Wall& wall = n.walls[n.touching];
    if (n.getting != wall.model) {
        hand_over(n, body, around);
        n.getting = wall.model;
    }
    n.given += velocity;
    n.turning += cross(get(&body.cloth.at[4 * size_t{n.particle}]) - wall.normal * body.radius[n.particle], velocity);
}

}  // namespace

/// Links, limits and walls have changed a velocity from the predicted one; what walls did they get.
void count_contacts(Body& body, const Surroundings& around, double rate) {
    for (Neighbour& n : body.cloth_contacts.neighbours) {
        if (n.touching < 0) continue;
        const Vec3 velocity = get(&body.cloth.velocity[4 * size_t{n.particle}]);
        const Vec3 pulled = n.moved * rate;
        lose(n, body, around, n.chained_touching ? n.coming + pulled - velocity : pulled);
    }
}

void turn_velocities(Body& body, const Surroundings& around, double quiet) {
    ClothState& cloth = body.cloth;
    for (Neighbour& n : body.cloth_contacts.neighbours) {
        if (n.touching < 0) continue;
        const size_t i = 4 * size_t{n.particle};
        float* velocity = &cloth.velocity[i];
        if (get(&cloth.at[i]) == get(&cloth.start[i])) {
            lose(n, body, around, get(velocity));
            put(velocity, {});
            continue;
        }
        const Vec3 normal = n.walls[n.touching].normal;
        const double away = dot(get(velocity), normal);
        const double wanted = n.approach > quiet ? body.settings.restitution * n.approach : 0;
        if (away >= wanted) continue;
        lose(n, body, around, normal * (away - wanted));
        put(velocity, get(velocity) + normal * (wanted - away));
    }
}

void catch_escaped(Body& body, const Surroundings& around, Vec3 gravity, double h) {
    ClothState& cloth = body.cloth;
    ClothContacts& contacts = body.cloth_contacts;
    uint32_t count = 0;
    for (uint32_t p = 0; p < body.size(); ++p) {
        const float* ball = &contacts.balls[4 * size_t{p}];
        const float* at = &cloth.at[4 * size_t{p}];
        const float x = at[0] - ball[0], y = at[1] - ball[1], z = at[2] - ball[2];
        if (x * x + y * y + z * z >= ball[3] && !body.pinned(p)) contacts.escaped[count++] = p;
    }
    if (count == 0) return;
    Aabb all{body.position[contacts.escaped[0]], body.position[contacts.escaped[0]]};
    double longest = 0, radius = 0;
    all = {Vec3{infinity, infinity, infinity}, Vec3{-infinity, -infinity, -infinity}};
    for (uint32_t k = 0; k < count; ++k) {
        const uint32_t p = contacts.escaped[k];
        const size_t i = 4 * size_t{p};
        body.start[p] = cloth.origin + get(&cloth.start[i]);
        body.position[p] = cloth.origin + get(&cloth.at[i]);
        body.velocity[p] = get(&cloth.velocity[i]);
        all.min = min(all.min, min(body.start[p], body.position[p]));
        all.max = max(all.max, max(body.start[p], body.position[p]));
        longest = std::max(longest, length_squared(body.position[p] - body.start[p]));
        radius = std::max(radius, body.radius[p]);
    }
    const double room = 2 * radius + std::sqrt(longest);
    const Collider collider(around, body,
                            bounds(Aabb{all.min - Vec3{room, room, room}, all.max + Vec3{room, room, room}}));
    Lookout lookout(around, body, around.step_time * (1 - around.end) + h);
    for (uint32_t k = 0; k < count; ++k) {
        const uint32_t p = contacts.escaped[k];
        const size_t i = 4 * size_t{p};
        if (!collider.idle()) {
            body.held[p] = 0;
            const Vec3 at = body.position[p];
            collider.slide(body, p, body.start[p], at - body.start[p], quiet_speed(gravity, h));
            if (body.held[p]) {
                put(&cloth.at[i], body.position[p] - cloth.origin);
                put(&cloth.velocity[i], body.velocity[p]);
            }
        }
        lookout.look(p, gravity);
    }
}

void stay_outside(Body& body, uint32_t particle) {
    const uint32_t place = body.cloth_contacts.place[particle];
    if (place != ClothContacts::nowhere) {
        push_out(body.cloth_contacts.neighbours[place], &body.cloth.at[4 * size_t{particle}]);
    }
}

void record_touches(Body& body, const Surroundings& around) {
    Lookout lookout(around, body, around.step_time);
    for (Neighbour& n : body.cloth_contacts.neighbours) lookout.record_touches(n);
}

}  // namespace gphys
