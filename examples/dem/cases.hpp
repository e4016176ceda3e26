// SPDX-License-Identifier: MIT
// Long runs: independent cases, side by side on the cores. Each case keeps one file, FOLDER/NAME.json: its checkpoint while it
// runs, its result once it is done. The same command run again goes on from there, with the same bits.
#pragma once

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "checkpoint.hpp"
#include "common/progress.hpp"

namespace dem {

/// What a running case reports to.
class CaseControl {
 public:
  /// Of a short run, which keeps no file.
  CaseControl() = default;
  /// `settings` say what a file must have been computed with to be taken up.
  CaseControl(std::string file, nlohmann::json settings) : file_(std::move(file)), settings_(std::move(settings)) {
    std::ifstream stream(file_);
    if (!stream) return;
    try {
      kept_ = nlohmann::json::parse(stream);
      if (kept_.at("settings") != settings_) throw std::runtime_error("belongs to a run with other settings");
      done_ = has_result() ? 1.0 : 0.0;
    } catch (const std::exception& fault) {
      common::fail({file_}, std::string(fault.what()) + ". Delete this file to begin this case anew.");
    }
  }

  double done() const { return done_; }
  bool has_result() const { return kept_.contains("result"); }
  const nlohmann::json& result() const { return kept_.at("result"); }

  /// Takes up the state of an earlier run, the scene first. Whether there was one.
  template <class Scene, class State>
  bool resume(Scene& scene, State& state) {
    if (!kept_.contains("scene")) return false;
    scene_from_json(kept_.at("scene"), scene);
    kept_.at("state").get_to(state);
    kept_ = nlohmann::json();
    return true;
  }

  /// To be called between two steps, now and then. Writes a checkpoint each minute (less often where that would take more than a
  /// twentieth of the time), and when the run is to stop.
  /// @throws common::Stopped then
  template <class Scene, class State>
  void between_steps(const Scene& scene, const State& state, double done) {
    done_ = done;
    const bool stops = common::stop_requested() || (stop_ && stop_());
    const auto now = std::chrono::steady_clock::now();
    if (!stops && now - saved_ < std::max<std::chrono::nanoseconds>(std::chrono::minutes(1), 20 * save_took_)) return;
    save(scene, state);
    if (stops) throw common::Stopped{"the same command goes on from here"};
  }
  /// Writes a checkpoint.
  template <class Scene, class State>
  void save(const Scene& scene, const State& state) {
    if (file_.empty()) return;
    const auto start = std::chrono::steady_clock::now();
    write_checkpoint(file_, {{"settings", settings_}, {"state", state}, {"scene", scene_to_json(scene)}});
    saved_ = std::chrono::steady_clock::now();
    save_took_ = saved_ - start;
  }
  void finish(const nlohmann::json& result) {
    kept_ = {{"settings", settings_}, {"result", result}};
    write_checkpoint(file_, kept_);
    done_ = 1.0;
  }

  /// Another reason to stop than Ctrl-C.
  void stop_when(std::function<bool()> stop) { stop_ = std::move(stop); }

 private:
  std::string file_;
  nlohmann::json settings_, kept_;
  std::atomic<double> done_{0.0};
  std::function<bool()> stop_;
  std::chrono::steady_clock::time_point saved_ = std::chrono::steady_clock::now();
  std::chrono::nanoseconds save_took_{0};
};

struct Case {
  std::string name;
  double work = 1.0;  ///< expected share of the time, for the progress shown
  nlohmann::json settings;
  std::function<nlohmann::json(CaseControl&)> run;  ///< returns the result
};

/// Runs the cases that have no result yet on so many threads. Returns the results, in the order of the cases. A fault in one case
/// stops the others at their next checkpoint, and is thrown.
inline std::vector<nlohmann::json> run_cases(const std::string& what, const std::string& folder,
                                             const std::vector<Case>& cases, int threads) {
  common::create_folder(folder);
  std::vector<std::unique_ptr<CaseControl>> controls;
  for (const Case& one : cases)
    controls.push_back(std::make_unique<CaseControl>(folder + "/" + one.name + ".json", one.settings));

  std::atomic<std::size_t> next{0};
  std::atomic<int> running{threads};
  std::atomic<bool> stop{false};
  std::exception_ptr fault;
  std::mutex fault_mutex;
  const auto work = [&] {
    for (std::size_t i = next++; i < cases.size() && !stop; i = next++) {
      if (controls[i]->has_result()) continue;
      controls[i]->stop_when([&stop] { return stop.load(); });
      try {
        controls[i]->finish(cases[i].run(*controls[i]));
      } catch (...) {
        const std::lock_guard<std::mutex> lock(fault_mutex);
        if (!fault) fault = std::current_exception();
        stop = true;
      }
    }
    --running;
  };
  std::vector<std::thread> workers;
  for (int i = 0; i < threads; ++i) workers.emplace_back(work);
  {
    common::Progress progress(what);
    double all = 0.0;
    for (const Case& one : cases) all += one.work;
    while (running > 0) {
      double done = 0.0;
      for (std::size_t i = 0; i < cases.size(); ++i) done += cases[i].work * controls[i]->done();
      progress.at(done / all);
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  }
  for (std::thread& worker : workers) worker.join();
  if (fault) std::rethrow_exception(fault);

  std::vector<nlohmann::json> results;
  for (const auto& control : controls) results.push_back(control->result());
  return results;
}

}  // namespace dem
