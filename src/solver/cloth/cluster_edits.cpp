// Adds, removes and lists clusters (clusters.h). A function that can fail checks its input and allocates first; after
// that it wakes the body and changes it.
#include "foundation/status.h"
#include "solver/body.h"
#include "solver/state.h"

namespace gphys {
namespace {

struct BySlot {
    bool operator()(const ClusterMember& member, uint32_t slot) const { return member.cluster < slot; }
    bool operator()(uint32_t slot, const ClusterMember& member) const { return slot < member.cluster; }
};

}  // namespace

ClusterRange members_of(const Clusters& clusters, uint32_t slot) {
    const auto range = std::equal_range(clusters.members.begin(), clusters.members.end(), slot, BySlot());
    const ClusterMember* const all = clusters.members.data();
    return {all + (range.first - clusters.members.begin()), all + (range.second - clusters.members.begin())};
}

gphys_status add_cluster(Body& body, const uint32_t* particles, uint32_t count, gphys_cluster_id& out) {
    Clusters& clusters = body.cloth.clusters;
    if (!clusters.ids.reserve(1)) return fail(GPHYS_ERROR_CAPACITY, "the body would have more than 2^24 - 1 clusters");
    if (count > IdTable::capacity - clusters.members.size()) {
        return fail(GPHYS_ERROR_CAPACITY, "the clusters of the body would have more than 2^24 - 1 particles");
    }
    reserve_more(clusters.members, count);
    wake(body);
    if (clusters.empty()) body.plan.chains_current = false;  // another method may solve it from now on
    out = clusters.ids.add();
    const uint32_t slot = IdTable::slot_of(out);
    const Vector<Vec3>& position = body.particles.position;
    auto at = clusters.members.insert(
        std::lower_bound(clusters.members.begin(), clusters.members.end(), slot, BySlot()), count, ClusterMember{});
    for (uint32_t i = 0; i < count; ++i) *at++ = {position[particles[i]] - position[particles[0]], particles[i], slot};
    clusters.changed = true;
    interrupt(body);
    return GPHYS_OK;
}

gphys_status check_cluster(const Clusters& clusters, gphys_cluster_id id) {
    if (clusters.ids.has(id)) return GPHYS_OK;
    return fail(GPHYS_ERROR_INVALID_ID, "cluster", id, "the id of a cluster of the body");
}

gphys_status remove_cluster(Body& body, gphys_cluster_id id) {
    Clusters& clusters = body.cloth.clusters;
    GPHYS_TRY(check_cluster(clusters, id));
    wake(body);
    const auto range =
        std::equal_range(clusters.members.begin(), clusters.members.end(), IdTable::slot_of(id), BySlot());
    clusters.members.erase(range.first, range.second);
    clusters.ids.remove(id);
    if (clusters.empty()) body.plan.chains_current = false;
    clusters.changed = true;
    interrupt(body);
    return GPHYS_OK;
}

void list_clusters(const Clusters& clusters, Smallest<gphys_cluster_id>& out) {
    for (const uint32_t slot : clusters.ids) out.add(clusters.ids.id(slot));
}

}  // namespace gphys
