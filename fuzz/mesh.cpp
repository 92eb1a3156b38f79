// Meshes: arrays of any kind are examined and refused or built, and what a mesh answers is compared with its
// triangles, asked one by one.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <vector>

#include "check.h"
#include "mesh/mesh_snapshot.h"
#include "mesh_source.h"
#include "program.h"
#include "shape_relations.h"

namespace fuzz {

const char* const target_name = "mesh";

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

struct Arrays {
    std::vector<gphys_vec3> vertices;
    std::vector<uint32_t> indices;
};

/// Triangles that share corners and edges, lie on each other, or are none.
Arrays arrays(Program& p) {
    Arrays a;
    const uint32_t kind = p.below(4);
    if (kind == 0) {  // a grid, as terrain is
        const uint32_t columns = 2 + p.below(8), rows = 2 + p.below(8);
        for (uint32_t r = 0; r < rows; ++r) {
            for (uint32_t c = 0; c < columns; ++c) {
                a.vertices.push_back({static_cast<float>(c), p.one_in(3) ? p.number() : 0.0f, static_cast<float>(r)});
            }
        }
        for (uint32_t r = 0; r + 1 < rows; ++r) {
            for (uint32_t c = 0; c + 1 < columns; ++c) {
                const uint32_t at = r * columns + c;
                for (const uint32_t i : {at, at + columns, at + 1, at + 1, at + columns, at + columns + 1}) {
                    a.indices.push_back(i);
                }
            }
        }
        return a;
    }
    const uint32_t vertices = p.below(kind == 1 ? 6 : 24), triangles = p.below(kind == 1 ? 8 : 60);
    for (uint32_t i = 0; i < vertices; ++i) a.vertices.push_back(p.point());
    for (uint32_t i = 0; vertices > 0 && i < 3 * triangles; ++i) a.indices.push_back(p.below(vertices));
    return a;
}

/// The report, counted from the arrays in the plainest way.
gphys_mesh_report counted(const Arrays& a) {
    gphys_mesh_report report{};
    report.first_degenerate = report.first_out_of_range = report.first_bad_vertex = GPHYS_NO_TRIANGLE;
    for (uint32_t i = 0; i < a.vertices.size(); ++i) {
        if (is_valid(a.vertices[i])) continue;
        if (report.bad_vertex_count++ == 0) report.first_bad_vertex = i;
    }
    report.triangle_count = static_cast<uint32_t>(a.indices.size() / 3);
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> edges;
    for (uint32_t i = 0; i < report.triangle_count; ++i) {
        const uint32_t* corner = &a.indices[3 * i];
        if (std::any_of(corner, corner + 3, [&](uint32_t c) { return c >= a.vertices.size(); })) {
            if (report.out_of_range_count++ == 0) report.first_out_of_range = i;
            continue;
        }
        for (int k = 0; k < 3; ++k) ++edges[std::minmax(corner[k], corner[(k + 1) % 3])];
    }
    for (const auto& [edge, triangles] : edges) report.open_edge_count += triangles != 2;
    return report;
}

void check_report(const Arrays& a, const gphys_mesh_report& report) {
    const gphys_mesh_report expected = counted(a);
    FUZZ_CHECK(report.triangle_count == expected.triangle_count, "a report counts the triangles");
    FUZZ_CHECK(
        report.bad_vertex_count == expected.bad_vertex_count && report.first_bad_vertex == expected.first_bad_vertex,
        "a report counts the bad vertices");
    FUZZ_CHECK(report.out_of_range_count == expected.out_of_range_count &&
                   report.first_out_of_range == expected.first_out_of_range,
               "a report counts the indices out of range");
    const bool sound = expected.bad_vertex_count == 0 && expected.out_of_range_count == 0;
    if (!sound) return;
    FUZZ_CHECK(report.degenerate_count <= report.triangle_count, "not more triangles are degenerate than there are");
    bool same_corner = false;
    for (size_t i = 0; i < a.indices.size(); i += 3) {
        same_corner |= a.indices[i] == a.indices[i + 1] || a.indices[i + 1] == a.indices[i + 2] ||
                       a.indices[i + 2] == a.indices[i];
    }
    FUZZ_CHECK(!same_corner || report.degenerate_count > 0, "a triangle with one corner twice is degenerate");
    if (!same_corner) FUZZ_CHECK(report.open_edge_count == expected.open_edge_count, "a report counts the open edges");
}

class MeshUnderTest {
public:
    MeshUnderTest(Program& p, const Arrays& a) : p_(p), source_(a.vertices, a.indices), mesh_(source_.create()) {}
    ~MeshUnderTest() { call(gphys_mesh_destroy, mesh_.release()); }

