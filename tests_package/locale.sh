#!/usr/bin/env bash
# Messages have numbers with a point in every locale of the host: with a comma, and with a separator of two bytes.
source "$SOURCE/tests_package/common.sh"
[ -f /usr/share/i18n/locales/de_DE ] && [ -f /usr/share/i18n/locales/ps_AF ] && command -v localedef >/dev/null || {
    echo "the sources of locales are not installed"
    exit 77
}
cat >message.c <<'END'
#include <gamephys_c.h>
#include <locale.h>
#include <stdio.h>

int main(void) {
    gphys_sphere ball = {{0, 0, 0}, -2.5f};
    const gphys_ray ray = {{0, 0, 0}, {1, 0, 0}, -1.5e-9f};
    gphys_hit hit;
    if (!setlocale(LC_ALL, "")) return 1;
    printf("%g\n", 2.5);
    if (gphys_shape_validate(GPHYS_SHAPE_SPHERE, &ball) >= 0) return 1;
    puts(gphys_last_error());
    ball.radius = 1;
    if (gphys_shape_raycast(GPHYS_SHAPE_SPHERE, &ball, &ray, &hit) >= 0) return 1;
    puts(gphys_last_error());
    return 0;
}
END
"$CC" -I"$INSTALLED/include" message.c -L"$INSTALLED/$LIBDIR" -lgamephys -o message

# messages LOCALE SEPARATOR: printf writes this separator, and the library a point.
messages() {
    mkdir -p locales
    localedef -c -i "$1" -f UTF-8 "$PWD/locales/$1.UTF-8" 2>localedef.log || [ -f "locales/$1.UTF-8/LC_NUMERIC" ] || fail "$(cat localedef.log)"
    LOCPATH=$PWD/locales LC_ALL=$1.UTF-8 LD_LIBRARY_PATH=$INSTALLED/$LIBDIR ./message >"$1.txt" || fail "$1: $(cat "$1.txt")"
    printf '%s\n' "2${2}5" 'gphys_shape_validate: sphere.radius -2.5 is not from 0 to 1e15' \
        'gphys_shape_raycast: ray.t_max -1.5e-09 is not 0 or more' | diff - "$1.txt" || fail "$1: other messages"
}
messages de_DE ,
messages ps_AF $'\u066b'
