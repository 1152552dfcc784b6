// fabricsh under the address sanitizer. libedit keeps the two words that it copies for EL_ADDFN for good, as
// it says itself; nothing else here calls wcsdup.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:wcsdup\n"; }
