#!/usr/bin/env python3
"""stack_probe.py API: a library in C that measures the stack that calls of gamephys take.

API is a description of the header (cmake/interface/describe.py). Preloaded into a program, the library has a wrapper
of each function: it paints the stack below its own frame, calls the function, and sees how far the paint is gone. At
its end the program appends a line "NAME BYTES" for each called function to the file that STACK_DEPTHS names. Only
calls by the program are measured: a function that is called from a callback of another, or on a thread whose stack is
smaller than the painted part, is not.
"""
import json
import sys

PRELUDE = r"""
#define _GNU_SOURCE
#include "gamephys_c.h"

#include <alloca.h>
#include <dlfcn.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PAINTED = 192 << 10, PAINT = 0xa5 };

typedef struct function { const char* name; void* address; size_t depth; } function;

static __thread int nested;

/* Below the caller's frame, which begins a little below `frame`. Not of a thread whose stack ends there. */
__attribute__((noinline)) static unsigned char* paint(unsigned char* frame) {
    static __thread unsigned char* end;
    unsigned char* const low = frame - PAINTED;
    if (nested++ > 0) return NULL;
    if (!end) {
        pthread_attr_t attributes;
        void* address;
        size_t size;
        if (pthread_getattr_np(pthread_self(), &attributes) != 0) abort();
        pthread_attr_getstack(&attributes, &address, &size);
        pthread_attr_destroy(&attributes);
        end = (unsigned char*)address + 4096;
    }
    if (low < end) return NULL;
    {
        /* Where the stack pointer is, memory below it is not this function's. */
        volatile unsigned char* const room = (volatile unsigned char*)alloca(PAINTED);
        const size_t most = (size_t)(frame - (unsigned char*)__builtin_frame_address(0)) + 256;
        __asm__ volatile("" : : "r"(room) : "memory");
        memset(low, PAINT, PAINTED - most);
        __asm__ volatile("" : : "r"(low) : "memory");
    }
    return low;
}

__attribute__((noinline)) static void see(function* f, unsigned char* low) {
    const unsigned long paint = 0x0101010101010101ul * PAINT;
    size_t depth = PAINTED;
    --nested;
    if (!low) return;
    __asm__ volatile("" : "+r"(low) : : "memory");
    for (; depth > 0 && *(const unsigned long*)low == paint; low += sizeof paint) depth -= sizeof paint;
    if (depth > f->depth) f->depth = depth; /* threads may lose a depth to each other, not invent one */
}
"""

END = r"""
__attribute__((constructor)) static void begin(void) {
    size_t i;
    for (i = 0; i < sizeof functions / sizeof functions[0]; ++i) {
        functions[i].address = dlsym(RTLD_NEXT, functions[i].name);
    }
}
__attribute__((destructor)) static void end(void) {
    const char* name = getenv("STACK_DEPTHS");
    FILE* const file = fopen(name ? name : "stack_depths.txt", "a");
    size_t i;
    if (!file) abort();
    for (i = 0; i < sizeof functions / sizeof functions[0]; ++i) {
        if (functions[i].depth) fprintf(file, "%s %lu\n", functions[i].name, (unsigned long)functions[i].depth);
    }
    fclose(file);
}
"""


def wrapper(number, function):
    types = [p["type"] for p in function["parameters"]]
    declared = ", ".join(f"{t} p{i}" for i, t in enumerate(types)) or "void"
    given = ", ".join(f"p{i}" for i in range(len(types)))
    result = function["returns"]
    call = f"(({result} (*)({', '.join(types) or 'void'}))functions[{number}].address)({given})"
    lines = [f"{result} {function['name']}({declared}) {{",
             "    unsigned char* const frame = (unsigned char*)__builtin_frame_address(0);",
             "    unsigned char* const low = paint(frame);"]
    lines += [f"    {call};"] if result == "void" else [f"    {result} const result = {call};"]
    lines += [f"    see(&functions[{number}], low);"]
    lines += ["}"] if result == "void" else ["    return result;", "}"]
    return "\n".join(lines)


def main():
    functions = json.load(open(sys.argv[1]))["functions"]
    print(PRELUDE)
    print("static function functions[] = {")
    for f in functions:
        print(f'    {{"{f["name"]}", NULL, 0}},')
    print("};")
    for i, f in enumerate(functions):
        print(wrapper(i, f))
    print(END)


main()
