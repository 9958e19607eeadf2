// The circuits of rules. Written by `thinbench-study circuits`.
#pragma once

#include "rules/built_in/circuit.hpp"

namespace thinbench::detail {

// clang-format off

template <>
inline constexpr Circuit<8> kThreeInputCircuit<BuiltInRule::naccache_shinghal, 0> = {kByHand, {{
    {0xC0, {5, 7, 7}}, {0xC0, {3, 7, 7}}, {0xB0, {3, 8, 9}}, {0x30, {5, 6, 6}},
    {0xE0, {1, 11, 12}}, {0x1C, {10, 13, 2}}, {0x34, {13, 9, 0}}, {0x02, {14, 15, 4}},
}}};

template <>
inline constexpr Circuit<14> kTwoInputCircuit<BuiltInRule::naccache_shinghal, 0> = {kByHand, {{
    {0x0C, {0, 5, 5}}, {0x0C, {2, 3, 3}}, {0xFC, {10, 9, 9}}, {0x0C, {6, 5, 5}},
    {0x0C, {8, 3, 3}}, {0xFC, {13, 12, 12}}, {0xC0, {1, 14, 14}}, {0xC0, {7, 11, 11}},
    {0xFC, {16, 15, 15}}, {0xC0, {1, 7, 7}}, {0xC0, {5, 3, 3}}, {0xC0, {19, 18, 18}},
    {0x0C, {20, 17, 17}}, {0x0C, {21, 4, 4}},
}}};

template <>
inline constexpr Circuit<11> kThreeInputCircuit<BuiltInRule::zhang_suen, 0> = {kByHand, {{
    {0xDB, {2, 1, 0}}, {0xB2, {5, 6, 7}}, {0xE7, {2, 3, 6}}, {0x43, {9, 6, 8}},
    {0x51, {12, 1, 3}}, {0xB2, {13, 10, 8}}, {0xDB, {14, 2, 7}}, {0x90, {11, 14, 0}},
    {0x81, {10, 14, 5}}, {0x4F, {9, 15, 17}}, {0xA8, {18, 16, 4}},
}}};

template <>
inline constexpr Circuit<26> kTwoInputCircuit<BuiltInRule::zhang_suen, 0> = {6000, {{
    {0x0C, {5, 0, 0}}, {0xFC, {2, 9, 9}}, {0x0C, {5, 6, 6}}, {0x0C, {7, 10, 10}},
    {0xFC, {11, 12, 12}}, {0x0C, {6, 5, 5}}, {0x0C, {5, 2, 2}}, {0x0C, {15, 7, 7}},
    {0xFC, {14, 16, 16}}, {0x0C, {17, 8, 8}}, {0x0C, {18, 13, 13}}, {0x0C, {2, 19, 19}},
    {0x0C, {0, 17, 17}}, {0xFC, {8, 19, 19}}, {0xC0, {21, 22, 22}}, {0xC0, {3, 20, 20}},
    {0x0C, {3, 23, 23}}, {0x3C, {24, 25, 25}}, {0x0C, {3, 6, 6}}, {0x0C, {27, 19, 19}},
    {0x0C, {0, 3, 3}}, {0x0C, {29, 28, 28}}, {0xC0, {1, 30, 30}}, {0x0C, {1, 26, 26}},
    {0x3C, {31, 32, 32}}, {0x0C, {33, 4, 4}},
}}};

template <>
inline constexpr Circuit<14> kThreeInputCircuit<BuiltInRule::zhang_suen_skimage, 0> = {5000, {{
    {0xE4, {7, 2, 6}}, {0xB0, {9, 2, 5}}, {0x73, {3, 0, 2}}, {0x89, {9, 3, 5}},
    {0x40, {7, 9, 0}}, {0xF4, {13, 6, 3}}, {0x59, {12, 6, 14}}, {0x89, {10, 1, 7}},
    {0xEC, {12, 16, 11}}, {0xA2, {15, 0, 17}}, {0x32, {11, 18, 1}}, {0x70, {4, 10, 19}},
    {0xB0, {4, 19, 14}}, {0xCA, {8, 20, 21}},
}}};

template <>
inline constexpr Circuit<29> kTwoInputCircuit<BuiltInRule::zhang_suen_skimage, 0> = {17000, {{
    {0xFC, {2, 6, 6}}, {0x0C, {7, 6, 6}}, {0x3C, {9, 10, 10}}, {0xC0, {0, 6, 6}},
    {0x3C, {7, 12, 12}}, {0x0C, {8, 13, 13}}, {0x3C, {11, 14, 14}}, {0x0C, {5, 2, 2}},
    {0x0C, {16, 15, 15}}, {0x0C, {3, 6, 6}}, {0x0C, {3, 11, 11}}, {0xFC, {5, 19, 19}},
    {0x3C, {3, 20, 20}}, {0x0C, {13, 21, 21}}, {0x0C, {2, 3, 3}}, {0x0C, {23, 0, 0}},
    {0xFC, {21, 24, 24}}, {0x0C, {17, 8, 8}}, {0x0C, {26, 25, 25}}, {0x0C, {22, 7, 7}},
    {0x0C, {28, 27, 27}}, {0x0C, {18, 29, 29}}, {0x0C, {30, 4, 4}}, {0xC0, {17, 21, 21}},
    {0x0C, {24, 32, 32}}, {0x0C, {33, 4, 4}}, {0xFC, {1, 34, 34}}, {0x0C, {31, 1, 1}},
    {0x3C, {35, 36, 36}},
}}};

template <>
inline constexpr Circuit<15> kThreeInputCircuit<BuiltInRule::zhang_suen_skimage, 1> = {6000, {{
    {0x4E, {2, 0, 1}}, {0x21, {7, 0, 6}}, {0x2B, {9, 6, 10}}, {0x1E, {9, 10, 2}},
    {0xB8, {8, 7, 1}}, {0xBE, {12, 0, 13}}, {0xB5, {14, 7, 2}}, {0x8A, {11, 15, 4}},
    {0x8C, {6, 12, 13}}, {0x2A, {8, 12, 5}}, {0xB3, {17, 11, 18}}, {0xB0, {16, 5, 19}},
    {0xE8, {14, 20, 17}}, {0xA8, {21, 18, 4}}, {0xD8, {20, 22, 3}},
}}};

template <>
inline constexpr Circuit<30> kTwoInputCircuit<BuiltInRule::zhang_suen_skimage, 1> = {5000, {{
    {0x3C, {3, 5, 5}}, {0x0C, {9, 4, 4}}, {0x3C, {7, 10, 10}}, {0x0C, {2, 11, 11}},
    {0xFC, {6, 12, 12}}, {0x3C, {0, 2, 2}}, {0x0C, {14, 1, 1}}, {0x0C, {2, 6, 6}},
    {0x3C, {15, 16, 16}}, {0x3C, {5, 12, 12}}, {0x0C, {1, 13, 13}}, {0x0C, {2, 19, 19}},
    {0xFC, {18, 20, 20}}, {0x0C, {7, 13, 13}}, {0x0C, {22, 21, 21}}, {0x0C, {3, 13, 13}},
    {0x0C, {24, 17, 17}}, {0x0C, {25, 0, 0}}, {0x0C, {26, 23, 23}}, {0xC0, {19, 27, 27}},
    {0x0C, {28, 4, 4}}, {0x0C, {3, 27, 27}}, {0x0C, {30, 29, 29}}, {0x0C, {7, 25, 25}},
    {0x0C, {32, 29, 29}}, {0xC0, {5, 10, 10}}, {0xFC, {33, 34, 34}}, {0xFC, {8, 35, 35}},
    {0x0C, {31, 8, 8}}, {0x3C, {36, 37, 37}},
}}};

template <>
inline constexpr Circuit<8> kThreeInputCircuit<BuiltInRule::guo_hall, 0> = {53000, {{
    {0x0D, {6, 1, 5}}, {0xD4, {9, 7, 0}}, {0xD1, {3, 10, 9}}, {0xB0, {4, 5, 11}},
    {0x42, {10, 6, 2}}, {0x74, {13, 3, 11}}, {0x18, {8, 1, 0}}, {0x70, {12, 14, 15}},
}}};

template <>
inline constexpr Circuit<18> kTwoInputCircuit<BuiltInRule::guo_hall, 0> = {36000, {{
    {0x0C, {0, 7, 7}}, {0xFC, {2, 3, 3}}, {0xC0, {0, 5, 5}}, {0x0C, {11, 8, 8}},
    {0xC0, {10, 12, 12}}, {0xFC, {1, 13, 13}}, {0x0C, {6, 14, 14}}, {0xFC, {9, 15, 15}},
    {0x0C, {14, 6, 6}}, {0xC0, {8, 17, 17}}, {0x0C, {3, 5, 5}}, {0xFC, {18, 19, 19}},
    {0x0C, {7, 0, 0}}, {0x0C, {12, 10, 10}}, {0xC0, {21, 22, 22}}, {0xFC, {20, 23, 23}},
    {0xC0, {16, 24, 24}}, {0x0C, {25, 4, 4}},
}}};

template <>
inline constexpr Circuit<12> kThreeInputCircuit<BuiltInRule::lu_wang, 0> = {2000, {{
    {0xC5, {7, 6, 8}}, {0x3A, {7, 1, 2}}, {0x2F, {10, 1, 0}}, {0x40, {8, 7, 11}},
    {0x32, {11, 12, 6}}, {0x3B, {9, 0, 13}}, {0x54, {14, 8, 5}}, {0xF1, {15, 1, 8}},
    {0xD0, {16, 2, 6}}, {0xE8, {14, 11, 5}}, {0xB8, {13, 3, 18}}, {0xC8, {17, 4, 19}},
}}};

template <>
inline constexpr Circuit<25> kTwoInputCircuit<BuiltInRule::lu_wang, 0> = {5000, {{
    {0x0C, {8, 3, 3}}, {0x0C, {0, 8, 8}}, {0xFC, {1, 10, 10}}, {0x0C, {0, 3, 3}},
    {0x0C, {12, 11, 11}}, {0x0C, {9, 6, 6}}, {0x0C, {14, 13, 13}}, {0x0C, {7, 15, 15}},
    {0xFC, {6, 16, 16}}, {0x0C, {15, 2, 2}}, {0x0C, {18, 17, 17}}, {0x0C, {7, 8, 8}},
    {0x0C, {20, 19, 19}}, {0x0C, {1, 7, 7}}, {0xC0, {13, 22, 22}}, {0xC0, {2, 16, 16}},
    {0xFC, {23, 24, 24}}, {0xFC, {0, 22, 22}}, {0xC0, {21, 26, 26}}, {0xFC, {3, 25, 25}},
    {0xC0, {27, 28, 28}}, {0x0C, {5, 29, 29}}, {0xC0, {5, 25, 25}}, {0x3C, {30, 31, 31}},
    {0x0C, {32, 4, 4}},
}}};

template <>
inline constexpr Circuit<5> kThreeInputCircuit<BuiltInRule::spta_directional, 0> = {1000, {{
    {0xAE, {1, 0, 3}}, {0xF2, {9, 7, 6}}, {0x01, {8, 7, 1}}, {0xF2, {10, 2, 11}},
    {0x8C, {5, 4, 12}},
}}};

template <>
inline constexpr Circuit<9> kTwoInputCircuit<BuiltInRule::spta_directional, 0> = {1000, {{
    {0xFC, {1, 2, 2}}, {0xFC, {8, 9, 9}}, {0x0C, {6, 10, 10}}, {0xFC, {7, 11, 11}},
    {0x0C, {1, 0, 0}}, {0x0C, {13, 12, 12}}, {0xC0, {5, 14, 14}}, {0x0C, {3, 15, 15}},
    {0x0C, {16, 4, 4}},
}}};

// clang-format on

}  // namespace thinbench::detail
