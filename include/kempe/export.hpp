#pragma once
// What a shared library shows of itself: the names marked here and no others.

#if defined(__GNUC__)
#define KEMPE_EXPORT __attribute__((visibility("default")))
#else
#define KEMPE_EXPORT
#endif
