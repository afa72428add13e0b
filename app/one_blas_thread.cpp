// Ipopt's BLAS may be OpenBLAS. Before main() begins that starts a thread for each core, and each waits for work in a busy loop, for
// about 70 ms of CPU time: as much as many a command takes. Nothing here is large enough for a second thread. main() is too late
// to say so by OPENBLAS_NUM_THREADS, but the program's own symbols come before those of its libraries: OpenBLAS asks this
// function how many threads that variable wishes for. Another BLAS never asks.

extern "C" {
__attribute__((visibility("default"))) int openblas_num_threads_env(void);
int openblas_num_threads_env(void) { return 1; }
}
