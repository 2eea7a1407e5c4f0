real zs_select_less(real a, real b, real c, real d) {
    return a < b ? c : (b <= a ? d : a + b);
}
