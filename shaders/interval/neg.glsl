real2 interval_neg(real2 a) { return -a.yx; }
