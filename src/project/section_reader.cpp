#include "project/section_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/closest_name.h"

namespace goniolux::project {

SectionReader::SectionReader(const core::Value& value, const Section& section, Reading& reading)
    : value_(value), section_(section), reading_(reading) {
  if (!value.isObject()) {
    reading.error(value, "wrong-type", fmt::format("{} is expected here: an object {{ … }}", section.title));
    failed_ = true;
    return;
  }
  checkKeys();
}

void SectionReader::checkKeys() {
  std::vector<std::string> meant;  // keys that unknown ones most likely stand for: not reported as missing too
  for (const auto& [name, member] : value_.object()) {
    const Key* key = section_.find(name);
    if (!key) {
      meant.push_back(core::closestName(name, section_.names()));
      reading_.diagnostics.error(
          member.keyPosition(), "unknown-key",
          fmt::format("{} has no key \"{}\"{}", section_.title, name, core::suggestion(name, section_.names())));
      failed_ = true;
    }
  }
  for (const Key& key : section_.keys) {
    if (!key.required || value_.find(key.name)) continue;
    failed_ = true;
    if (std::find(meant.begin(), meant.end(), key.name) == meant.end()) {
      reading_.error(value_, "missing-key", fmt::format("{} needs \"{}\": {}", section_.title, key.name, key.help));
    }
  }
}

const Key& SectionReader::known(const std::string& key) const {
  const Key* found = section_.find(key);
  // A reader that asks for a key outside the table is a mistake of this program: such a key could never be given.
  if (!found) throw std::logic_error("the format has no key \"" + key + "\" in " + section_.title);
  return *found;
}

const core::Value* SectionReader::find(const std::string& key) const {
  return value_.find(known(key).name);
}

void SectionReader::refuse(const std::string& key, const std::string& rule, const std::string& message) {
  const core::Value* at = find(key);
  reading_.error(at ? *at : value_, rule, message);
  failed_ = true;
}

std::optional<double> SectionReader::number(const std::string& key) {
  const core::Value* value = find(key);
  if (!value || (value->isNull() && known(key).form == Form::numberOrNull)) return std::nullopt;
  const auto number = readNumber(*value, known(key), reading_);
  failed_ |= !number;
  return number;
}

std::optional<int> SectionReader::integer(const std::string& key) {
  const auto value = number(key);
  if (!value) return std::nullopt;
  if (*value != std::floor(*value) || std::abs(*value) > 2e9) {
    refuse(key, "wrong-type", fmt::format("\"{}\" is {}; a whole number is expected", key, *value));
    return std::nullopt;
  }
  return static_cast<int>(*value);
}

std::optional<bool> SectionReader::boolean(const std::string& key) {
  const core::Value* value = find(key);
  if (!value) return std::nullopt;
  if (!value->isBoolean()) {
    refuse(key, "wrong-type", fmt::format("\"{}\" must be true or false", key));
    return std::nullopt;
  }
  return value->boolean();
}

std::optional<std::string> SectionReader::text(const std::string& key) {
  const core::Value* value = find(key);
  if (!value) return std::nullopt;
  auto text = readText(*value, known(key), reading_);
  failed_ |= !text;
  return text;
}

std::optional<std::string> SectionReader::choice(const std::string& key) {
  const auto chosen = text(key);
  if (!chosen) return std::nullopt;
  const Key& description = known(key);
  const std::vector<std::string>& all = description.choices;
  if (std::find(all.begin(), all.end(), *chosen) != all.end()) return chosen;
  failed_ = true;
  refuse(key, "unknown-value", fmt::format("\"{}\" cannot be \"{}\"{}", key, *chosen, core::suggestion(*chosen, all)));
  return std::nullopt;
}

std::optional<double> SectionReader::length(const std::string& key) {
  const auto value = number(key);
  if (!value) return std::nullopt;
  const double metres = *value * reading_.metresPerUnit;
  if (std::abs(metres) > 1e7) {
    refuse(key, "out-of-range", fmt::format("\"{}\" is {} m; lengths may reach 10 000 km", key, metres));
    return std::nullopt;
  }
  return metres;
}

std::optional<core::Vec3> SectionReader::point(const std::string& key) {
  const core::Value* value = find(key);
  if (!value) return std::nullopt;
  const auto point = readPoint(*value, known(key), reading_);
  failed_ |= !point;
  return point;
}

std::optional<core::Vec3> SectionReader::direction(const std::string& key) {
  const core::Value* value = find(key);
  if (!value) return std::nullopt;
  const auto direction = readDirection(*value, known(key), reading_);
  failed_ |= !direction;
  return direction;
}

namespace {

template <typename ReadOne>
std::optional<std::vector<core::Vec3>> readList(const core::Value& value, const Key& key, Reading& reading,
                                                ReadOne readOne) {
  if (!value.isArray() || value.array().empty()) {
    reading.error(value, "wrong-type",
                  fmt::format("\"{}\" must be a list [[x, y, z], …] with at least one entry", key.name));
    return std::nullopt;
  }
  std::vector<core::Vec3> list;
  for (const core::Value& entry : value.array()) {
    const auto vector = readOne(entry, key, reading);
    if (!vector) return std::nullopt;  // one message, not one per entry of a long list
    list.push_back(*vector);
  }
  return list;
}

}  // namespace

std::optional<std::vector<core::Vec3>> SectionReader::points(const std::string& key) {
  const core::Value* value = find(key);
  if (!value) return std::nullopt;
  auto list = readList(*value, known(key), reading_, readPoint);
  failed_ |= !list;
  return list;
}

std::optional<std::vector<core::Vec3>> SectionReader::directions(const std::string& key) {
  const core::Value* value = find(key);
  if (!value) return std::nullopt;
  auto list = readList(*value, known(key), reading_, readDirection);
  failed_ |= !list;
  return list;
}

std::optional<std::array<int, 2>> SectionReader::counts(const std::string& key) {
  const core::Value* value = find(key);
  if (!value) return std::nullopt;
  constexpr double most = 1e6;
  std::array<int, 2> counts{};
  bool good = value->isArray() && value->array().size() == 2;
  for (std::size_t i = 0; good && i < 2; ++i) {
    const core::Value& count = value->array()[i];
    good = count.isNumber() && count.number() >= 1 && count.number() <= most &&
           count.number() == std::floor(count.number());
    if (good) counts[i] = static_cast<int>(count.number());
  }
  if (good && static_cast<double>(counts[0]) * counts[1] <= most) return counts;
  refuse(key, good ? "out-of-range" : "wrong-type",
         good ? fmt::format("\"{}\" asks for {} x {}; at most a million in all", key, counts[0], counts[1])
              : fmt::format("\"{}\" must be two whole numbers of at least 1, e.g. [3, 2]", key));
  return std::nullopt;
}

std::optional<double> SectionReader::percentage(const std::string& key) {
  const core::Value* value = find(key);
  if (!value) return std::nullopt;
  std::optional<double> fraction;
  if (value->isString()) fraction = fractionFromText(value->string());
  if (value->isNumber() && value->number() > 0 && value->number() < 1) fraction = value->number();
  if (!fraction) {
    refuse(key, "out-of-range", fmt::format("\"{}\" must be a percentage above 0 and below 100 such as \"2 %\"", key));
  }
  return fraction;
}

}  // namespace goniolux::project
