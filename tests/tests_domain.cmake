# asterism_test(name SOURCES ... LINK ...)
