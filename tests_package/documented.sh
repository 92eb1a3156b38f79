# Sourced by scripts that look at the comments of generated bindings.

# comments_of FILE: the comment lines of a generated file.
comments_of() {
    case $1 in
        *.py) awk '/"""/ { n = gsub(/"""/, "&"); print; if (n == 1) inside = !inside; next } inside' "$1" ;;
        *.rb) grep -E '^ *#' "$1" ;;
        *.lua) grep -E '^ *---' "$1" ;;
        *.java | *.ts) grep -E '^ *(/\*\*|\*)' "$1" ;;
        *) grep -E '^[[:space:]]*//' "$1" ;;
    esac
}

# comments_in_own_terms BINDINGS
comments_in_own_terms() {
    local file sample lines
    for file in python/gamephys/_objects.py csharp/src/Objects.cs go/objects.go javascript/index.d.ts lua/gamephys/methods.lua \
        ruby/lib/gamephys/methods.rb rust/src/objects.rs cpp/gamephys/gamephys.hpp \
        java/src/main/java/gamephys/{Scene,Mesh,Camera,Solver,Gamephys}.java; do
        comments_of "$1/$file" | grep -v 'Generated from\|[oO]wns a `\{0,1\}gphys_\|such as "GPHYS_NO_HIT"' >comments.txt || fail "$file has no comments"
        expect_no_match "$file speaks C" -nE '\bNULL\b|\bgphys_|\bstride\b|\bout_[a-z]|\bcapacity\b|@return(s)? *GPHYS|struct_size' comments.txt
        case $file in
            *.hpp) ;; # C++ has the header's constants
            *) expect_no_match "$file speaks C" -nE '\bGPHYS_' comments.txt ;;
        esac
    done
    # FILE, then text that its comments have: a result that may be missing, an error, a parameter, another method.
    while IFS='|' read -r file sample; do
        comments_of "$1/$file" | sed -E 's,^[[:space:]]*(///|//|---|\*|#)? ?,,' | tr '\n' ' ' | tr -s ' ' >comments.txt
        grep -qF -e "$sample" comments.txt || fail "$file does not say: $sample"
    done <<'END'
python/gamephys/_objects.py|Returns: None for a plane.
python/gamephys/_objects.py|Error, status ERROR_CYCLE: if parent is the model or one of its descendants
python/gamephys/_objects.py|as Scene.set_transform for what moves
csharp/src/Objects.cs|<returns>null for a plane.</returns>
csharp/src/Objects.cs|<exception cref="GamephysException">Status.ErrorCycle: if parent
csharp/src/Objects.cs|<param name="keepWorld">false: the local transform is kept
go/objects.go|Result: found is false for a plane.
go/objects.go|The error is ErrCycle if parent
go/objects.go|- keepWorld: false: the local transform
java/src/main/java/gamephys/Scene.java|@return empty for a plane.
java/src/main/java/gamephys/Scene.java|@throws GamephysException with ERROR_CYCLE: if parent
java/src/main/java/gamephys/Scene.java|@param keepWorld false: the local
javascript/index.d.ts|@returns null for a plane.
javascript/index.d.ts|@throws {GamephysError} ERROR_CYCLE: if parent
lua/gamephys/methods.lua|@return nil for a plane.
lua/gamephys/methods.lua|@raise status ERROR_CYCLE: if parent
ruby/lib/gamephys/methods.rb|@return nil for a plane.
ruby/lib/gamephys/methods.rb|@raise [Error] if parent is the model or one of its descendants (ERROR_CYCLE)
rust/src/objects.rs|Returns `None` for a plane.
rust/src/objects.rs|# Errors * `Status::ERROR_CYCLE`: if parent
cpp/gamephys/gamephys.hpp|Result: std::nullopt for a plane.
cpp/gamephys/gamephys.hpp|Throws Error with GPHYS_ERROR_CYCLE if parent
END
}
