// What generated expressions call, as GLSL has it.
float zs_asin(float x) { return asin(x); }
float zs_acos(float x) { return acos(x); }
float zs_atan(float x) { return atan(x); }
float zs_atan2(float y, float x) { return atan(y, x); }
float zs_cbrt(float x) { return sign(x) * pow(abs(x), 1.0 / 3.0); }
float zs_cosh(float x) { return cosh(x); }
float zs_exp(float x) { return exp(x); }
float zs_hypot(float a, float b) { return length(vec2(a, b)); }
float zs_hypot3(float a, float b, float c) { return length(vec3(a, b, c)); }
float zs_log(float x) { return log(x); }
float zs_min(float a, float b) { return min(a, b); }
float zs_max(float a, float b) { return max(a, b); }
float zs_pow(float a, float b) { return pow(a, b); }
float zs_ratio(float a, float b) { return a / b; }
float zs_select_less(float a, float b, float c, float d) { return a < b ? c : d; }
float zs_sign(float x) { return sign(x); }
vec2 zs_sincos(float x) { return vec2(sin(x), cos(x)); }
float zs_sin(float x) { return sin(x); }
float zs_cos(float x) { return cos(x); }
float zs_sinh(float x) { return sinh(x); }
float zs_tanh(float x) { return tanh(x); }
float zs_sqrt(float x) { return sqrt(x); }
float zs_tan(float x) { return tan(x); }
