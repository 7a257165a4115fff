#include "gearwright/job/search_files.hpp"

#include <zstd.h>

#include <cmath>
#include <cstring>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/output_file.hpp"

namespace gearwright {

namespace {

// Calls f for every number of the row. Both writing and reading use this function.
template <class Row, class F>
void each_number(Row& row, const F& f) {
  f(row.trial.index);
  f(row.trial.module);
  f(row.trial.z1);
  f(row.trial.z2);
  f(row.trial.helix[0]);
  f(row.trial.helix[1]);
  f(row.trial.rack);
  f(row.trial.face_width);
  f(row.shift[0]);
  f(row.shift[1]);
  f(row.balanced);
  f(row.center_distance);
  f(row.working_angle);
  f(row.ratio);
  f(row.contact_ratio);
  f(row.contact_ratio_true);
  f(row.overlap_ratio);
  f(row.backlash_normal);
  f(row.tip_alteration);
  f(row.face_width);
  for (const int i : {0, 1}) {
    f(row.tip_thickness[i]);
    f(row.tip_clearance[i]);
    f(row.sliding[i][0]);
    f(row.sliding[i][1]);
    f(row.form_clearance[i]);
    f(row.flank_safety[i]);
    f(row.root_safety[i]);
    f(row.sums[i]);
    f(row.lo[i]);
    f(row.hi[i]);
    f(row.allowance[i]);
    f(row.backlash_ends[i]);
  }
  f(row.interference);
  f(row.area);
  f(row.mass);
  f(row.efficiency);
  f(row.noise);
}

template <class Point, class F>
void each_number_of_point(Point& p, const F& f) {
  f(p.trial);
  f(p.shift[0]);
  f(p.shift[1]);
  f(p.center_distance);
  f(p.working_angle);
  f(p.contact_ratio);
  f(p.contact_ratio_true);
  f(p.sliding);
  for (const int i : {0, 1}) {
    f(p.tip_thickness[i]);
    f(p.tip_clearance[i]);
  }
  f(p.backlash_normal);
  f(p.interference);
}

constexpr std::size_t kNumbers = 20 + 2 * 12 + 5;
constexpr std::size_t kPointNumbers = 14;

// Passes numbers to the compressor one by one. The uncompressed bytes of a million points are
// therefore never in memory together.
class Packer {
 public:
  Packer()
      : context_(ZSTD_createCCtx()), buffer_(ZSTD_CStreamInSize()), out_(ZSTD_CStreamOutSize()) {
    GW_ENSURES(context_ != nullptr);
    ZSTD_CCtx_setParameter(context_, ZSTD_c_compressionLevel, 1);
  }
  Packer(const Packer&) = delete;
  Packer& operator=(const Packer&) = delete;
  ~Packer() { ZSTD_freeCCtx(context_); }
  /// Sets the uncompressed size, which is written into the frame for the reader.
  void announce(std::size_t size) { ZSTD_CCtx_setPledgedSrcSize(context_, size); }

  void word(std::uint64_t w) {
    if (used_ + 8 > buffer_.size()) flush(ZSTD_e_continue);
    for (int i = 0; i < 8; ++i) buffer_[used_++] = static_cast<char>(w >> (8 * i));
  }
  std::string take() {
    flush(ZSTD_e_end);
    return std::move(packed_);
  }

