// A target as a program of its own, for every compiler: replays inputs and runs random ones.
//
//   fuzz_TARGET [--seconds S | --programs N | --program I] [--seed K] [--ignore CHECK]... [--keep FOLDER] [--digests]
//               [--print] [--exceptions] [--round up|down|zero] [--flush] [--modes] [FILE or FOLDER]...
//
// --program runs one of the random programs alone and keeps its input. A check that does not hold is reported once, its
// first input is kept, and the run goes on. What ends the process, and what takes longer than 20 s, keeps its input
// too. --digests prints the digest of each program, to find the one in which two instruction sets differ. --print shows
// what each program draws. --exceptions checks that calls with valid input raise no floating-point exception that a
// host may trap; --round and --flush make the calls in another rounding mode, or with denormal numbers flushed to zero;
// --modes runs each program once more in one of these modes, and compares the answers.
#include <algorithm>
#include <cfenv>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <vector>

#if __has_include(<unistd.h>)
#include <fcntl.h>
#include <unistd.h>
#define FUZZ_KEEPS_CRASHES 1
#endif

#include "check.h"
#include "program.h"

namespace {

using Input = std::vector<uint8_t>;

std::string keep_in = ".";
Input present;  // what is being run
char crash_file[512];

#ifdef FUZZ_KEEPS_CRASHES
void keep_crash(int signal) {
    const int file = open(crash_file, O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (file >= 0) {
        if (write(file, present.data(), present.size()) < 0) std::_Exit(3);
        close(file);
    }
    const char text[] = "the process was ended; its input is the file crash-* in the folder of --keep\n";
    if (write(2, text, sizeof text - 1) < 0) std::_Exit(3);
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}
#endif

void watch_for_crashes() {
#ifdef FUZZ_KEEPS_CRASHES
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL, SIGALRM}) std::signal(signal, keep_crash);
#endif
}

void limit_time([[maybe_unused]] unsigned seconds) {
#ifdef FUZZ_KEEPS_CRASHES
    alarm(seconds);
#endif
}

/// xorshift64* (Vigna 2016), the same numbers everywhere.
struct Random {
    uint64_t state;
    uint64_t next() {
        state ^= state >> 12;
        state ^= state << 25;
        state ^= state >> 27;
        return state * 0x2545f4914f6cdd1d;
    }
};

struct Tally {
    uint64_t programs = 0, digest = 0;
    std::map<std::string, uint64_t> findings;  // by check
    bool print_digests = false, other_modes = false;
};

void keep(const std::string& name) {
    std::ofstream file(keep_in + "/" + name, std::ios::binary);
    file.write(reinterpret_cast<const char*>(present.data()), static_cast<std::streamsize>(present.size()));
    std::fprintf(stderr, "  input kept as %s/%s\n", keep_in.c_str(), name.c_str());
}

std::string as_file_name(std::string text) {
    for (char& c : text) {
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '-';
    }
    return text;
}

/// The number-th of the modes that programs do not start in, or none of them.
void set_mode(std::optional<uint64_t> number) {
    constexpr int roundings[] = {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO, FE_TONEAREST};
    fuzz::Session& session = fuzz::session();
    session.rounding = number ? roundings[*number % 4] : FE_TONEAREST;
    session.flush = number && (*number % 4 == 3 || *number % 8 == 4);
}

void report(Tally& tally, const char* check, const std::string& source) {
    if (tally.findings[check]++ > 0) return;
    std::fprintf(stderr, "%s: does not hold: %s (%s)\n", fuzz::target_name, check, source.c_str());
    keep("finding-" + std::string(fuzz::target_name) + "-" + as_file_name(check));
}

/// The digest of the present program's answers.
uint64_t run_once(Tally& tally, const std::string& source) {
    fuzz::session().digest = 0;
    limit_time(20);
    fuzz::Program program(present.data(), present.size());
    try {
        fuzz::run(program);
    } catch (const fuzz::Finding& finding) {
        if (!finding.ignored) report(tally, finding.check, source);
    }
    limit_time(0);
    return fuzz::session().digest;
}

void run_present(Tally& tally, const std::string& source) {
    const uint64_t digest = run_once(tally, source);
    if (tally.other_modes) {
        set_mode(tally.programs);
        if (run_once(tally, source) != digest)
            report(tally, "every floating-point mode gives the same answers", source);
        set_mode(std::nullopt);
    }
    ++tally.programs;
    tally.digest = (tally.digest ^ digest) * 0x9e3779b97f4a7c15;
    if (tally.print_digests) std::printf("%s %016llx\n", source.c_str(), static_cast<unsigned long long>(digest));
}