    void ask() {
        constexpr void (MeshUnderTest::*questions[])() = {
            &MeshUnderTest::raycast,  &MeshUnderTest::raycast,       &MeshUnderTest::raycast_batch,
            &MeshUnderTest::segment,  &MeshUnderTest::overlap,       &MeshUnderTest::overlap,
            &MeshUnderTest::sweep,    &MeshUnderTest::closest_point, &MeshUnderTest::mesh_with_mesh,
            &MeshUnderTest::contents, &MeshUnderTest::misuse,        &MeshUnderTest::contains,
            &MeshUnderTest::reload};
        (this->*questions[p_.below(std::size(questions))])();
    }

private:
    gphys_shape_type type() const { return GPHYS_SHAPE_MESH; }
    const gphys_mesh* mesh() const { return mesh_.get(); }

    void raycast() {
        const gphys_ray ray = p_.ray();
        if (!is_valid(ray)) return;
        const std::vector<gphys_hit> expected = source_.hits(ray);
        Output<gphys_hit> first;
        const gphys_status status = call(gphys_shape_raycast, type(), mesh(), &ray, &first.value);
        first.after(status);
        FUZZ_CHECK((status == GPHYS_OK) == !expected.empty(), "a mesh is hit where a triangle is");
        if (!expected.empty()) FUZZ_CHECK(same_bits(first.value, expected[0]), "raycast of a mesh gives the first hit");
        int32_t any = -1;
        call(gphys_mesh_raycast_any, mesh(), &ray, &any);
        FUZZ_CHECK(any == !expected.empty(), "mesh_raycast_any agrees with the triangles");
        const uint32_t capacity = p_.one_in(2) ? 100 : p_.below(4);
        std::vector<gphys_hit> all(capacity + 1);
        uint32_t total = 0;
        const gphys_status listed =
            call(gphys_mesh_raycast_all, mesh(), &ray, capacity ? all.data() : nullptr, capacity, &total);
        FUZZ_CHECK(total == expected.size(), "mesh_raycast_all counts the hits");
        FUZZ_CHECK(listed == (total > capacity ? GPHYS_INCOMPLETE : GPHYS_OK), "a list that is cut short says so");
        for (uint32_t i = 0; i < std::min(total, capacity); ++i) {
            note(all[i]);
            FUZZ_CHECK(same_bits(all[i], expected[i]), "mesh_raycast_all lists the hits in order");
        }
    }

    void raycast_batch() {
        const uint32_t count = p_.below(100);
        std::vector<gphys_ray> rays(count + 1);
        const bool image = p_.one_in(2);  // rows of neighbours, which share walks
        const gphys_ray corner = p_.ray();
        for (uint32_t i = 0; i < count; ++i) {
            rays[i] = image ? corner : p_.ray();
            if (image) rays[i].direction.x += static_cast<float>(i % 8) / 16;
            if (image) rays[i].direction.y += static_cast<float>(i / 8) / 16;
            if (!is_valid(rays[i])) return;
        }
        std::vector<gphys_hit> hits(count + 1);
        const gphys_status status = call(gphys_shape_raycast_batch, type(), mesh(), rays.data(),
                                         uint32_t{sizeof(gphys_ray)}, count, hits.data(), uint32_t{sizeof(gphys_hit)});
        FUZZ_CHECK(status == GPHYS_OK, "a batch of valid rays is answered");
        std::vector<gphys_distance> distances(count + 1);
        std::vector<int32_t> any(count + 1);
        call(gphys_mesh_raycast_distance_batch, mesh(), rays.data(), uint32_t{sizeof(gphys_ray)}, count,
             distances.data(), uint32_t{sizeof(gphys_distance)});
        call(gphys_mesh_raycast_any_batch, mesh(), rays.data(), uint32_t{sizeof(gphys_ray)}, count, any.data(), 4u);
        for (uint32_t i = 0; i < count; ++i) {
            gphys_hit single{0, 0, infinity, {}, {}, GPHYS_NO_TRIANGLE, 0, 0, 0};
            call(gphys_shape_raycast, type(), mesh(), &rays[i], &single);
            note(hits[i]);
            FUZZ_CHECK(same_bits(hits[i], single), "raycast_batch of a mesh gives the bits of raycast");
            FUZZ_CHECK(same_bits(distances[i], gphys_distance{single.t, 0, single.triangle}),
                       "raycast_distance_batch of a mesh gives the bits of raycast");
            FUZZ_CHECK(any[i] == (single.triangle != GPHYS_NO_TRIANGLE), "raycast_any_batch agrees with raycast");
        }
    }

