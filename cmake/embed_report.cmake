# SPDX-License-Identifier: MIT
# cmake -DSTYLE=style.css -DSCRIPT=report.js|"" -DOUTPUT=file.cpp -P embed_report.cmake
file(READ "${STYLE}" style)
set(script "")
set(script_sha256 "")
if(SCRIPT)
  file(READ "${SCRIPT}" script)
  file(READ "${SCRIPT}.sha256" script_sha256)
endif()
file(WRITE "${OUTPUT}" "// SPDX-License-Identifier: MIT\n// Made by cmake/embed_report.cmake.\n"
  "#include \"apps/augicp/page/report_bundle.h\"\n\nnamespace augicp::app {\n\n"
  "PageBundle report_bundle() {\n  return {R\"augicp(${style})augicp\",\n          R\"augicp(${script})augicp\",\n"
  "          \"${script_sha256}\"};\n}\n\n}  // namespace augicp::app\n")