 private:
  void flush(ZSTD_EndDirective end) {
    ZSTD_inBuffer in{buffer_.data(), used_, 0};
    for (;;) {
      ZSTD_outBuffer out{out_.data(), out_.size(), 0};
      const std::size_t left = ZSTD_compressStream2(context_, &out, &in, end);
      GW_ENSURES(!ZSTD_isError(left));
      packed_.append(out_.data(), out.pos);
      if (end == ZSTD_e_end ? left == 0 : in.pos == in.size) break;
    }
    used_ = 0;
  }
  ZSTD_CCtx* context_;
  std::vector<char> buffer_, out_;
  std::size_t used_ = 0;
  std::string packed_;
};

struct ColumnWriter {
  Packer* packer;
  void operator()(double v) const {
    std::uint64_t w;
    std::memcpy(&w, &v, 8);
    packer->word(w);
  }
  void operator()(Angle v) const { (*this)(v.rad()); }
  void operator()(std::int64_t v) const { packer->word(static_cast<std::uint64_t>(v)); }
  void operator()(int v) const { (*this)(static_cast<std::int64_t>(v)); }
  void operator()(bool v) const { (*this)(static_cast<std::int64_t>(v)); }
  void operator()(const std::optional<double>& v) const { (*this)(v.value_or(kNoNumber)); }
};

struct Reader {
  const unsigned char** at;
  std::uint64_t word() const {
    std::uint64_t w = 0;
    for (int i = 0; i < 8; ++i) w |= static_cast<std::uint64_t>((*at)[i]) << (8 * i);
    *at += 8;
    return w;
  }
  void operator()(double& v) const {
    const std::uint64_t w = word();
    std::memcpy(&v, &w, 8);
  }
  void operator()(Angle& v) const {
    double rad = 0.0;
    (*this)(rad);
    v = Angle::radians(rad);
  }
  void operator()(std::int64_t& v) const { v = static_cast<std::int64_t>(word()); }
  void operator()(int& v) const { v = static_cast<int>(static_cast<std::int64_t>(word())); }
  void operator()(bool& v) const { v = word() != 0; }
  void operator()(std::optional<double>& v) const {
    double number = 0.0;
    (*this)(number);
    v = std::isnan(number) ? std::nullopt : std::optional(number);
  }
};

}  // namespace

std::string pack(const ChunkFinds& finds) {
  const std::size_t size =
      8 * (2 + finds.designs.size() * kNumbers + finds.points.size() * kPointNumbers);
  Packer packer;
  packer.announce(size);
  const ColumnWriter write{&packer};
  write(static_cast<std::int64_t>(finds.designs.size()));
  write(static_cast<std::int64_t>(finds.points.size()));
  for (const DesignRow& row : finds.designs) {
    GW_EXPECTS(row.whole);  // false only if some numbers of the row were not computed
    each_number(row, write);
  }
  for (const ShiftPoint& point : finds.points) each_number_of_point(point, write);
  return packer.take();  // if `size` were wrong, the compressor would report an error here
}

ChunkFinds unpack(std::string_view bytes, const std::string& where) {
  const auto size = ZSTD_getFrameContentSize(bytes.data(), bytes.size());
  constexpr unsigned long long kMax = 1ULL << 36;
  if (size > kMax || size < 16) throw IoError(where + " does not contain designs of this version");
  std::string plain(size, '\0');
  const std::size_t got = ZSTD_decompress(plain.data(), plain.size(), bytes.data(), bytes.size());
  if (ZSTD_isError(got) || got != size) throw IoError(where + " cannot be unpacked");
  const auto* at = reinterpret_cast<const unsigned char*>(plain.data());
  const Reader read{&at};
  std::int64_t designs = 0;
  std::int64_t points = 0;
  read(designs);
  read(points);
  const auto most = static_cast<std::int64_t>(size / 8);
  if (designs < 0 || points < 0 || designs > most || points > most ||
      size != 8 * (2 + static_cast<std::size_t>(designs) * kNumbers +
                   static_cast<std::size_t>(points) * kPointNumbers)) {
    throw IoError(where + " does not contain designs of this version");
  }
  ChunkFinds finds;
  finds.designs.resize(static_cast<std::size_t>(designs));
  finds.points.resize(static_cast<std::size_t>(points));
  for (DesignRow& row : finds.designs) {
    each_number(row, read);
    row.whole = true;
  }
  for (ShiftPoint& point : finds.points) each_number_of_point(point, read);
  return finds;
}

}  // namespace gearwright
