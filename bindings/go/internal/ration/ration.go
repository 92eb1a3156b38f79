// Package ration is a gphys_allocator for tests: it gives out so many bytes and no more, and counts
// what is held. Test files cannot use cgo themselves.
package ration

/*
#cgo pkg-config: gamephys
#include <gamephys_c.h>
#include <stdlib.h>

typedef struct ration {
    gphys_allocator allocator;
    int64_t left, held;
} ration;

static void* take(void* user, size_t size, size_t alignment) {
    ration* r = user;
    void* memory = NULL;
    if (r->left < (int64_t)size) return NULL;
    if (alignment < sizeof(void*)) alignment = sizeof(void*);
    if (posix_memalign(&memory, alignment, size)) return NULL;
    r->left -= (int64_t)size;
    r->held += (int64_t)size;
    return memory;
}

static void give_back(void* user, void* memory, size_t size, size_t alignment) {
    ration* r = user;
    (void)alignment;
    r->left += (int64_t)size;
    r->held -= (int64_t)size;
    free(memory);
}

static ration* new_ration(void) {
    ration* r = calloc(1, sizeof *r);
    if (r) r->allocator = (gphys_allocator){take, give_back, r};
    return r;
}
*/
import "C"

import "unsafe"

// Ration is for one object at a time, or for several that one goroutine uses.
type Ration struct{ c *C.ration }

// New is a ration of nothing.
func New() Ration { return Ration{C.new_ration()} }

// Free ends it; the objects that it served have to be closed before.
func (r Ration) Free() { C.free(unsafe.Pointer(r.c)) }

// Allocator is what the settings of an object take.
func (r Ration) Allocator() unsafe.Pointer { return unsafe.Pointer(&r.c.allocator) }

// Allow lets so many bytes be taken from here on.
func (r Ration) Allow(bytes int) { r.c.left = C.int64_t(bytes) }

// Held is the number of bytes that were not given back.
func (r Ration) Held() int { return int(r.c.held) }
