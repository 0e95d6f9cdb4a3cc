// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/forced_end.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "quoin/cli/interruption.h"

namespace quoin::cli {
namespace {

// Each of these ends a process of its own.

const ForcedEndOptions ending{
    .interrupted{"", "cancelled\n"}, .out_of_time{"", "out of time\n"}, .seconds{}, .exit_code = 4};

[[noreturn]] void go_on_for_ever() {
  for (;;) pause();
}

void go_on_for_a_while() {
  constexpr useconds_t microseconds = 200'000;
  usleep(microseconds);
}

std::string name_of_file() {
  return std::filesystem::temp_directory_path() / ("forced_end_test" + std::to_string(getpid()));
}

void write_all_that_fits(int pipe) {
  constexpr std::array<char, 4096> block{};
  fcntl(pipe, F_SETFL, O_NONBLOCK);
  while (write(pipe, block.data(), block.size()) > 0) continue;
  fcntl(pipe, F_SETFL, 0);
}

TEST(ForcedEnd, ComesWhereNothingHeedsAnInterruption) {
  const auto interrupted = [](int signal) {
    Context context;
    const InterruptionGuard guard(context);
    prepare_forced_end(ending);
    raise(signal);
    go_on_for_ever();
  };
  EXPECT_EXIT(interrupted(SIGINT), testing::ExitedWithCode(4), "^cancelled\n$");
  EXPECT_EXIT(interrupted(SIGTERM), testing::ExitedWithCode(4), "^cancelled\n$");
}

TEST(ForcedEnd, ComesWhereNothingHeedsTheTimeLimit) {
  const auto limited = [] {
    ForcedEndOptions options = ending;
    options.seconds = 0.01;
    prepare_forced_end(options);
    go_on_for_ever();
  };
  EXPECT_EXIT(limited(), testing::ExitedWithCode(4), "^out of time\n$");
}

TEST(ForcedEnd, DoesNotComeBeforeItIsPrepared) {
  const auto unprepared = [] {
    force_end();
    go_on_for_a_while();
    _exit(7);
  };
  EXPECT_EXIT(unprepared(), testing::ExitedWithCode(7), "^$");
}

TEST(ForcedEnd, DoesNotComeAfterOneInOrder) {
  const auto in_order = [] {
    prepare_forced_end(ending);
    end_in_order();
    force_end();
    end_in_order();  // as where the last words fail
    go_on_for_a_while();
    _exit(7);
  };
  EXPECT_EXIT(in_order(), testing::ExitedWithCode(7), "^$");
}

TEST(ForcedEnd, RemovesTheFileThatIsNotWhole) {
  const std::string name = name_of_file();
  const auto writing = [&] {
    prepare_forced_end(ending);
    {
      WithoutForcedEnd guard;
      std::ofstream(name) << "half";
      guard.remove_at_forced_end(name.c_str());
    }
    force_end();
    go_on_for_ever();
  };
  EXPECT_EXIT(writing(), testing::ExitedWithCode(4), "cancelled");
  EXPECT_FALSE(std::filesystem::exists(name));
}

TEST(ForcedEnd, LeavesTheFileThatIsWhole) {
  const std::string name = name_of_file();
  const auto written = [&] {
    prepare_forced_end(ending);
    WithoutForcedEnd().remove_at_forced_end(name.c_str());
    std::ofstream(name) << "whole";
    WithoutForcedEnd().remove_at_forced_end(nullptr);
    force_end();
    go_on_for_ever();
  };
  EXPECT_EXIT(written(), testing::ExitedWithCode(4), "cancelled");
  EXPECT_TRUE(std::filesystem::remove(name));
}

TEST(ForcedEnd, WaitsForWhatIsDoneAsAWhole) {
  const auto guarded = [] {
    prepare_forced_end(ending);
    {
      const WithoutForcedEnd guard;
      force_end();
      go_on_for_a_while();
      EXPECT_EQ(write(STDERR_FILENO, "done\n", 5), 5);
    }
    go_on_for_ever();
  };
  EXPECT_EXIT(guarded(), testing::ExitedWithCode(4), "^done\ncancelled\n$");
}

TEST(ForcedEnd, SaysNothingWhereNobodyReads) {
  const auto unread = [] {
    std::array<int, 2> ends{};
    EXPECT_EQ(pipe(ends.data()), 0);
    write_all_that_fits(ends[1]);
    dup2(ends[1], STDOUT_FILENO);
    ForcedEndOptions options = ending;
    options.interrupted.output = "{}\n";
    prepare_forced_end(options);
    force_end();
    go_on_for_ever();
  };
  EXPECT_EXIT(unread(), testing::ExitedWithCode(4), "^cancelled\n$");
}

TEST(ForcedEnd, WhoeverGivesBackItsMemoryEndsToo) {
  ASSERT_EQ(prctl(PR_SET_CHILD_SUBREAPER, 1), 0);
  const pid_t process = fork();
  if (process == 0) {
    prepare_forced_end(ending);
    force_end();
    go_on_for_ever();
  }
  int status = 0;
  ASSERT_EQ(waitpid(process, &status, 0), process);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 4) << status;
  int others = 0;
  while (waitpid(-1, &status, __WALL) > 0) {
    EXPECT_EQ(status, 0);
    ++others;
  }
  EXPECT_EQ(errno, ECHILD);
  EXPECT_EQ(others, 1);
  prctl(PR_SET_CHILD_SUBREAPER, 0);
}

}  // namespace
}  // namespace quoin::cli
