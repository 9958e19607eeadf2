#include "paired/wire.hpp"

#include <stdexcept>

#include <nlohmann/json.hpp>

namespace thinbench {
namespace {

using nlohmann::json;

json parsed(const std::string& line) {
  json object = json::parse(line, nullptr, false);
  if (!object.is_object()) throw std::runtime_error("no line of measurements: '" + line + "'");
  return object;
}

}  // namespace

void to_json(json& object, const Entry& entry) {
  object = {{"name", entry.name},      {"calls", entry.calls},     {"counted", entry.counted},
            {"long", entry.long_call}, {"warm_up", entry.warm_up}, {"threaded", entry.threaded},
            {"hash", entry.hash}};
}

void from_json(const json& object, Entry& entry) {
  object.at("name").get_to(entry.name);
  object.at("calls").get_to(entry.calls);
  object.at("counted").get_to(entry.counted);
  object.at("long").get_to(entry.long_call);
  object.at("warm_up").get_to(entry.warm_up);
  object.at("threaded").get_to(entry.threaded);
  object.at("hash").get_to(entry.hash);
}

void to_json(json& object, const Group& group) {
  object = {{"rounds", group.rounds},
            {"sweeps", group.sweeps},
            {"anchor", group.anchor},
            {"entries", group.entries}};
}

void from_json(const json& object, Group& group) {
  object.at("rounds").get_to(group.rounds);
  object.at("sweeps").get_to(group.sweeps);
  object.at("anchor").get_to(group.anchor);
  object.at("entries").get_to(group.entries);
}

void to_json(json& object, const ClockTimes& times) {
  object = {{"logs", times.logs}, {"ns", times.ns}};
}

void from_json(const json& object, ClockTimes& times) {
  object.at("logs").get_to(times.logs);
  object.at("ns").get_to(times.ns);
}

void to_json(json& object, const EntryTimes& times) {
  object = {{"cpu", times.thread_cpu}, {"wall", times.wall}};
}

void from_json(const json& object, EntryTimes& times) {
  object.at("cpu").get_to(times.thread_cpu);
  object.at("wall").get_to(times.wall);
}

void to_json(json& object, const BinariseOptions& options) {
  object = {{"foreground", options.foreground}};
  if (options.threshold) object["threshold"] = *options.threshold;
}

void from_json(const json& object, BinariseOptions& options) {
  object.at("foreground").get_to(options.foreground);
  if (object.contains("threshold")) options.threshold = object["threshold"].get<int>();
}

std::string to_line(const Order& order) {
  const json object = {
      {"pictures", order.pictures}, {"binarise", order.binarise}, {"groups", order.groups}};
  return object.dump() + "\n";
}

std::string to_line(const GroupTimes& times) {
  const json object = {
      {"group", times.group}, {"entries", times.entries}, {"layout", times.layout}};
  return object.dump() + "\n";
}

Order order_from(const std::string& line) {
  const json object = parsed(line);
  return {object.at("pictures").get<std::vector<std::string>>(),
          object.at("binarise").get<BinariseOptions>(),
          object.at("groups").get<std::vector<Group>>()};
}

GroupTimes group_times_from(const std::string& line) {
  const json object = parsed(line);
  return {object.at("group").get<std::size_t>(),
          object.at("entries").get<std::vector<EntryTimes>>(),
          object.at("layout").get<std::vector<std::size_t>>()};
}

}  // namespace thinbench