    void segment() {
        const gphys_segment segment = p_.segment(), back{segment.b, segment.a};
        gphys_hit expected{}, hit{};
        bool any = false;
        for (uint32_t i = 0; i < source_.triangles(); ++i) {
            gphys_hit candidate;
            const gphys_triangle t = source_.triangle(i);
            if (call(gphys_shape_segment_test, gphys_shape_type{GPHYS_SHAPE_TRIANGLE}, &t, &segment, &candidate))
                continue;
            candidate.triangle = i;
            if (!any || candidate.t < expected.t) expected = candidate;
            any = true;
        }
        const gphys_status status = call(gphys_shape_segment_test, type(), mesh(), &segment, &hit);
        FUZZ_CHECK((status == GPHYS_OK) == any, "a segment meets a mesh where it meets a triangle");
        if (any) note(hit);
        if (any) FUZZ_CHECK(same_bits(hit, expected), "segment_test of a mesh gives the first hit");
        gphys_hit unused;
        FUZZ_CHECK(call(gphys_shape_segment_test, type(), mesh(), &back, &unused) == status,
                   "a segment and its reverse agree about a mesh");
    }

    void overlap() {
        const AnyShape shape = p_.shape(p_.shape_type(true));
        std::vector<uint32_t> expected;
        for (uint32_t i = 0; i < source_.triangles(); ++i) {
            const gphys_triangle t = source_.triangle(i);
            int32_t overlaps = 0;
            call(gphys_shape_overlaps, gphys_shape_type{GPHYS_SHAPE_TRIANGLE}, &t, shape.type, shape.bytes, &overlaps);
            if (overlaps) expected.push_back(i);
        }
        std::vector<uint32_t> found(source_.triangles() + 1);
        uint32_t total = 0;
        gphys_status status =
            call(gphys_mesh_overlap, mesh(), shape.type, shape.bytes, found.data(), source_.triangles(), &total);
        FUZZ_CHECK(status == GPHYS_OK && total <= source_.triangles(), "mesh_overlap lists each triangle once");
        found.resize(total);
        for (const uint32_t i : found) note(i);
        FUZZ_CHECK(std::is_sorted(found.begin(), found.end()), "mesh_overlap lists the triangles in order");
        std::vector<uint32_t> differing;
        std::set_symmetric_difference(found.begin(), found.end(), expected.begin(), expected.end(),
                                      std::back_inserter(differing));
        for (const uint32_t i : differing) {
            FUZZ_CHECK(!is_clear(AnyShape::of(GPHYS_SHAPE_TRIANGLE, source_.triangle(i)), shape),
                       "mesh_overlap lists the triangles that overlap");
        }
        const uint32_t capacity = p_.below(4);
        std::vector<uint32_t> lowest(capacity + 1);
        status = call(gphys_mesh_overlap, mesh(), shape.type, shape.bytes, capacity ? lowest.data() : nullptr, capacity,
                      &total);
        FUZZ_CHECK(status == (total > capacity ? GPHYS_INCOMPLETE : GPHYS_OK), "a list that is cut short says so");
        FUZZ_CHECK(total == found.size() &&
                       std::equal(found.begin(), found.begin() + std::min(total, capacity), lowest.begin()),
                   "what is kept of a list is its beginning");
        if (!differing.empty()) return;
        for (const bool mesh_first : {true, false}) {
            int32_t overlaps = -1;
            if (mesh_first) {
                call(gphys_shape_overlaps, type(), mesh(), shape.type, shape.bytes, &overlaps);
            } else {
                call(gphys_shape_overlaps, shape.type, shape.bytes, type(), mesh(), &overlaps);
            }
            FUZZ_CHECK(overlaps == !expected.empty(), "a mesh overlaps where a triangle does");
        }
    }

    void sweep() {
        const gphys_sphere sphere{p_.point(), p_.size()};
        const gphys_vec3 displacement = p_.direction();
        gphys_hit expected{}, hit{};
        bool any = false;
        for (uint32_t i = 0; i < source_.triangles(); ++i) {
            gphys_hit candidate;
            const gphys_triangle t = source_.triangle(i);
            if (call(gphys_shape_sweep_sphere, gphys_shape_type{GPHYS_SHAPE_TRIANGLE}, &t, &sphere, &displacement,
                     &candidate))
                continue;
            candidate.triangle = i;
            if (!any || candidate.t < expected.t) expected = candidate;
            any = true;
        }
        const gphys_status status = call(gphys_shape_sweep_sphere, type(), mesh(), &sphere, &displacement, &hit);
        FUZZ_CHECK((status == GPHYS_OK) == any, "a sweep touches a mesh where it touches a triangle");
        if (!any) return;
        note(hit);
        FUZZ_CHECK(hit.t == expected.t, "a sweep touches a mesh when it touches the first triangle");
        FUZZ_CHECK(hit.triangle == expected.triangle, "a sweep names the lowest of the triangles it touches first");
    }

