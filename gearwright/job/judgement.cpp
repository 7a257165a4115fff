#include "gearwright/job/judgement.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gearwright {

Verdict judge(const SolvedJob& job, const ContactResult* contact, const RatingAnswer* rating) {
  Judged judged;
  for (const Gear& gear : job.gears) judged.gears.push_back(&gear);
  judged.pair = job.pair ? &*job.pair : nullptr;
  judged.warnings = &job.warnings;
  judged.contact = contact;
  judged.errors = job.spec.errors.any();
  const auto& gears = job.spec.gears;
  judged.shifts_follow = job.pair && job.spec.pair.center_distance && gears[0] && gears[1] &&
                         !(gears[0]->profile_shift && gears[1]->profile_shift);
  if (rating)
    judged.rating = JudgedRating{&rating->pair, &rating->input, &rating->rating, rating->wanted};
  return verdict_of(judged);
}

std::string verdict_listing(std::string_view level, std::string_view headline) {
  constexpr std::size_t kWidth = 80;  // of a terminal
  std::string text = fmt::format("\nVerdict: {}.", level);
  std::size_t column = text.size() - 1;
  while (!headline.empty()) {
    const std::size_t end = std::min(headline.find(' '), headline.size());
    const std::string_view word = headline.substr(0, end);
    headline.remove_prefix(std::min(end + 1, headline.size()));
    const bool fits = column + 1 + word.size() <= kWidth;
    text += fits ? " " : "\n  ";
    column = (fits ? column + 1 : 2) + word.size();
    text += word;
  }
  return text + "\n";
}

std::string verdict_listing(const Verdict& verdict) {
  return verdict_listing(to_string(verdict.level), verdict.headline);
}

}  // namespace gearwright
