package simrobot.world;

/** Rejects coordinates that are not finite. */
final class FiniteCheck {
    private FiniteCheck() {}

    static void check(String what, double value) {
        if (!Double.isFinite(value)) {
            throw new IllegalArgumentException(what + " is " + value + ", expected a finite number");
        }
    }
}