    void closest_point() {
        const gphys_vec3 point = p_.point();
        float least = infinity, reach = 0;
        for (uint32_t i = 0; i < source_.triangles(); ++i) {
            const gphys_triangle t = source_.triangle(i);
            gphys_nearest near;
            call(gphys_shape_closest_point, gphys_shape_type{GPHYS_SHAPE_TRIANGLE}, &t, &point, &near);
            least = std::min(least, near.distance);
            for (const gphys_vec3& at : {t.a, t.b, t.c, point}) {
                reach = std::max({reach, std::fabs(at.x), std::fabs(at.y), std::fabs(at.z)});
            }
        }
        Output<gphys_nearest> near;
        const gphys_status status = call(gphys_shape_closest_point, type(), mesh(), &point, &near.value);
        near.after(status);
        FUZZ_CHECK((status == GPHYS_NO_HIT) == (source_.triangles() == 0), "only an empty mesh has no closest point");
        if (status != GPHYS_OK) return;
        const double bound = 0x1p-22 * least + 0x1p-38 * reach + 0x1p-140;
        FUZZ_CHECK(std::fabs(static_cast<double>(near.value.distance) - least) <= bound,
                   "a mesh is as near as its nearest triangle");
        FUZZ_CHECK(near.value.triangle < source_.triangles(), "the closest point names its triangle");
    }

    void contains() {
        const gphys_vec3 point = p_.point();
        const float tolerance = p_.one_in(2) ? 0.0f : p_.size();
        const AnyShape ball = AnyShape::of(GPHYS_SHAPE_SPHERE, gphys_sphere{point, tolerance});
        bool any = false, clear = true;
        for (uint32_t i = 0; i < source_.triangles(); ++i) {
            const AnyShape triangle = AnyShape::of(GPHYS_SHAPE_TRIANGLE, source_.triangle(i));
            const bool overlaps = fuzz::overlap(triangle, ball);
            any = any || overlaps;
            // The mesh leaves triangles out by boxes that are exact.
            clear = clear && (!overlaps || is_clear(triangle, ball));
        }
        int32_t contained = -1;
        call(gphys_shape_contains, type(), mesh(), &point, tolerance, &contained);
        FUZZ_CHECK((contained != 0) == any || !clear, "a point is within a tolerance of a mesh if it is of a triangle");
    }

    void mesh_with_mesh() {
        const Arrays other_arrays = arrays(p_);
        const MeshSource other(other_arrays.vertices, other_arrays.indices);
        const MeshHandle other_mesh = other.create();
        if (!other_mesh) return;
        bool any = false;
        for (uint32_t i = 0; i < source_.triangles() && !any; ++i) {
            const gphys_triangle t = source_.triangle(i);
            int32_t overlaps = 0;
            call(gphys_shape_overlaps, gphys_shape_type{GPHYS_SHAPE_TRIANGLE}, &t, type(), other_mesh.get(), &overlaps);
            any |= overlaps != 0;
        }
        int32_t overlaps = -1, back = -1;
        call(gphys_shape_overlaps, type(), mesh(), type(), other_mesh.get(), &overlaps);
        call(gphys_shape_overlaps, type(), other_mesh.get(), type(), mesh(), &back);
        FUZZ_CHECK(overlaps == any && back == any, "two meshes overlap where triangles do");
    }

