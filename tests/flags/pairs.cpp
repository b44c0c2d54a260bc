// Differences and sums of products side by side, of which compilers make fused operations.

void multiply(const double* __restrict a, const double* __restrict b, double* __restrict product,
              int count) {
    for (int i = 0; i < count; ++i) {
        product[2 * i] = a[2 * i] * b[2 * i] - a[2 * i + 1] * b[2 * i + 1];
        product[2 * i + 1] = a[2 * i] * b[2 * i + 1] + a[2 * i + 1] * b[2 * i];
    }
}

void add_products(const double* __restrict a, const double* __restrict b, double* __restrict sum) {
    sum[0] = a[0] * b[0] - sum[0];
    sum[1] = a[1] * b[1] + sum[1];
}
