#include "gearwright/compliance/tooth_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearwright/base/parallel.hpp"
#include "gearwright/compliance/face_reading.hpp"

namespace gearwright {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kTableElement = 0.5;  // modules: length of an element along the face
// At distances from the end of the face above this limit, modules, the mirror images of bump and
// strip cause equal displacements.
constexpr double kImageReach = 2.0;
}  // namespace

double& ToothTable::entry(std::vector<double>& t, int i, int j, int k, int l) const {
  return t[((static_cast<std::size_t>(j) * n_ + l) * places_ + i) * places_ + k];
}

ToothTable::ToothTable(std::shared_ptr<const detail::ToothSection> section,
                       const ToothTableRequest& request)
    : section_(std::move(section)),
      slices_(request.slices),
      half_face_(request.face_width / 2),
      n_(request.slices.count),
      places_(static_cast<int>(section_->s.size())) {
  for (int j = 0; j < n_; ++j) middles_.push_back(slices_.middle(j));
  make(request);
  make_local(request);
}

// Returns the weights of cubic interpolation through the four evenly spaced positions around x.
// Near an end, the first or last four positions are used instead.
ToothTable::Weights ToothTable::cubic(const std::vector<double>& places, double x) {
  const double step = places[1] - places[0];
  Weights w{};
  w.first = std::clamp(static_cast<int>(std::floor((x - places[0]) / step)) - 1, 0,
                       static_cast<int>(places.size()) - 4);
  for (int a = 0; a < 4; ++a) {
    double v = 1.0;
    for (int b = 0; b < 4; ++b)
      if (b != a) v *= (x - places[w.first + b]) / (places[w.first + a] - places[w.first + b]);
    w.w[a] = v;
  }
  return w;
}

// Computes the displacements and root stresses under a unit force on each slice at each position.
void ToothTable::make(const ToothTableRequest& request) {
  using namespace detail;
  const ToothSection& s = *section_;
  const int side = s.mesh.side_teeth;
  count_step(request.progress);
  const Face face(s.modes.matrices, request.face_width, kTableElement);
  count_step(request.progress);
  const Index r = face.mode_count();
  const Index n3 = s.modes.fields.rows();
  // Projections onto the modes. `load` is for loads at the positions on tooth 0, and `read` is for
  // displacements at the positions on teeth −side … side.
  MatrixXd load(r, places_);
  MatrixXd read(places_ * (2 * side + 1), r);
  for (int i = 0; i < places_; ++i) {
    load.col(i) = s.modes.fields.transpose() * s.bumps[i].vector(n3);
    for (int k = -side; k <= side; ++k) {
      const Functional f = k == 0 ? s.bumps[i] : on_tooth(s.mesh, s.bumps[i], k);
      read.row((k + side) * places_ + i) = f.vector(n3).transpose() * s.modes.fields;
    }
  }
  const Face::Loads loads = face.loads(load);
  MatrixXd mean(face.node_count(), n_);
  const double h = slices_.width();
  for (int j = 0; j < n_; ++j)
    mean.col(j) = face.mean(slices_.lo + j * h, slices_.lo + (j + 1) * h);
  // A spur gear is symmetric about the middle of the face, so only half of the slices are loaded.
  solved_ = s.tau == 0.0 && slices_.lo == -slices_.hi ? (n_ + 1) / 2 : n_;
  const MatrixXd along = mean.leftCols(solved_);
  MatrixXd ends((face.element_count() + 1) * r, places_ * solved_);
  parallel_for(static_cast<std::size_t>(places_), [&](std::size_t i) {
    ends.middleCols(static_cast<Index>(i) * solved_, solved_) =
        face.solve(loads, static_cast<int>(i), along);
    count_step(request.progress);
  });
  const FaceReading displacement(face, loads, std::move(read));
  same_.assign(static_cast<std::size_t>(n_) * n_ * places_ * places_, 0.0);
  other_.assign(2 * side + 1, same_);
  parallel_for(static_cast<std::size_t>(n_), [&](std::size_t at) {
    const int l = static_cast<int>(at);
    const MatrixXd u = displacement.at(mean.col(l), {}, along, ends);
    for (int k = -side; k <= side; ++k)
      store(k == 0 ? same_ : other_[k + side], l, u.middleRows((k + side) * places_, places_));
    count_step(request.progress);
  });
  if (request.root_stress) make_root_stress(request, face, loads, along, ends);
  // For a single tooth, Betti's reciprocity is exact. For neighbouring teeth, the smooth part
  // of the rim disturbs it, so the mean of each entry and the reciprocal entry is used.
  for (int j = 0; j < n_; ++j) {
    for (int l = 0; l < n_; ++l) {
      for (int i = 0; i < places_; ++i) {
        for (int p = 0; p < places_; ++p) {
          double& a = entry(same_, i, j, p, l);
          double& b = entry(same_, p, l, i, j);
          a = b = 0.5 * (a + b);
          for (int k = 1; k <= side; ++k) {
            double& c = entry(other_[side + k], i, j, p, l);
            double& d = entry(other_[side - k], p, l, i, j);
            c = d = 0.5 * (c + d);
          }
        }
      }
    }
  }
}

