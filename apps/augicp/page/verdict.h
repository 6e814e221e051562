// SPDX-License-Identifier: MIT
// The verdict on a registration, and the options that took effect, for the page of `augicp align --report`.
#pragma once

#include <string>

#include "apps/augicp/page/html.h"
#include "apps/augicp/text/align.h"

namespace augicp::app {

// HTML: the status, what to do, doubts and free motions as sentences, a table of figures.
std::string verdict_html(const AlignResult& result);

// How the status is coloured: good, warn or bad.
std::string badge_class(AlignStatus status);

NamedTexts effective_options(const AlignReport& report);

}  // namespace augicp::app
