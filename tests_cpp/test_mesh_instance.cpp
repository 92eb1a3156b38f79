#include "mesh/mesh_instance.h"

#include "meshes.h"
#include "scene/conservative_tests.h"

using namespace gphys;

namespace {

/// On a coarse lattice rays run along faces, through edges and into corners.
class Lattice {
public:
    float number(int extent, bool coarse) {
        const float reach = static_cast<float>(extent), value = random_.uniform_float(-reach, reach);
        return coarse ? std::round(value) : value;
    }
    gphys_vec3 point(int extent, bool coarse) {
        return {number(extent, coarse), number(extent, coarse), number(extent, coarse)};
    }
    gphys_transform transform(bool coarse) {
        const Quat turn = normalized(Quat{number(1, false), number(1, false), number(1, false), 1.01});
        return {point(5, coarse), coarse ? gphys_quat{0, 0, 0, 1} : narrow(turn),
                coarse ? 2.0f : random_.uniform_float(0.2f, 3)};
    }
    Ray ray(bool coarse) {
        return {widen(point(6, coarse)), widen(point(3, coarse)),
                random_.index(3) == 0 ? infinity : std::fabs(double{number(5, coarse)})};
    }

private:
    test::Random random_{91};
};

bool holds(const Box& box, Vec3 point) {
    for (int k = 0; k < 3; ++k) {
        if (point[k] < box.min[k] || point[k] > box.max[k]) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("the box of a placed mesh holds its triangles, and of a round one little else") {
    const test::Arrays round = test::sphere(3).placed({4, -2, 1}, {1, 1, 1});
    const test::Arrays rod = test::sphere(2).placed({0, 3, 0}, {5, 0.1, 0.1});
    Lattice lattice;
    for (const test::Arrays* arrays : {&round, &rod}) {
        Mesh* mesh = arrays->make();
        for (int i = 0; i < 500; ++i) {
            const Transform world = widen(lattice.transform(i % 2 == 0));
            const Box box = bounds(MeshInstance{*mesh, world});
            for (const gphys_vec3& vertex : arrays->vertices) REQUIRE(holds(box, world.apply(widen(vertex))));
            if (arrays != &round) continue;
            for (int k = 0; k < 3; ++k) REQUIRE(box.max[k] - box.min[k] < 2 * world.scale + 1e-5);
        }
        Mesh::release(mesh);
    }
}

TEST_CASE("a ray that meets a mesh is never held off by what encloses it") {
    const test::Arrays shapes[] = {test::sphere(0), test::sphere(2).placed({1, 0, 2}, {3, 1, 1})};
    Lattice lattice;
    for (const test::Arrays& arrays : shapes) {
        Mesh* mesh = arrays.make();
        int met = 0, conservative_no = 0;
        for (int i = 0; i < 40000; ++i) {
            const bool coarse = i % 2 == 0;
            const gphys_transform stored = lattice.transform(coarse);
            const Transform world = widen(stored);
            const Ray ray = lattice.ray(coarse);
            const Ray local{world.inverse_apply(ray.origin), world.inverse_apply_to_vector(ray.direction), ray.t_max};
            Hit expected, hit;
            const bool truth = mesh->raycast(local, expected);
            met += truth;
            const MeshInstance instance{*mesh, world};
            REQUIRE(raycast(instance, ray, hit) == truth);
            REQUIRE(raycast_any(instance, ray) == truth);
            REQUIRE((!truth || (hit.t == expected.t && hit.triangle == expected.triangle)));
            const ModelMesh held{mesh, no_scale};
            const ConservativeRay quick(ray);
            const TriState verdict =
                conservative_verdict(held, stored, [&](const auto& shape) { return quick(shape, ray.t_max); });
            REQUIRE(verdict != TriState::yes);
            REQUIRE_FALSE((truth && verdict == TriState::no));
            conservative_no += verdict == TriState::no;
        }
        CHECK(met > 500);
        CHECK(conservative_no > 20000);
        Mesh::release(mesh);
    }
}

TEST_CASE("a ray that a kernel transforms gets the bits of one that scalar code transforms, on every instruction set") {
    test::Arrays flat = test::sphere(2).placed({1, 0, 2}, {3, 1, 1});
    flat.add(0, 0, 5);  // without a normal
    flat.add(3, 2, 3);
    const test::Arrays shapes[] = {test::sphere(1), flat, test::sphere(2).placed({-40, 3, 7}, {9, 0.001, 2})};
    const auto bits_differ = [](const auto& a, const auto& b) { return std::memcmp(&a, &b, sizeof a) != 0; };
    for (const Isa isa : test::isas()) {
        Lattice lattice;
        int met = 0, differ = 0;
        for (const test::Arrays& arrays : shapes) {
            Mesh* mesh = arrays.make(nullptr, isa);
            const Vec3 middle = mesh->center();
            for (int i = 0; i < 12000; ++i) {
                const bool coarse = i % 2 == 0;
                gphys_transform stored = lattice.transform(coarse);
                if (i % 5 == 0) stored.scale = 0x1p-3f;
                const AxisScale axes(i % 3 == 0 ? Vec3{2, 0.5f, 1.25f} : Vec3{1, 1, 1});
                const Transform world = widen(stored);
                const MeshInstance instance{*mesh, world, axes};
                Ray ray = lattice.ray(coarse);
                if (i % 4 != 0) ray.origin = ray.origin + instance.place().apply(middle);
                if (i % 7 == 0) ray.faces.back = false;
                if (i % 11 == 0) ray.faces.front = false;
                const PlacedMesh placed{*mesh, stored, axes.by};
                REQUIRE(mesh->crosses_placed(ray));

                Hit exact;
                gphys_hit hit{}, expected{};
                const bool truth = raycast(instance, ray, exact);
                if (truth) expected = to_hit(exact);
                met += truth;
                differ += raycast(placed, ray, hit) != truth || bits_differ(hit, expected);
                differ += raycast_any(placed, ray) != truth;
                gphys_distance distance{}, expected_distance{};
                const bool found = raycast_distance(placed, ray, distance);
                raycast_distance(instance, ray, expected_distance);
                differ += found != truth || bits_differ(distance, expected_distance);

                Hit own;
                gphys_hit rounded{}, expected_own{};
                if (mesh->raycast(ray, own)) expected_own = to_hit(own);
                mesh->raycast(ray, rounded);
                differ += bits_differ(rounded, expected_own);
            }
            Mesh::release(mesh);
        }
        INFO(name_of(isa));
        CHECK(differ == 0);
        CHECK(met > 2000);
    }
}
