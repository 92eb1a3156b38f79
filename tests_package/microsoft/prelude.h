// Comes before every source file in microsoft.sh: the C++ library of this system, and then a compiler that
// calls itself Microsoft's for what follows.
#include <algorithm>
#include <atomic>
#include <cfloat>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iterator>
#include <limits>
#include <memory_resource>
#include <mutex>
#include <numeric>
#include <optional>
#include <queue>
#include <system_error>
#include <thread>
#include <variant>
#include <vector>

#undef __GNUC__
#undef __clang__
#undef __SIZEOF_INT128__
#undef __SSE2__
#undef __x86_64__
#undef __unix__
#undef __linux__
#define _M_X64 100
#ifndef _MSC_VER
#define _MSC_VER 1939
#endif
#define _WIN32 1
#pragma GCC poison __attribute__ __extension__ __int128 __restrict__ __typeof__