// Stores displacements on one tooth at slice l. Row p of `u` is the position that is read, and
// column i·solved_ + j is for the force on slice j at position i.
void ToothTable::store(std::vector<double>& to, int l, const Eigen::Ref<const MatrixXd>& u) {
  for (int i = 0; i < places_; ++i) {
    for (int j = 0; j < solved_; ++j) {
      for (int p = 0; p < places_; ++p) {
        const double v = u(p, i * solved_ + j);
        entry(to, i, j, p, l) = v;
        if (has_image(j)) entry(to, i, mirrored(j), p, mirrored(l)) = v;
      }
    }
  }
}

// Computes the stresses in the middle of each slice at the root points of teeth −1, 0 and 1.
void ToothTable::make_root_stress(const ToothTableRequest& request, const detail::Face& face,
                                  const detail::Face::Loads& loads, const MatrixXd& along,
                                  const MatrixXd& ends) {
  root_ = detail::root_points(*section_);
  const auto points = static_cast<Index>(root_.t.size());
  const detail::FaceReading stress(face, loads, root_.of_mode, root_.of_slope);
  stress_.assign(3, std::vector<MatrixXd>(places_, MatrixXd(6 * points * n_, n_)));
  parallel_for(static_cast<std::size_t>(n_), [&](std::size_t at) {
    const int l = static_cast<int>(at);
    const double z = slices_.middle(l);
    const MatrixXd sigma = stress.at(face.at(z), face.slope_at(z), along, ends);
    count_step(request.progress);
    for (int k = 0; k < 3; ++k) {
      for (int i = 0; i < places_; ++i) {
        const auto here = sigma.block(6 * points * k, i * solved_, 6 * points, solved_);
        MatrixXd& to = stress_[k][i];
        to.block(6 * points * l, 0, 6 * points, solved_) = here;
        for (int j = 0; j < solved_; ++j) {
          if (!has_image(j)) continue;
          auto image = to.block(6 * points * mirrored(l), mirrored(j), 6 * points, 1);
          image = here.col(j);
          for (Index p = 0; p < points; ++p) image.middleRows(6 * p + 4, 2) *= -1.0;
        }
      }
    }
  });
}

