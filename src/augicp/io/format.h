// SPDX-License-Identifier: MIT
// fmt::format and fmt::join: text from values, the same in every locale.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>
