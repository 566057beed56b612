/* One cycle of Belytschko-Tsay shells in plain C, element after element: three points, elastic, viscous hourglass
   control, then the nodes. The arithmetic of vmharness/explicit/elements/shell_belytschko_tsay, ISDO 0. */
#include <math.h>

#define FOR(i, n) for (int i = 0; i < (n); i++)
#define POINTS 3

typedef struct {
    double E, nu, thickness, kappa, C[3];   /* C: hourglass constants, membrane, warping, bending */
    double zeta[POINTS], weight[POINTS];
} Section;

static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void cross(const double *a, const double *b, double *c) {
    c[0] = a[1] * b[2] - a[2] * b[1], c[1] = a[2] * b[0] - a[0] * b[2], c[2] = a[0] * b[1] - a[1] * b[0];
}

/* Rows of T: e1, e2, e3; B[i]: gradient d/dx_i on the differences 1-3 and 2-4; h: hourglass pattern of x. Returns A. */
static double frame(double x[4][3], double T[3][3], double B[2][2], double *h) {
    double r13[3], r24[3], r21[3], n[3], g[3];
    FOR(k, 3) r13[k] = x[0][k] - x[2][k], r24[k] = x[1][k] - x[3][k], r21[k] = x[1][k] - x[0][k];
    cross(r13, r24, n);
    double twice = sqrt(dot(n, n));
    FOR(k, 3) T[2][k] = n[k] / twice;
    double along = dot(r21, T[2]);
    FOR(k, 3) T[0][k] = r21[k] - along * T[2][k];
    double inverse = 1 / sqrt(dot(T[0], T[0]));
    FOR(k, 3) T[0][k] *= inverse;
    cross(T[2], T[0], T[1]);
    B[0][0] = dot(r24, T[1]) / twice, B[0][1] = -dot(r13, T[1]) / twice;
    B[1][0] = -dot(r24, T[0]) / twice, B[1][1] = dot(r13, T[0]) / twice;
    FOR(k, 3) g[k] = x[0][k] - x[1][k] + x[2][k] - x[3][k];
    FOR(k, 3) h[k] = dot(T[k], g);
    return 0.5 * twice;
}

/* Gradients g[0] = dv/dx, g[1] = dv/dy and the hourglass pattern p of a nodal field, all in the triad. */
static void rates(double v[4][3], double T[3][3], double B[2][2], double g[2][3], double *p) {
    double d13[3], d24[3], q[3];
    FOR(k, 3) d13[k] = v[0][k] - v[2][k], d24[k] = v[1][k] - v[3][k], q[k] = v[0][k] - v[1][k] + v[2][k] - v[3][k];
    FOR(k, 3) {
        double a = dot(T[k], d13), b = dot(T[k], d24);
        g[0][k] = B[0][0] * a + B[0][1] * b, g[1][k] = B[1][0] * a + B[1][1] * b, p[k] = dot(T[k], q);
    }
}

static double length(double x[4][3], double A) {
    double longest = 0;
    FOR(i, 4) {
        double r[3];
        FOR(k, 3) r[k] = x[(i + 1) % 4][k] - x[i][k];
        longest = fmax(longest, dot(r, r));
    }
    return A / sqrt(longest);
}

/* Transpose of `rates`: coefficients u of the gradients, Q of the pattern, and an equal share s, off the field `out`. */
static void spread(double T[3][3], double B[2][2], double u[2][3], const double *Q, const double *s,
                   const long *node, double *out) {
    double p[3], q[3], r[3];
    FOR(k, 3) p[k] = q[k] = r[k] = 0;
    FOR(i, 3) FOR(k, 3) {
        p[k] += T[i][k] * (B[0][0] * u[0][i] + B[1][0] * u[1][i]);
        q[k] += T[i][k] * (B[0][1] * u[0][i] + B[1][1] * u[1][i]);
        r[k] += T[i][k] * Q[i];
    }
    FOR(k, 3) {
        double mean = T[0][k] * s[0] + T[1][k] * s[1];
        out[3 * node[0] + k] -= mean + p[k] + r[k], out[3 * node[1] + k] -= mean + q[k] - r[k];
        out[3 * node[2] + k] -= mean - p[k] + r[k], out[3 * node[3] + k] -= mean - q[k] - r[k];
    }
}

