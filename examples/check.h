/* What the examples share: a call that must succeed, and an answer that must be right. */
#ifndef CHECK_H
#define CHECK_H

#include <gamephys_c.h>
#include <stdio.h>
#include <stdlib.h>

/* Stop with the library's own explanation if the call fails. */
#define MUST(call)                                                                                                  \
    do {                                                                                                            \
        const gphys_status status_ = (call);                                                                        \
        if (status_ != GPHYS_OK) {                                                                                  \
            fprintf(stderr, "%s:%d: %s: %s\n", __FILE__, __LINE__, gphys_status_name(status_), gphys_last_error()); \
            exit(1);                                                                                                \
        }                                                                                                           \
    } while (0)

/* Stop if the answer is not what this example says it is. */
#define EXPECT(condition)                                                            \
    do {                                                                             \
        if (!(condition)) {                                                          \
            fprintf(stderr, "%s:%d: expected %s\n", __FILE__, __LINE__, #condition); \
            exit(1);                                                                 \
        }                                                                            \
    } while (0)

#endif
