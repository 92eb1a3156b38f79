// Solves the contacts of rigid clusters (rigid_contacts.h).
#include "solver/contact/rigid_contacts.h"

namespace gphys {
namespace {

Vec3 moved(const ContactSide& side) {
    if (side.cluster) return side.cluster->shift + cross(side.cluster->turn, side.arm);
    return side.value ? *side.value - *side.uncorrected : Vec3{};
}

void push(ContactCluster& cluster, Vec3 impulse, Vec3 moment) {
    cluster.shift += impulse * cluster.inverse_mass;
    cluster.turn += cluster.inverse_inertia * moment;
}

void push(const ContactSide& side, Vec3 impulse) {
    if (side.cluster) {
        push(*side.cluster, impulse, cross(side.arm, impulse));
    } else if (side.value) {
        *side.value += impulse * side.inverse_mass;
        if (!side.supports) return;
        *side.value = side.supports->stop(*side.value, *side.uncorrected);
        *side.value = side.supports->hold(*side.value, *side.still);
    }
}

/// What an impulse moves a cluster by at its arm, or a particle that no model carries.
Vec3 moved_by(const ContactSide& side, Vec3 impulse) {
    if (!side.cluster) return side.supports ? Vec3{} : impulse * side.inverse_mass;
    return impulse * side.cluster->inverse_mass +
           cross(side.cluster->inverse_inertia * cross(side.arm, impulse), side.arm);
}

/// Of a particle that models carry: its inverse mass, as far as they let it go.
double yielding_mass(const ContactSide& side, Vec3 direction) {
    if (!side.supports) return 0;
    return side.inverse_mass * std::max(0.0, dot(side.supports->yielding(direction), direction));
}

double yielding_mass(const ContactRow& row, Vec3 direction) {
    return row.carried ? yielding_mass(row.a, -direction) + yielding_mass(row.b, direction) : 0;
}

double yielding_mass_along(const ContactRow& row, Vec3 slip) {
    const double size = row.carried ? length(slip) : 0;
    return size > 0 ? yielding_mass(row, slip / -size) : 0;
}

/// The largest eigenvalue of the inverse mass along the surface.
double largest_along(const ContactRow& row) {
    const Vec3 n = row.normal, other = std::fabs(n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 s = cross(n, other) / length(cross(n, other)), t = cross(n, s);
    const Vec3 by_s = moved_by(row.a, s) + moved_by(row.b, s), by_t = moved_by(row.a, t) + moved_by(row.b, t);
    const double ss = dot(s, by_s), tt = dot(t, by_t), st = dot(t, by_s);
    return (ss + tt) / 2 + std::sqrt((ss - tt) * (ss - tt) / 4 + st * st);
}

/// Changes the normal impulse of a row, of which `among` share the masses. Returns by how much it has changed the gap.
double change_normal(ContactRow& row, Vec3 moved, double among) {
    row.normal_change = 0;
    const double gap = row.gap + dot(row.normal, moved);
    if (row.normal_impulse == 0 && gap >= 0) return 0;
    const double yields = row.inverse_mass + yielding_mass(row, row.normal);
    if (!(yields > 0)) return 0;
    row.normal_change = std::max(-row.normal_impulse, -gap / (yields * among));
    row.normal_impulse += row.normal_change;
    return std::fabs(row.normal_change) * yields;
}

/// The same for friction, within Coulomb's bound, by a row with this share of the masses.
double change_friction(ContactRow& row, Vec3 moved, double share) {
    row.friction_change = {};
    if (row.friction == 0 || (row.normal_impulse == 0 && row.friction_impulse == Vec3{})) return 0;
    Vec3 slip = row.slip + moved;
    slip -= row.normal * dot(slip, row.normal);
    const double along = row.inverse_mass_along + yielding_mass_along(row, slip);
    Vec3 wanted = row.friction_impulse;
    if (along > 0) wanted -= slip * (share / along);
    const double most = row.friction * row.normal_impulse, square = length_squared(wanted);
    if (square > most * most) wanted *= most / std::sqrt(square);
    row.friction_change = wanted - row.friction_impulse;
    row.friction_impulse = wanted;
    return length(row.friction_change) * along;
}

/// Calls impulse_of(row) for the rows of a group, and applies the sum.
template <class Impulse>
void push_group(ContactRow* first, Impulse&& impulse_of) {
    ContactRow* const end = first + first->count;
    if (first->count == 1) {
        const Vec3 impulse = impulse_of(*first);
        push(first->a, -impulse);
        push(first->b, impulse);
        return;
    }
    Vec3 sum, about_a, about_b;
    for (ContactRow* row = first; row != end; ++row) {
        const Vec3 impulse = impulse_of(*row);
        sum += impulse;
        about_a += cross(row->a.arm, impulse);
        about_b += cross(row->b.arm, impulse);
    }
    if (first->a.cluster) push(*first->a.cluster, -sum, -about_a);
    push(*first->b.cluster, sum, about_b);
}

}  // namespace

void RigidContacts::add(const ContactRow& added) {
    if (count_ == room_) return;
    ContactRow& row = rows_[count_];
    row = added;
    row.number = count_++;
    row.carried = row.a.supports || row.b.supports;
    row.pushed = moved_by(row.a, row.normal) + moved_by(row.b, row.normal);
    row.inverse_mass = dot(row.pushed, row.normal);
    row.inverse_mass_along = row.friction > 0 ? largest_along(row) : 0;
}

void RigidContacts::arrange(const ContactCluster* clusters) {
    const auto number = [&](const ContactSide& side) {
        return side.cluster ? static_cast<uint64_t>(side.cluster - clusters) + 1 : 0;
    };
    for (ContactRow* row = rows_; row != rows_ + count_; ++row) {
        if (number(row->a) > number(row->b)) {
            std::swap(row->a, row->b);
            row->normal = -row->normal;
            row->slip = -row->slip;
        }
        row->group = number(row->a) << 32 | number(row->b);
    }
    std::sort(rows_, rows_ + count_, [](const ContactRow& x, const ContactRow& y) {
        return x.group != y.group ? x.group < y.group : x.number < y.number;
    });
    ContactRow* const end = rows_ + count_;
    for (ContactRow* row = rows_; row != end; row += row->count) {
        row->count = 1;
        const auto follows = [&](const ContactRow* next) {
            return next != end && next->group == row->group && !next->a.value;
        };
        while (!row->a.value && follows(row + row->count)) ++row->count;
    }
}

/// Returns by how much it has moved anything, at most.
double RigidContacts::sweep() {
    double largest = 0;
    square_ = 0;
    for (ContactRow *first = rows_, *const end = rows_ + count_; first != end; first += first->count) {
        const double among = first->count;
        double load = 0;
        push_group(first, [&](ContactRow& row) {
            largest = std::max(largest, change_normal(row, moved(row.b) - moved(row.a), among));
            load += row.normal_impulse;
            return row.normal * row.normal_change;
        });
        push_group(first, [&](ContactRow& row) {
            // Each bears as much of the friction as of the load, which bounds it.
            const double share = load > 0 ? row.normal_impulse / load : 1 / among;
            largest = std::max(largest, change_friction(row, moved(row.b) - moved(row.a), share));
            // In the norm of the energy.
            square_ += row.inverse_mass * (row.normal_change * row.normal_change + length_squared(row.friction_change));
            return row.friction_change;
        });
    }
    return largest;
}

/// What a sweep changes is the gradient.
void RigidContacts::accelerate() {
    const double factor = square_before_ > 0 ? square_ / square_before_ : infinity;
    square_before_ = square_;
    for (ContactRow *first = rows_, *const end = rows_ + count_; first != end; first += first->count) {
        if (factor > 1) {
            for (ContactRow* row = first; row != first + first->count; ++row) {
                row->normal_way = row->normal_change;
                row->friction_way = row->friction_change;
            }
            continue;
        }
        push_group(first, [&](ContactRow& row) {
            const double more = factor * row.normal_way;
            const Vec3 more_friction = row.friction_way * factor;
            row.normal_way = more + row.normal_change;
            row.friction_way = more_friction + row.friction_change;
            row.normal_impulse += more;
            row.friction_impulse += more_friction;
            return row.normal * more + more_friction;
        });
    }
}

void RigidContacts::solve(int most, double tolerance) {
    for (int i = 0; i < most; ++i) {
        if (sweep() <= tolerance) break;
        if (i + 1 < most) accelerate();
    }
}

void RigidContacts::end() const {
    for (const ContactRow* row = rows_; row != rows_ + count_; ++row) {
        if (row->support) {
            row->support->push = row->normal_impulse * row->scale;
            row->support->friction = row->friction_impulse * row->scale;
        } else {
            *row->separation = row->normal_impulse * row->scale;
        }
    }
}

}  // namespace gphys
