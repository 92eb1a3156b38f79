// Solves the contacts of rigid clusters (rigid_contacts.h).
#include "solver/contact/rigid_contacts.h"

#include "foundation/compiler.h"

namespace gphys {
namespace {

Vec3 shift_of(const ContactPartner& partner) {
    if (partner.cluster) return partner.cluster->shift;
    return partner.value ? *partner.value - *partner.uncorrected : Vec3{};
}

Vec3 turn_of(const ContactPartner& partner) { return partner.cluster ? partner.cluster->turn : Vec3{}; }

/// The motion of b relative to a, while the contacts of the two are solved.
class RelativeMotion {
public:
    explicit RelativeMotion(const ContactGroup& group)
        : linear_(shift_of(group.b) - shift_of(group.a)), turn_a_(turn_of(group.a)), turn_b_(turn_of(group.b)) {}
    GPHYS_INLINE Vec3 at(const ContactRow& row) const {
        return linear_ + cross(turn_b_, row.arm_b) - cross(turn_a_, row.arm_a);
    }

private:
    Vec3 linear_, turn_a_, turn_b_;
};

GPHYS_INLINE void add_impulse(ContactImpulse& sum, const ContactRow& row, Vec3 impulse) {
    sum.impulse += impulse;
    sum.about_a += cross(row.arm_a, impulse);
    sum.about_b += cross(row.arm_b, impulse);
}

void push(const ContactPartner& partner, Vec3 impulse, Vec3 moment) {
    if (partner.cluster && partner.cluster->response) {
        ContactCluster& cluster = *partner.cluster;
        cluster.displace(impulse, moment, cluster.shift, cluster.turn);
        cluster.response->impulse += impulse / cluster.mass_unit;
        cluster.response->angular_impulse += moment / cluster.mass_unit;
    } else if (partner.cluster) {
        partner.cluster->shift += impulse * partner.cluster->inverse_mass;
        partner.cluster->turn += partner.cluster->inverse_inertia * moment;
    } else if (partner.value) {
        *partner.value += impulse * partner.inverse_mass;
        if (!partner.supports) return;
        *partner.value = partner.supports->stop(*partner.value, *partner.uncorrected);
        *partner.value = partner.supports->hold(*partner.value, *partner.still);
    }
}

void push(const ContactGroup& group, const ContactImpulse& sum) {
    push(group.b, sum.impulse, sum.about_b);
    push(group.a, -sum.impulse, -sum.about_a);
}

/// What it is joined to moves with it.
void push_joined(const ContactPartner& partner, Vec3 impulse, Vec3 moment) {
    if (!partner.cluster || !partner.cluster->response || !partner.cluster->system) return;
    if (impulse == Vec3{} && moment == Vec3{}) return;
    const ContactCluster& cluster = *partner.cluster;
    cluster.system->add_impulse(*cluster.response, impulse / cluster.mass_unit, moment / cluster.mass_unit);
}

void push_joined(const ContactGroup& group, const ContactImpulse& sum) {
    push_joined(group.b, sum.impulse, sum.about_b);
    push_joined(group.a, -sum.impulse, -sum.about_a);
}

/// Where the impulses on all that it is joined to have moved it.
void follow_joined(const ContactPartner& partner) {
    if (!partner.cluster || !partner.cluster->response || !partner.cluster->system) return;
    ContactCluster& cluster = *partner.cluster;
    cluster.system->displacement(*cluster.response, cluster.shift, cluster.turn);
}

void follow_joined(const ContactGroup& group) {
    follow_joined(group.b);
    follow_joined(group.a);
}

bool are_joined(const ContactGroup& group) {
    const ContactCluster *const a = group.a.cluster, *const b = group.b.cluster;
    return a && b && a->response && b->response && a->response->system == b->response->system;
}

/// Whether what moves one of a group moves the other one, too.
bool move_together(const ContactGroup& group) { return are_joined(group) && group.a.cluster->system; }

/// The relative displacement of such two by a unit impulse, before there are others.
Vec3 moved_together(const ContactGroup& group, const ContactRow& row, Vec3 direction) {
    ContactImpulse unit;
    add_impulse(unit, row, direction);
    push_joined(group, unit);
    follow_joined(group);
    const Vec3 moved = RelativeMotion(group).at(row);
    group.a.cluster->system->begin_impulses();
    for (ContactCluster* cluster : {group.a.cluster, group.b.cluster}) cluster->shift = cluster->turn = {};
    return moved;
}

/// What unit impulses at a place move both of a group by, relative to each other: an impulse along s moves them along s
/// by ss, and along t by st.
struct InverseMasses {
    double ss = 0, tt = 0, st = 0;

