// SPDX-License-Identifier: MIT
#include "cli/check_command.h"

#include <cstdio>

#include <fmt/format.h>

#include "analysis/facts.h"
#include "cli/facts.h"
#include "cli/run.h"
#include "compile/check_scene.h"
#include "compile/visible_region.h"

namespace cli {

int check(const InputOptions& input_options, const CheckOptions& options) {
    const auto input = read_input(input_options);
    if (!input) return failed;
    report(input->source, compile::check_scene(input->formula, input->document));
    if (!options.facts && !options.json) return success;
    const field::Field& field = input->formula.field;
    const auto facts = analysis::find_facts(field, compile::visible_region(input->document.bounds),
                                            compile::parameter_values(field, input->document));
    const shader::ProgramSource source =
        compile::program_source(input->formula, input->document, {});
    const std::vector<compile::StepRule> rules = compile::step_rules(
        field, source, compile::field_numbers(input->formula, source, input->document),
        input->document);
    fmt::print("{}", options.json ? facts_json(facts, field.graph, rules)
                                  : facts_text(facts, field.graph, rules));
    return success;
}

}  // namespace cli
