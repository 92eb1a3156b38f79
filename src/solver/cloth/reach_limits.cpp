// Long-range attachments (Kim, Chentanez, Mueller-Fischer 2012): a particle stays within the length of the shortest
// path of rigid links from each of its nearest pins. Applied after all else, these limits remove at once the stretch
// for which sweeps over the links would need many substeps.
//
// In a flat sheet that nobody has cut, straight lines take the place of the paths: no path is shorter.
#include "solver/cloth/reach_limits.h"

#include "solver/cloth/cloth_sheet.h"
#include "solver/cloth/cloth_state.h"
#include "solver/cloth/rigid_links.h"
#include "solver/particles/particles.h"

namespace gphys {
namespace {

// Limits leave this fraction of slack, so that they act on stretch and not on rounding.
constexpr double slack = 1e-6;

/// Whether no rigid link is shorter than the distance of its ends in the flat sheet.
bool is_flat(const ClothSheet& sheet, const RigidLinks& rigid) {
    constexpr double rounding = 1e-9;
    const Vector<Vec3>& place = sheet.rest_position;
    for (uint32_t p = 0; p < place.size(); ++p) {
        for (uint32_t i = rigid.begin[p]; i < rigid.begin[p + 1]; ++i) {
            const RigidLinks::End& link = rigid.at[i];
            if (link.rest * link.rest < (1 - rounding) * length_squared(place[link.to] - place[p])) return false;
        }
    }
    return !place.empty();
}

/// The limits of all particles of a flat sheet, which is connected. Of each the nearest anchor first.
void add_straight_limits(Vector<ReachLimit>& limits, const Vector<uint32_t>& anchors, const Particles& particles,
                         const Vector<Vec3>& place) {
    limits.reserve(anchors.size() * particles.size());
    for (uint32_t p = 0; p < particles.size(); ++p) {
        if (particles.pinned(p)) continue;
        const size_t first = limits.size();
        for (const uint32_t anchor : anchors) {
            const double limit = distance(place[p], place[anchor]) * (1 + slack);
            limits.push_back({p, anchor, limit});
            for (size_t i = limits.size() - 1; i > first && limits[i - 1].distance > limit; --i)
                std::swap(limits[i - 1], limits[i]);
        }
    }
}

ClothLimits packed(const ReachLimits& reach) {
    const Vector<float>& distances = reach.stretched.empty() ? reach.distances : reach.stretched;
    return {reach.limited.data(), reach.anchors.data(), distances.data()};
}

}  // namespace

void plan_reach_limits(ReachLimits& reach, const RigidLinks& rigid, const Particles& particles,
                       const ClothSheet& sheet) {
    reach.limits.clear();
    const bool flat = !sheet.rest_position.empty();
    if (flat) {
        Vector<uint32_t> pinned(reach.limits.get_allocator());
        for (uint32_t p = 0; p < particles.size() && pinned.size() <= most_anchors; ++p) {
            if (particles.pinned(p)) pinned.push_back(p);
        }
        if (pinned.size() <= most_anchors && is_flat(sheet, rigid))
            return add_straight_limits(reach.limits, pinned, particles, sheet.rest_position);
    }
    update_pin_paths(reach.paths, rigid, particles);
    reach.limits.reserve(reach.paths.size());
    for (const PinPath& path : reach.paths) {
        if (particles.pinned(path.particle)) continue;
        const double straight =
            flat ? distance(sheet.rest_position[path.particle], sheet.rest_position[path.anchor]) : path.length;
        reach.limits.push_back({path.particle, path.anchor, std::min(straight, path.length) * (1 + slack)});
    }
}

/// The limits of one particle act one after the other, those of different particles in eight lanes: rank 0 has the
/// nearest anchor of each particle, rank 1 the second nearest, and so on.
void pack_reach_limits(ReachLimits& reach, uint32_t particles) {
    constexpr uint32_t lanes = 8;
    Vector<uint32_t> rank(reach.limits.size(), reach.limited.get_allocator()),
        count(particles, 0, rank.get_allocator());
    uint32_t ranks = 0;
    for (size_t i = 0; i < reach.limits.size(); ++i) {
        rank[i] = count[reach.limits[i].particle]++;
        ranks = std::max(ranks, rank[i] + 1);
    }
    const auto add = [&](const ReachLimit& limit) {
        reach.limited.push_back(limit.particle);
        reach.anchors.push_back(limit.anchor);
        reach.distances.push_back(static_cast<float>(limit.distance));
    };
    reach.limited.clear();
    reach.anchors.clear();
    reach.distances.clear();
    reach.stretched.clear();
    reach.ranks.assign(1, 0);
    for (uint32_t r = 0; r < ranks; ++r) {
        for (size_t i = 0; i < reach.limits.size(); ++i) {
            if (rank[i] == r) add(reach.limits[i]);
        }
        while (reach.limited.size() % lanes != 0) add({particles, particles, 0});  // a particle that does not move
        reach.ranks.push_back(static_cast<uint32_t>(reach.limited.size()));
    }
}

void apply_reach_limits(const ReachLimits& reach, ClothState& state, Team* team) {
    const ClothKernels& kernels = cloth_kernels(chosen_isa());
    const ClothLimits limits = packed(reach);
    for (size_t rank = 0; rank + 1 < reach.ranks.size(); ++rank) {
        const uint32_t first = reach.ranks[rank], count = reach.ranks[rank + 1] - first;
        share(team, (count + share_limits - 1) / share_limits, [&](uint32_t i, uint32_t) {
            const uint32_t from = first + i * share_limits;
            kernels.limit(state.at.data(), {limits.particles + from, limits.anchors + from, limits.distances + from},
                          std::min(share_limits, first + count - from));
        });
    }
}

void apply_reach_limits(const ReachLimits& reach, ClothState& state, float* pulls) {
    cloth_kernels(chosen_isa())
        .limit_pulling(state.at.data(), packed(reach), static_cast<uint32_t>(reach.limited.size()),
                       state.acceleration.data(), pulls);
}

}  // namespace gphys
