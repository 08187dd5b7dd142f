// How messages spell numbers and names.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace glimt {

// 1234567 as "1,234,567".
std::string grouped(std::uintmax_t number);

// "1 triangle", "2 triangles", "1,234 triangles".
std::string counted(std::uintmax_t number, std::string_view noun);

// "12 s", "3 min", "4.5 h".
std::string duration(double seconds);

// A share of 1: 0.123 as "12%", 0.0123 as "1.2%".
std::string percent(double share);

// Fit for one line on a terminal: control characters become '?', and long text is cut.
std::string printable(std::string_view text);

// "'a', 'b', 'c' and 4 more".
std::string listed(const std::vector<std::string>& names);

// The known name that `name` was most likely meant to be; empty when none is close.
std::string nearest(std::string_view name, const std::vector<std::string>& known);

}  // namespace glimt
