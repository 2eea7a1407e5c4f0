#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include "contract/arguments.h"
#include "eval/operators.h"
using namespace contract;
int main(int argc, char** argv) {
    auto context = render::open_osmesa();
    if (!context) return 1;
    printf("%s\n", (*context)->renderer().c_str());
    graph::for_each_operator([&](graph::Op op) {
        const auto name = std::string(graph::facts(op).name);
        if (argc > 1) {
            bool f = false;
            for (int i = 1; i < argc; ++i) f |= name == argv[i];
            if (!f) return;
        }
        Random random(7);
        const Row* row = find_row(op);
        if (!row) {
            printf("no row %s\n", name.c_str());
            return;
        }
        auto list = random_arguments(*row, 1 << 17, random);
        auto out = glsl_values(**context, op, list);
        double worst = 0, wa = 0, wr = 0;
        Arguments at{};
        float got = 0;
        double want = 0;
        int n = 0;
        for (size_t i = 0; i < list.size(); ++i) {
            if (is_excluded(op, list[i])) continue;
            double d = eval::apply<double>(op, list[i][0], list[i][1], list[i][2], list[i][3]);
            if (!std::isfinite(d)) continue;
            if (std::abs(d) > 3e38 || (std::abs(d) < 1.2e-38)) continue;
            ++n;
            double e = std::abs(out[i] - d);
            if (std::isnan(e)) e = INFINITY;
            wa = std::max(wa, e);
            wr = std::max(wr, e / std::abs(d));
            double u = e / size_of(row->unit, d);
            if (!(u <= worst)) {
                worst = u;
                at = list[i];
                got = out[i];
                want = d;
            }
        }
        printf(
            "%-12s n %6d worst %.3g %s(bound %.3g)  abs %.3g rel %.3g  at %.9g %.9g %.9g %.9g: "
            "%.9g want %.12g\n",
            name.c_str(), n, worst, worst > row->bound ? "** " : "", row->bound, wa, wr, at[0],
            at[1], at[2], at[3], got, want);
    });
}
