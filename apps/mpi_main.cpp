// SPDX-License-Identifier: MIT
//
// Runs `asterism-mpi`, which makes meshes in pieces on the ranks of MPI. For any number of ranks
// the files equal those of `asterism mesh --pieces`.
#include <mpi.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <iostream>
#include <new>
#include <numeric>
#include <string>
#include <vector>

#include "asterism/apps/base/commands.hpp"
#include "asterism/apps/base/complain.hpp"
#include "asterism/apps/help/usage_message.hpp"
#include "asterism/apps/pieces/piece_team.hpp"
#include "asterism/apps/run/freed_memory.hpp"
#include "asterism/core/version.h"

namespace {

// The ranks of MPI_COMM_WORLD. An error inside MPI ends all of them, which is MPI's default.
class mpi_team : public asterism::apps::piece_team {
 public:
  mpi_team() {
    int rank = 0, size = 1;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    rank_ = static_cast<std::size_t>(rank);
    size_ = static_cast<std::size_t>(size);
  }

  std::size_t rank() const override { return rank_; }
  std::size_t size() const override { return size_; }

  std::vector<std::string> gather(const std::string& mine) override {
    const int length = static_cast<int>(mine.size());
    std::vector<int> lengths(size_), starts(size_, 0);
    MPI_Allgather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, MPI_COMM_WORLD);
    std::partial_sum(lengths.begin(), lengths.end() - 1, starts.begin() + 1);
    std::string all(static_cast<std::size_t>(starts.back() + lengths.back()), '\0');
    MPI_Allgatherv(mine.data(), length, MPI_CHAR, all.data(), lengths.data(), starts.data(),
                   MPI_CHAR, MPI_COMM_WORLD);
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < size_; ++i)
      texts.push_back(
          all.substr(static_cast<std::size_t>(starts[i]), static_cast<std::size_t>(lengths[i])));
    return texts;
  }

 private:
  std::size_t rank_ = 0, size_ = 1;
};

int run(int argc, char** argv, mpi_team& team) {
  using namespace asterism::apps;
  CLI::App program("Meshes in pieces and verifies them, shared out among the ranks of MPI.");
  program.name("asterism-mpi");
  program.set_version_flag("--version", "asterism-mpi " ASTERISM_VERSION_TEXT);
  program.require_subcommand(0, 1);
  command chosen;
  add_mesh_command(program, chosen, &team);
  add_verify_command(program, chosen, &team);
  try {
    program.parse(argc, argv);
    if (!chosen) throw CLI::RequiredError("a command (mesh or verify)");
  } catch (const CLI::ParseError& failure) {
    if (failure.get_exit_code() == 0) return team.is_first() ? program.exit(failure) : done;
    if (team.is_first())
      std::cerr << "asterism-mpi: " << usage_message(program, {argv + 1, argv + argc}, failure)
                << '\n';
    return refused;
  }
  const int status = chosen();
  if (std::cout.flush() || status != done) return status;
  std::cerr << "asterism-mpi: standard output: writing failed\n";
  return not_reached;
}

// Ends all ranks, since the others wait for this one. Each file is then complete or absent.
void end_all(std::size_t rank, const std::string& why) {
  std::cerr << "asterism-mpi: rank " << rank << ": " << why
            << "; pieces that are finished are whole, and --resume goes on\n";
  MPI_Abort(MPI_COMM_WORLD, asterism::apps::not_reached);
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);
  asterism::apps::give_back_large_blocks();
  // Requests the level in which only this thread of a rank calls MPI.
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
  int status = asterism::apps::not_reached;
  {
    mpi_team team;
    try {
      status = run(argc, argv, team);
    } catch (const std::bad_alloc&) {
      end_all(team.rank(), "there is not enough memory");
    } catch (const std::exception& failure) {
      end_all(team.rank(), failure.what());
    }
  }
  MPI_Finalize();
  return status;
}
