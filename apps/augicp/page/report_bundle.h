// SPDX-License-Identifier: MIT
#pragma once

#include "apps/augicp/page/page.h"

namespace augicp::app {

// The style of the reports, and their script where one was bundled. In a source file made at build time: the library
// knows no script, and stays small.
PageBundle report_bundle();

}  // namespace augicp::app