    InverseMasses(const ContactGroup& group, const ContactRow& row, Vec3 s, Vec3 t) {
        add(group.b, row.arm_b, s, t);
        add(group.a, row.arm_a, s, t);
        if (!move_together(group)) return;
        const Vec3 by_s = moved_together(group, row, s), by_t = moved_together(group, row, t);
        ss = std::max(ss, dot(s, by_s));
        tt = std::max(tt, dot(t, by_t));
        st = dot(t, by_s);
    }
    double largest() const { return (ss + tt) / 2 + std::sqrt((ss - tt) * (ss - tt) / 4 + st * st); }

private:
    void add(const ContactPartner& partner, Vec3 arm, Vec3 s, Vec3 t) {
        if (!partner.cluster) {
            if (partner.supports) return;
            ss += partner.inverse_mass;
            tt += partner.inverse_mass;
            return;
        }
        const ContactCluster& cluster = *partner.cluster;
        if (cluster.response) {
            const Vec3 moved = cluster.displacement(arm, s);
            ss += dot(s, moved);
            tt += dot(t, cluster.displacement(arm, t));
            st += dot(t, moved);
            return;
        }
        const Vec3 by_s = cross(arm, s), by_t = cross(arm, t), turned = cluster.inverse_inertia * by_s;
        ss += cluster.inverse_mass + dot(by_s, turned);
        tt += cluster.inverse_mass + dot(by_t, cluster.inverse_inertia * by_t);
        st += dot(by_t, turned);
    }
};

double inverse_mass(const ContactPartner& partner, Vec3 arm, Vec3 direction) {
    if (!partner.cluster) return partner.supports ? 0 : partner.inverse_mass;
    if (partner.cluster->response) return dot(direction, partner.cluster->displacement(arm, direction));
    const Vec3 lever = cross(arm, direction);
    return partner.cluster->inverse_mass + dot(lever, partner.cluster->inverse_inertia * lever);
}

double inverse_mass(const ContactGroup& group, const ContactRow& row) {
    const double alone = inverse_mass(group.b, row.arm_b, row.normal) + inverse_mass(group.a, row.arm_a, row.normal);
    return move_together(group) ? std::max(alone, dot(row.normal, moved_together(group, row, row.normal))) : alone;
}

/// The largest one along the surface.
double inverse_mass_along(const ContactGroup& group, const ContactRow& row) {
    const Vec3 n = row.normal, other = std::fabs(n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, across = cross(n, other);
    const Vec3 s = across / length(across);
    return InverseMasses(group, row, s, cross(n, s)).largest();
}

/// Of a particle that models carry: its inverse mass, as far as they let it go. 0 for others.
double yielding_mass(const ContactPartner& partner, Vec3 direction) {
    if (!partner.supports) return 0;
    return partner.inverse_mass * std::max(0.0, dot(partner.supports->yielding(direction), direction));
}

/// Whether one of both is a particle that models carry.
bool is_carried(const ContactGroup& group) { return group.a.supports || group.b.supports; }

// What stops a light particle between a model and a cluster is much less than what lifts the cluster off one that
// sticks. The iteration finds it only from below: so the impulse grows at most by this factor in a sweep.
constexpr double growth_of_carried = 10;

/// The inverse mass of those that models carry, as if nothing held them.
double carried_mass(const ContactGroup& group) {
    return (group.a.supports ? group.a.inverse_mass : 0) + (group.b.supports ? group.b.inverse_mass : 0);
}

/// Of both, for an impulse on b.
double yielding_mass(const ContactGroup& group, Vec3 direction) {
    return yielding_mass(group.a, -direction) + yielding_mass(group.b, direction);
}

double yielding_mass_along(const ContactGroup& group, Vec3 slip) {
    const double size = group.a.supports || group.b.supports ? length(slip) : 0;
    return size > 0 ? yielding_mass(group, slip / -size) : 0;
}

// Contacts of two clusters in one system of joints may ask for what the joints do not allow, as of limbs that overlap
// where they are joined. Their impulses would grow without bound. So this part of the gap that an impulse would close
// without the other cluster may stay: of clusters at rest, a third of the way that gravity moves them in a substep.
constexpr double softness_of_joined = 0.3;

/// Changes the normal impulse of a row, of which `among` share the masses. Returns by how much it has changed the gap.
GPHYS_INLINE double change_normal(const ContactGroup& group, ContactRow& row, double moved, double among) {
    row.normal_change = 0;
    const double gap = row.gap + moved + row.softness * row.normal_impulse;
    if (row.normal_impulse == 0 && gap >= 0) return 0;
    const double yields = row.inverse_mass + row.softness + yielding_mass(group, row.normal);
    if (!(yields > 0)) return 0;
    double change = -gap / (yields * among);
    if (is_carried(group)) {
        const double alone = row.inverse_mass + carried_mass(group);
        change = std::min(change, growth_of_carried * row.normal_impulse - std::min(gap, 0.0) / alone);
    }
    row.normal_change = std::max(-row.normal_impulse, change);
    row.normal_impulse += row.normal_change;
    return std::fabs(row.normal_change) * yields;
}

/// Keeps friction within Coulomb's bound. Returns what that changes. Of particles that models carry this must not wait.
/// The friction of a heavy cluster would move a light one at any speed once the models no longer hold it.
Vec3 bound_friction(ContactRow& row) {
    const Vec3 before = row.friction_impulse;
    const double most = row.friction * row.normal_impulse, square = length_squared(before);
    if (square > most * most) row.friction_impulse *= most / std::sqrt(square);
    return row.friction_impulse - before;
}

/// The same for friction, within Coulomb's bound, by a row with this share of the masses. Returns the square of its
/// slip if it sticks, which all rows of the group close together, and of what it changes of that if it slides.
GPHYS_INLINE double change_friction(const ContactGroup& group, ContactRow& row, const RelativeMotion& motion,
                                    double share, Vec3& change) {
    if (row.friction == 0 || (row.normal_impulse == 0 && row.friction_impulse == Vec3{})) return 0;
    Vec3 slip = row.slip + motion.at(row);
    slip -= row.normal * dot(slip, row.normal);
    const double along = row.inverse_mass_along + yielding_mass_along(group, slip);
    Vec3 wanted = row.friction_impulse;
    if (along > 0) wanted -= slip * (share / along);
    const double most = row.friction * row.normal_impulse, square = length_squared(wanted);
    const bool slides = square > most * most;
    if (slides) wanted *= most / std::sqrt(square);
    change = wanted - row.friction_impulse;
    row.friction_impulse = wanted;
    return slides ? length_squared(change) * along * along : length_squared(slip);
}

/// Among how many the rows of a group share its masses, n: 1 for independent rows, their number if all are alike. A_ij
/// is what a unit impulse of row i moves row j by, over the root of the inverse masses of both. If each row changes by
/// 1 / n of what it alone needs, 1 - A / n is left of the gaps; this n makes the Frobenius norm of that least. Sweeps
/// over one group converge with it: A has at most six eigenvalues that are not 0, so the largest is below 1.8 n.
double among(const ContactGroup& group, const ContactRow* rows) {
    constexpr int size = 9;  // a force, and its moments about both centres
    if ((group.a.cluster && group.a.cluster->response) || (group.b.cluster && group.b.cluster->response))
        return group.count;
    double sums[size][size] = {};
    for (const ContactRow* row = rows; row != rows + group.count; ++row) {
        if (!(row->inverse_mass > 0)) return group.count;
        const Vec3 by_a = cross(row->arm_a, row->normal), by_b = cross(row->arm_b, row->normal), n = row->normal;
        const double force[size] = {n.x, n.y, n.z, by_a.x, by_a.y, by_a.z, by_b.x, by_b.y, by_b.z};
        for (int i = 0; i < size; ++i) {
            for (int k = 0; k < size; ++k) sums[i][k] += force[i] * force[k] / row->inverse_mass;
        }
    }
    // moved = inverse masses * sums
    const auto linear = [](const ContactPartner& partner) {
        if (partner.cluster) return partner.cluster->inverse_mass;
        return partner.supports ? 0 : partner.inverse_mass;
    };
    const auto angular = [](const ContactPartner& partner) {
        return partner.cluster ? partner.cluster->inverse_inertia : Mat3{{}, {}, {}};
    };
    const double mass = linear(group.a) + linear(group.b);
    const Mat3 of_a = angular(group.a), of_b = angular(group.b);
    double moved[size][size];
    for (int k = 0; k < size; ++k) {
        const Vec3 a = of_a * Vec3{sums[3][k], sums[4][k], sums[5][k]},
                   b = of_b * Vec3{sums[6][k], sums[7][k], sums[8][k]};
        const double column[size] = {
            mass * sums[0][k], mass * sums[1][k], mass * sums[2][k], a.x, a.y, a.z, b.x, b.y, b.z};
        for (int i = 0; i < size; ++i) moved[i][k] = column[i];
    }
    double square = 0;
    for (int i = 0; i < size; ++i) {
        for (int k = 0; k < size; ++k) square += moved[i][k] * moved[k][i];
    }
    return std::max(1.0, square / group.count);
}

}  // namespace

void RigidContacts::begin_group(const ContactPartner& a, const ContactPartner& b) {
    // One without rows is overwritten.
    if (group_count_ == 0 || groups_[group_count_ - 1].count > 0) {
        is_full_ = group_count_ == room_.group_count;
        if (is_full_) return;
        ++group_count_;
    }
    groups_[group_count_ - 1] = {a, b, count_, 0, 0, {}, {}};
}

void RigidContacts::add(const ContactRow& added) {
    if (is_full_ || count_ == room_.row_count) return;
    ContactGroup& group = groups_[group_count_ - 1];
    ContactRow& row = rows_[count_++];
    ++group.count;
    row = added;
    row.inverse_mass = inverse_mass(group, row);
    if (are_joined(group)) row.softness = softness_of_joined * row.inverse_mass;
    row.inverse_mass_along = row.friction > 0 ? inverse_mass_along(group, row) : 0;
}

/// Returns by how much it has moved anything, at most.
double RigidContacts::sweep() {
    double largest = 0, largest_square = 0;
    double squares = 0;
    for (ContactGroup *group = groups_, *const groups_end = groups_ + group_count_; group != groups_end; ++group) {
        ContactRow *const first = rows_ + group->first, *const end = first + group->count;
        const double among = group->among;
        const bool carried = is_carried(*group);
        ContactImpulse normal, friction;
        double load = 0;
        follow_joined(*group);
        const RelativeMotion approaching(*group);
        for (ContactRow* row = first; row != end; ++row) {
            largest = std::max(largest, change_normal(*group, *row, dot(row->normal, approaching.at(*row)), among));
            load += row->normal_impulse;
            row->friction_change = carried ? bound_friction(*row) : Vec3{};
            const Vec3 change = row->normal * row->normal_change + row->friction_change;
            if (change != Vec3{}) add_impulse(normal, *row, change);
        }
        push(*group, ContactImpulse(normal));
        const bool together = move_together(*group);
        if (together) {
            push_joined(*group, normal);
            follow_joined(*group);
        }
        const RelativeMotion sliding(*group);
        for (ContactRow* row = first; row != end; ++row) {
            // Each bears as much of the friction as of the load, which bounds it.
            const double share = load > 0 ? row->normal_impulse / load : 1.0 / group->count;
            Vec3 changed;
            largest_square = std::max(largest_square, change_friction(*group, *row, sliding, share, changed));
            row->friction_change += changed;
            // In the norm of the energy.
            squares +=
                row->inverse_mass * (row->normal_change * row->normal_change + length_squared(row->friction_change));
            if (changed != Vec3{}) add_impulse(friction, *row, changed);
        }
        push(*group, ContactImpulse(friction));
        group->change = {normal.impulse + friction.impulse, normal.about_a + friction.about_a,
                         normal.about_b + friction.about_b};
        push_joined(*group, together ? friction : group->change);
    }
    square_ = squares;
    return std::max(largest, std::sqrt(largest_square));
}

/// What a sweep changes is the gradient.
void RigidContacts::accelerate() {
    const double factor = square_before_ > 0 ? square_ / square_before_ : infinity;
    square_before_ = square_;
    const bool restarts = factor > 1;
    for (ContactGroup *group = groups_, *const groups_end = groups_ + group_count_; group != groups_end; ++group) {
        ContactRow *const first = rows_ + group->first, *const end = first + group->count;
        if (restarts) {
            for (ContactRow* row = first; row != end; ++row) {
                row->normal_way = row->normal_change;
                row->friction_way = row->friction_change;
            }
            group->way = group->change;
            continue;
        }
        const auto continue_way = [factor](auto& way, auto change, auto& impulse) {
            const auto more = way * factor;
            way = more + change;
            impulse += more;
        };
        const bool carried = is_carried(*group);
        ContactImpulse more;
        for (ContactRow* row = first; row != end; ++row) {
            const Vec3 before = row->normal * row->normal_impulse + row->friction_impulse;
            continue_way(row->normal_way, row->normal_change, row->normal_impulse);
            continue_way(row->friction_way, row->friction_change, row->friction_impulse);
            if (!carried) continue;
            row->normal_impulse = std::max(0.0, row->normal_impulse);
            bound_friction(*row);
            add_impulse(more, *row, row->normal * row->normal_impulse + row->friction_impulse - before);
        }
        if (!carried) {
            continue_way(group->way.impulse, group->change.impulse, more.impulse);
            continue_way(group->way.about_a, group->change.about_a, more.about_a);
            continue_way(group->way.about_b, group->change.about_b, more.about_b);
        }
        push(*group, more);
        push_joined(*group, more);
    }
}

void RigidContacts::solve(int most, double tolerance) {
    for (ContactGroup* group = groups_; group != groups_ + group_count_; ++group) {
        if (group->among == 0 && group->count > 0) group->among = among(*group, rows_ + group->first);
    }
    for (int i = 0; i < most; ++i) {
        if (sweep() <= tolerance) break;
        if (i + 1 < most) accelerate();
    }
}

void RigidContacts::end() const {
    for (const ContactGroup* group = groups_; group != groups_ + group_count_; ++group) {
        ContactImpulse sum;
        for (const ContactRow *row = rows_ + group->first, *const last = row + group->count; row != last; ++row) {
            add_impulse(sum, *row, row->normal * row->normal_impulse + row->friction_impulse);
            if (row->support) {
                row->support->push = row->normal_impulse * row->scale;
                row->support->friction = row->friction_impulse * row->scale;
            } else {
                *row->separation = row->normal_impulse * row->scale;
            }
        }
        const auto add = [](ContactCluster* cluster, Vec3 impulse, Vec3 moment) {
            if (!cluster || !cluster->held) return;
            cluster->impulse += impulse;
            cluster->moment += moment;
        };
        add(group->b.cluster, sum.impulse, sum.about_b);
        add(group->a.cluster, -sum.impulse, -sum.about_a);
    }
}

}  // namespace gphys
