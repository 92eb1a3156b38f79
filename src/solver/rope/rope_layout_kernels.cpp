// Conversion between the arrays of bodies and the nodes of kernels: gather and scatter with one rope per lane.
#include "solver/rope/rope_nodes.h"

#include <limits>

#include "foundation/compiler.h"

namespace gphys::GPHYS_ISA {

namespace {

/// Loads the `count` consecutive numbers at each rope's index(lane).
template <int count, int lanes, class Array, class Index>
GPHYS_INLINE void load_each(const RopeArrays (&ropes)[lanes], Array RopeArrays::*array, const Index& index,
                            Doubles<lanes> (&to)[count]) {
    load_components([&](int lane) { return ropes[lane].*array + size_t{count} * index(lane); }, to);
}
template <int lanes, class Array, class Index>
GPHYS_INLINE void put_each(const RopeArrays (&ropes)[lanes], Array RopeArrays::*array, const Index& index,
                           double (&to)[lanes]) {
    Doubles<lanes> value[1];
    load_each(ropes, array, index, value);
    store(to, value[0]);
}
template <int lanes, class Array, class Index>
GPHYS_INLINE void put_each(const RopeArrays (&ropes)[lanes], Array RopeArrays::*array, const Index& index,
                           double (&to)[3][lanes]) {
    Doubles<lanes> value[3];
    load_each(ropes, array, index, value);
    for (int k = 0; k < 3; ++k) store(to[k], value[k]);
}

/// The link between two nodes, whose inverse masses are known.
template <int lanes, class Mask>
void complete_link(RopeNode<lanes>& node, const Doubles<lanes>& inverse_masses, const Mask& is_there) {
    using Value = Doubles<lanes>;
    const Value none = all_of<lanes>(0), one = all_of<lanes>(1);
    const auto present = is_there & (none < inverse_masses);
    const Value target = load(node.target), hair = all_of<lanes>(2 * rope_settled);
    store(node.present, select(present, one, none));
    store(node.target, select(present, target, none));
    store(node.inverse_target, select(present, one / largest(target, all_of<lanes>(rope_shortest)), one));
    store(node.compliance, select(present, load(node.compliance), none));
    store(node.regularisation, select(present, all_of<lanes>(rope_regularisation) * inverse_masses, one));
    store(node.sideways,
          select(present, hair * target * target, all_of<lanes>(std::numeric_limits<double>::infinity())));
    store(node.tension, select(present, load(node.tension), none));
}

}  // namespace

template <int lanes>
GPHYS_FLATTEN void put_ropes(RopeNode<lanes>* nodes, uint32_t count, const RopeArrays (&ropes)[lanes],
                             const double (&gravity)[3]) {
    using Value = Doubles<lanes>;
    const Value none = all_of<lanes>(0), one = all_of<lanes>(1);
    double counts[lanes];
    bool forced = false;
    for (int lane = 0; lane < lanes; ++lane) {
        counts[lane] = ropes[lane].count;
        forced = forced || ropes[lane].forced;
    }
    Value inverse_mass_before = none;
    for (uint32_t i = 0; i < count; ++i) {
        RopeNode<lanes>& node = nodes[i];
        const auto is_there = all_of<lanes>(i) < load(counts);
        uint32_t particles[lanes];
        for (int lane = 0; lane < lanes; ++lane) {
            particles[lane] = ropes[lane].particles[i < ropes[lane].count ? i : 0];
        }
        const auto particle = [&](int lane) { return particles[lane]; };
        const auto link = [&](int lane) { return i + 1 < ropes[lane].count ? i : 0; };
        put_each(ropes, &RopeArrays::position, particle, node.position);
        put_each(ropes, &RopeArrays::velocity, particle, node.velocity);
        put_each(ropes, &RopeArrays::start, particle, node.start);
        put_each(ropes, &RopeArrays::start_velocity, particle, node.start_velocity);
        put_each(ropes, &RopeArrays::mass, particle, node.mass);
        put_each(ropes, &RopeArrays::inverse_mass, particle, node.inverse_mass);
        put_each(ropes, &RopeArrays::target, link, node.target);
        put_each(ropes, &RopeArrays::compliance, link, node.compliance);
        put_each(ropes, &RopeArrays::tension, link, node.tension);
        const Value inverse_mass = select(is_there, load(node.inverse_mass), none);
        store(node.inverse_mass, inverse_mass);
        store(node.free, select(none < inverse_mass, one, none));
        Value force[3] = {none, none, none};
        if (forced) load_each(ropes, &RopeArrays::force, particle, force);
        for (int k = 0; k < 3; ++k) {
            store(node.acceleration[k], all_of<lanes>(gravity[k]) + force[k] * inverse_mass);
        }
        if (i > 0) complete_link(nodes[i - 1], inverse_mass_before + inverse_mass, is_there);
        inverse_mass_before = inverse_mass;
    }
}

template <int lanes>
GPHYS_FLATTEN void take_ropes(const RopeNode<lanes>* nodes, uint32_t count, const RopeArrays (&ropes)[lanes],
                              const bool (&wanted)[lanes]) {
    uint32_t shortest_rope = count;
    for (int lane = 0; lane < lanes; ++lane) {
        const uint32_t nodes_of_rope = wanted[lane] ? ropes[lane].count : 0;
        shortest_rope = nodes_of_rope < shortest_rope ? nodes_of_rope : shortest_rope;
    }
    const bool estimated = ropes[0].earlier_velocity;
    const auto take = [&](uint32_t i, const auto& is_wanted) {
        const RopeNode<lanes>& node = nodes[i];
        double aside[3];  // destination of lanes that are not stored
        const auto scatter = [&](double* RopeArrays::*array, const double(&from)[3][lanes]) {
            const Doubles<lanes> value[3] = {load(from[0]), load(from[1]), load(from[2])};
            store_components(
                [&](int lane) {
                    return is_wanted(lane) ? ropes[lane].*array + size_t{3} * ropes[lane].particles[i] : aside;
                },
                value);
        };
        scatter(&RopeArrays::position, node.position);
        scatter(&RopeArrays::velocity, node.velocity);
        scatter(&RopeArrays::start, node.start);
        scatter(&RopeArrays::start_velocity, node.start_velocity);
        if (estimated) scatter(&RopeArrays::earlier_velocity, node.earlier_velocity);
        for (int lane = 0; lane < lanes; ++lane) {
            if (is_wanted(lane) && i + 1 < ropes[lane].count) ropes[lane].tension[i] = node.tension[lane];
        }
    };
    // In most calls all lanes are wanted and of one length, so no branches are needed up to the shortest.
    for (uint32_t i = 0; i < shortest_rope; ++i) take(i, [](int) { return true; });
    for (uint32_t i = shortest_rope; i < count; ++i) {
        take(i, [&](int lane) { return wanted[lane] && i < ropes[lane].count; });
    }
}

template void put_ropes<1>(RopeNode<1>*, uint32_t, const RopeArrays (&)[1], const double (&)[3]);
template void put_ropes<8>(RopeNode<8>*, uint32_t, const RopeArrays (&)[8], const double (&)[3]);
template void take_ropes<1>(const RopeNode<1>*, uint32_t, const RopeArrays (&)[1], const bool (&)[1]);
template void take_ropes<8>(const RopeNode<8>*, uint32_t, const RopeArrays (&)[8], const bool (&)[8]);

}  // namespace gphys::GPHYS_ISA
