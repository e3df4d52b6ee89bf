// SPDX-License-Identifier: MIT
//
// One file per command: each adds itself to the command line and says what to run.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace bankshot::app {

using Run = std::function<int()>;

// A folder and a namespace a command.
namespace solve {
Run add(CLI::App& app);
}
namespace batch {
Run add(CLI::App& app);
}
namespace simulate {
Run add(CLI::App& app);
}
namespace verify {
Run add(CLI::App& app);
}
namespace generate {
Run add(CLI::App& app);
}
namespace map {
Run add(CLI::App& app);
}
namespace report {
Run add(CLI::App& app);
}

}  // namespace bankshot::app
