#pragma once
// KEMPE_SANITIZED is defined in builds with the address or the thread sanitizer, which forbid some of what the system allows.

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define KEMPE_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define KEMPE_SANITIZED 1
#endif
#endif
