#!/usr/bin/env python3
"""Makes normal_quantiles.csv and normal_numbers.csv beside it, from the definitions alone."""
import math
from decimal import Decimal, getcontext
from pathlib import Path
from statistics import NormalDist

getcontext().prec = 70
TINY = Decimal(10) ** -68


def arctan_of_inverse(n):
    total = term = Decimal(1) / n
    k = 1
    while abs(term) > TINY:
        term = -term / (n * n)
        k += 2
        total += term / k
    return total


PI = 4 * (4 * arctan_of_inverse(5) - arctan_of_inverse(239))


def density(x):
    return (-x * x / 2).exp() / (2 * PI).sqrt()


def above(x):
    """The part of the normal distribution above x >= 0."""
    if x < 6:
        total = term = x
        k = 1
        while abs(term) > TINY:
            term = term * x * x / (2 * k + 1)
            total += term
            k += 1
        return Decimal(1) / 2 - density(x) * total
    fraction = Decimal(0)
    for k in range(4000, 0, -1):
        fraction = k / (x + fraction)
    return density(x) / (x + fraction)


def quantile(p):
    """z with Phi(z) = p, by Newton's iteration."""
    p = Decimal(p)
    tail = min(p, 1 - p)
    z = Decimal(-NormalDist().inv_cdf(float(tail)))
    for _ in range(6):
        z += (above(z) - tail) / density(z)
    return z if p > tail else -z


def seed_seq(seeds, count):
    """std::seed_seq::generate, [rand.util.seedseq]."""
    mask, s, n = 0xFFFFFFFF, len(seeds), count
    b = [0x8B8B8B8B] * n
    t = 11 if n >= 623 else 7 if n >= 68 else 5 if n >= 39 else 3 if n >= 7 else (n - 1) // 2
    p, m = (n - t) // 2, max(s + 1, n)
    q = p + t
    for k in range(m):
        x = b[k % n] ^ b[(k + p) % n] ^ b[(k - 1) % n]
        r1 = 1664525 * (x ^ (x >> 27)) & mask
        r2 = (r1 + (s if k == 0 else k % n + seeds[k - 1] if k <= s else k % n)) & mask
        b[(k + p) % n] = (b[(k + p) % n] + r1) & mask
        b[(k + q) % n] = (b[(k + q) % n] + r2) & mask
        b[k % n] = r2
    for k in range(m, m + n):
        x = (b[k % n] + b[(k + p) % n] + b[(k - 1) % n]) & mask
        r3 = 1566083941 * (x ^ (x >> 27)) & mask
        r4 = (r3 - k % n) & mask
        b[(k + p) % n] ^= r3
        b[(k + q) % n] ^= r4
        b[k % n] = r4
    return b


def mt19937_64(state):
    """The numbers of the engine, [rand.eng.mers], from 312 words of state."""
    state, n = list(state), 312
    while True:
        for i in range(n):
            y = (state[i] & ~0x7FFFFFFF) | (state[(i + 1) % n] & 0x7FFFFFFF)
            state[i] = state[(i + 156) % n] ^ (y >> 1) ^ (0xB5026F5AA96619E9 * (y & 1))
        for y in state:
            y ^= (y >> 29) & 0x5555555555555555
            y ^= (y << 17) & 0x71D67FFFEDA60000
            y ^= (y << 37) & 0xFFF7EEE000000000
            yield y ^ (y >> 43)


def engine(seed, part, index):
    words = [seed, seed >> 32, part, index, index >> 32]
    halves = seed_seq([word & 0xFFFFFFFF for word in words], 624)
    return mt19937_64([halves[2 * i] | halves[2 * i + 1] << 32 for i in range(312)])


def rounded(z):
    return f"{z:.24e}" if z else "0"


folder = Path(__file__).parent
levels = [1e-15, 1e-12, 1e-10, 1e-8, 1e-6, 1e-5, 1e-4, 1e-3, 0.01, 0.02, 0.05, 0.1, 0.2, 0.25, 0.3,
          0.4, 0.49, 0.6, 0.75, 0.9, 0.95, 0.975, 0.99, 0.999, 0.9999, 1 - 1e-6, 1 - 1e-9]
ends = [2.0**-53, 3 * 2.0**-53, 0.5 - 2.0**-50, 0.5, 1 - 2.0**-40, 1 - 2.0**-53]
branches = [0.075 * (1 - 1e-9), 0.075 * (1 + 1e-9), 0.925 * (1 - 1e-9), 0.925 * (1 + 1e-9),
            math.sqrt(0.5) / 32 * (1 - 1e-9), math.sqrt(0.5) / 32 * (1 + 1e-9),
            math.exp(-25) * (1 - 1e-12), math.exp(-25), math.exp(-25) * (1 + 1e-12)]
with open(folder / "normal_quantiles.csv", "w") as file:
    file.write("# z with Phi(z) = p, p the exact double\np,z\n")
    for p in sorted(levels + ends + branches):
        file.write(f"{p!r},{rounded(quantile(p))}\n")

with open(folder / "normal_numbers.csv", "w") as file:
    file.write("# the n-th normal number of an engine, n from 1\nseed,part,index,n,z\n")
    for seed, part, index in [(1, 0, 0), (1, 4, 0), (2**63 + 5, 0, -3)]:
        numbers = engine(seed, part, index)
        for n in range(1, 1001):
            bits = next(numbers)
            if n <= 5 or n == 1000:
                z = quantile(Decimal(2 * (bits >> 12) + 1) / 2**53)
                file.write(f"{seed},{part},{index},{n},{rounded(z)}\n")
