#include <gtest/gtest.h>

TEST(Laws, CanBeRunByAConsumer) { SUCCEED(); }
