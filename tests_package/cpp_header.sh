#!/usr/bin/env bash
# The header for C++ is installed beside that for C: a program that includes it needs nothing but
# what pkg-config says.
source "$SOURCE/tests_package/common.sh"

cat >client.cpp <<'END'
#include <gamephys.hpp>

int main() {
    gamephys::Scene scene;
    const auto ball = scene.add(gamephys::Sphere{{0, 0, 5}, 1});
    const auto hit = scene.raycast({{0, 0, 0}, {0, 0, 1}, 100});
    return hit && hit->model == ball && hit->t == 4 ? 0 : 1;
}
END
export PKG_CONFIG_PATH=$INSTALLED/$LIBDIR/pkgconfig
"$CXX" -std=c++17 client.cpp $(pkg-config --cflags --libs gamephys) -o client
LD_LIBRARY_PATH=$INSTALLED/$LIBDIR ./client
