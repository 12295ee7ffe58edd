// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/data/eval_json.h"

#include "report/data/json_value.h"
#include "report/wording/advice.h"

namespace rigor {
namespace {

/// Infinite and not-a-number become null.
Json spread(const Spread& spread) { return {{"worst", spread.worst}, {"median", spread.median}}; }

Json measure_json(const ErrorMeasure& measure) {
  Json json{{"compared", measure.compared}};
  if (measure.compared > 0) {
    json["relative_error"] = spread(measure.relative);
    json["ulps"] = spread(measure.ulps);
    json["bits"] = spread(measure.bits_kept);
  }
  json["overflows"] = measure.overflows;
  json["not_a_number"] = measure.not_a_number;
  json["wrong_signs"] = measure.wrong_signs;
  json["zeros"] = measure.zeros;
  if (measure.zeros > 0) json["worst_at_zero"] = measure.worst_at_zero;
  json["undefined"] = measure.undefined;
  json["unknown"] = measure.unknown;
  if (measure.nanoseconds > 0) json["nanoseconds"] = measure.nanoseconds;
  return json;
}

Json form_json(const FormResult& form) {
  Json json{{"value", form.first}, {"measured", form.measure.measured}};
  if (form.measure.condition_known > 0) json["condition"] = spread(form.measure.condition);
  for (const ErrorMeasure& measure : form.measure.arithmetics)
    json[std::string(name_of(measure.arithmetic))] = measure_json(measure);
  return json;
}

Json worst_json(const WorstPoint& worst) {
  return {{"form", worst.form}, {"at", worst.values}, {"forms", array_of(worst.forms, form_json)}};
}

/// Forms for ranges of numbers, and the points where other forms lose their digits.
Json search_json(const SearchResult& search) {
  return {{"ranges", array_of(search.ranges,
                              [](const FormForRange& range) {
                                return Json{{"form", range.form},
                                            {"where", range.where},
                                            {"losing", array_of(range.losing, worst_json)}};
                              })},
          {"losing", array_of(search.losing, worst_json)}};
}

Json chain_json(const EvaluatedChain& evaluated, const SourceMap& sources) {
  const WrittenFormChain* chain = evaluated.chain;
  const ChainResult& result = evaluated.result;
  const LineColumn place = sources.line_column(chain->span.file, chain->span.begin);
  Json json{{"file", sources.path(chain->span.file)}, {"line", place.line}, {"column", place.column}};
  if (!chain->tag.empty()) json["tag"] = chain->tag;
  if (chain->image > 0) json["cyclic_image"] = chain->image;
  json["section"] = chain->section;
  json["forms"] = array_of(result.forms, [&](const ChainResult::Form& form) {
    return Json{{"source", chain->forms[form.side].source},
                {"operations", form.operations},
                {"operations_per_particle", form.operations_per_particle}};
  });
  json["not_evaluated"] = array_of(result.left_out, [&](const ChainResult::LeftOut& each) {
    return Json{{"source", chain->forms[each.side].source}, {"why", each.why}};
  });
  if (!result.not_comparable.empty()) json["not_comparable"] = result.not_comparable;
  if (!result.taken_for.empty()) json["taken_for"] = result.taken_for;
  if (!result.no_trials.empty()) json["no_trials"] = result.no_trials;
  json["trials"] = array_of(result.trials, [](const TrialResult& trial) {
    return Json{{"name", trial.name},
                {"what", trial.what},
                {"assumptions_hold", trial.met},
                {"samples", trial.samples},
                {"particles", trial.particles},
                {"forms", array_of(trial.forms, form_json)}};
  });
  if (result.search) json["search"] = search_json(*result.search);
  if (const auto advice = advise(result)) {
    json["advice"] = {{"form", advice->form},
                      {"all_alike", advice->all_alike},
                      {"unbeaten", advice->fronts},
                      {"text", advice_text(result, *advice)}};
  }
  return json;
}

}  // namespace

std::string evaluation_json(const EvaluatedNotes& notes, const SourceMap& sources) {
  return to_text({{"format", 1},
                  {"notes", notes.path},
                  {"chains", array_of(notes.chains, [&](const EvaluatedChain& chain) {
                     return chain_json(chain, sources);
                   })}});
}

}  // namespace rigor
