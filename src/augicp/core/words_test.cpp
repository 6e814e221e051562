// SPDX-License-Identifier: MIT
#include "augicp/core/words.h"

#include <gmock/gmock.h>

namespace augicp {

enum class Fruit { Apple, Sloe };
template <>
inline constexpr auto kWords<Fruit> = std::to_array<Word<Fruit>>({{Fruit::Apple, "apple"}, {Fruit::Sloe, "sloe"}});

namespace {

enum class Wordless { One };

TEST(Words, NameAndValueUndoEachOther) {
  for (const auto& [value, word] : kWords<Fruit>) {
    EXPECT_EQ(name_of(value), word);
    EXPECT_EQ(value_of<Fruit>(word), value);
  }
}

TEST(Words, OthersHaveNone) {
  EXPECT_EQ(name_of(static_cast<Fruit>(7)), "");
  for (const char* word : {"", "Apple", "apple ", "appl", "plum"})
    EXPECT_EQ(value_of<Fruit>(word), std::nullopt) << word;
  EXPECT_FALSE(HasWords<Wordless>);
  EXPECT_FALSE(HasWords<double>);
}

}  // namespace
}  // namespace augicp
