// This file is empty. Its object owns a precompiled header (gw_precompiled.cmake).
