// Colours that stand for numbers are shown as they are.
vec3 display(vec3 colour) { return colour; }
