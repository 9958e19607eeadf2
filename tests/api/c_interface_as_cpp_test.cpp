#include "c_interface_test.c"
