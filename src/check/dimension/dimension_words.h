// SPDX-License-Identifier: GPL-3.0-or-later
// A contradiction between dimensions in words: both dimensions, and the earlier place.
#pragma once

#include <string>
#include <vector>

#include "check/dimension/dimension_record.h"
#include "check/dimension/dimension_system.h"
#include "source/diagnostic.h"
#include "source/source_map.h"

namespace rigor {

/// Where an equation between dimensions comes from.
struct DimensionReason {
  enum class Kind : std::uint8_t {
    time,  // without `units`: the time is no number
    units,
    statement
  };
  Kind kind = Kind::time;
  Span span = {};
};

class DimensionWords {
 public:
  /// `known`: all that holds without the equation in question.
  DimensionWords(const DimensionRecord& record, const DimensionSystem& known,
                 const std::vector<DimensionReason>& reasons, const SourceMap& sources)
      : record_(record), known_(known), reasons_(reasons), sources_(sources) {}

  /// Nothing but `units` lines and the equation itself are needed.
  [[nodiscard]] bool is_declared(const DimensionSystem::Contradiction& contradiction) const {
    return places_of(contradiction.reasons, DimensionReason::Kind::statement).empty();
  }
  [[nodiscard]] Diagnostic describe(const DimensionEquation& equation,
                                    const DimensionSystem::Contradiction& contradiction, Span place) const;

 private:
  struct Blamed {
    Unknown symbol = 0;
    Dimension before;
    Dimension here;
    Span earlier;
  };
  [[nodiscard]] std::optional<Blamed> blamed(const DimensionEquation& equation,
                                             const DimensionSystem::Contradiction& contradiction) const;
  [[nodiscard]] std::vector<Span> places_of(const Reasons& reasons, DimensionReason::Kind kind) const;
  [[nodiscard]] std::string text_of(const DimensionForm& form) const;
  [[nodiscard]] std::string compared(const DimensionEquation& equation) const;
  [[nodiscard]] std::uint32_t line_of(Span span) const {
    return sources_.line_column(span.file, span.begin).line;
  }

  const DimensionRecord& record_;
  const DimensionSystem& known_;
  const std::vector<DimensionReason>& reasons_;
  const SourceMap& sources_;
};

}  // namespace rigor
