// What the page's worker calls: the door as two C functions.

#include <emscripten.h>

#include <string>

#include "studio/door.hpp"

// clang-format off
EM_JS(void, kempe_tell, (double share, const char* what), {
  if (Module["onProgress"]) Module["onProgress"](share, UTF8ToString(what));
});
// clang-format on

extern "C" {

/// The answer to a question, JSON in UTF-8; it stays where it is until the next question.
EMSCRIPTEN_KEEPALIVE const char* kempe_ask(const char* question, const char* argument) {
  static kempe::studio::Door door;
  static std::string answer;
  answer = door.ask(question, argument, [](double share, std::string_view what) {
    kempe_tell(share, std::string(what).c_str());
  });
  return answer.c_str();
}
}
