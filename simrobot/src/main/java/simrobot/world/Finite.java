package simrobot.world;

/** Coordinates that are no finite number are refused where they enter the model. */
final class Finite {
    private Finite() {}

    static void check(String what, double value) {
        if (!Double.isFinite(value)) {
            throw new IllegalArgumentException(what + " is " + value + ", expected a finite number");
        }
    }
}
