// SPDX-License-Identifier: MIT
// The verdict on a registration, and options, for the page of `augicp align --report`.
#pragma once

#include <string>

#include "apps/augicp/page/html.h"
#include "apps/augicp/text/align.h"

namespace augicp::app {

// HTML: the status, the advice, doubts and free motions as sentences, a table of figures.
std::string verdict_html(const AlignReport& report);

// The colour of the status: good, warn or bad.
std::string badge_class(AlignStatus status);

// The options that are set, without the number of threads.
NamedTexts options_texts(const RegistrationOptions& options);

}  // namespace augicp::app
