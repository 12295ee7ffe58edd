// SPDX-License-Identifier: GPL-3.0-or-later
// From a file of notes to the forms for the floating-point side.
#pragma once

#include <string>

#include "check/form/forms.h"
#include "source/source_map.h"

namespace rigor {

/// An expression that cannot be read, or has a letter that is nowhere in the notes, is a diagnostic of the
/// file, and `forms.asked` is then empty. Never throws for anything in the notes or the request.
[[nodiscard]] FormsReading read_forms(SourceMap& sources, const std::string& path,
                                      const FormRequest& request);
/// The same for text in memory.
[[nodiscard]] FormsReading read_forms_of_text(SourceMap& sources, const std::string& path, std::string text,
                                              const FormRequest& request);

}  // namespace rigor
