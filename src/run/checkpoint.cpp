#include "run/checkpoint.hpp"

#include <algorithm>
#include <filesystem>

#include "base/error.hpp"
#include "base/hash.hpp"
#include "base/number.hpp"
#include "base/version.hpp"
#include "card/fields.hpp"
#include "format/checkpoint.hpp"
#include "mechanics/terms/contact.hpp"
#include "simd/isa.hpp"

namespace fabricsh::run {

namespace {

void add_part(model::Fingerprint& parts, const std::string& name, const std::string& text,
              const std::string& bytes) {
  parts.push_back({name, text, hash(bytes)});
}

// What this build makes of the model, so that a run would go on with a jump if another one did: the masses of
// the nodes, and the gap, floor and stiffness of contact where they are not given.
Archive derived_by(const mechanics::Assembly& assembly) {
  Archive out;
  std::vector<double> masses = assembly.cloth().mass();
  out(masses);
  if (const auto* const contact = assembly.terms().find<mechanics::Contacts>(); contact != nullptr)
    for (const auto& m : contact->surfaces().meetings()) {
      double gap = m.data.gap, floor = m.data.floor, carried = m.carried;
      out(gap, floor, carried);
    }
  return out;
}

std::string part_text(const std::string& kind, const std::string& path) {
  if (kind == "keep") return "kept table of checkpoint '" + path + "'";
  return (kind == "record" ? "table '" : "series '") + path + "'";
}

std::string bytes_of(Checkpoint checkpoint) {
  Archive archive;
  checkpoint.keep(archive);
  return archive.bytes();
}

std::shared_ptr<Checkpoint> checkpoint_from(const std::string& path, std::string bytes) {
  auto c = std::make_shared<Checkpoint>();
  Archive archive(std::move(bytes));
  const auto refuse = [&](const std::string& why) { throw Error("checkpoint '" + path + "': " + why); };
  try {
    c->keep(archive);
  } catch (const Error& error) {
    refuse(error.what());
  }
  if (c->edition != model::fingerprint_edition)
    refuse(
        "another build of fabricsh wrote it, which describes the problem in other parts: that build can go "
        "on from it");
  if (!archive.at_end()) refuse("it is damaged: data follow after its end");
  if (c->instructions != name(best_isa()))
    refuse("it was written with the instructions " + c->instructions + ", this machine has " +
           name(best_isa()) + ": its results would be rounded differently");
  c->path = path;
  return c;
}

constexpr const char* kDerived =
    "masses of the nodes or default contact (which another build derives otherwise)";

// What a deck gives.
model::Fingerprint given(model::Fingerprint all) {
  std::erase_if(all, [](const auto& part) { return part.name == kDerived; });
  return all;
}

}  // namespace

model::Fingerprint problem_of(const Run& run) {
  model::Fingerprint parts;
  add_part(parts, "method", run.method(), run.method());
  const std::string duration = exact_number(run.duration()) + " s";
  add_part(parts, "duration", duration, duration);
  if (const std::string kernels = run.kernels(); !kernels.empty())
    add_part(parts,
             "BLAS kernels (other kernels give other bits; the variable OPENBLAS_CORETYPE selects them)",
             kernels, kernels);
  if (run.origin() != 0)
    parts.push_back({"state from which it begins", "time " + exact_number(run.began()) + " s", run.origin()});
  const model::Model& m = run.model();
  for (const auto& region : m.regions()) {
    std::string cards = card::lua_text(region.card);
    for (const auto& ply : region.options.plies) cards += card::lua_text(ply.card);
    add_part(parts, "card" + model::of_region(m, region), region.card.name, cards);
  }
  for (auto& part : model::fingerprint(m, run.duration())) parts.push_back(std::move(part));
  Archive derived = derived_by(run.assembly());
  add_part(parts, kDerived, "", derived.bytes());
  return parts;
}

const Checkpoint::Finished* Checkpoint::finished_run(std::int64_t number_of_run) const {
  const auto found = std::find_if(finished.begin(), finished.end(),
                                  [&](const Finished& one) { return one.number == number_of_run; });
  return found == finished.end() ? nullptr : &*found;
}

Checkpoint checkpoint_of(Run& run) {
  Checkpoint c;
  c.version = version();
  c.instructions = name(best_isa());
  c.problem = problem_of(run);
  c.time = run.time();
  c.state = run.kept();
  Archive settings;
  run.keep_settings(settings);
  c.settings = settings.bytes();
  return c;
}

void write_checkpoint(const std::string& path, const Checkpoint& checkpoint) {
  format::write_checkpoint(path, bytes_of(checkpoint));
}

std::shared_ptr<const Checkpoint> read_checkpoint(const std::string& path) {
  return checkpoint_from(path, format::read_checkpoint(path));
}

std::optional<std::uint64_t> copy_checkpoint(const std::string& from, const std::string& to) {
  std::string bytes;
  try {
    const auto checkpoint = checkpoint_from(from, format::read_checkpoint(from));
    checkpoint->finished.clear();
    bytes = bytes_of(*checkpoint);
  } catch (const Error&) {
    return {};
  }
  format::write_checkpoint(to, bytes);
  return hash(bytes);
}

std::optional<std::uint64_t> hash_of_checkpoint(const std::string& path) {
  try {
    return hash(format::read_checkpoint(path));
  } catch (const Error&) {
    return {};
  }
}

std::string file_of(const Checkpoint& checkpoint, const Checkpoint::Finished& finished) {
  namespace fs = std::filesystem;
  return (fs::absolute(checkpoint.path).parent_path() / finished.file).lexically_normal().string();
}

std::shared_ptr<const Checkpoint> read_finished(const Checkpoint& checkpoint,
                                                const Checkpoint::Finished& finished) {
  const std::string file = file_of(checkpoint, finished);
  std::string bytes = format::read_checkpoint(file);
  if (hash(bytes) != finished.hash)
    throw Error("checkpoint '" + file + "': it is not as it was when '" + checkpoint.path + "' was written");
  return checkpoint_from(checkpoint.path, std::move(bytes));
}

std::string difference(const Checkpoint& checkpoint, const Run& run) {
  const model::Fingerprint here = problem_of(run);
  const std::string differs = model::difference(given(checkpoint.problem), given(here));
  return differs.empty() ? model::difference(checkpoint.problem, here) : differs;
}

void take_up(Run& run, const Checkpoint& checkpoint) {
  try {
    Archive settings(checkpoint.settings);
    run.keep_settings(settings);
    run.resume(checkpoint.state);
  } catch (const Error& error) {
    throw Error("checkpoint '" + checkpoint.path + "': " + error.what());
  }
}

const std::string* Claims::take(const std::string& kind, const std::string& path) {
  if (!open()) return nullptr;
  const auto& parts = from_->parts;
  const auto find = [&](const auto& fits) -> const std::string* {
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (parts[i].kind == kind && fits(i)) {
        claimed_[i] = path;
        return &parts[i].bytes;
      }
    return nullptr;
  };
  const auto is_free = [&](std::size_t i) { return claimed_.count(i) == 0; };
  const std::string* part = find([&](std::size_t i) { return !is_free(i) && claimed_[i] == path; });
  if (part == nullptr) part = find([&](std::size_t i) { return is_free(i) && parts[i].path == path; });
  if (part == nullptr) part = find(is_free);
  if (part == nullptr)
    throw Error("checkpoint '" + from_->path + "': the run that wrote it had no " + part_text(kind, path) +
                " there; new ones can be added after the first solve(), advance() or step()");
  return part;
}

void Claims::check() {
  if (!open()) return;
  for (std::size_t i = 0; i < from_->parts.size(); ++i) {
    const auto& part = from_->parts[i];
    if (claimed_.count(i) == 0)
      throw Error("checkpoint '" + from_->path + "': it has the " + part_text(part.kind, part.path) +
                  ", which this run does not continue: repeat the call that wrote it, after the restart");
  }
  went_on_ = true;
}

}  // namespace fabricsh::run
