// SPDX-License-Identifier: MIT
#pragma once

#include "apps/augicp/page/page.h"

namespace augicp::app {

// The style of the reports, and their script if one was bundled. It is in a source file made at build time, so that the
// library stays small.
PageBundle report_bundle();

}  // namespace augicp::app
