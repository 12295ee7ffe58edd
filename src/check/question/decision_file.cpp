// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/question/decision_file.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/archive.h"
#include "base/md5.h"
#include "source/read_file.h"
#include "source/system_error.h"
#include "source/write_file.h"

namespace rigor {
namespace {

constexpr std::string_view first_line = "rigor decisions 3\n";
constexpr std::size_t digest_size = 32;
constexpr std::size_t kinds_of_questions = 2;

struct SavedAnswers {
  std::string program;
  std::vector<SavedAnswer> answers;
};

}  // namespace

template <class Archive>
void fields(Archive& archive, Limits& limits) {
  auto& [expanded_terms, steps, quick_points, quick_steps, sample_attempts, fewest_assumptions,
         simplest_sample, only_proofs, sign_cases, budget] = limits;
  static_cast<void>(budget);
  archive(expanded_terms, steps, quick_points, quick_steps, sample_attempts, fewest_assumptions,
          simplest_sample, only_proofs, sign_cases);
}

template <class Archive>
void fields(Archive& archive, AskedQuestion& asked) {
  auto& [kind, limits, question, known] = asked;
  archive.bounded(kind, kinds_of_questions);
  archive(limits, question, known);
}

template <class Archive>
void fields(Archive& archive, SavedAnswer& saved) {
  auto& [asked, answer, work, age] = saved;
  archive(asked, answer, work, age);
}

template <class Archive>
void fields(Archive& archive, SavedAnswers& all) {
  archive(all.program, all.answers);
}

std::string archived(const AskedQuestion& asked) {
  AskedQuestion copy = asked;
  ArchiveWriter writer;
  writer(copy);
  return writer.take();
}

std::optional<AskedQuestion> asked_of_bytes(std::string_view bytes) {
  AskedQuestion asked;
  ArchiveReader reader(bytes);
  reader(asked);
  return reader.finished() ? std::optional(std::move(asked)) : std::nullopt;
}

Result<std::vector<SavedAnswer>> read_answers(const std::string& path, const std::string& program) {
  const Result<std::string> bytes = read_file(path);
  if (!bytes) return tl::make_unexpected(bytes.error());
  std::string_view rest = *bytes;
  if (!rest.starts_with(first_line)) return refuse("it is damaged");
  rest.remove_prefix(first_line.size());
  const std::string_view digest = rest.substr(0, std::min(digest_size, rest.size()));
  rest.remove_prefix(digest.size());
  SavedAnswers all;
  ArchiveReader reader(rest);
  if (md5(rest) == digest) reader(all);
  if (md5(rest) != digest || !reader.finished()) return refuse("it is damaged");
  if (all.program != program) all.answers.clear();
  return std::move(all.answers);
}

Result<void> write_answers(const std::string& path, const std::string& program,
                           std::vector<SavedAnswer> answers) {
  SavedAnswers all{program, std::move(answers)};
  ArchiveWriter writer;
  writer(all);
  const std::string content = writer.take();
  std::error_code error;
  std::filesystem::create_directories(std::filesystem::path(path).parent_path(), error);
  if (error) return tl::make_unexpected(error_of(error));
  return replace_file(path, std::string(first_line) + md5(content) + content);
}

}  // namespace rigor
