# Sourced by scripts that look at gamephys as a part of another project.

# parent NAME OPTION...: configures the project in the folder parent, which writes NAME/compile_commands.json.
parent() {
    local name=$1
    shift
    "$CMAKE" -S "$here/parent" -B "$name" -G Ninja -DGAMEPHYS_SOURCE="$SOURCE" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON \
        -DCMAKE_C_COMPILER="$CC" -DCMAKE_CXX_COMPILER="$CXX" "$@" >"$name.log" 2>&1
}

# compiled NAME FILE: how that file is compiled there, a line for each time.
compiled() {
    sed -n 's/^ *"command": "\(.*\)",*$/\1/p' "$1/compile_commands.json" | grep -E -- "-c [^ ]*$2\$"
}

# everywhere NAME PATTERN: the pattern matches each command that compiles gamephys.
everywhere() {
    compiled "$1" '/src/[^ ]*\.cpp' >commands.txt
    [ "$(wc -l <commands.txt)" -gt 100 ] || fail "$1: the commands were not found"
    ! grep -vE -- "$2" commands.txt >without.txt || fail "$1: $2 is not in: $(head -n 1 without.txt)"
}

# nowhere NAME PATTERN
nowhere() {
    compiled "$1" '/src/[^ ]*\.cpp' >commands.txt
    [ "$(wc -l <commands.txt)" -gt 100 ] || fail "$1: the commands were not found"
    expect_no_match "$1: $2" -E -- "$2" commands.txt
}
