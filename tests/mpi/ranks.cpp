// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <scree/distributed/gathered.hpp>
#include <scree/distributed/other_ranks.hpp>
#include <scree/distributed/run_on_mpi.hpp>
#include <scree/distributed/run_on_threads.hpp>
#include <scree/granular/granular.hpp>
#include <scree/io/body_series.hpp>
#include <scree/io/checkpoints.hpp>
#include <scree/run/run_with.hpp>
#include <scree/setup/setup.hpp>
#include <scree/solver/solver.hpp>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

// Run by mpirun: with `same-bits`, a column that collapses on all ranks must end with the bits of one rank; with
// `fail`, one rank throws; with `unlike`, ranks request for unlike transports; with `stop FOLDER`, a signal comes to
// one rank, and with `continue FOLDER`, a run continues from the checkpoint of that run.
namespace scree::test {
using namespace fields;
namespace {

using Space = Kokkos::DefaultExecutionSpace;

struct Collapse : Formulation<2> {
  using space = Space;
  using physics = Granular<>;
  template <class P>
  using search = ReproducibleList<P>;
  template <class P>
  using ghosts = OtherRanks<P>;
};

/// `share`: that of this rank, which begins with it; none: it begins with the whole column.
template <class... OfWhom>
Solver<Collapse> column(Team<Space> const& team, Space const& space, OfWhom const&... share) {
  double const dr = 0.01;
  SolverSettings<Collapse> settings{.spacing = dr, .ranks = {.team = team}};
  settings.physics.law = {.elastic = {1e5, 0.3, 1500}, .grains = {5e-4}};
  Solver<Collapse> solver(space, settings, fill_lattice(Box<2>{{0, 0}, {0.2, 0.3}}, dr, share...),
                          wall_around(Box<2>{{0, 0}, {0.8, 0.5}}, dr, 4, share...));
  solver.set(velocity, [](auto const& x) { return Vec<2, double>(1, 0.1 * x[1]); });
  return solver;
}
template <class... OfWhom>
std::uint64_t end_of(Team<Space> const& team, Space const& space, OfWhom const&... share) {
  auto solver = column(team, space, share...);
  for (int k = 0; k < 200; ++k) solver.step(1);
  return state_hash(solver);
}
double const end = 0.06;  // s
/// Runs with files. Returns the hash of the end; a signal stops the run before that.
std::uint64_t run_with_files(Team<Space> const& team, Space const& space, std::filesystem::path const& folder,
                             bool goes_on, int rank_with_signal) {
  using S = Solver<Collapse>;
  auto solver = column(team, space);
  Checkpoints checkpoints({.file = folder / "checkpoint.h5", .interval = 1e9});
  if (goes_on) solver.restore(checkpoints.read(folder / "checkpoint.h5"));
  BodySeries output(folder / ("particles of " + std::to_string(team.ranks()) + ".vtkhdf"), Fields<Velocity>{},
                    Bodies<Material>{}, {.overwrite = true});
  run_with(solver, end,
           {every<S>(0.02,
                     [&](S& now) {
                       output.append(now);
                       if (now.time() > 0.03 && team.rank() == rank_with_signal) std::raise(SIGUSR1);
                     })},
           checkpoints);
  bool const stopped = team.smallest(int(checkpoints.interrupted() && checkpoints.exit_code() == 128 + SIGUSR1)) == 1;
  bool const same_step = team.smallest(solver.steps()) == team.largest(solver.steps());
  if (team.rank() == 0 && stopped && same_step && solver.time() < end) std::printf("all ranks stopped\n");
  return state_hash(solver);
}
bool continued(std::filesystem::path const& folder) {
  std::uint64_t whole = 0;
  bool same = false;
  auto const alone = folder / "alone";
  run_on_mpi<Space>([&](Team<Space> const& team, Space const& space) {
    auto const here = run_with_files(team, space, folder, true, -1);
    if (team.rank() == 0) {
      std::filesystem::create_directories(alone);
      run_on_threads<Space>(
          1, [&](Team<Space> const& one, Space const& own) { whole = run_with_files(one, own, alone, false, -1); });
    }
    same = team.largest(whole) == here;
  });
  return same;
}

/// Whether messages of many sizes arrive whole, again and again, while blocks grow.
bool messages_arrive(Team<Space> const& team, Space const& space) {
  using Bytes = Memory<Space::memory_space>;
  using OnHost = Kokkos::HostSpace;
  long wrong = 0;
  for (int round = 0; round < 40; ++round) {
    Messages sent{nullptr, {0}}, received{nullptr, {0}};
    // Rank p sends (p + 2 q + round) 37 words to rank q, nothing to the next one in every third round.
    auto const size = [&](int from, int to) {
      return (round + from) % 3 == 0 && to == (from + 1) % team.ranks() ? 0 : 8 * 37 * (from + 2 * to + round);
    };
    for (int q = 0; q < team.ranks(); ++q) {
      sent.starts.push_back(sent.starts.back() + size(team.rank(), q));
      received.starts.push_back(received.starts.back() + size(q, team.rank()));
    }
    auto const value = [&](int from, int to, std::int64_t k) {
      return (from * 64 + to) * 1'000'000l + round * 10'000l + k;
    };
    std::vector<long> out(std::size_t(sent.starts.back()) / 8 + 1), in(std::size_t(received.starts.back()) / 8 + 1);
    for (int q = 0; q < team.ranks(); ++q)
      for (std::int64_t k = 0; k < sent.size_for(q) / 8; ++k)
        out[std::size_t(sent.starts[std::size_t(q)] / 8 + k)] = value(team.rank(), q, k);
    Bytes const to_send("sent", out.size() * 8), room("received", in.size() * 8);
    copy_bytes<Space::memory_space, OnHost>(space, to_send.data(), out.data(), out.size() * 8);
    sent.bytes = to_send.data(), received.bytes = room.data();
    team.exchange(space, sent, received);
    copy_bytes<OnHost, Space::memory_space>(space, in.data(), room.data(), in.size() * 8);
    for (int q = 0; q < team.ranks(); ++q)
      for (std::int64_t k = 0; k < received.size_for(q) / 8; ++k)
        wrong += in[std::size_t(received.starts[std::size_t(q)] / 8 + k)] != value(q, team.rank(), k);
  }
  return team.sum(wrong) == 0;
}

struct AddOne {
  long const* from;
  long* to;
  SCREE_FN void operator()(int k) const { to[k] = from[k] + 1; }
};
/// Whether numbers that go from rank to rank, and grow by one on each, arrive as they should after many exchanges
/// between which the host does not wait. Other messages of changing sizes travel with them.
bool relay_counts(Team<Space> const& team, Space const& space) {
  using Bytes = Memory<Space::memory_space>;
  int const ranks = team.ranks(), rank = team.rank(), numbers = 5000, rounds = 60 * ranks;
  std::vector<long> values(std::size_t(numbers), 1'000'000l * rank);
  std::size_t const most = std::size_t(numbers) * 8 * std::size_t(ranks);
  Bytes const here("here", most), there("there", most);
  copy_bytes<Space::memory_space, Kokkos::HostSpace>(space, here.data(), values.data(), values.size() * 8);
  std::byte* arrived = here.data();
  for (int round = 0; round < rounds; ++round) {
    Messages sent{there.data(), {0}}, received{here.data(), {0}};
    auto const size = [&](int from, int to) {
      return 8 * (to == (from + 1) % ranks ? numbers : (round * (from + 2 * to + 1)) % numbers);
    };
    for (int q = 0; q < ranks; ++q) {
      sent.starts.push_back(sent.starts.back() + size(rank, q));
      received.starts.push_back(received.starts.back() + size(q, rank));
    }
    for_each_index(
        space, "relay", 0, numbers,
        AddOne{reinterpret_cast<long const*>(arrived), reinterpret_cast<long*>(sent.begin_for((rank + 1) % ranks))});
    team.exchange(space, sent, received);
    arrived = received.begin_for((rank + ranks - 1) % ranks);
  }
  copy_bytes<Kokkos::HostSpace, Space::memory_space>(space, values.data(), arrived, values.size() * 8);
  long wrong = 0;  // the rounds are a multiple of the ranks: numbers are back where they began
  for (long const value : values) wrong += value != 1'000'000l * rank + rounds;
  return team.sum(wrong) == 0;
}

/// Whether a run on all ranks ends with the bits of one rank.
bool has_bits(std::uint64_t one, Team<Space> const& team, Space const& space) {
  auto const here = end_of(team, space), from_shares = end_of(team, space, team.share());
  ExactSum sum;
  sum += 0.1 * (team.rank() + 1);
  bool const sums = team.sum(sum) == [&] {
    ExactSum all;
    for (int q = 0; q < team.ranks(); ++q) all += 0.1 * (q + 1);
    return all.value();
  }();
  bool const whole = messages_arrive(team, space), arrive = relay_counts(team, space) && whole;
  if (team.rank() == 0)
    std::printf("%d ranks, %s: %016lx, from shares: %016lx, one rank: %016lx, sums %d, messages %d\n", team.ranks(),
                team.name(space).c_str(), static_cast<unsigned long>(here), static_cast<unsigned long>(from_shares),
                static_cast<unsigned long>(one), int(sums), int(arrive));
  return team.smallest(int(here == one && from_shares == one && sums && arrive)) == 1;
}

#ifdef __linux__
/// Whether a file that only has the path of shared memory is refused.
bool refuses_other_files() {
  HostBlocks::Block const block(4096);
  auto handle = block.handle();
  HostBlocks::Mapped const same(handle);
  same.data()[7] = std::byte(42);
  ++handle.identity[1];
  try {
    HostBlocks::Mapped const other(handle);
  } catch (std::runtime_error const&) {
    return block.data()[7] == std::byte(42);
  }
  return false;
}
#endif

/// A transport that changes one byte of each message from the first rank to the last.
struct Spoiling {
  Mpi mpi;
  int rank() const { return mpi.rank(); }
  int ranks() const { return mpi.ranks(); }
  void exchange(Space const& space, Messages const& sent, Messages const& received) {
    mpi.exchange(space, sent, received);
    if (rank() != ranks() - 1) return;
    std::byte changed{};
    auto* const last = received.begin_for(0) + received.size_for(0) - 1;
    copy_bytes<Kokkos::HostSpace, Space::memory_space>(space, &changed, last, 1);
    changed ^= std::byte(1);
    copy_bytes<Space::memory_space, Kokkos::HostSpace>(space, last, &changed, 1);
  }
};
/// Whether the trial at the start of a GPU-aware MPI believes messages that arrive, and not those that a rank spoils.
bool trial_finds_spoilt_messages() {
  Mpi mpi;
  Spoiling spoiling{mpi};
  bool const last = mpi.rank() == mpi.ranks() - 1;
  bool const right = detail::messages_arrive(mpi, Space(), 1 << 20) &&
                     detail::messages_arrive(spoiling, Space(), 1 << 20) == !last && detail::all_say(mpi, true) &&
                     !detail::all_say(mpi, !last);
  return Team<Space>(mpi).smallest(int(right)) == 1;
}

bool same_bits() {
  std::uint64_t one = 0;
  run_on_threads<Space>(1, [&](Team<Space> const& team, Space const& space) { one = end_of(team, space); });
  bool same = has_bits(one, Team<Space>(Mpi()), Space());
  same = has_bits(one, team_of_mpi<Space>(), Space()) && trial_finds_spoilt_messages() && same;
#ifdef __linux__
  same = has_bits(one, Team<Space>(PeerMemory<HostBlocks>(Mpi())), Space()) && refuses_other_files() && same;
#endif
  return same;
}

/// Asks for another transport on the first rank than on the others.
void ask_unlike() { setenv("SCREE_TRANSPORT", Mpi().rank() == 0 ? "staged-mpi" : "mpi", 1); }

void fail() {
  run_on_mpi<Space>([&](Team<Space> const& team, Space const&) {
    team.gather(1);
    if (team.rank() == 1) throw std::runtime_error("no sand");
    for (;;) team.gather(2);
  });
}

}  // namespace
}  // namespace scree::test

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  bool good = true;
  {
    Kokkos::ScopeGuard const kokkos(argc, argv);
    if (argc > 1 && std::string(argv[1]) == "unlike") scree::test::ask_unlike();
    if (argc > 1 && (std::string(argv[1]) == "fail" || std::string(argv[1]) == "unlike"))
      scree::test::fail();
    else if (argc > 2 && std::string(argv[1]) == "stop")
      scree::run_on_mpi<scree::test::Space>([&](auto const& team, auto const& space) {
        scree::test::run_with_files(team, space, argv[2], false, team.ranks() - 1);
      });
    else if (argc > 2 && std::string(argv[1]) == "continue")
      good = scree::test::continued(argv[2]);
    else
      good = scree::test::same_bits();
  }
  MPI_Finalize();
  return good ? 0 : 1;
}
