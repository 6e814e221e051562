# SPDX-License-Identifier: MIT
# Formula for the source distribution that scripts/wheel writes to dist/.
class Augicp < Formula
  desc "Rigid registration of 3D point clouds with augmented measurements"
  url "file://#{Dir[File.expand_path("../../dist/augicp-*.tar.gz", __dir__)].max}"
  license "MIT"

  depends_on "cli11" => :build
  depends_on "cmake" => :build
  depends_on "ninja" => :build
  depends_on "nlohmann-json" => :build
  depends_on "pkgconf" => :build
  depends_on "eigen"
  depends_on "fmt"
  depends_on "liblzf"
  depends_on "libspng"
  depends_on "lz4"
  depends_on "tbb"
  depends_on "zstd"

  uses_from_macos "bzip2"
  uses_from_macos "sqlite"
  uses_from_macos "zlib"

  def install
    system "cmake", "-S", ".", "-B", "build", "-G", "Ninja", "-DAUGICP_BUILD_TESTS=OFF", "-DAUGICP_BUILD_EXAMPLES=OFF",
           "-DAUGICP_BUILD_PYTHON=OFF", "-DBUILD_SHARED_LIBS=ON", *std_cmake_args
    system "cmake", "--build", "build"
    system "cmake", "--install", "build"
    bash_completion.install "packaging/completion/augicp.bash" => "augicp"
  end

  test do
    assert_match version.to_s, shell_output("#{bin}/augicp --version")
  end
end
