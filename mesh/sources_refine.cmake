# target_sources(asterism PRIVATE ...)
