// Decides whether the substeps of a rope have two stages, the trapezoid rule and the backward formula (TR-BDF2, see
// TimeScheme). The trapezoid rule damps nothing, and it adds energy if the motion turns too far within a substep.
//
// The measure is the largest angular frequency of a link, times the length of a substep. Three motions count:
//
//   turning      |v_b - v_a| / length, and what has been added to it in the last part of a substep
//   swinging     sqrt(t (w_a + w_b) / length): sideways, under the tension t; w are inverse masses
//   stretching   sqrt((w_a + w_b) / compliance): along the link; a taut elastic string would keep oscillating
//
// A link may turn by half a radian in a substep. It may swing or stretch by a full radian, hence the weights.
#include "solver/rope/rope_nodes.h"

#include "foundation/compiler.h"

namespace gphys::GPHYS_ISA {
namespace {

// Of squared frequencies, relative to that of turning:
constexpr double oscillation_weight = 0.25;  // of swinging and stretching
constexpr double acceleration_weight = 6;    // of added turning: the squared ratio of a substep to its last part

/// Newtons, by which gravity and forces may load a link of the node within the step, even one that is slack now.
template <int lanes>
Doubles<lanes> weight_of(const RopeNode<lanes>& node) {
    const Vec<Doubles<lanes>> acceleration = load3(node.acceleration);
    return square_root(dot(acceleration, acceleration)) * load(node.mass) * load(node.free);
}

}  // namespace

template <int lanes>
GPHYS_FLATTEN void find_largest_frequency(const RopeNode<lanes>* nodes, uint32_t count,
                                          double (&frequency_squared)[lanes]) {
    using Value = Doubles<lanes>;
    const Value zero = all_of<lanes>(0);
    const Value oscillation = all_of<lanes>(oscillation_weight), acceleration = all_of<lanes>(acceleration_weight);
    Value largest_squared = zero, weight = weight_of(nodes[0]);
    for (uint32_t i = 0; i + 1 < count; ++i) {
        const RopeNode<lanes>&a = nodes[i], &b = nodes[i + 1];
        const Vec<Value> relative = load3(b.velocity) - load3(a.velocity);
        const Vec<Value> added = relative - (load3(b.start_velocity) - load3(a.start_velocity));
        const Value turning = largest(dot(relative, relative), acceleration * dot(added, added));  // m^2/s^2
        const Value tension = load(a.tension), next_weight = weight_of(b);
        const Value load_of_link = largest(largest(tension, -tension), largest(weight, next_weight));
        const Value inverse_masses = load(a.inverse_mass) + load(b.inverse_mass), compliance = load(a.compliance);
        const Value swinging = oscillation * load_of_link * inverse_masses;  // m/s^2
        const Value inverse_length = load(a.inverse_target);
        const Value sideways = largest(turning * inverse_length, swinging) * inverse_length;
        // Avoids a division by 0 for rigid links, because hosts may trap it.
        const auto is_elastic = zero < compliance;
        const Value stretching =
            select(is_elastic, oscillation * inverse_masses / select(is_elastic, compliance, all_of<lanes>(1)), zero);
        largest_squared = largest(largest_squared, largest(sideways, stretching) * load(a.present));
        weight = next_weight;
    }
    store(frequency_squared, largest_squared);
}

template void find_largest_frequency<1>(const RopeNode<1>*, uint32_t, double (&)[1]);
template void find_largest_frequency<8>(const RopeNode<8>*, uint32_t, double (&)[8]);

}  // namespace gphys::GPHYS_ISA
