// The commands of the program; each adds itself to the command line and runs when it is called.
#pragma once

#include <CLI/CLI.hpp>

namespace apps {

void add_synth(CLI::App& app);
void add_info(CLI::App& app);
void add_convert(CLI::App& app);
void add_advise(CLI::App& app);
void add_precompute(CLI::App& app);
void add_sweep(CLI::App& app);
void add_peaks(CLI::App& app);
void add_period(CLI::App& app);
void add_ridges(CLI::App& app);
void add_plot(CLI::App& app);
void add_colour(CLI::App& app);
void add_map(CLI::App& app);
void add_albedo(CLI::App& app);
void add_bake(CLI::App& app);
void add_render(CLI::App& app);
void add_tradeoff(CLI::App& app);
void add_stability(CLI::App& app);
void add_validate(CLI::App& app);
void add_completion(CLI::App& app);
void add_manual(CLI::App& app);

}  // namespace apps