// Subtracts H[b, b], which is the indentation under the bumps, and computes H[a, a], which is the
// indentation under the Hertz strip along the contact line.
void ToothTable::make_local(const ToothTableRequest& request) {
  using namespace detail;
  const ToothSection& s = *section_;
  const double h = slices_.width();
  const double scale = (1 - s.poisson_ratio * s.poisson_ratio) / std::numbers::pi;
  const auto ends = [&](int j, int l, auto f) {
    const double sum = slices_.middle(j) + slices_.middle(l);
    return f(2 * half_face_ - sum) + f(2 * half_face_ + sum);
  };
  image_.assign(same_.size(), 0.0);
  parallel_for(static_cast<std::size_t>(places_), [&](std::size_t at) {
    count_step(request.progress);
    const int i = static_cast<int>(at);
    for (int p = 0; p < places_; ++p) {
      const FlankMetric metric = s.metric(0.5 * (s.s[i] + s.s[p]));
      const Offsets o = bump_offsets(s.s[p] - s.s[i], s.c[i], s.c[p]);
      const auto mean = [&](const FlankMetric& m, double shift, double d) {
        double sum = 0.0;
        for (std::size_t q = 0; q < o.x.size(); ++q)
          sum += o.weight[q] * slices_inverse(m, o.x[q] + shift, d, h);
        return scale * sum;
      };
      std::vector<double> direct(2 * n_ - 1);
      for (int d = 1 - n_; d < n_; ++d) {
        if (s.tau == 0.0 && d < 0) continue;
        direct[d + n_ - 1] = mean(metric, 0.0, d * h);
      }
      if (s.tau == 0.0)
        for (int d = 1; d < n_; ++d) direct[n_ - 1 - d] = direct[n_ - 1 + d];
      // The mirror image of a load in an end face has another height z but the same s. Its shift
      // g Δz along s is therefore computed from the height of the load itself, and the metric for
      // the image has no term with g.
      const FlankMetric across{0.0, metric.zz - metric.sz * metric.sz};
      for (int j = 0; j < n_; ++j) {
        for (int l = 0; l < n_; ++l) {
          const double image = ends(j, l, [&](double d) {
            if (d > 2 * kImageReach) return 0.0;
            return mean(across, metric.sz * h * (l - j), d);
          });
          entry(same_, i, j, p, l) -= direct[l - j + n_ - 1];
          entry(same_, i, j, p, l) -= image;
          entry(image_, i, j, p, l) = image;
        }
      }
    }
  });
  // H[a, a] along the contact line, including the mirror images at the ends of the face. The metric
  // in the middle of the flank is used for all positions.
  const Offsets o = hertz_offsets(request.half_width);
  const double per = request.line_per_height;
  const FlankMetric along{0.0, per * per};
  const FlankMetric metric = s.metric(0.5 * (s.s.front() + s.s.back()));
  const double upright = std::sqrt(metric.zz - metric.sz * metric.sz);
  const double sideways = std::sqrt(std::max(0.0, per * per - upright * upright));
  hertz_.resize(n_, n_);
  const auto mean = [&](const FlankMetric& m, double shift, double d) {
    double sum = 0.0;
    for (std::size_t q = 0; q < o.x.size(); ++q)
      sum += o.weight[q] * slices_inverse(m, std::hypot(o.x[q], shift), d, h);
    return scale * sum;
  };
  for (int j = 0; j < n_; ++j) {
    for (int l = 0; l < n_; ++l) {
      hertz_(j, l) = mean(along, 0.0, (l - j) * h) + ends(j, l, [&](double d) {
                       if (d > 2 * kImageReach) return 0.0;
                       return mean({0.0, upright * upright}, sideways * h * (l - j), d);
                     });
    }
  }
}

ToothTable::Weights ToothTable::weights(double s) const { return cubic(section_->s, s); }

double ToothTable::entry(const std::vector<double>& table, int j, const Weights& from, int l,
                         const Weights& to) const {
  const double* t = &table[(static_cast<std::size_t>(j) * n_ + l) * places_ * places_];
  double sum = 0.0;
  for (int a = 0; a < 4; ++a) {
    double row = 0.0;
    for (int b = 0; b < 4; ++b) row += to.w[b] * t[(from.first + a) * places_ + to.first + b];
    sum += from.w[a] * row;
  }
  return sum;
}

