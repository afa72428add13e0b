// Ipopt may use OpenBLAS. While that is loaded it starts a thread for each core, and each waits for work in a busy loop, for about 70 ms
// of CPU time: as much as many a command takes. Nothing here is large enough for a second thread. To set OPENBLAS_NUM_THREADS in
// main() is too late; but OpenBLAS calls this function for the variable's value, and of a shared library's functions the
// program's own definition is taken. Another BLAS never calls it.

extern "C" {
__attribute__((visibility("default"))) int openblas_num_threads_env(void);
int openblas_num_threads_env(void) { return 1; }
}
