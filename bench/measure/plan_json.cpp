#include "measure/plan_json.hpp"

#include <limits>
#include <map>
#include <set>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "harness/case_json.hpp"
#include "peers/peers.hpp"
#include "support/json_field.hpp"

namespace thinbench {

using nlohmann::json;

NLOHMANN_JSON_SERIALIZE_ENUM(Role,
                             {{Role::row, "row"}, {Role::same, "same"}, {Role::slowed, "slowed"}})
NLOHMANN_JSON_SERIALIZE_ENUM(Foreground, {{Foreground::automatic, "auto"},
                                          {Foreground::bright, "bright"},
                                          {Foreground::dark, "dark"}})
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Entry, name, role, calls, delay_ns, warm_up, visits, threaded,
                                   seconds, hash)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Group, entries, layouts)

void to_json(json& object, const InputChoice& choice) {
  object = {{"pictures", choice.pictures},
            {"drawn", choice.drawn},
            {"foreground", choice.binarise.foreground},
            {"threshold", choice.binarise.threshold ? json(*choice.binarise.threshold) : json()}};
}

void from_json(const json& object, InputChoice& choice) {
  object.at("pictures").get_to(choice.pictures);
  object.at("drawn").get_to(choice.drawn);
  object.at("foreground").get_to(choice.binarise.foreground);
  if (!object.at("threshold").is_null()) {
    choice.binarise.threshold = object.at("threshold").get<int>();
  }
}

namespace {

template <class Number>
json or_null(const std::optional<Number>& number) {
  return number ? json(*number) : json();
}

json input_json(const TimedInput& input) {
  return {{"name", input.name},
          {"width", input.width()},
          {"height", input.height()},
          {"hash", pixel_hash(input.binary.view())},
          {"grey_hash", pixel_hash(input.grey.view())},
          {"foreground_pixels", foreground_pixels(input.binary.view())}};
}

/// What timings.csv tells of a row beside its times.
json row_json(const TimedRow& row) {
  const bool is_reference = row.variant == nullptr;
  json object = case_json<json>(*row.operation);
  object.update(
      {{"technique", is_reference ? "reference" : row.variant->technique},
       {"isa", is_reference ? "baseline" : row.variant->isa_label()},
       {"threads", row.threads},
       {"scope", scope_name(row.scope)},
       {"input", row.input->name},
       {"counter", or_null(row.counter)},
       {"plan_bytes", or_null(row.plan_bytes)},
       {"peer", row.is_peer()},
       {"default", !is_reference && is_default(*row.operation, *row.variant, row.input->width())},
       {"scalar", is_reference || (!row.is_peer() && is_scalar(*row.variant))}});
  return object;
}

json peers_json(const Selection& selection) {
  std::set<std::string_view> techniques;
  for (const TimedRow& row : selection.rows) {
    if (row.is_peer()) techniques.insert(row.variant->technique);
  }
  json list = json::array();
  for (const Peer& peer : peers()) {
    if (techniques.count(peer.technique) == 0) continue;
    list.push_back({{"technique", peer.technique},
                    {"about", peer.about},
                    {"equal_output", peer.equal_output}});
  }
  return list;
}

}  // namespace

json plan_json(const Plan& plan, const Selection& selection, const std::vector<TimedInput>& inputs,
               const std::vector<CalibratedRow>& rows) {
  json object = {{"sources", plan.inputs},
                 {"cycle_ns", plan.cycle_ns},
                 {"groups", plan.groups},
                 {"inputs", json::array()},
                 {"rows", json::object()},
                 {"skipped", json::array()},
                 {"peers", peers_json(selection)},
                 {"verified", selection.verified},
                 {"mismatches", selection.mismatches}};
  for (const TimedInput& input : inputs) object["inputs"].push_back(input_json(input));
  for (const CalibratedRow& row : rows) object["rows"][row.row->name] = row_json(*row.row);
  for (const SkippedRow& row : selection.skipped) {
    object["skipped"].push_back({{"row", row.name}, {"reason", row.reason}});
  }
  return object;
}

namespace {

void check_integer(const JsonField& object, const char* key, std::int64_t min) {
  constexpr std::int64_t max = std::numeric_limits<std::int32_t>::max();
  const JsonField field = object.member(key);
  const std::int64_t value = field.integer();
  if (value < min || value > max) {
    field.fail("is " + std::to_string(value) + ", not from " + std::to_string(min) + " to " +
               std::to_string(max));
  }
}

/// Numbers that are repeated, divided by or converted: what no plan has is rejected.
void check_numbers(const json& object, const std::string& name) {
  const JsonField groups = JsonField(object, name, "").member("groups");
  for (std::size_t i = 0; i < groups.count(0, 1'000'000, "groups"); ++i) {
    const JsonField group = groups.element(i);
    check_integer(group, "layouts", 1);
    const JsonField entries = group.member("entries");
    for (std::size_t k = 0; k < entries.count(1, 1'000'000, "entries"); ++k) {
      const JsonField entry = entries.element(k);
      for (const char* key : {"calls", "visits"}) check_integer(entry, key, 1);
      check_integer(entry, "warm_up", 0);
      const JsonField delay = entry.member("delay_ns");
      if (!delay.json().is_number() || delay.json() < 0) delay.fail("must be a number of at least 0");
    }
  }
  const JsonField sources = JsonField(object, name, "").member("sources");
  if (!sources.member("threshold").json().is_null()) check_integer(sources, "threshold", 0);
}

}  // namespace

Plan plan_from_json(const std::string& text) {
  try {
    const std::string name = "standard input";
    const json object = parse_json(text, name);
    check_numbers(object, name);
    return {object.at("sources").get<InputChoice>(), object.at("cycle_ns").get<double>(),
            object.at("groups").get<std::vector<Group>>()};
  } catch (const json::exception& error) {
    throw std::runtime_error(std::string("standard input holds no plan: ") + error.what());
  }
}

json group_times_json(const GroupTimes& times) {
  return {{"group", times.group}, {"entries", times.entries}};
}

}  // namespace thinbench
