// SPDX-License-Identifier: MIT
//
// Adds the option that makes triangles of second order, and notes on its outputs.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "asterism/core/result.hpp"
#include "asterism/mesh/audit/curved_triangles.hpp"

namespace asterism::apps {

// Adds --order.
CLI::Option* add_order_option(CLI::App& app, int& order);

// Refuses an order that no file of the output can hold.
std::optional<error> check_order(int order, const std::vector<std::filesystem::path>& outputs);

// Returns a note for each output whose format holds straight sides alone though second order is
// asked for, and one on sides kept straight in all outputs.
std::vector<std::string> notes_of_order(const std::vector<std::filesystem::path>& outputs,
                                        const second_order_report& report);

}  // namespace asterism::apps
