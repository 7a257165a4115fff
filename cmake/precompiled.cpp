// Empty: the object that a precompiled header belongs to (gw_precompiled.cmake).
