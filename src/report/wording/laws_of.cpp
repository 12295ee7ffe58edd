// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/wording/laws_of.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/among.h"

namespace rigor {

namespace {

bool is_used(const std::string& name, const FileReport& file) {
  return std::ranges::any_of(file.steps, [&](const Step& step) { return is_one_of(name, step.uses); });
}

}  // namespace

std::vector<LawUse> laws_of(const FileReport& file, const SourceMap& sources) {
  std::vector<LawUse> laws;
  for (const Step& step : file.steps) {
    const bool open = step.verdict == Verdict::undecided;  // it may be a conclusion that others rest on
    if (!open && (step.verdict != Verdict::law || step.restates)) continue;
    std::string name = name_of_law(step.tag, step.relation_span, sources, open ? "conclusion" : "law");
    if (open && !is_used(name, file)) continue;
    if (std::ranges::find(laws, name, &LawUse::name) == laws.end())
      laws.push_back({std::move(name), step.span});
  }
  for (LawUse& law : laws) {
    law.used = static_cast<std::uint32_t>(
        std::ranges::count_if(file.steps, [&](const Step& step) { return is_one_of(law.name, step.uses); }));
  }
  return laws;
}

std::string print_laws(const std::vector<LawUse>& laws) {
  if (laws.empty()) return {};
  std::string text = fmt::format("rests on {} law{}", laws.size(), laws.size() == 1 ? "" : "s");
  std::size_t unused = 0;
  bool first = true;
  for (const LawUse& law : laws) {
    if (law.used == 0) {
      ++unused;
      continue;
    }
    const std::size_t behind = law.name.starts_with("law in ") ? 7 : law.name.starts_with("law ") ? 4 : 0;
    const std::string place = law.name.substr(behind);
    text +=
        fmt::format("{} {}, used by {} step{}", first ? ":" : ";", place, law.used, law.used == 1 ? "" : "s");
    first = false;
  }
  if (first) return text + ", which no step uses";
  if (unused > 0) text += fmt::format("; {} other{} by none", unused, unused == 1 ? "" : "s");
  return text;
}

}  // namespace rigor
