#!/usr/bin/env bash
# What registries show of a package: each manifest has a description of one sentence, keywords where the format has
# them, and the licence.
source "$SOURCE/tests_package/common.sh"
summary='A 3D scene library: ray casts, overlap and nearest queries, culling, picking, ropes and cloth'

# has FILE PATTERN...: each pattern is in it.
has() {
    local file=$1 pattern
    for pattern in "${@:2}"; do
        grep -qE "$pattern" "$SOURCE/$file" || fail "$file has no line like: $pattern"
    done
}
has bindings/python/build_wheel.py "^Summary: $summary\$" '^Keywords: .+,' '^License-Expression: MIT$' '^License-File: LICENSE$'
has bindings/javascript/package.json '^  "description": "3D .+"' '^  "keywords": \[.+\]' '^  "license": "MIT"'
has bindings/rust/Cargo.toml "^description = \"$summary\"" '^keywords = \[.+\]' '^categories = \[.+\]' '^license = "MIT"' '^readme = "README.md"'
has bindings/ruby/gamephys.gemspec "spec\.summary = '$summary'" "spec\.description = '.+'" "spec\.license = 'MIT'"
has bindings/lua/gamephys-scm-1.rockspec "summary = '$summary'" "detailed = '.+'" "license = 'MIT'" 'labels = \{.+\}'
has bindings/csharp/Gamephys.csproj "<Description>$summary\.<" '<PackageTags>.+<' '<PackageLicenseExpression>MIT<' '<PackageReadmeFile>README.md<'
has packaging/Gamephys.Mono.nuspec "<description>$summary\.<" '<tags>.+<' '<copyright>.*MIT licence<' 'src="LICENSE"' 'src="README.md"'
has packaging/pom.xml.in "<description>$summary\.<" '<name>MIT<'
has packaging/vcpkg/vcpkg.json '"description": "3D .+"' '"license": "MIT"'
has packaging/conan/conanfile.py 'description = "3D .+"' 'topics = \(.+\)' 'license = "MIT"'
