# Not run (../README.md).
class Gearwright < Formula
  desc "Exact engine for cylindrical gears: geometry, contact, load, strength, CAD files"
  homepage "https://gearwright.invalid"
  url "https://gearwright.invalid/gearwright-0.1.0.tar.gz"
  sha256 "0000000000000000000000000000000000000000000000000000000000000000"
  license "Apache-2.0"

  depends_on "boost" => :build
  depends_on "cli11" => :build
  depends_on "cmake" => :build
  depends_on "eigen" => :build
  depends_on "ninja" => :build
  depends_on "nlohmann-json" => :build
  depends_on "pkgconf" => :build
  depends_on "fmt"
  depends_on "highway"
  depends_on "sqlite"
  depends_on "tbb"
  depends_on "tomlplusplus"
  depends_on "zstd"

  def install
    system "cmake", "-S", ".", "-B", "build", "-G", "Ninja", "-DGEARWRIGHT_TESTS=OFF", "-DGEARWRIGHT_BENCH=OFF",
           "-DGEARWRIGHT_PYTHON=OFF", "-DGEARWRIGHT_MPI=OFF", *std_cmake_args
    system "cmake", "--build", "build", "--target", "gearwright_cli"
    system "cmake", "--install", "build"
    pkgshare.install "examples"
  end

  test do
    (testpath/"pair.toml").write <<~TOML
      [gear1]
      teeth = 17
      normal_module_mm = 2.5
      [gear2]
      teeth = 43
    TOML
    assert_match "centre distance", shell_output("#{bin}/gearwright pair pair.toml")
  end
end
