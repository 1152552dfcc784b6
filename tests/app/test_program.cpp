// The program from outside: what it prints, its exit codes.
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "catch.hpp"
#include "program.hpp"

using namespace fabricsh;

namespace {

struct Ran {
  int code;
  std::string out;
};

// Runs the program in a shell; `more` may redirect. Standard error goes into out too.
Ran run(const std::string& more, const std::string& before = "") {
  const std::string command = before + "'" FABRICSH_PROGRAM "' " + more + " 2>&1";
  std::FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string out;
  char buffer[4096];
  for (std::size_t n = 0; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) out.append(buffer, n);
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, out};
}

void write(const std::string& path, const std::string& text) { std::ofstream(path) << text; }
bool has(const std::string& all, const std::string& part) { return all.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("exit codes") {
  CHECK(run("-e 'x = 1'").code == 0);
  CHECK(run("-e 'error \"no\"'").code == 1);
  CHECK(run("-e 'error{kind=\"numerical\", message=\"stuck\"}'").code == 3);
  CHECK(run("-e 'error()'").out == "fabricsh: error without a message (error() was called with nil)\n");
  CHECK(run("-e 'error{ code=7, why=\"no thread\" }'").out ==
        "fabricsh: error without a text: {code = 7, why = \"no thread\"}\n");
  CHECK(run("--nonsense").code == 2);
  CHECK(
      run("--thread 2").out ==
      "fabricsh: unknown option '--thread', did you mean '--threads'?; fabricsh --help shows the options\n");
  CHECK(has(run("--threads 5000 -e 'x=1'").out, "expected an integer from 1 to 4096, got '5000'"));
  CHECK(run("--threads none -e 'x=1'").code == 2);
  CHECK(run("--check").code == 2);
  CHECK(run("-e").code == 2);
  for (const char* words : {"''", "--quiet -- ''", "-i ''", "--check ''"}) {
    const Ran empty = run(words, "echo 'print(1)' | ");
    CHECK(empty.code == 2);
    CHECK(
        empty.out ==
        "fabricsh: the name of the deck is empty (- is standard input); fabricsh --help shows the options\n");
  }
}

TEST_CASE("a numerical failure of a run, uncaught and caught") {
  const std::string deck =
      "local fabric = require 'fabric'\n"
      "local mesh = fabric.mesh.rectangle{ width=0.1, height=0.1, nx=2, ny=2 }\n"
      "local m = fabric.model{ mesh=mesh, card=fabric.card 'blend' }\n"
      "m:fix('bottom', 'x y z'):move('top', { y=fabric.ramp(0.5, 1) })\n"  // folds out of plane: nothing
                                                                           // holds it
      "m:force('all', { z=fabric.ramp(1e9, 1) })\n"
      "local a = fabric.static{ model=m, duration=1, max_cuts=2, max_iterations=5 }\n";
  write("fails.lua", deck + "a:solve()\n");
  const Ran uncaught = run("fails.lua");
  INFO(uncaught.out);
  CHECK(uncaught.code == 3);
  CHECK(has(uncaught.out, "fails.lua:7: solve: "));
  write("caught.lua",
        deck +
            "local ok, e = pcall(a.solve, a)\nassert(not ok and e.kind == 'numerical' and e.time >= 0)\n"
            "print(e)\n");
  CHECK(run("caught.lua").code == 0);
}

TEST_CASE("a deck that does not exist, a syntax error") {
  const Ran missing = run("no-such-deck.lua");
  CHECK(missing.code == 1);
  CHECK(has(missing.out, "cannot read 'no-such-deck.lua': No such file"));
  // One that came with the program is found from this folder, unless there is one of that name here.
  CHECK(run("--check scripts/law/reload.lua").code == 0);
  CHECK(run("--check scripts/thesis/fig_4_11_svk.lua").code ==
        0);  // it reads chapter.lua, which lies beside it
  CHECK(has(run("scripts/law/no-such-deck.lua").out, "cannot read 'scripts/law/no-such-deck.lua'"));
  std::filesystem::create_directories("scripts/law");
  write("scripts/law/reload.lua", "print 'mine'\n");
  CHECK(run("scripts/law/reload.lua").out == "mine\n");
  write("syntax.lua", "x = = 1\n");
  const Ran syntax = run("syntax.lua");
  CHECK(syntax.code == 1);
  CHECK(has(syntax.out, "syntax.lua:1: unexpected symbol near '='"));
}

TEST_CASE("arguments, standard input, -l, order of -e") {
  write("args.lua", "print(arg[0], arg[1], #arg, ...)\n");
  CHECK(run("args.lua a b").out == "args.lua\ta\t2\ta\tb\n");
  CHECK(run("-", "echo 'print(7)' | ").out == "7\n");
  CHECK(run("-e 'x = 1' -e 'print(x + 1)'").out == "2\n");
  write("plain.lua", "return { answer = 42 }\n");
  CHECK(run("-l plain -e 'print(plain.answer)'").out == "42\n");
  CHECK(run("-e 'print(3*inch)'").out == "0.0762\n");
  CHECK(run("-- args.lua").out == "args.lua\tnil\t0\n");
}

TEST_CASE("an interactive session reads standard input when there is no terminal") {
  const Ran ran =
      run("", "printf '1 + 1\\nerror(\"no\")\\nfor i = 1, 2 do\\nprint(i)\\nend\\n\"end\"\\n' | ");
  CHECK(ran.code == 1);  // nobody sees the error, so the program says so at the end
  CHECK(run("", "printf 'x = 1\\nx + 1\\n' | ").code == 0);
  CHECK(run("", "printf 'error{ kind=\"numerical\" }\\n1 + 1\\n' | ").code == 3);
  CHECK(has(ran.out, "2\n"));
  CHECK(has(ran.out, "prompt:1: no"));
  CHECK(has(ran.out, "1\n2\nend\n"));
  CHECK(has(run("'" FABRICSH_SOURCE_DIR "/scripts/thesis/uniaxial.lua' -h").out,
            "usage: fabricsh uniaxial.lua"));
  CHECK(run("'" FABRICSH_SOURCE_DIR "/scripts/thesis/uniaxial.lua' -h").code == 0);
  write("sets.lua", "y = 5\n");
  CHECK(has(run("-i sets.lua", "echo 'y + 1' | ").out, "6\n"));
}

TEST_CASE("--version and --help") {
  const std::string about = run("--version").out;
  INFO(about);
  for (const char* word : {"fabricsh 0.", "Lua 5.4", "Eigen 3.", "UMFPACK ", "CHOLMOD ", "OpenBLAS ",
                           "VTK 9.", "libedit ", "kernels for ", " threads", "gnuplot: ", "Xvfb: "})
    CHECK(has(about, word));
  CHECK(has(run("--version", "PATH=/nowhere ").out, "gnuplot: not found, needed for figures"));
  CHECK(has(run("--help").out, "usage: fabricsh"));
}

TEST_CASE("a standard output that is full is told, and is no success") {
  const auto full = [](const std::string& words) { return run(words + " 2>&1 >/dev/full; }", "{ "); };
  for (const char* words : {"--help", "--version", "-e 'print(1)'", "-e 'io.write(1) os.exit(0)'",
                            "-e 'io.write(1) os.exit(0, true)'"}) {
    INFO(words);
    const Ran ran = full(words);
    CHECK(ran.code == 1);
    CHECK(has(ran.out, "fabricsh: standard output is incomplete"));
  }
  write("full.lua", "print(1)\n");
  for (const char* words :
       {"full.lua", "--safe full.lua", "--check full.lua", "-l full", "-", "-i full.lua"}) {
    INFO(words);
    const Ran ran = run(std::string(words) + " 2>&1 >/dev/full; }", "echo 'print(1)' | { ");
    CHECK(ran.code == 1);
    CHECK(has(ran.out, "fabricsh: standard output is incomplete"));
  }
  for (const char* input : {"1 + 1", "print(1)", "help()", "quit\nquit"}) {  // of a prompt without a terminal
    INFO(input);
    CHECK(run("2>&1 >/dev/full; }", "echo '" + std::string(input) + "' | { ").code ==
          (*input == 'q' ? 0 : 1));
  }
  CHECK(has(full("--help").out, "No space left on device"));
  CHECK(full("-e 'print(1) os.exit(7)'").code == 7);
  CHECK(full("-e 'print(1) error()'").code == 1);
  CHECK(full("-e 'x = 1'").code == 0);
  CHECK(run("-e 'print(1)' 2>&1 >&-; }", "{ ").code == 1);
  CHECK(run("-e 'x = 1' 2>&1 >&-; }", "{ ").code == 0);
  CHECK(run("-e 'for i = 1, 3 do io.write(i) end'").out == "123");
}

TEST_CASE("printed text goes into no file where the caller has closed a stream") {
  write("closed.lua",
        "local file = io.open(arg[1], 'w') file:write 'time,force\\n' file:flush()\n"
        "print 'a message' io.stdout:flush() io.stderr:write 'another' require 'fabric'.warn 'a third'\n"
        "assert(io.read() == nil)\n"
        "file:write '0,1\\n' file:close()\n");
  const std::pair<std::string, int> cases[] = {{">&-", 1},      {"2>&-", 0},    {"<&-", 0},
                                               {">&- 2>&-", 1}, {"<&- >&-", 1}, {"<&- >&- 2>&-", 1}};
  for (const auto& [closed, code] : cases) {  // a message that nobody hears is told
    INFO(closed);
    CHECK(run("closed.lua closed.csv " + closed + "; }", "{ : | ").code == code);
    CHECK(content_of("closed.csv") == "time,force\n0,1\n");
  }
}

#if !defined(__SANITIZE_ADDRESS__)  // whose frames are larger
TEST_CASE("runs within hooks of runs end in an error where the stack does") {
  write("nest.lua",
        "local fabric = require 'fabric'\n"
        "local mesh = fabric.mesh.rectangle{ width=0.2, height=0.1, nx=2, ny=1 }\n"
        "local deepest = 0\n"
        "local function level(n)\n"
        "  deepest = n\n"
        "  local m = fabric.model{ mesh=mesh, card=fabric.card 'blend' }\n"
        "  m:fix('all', 'z rotation'):fix('left', 'x y'):move('right', { x=fabric.ramp(1e-3, 1), y=0 })\n"
        "  local a, within = fabric.static{ model=m, duration=1, step=0.5 }, n > 300\n"
        "  a:every(1, function() if not within then within = true level(n + 1) end end)\n"
        "  a:solve()\n"
        "  return a.time\n"
        "end\n"
        "local ok, why = pcall(level, 1)\n"
        "print(ok, tostring(why):match 'nested too deeply' or tostring(why):match 'stack overflow', deepest "
        "> 3)\n"
        "deepest = 300 print(level(301))\n");
  CHECK(run("nest.lua", "ulimit -s 256; ").out == "false\tnested too deeply\ttrue\n1.0\n");
  CHECK(has(run("nest.lua", "ulimit -s 8192; ").out, "\ttrue\n1.0\n"));
}
#endif

TEST_CASE("a program without its files says what is missing and what to set") {
  std::system("rm -rf lonely && mkdir -p lonely/bin && cp '" FABRICSH_PROGRAM "' lonely/bin/alone");
  const std::string alone = "; env -u FABRICSH_HOME lonely/bin/alone -e ";
  const Ran ran = run("-e 'x = 1'" + alone + "'x = 1'");
  CHECK(ran.code == 1);
  CHECK(ran.out ==
        "fabricsh: the program's own files are missing: lua/fabric/library.lua is neither in share/fabricsh "
        "beside the "
        "program nor in the source tree of its build; set FABRICSH_HOME to the folder that holds lua/ and "
        "share/cards/ "
        "(PREFIX/share/fabricsh of an installation, or the source tree)\n");
  CHECK(has(run("-e 'x = 1'; FABRICSH_HOME=/nowhere lonely/bin/alone -e 'x = 1'").out,
            "lua/fabric/library.lua is neither in FABRICSH_HOME ('/nowhere') nor in share/fabricsh beside"));
  CHECK(run("-e 'x = 1'; FABRICSH_HOME='" FABRICSH_SOURCE_DIR
            "' lonely/bin/alone -e 'print(card \"denim\".name)'")
            .out == "denim\n");
  std::system("rm -r lonely");
}

TEST_CASE("Ctrl-C while gnuplot draws is an interruption, and gnuplot ends with it") {
  std::system("rm -rf slow-gnuplot && mkdir slow-gnuplot");
  write("slow-gnuplot/gnuplot",
        "#!/bin/sh\ntouch slow-gnuplot/started\nsleep 60\ntouch slow-gnuplot/late\necho words >&2\nexit 1\n");
  std::system("chmod +x slow-gnuplot/gnuplot");
  const std::string path = std::getenv("PATH");
  setenv("PATH", ("slow-gnuplot:" + path).c_str(), 1);
  test::Program program(
      {"-e", "plot{ file='slow-gnuplot/a.svg', curves={ {x={0, 1}, y={0, 1}} } } print 'not reached'"},
      "slow-gnuplot/log");
  setenv("PATH", path.c_str(), 1);
  for (int i = 0; i < 1200 && !std::filesystem::exists("slow-gnuplot/started"); ++i) usleep(50'000);
  program.signal(SIGINT);
  CHECK(program.wait() == 128 + SIGINT);
  CHECK(content_of("slow-gnuplot/log") == "fabricsh: (command line):1: plot: interrupted\n");
  CHECK_FALSE(std::filesystem::exists("slow-gnuplot/late"));
  CHECK_FALSE(std::filesystem::exists("slow-gnuplot/a.svg"));
}

TEST_CASE("Ctrl-C that comes as soon as gnuplot has begun is an interruption, too") {
  std::system("rm -rf soon-gnuplot && mkdir soon-gnuplot");
  write("soon-gnuplot/gnuplot", "#!/bin/sh\nkill -INT $PPID\nsleep 60\n");
  std::system("chmod +x soon-gnuplot/gnuplot");
  const std::string path = std::getenv("PATH");
  // Each takes the seconds that the program gives gnuplot to end, so that they run at once.
  std::vector<std::unique_ptr<test::Program>> programs;
  const auto log = [](int i) { return "soon-gnuplot/log" + std::to_string(i); };
  setenv("PATH", ("soon-gnuplot:" + path).c_str(), 1);
  for (int i = 0; i < 3; ++i) {
    const std::string file = "soon-gnuplot/" + std::to_string(i) + ".svg";
    programs.push_back(std::make_unique<test::Program>(
        std::vector<std::string>{"-e", "plot{ file='" + file + "', curves={ {x={0, 1}, y={0, 1}} } }"},
        log(i)));
  }
  setenv("PATH", path.c_str(), 1);
  for (int i = 0; i < 3; ++i) {
    CHECK(programs[static_cast<std::size_t>(i)]->wait() == 128 + SIGINT);
    CHECK(content_of(log(i)) == "fabricsh: (command line):1: plot: interrupted\n");
  }
}

TEST_CASE("kernels that are none are refused") {
  const Ran ran = run("-e 'x = 1'", "FABRICSH_ISA=foo ");
  CHECK(ran.code == 2);
  CHECK(has(ran.out, "fabricsh: FABRICSH_ISA: expected one that this machine has (baseline"));
  CHECK(has(ran.out, "got 'foo'"));
  CHECK(has(run("--version", "FABRICSH_ISA=baseline ").out, "kernels for baseline"));
}

TEST_CASE("--restart needs a deck") {
  for (const char* words : {"--restart some.ckpt", "--restart some.ckpt -i"}) {
    const Ran ran = run(words, "echo 1 | ");
    CHECK(ran.code == 2);
    CHECK(ran.out == "fabricsh: --restart needs the deck that wrote the checkpoint\n");
  }
  CHECK(has(run("--restart= args.lua").out, "'--restart' needs an argument"));
}

TEST_CASE("below an error of a deck stands who called whom") {
  write("part.lua",
        "local part = {}\nfunction part.cut(w)\n  local x = w.size + 1\n  return x\nend\nreturn part\n");
  write("whole.lua",
        "local part = require 'part'\nlocal function all(w)\n  local x = part.cut(w)\n  return "
        "x\nend\n\nlocal y = all()\n");
  const Ran ran = run("whole.lua");
  CHECK(ran.code == 1);
  CHECK(ran.out ==
        "fabricsh: ./part.lua:3: attempt to index a nil value (local 'w')\n"
        "  called from whole.lua:3, in 'all'\n"
        "  called from whole.lua:7\n");
}

TEST_CASE("--check validates and writes nothing") {
  std::system("rm -rf checked");
  const std::string deck = "'" FABRICSH_SOURCE_DIR "/scripts/thesis/uniaxial.lua' ";
  CHECK(run("--check " + deck + "blend warp free 80 checked").code == 0);
  CHECK(std::system("test ! -e checked") == 0);
  const Ran wrong = run("--check " + deck + "blend wrap");
  CHECK(wrong.code == 1);
  CHECK(has(wrong.out, "argument 2 (direction): expected warp or weft, got 'wrap'"));
}
