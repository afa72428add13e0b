#pragma once
// What a task asks for, as design.json and the log of a proof state it (docs/design-file.md). Lengths mm, angles degrees.

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "specs/spec.hpp"
#include "synthesis/design/design.hpp"

namespace kempe {

/// Infinity (no pair of parts can touch) has no JSON form, and NaN must never pass for a figure: null.
nlohmann::ordered_json finite_or_null(double value);
nlohmann::ordered_json finite_or_null(const std::optional<double>& value);

nlohmann::ordered_json limits_json(const Limits& limits);
nlohmann::ordered_json tolerance_json(const std::optional<Tolerance>& tolerance);
nlohmann::ordered_json obstacles_json(const std::vector<Obstacle>& obstacles);
/// Adds "material" and "load", each only if there is one.
void add_material_and_load(const std::optional<Material>& material, const std::optional<Load>& load,
                           nlohmann::ordered_json& json);
/// Adds "bodies" and "table", each only if there is one.
void add_bodies_and_table(const std::vector<Body>& bodies, const std::optional<Polygon>& table,
                          nlohmann::ordered_json& json);
nlohmann::ordered_json pole_json(const Allowed& allowed);
nlohmann::ordered_json links_limits_json(const Allowed& allowed);
nlohmann::ordered_json objective_json(const Allowed& allowed);
nlohmann::ordered_json cutting_json(const CuttingSpec& cutting);

/// All of it, with the wanted ratio, the region and the links' style.
nlohmann::ordered_json task_json(const Spec& spec);

}  // namespace kempe
