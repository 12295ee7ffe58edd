// SPDX-License-Identifier: GPL-3.0-or-later
#include "source/processes.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <exception>
#include <optional>
#include <thread>

#include "base/archive.h"
#include "source/system_error.h"

namespace rigor {
namespace {

/// What a process says, after its length: how far it is, or the answer, or what was thrown.
struct PieceMessage {
  enum class Kind : std::uint8_t { progress, answer, exception };
  Kind kind = Kind::progress;
  std::uint64_t done = 0;
  std::uint64_t all = 0;
  std::string text = {};
};

template <class Archive>
void fields(Archive& archive, PieceMessage& message) {
  archive.bounded(message.kind, 3);
  archive(message.done, message.all, message.text);
}

struct PieceProcess {
  std::size_t piece = 0;
  pid_t id = 0;
  int pipe = -1;  // its answer is read from it
  std::string unread = {};
  std::optional<PieceMessage> last = {};  // that is no progress
};

// --- in the process of a piece

/// If nobody reads any more, the signal of a broken pipe ends the process.
void send(int pipe, PieceMessage message) {
  ArchiveWriter writer;
  writer(message);
  std::string bytes = writer.take();
  ArchiveWriter framing;
  framing(bytes);
  const std::string frame = framing.take();
  for (std::size_t sent = 0; sent < frame.size();) {
    const ssize_t count = ::write(pipe, frame.data() + sent, frame.size() - sent);
    if (count >= 0)
      sent += static_cast<std::size_t>(count);
    else if (errno != EINTR)
      ::_exit(1);
  }
}

[[noreturn]] void work_on(const Pieces& pieces, std::size_t piece, int pipe, pid_t parent) {
  std::signal(SIGPIPE, SIG_DFL);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);  // it ended before that was said
  const auto progress = [pipe](std::size_t done, std::size_t all) {
    send(pipe, {PieceMessage::Kind::progress, done, all});
  };
  try {
    send(pipe, {PieceMessage::Kind::answer, 0, 0, pieces.work(piece, progress)});
  } catch (const std::exception& error) {
    send(pipe, {PieceMessage::Kind::exception, 0, 0, error.what()});
  } catch (...) {
    send(pipe, {PieceMessage::Kind::exception, 0, 0, "unexpected error"});
  }
  ::_exit(0);  // what this process has in its buffers is for its parent to print
}

// --- in this process

std::string why_it_ended(int status) {
  if (WIFSIGNALED(status))
    return fmt::format("its process was ended by signal {} ({})", WTERMSIG(status),
                       strsignal(WTERMSIG(status)));
  return fmt::format("its process ended with code {} and no answer", WEXITSTATUS(status));
}

class PieceProcesses {
 public:
  PieceProcesses(const Pieces& pieces, std::size_t most_at_once)
      : pieces_(pieces), most_at_once_(most_at_once), answers_(pieces.count, failed("never started")) {}

  std::vector<Result<std::string>> run() {
    std::size_t next = 0;
    while (next < pieces_.count || !children_.empty()) {
      while (next < pieces_.count && children_.size() < most_at_once_) {
        if (!start(next)) break;
        ++next;
      }
      listen();
    }
    return std::move(answers_);
  }

 private:
  static Result<std::string> failed(std::string reason) {
    return tl::make_unexpected(Error{std::move(reason)});
  }

  /// False: there is no room now, and others are still at work. A piece that can never start has failed.
  bool start(std::size_t piece) {
    std::array<int, 2> ends{};
    const bool piped = ::pipe(ends.data()) == 0;
    const pid_t parent = ::getpid();
    const pid_t id = piped ? ::fork() : -1;
    const int reason = errno;
    if (id == 0) {
      for (const PieceProcess& child : children_) ::close(child.pipe);
      ::close(ends[0]);
      work_on(pieces_, piece, ends[1], parent);
    }
    if (piped) ::close(ends[1]);
    if (id > 0) {
      children_.push_back({piece, id, ends[0]});
      return true;
    }
    if (piped) ::close(ends[0]);
    if (!children_.empty()) return false;
    answers_[piece] = failed("no process could be started: " +
                             error_of(std::error_code(reason, std::generic_category())).reason);
    return true;
  }

  /// Waits until a child says something, and hears all who do.
  void listen() {
    std::vector<pollfd> waiting;
    for (const PieceProcess& child : children_) waiting.push_back({child.pipe, POLLIN, 0});
    if (waiting.empty() || ::poll(waiting.data(), waiting.size(), -1) < 0) return;
    std::vector<PieceProcess> running;
    for (std::size_t k = 0; k < children_.size(); ++k) {
      PieceProcess& child = children_[k];
      if (waiting[k].revents == 0 || hear(child)) running.push_back(std::move(child));
    }
    children_ = std::move(running);
  }

  /// Is it still at work?
  bool hear(PieceProcess& child) {
    std::array<char, 65536> buffer;
    const ssize_t count = ::read(child.pipe, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) return true;
    if (count <= 0) {
      finish(child);
      return false;
    }
    child.unread.append(buffer.data(), static_cast<std::size_t>(count));
    while (take_message(child)) {
    }
    return true;
  }

  /// The next whole message, if there is one.
  bool take_message(PieceProcess& child) {
    ArchiveReader framing(child.unread);
    std::string bytes;
    framing(bytes);
    if (!framing.ok()) return false;
    child.unread.erase(0, child.unread.size() - framing.rest().size());
    PieceMessage message;
    ArchiveReader reader(bytes);
    reader(message);
    if (message.kind != PieceMessage::Kind::progress)
      child.last = std::move(message);
    else if (pieces_.progress)
      pieces_.progress(child.piece, message.done, message.all);
    return true;
  }

  void finish(PieceProcess& child) {
    ::close(child.pipe);
    int status = 0;
    while (::waitpid(child.id, &status, 0) < 0 && errno == EINTR) {
    }
    const bool well = WIFEXITED(status) && WEXITSTATUS(status) == 0 && child.last;
    Result<std::string>& answer = answers_[child.piece];
    if (!well)
      answer = failed(why_it_ended(status));
    else if (child.last->kind == PieceMessage::Kind::exception)
      answer = failed(std::move(child.last->text));
    else
      answer = std::move(child.last->text);
  }

  const Pieces& pieces_;
  std::size_t most_at_once_;
  std::vector<Result<std::string>> answers_;
  std::vector<PieceProcess> children_;
};

}  // namespace

std::vector<Result<std::string>> in_processes(const Pieces& pieces, std::size_t most_at_once) {
  return PieceProcesses(pieces, most_at_once == 0 ? 1 : most_at_once).run();
}

std::vector<std::string> in_processes_or_here(const Pieces& pieces, std::size_t most_at_once) {
  std::vector<std::string> done(pieces.count);
  std::vector<Result<std::string>> answers;
  if (most_at_once > 1 && pieces.count > 1) answers = in_processes(pieces, most_at_once);
  for (std::size_t piece = 0; piece < pieces.count; ++piece) {
    const bool answered = piece < answers.size() && answers[piece];
    done[piece] = answered ? std::move(*answers[piece]) : pieces.work(piece, {});
  }
  return done;
}

std::size_t processor_count() {
  const unsigned count = std::thread::hardware_concurrency();
  return count == 0 ? 1 : count;
}

}  // namespace rigor