    void contents() {
        const uint32_t vertex_count = static_cast<uint32_t>(source_.vertices().size());
        std::vector<gphys_vec3> vertices(vertex_count + 1);
        std::vector<uint32_t> indices(source_.indices().size() + 1);
        uint32_t total = 0;
        call(gphys_mesh_get_vertices, mesh(), vertices.data(), vertex_count, &total);
        FUZZ_CHECK(total == vertex_count, "a mesh keeps its vertices");
        FUZZ_CHECK(
            std::equal(source_.vertices().begin(), source_.vertices().end(), vertices.begin(), same_bits<gphys_vec3>),
            "a mesh keeps its vertices");
        call(gphys_mesh_get_indices, mesh(), indices.data(), static_cast<uint32_t>(source_.indices().size()), &total);
        FUZZ_CHECK(std::equal(source_.indices().begin(), source_.indices().end(), indices.begin()),
                   "a mesh keeps its indices");
        gphys_octree_stats stats;
        call(gphys_mesh_get_octree_stats, mesh(), &stats);
        FUZZ_CHECK(stats.item_count == source_.triangles(), "a mesh's tree holds its triangles");
        std::vector<gphys_octree_box> boxes(stats.node_count + 1);
        call(gphys_mesh_get_octree_boxes, mesh(), boxes.data(), stats.node_count, &total);
        FUZZ_CHECK(total <= stats.node_count + stats.leaf_count, "a tree has a box for each node");
        gphys_mesh_info info;
        call(gphys_mesh_get_info, mesh(), &info);
        FUZZ_CHECK(
            info.vertex_count == vertex_count && info.triangle_count == source_.triangles() && info.follows_body == 0,
            "a mesh knows what it is made of");
        gphys_mesh_report report;
        call(gphys_mesh_get_report, mesh(), &report);
        note(report);
        if (!made_up_) check_report({source_.vertices(), source_.indices()}, report);
        Output<gphys_aabb> box;
        const gphys_status status = call(gphys_shape_bounds, type(), mesh(), &box.value);
        box.after(status);
        FUZZ_CHECK((status == GPHYS_NO_HIT) == (source_.triangles() == 0), "only an empty mesh has no bounds");
        const gphys_transform identity{{0, 0, 0}, {0, 0, 0, 1}, 1};
        FUZZ_CHECK(call(gphys_shape_transform, type(), mesh(), &identity, &report) == GPHYS_ERROR_UNSUPPORTED,
                   "a mesh is not moved");
        FUZZ_CHECK(call(gphys_shape_validate, type(), mesh()) == GPHYS_OK, "a mesh is valid");
    }

    /// From here on the mesh is one of a snapshot, of which words may have been made up: then its triangles are what it
    /// says that they are.
    void reload() {
        uint32_t total = 0;
        FUZZ_CHECK(call(gphys_mesh_get_snapshot, mesh(), nullptr, 0u, &total) == GPHYS_INCOMPLETE,
                   "no snapshot has no words");
        std::vector<uint32_t> words(total);
        FUZZ_CHECK(
            call(gphys_mesh_get_snapshot, mesh(), words.data(), total, &total) == GPHYS_OK && total == words.size(),
            "a snapshot of a mesh is taken");
        const bool forged = p_.one_in(2);
        if (forged) forge(words);
        gphys_mesh* loaded = nullptr;
        const gphys_status status =
            call(gphys_mesh_create_from_snapshot, nullptr, words.data(), static_cast<uint32_t>(words.size()), &loaded);
        FUZZ_CHECK((loaded != nullptr) == (status == GPHYS_OK), "a mesh that is refused is not there");
        FUZZ_CHECK(forged || loaded, "the snapshot of a mesh is a mesh");
        if (!loaded) return;
        mesh_.reset(loaded);
        if (!forged) return;
        made_up_ = true;
        std::vector<gphys_vec3> vertices;
        std::vector<uint32_t> indices;
        call(gphys_mesh_get_vertices, mesh(), nullptr, 0u, &total);
        vertices.resize(total);
        call(gphys_mesh_get_vertices, mesh(), vertices.data(), total, &total);
        call(gphys_mesh_get_indices, mesh(), nullptr, 0u, &total);
        indices.resize(total);
        call(gphys_mesh_get_indices, mesh(), indices.data(), total, &total);
        source_ = MeshSource(vertices, indices);
    }

    /// Change words and mend the checksum.
    void forge(std::vector<uint32_t>& words) {
        for (uint32_t changes = 1 + p_.below(3); changes > 0; --changes) {
            const uint32_t first = gphys::snapshot_header_words;
            const auto any = [&] { return first + p_.below(static_cast<uint32_t>(words.size()) - first); };
            uint32_t& word = words[any()];
            const uint32_t likely[] = {0,          1,          7,          8,        15,       16,
                                       0x80000000, 0xffffffff, 0x7fc00000, word + 1, word - 1, word ^ 0x80000000};
            word = p_.one_in(3) ? words[any()] : p_.one_in(4) ? p_.word() : likely[p_.below(std::size(likely))];
        }
        const uint64_t sum = gphys::mesh_snapshot_checksum(words.data(), static_cast<uint32_t>(words.size()));
        words[3] = static_cast<uint32_t>(sum);
        words[4] = static_cast<uint32_t>(sum >> 32);
    }

