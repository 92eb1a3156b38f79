<?php
// The library through PHP's FFI, from the preprocessed header: cc -E -P gamephys_c.h >gamephys_c.i

$gp = FFI::cdef(file_get_contents(getenv('GAMEPHYS_HEADER')), getenv('GAMEPHYS_LIBRARY') ?: 'libgamephys.so.1');
const ALL_LAYERS = 0xffffffff; // a macro in C, which the preprocessor has taken away

/** An outcome that is not an error is handed on. */
function must(int $status): int
{
    global $gp;
    return $status >= 0 ? $status : throw new RuntimeException($gp->gphys_last_error(), $status);
}

/** An object of the library, which destroy frees. */
function made(string $type, callable $create): FFI\CData
{
    global $gp;
    $object = $gp->new("$type*");
    must($create(FFI::addr($object)));
    return $object;
}

/** A struct or an array of structs, from its fields in order. */
function value(string $type, array $fields): FFI\CData
{
    global $gp;
    $value = $gp->new($type);
    fill($value, $fields);
    return $value;
}

function fill(FFI\CData $value, array $fields): void
{
    $type = FFI::typeof($value);
    $names = $type->getKind() === FFI\CType::TYPE_STRUCT ? $type->getStructFieldNames() : null;
    foreach ($fields as $i => $field) {
        if (is_array($field)) {
            fill($names ? $value->{$names[$i]} : $value[$i], $field);
        } elseif ($names) {
            $value->{$names[$i]} = $field;
        } else {
            $value[$i] = $field;
        }
    }
}

function expect(bool $condition): void
{
    if (!$condition) {
        throw new UnexpectedValueException('a wrong answer');
    }
}