double forces(long elements, const long *nodes, const double *x, const double *v, const double *omega, double dt,
              const Section *s, double *stress, double *hourglass, double *f, double *moment, double *energy) {
    double shortest = INFINITY, t = s->thickness;
    double plate = s->E / (1 - s->nu * s->nu), G = s->E / (2 * (1 + s->nu));
    for (long e = 0; e < elements; e++, stress += 5 * POINTS, hourglass += 5) {
        const long *node = nodes + 4 * e;
        double X[4][3], middle[4][3], V[4][3], W[4][3], T[3][3], B[2][2], h[3], g[2][3], w[2][3], p[3], o[3];
        FOR(i, 4) FOR(k, 3) {
            X[i][k] = x[3 * node[i] + k], V[i][k] = v[3 * node[i] + k], W[i][k] = omega[3 * node[i] + k];
            middle[i][k] = X[i][k] - 0.5 * dt * V[i][k];
        }
        double A = frame(middle, T, B, h), mean[3], turn[2];
        rates(V, T, B, g, p), rates(W, T, B, w, o);
        FOR(k, 3) mean[k] = 0.25 * (W[0][k] + W[1][k] + W[2][k] + W[3][k]);
        FOR(k, 2) turn[k] = dot(T[k], mean);
        double spin = 0.5 * (g[0][1] - g[1][0]);
        double chord = 1 - dt * dt / 12 * (g[1][2] * g[1][2] + g[0][2] * g[0][2] + spin * spin);
        double yz = dt * (chord * g[1][2] - turn[0]), zx = dt * (chord * g[0][2] + turn[1]);
        double N[3] = {0}, M[3] = {0}, S[2] = {0}, work = 0;
        FOR(i, POINTS) {
            double z = 0.5 * t * s->zeta[i], dz = 0.5 * t * s->weight[i], *a = stress + 5 * i, b[5];
            double xx = dt * (g[0][0] + z * w[0][1]), yy = dt * (g[1][1] - z * w[1][0]);
            double xy = dt * (g[1][0] + g[0][1] + z * (w[1][1] - w[0][0]));
            b[0] = a[0] + plate * (xx + s->nu * yy), b[1] = a[1] + plate * (yy + s->nu * xx);
            b[2] = a[2] + G * xy, b[3] = a[3] + G * yz, b[4] = a[4] + G * zx;
            work += 0.5 * dz * A * ((a[0] + b[0]) * xx + (a[1] + b[1]) * yy + (a[2] + b[2]) * xy
                                    + s->kappa * ((a[3] + b[3]) * yz + (a[4] + b[4]) * zx));
            FOR(k, 3) N[k] += dz * b[k], M[k] += z * dz * b[k];
            FOR(k, 2) S[k] += s->kappa * dz * b[3 + k];
            FOR(k, 5) a[k] = b[k];
        }
        double q[5], H[5];
        FOR(k, 3) q[k] = p[k] - h[0] * g[0][k] - h[1] * g[1][k];
        FOR(k, 2) q[k] += h[2] * g[k][2], q[3 + k] = o[k] - h[0] * w[0][k] - h[1] * w[1][k];
        H[0] = s->C[0] * q[0], H[1] = s->C[0] * q[1], H[2] = s->C[1] * q[2];
        H[3] = s->C[2] * q[3], H[4] = s->C[2] * q[4];
        FOR(k, 5) energy[1] += 0.5 * dt * (hourglass[k] + H[k]) * q[k], hourglass[k] = H[k];
        energy[0] += work;

        A = frame(X, T, B, h);
        shortest = fmin(shortest, length(X, A));
        double by_v[2][3] = {
            {A * N[0] - h[0] * H[0], A * N[2] - h[0] * H[1], A * S[1] - h[0] * H[2] + h[2] * H[0]},
            {A * N[2] - h[1] * H[0], A * N[1] - h[1] * H[1], A * S[0] - h[1] * H[2] + h[2] * H[1]}};
        double by_w[2][3] = {{-A * M[2] - h[0] * H[3], A * M[0] - h[0] * H[4], 0},
                             {-A * M[1] - h[1] * H[3], A * M[2] - h[1] * H[4], 0}};
        double R[3] = {H[3], H[4], 0}, none[2] = {0}, shear[2] = {-0.25 * A * S[0], 0.25 * A * S[1]};
        spread(T, B, by_v, H, none, node, f), spread(T, B, by_w, R, shear, node, moment);
    }
    return shortest;
}

/* The nodes: accelerations, kinetic energy, velocities, coordinates; the forces are cleared for the next cycle. */
double advance(long n, double *x, double *v, double *omega, double *f, double *moment, const double *mass,
               const double *inertia, double before, double dt) {
    double kinetic = 0;
    for (long i = 0; i < n; i++) FOR(k, 3) {
        long at = 3 * i + k;
        double a = f[at] / mass[i], alpha = moment[at] / inertia[i];
        double now = v[at] + 0.5 * before * a, turning = omega[at] + 0.5 * before * alpha;
        kinetic += 0.5 * (mass[i] * now * now + inertia[i] * turning * turning);
        v[at] += 0.5 * (before + dt) * a, omega[at] += 0.5 * (before + dt) * alpha;
        x[at] += dt * v[at];
        f[at] = moment[at] = 0;
    }
    return kinetic;
}