    void misuse() {
        gphys_ray ray = p_.ray();
        p_.spoil(ray, 2);
        AnyShape shape = p_.shape(p_.shape_type(true));
        p_.spoil(shape, 2);
        uint32_t total = 77;
        gphys_hit hit;
        uint32_t triangle = 0;
        const gphys_status cast = call(gphys_mesh_raycast_all, mesh(), &ray, &hit, 1u, &total);
        FUZZ_CHECK((cast >= 0) == is_valid(ray), "a mesh takes valid rays only");
        const gphys_status met = call(gphys_mesh_overlap, mesh(), shape.type, shape.bytes, &triangle, 1u, &total);
        FUZZ_CHECK((met >= 0) == is_valid(shape), "a mesh takes valid shapes only");
        int32_t any = 0;
        gphys_mesh* made = nullptr;
        const gphys_status refused[] = {call(gphys_mesh_raycast_all, nullptr, &ray, &hit, 1u, &total),
                                        call(gphys_mesh_raycast_all, mesh(), nullptr, &hit, 1u, &total),
                                        call(gphys_mesh_raycast_all, mesh(), &ray, nullptr, 1u, &total),
                                        call(gphys_mesh_raycast_all, mesh(), &ray, &hit, 1u, nullptr),
                                        call(gphys_mesh_raycast_any, nullptr, &ray, &any),
                                        call(gphys_mesh_raycast_any, mesh(), &ray, nullptr),
                                        call(gphys_mesh_overlap, mesh(), shape.type, nullptr, &triangle, 1u, &total),
                                        call(gphys_mesh_overlap, mesh(), type(), mesh(), &triangle, 1u, &total),
                                        call(gphys_mesh_get_info, mesh(), nullptr),
                                        call(gphys_mesh_get_report, mesh(), nullptr),
                                        call(gphys_mesh_get_report, nullptr, nullptr),
                                        call(gphys_mesh_get_vertices, mesh(), nullptr, 1u, &total),
                                        call(gphys_mesh_get_indices, nullptr, nullptr, 0u, &total),
                                        call(gphys_mesh_get_octree_stats, mesh(), nullptr),
                                        call(gphys_mesh_get_octree_boxes, mesh(), nullptr, 1u, nullptr),
                                        call(gphys_mesh_get_snapshot, mesh(), nullptr, 1u, &total),
                                        call(gphys_mesh_get_snapshot, nullptr, &triangle, 1u, &total),
                                        call(gphys_mesh_create_from_snapshot, nullptr, &triangle, 1u, &made),
                                        call(gphys_mesh_create_from_snapshot, nullptr, nullptr, 0u, &made),
                                        call(gphys_mesh_create_from_snapshot, nullptr, &triangle, 1u, nullptr)};
        for (const gphys_status status : refused) FUZZ_CHECK(status < 0, "a call that makes no sense is refused");
    }

