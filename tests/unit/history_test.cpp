#include "app/viewer/history.h"

#include <catch2/catch.hpp>

using namespace glimt;

TEST_CASE("undo and redo lead through the steps, and end at the first and the last") {
  History<int> history(1);
  CHECK_FALSE(history.canUndo());
  CHECK(history.undo() == 1);
  history.keep(2);
  history.keep(3);
  CHECK(history.undo() == 2);
  CHECK(history.undo() == 1);
  CHECK_FALSE(history.canUndo());
  CHECK(history.redo() == 2);
  CHECK(history.redo() == 3);
  CHECK_FALSE(history.canRedo());
  CHECK(history.redo() == 3);
}

TEST_CASE("a step after an undo takes the place of what was undone") {
  History<int> history(1);
  history.keep(2);
  history.undo();
  history.keep(7);
  CHECK_FALSE(history.canRedo());
  CHECK(history.undo() == 1);
  CHECK(history.redo() == 7);
}

TEST_CASE("the same value again is no step") {
  History<int> history(1);
  history.keep(1);
  CHECK_FALSE(history.canUndo());
}

TEST_CASE("of very many steps the last ones are kept") {
  History<int> history(0);
  for (int i = 1; i <= 2000; ++i) history.keep(i);
  CHECK(history.now() == 2000);
  int steps = 0;
  for (; history.canUndo(); ++steps) history.undo();
  CHECK(steps > 100);
  CHECK(steps < 2000);
}
