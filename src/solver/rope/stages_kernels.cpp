// Decides whether the substeps of a rope have two stages, the trapezoid rule and the backward formula (TR-BDF2, see
// TimeScheme). The trapezoid rule damps nothing. It adds energy where a link turns by more than half a radian in a
// substep, or begins to, or would swing by more than one radian if its ends were displaced. And a stiff spring that
// would swing by more, such as a taut elastic string, keeps oscillating.
#include "solver/rope/rope_nodes.h"

#include "foundation/compiler.h"

namespace gphys::GPHYS_ISA {

namespace {

// Weight of swinging, sideways or along, and of faster turning, relative to turning.
constexpr double swing_weight = 0.25;
// The squared ratio of a substep to its last part, in which a link has begun to turn faster.
constexpr double faster_weight = 6;

/// The weight that hangs from a link, in newtons: a link that is slack at the moment may become loaded by it within the
/// step.
template <int lanes>
Doubles<lanes> weight_of(const RopeNode<lanes>& node) {
    const Vec<Doubles<lanes>> acceleration = load3(node.acceleration);
    return square_root(dot(acceleration, acceleration)) * load(node.mass) * load(node.free);
}

}  // namespace

/// The largest square of a link's turning rate, 1/s^2.
template <int lanes>
GPHYS_FLATTEN void find_agility(const RopeNode<lanes>* nodes, uint32_t count, double (&agility)[lanes]) {
    using Value = Doubles<lanes>;
    const Value none = all_of<lanes>(0), swings = all_of<lanes>(swing_weight), quickens = all_of<lanes>(faster_weight);
    Value most = none, weight = weight_of(nodes[0]);
    for (uint32_t i = 0; i + 1 < count; ++i) {
        const RopeNode<lanes>&a = nodes[i], &b = nodes[i + 1];
        const Vec<Value> apart = load3(b.velocity) - load3(a.velocity);
        const Vec<Value> faster = apart - (load3(b.start_velocity) - load3(a.start_velocity));
        const Value turning = largest(dot(apart, apart), quickens * dot(faster, faster));
        const Value tension = load(a.tension), weight_after = weight_of(b);
        const Value pull = largest(largest(tension, -tension), largest(weight, weight_after));
        const Value mobility = load(a.inverse_mass) + load(b.inverse_mass), compliance = load(a.compliance);
        const Value swinging = swings * pull * mobility;
        const Value inverse = load(a.inverse_target);
        const Value sideways = largest(turning * inverse, swinging) * inverse;
        // Avoids a division by 0 for rigid links, because hosts may trap it.
        const auto yields = none < compliance;
        const Value along = select(yields, swings * mobility / select(yields, compliance, all_of<lanes>(1)), none);
        most = largest(most, largest(sideways, along) * load(a.present));
        weight = weight_after;
    }
    store(agility, most);
}

template void find_agility<1>(const RopeNode<1>*, uint32_t, double (&)[1]);
template void find_agility<8>(const RopeNode<8>*, uint32_t, double (&)[8]);

}  // namespace gphys::GPHYS_ISA
