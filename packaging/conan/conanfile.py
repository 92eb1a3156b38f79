"""The Conan 2 recipe: conan create packaging/conan, from a tree of the sources."""
import os
import re

from conan import ConanFile
from conan.errors import ConanInvalidConfiguration
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load, rmdir

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")


class Gamephys(ConanFile):
    name = "gamephys"
    description = "3D scene queries, camera, ropes and cloth behind a stable C interface"
    license = "MIT"
    topics = ("physics", "raycast", "bvh", "cloth")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False], "fPIC": [True, False]}
    default_options = {"shared": True, "fPIC": True}
    implements = ["auto_shared_fpic"]

    def set_version(self):
        header = load(self, os.path.join(ROOT, "include", "gamephys_c.h"))
        self.version = ".".join(re.findall(r"#define GPHYS_VERSION_\w+ (\d+)", header))

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "LICENSE", "cmake/*", "include/*", "pkgconfig/*", "src/*",
                        "bindings/cpp/gamephys/*", "bindings/gamephys_api.json"):
            copy(self, pattern, src=ROOT, dst=self.export_sources_folder)

    def validate(self):
        check_min_cppstd(self, 17)
        if self.settings.compiler == "msvc":
            raise ConanInvalidConfiguration("gamephys needs gcc or clang")

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables.update(GAMEPHYS_TESTS="OFF", GAMEPHYS_EXAMPLES=False, GAMEPHYS_BENCH=False,
                                         GAMEPHYS_SHARED=bool(self.options.shared))
        toolchain.generate()
        CMakeDeps(self).generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "LICENSE", src=self.source_folder, dst=os.path.join(self.package_folder, "licenses"))
        CMake(self).install()
        rmdir(self, os.path.join(self.package_folder, "lib", "cmake"))
        rmdir(self, os.path.join(self.package_folder, "lib", "pkgconfig"))

    def package_info(self):
        self.cpp_info.libs = ["gamephys"]
        self.cpp_info.set_property("cmake_file_name", "gamephys")
        self.cpp_info.set_property("cmake_target_name", "gamephys::gamephys")
        self.cpp_info.set_property("pkg_config_name", "gamephys")
        if self.settings.os in ("Linux", "FreeBSD"):
            self.cpp_info.system_libs = [] if self.options.shared else ["m", "pthread", "stdc++"]
