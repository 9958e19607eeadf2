#include "study/study.hpp"

int main(int argc, char** argv) {
  return thinbench::run_main(thinbench::study_program(), argc, argv);
}
