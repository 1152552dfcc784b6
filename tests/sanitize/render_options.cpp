// fabricsh-render under the address sanitizer: all is looked for but leaks. VTK 9.1 never lets go of the
// labels given to vtkCubeAxesActor nor of a byte of its geometry filter, and the graphics library that it
// unloads leaves blocks whose origin can't be named, so that they can't be told from others by a list.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() { return "detect_leaks=0"; }
