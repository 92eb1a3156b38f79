// Conversion between the arrays of bodies and the nodes of kernels: gather and scatter with one rope per lane.
#include "solver/rope/rope_nodes.h"

#include <limits>

#include "foundation/compiler.h"

namespace gphys::GPHYS_ISA {
namespace {

/// Loads `count` consecutive numbers of each rope, from element index(lane) of an array; gather_into also stores them.
template <int count, int lanes, class Array, class Index>
GPHYS_INLINE void gather(const RopeArrays (&ropes)[lanes], Array RopeArrays::*array, const Index& index,
                         Doubles<lanes> (&to)[count]) {
    load_components([&](int lane) { return ropes[lane].*array + size_t{count} * index(lane); }, to);
}
template <int lanes, class Array, class Index>
GPHYS_INLINE void gather_into(const RopeArrays (&ropes)[lanes], Array RopeArrays::*array, const Index& index,
                              double (&to)[lanes]) {
    Doubles<lanes> value[1];
    gather(ropes, array, index, value);
    store(to, value[0]);
}
template <int lanes, class Array, class Index>
GPHYS_INLINE void gather_into(const RopeArrays (&ropes)[lanes], Array RopeArrays::*array, const Index& index,
                              double (&to)[3][lanes]) {
    Doubles<lanes> value[3];
    gather(ropes, array, index, value);
    for (int k = 0; k < 3; ++k) store(to[k], value[k]);
}

/// Completes the link between two nodes. `inverse_masses`: the sum of those of its ends.
template <int lanes, class Mask>
void complete_link(RopeNode<lanes>& node, const Doubles<lanes>& inverse_masses, const Mask& is_there) {
    using Value = Doubles<lanes>;
    const Value zero = all_of<lanes>(0), one = all_of<lanes>(1);
    const auto present = is_there & (zero < inverse_masses);
    const Value target = load(node.target), tolerance = all_of<lanes>(2 * rope_tolerance);
    store(node.present, select(present, one, zero));
    store(node.target, select(present, target, zero));
    store(node.inverse_target, select(present, one / largest(target, all_of<lanes>(rope_shortest)), one));
    store(node.compliance, select(present, load(node.compliance), zero));
    store(node.regularisation, select(present, all_of<lanes>(rope_regularisation) * inverse_masses, one));
    store(node.lateral_tolerance,
          select(present, tolerance * target * target, all_of<lanes>(std::numeric_limits<double>::infinity())));
    store(node.tension, select(present, load(node.tension), zero));
}

}  // namespace

template <int lanes>
GPHYS_FLATTEN void gather_ropes(RopeNode<lanes>* nodes, uint32_t count, const RopeArrays (&ropes)[lanes],
                                const double (&gravity)[3]) {
    using Value = Doubles<lanes>;
    const Value zero = all_of<lanes>(0), one = all_of<lanes>(1);
    double counts[lanes];
    bool forced = false;
    for (int lane = 0; lane < lanes; ++lane) {
        counts[lane] = ropes[lane].count;
        forced = forced || ropes[lane].forced;
    }
    Value inverse_mass_before = zero;
    for (uint32_t i = 0; i < count; ++i) {
        RopeNode<lanes>& node = nodes[i];
        const auto is_there = all_of<lanes>(i) < load(counts);
        uint32_t particles[lanes];
        for (int lane = 0; lane < lanes; ++lane) particles[lane] = ropes[lane].particles[i < ropes[lane].count ? i : 0];
        const auto particle = [&](int lane) { return particles[lane]; };
        const auto link = [&](int lane) { return i + 1 < ropes[lane].count ? i : 0; };
        gather_into(ropes, &RopeArrays::position, particle, node.position);
        gather_into(ropes, &RopeArrays::velocity, particle, node.velocity);
        gather_into(ropes, &RopeArrays::start, particle, node.start);
        gather_into(ropes, &RopeArrays::start_velocity, particle, node.start_velocity);
        gather_into(ropes, &RopeArrays::mass, particle, node.mass);
        gather_into(ropes, &RopeArrays::inverse_mass, particle, node.inverse_mass);
        gather_into(ropes, &RopeArrays::target, link, node.target);
        gather_into(ropes, &RopeArrays::compliance, link, node.compliance);
        gather_into(ropes, &RopeArrays::tension, link, node.tension);
        const Value inverse_mass = select(is_there, load(node.inverse_mass), zero);
        store(node.inverse_mass, inverse_mass);
        const auto is_free = zero < inverse_mass;
        store(node.free, select(is_free, one, zero));
        for (double(&velocity)[lanes] : node.velocity) store(velocity, select(is_free, load(velocity), zero));
        Value force[3] = {zero, zero, zero};
        if (forced) gather(ropes, &RopeArrays::force, particle, force);
        for (int k = 0; k < 3; ++k) store(node.acceleration[k], all_of<lanes>(gravity[k]) + force[k] * inverse_mass);
        if (i > 0) complete_link(nodes[i - 1], inverse_mass_before + inverse_mass, is_there);
        inverse_mass_before = inverse_mass;
    }
}

template <int lanes>
GPHYS_FLATTEN void scatter_ropes(const RopeNode<lanes>* nodes, uint32_t count, const RopeArrays (&ropes)[lanes],
                                 const bool (&wanted)[lanes]) {
    uint32_t shortest = count;
    for (int lane = 0; lane < lanes; ++lane) {
        const uint32_t nodes_of_rope = wanted[lane] ? ropes[lane].count : 0;
        shortest = nodes_of_rope < shortest ? nodes_of_rope : shortest;
    }
    const bool estimated = ropes[0].earlier_velocity;
    const auto scatter_node = [&](uint32_t i, const auto& is_wanted) {
        const RopeNode<lanes>& node = nodes[i];
        double unused[3];  // where lanes that are not wanted are stored
        const auto scatter = [&](double* RopeArrays::*array, const double(&from)[3][lanes]) {
            const Doubles<lanes> value[3] = {load(from[0]), load(from[1]), load(from[2])};
            store_components(
                [&](int lane) {
                    return is_wanted(lane) ? ropes[lane].*array + size_t{3} * ropes[lane].particles[i] : unused;
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
    for (uint32_t i = 0; i < shortest; ++i) scatter_node(i, [](int) { return true; });
    for (uint32_t i = shortest; i < count; ++i) {
        scatter_node(i, [&](int lane) { return wanted[lane] && i < ropes[lane].count; });
    }
}

template void gather_ropes<1>(RopeNode<1>*, uint32_t, const RopeArrays (&)[1], const double (&)[3]);
template void gather_ropes<8>(RopeNode<8>*, uint32_t, const RopeArrays (&)[8], const double (&)[3]);
template void scatter_ropes<1>(const RopeNode<1>*, uint32_t, const RopeArrays (&)[1], const bool (&)[1]);
template void scatter_ropes<8>(const RopeNode<8>*, uint32_t, const RopeArrays (&)[8], const bool (&)[8]);

}  // namespace gphys::GPHYS_ISA
