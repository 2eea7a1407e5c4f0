// SPDX-License-Identifier: MIT
// Draws trials.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "render/canvas.h"
#include "render/program.h"
#include "studio/trial.h"

namespace studio {

/// Keeps canvas and programs from one trial to the next, so that a trial costs no more than its
/// frame. Its context must be current for every call, and the functions must outlive it.
class TrialCanvas {
public:
    explicit TrialCanvas(const render::Gl& gl) : gl_(&gl) {}

    /// `superseded` is asked every tenth of a second or so; where it says yes, the trial is given
    /// up.
    TrialAnswer draw(const TrialRequest& trial, const std::function<bool()>& superseded);

private:
    base::Result<const render::Program*> program(const shader::ProgramSource& source);
    base::Status fit(int width, int height);
    base::Status draw(const TrialRequest& trial, const std::function<bool()>& superseded,
                      TrialAnswer& answer);

    const render::Gl* gl_;
    std::optional<render::Canvas> canvas_;
    std::map<std::string, render::Program> programs_;  ///< by their texts
};

}  // namespace studio
