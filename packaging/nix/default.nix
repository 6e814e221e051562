# SPDX-License-Identifier: MIT
# The library and the command of the tree that this lies in: nix-build packaging/nix
{ pkgs ? import <nixpkgs> { } }:

pkgs.stdenv.mkDerivation {
  pname = "augicp";
  version = pkgs.lib.fileContents ../../VERSION;
  src = pkgs.lib.cleanSource ../..;

  nativeBuildInputs = with pkgs; [ cmake ninja pkg-config ];
  buildInputs = with pkgs; [ bzip2 cli11 fmt liblzf libspng lz4 nlohmann_json sqlite tbb zlib zstd ];
  propagatedBuildInputs = [ pkgs.eigen ];

  cmakeFlags = [
    "-DAUGICP_BUILD_TESTS=OFF"
    "-DAUGICP_BUILD_EXAMPLES=OFF"
    "-DAUGICP_BUILD_PYTHON=OFF"
    "-DBUILD_SHARED_LIBS=ON"
  ];

  meta = {
    description = "Rigid registration of 3D point clouds with augmented measurements";
    license = pkgs.lib.licenses.mit;
    mainProgram = "augicp";
    platforms = pkgs.lib.platforms.linux;
  };
}
