// SPDX-License-Identifier: Apache-2.0
// The system around the hardware: firmware, bus, DRAM.
#include <fmt/format.h>

#include "host/report/page_sections.hpp"
#include "host/report/page_text.hpp"

namespace gnomon::report {
namespace {

Json firmware_rows(const Json& f) {
  return Json::array({row("image", count(f.at("image_bytes")) + " bytes"), row("jobs", count(f.at("jobs"))),
                      row("instructions", count(f.at("instructions"))),
                      row("instructions a job", number(f.at("instructions_per_job"), 0)),
                      row("processor asleep", share(f.at("asleep_share"))),
                      row("waited for the bus", count(f.at("cycles_waited")) + " cycles"),
                      row("polled registers", count(f.at("cycles_polling")) + " cycles"),
                      row("interrupts", count(f.at("interrupts"))),
                      row("registers read, written",
                          count(f.at("register_reads")) + ", " + count(f.at("register_writes")))});
}

Json dram_rows(const Json& d) {
  return Json::array(
      {row("reads, writes", count(d.at("reads")) + ", " + count(d.at("writes"))),
       row("bytes", count(d.at("bytes"))), row("bytes a cycle", number(d.at("bytes_per_cycle"), 3)),
       row("data bus busy", share(d.at("bus_share"))), row("row open already", share(d.at("row_hit_share"))),
       row("another row open", count(d.at("row_conflicts")))});
}

Json cache_rows(const Json& cache) {
  Json rows = Json::array();
  for (const auto& [name, value] : cache.items()) rows.push_back(row(name, count(value)));
  return rows;
}

Json bus_rows(const Json& bus) {
  Json rows = Json::array();
  for (const Json& target : bus)
    rows.push_back({{"target", target.at("target")},
                    {"reads", count(target.at("reads"))},
                    {"writes", count(target.at("writes"))},
                    {"bytes", count(target.at("bytes"))}});
  return rows;
}

}  // namespace

Json system_section(const Json& m) {
  const Json& system = m.at("system");
  if (system.is_null()) return {{"system", false}};
  std::string log;
  for (const Json& line : system.at("firmware").at("log")) log += line.get<std::string>() + "\n";
  return {{"system",
           {{"cycles_line", fmt::format("{} cycles from power-up to the last report; inside the hardware: {}",
                                        count(system.at("cycles")), plain(system.at("inside")))},
            {"firmware", firmware_rows(system.at("firmware"))},
            {"dram", dram_rows(system.at("dram"))},
            {"bus", bus_rows(system.at("bus"))},
            {"cache", !system.at("cache").empty()},
            {"cache_rows", cache_rows(system.at("cache"))},
            {"log", log}}}};
}

}  // namespace gnomon::report
