// Nothing but a function: what spoils arithmetic is the start-up code that -ffast-math links to a library.
extern "C" double dumbbell_half(double x) { return x / 2; }
