#pragma once
// The engine's door: questions and answers as JSON, for a page that holds no C++.

#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace kempe::studio {

/// Told the share of the work done, 0..1, and what is being done.
using Progress = std::function<void(double share, std::string_view what)>;

/// What one page asks, one question after the other; it remembers the last design and the last sketch.
///
/// Every answer is a JSON object. Lengths mm, angles rad, places [x, y] in the table's frame. Questions take {"text": the spec as
/// TOML}, and perhaps "files": [{"name", "text"}], the drawings that it names:
///
///   version    {"version"}
///   check      {"holds"}: true where interval arithmetic encloses, without which nothing here may be called proven
///   materials  {"names"}: those that a spec can name
///   validate   {"faults": [{"file", "line", "key", "found", "allowed"}, ...]}, or {"task": what a page draws of the spec}; "file"
///              is null for the spec, else the drawing whose line is meant
///   region     what the tracer is to cover, every corner: {"polygons": [[outline, hole, ...], ...]}, or faults
///   sketch     a design at the speed of a hand, from the last sketch, or "from" the "handover" of a design, perhaps another
///              door's: "kind" is "sketch", "none" or "faults"
///   design     the search: "kind" is "design", "none" or "faults"
///   map        the mechanism that the spec gives: the same kinds
///   files      writes what `kempe synthesize` writes of the last design into the folder /files: {"files": names}, or {"reason"}
///
/// A question that is none of these, or no JSON, is answered by {"error": a sentence}. Nothing is thrown.
class Door {
 public:
  Door();
  ~Door();
  Door(const Door&) = delete;
  Door& operator=(const Door&) = delete;

  /// The answer to one question.
  std::string ask(std::string_view question, const std::string& argument, const Progress& progress = {});

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace kempe::studio