    Program& p_;
    MeshSource source_;
    MeshHandle mesh_;
    bool made_up_ = false;  // then the report may be wrong
};

/// A deformable mesh takes other vertices, with the answers of one made of them.
void deform(Program& p, const Arrays& a) {
    const uint32_t vertex_count = static_cast<uint32_t>(a.vertices.size());
    const uint32_t index_count = static_cast<uint32_t>(a.indices.size());
    const auto make = [&](const std::vector<gphys_vec3>& vertices, int32_t deformable) {
        gphys_mesh_desc desc;
        call(gphys_mesh_desc_init, &desc, uint32_t{sizeof desc});
        desc.deformable = deformable;
        gphys_mesh* mesh = nullptr;
        call(gphys_mesh_create, &desc, reinterpret_cast<const float*>(vertices.data()), 12u, vertex_count,
             a.indices.data(), index_count, &mesh);
        return mesh;
    };
    gphys_mesh* const mesh = make(a.vertices, 1);
    std::vector<gphys_vec3> vertices = a.vertices, wanted = a.vertices;
    for (int i = 0; i < 4 && !p.done(); ++i) {
        for (gphys_vec3& v : wanted) {
            if (p.one_in(2)) v = p.point();
        }
        if (!wanted.empty()) p.spoil(wanted[p.below(vertex_count)], 12);
        const bool valid = std::all_of(wanted.begin(), wanted.end(), [](const gphys_vec3& v) { return is_valid(v); });
        const gphys_status set =
            call(gphys_mesh_set_vertices, mesh, reinterpret_cast<const float*>(wanted.data()), 12u, vertex_count);
        FUZZ_CHECK((set == GPHYS_OK) == valid, "a mesh takes valid vertices");
        valid ? vertices = wanted : wanted = vertices;
        gphys_mesh* const fresh = make(vertices, 0);
        const gphys_ray ray = p.ray();
        gphys_hit hits[2] = {}, all[2][8] = {};
        uint32_t counts[2] = {};
        gphys_nearest near[2] = {};
        const gphys_vec3 point = p.point();
        gphys_status answers[2][3];
        for (int k = 0; k < 2; ++k) {
            gphys_mesh* const asked = k == 0 ? mesh : fresh;
            answers[k][0] = call(gphys_shape_raycast, gphys_shape_type{GPHYS_SHAPE_MESH}, asked, &ray, &hits[k]);
            answers[k][1] =
                call(gphys_shape_closest_point, gphys_shape_type{GPHYS_SHAPE_MESH}, asked, &point, &near[k]);
            answers[k][2] = call(gphys_mesh_raycast_all, asked, &ray, all[k], 8u, &counts[k]);
        }
        FUZZ_CHECK(same_bits(answers[0], answers[1]) && same_bits(hits[0], hits[1]) && same_bits(near[0], near[1]) &&
                       same_bits(all[0], all[1]) && counts[0] == counts[1],
                   "a mesh that was deformed answers as one of the same vertices");
        call(gphys_mesh_destroy, fresh);
    }
    call(gphys_mesh_destroy, mesh);
}

/// What overlaps a hull, which a scene may have scaled, gets out of it and is not swept anywhere; nor has a hull a
/// back.
void meet(Program& p, const gphys_mesh* hull) {
    constexpr gphys_shape_type solids[] = {GPHYS_SHAPE_CAPSULE, GPHYS_SHAPE_AABB, GPHYS_SHAPE_OBB};
    constexpr float scales[] = {1, 1, 0.5f, 4};
    const AnyShape moving = p.shape(solids[p.below(3)]);
    const gphys_vec3 way = p.direction();
    gphys_model_desc desc;
    call(gphys_model_desc_init, &desc, uint32_t{sizeof desc});
    desc.scale = {scales[p.below(4)], scales[p.below(4)], scales[p.below(4)]};
    if (!is_valid(moving)) return;
    gphys_scene* scene = nullptr;
    gphys_model_id model = 0;
    call(gphys_scene_create, nullptr, &scene);
    if (call(gphys_scene_add, scene, gphys_shape_type{GPHYS_SHAPE_MESH}, hull, nullptr, &desc, &model) == GPHYS_OK) {
        gphys_penetration out{};
        gphys_hit hit{};
        uint32_t ways = 0;
        call(gphys_scene_penetration, scene, moving.type, moving.bytes, ~0u, &out, 1u, &ways);
        const gphys_status swept = call(gphys_scene_sweep, scene, moving.type, moving.bytes, &way, ~0u, &hit);
        FUZZ_CHECK(ways <= 1 && (ways == 0 || out.triangle == GPHYS_NO_TRIANGLE), "there is one way out of a hull");
        FUZZ_CHECK(ways == 0 || (swept == GPHYS_OK && (hit.flags & GPHYS_HIT_INSIDE) != 0 && hit.t == 0),
                   "what overlaps a hull is met by it at the start");
        FUZZ_CHECK(swept != GPHYS_OK || (hit.flags & GPHYS_HIT_BACK) == 0, "a hull has no back for solids");
    }
    call(gphys_scene_destroy, scene);
}

/// The hull of points holds them all, and its own vertices make it again.
void enclose(Program& p, std::vector<gphys_vec3> points) {
    const auto make = [](const std::vector<gphys_vec3>& of, gphys_mesh*& out) {
        return call(gphys_mesh_create_hull, nullptr, reinterpret_cast<const float*>(of.data()), 12u,
                    static_cast<uint32_t>(of.size()), &out);
    };
    gphys_mesh *hull = nullptr, *again = nullptr;
    const bool valid = std::all_of(points.begin(), points.end(), [](const gphys_vec3& v) { return is_valid(v); });
    if (!valid) {
        const MayRaise signalling_nans;  // which the check looks at
        FUZZ_CHECK(make(points, hull) == GPHYS_ERROR_INVALID_ARGUMENT, "a hull is made of valid points");
        return;
    }
    if (make(points, hull) != GPHYS_OK) return;
    for (const gphys_vec3& point : points) {
        int32_t holds = 0;
        call(gphys_shape_contains, gphys_shape_type{GPHYS_SHAPE_MESH}, hull, &point, 0.0f, &holds);
        FUZZ_CHECK(holds == 1, "a hull holds its points");
    }
    uint32_t total = 0, triangles = 0;
    call(gphys_mesh_get_hull_planes, hull, nullptr, 0u, &total);
    call(gphys_mesh_get_hull_faces, hull, nullptr, 0u, &triangles);
    std::vector<gphys_plane> planes(total);
    std::vector<uint32_t> faces(triangles);
    call(gphys_mesh_get_hull_planes, hull, planes.data(), total, &total);
    call(gphys_mesh_get_hull_faces, hull, faces.data(), triangles, &triangles);
    FUZZ_CHECK(total >= 4 && total <= 256 && faces.back() == total - 1, "a hull has 4 to 256 faces");
    call(gphys_mesh_get_vertices, hull, nullptr, 0u, &total);
    std::vector<gphys_vec3> vertices(total);
    call(gphys_mesh_get_vertices, hull, vertices.data(), total, &total);
    FUZZ_CHECK(make(vertices, again) == GPHYS_OK, "the vertices of a hull have a hull");
    const gphys_ray ray = p.ray();
    gphys_hit hits[2] = {};
    gphys_status met[2];
    for (int k = 0; k < 2; ++k) {
        met[k] = call(gphys_shape_raycast, gphys_shape_type{GPHYS_SHAPE_MESH}, k == 0 ? hull : again, &ray, &hits[k]);
    }
    FUZZ_CHECK(met[0] == met[1] && same_bits(hits[0], hits[1]), "the vertices of a hull have the same hull");
    FUZZ_CHECK(met[0] != GPHYS_OK || (hits[0].flags & GPHYS_HIT_BACK) == 0, "a hull has no back");
    meet(p, hull);
    call(gphys_mesh_destroy, again);
    call(gphys_mesh_destroy, hull);
}

/// Arrays that may be spoiled: examined, then refused or taken as the examination says.
void build(Program& p) {
    Arrays a = arrays(p);
    if (!a.vertices.empty() && p.one_in(4)) p.spoil(a.vertices[p.below(static_cast<uint32_t>(a.vertices.size()))], 1);
    if (!a.indices.empty() && p.one_in(6)) a.indices[p.below(static_cast<uint32_t>(a.indices.size()))] = p.word();
    if (!a.indices.empty() && p.one_in(10)) a.indices.pop_back();
    const uint32_t strides[] = {12, 12, 12, 16, 0, 8, 13};
    const uint32_t stride = strides[p.below(7)];
    std::vector<float> vertices(a.vertices.size() * 4 + 4);
    for (size_t i = 0; i < a.vertices.size() && stride % 4 == 0; ++i) {
        std::memcpy(&vertices[i * stride / 4], &a.vertices[i], sizeof(gphys_vec3));
    }
    const bool fine_stride = stride == 12 || stride == 16;
    const uint32_t vertex_count = static_cast<uint32_t>(a.vertices.size());
    const uint32_t index_count = static_cast<uint32_t>(a.indices.size());
    Output<gphys_mesh_report> report;
    const MayRaise signalling_nans;  // which the examination looks at
    const gphys_status checked =
        call(gphys_mesh_check, vertices.data(), stride, vertex_count, a.indices.data(), index_count, &report.value);
    report.after(checked);
    if (fine_stride && index_count % 3 == 0) {
        FUZZ_CHECK(checked == GPHYS_OK, "arrays of any contents are examined");
        check_report(a, report.value);
    }
    FUZZ_CHECK(fine_stride || checked < 0, "a vertex stride that is none is refused");
    gphys_mesh_desc desc;
    const uint32_t desc_size = p.one_in(8) ? p.byte() : static_cast<uint32_t>(sizeof desc);
    std::vector<unsigned char> desc_room(256);
    if (call(gphys_mesh_desc_init, reinterpret_cast<gphys_mesh_desc*>(desc_room.data()), desc_size) != GPHYS_OK) return;
    gphys_mesh* mesh = nullptr;
    const gphys_status made = call(gphys_mesh_create, reinterpret_cast<const gphys_mesh_desc*>(desc_room.data()),
                                   vertices.data(), stride, vertex_count, a.indices.data(), index_count, &mesh);
    const bool sound = fine_stride && checked == GPHYS_OK && index_count % 3 == 0 &&
                       report.value.bad_vertex_count == 0 && report.value.out_of_range_count == 0;
    FUZZ_CHECK((made == GPHYS_OK) == sound, "a mesh is built exactly of what its examination finds no fault with");
    FUZZ_CHECK((mesh != nullptr) == (made == GPHYS_OK), "a mesh that is refused is not there");
    call(gphys_mesh_destroy, mesh);
    if (sound) deform(p, a);
    enclose(p, a.vertices);
}

}  // namespace

void run(Program& p) {
    for (int i = 0; i < 8 && !p.done(); ++i) {
        if (p.one_in(3)) {
            build(p);
            continue;
        }
        const Arrays a = arrays(p);
        if (!std::all_of(a.vertices.begin(), a.vertices.end(), [](const gphys_vec3& v) { return is_valid(v); }))
            continue;
        MeshUnderTest mesh(p, a);
        for (int k = 0; k < 16 && !p.done(); ++k) mesh.ask();
    }
}

}  // namespace fuzz
