# Linux on x86-64, with the system's g++.
set(CMAKE_C_COMPILER gcc)
set(CMAKE_CXX_COMPILER g++)