void replay(const std::filesystem::path& path, Tally& tally) {
    if (std::filesystem::is_directory(path)) {
        std::vector<std::filesystem::path> files;
        for (const auto& entry : std::filesystem::directory_iterator(path)) files.push_back(entry.path());
        std::sort(files.begin(), files.end());
        for (const auto& file : files) replay(file, tally);
        return;
    }
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        std::fprintf(stderr, "cannot read %s\n", path.string().c_str());
        std::exit(2);
    }
    present.assign(std::istreambuf_iterator<char>(file), {});
    run_present(tally, path.filename().string());
}

void run_random(Tally& tally, uint64_t seed, double seconds, uint64_t programs, std::optional<uint64_t> only) {
    const auto start = std::chrono::steady_clock::now();
    const auto elapsed = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    for (uint64_t i = only.value_or(0); i < only.value_or(programs - 1) + 1; ++i) {
        if (programs == UINT64_MAX && elapsed() >= seconds) break;
        // Of neighbouring numbers make distant states (splitmix64, Steele et al. 2014).
        uint64_t mixed = (seed << 32) + i + 1;
        mixed = (mixed ^ mixed >> 30) * 0xbf58476d1ce4e5b9;
        mixed = (mixed ^ mixed >> 27) * 0x94d049bb133111eb;
        Random random{(mixed ^ mixed >> 31) | 1};
        present.resize(64 << random.next() % 6);  // 64 .. 2048 bytes
        for (size_t k = 0; k < present.size(); k += 8) {
            const uint64_t bits = random.next();
            std::memcpy(&present[k], &bits, 8);
        }
        if (only) keep("program-" + std::string(fuzz::target_name) + "-" + std::to_string(i));
        run_present(tally, "seed " + std::to_string(seed) + ", program " + std::to_string(i));
    }
}

}  // namespace

int main(int count, char** arguments) {
    Tally tally;
    std::vector<std::string> paths;
    double seconds = 0;
    uint64_t programs = 0, seed = 1;
    std::optional<uint64_t> only;
    for (int i = 1; i < count; ++i) {
        const std::string argument = arguments[i];
        const auto value = [&] {
            if (++i < count) return std::string(arguments[i]);
            std::fprintf(stderr, "%s needs a value\n", argument.c_str());
            std::exit(2);
        };
        if (argument == "--seconds") {
            seconds = std::stod(value());
        } else if (argument == "--programs") {
            programs = std::stoull(value());
        } else if (argument == "--program") {
            only = std::stoull(value());
            programs = 1;
        } else if (argument == "--seed") {
            seed = std::stoull(value());
        } else if (argument == "--ignore") {
            fuzz::ignore(value());
        } else if (argument == "--keep") {
            keep_in = value();
        } else if (argument == "--digests") {
            tally.print_digests = true;
        } else if (argument == "--print") {
            fuzz::session().print = true;
        } else if (argument == "--exceptions") {
            fuzz::session().exceptions = true;
        } else if (argument == "--round") {
            const std::string way = value();
            fuzz::session().rounding = way == "up" ? FE_UPWARD : way == "down" ? FE_DOWNWARD : FE_TOWARDZERO;
        } else if (argument == "--flush") {
            fuzz::session().flush = true;
        } else if (argument == "--modes") {
            tally.other_modes = true;
        } else {
            paths.push_back(argument);
        }
    }
    std::snprintf(crash_file, sizeof crash_file, "%s/crash-%s-%llu", keep_in.c_str(), fuzz::target_name,
                  static_cast<unsigned long long>(seed));
    watch_for_crashes();
    for (const std::string& path : paths) replay(path, tally);
    const uint64_t replayed = tally.programs;
    if (seconds > 0 || programs > 0) run_random(tally, seed, seconds, programs > 0 ? programs : UINT64_MAX, only);
    for (const auto& [check, times] : tally.findings) {
        std::printf("%s: does not hold in %llu programs: %s\n", fuzz::target_name,
                    static_cast<unsigned long long>(times), check.c_str());
    }
    std::printf("%s: %llu inputs replayed, %llu random programs, %llu operations, digest %016llx, %zu findings\n",
                fuzz::target_name, static_cast<unsigned long long>(replayed),
                static_cast<unsigned long long>(tally.programs - replayed),
                static_cast<unsigned long long>(fuzz::session().operations),
                static_cast<unsigned long long>(tally.digest), tally.findings.size());
    if (tally.programs == 0) std::fprintf(stderr, "nothing was run\n");
    return tally.findings.empty() && tally.programs > 0 ? 0 : 1;
}