MatrixXd ToothTable::same_tooth(const LinePlaces& line) const {
  MatrixXd c = hertz_;
  std::vector<Weights> w;
  for (const double s : line) w.push_back(weights(s));
  for (int j = 0; j < n_; ++j) {
    for (int l = 0; l <= j; ++l) {
      c(l, j) += entry(same_, j, w[j], l, w[l]);
      if (l != j) c(j, l) = c(l, j);
    }
  }
  return c;
}

MatrixXd ToothTable::other_tooth(int k, const LinePlaces& read, const LinePlaces& loaded) const {
  MatrixXd c = MatrixXd::Zero(n_, n_);
  const int nearest = std::clamp(k, -side_teeth(), side_teeth());
  const std::vector<double>& table = other_[nearest + side_teeth()];
  std::vector<Weights> from;
  std::vector<Weights> to;
  for (const double s : loaded) from.push_back(weights(s));
  for (const double s : read) to.push_back(weights(s));
  for (int j = 0; j < n_; ++j) {
    for (int l = 0; l < n_; ++l) c(l, j) = entry(table, j, from[j], l, to[l]);
  }
  return c;
}

MatrixXd ToothTable::on_grid(const TablePlace& place) const {
  MatrixXd grid = MatrixXd::Zero(n_, places_);
  const Weights along = weights(place.s);
  // Near an end of the face, the compliance increases steeply, so it is not extrapolated. Beyond
  // the middle of the last slice, the compliance at that middle is used.
  const Weights across = cubic(middles_, std::clamp(place.z, middles_.front(), middles_.back()));
  for (int j = 0; j < 4; ++j)
    for (int a = 0; a < 4; ++a) grid(across.first + j, along.first + a) = across.w[j] * along.w[a];
  return grid;
}

double ToothTable::yield(int k, const MatrixXd& read, const MatrixXd& loaded) const {
  const int nearest = std::clamp(k, -side_teeth(), side_teeth());
  const std::vector<double>& table = k == 0 ? same_ : other_[nearest + side_teeth()];
  double sum = 0.0;
  for (int j = 0; j < n_; ++j) {
    if (loaded.row(j).isZero(0.0)) continue;
    for (int l = 0; l < n_; ++l) {
      if (read.row(l).isZero(0.0)) continue;
      const std::size_t at = (static_cast<std::size_t>(j) * n_ + l) * places_ * places_;
      for (int i = 0; i < places_; ++i) {
        const std::size_t from = at + static_cast<std::size_t>(i * places_);
        double row = 0.0;
        for (int p = 0; p < places_; ++p)
          row += read(l, p) * (k == 0 ? table[from + p] + image_[from + p] : table[from + p]);
        sum += loaded(j, i) * row;
      }
    }
  }
  return sum;
}

MatrixXd ToothTable::on_grid(const LinePlaces& line, const VectorXd& force) const {
  MatrixXd grid = MatrixXd::Zero(n_, places_);
  for (int j = 0; j < n_; ++j) {
    if (force[j] == 0.0) continue;
    const Weights w = weights(line[j]);
    for (int a = 0; a < 4; ++a) grid(j, w.first + a) += force[j] * w.w[a];
  }
  return grid;
}

void ToothTable::add_root_stress(int k, const MatrixXd& force, MatrixXd& stress) const {
  GW_EXPECTS(std::abs(k) <= 1);
  Eigen::Map<VectorXd> all(stress.data(), stress.size());
  for (int p = 0; p < places_; ++p) {
    // Only a few slices are loaded near each position along the flank.
    const auto f = force.col(p);
    Index first = 0;
    Index end = f.size();
    while (first < end && f[first] == 0.0) ++first;
    while (end > first && f[end - 1] == 0.0) --end;
    const Index count = end - first;
    if (count > 0)
      all.noalias() += stress_[k + 1][p].middleCols(first, count) * f.segment(first, count);
  }
}

}  // namespace gearwright
